#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what `make test` and `make check` need on Debian, as root; elsewhere names it and fails.
set -eu
packages='git gcc g++ tcc make cmake pkg-config jq libcmocka-dev libmpfr-dev libpng-dev libstb-dev libassimp-dev
          libmeshoptimizer-dev clang clang-format clang-tidy cppcheck
          gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm
          gcc-riscv64-unknown-elf qemu-system-misc gcc-avr avr-libc simavr
          gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user
          gcc-i686-linux-gnu libc6-dev-i386-cross'
packages=$(echo $packages)

if ! command -v apt-get >/dev/null || [ "$(id -u)" != 0 ]; then
    echo "setup: tests and checks need these packages (names of Debian), and clang's sanitizer and fuzzer runtime:"
    echo "    $packages libclang-rt-14-dev"
    command -v apt-get >/dev/null && echo "setup: run as root to install them"
    exit 1
fi

installed()
{
    [ "$(dpkg-query -W -f '${db:Status-Status}\n' "$@" 2>/dev/null | grep -c '^installed$')" = $# ]
}

# clang's runtime (sanitizers, libFuzzer) carries clang's version in its name.
runtime()
{
    apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/libclang-rt-\1-dev/p' | head -n 1
}

if ! installed $packages $(runtime); then
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq
    apt-get install -y -qq --no-install-recommends $packages $(runtime) >/dev/null
fi
echo "setup: all packages are installed"
