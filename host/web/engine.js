/* SPDX-License-Identifier: MIT */
/* The WebAssembly module of web.h as an object. What of WASI its C library asks for is a place to write to. */
'use strict';

async function createEngine() {
    const written = ['', '', '']; /* by descriptor: standard output and error */
    const decoder = new TextDecoder();
    const bytesOfScript = Uint8Array.from(atob(QTRI_WASM), (letter) => letter.charCodeAt(0));
    let c = null; /* the module's exports */

    const view = () => new DataView(c.memory.buffer);
    const wasi = {
        fd_close: () => 0,
        fd_fdstat_get: (descriptor, out) => {
            new Uint8Array(c.memory.buffer, out, 24).fill(0);
            view().setUint8(out, 2); /* a terminal, which is written line by line */
            return 0;
        },
        fd_seek: () => 70, /* ESPIPE */
        fd_write: (descriptor, pieces, count, out) => {
            let total = 0;
            for (let i = 0; i < count; i++) {
                const at = view().getUint32(pieces + 8 * i, true), length = view().getUint32(pieces + 8 * i + 4, true);
                written[descriptor] += decoder.decode(new Uint8Array(c.memory.buffer, at, length));
                total += length;
            }
            view().setUint32(out, total, true);
            return 0;
        },
    };
    /* Triangles in the order for the vertex cache. The library numbers vertices anew besides: that is undone. */
    const order = (at, count) => {
        if (hasOrder) {
            const indices = new Uint32Array(c.memory.buffer, at, count), ordered = indices.slice();
            const before = [];
            MeshoptEncoder.reorderMesh(ordered, true, false)[0].forEach((after, vertex) => before[after] = vertex);
            indices.set(ordered.map((vertex) => before[vertex]));
        }
    };
    const hasOrder = typeof MeshoptEncoder !== 'undefined';
    await (hasOrder && MeshoptEncoder.ready);
    c = (await WebAssembly.instantiate(bytesOfScript, {wasi_snapshot_preview1: wasi, env: {page_order: order}})).instance.exports;
    c._initialize();

    /* Calls with memory for text that lives no longer than the call. */
    function withTexts(texts, call) {
        const places = texts.map((text) => {
            const bytes = new TextEncoder().encode(text + '\0'), at = c.malloc(bytes.length);
            new Uint8Array(c.memory.buffer, at, bytes.length).set(bytes);
            return at;
        });
        try {
            return call(places);
        } finally {
            places.forEach((at) => c.free(at));
        }
    }

    function takeWritten(descriptor) {
        const text = written[descriptor];
        written[descriptor] = '';
        return text;
    }

    function run(command, words) {
        const status = withTexts(words, (places) => {
            const list = c.malloc(4 * (places.length + 1));
            places.concat(0).forEach((at, i) => view().setUint32(list + 4 * i, at, true));
            const result = command(places.length, list);
            c.free(list);
            return result;
        });
        return {ok: status === 0, report: takeWritten(1), message: takeWritten(2).trim()};
    }

    const engine = {
        hasOrder,
        put(name, bytes) {
            const content = typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes;
            const at = withTexts([name], ([path]) => c.web_file_create(path, content.length));
            if (at === 0) {
                throw new Error('There is not enough memory for ' + name + '.');
            }
            new Uint8Array(c.memory.buffer, at, content.length).set(content);
        },
        get(name) {
            return withTexts([name], ([path]) => {
                const at = c.web_file_content(path);
                return at === 0 ? null : new Uint8Array(c.memory.buffer, at, c.web_file_length(path)).slice();
            });
        },
        clear: () => c.web_files_clear(),

        /* `qtri model`: {ok, report, message}. */
        model: (words) => run(c.web_model, words),

        /* The parts of such a header, a list of numbers each: web_show.c. Their meshes and textures become files. */
        show(words) {
            const {ok, report} = run(c.web_show, words);
            if (!ok) {
                throw new Error('There is not enough memory to draw this.');
            }
            return report.trim().split('\n').map((line) => line.split(' ').map(Number));
        },

        /* The scene that is drawn from now on. Throws what is wrong with it. */
        scene(text) {
            engine.put('page.scene', text);
            if (withTexts(['page.scene'], ([path]) => c.web_scene(path)) !== 0) {
                throw new Error(takeWritten(2).trim());
            }
        },

        /* 0 core, 1 double precision, 2 difference: bytes r g b, which the next call may overwrite. */
        draw(what, look, pixels) {
            const at = c.web_draw(what, look.format, look.rows, look.degrees);
            if (at === 0) {
                throw new Error('There is not enough memory to draw this.');
            }
            return new Uint8Array(c.memory.buffer, at, 3 * pixels);
        },

        count(look) {
            const at = c.web_count(look.format, look.rows, look.degrees);
            if (at === 0) {
                throw new Error('There is not enough memory to draw this.');
            }
            const numbers = Array.from(new Float64Array(c.memory.buffer, at, 8));
            const [triangles, pixels, bandBytes, m0plus, m3, costError, differing, largestError] = numbers;
            return {triangles, pixels, bandBytes, m0plus, m3, costError, differing, largestError};
        },
    };
    return engine;
}
