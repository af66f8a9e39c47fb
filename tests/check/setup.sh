#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs on Debian, as root, what `make test` needs, or with `all` what `make check` needs besides: setup.sh [all]
# Elsewhere names it and fails.
set -eu
what=${1:-test}
packages='git gcc make pkg-config libcmocka-dev libmpfr-dev libpng-dev libstb-dev libassimp-dev libmeshoptimizer-dev libfreetype-dev'
[ "$what" = test ] || packages="$packages g++ tcc cmake ninja-build jq clang lld wasi-libc clang-format clang-tidy cppcheck doxygen libsdl2-dev
          gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm
          gcc-riscv64-unknown-elf qemu-system-misc gcc-avr avr-libc simavr
          gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user
          gcc-i686-linux-gnu libc6-dev-i386-cross gcc-mingw-w64-x86-64-win32 nodejs"
packages=$(echo $packages)

if ! command -v apt-get >/dev/null || [ "$(id -u)" != 0 ]; then
    echo "setup: make $([ "$what" = test ] && echo test || echo check) needs these packages (names of Debian)$([ "$what" = test ] || echo ", and clang's sanitizer and fuzzer runtime"):"
    echo "    $packages$([ "$what" = test ] || echo " libclang-rt-14-dev libclang-rt-14-dev-wasm32")"
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
    [ "$what" = test ] || apt-cache depends clang 2>/dev/null | sed -n 's/.*Depends: clang-\([0-9]*\)$/libclang-rt-\1-dev libclang-rt-\1-dev-wasm32/p' | head -n 1
}

if ! installed $packages $(runtime); then
    echo "setup: installs $packages"
    echo "setup: that takes $([ "$what" = test ] && echo 'about 330 MB on a bare Debian, and a minute or two' || echo 'about 3 GB, and some minutes')"
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq
    apt-get install -y --no-install-recommends $packages $(runtime) |
        awk '/^Unpacking/ { n++; if (n % 20 == 0) { print "setup: " n " packages unpacked"; fflush() } }'
    installed $packages $(runtime) || { echo "setup: apt-get did not install all of them"; exit 1; }
fi
echo "setup: all packages are installed"

# Of npm, whose package of Debian brings hundreds more and is left out: package, version, what is skipped without it.
of_npm()
{
    grep -qs "\"version\": \"$2\"" "build/npm/node_modules/$1/package.json" ||
        npm install --silent --no-audit --no-fund --prefix build/npm "$1@$2" || echo "setup: npm did not install $1 $2: $3"
}
if [ "$what" = all ]; then
    of_npm rp2040js 1.4.1 'make test-rp2040 will be skipped' # an emulator of the RP2040
    of_npm meshoptimizer 0.18.1 'the page of make web will leave triangles as they are' # as Debian has it
fi
