// SPDX-License-Identifier: MIT
// Runs a firmware of port/boards/rp2040 in rp2040js and prints what its display and its console get:
//
//   node tests/boards/rp2040.mjs RP2040JS FIRMWARE.elf FRAMES
//
// RP2040JS is the folder of that package. A line each: `at MS` (time goes on), `reset 0|1` (level of the pin),
// `command HEX` and `data HEX` (bytes with D/C low and high), and the console's own lines. The run ends with the
// firmware or after FRAMES lines `frame ...`, each of which is answered by the byte that the firmware waits for.
// Status: the firmware's own; 1 when it does what the chip does not have or the display forbids.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, file, frames] = process.argv.slice(2);
if (!(frames > 0)) {
    console.error('usage: node rp2040.mjs RP2040JS FIRMWARE.elf FRAMES');
    process.exit(2);
}
const { RP2040 } = await import(pathToFileURL(path.resolve(folder, 'dist/esm/index.js')));

const FLASH = 0x10000000, VECTORS = 0x10000100;
const PIN_CS = 17, PIN_DC = 20, PIN_RESET = 21;
const HIGH = 1;
const chip = new RP2040();
const { clock, core, gpio, spi: [spi], uart: [uart] } = chip;

const output = [];
let outputBytes = 0;

function print(line) {
    output.push(line);
    outputBytes += line.length;
    if (outputBytes > 65536) {
        flush();
    }
}

function flush() {
    const text = Buffer.from(output.map((line) => line + '\n').join(''));
    for (let done = 0; done < text.length;) {
        try {
            done += fs.writeSync(1, text, done);
        } catch (error) {
            if (error.code !== 'EAGAIN') { // that is a full pipe; others: nobody reads any more
                process.exit(1);
            }
        }
    }
    output.length = outputBytes = 0;
}

function end(status, message) {
    flush();
    if (message) {
        console.error(`${file}: ${message}`);
    }
    process.exit(status);
}

// What the emulator warns of, a real chip would do otherwise than the emulator. SCB.CCR is read-only there.
function complain(source, message) {
    if (!/ 0xd14/.test(message)) {
        end(1, `${source}: ${message}, pc 0x${core.PC.toString(16)}`);
    }
}
chip.logger = { debug() {}, info() {}, warn: complain, error: complain };

// The bus: bytes of one kind are collected into lines.
let bytes = '', isData = false, lastMs = 0;

function milliseconds() {
    return Math.floor(clock.nanos / 1e6);
}

function finishLine() {
    if (bytes) {
        print((isData ? 'data ' : 'command ') + bytes);
        bytes = '';
    }
    if (milliseconds() !== lastMs) {
        lastMs = milliseconds();
        print(`at ${lastMs}`);
    }
}

const transmitted = clock.createAlarm(() => spi.completeTransmit(0));

spi.onTransmit = (value) => {
    if (gpio[PIN_CS].value === HIGH || spi.dataBits !== 8 || spi.spiMode !== 0) {
        end(1, 'SPI: the display is not selected, or not by bytes in mode 0');
    }
    const high = gpio[PIN_DC].value === HIGH;
    if (high !== isData || bytes.length >= 4096 || milliseconds() !== lastMs) {
        finishLine();
        isData = high;
    }
    bytes += value.toString(16).padStart(2, '0');
    transmitted.schedule(8e9 / spi.clockFrequency);
};

gpio[PIN_DC].addListener(() => {
    if (spi.busy || !spi.txFIFO.empty) {
        end(1, 'SPI: D/C changes before the last bit is out');
    }
});
gpio[PIN_RESET].addListener((level) => {
    finishLine();
    print(`reset ${level === HIGH ? 1 : 0}`);
});

let text = '', shown = 0;

uart.onByte = (byte) => {
    if (byte !== 10) {
        text += String.fromCharCode(byte);
        return;
    }
    finishLine();
    print(text);
    if (text.startsWith('frame ')) {
        if (++shown >= Number(frames)) {
            end(0);
        }
        uart.feedByte(10);
    }
    text = '';
};

// Semihosting: SYS_EXIT_EXTENDED, its status behind the reason.
chip.onBreak = (number) => {
    const status = chip.readUint32(core.registers[1] + 4);
    end(status, number === 0xab && core.registers[0] === 0x20 ? '' : `breakpoint ${number}`);
};

// Segments that have bytes in the file go to their load addresses.
const elf = fs.readFileSync(file);
const header = elf.readUInt32LE(28), size = elf.readUInt16LE(42), count = elf.readUInt16LE(44);
for (let i = 0; i < count; i++) {
    const at = header + i * size;
    const offset = elf.readUInt32LE(at + 4), address = elf.readUInt32LE(at + 12), length = elf.readUInt32LE(at + 16);
    if (elf.readUInt32LE(at) === 1 && length > 0) {
        chip.flash.set(elf.subarray(offset, offset + length), address - FLASH);
    }
}

// As the second stage of the boot does.
core.VTOR = VECTORS;
core.SP = chip.readUint32(VECTORS);
core.PC = chip.readUint32(VECTORS + 4) & ~1;
for (;;) {
    clock.tick(core.executeInstruction() * 1e9 / chip.clkSys);
}
