#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the boards' firmware in QEMU and compares what it draws with what the host draws.
#   tests/test_boards.sh BUILD BOARD:CORE:DISPLAY:EMULATOR...
# EMULATOR is a command that lacks only the firmware, BUILD/boards/BOARD_CORE/firmware.elf. Where DISPLAY is `-`, the
# firmware prints checksums of the board scenes, as BUILD/boards/host/board_host does; else the display's pixels are
# compared with the pictures of BUILD/boards/host/show_BOARD. Status 0 when everything ran and agrees.
# TIME_LIMIT: seconds for a board. SKIPPED: targets that are not run for want of tools.
set -u
build=$1
shift
boards=$build/boards
table=$build/boards.tsv
summary=$boards/summary.tsv
checksums=$boards/host/checksums.txt
: "${TIME_LIMIT:=120}" "${SKIPPED:=0}"
export TIME_LIMIT
failures=0

fail()
{
    echo "test-boards: $*" >&2
    failures=$((failures + 1))
}

# finished TARGET STATUS: whether it ended well; the reason if not.
finished()
{
    case $2 in
    0) return 0 ;;
    70) fail "$1: the processor reported a fault" ;;
    124 | 143) fail "$1: no end within $TIME_LIMIT s" ;;
    *) fail "$1: status $2" ;;
    esac
    return 1
}

# row DISPLAY SCENE PIXELS MISMATCHES INSTRUCTIONS: a line of the summary. Figures of the firmware: code and constants,
# and static RAM with the stack, from its .size; the deepest stack from what it printed.
row()
{
    figures=$(awk -v output="$folder/output.txt" '
        BEGIN { while ((getline line <output) > 0) if (split(line, word, " ") >= 3 && word[2] == "stack") stack = word[3] }
        NR == 2 { printf "%d\t%d\t%s", $2 + $3, $1 + $2, (stack > 0 ? stack : "-") }' "$folder/firmware.size")
    [ "$board" != linux ] || figures="-$tab-$tab-"
    printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$board" "$core" "$@" "$figures" >>"$summary"
}

# The target must print every line that the host does, but for frames that its memory cannot hold.
compare_checksums()
{
    awk -v board="$board" -v core="$core" -v table="$table" '
        NR == FNR && $1 == "end" { expected = $2 }
        NR == FNR { crc[$1 " " $2 " " $3] = $4; pixels[$1 " " $2 " " $3] = $5; next }
        /^# no memory/ { expected-- }
        /^#/ { next }
        $1 == "end" { ended = $2; all = $3; next }
        {
            key = $1 " " $2 " " $3
            count++
            # All heights of band must give one picture.
            frame = $1 " " $2
            if (!(frame in first)) { first[frame] = $4; frames++; instructions += $6 }
            if (crc[key] != $4 || pixels[key] != $5 || first[frame] != $4) {
                bad++
                print "test-boards: " board " " core ": " key " differs" > "/dev/stderr"
            }
            printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", board, core, $1, $2, $3, $5, crc[key], $4, $6 >> table
        }
        END {
            mean = frames > 0 ? int(instructions / frames) : 0
            print count + 0, bad + 0, all + 0, (mean > 0 ? mean : "-")
            exit count == 0 || count != ended || count != expected
        }' "$checksums" "$folder/output.txt" >"$folder/verdict.txt" || fail "$board $core: output is incomplete"
    read -r count bad all instructions <"$folder/verdict.txt"
    row - "6 scenes, 3 formats" "$all" "$bad" "$instructions"
}

# The host's program compares the pictures; a row for each scene.
compare_display()
{
    mkdir -p "$folder/expected"
    "$boards/host/show_$board" "$folder/expected" "$folder/shown" >"$folder/verdict.txt" ||
        fail "$board: the display shows something else than $folder/expected"
    awk -v name="$board" '
        NR == FNR { if ($1 == "frame") instructions[$2 " " $3] = $4; next }
        {
            if (!($3 in frames)) order[++scenes] = $3
            frames[$3]++; pixels[$3] += $4; bad[$3] += $5; drawn[$3] += $6
            sum[$3] += instructions[$2 " " $3]
        }
        END {
            for (i = 1; i <= scenes; i++) {
                scene = order[i]
                if (drawn[scene] < pixels[scene] / 20) print "test-boards: " name ": " scene ": no picture" > "/dev/stderr"
                print scene, frames[scene], pixels[scene], bad[scene], int(sum[scene] / frames[scene])
            }
        }' "$folder/output.txt" "$folder/verdict.txt" >"$folder/scenes.txt"
    while read -r scene frames pixels wrong instructions; do
        count=$((count + frames))
        [ "$wrong" = 0 ] || bad=$((bad + 1))
        row "$display" "$scene x $frames" "$pixels" "$wrong" "$instructions"
    done <"$folder/scenes.txt"
    [ "$count" -gt 0 ] || fail "$board: no picture was compared"
}

mkdir -p build/results
if [ $# = 0 ]; then
    echo "0 0 $SKIPPED" >build/results/boards
    exit 0
fi

"$boards/host/board_host" >"$checksums" || fail "the host program failed"

# A checksum says nothing about a wrong picture: this one's pixel count is known (COURSE scene 3).
[ "$(awk '$1 == "triangle" && $5 == 8214' "$checksums" | wc -l)" = 6 ] ||
    fail "the colour triangle covers other than 8214 pixels"

tab=$(printf '\t')
printf 'board\tcore\tscene\tformat\trows\tpixels\tcrc_host\tcrc_target\tinstructions\n' >"$table"
printf 'board\tcore\tdisplay\tscene\tpixels\tmismatches\tinstructions\tRAM\tflash\tstack\n' >"$summary"
compared=0 mismatches=0
for target; do
    board=${target%%:*}
    target=${target#*:}
    core=${target%%:*}
    target=${target#*:}
    display=${target%%:*}
    emulator=${target#*:}
    folder=$boards/${board}_$core
    count=0 bad=0
    if [ "$display" = - ]; then
        timeout "$TIME_LIMIT" $emulator "$folder/firmware.elf" </dev/null >"$folder/output.txt"
        finished "$board $core" $? && compare_checksums
    else
        rm -rf "$folder/shown"
        sh tests/boards/run_display.sh "$emulator" "$folder/firmware.elf" "$folder/shown" >"$folder/output.txt"
        finished "$board $core" $? && compare_display
        grep '^# failed' "$folder/output.txt"
    fi
    compared=$((compared + count))
    mismatches=$((mismatches + bad))
done

# Columns as wide as their widest cell. instructions: of a whole frame, the display included; the mean where a row has
# several. mismatches: pixels on a display, frames among the checksums. RAM and flash: bytes of the firmware.
awk -F '\t' '
    NR == FNR { for (i = 1; i <= NF; i++) if (length($i) > width[i]) width[i] = length($i); next }
    { for (i = 1; i <= NF; i++) printf i <= 4 ? "%-*s  " : i < NF ? "%*s  " : "%*s\n", width[i], $i }' "$summary" "$summary"
echo "$((compared - mismatches)) $((mismatches + failures)) $SKIPPED" >build/results/boards
echo "boards: $compared frames compared, $mismatches mismatches; checksums of each in $table"
[ "$failures" = 0 ] && [ "$mismatches" = 0 ] && [ "$compared" -gt 0 ]
