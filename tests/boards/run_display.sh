#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the firmware of a board with a display in QEMU and keeps what the display shows.
#   tests/boards/run_display.sh 'EMULATOR ... -kernel' FIRMWARE FOLDER [ppm|png]
# For each line `frame NUMBER SCENE ...` of the firmware the display goes to FOLDER/NUMBER-SCENE.ppm; then the firmware
# gets the byte that it waits for. Its lines are printed. Status: QEMU's, the firmware's own; 124 after TIME_LIMIT seconds.
set -u
if [ "${TIMED:-}" != yes ]; then
    TIMED=yes timeout "${TIME_LIMIT:-120}" sh "$0" "$@"
    exit
fi
emulator=$1
firmware=$2
folder=$3
format=${4:-ppm}

mkdir -p "$folder" || exit 1
pipes=$(mktemp -d) || exit 1
qemu=
trap 'kill $qemu 2>/dev/null; rm -rf "$pipes"' EXIT
trap 'exit 1' INT TERM
mkfifo "$pipes/serial.in" "$pipes/serial.out" "$pipes/monitor.in" "$pipes/monitor.out" || exit 1

# The emulator inherits one end of every pipe, so that the other end notices when it is gone.
QEMU_AUDIO_DRV=none $emulator "$firmware" -serial "pipe:$pipes/serial" -monitor "pipe:$pipes/monitor" \
    0<"$pipes/serial.in" >"$pipes/serial.out" 8<"$pipes/monitor.in" 9>"$pipes/monitor.out" 2>"$pipes/errors" &
qemu=$!
exec 3>"$pipes/serial.in" 4<"$pipes/serial.out" 5>"$pipes/monitor.in" 6<"$pipes/monitor.out"

# The monitor does one command after another: when it answers the second, the file of the first is complete.
screendump()
{
    printf 'screendump "%s" -f %s\ninfo status\n' "$1" "$format" >&5
    while read -r line <&6; do
        case $line in
        *"VM status"*) return ;;
        esac
    done
}

while read -r word number scene rest <&4; do
    echo "$word $number $scene $rest"
    if [ "$word" = frame ]; then
        file=$folder/$number-$scene.$format
        rm -f "$file"
        screendump "$file"
        [ -s "$file" ] || { echo "# failed: no dump of the display" && exit 1; }
        echo >&3
    fi
done
wait "$qemu"
status=$?
qemu=
[ "$status" = 0 ] || cat "$pipes/errors" >&2
exit "$status"
