#!/bin/sh
# Runs firmware in QEMU and compares every line it prints with the host's.
#   tests/test_boards.sh HOST_PROGRAM TABLE.tsv BOARD_CORE:MACHINE:FIRMWARE...
# Status 0 when everything ran and agrees. QEMU and TIME_LIMIT (seconds) may be set from outside.
host_program=$1
table=$2
shift 2
qemu=${QEMU:-qemu-system-arm}
lines=$(mktemp -d) || exit 1
trap 'rm -rf "$lines"' EXIT
trap 'exit 1' INT TERM
failures=0

fail() {
    echo "test-boards: $*" >&2
    failures=$((failures + 1))
}

"$host_program" >"$lines/host" || fail "the host program failed"

# A checksum says nothing about a wrong picture: this one's pixel count is known (COURSE scene 3).
[ "$(awk '$1 == "triangle" && $5 == 8214' "$lines/host" | wc -l)" = 6 ] ||
    fail "the colour triangle covers other than 8214 pixels"

printf 'board\tcore\tscene\tformat\trows\tpixels\tcrc_host\tcrc_target\tinstructions\n' >"$table"
for run; do
    name=${run%%:*}
    machine=${run#*:}
    firmware=${machine#*:}
    machine=${machine%%:*}
    timeout "${TIME_LIMIT:-120}" "$qemu" -M "$machine" -display none -monitor none -serial stdio \
        -icount shift=0,sleep=off -semihosting-config enable=on,target=native \
        -kernel "$firmware" </dev/null >"$lines/$name"
    status=$?
    case $status in
    0) ;;
    124) fail "$name: no end within ${TIME_LIMIT:-120} s" ;;
    *) fail "$name: status $status" ;;
    esac
    grep '^#' "$lines/$name" | sed "s/^#/# $name:/"
    # The target must print every line that the host does, but for frames that its memory cannot hold.
    awk -v name="$name" -v table="$table" '
        BEGIN { split(name, part, "_") }
        NR == FNR && $1 == "end" { expected = $2 }
        NR == FNR { crc[$1 " " $2 " " $3] = $4; pixels[$1 " " $2 " " $3] = $5; next }
        /^# no memory/ { expected-- }
        /^#/ { next }
        $1 == "end" { ended = $2; next }
        {
            key = $1 " " $2 " " $3
            count++
            # All heights of band must give one picture.
            frame = $1 " " $2
            if (!(frame in first)) first[frame] = $4
            if (crc[key] != $4 || pixels[key] != $5 || first[frame] != $4) {
                bad++
                print "test-boards: " name ": " key " differs" > "/dev/stderr"
            }
            printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", part[1], part[2], $1, $2, $3, $5, \
                   crc[key], $4, $6 >> table
        }
        END {
            print count + 0, bad + 0
            exit count == 0 || count != ended || count != expected
        }' "$lines/host" "$lines/$name" >"$lines/verdict" || fail "$name: output is incomplete"
    read -r count bad <"$lines/verdict"
    compared=$((${compared:-0} + count))
    mismatches=$((${mismatches:-0} + bad))
done

expand -t 6,20,31,41,46,54,64,76 "$table"
mkdir -p build/results
echo "$((${compared:-0} - ${mismatches:-0})) $((${mismatches:-0} + failures)) 0" >build/results/boards
echo "boards: ${compared:-0} compared, ${mismatches:-0} mismatches"
[ "$failures" = 0 ] && [ "${mismatches:-0}" = 0 ] && [ "${compared:-0}" -gt 0 ]
