# SPDX-License-Identifier: MIT
# Sourced by the gates: the files they read, and how they end.

# C files below the folders named, generated ones left out: c_files core host
c_files()
{
    for folder in "$@"; do
        [ ! -d "$folder" ] || find "$folder" -name '*.[ch]' -o -name '*.inc'
    done | LC_ALL=C sort
}

# Stops where a tool is missing: need clang-format g++
need()
{
    for tool in "$@"; do
        command -v "$tool" >/dev/null 2>&1 || {
            echo "check: $gate needs $tool, which \`make setup-all\` installs"
            exit 1
        }
    done
}

# The gate's last word and the seconds it took, waiting included: finish STATUS, 0 where nothing was found.
gate_began=$(date +%s)
finish()
{
    took="$(($(date +%s) - gate_began)) s"
    [ "$1" = 0 ] || { echo "check: $gate FAILED ($took)"; exit 1; }
    echo "check: $gate ok ($took)"
}

jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)

# The library of cores as benchmarks count it, compiled where it is not there: core_libraries cortex-m3 cortex-m0plus-Os
core_libraries()
{
    alone make -s -j "$jobs" MAKEFLAGS= $(printf "${BUILD:-build}/bench/scenes/%s/libqtri.a " "$@") >"$work/log" 2>&1 ||
        { cat "$work/log"; return 1; }
}

# What make compiles for this computer, where it is not there: plain_build [OPTION] TARGET...
plain_build()
{
    locked plain env MAKEFLAGS= make -s -j "$jobs" "$@" >"$work/plain.log" 2>&1 || { cat "$work/plain.log"; return 1; }
}

# Runs a make of the benchmarks when no other gate does: they share objects, those of the plain build among them.
alone() { plain_build all && locked bench "$@"; }

# Runs a command when none other runs by this name: locked NAME COMMAND...
locked()
{
    lock=${BUILD:-build}/$1.lock
    shift
    mkdir -p "${BUILD:-build}"
    if command -v flock >/dev/null 2>&1; then
        flock "$lock" "$@"
    else
        "$@"
    fi
}

# Objects of the files that standard input names, no two of which may have one name: objects FOLDER COMMAND... A compiler
# that is begun for several takes half the time of one for each at -O0.
objects()
{
    into=$1
    shift
    mkdir -p "$into"
    sed "s,^,$(pwd)/," | (cd "$into" && xargs -P "$jobs" -n 12 "$@" -c)
}

# For tidy: nothing but what the compiler says. One check must be named, which only asks C++.
diagnostics='{Checks: "-*,clang-diagnostic-*,misc-unused-alias-decls", WarningsAsErrors: "*", HeaderFilterRegex: ".*"}'

# Runs clang-tidy on the files that standard input names, many at a time, as it takes longer to begin than to read most of
# them: tidy CONFIG FLAGS; what it finds is printed and makes it fail.
tidy()
{
    xargs -P "$jobs" -n 16 sh -c '
        config=$1 flags=$2
        shift 2
        output=$(clang-tidy --quiet ${config:+"--config=$config"} "$@" -- $flags 2>&1) || {
            printf "%s\n" "$output" | grep -v " warnings\{0,1\} generated\.$"
            exit 1
        }' tidy "$@"
}
