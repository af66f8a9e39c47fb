// SPDX-License-Identifier: MIT
// The page of host/web in a browser, against the command: web.js CHROMIUM PAGE-FOLDER QTRI WORK-FOLDER
// Prints what is wrong; the status is how much of it there was.
'use strict';
const {execFileSync, spawnSync} = require('child_process');
const fs = require('fs');
const http = require('http');
const path = require('path');
const zlib = require('zlib');
const {pathToFileURL} = require('url');
const {openBrowser} = require('./browser.js');

const [chromium, folder, command, work] = process.argv.slice(2), qtri = path.resolve(command);
const page = pathToFileURL(path.join(path.resolve(folder), 'index.html')).href;
let findings = 0;

function check(holds, what) {
    if (!holds) {
        console.log(what);
        findings++;
    }
}

const file = (name, content) => {
    fs.writeFileSync(path.join(work, name), content);
    return path.join(work, name);
};

// ---- Files ----

const OBJ = `mtllib small.mtl
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v 0 0 1.5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl red
f 1/1 2/2 5/3
f 2/1 3/2 5/3
usemtl skin
f 3/1 4/2 5/3
f 4/1 1/2 5/3
f 4/1 3/2 2/3 1/4
`;
const MTL = 'newmtl red\nKd 0.8 0.1 0.2\nnewmtl skin\nKd 1 1 1\nmap_Kd textures/skin.ppm\n';

function ppm(width, height) {
    const pixels = Buffer.alloc(3 * width * height);
    for (let i = 0; i < pixels.length; i++) {
        pixels[i] = (i * 7919) >> 3 & 255;
    }
    return Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), pixels]);
}

// A container of a description and the arrays that its buffer views are of.
function glbOf(json, arrays) {
    const pieces = arrays.map((array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength)), numbers = (...list) => Buffer.from(new Uint32Array(list).buffer);
    let at = 0;
    const views = pieces.map((piece) => ({buffer: 0, byteOffset: (at += -at & 3, at += piece.length) - piece.length, byteLength: piece.length}));
    const binary = Buffer.concat(pieces.map((piece) => Buffer.concat([piece, Buffer.alloc(-piece.length & 3)])));
    const text = Buffer.from(JSON.stringify({asset: {version: '2.0'}, scene: 0, buffers: [{byteLength: binary.length}], bufferViews: views, ...json}));
    const padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]);
    return Buffer.concat([numbers(0x46546c67, 2, 28 + padded.length + binary.length, padded.length, 0x4e4f534a), padded, numbers(binary.length, 0x004e4942), binary]);
}

// A tetrahedron with a material, moved by its node.
const glb = (more) => glbOf({
    scenes: [{nodes: [0]}], nodes: [{mesh: 0, scale: [2, 1, 1]}], ...more,
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
    materials: [{pbrMetallicRoughness: {baseColorFactor: [0.2, 0.5, 0.8, 1]}}],
    accessors: [{bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1]},
        {bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR'}],
}, [new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), new Uint16Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])]);

// All that the page reads of GLB: nodes below nodes, strips and fans, colours, pictures that are turned, clamped, with holes and
// seen through, a skin, targets of a shape, motion. `moves`: with an animation.
function richGlb(pictures, moves) {
    const arrays = [], accessors = [], widths = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16};
    const add = (type, componentType, array, more) => {
        accessors.push({bufferView: arrays.push(array) - 1, componentType, type, count: array.length / widths[type], ...more});
        return accessors.length - 1;
    };
    const ROWS = 8, COLUMNS = 12, count = (ROWS + 1) * (COLUMNS + 1), vertices = [...Array(count).keys()], bound = {min: [-2, -2, -2], max: [2, 2, 2]};
    let state = 7;
    const random = () => (state = (state * 1103515245 + 12345) & 0x7fffffff) / 0x7fffffff;
    const normals = vertices.flatMap((i) => {
        const a = Math.PI * Math.floor(i / (COLUMNS + 1)) / ROWS, b = 2 * Math.PI * (i % (COLUMNS + 1)) / COLUMNS;
        return [Math.sin(a) * Math.cos(b), Math.cos(a), Math.sin(a) * Math.sin(b)];
    });
    const faces = vertices.filter((i) => i % (COLUMNS + 1) < COLUMNS && i < count - COLUMNS - 1)
        .flatMap((i) => [i, i + 1, i + COLUMNS + 1, i + 1, i + COLUMNS + 2, i + COLUMNS + 1]);
    const unit = (...q) => q.map((number) => number / Math.hypot(...q));
    const POSITION = add('VEC3', 5126, Float32Array.from(normals, (number) => number * (1 + 0.2 * random())), bound);
    const NORMAL = add('VEC3', 5126, Float32Array.from(normals));
    const TEXCOORD_0 = add('VEC2', 5126, Float32Array.from(vertices.flatMap((i) => [i % (COLUMNS + 1) / COLUMNS * 1.3, Math.floor(i / (COLUMNS + 1)) / ROWS])));
    const COLOR_0 = add('VEC4', 5121, Uint8Array.from({length: 4 * count}, (unused, i) => i % 4 === 3 ? 255 : 256 * random()), {normalized: true});
    const JOINTS_0 = add('VEC4', 5121, Uint8Array.from({length: 4 * count}, (unused, i) => i % 4 & 1));
    const WEIGHTS_0 = add('VEC4', 5126, Float32Array.from(vertices.flatMap((i) => [i / count, 1 - i / count, 0, 0])));
    const indices = add('SCALAR', 5123, Uint16Array.from(faces));
    const strip = add('SCALAR', 5123, Uint16Array.from({length: 2 * (COLUMNS + 1)}, (unused, i) => (i >> 1) + (i & 1) * (COLUMNS + 1)));
    const fan = add('SCALAR', 5121, Uint8Array.from({length: COLUMNS + 1}, (unused, i) => i + 3 * (COLUMNS + 1)));
    const targets = [0.3, 0.1].map((size) => ({POSITION: add('VEC3', 5126, Float32Array.from(normals, () => size * random()), bound)}));
    accessors[targets[1].POSITION].sparse = {count: 3, indices: {bufferView: arrays.push(new Uint16Array([5, 17, 40])) - 1, componentType: 5123},
        values: {bufferView: arrays.push(new Float32Array([0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5])) - 1}};
    const inverseBindMatrices = add('MAT4', 5126, Float32Array.from([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.5, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.3, 0.5, 0, 1]));
    const input = add('SCALAR', 5126, new Float32Array([0, 0.7, 1.3]), {min: [0], max: [1.3]});
    const outputs = [add('VEC4', 5126, Float32Array.from([...unit(1, 2, 3, 9), ...unit(4, 1, -2, 9), ...unit(1, 8, 3, 5)])),
        add('VEC3', 5126, new Float32Array([5, 0, 1, 5.1, 0.2, 1.3, 4.1, 0.7, 2.3])), add('SCALAR', 5126, new Float32Array([0, 1, 0.5, 0.3, 1, -0.1]))];
    const channel = (sampler, node, path) => ({sampler, target: {node, path}});
    const images = pictures.map((picture) => ({bufferView: arrays.push(new Uint8Array(picture)) - 1, mimeType: 'image/png'}));
    return glbOf({
        extensionsUsed: ['KHR_texture_transform'], accessors, images,
        scenes: [{nodes: [0, 3, 5, 8]}, {nodes: [1]}],
        nodes: [{name: 'a', translation: [0.123, 4.567, -2.3], rotation: unit(3, 2, 5, 9), scale: [1.1, 0.7, 2.3], children: [1, 2]},
            {mesh: 0, matrix: [0.9, 0.1, 0.2, 0, -0.1, 1.2, 0.3, 0, 0.2, 0.3, -1.1, 0, 1.5, 2.5, 3.5, 1]}, {mesh: 1, translation: [3, 1, 2]},
            {name: 'moves', rotation: unit(1, 2, 3, 7), translation: [5, 0, 1], scale: [1.5, 1.5, 1.5], children: [4]},
            {name: 'inner', mesh: 2, translation: [0.3, 0.1, 0.2]}, {mesh: 3, skin: 0}, {name: 'j0', translation: [0, 0.5, 1], children: [7]},
            {name: 'j1', rotation: unit(3, 1, 1, 10), translation: [0, 1, 0]}, {children: [6]}],
        skins: [{joints: [6, 7], inverseBindMatrices}],
        meshes: [{primitives: [{attributes: {POSITION, NORMAL, TEXCOORD_0}, indices, material: 2}, {attributes: {POSITION, NORMAL, COLOR_0}, indices}]},
            {primitives: [{attributes: {POSITION}, indices: strip, mode: 5, material: 0}, {attributes: {POSITION, NORMAL, TEXCOORD_0}, indices: fan, mode: 6, material: 1}]},
            {weights: [0.2, 0.4], primitives: [{attributes: {POSITION, NORMAL, TEXCOORD_0}, indices, material: 3, targets}]},
            {primitives: [{attributes: {POSITION, NORMAL, JOINTS_0, WEIGHTS_0}, indices, material: 0}]}],
        materials: [{name: 'plain red', pbrMetallicRoughness: {baseColorFactor: [0.7, 0.1, 0.05, 1]}, doubleSided: true},
            {name: 'glass', alphaMode: 'BLEND', pbrMetallicRoughness: {baseColorFactor: [0.2, 0.9, 0.7, 0.4], baseColorTexture: {index: 1}}},
            {pbrMetallicRoughness: {baseColorTexture: {index: 1, extensions: {KHR_texture_transform: {offset: [0.1, 0.2], rotation: 0.4, scale: [1.5, 0.7]}}}}, normalTexture: {index: 0}},
            {name: 'mask', alphaMode: 'MASK', pbrMetallicRoughness: {baseColorTexture: {index: 0}}}],
        samplers: [{wrapS: 33071}], textures: [{source: 1, sampler: 0}, {source: 0}],
        ...(moves ? {animations: [{samplers: outputs.map((output, i) => ({input, output, interpolation: i === 1 ? 'STEP' : 'LINEAR'})),
            channels: [channel(0, 3, 'rotation'), channel(1, 3, 'translation'), channel(2, 4, 'weights')]}]} : {}),
    }, arrays);
}

// Pictures of 16 x 12 pixels. PNG: of `depth` bits and kind 2 rgb, 3 of a palette, 6 rgba, in seven passes or one. Its sums
// (CRC) are left out, which nobody looks at.
function png(depth, kind, isInterlaced) {
    const [width, height] = [16, 12], channels = {2: 3, 3: 1, 6: 4}[kind], chunk = (name, data) => {
        const length = Buffer.alloc(4);
        length.writeUInt32BE(data.length);
        return Buffer.concat([length, Buffer.from(name), data, Buffer.alloc(4)]);
    };
    const sample = (x, y, channel) => (x * 37 + y * 61 + channel * 97) * (channel === 3 ? 5 : 3) & 255;
    const row = (y, first, step) => {
        const columns = [];
        for (let x = first; x < width; x += step) columns.push(x);
        const bytes = columns.flatMap((x) => [...Array(channels).keys()].flatMap((channel) => kind === 3 ? [(x * y) % 8] : depth === 16 ? [sample(x, y, channel), x * y & 255] : [sample(x, y, channel)]));
        return columns.length === 0 ? Buffer.alloc(0) : Buffer.from([0, ...bytes]);
    };
    const passes = isInterlaced ? [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]] : [[0, 0, 1, 1]];
    const rows = passes.flatMap(([x, y, right, down]) => [...Array(height).keys()].filter((at) => at >= y && (at - y) % down === 0).map((at) => row(at, x, right)));
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width);
    header.writeUInt32BE(height, 4);
    header.set([depth, kind, 0, 0, isInterlaced ? 1 : 0], 8);
    const palette = kind === 3 ? [chunk('PLTE', Buffer.from([...Array(24).keys()].map((i) => i * 47 & 255))), chunk('tRNS', Buffer.from([255, 0, 90]))] : [];
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header), ...palette, chunk('IDAT', zlib.deflateSync(Buffer.concat(rows))), chunk('IEND', Buffer.alloc(0))]);
}

// Baseline with colours of half the width and height, the same progressive, and grey.
const JPEGS = {
    baseline: '/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx' +
        '4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/wAARCAAMABADASIAAhEBAxEB/8QAFwAAAwEAAAAAAAAAAAAA' +
        'AAAAAQIEBf/EAB8QAAECBgMAAAAAAAAAAAAAAAEAEQIDITFBURITgf/EABUBAQEAAAAAAAAAAAAAAAAAAAQF/8QAGREAAwADAAAAAAAAAAAAAAAAAAECBAUR/9oADAMBAA' +
        'IRAxEAPwDJ733x0lE5xQ0yLKIRxDPiJLlzcKvWthvoqc60f//Z',
    progressive: '/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx' +
        '4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/wgARCAAMABADASIAAhEBAxEB/8QAFgABAQEAAAAAAAAAAAAA' +
        'AAAAAQME/8QAFQEBAQAAAAAAAAAAAAAAAAAAAwT/2gAMAwEAAhADEAAAAchBrX//xAAWEAEBAQAAAAAAAAAAAAAAAAARABD/2gAIAQEAAQUCZ3//xAAWEQEBAQAAAAAAAA' +
        'AAAAAAAAABAAP/2gAIAQMBAT8BN2//xAAWEQEBAQAAAAAAAAAAAAAAAAABAAT/2gAIAQIBAT8Bcxf/xAAUEAEAAAAAAAAAAAAAAAAAAAAg/9oACAEBAAY/Ah//xAAXEAEA' +
        'AwAAAAAAAAAAAAAAAAAQARGh/9oACAEBAAE/Icm5P//aAAwDAQACAAMAAAAQK//EABURAQEAAAAAAAAAAAAAAAAAAAAB/9oACAEDAQE/EIX/xAAWEQEBAQAAAAAAAAAAAA' +
        'AAAAABABH/2gAIAQIBAT8QS7f/xAAcEAEAAQQDAAAAAAAAAAAAAAABABEhMUFRYYH/2gAIAQEAAT8Qv56QqLNtmIFvyLVq5J//2Q==',
    grey: '/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVkVGZIhlbXd7gYKBTmCNl4x9lnN+gXz/wAALCAAMAB' +
        'ABAREA/8QAFwAAAwEAAAAAAAAAAAAAAAAAAQIEBf/EAB8QAAEDBAMBAAAAAAAAAAAAAAEAAhETITFREkFSgf/aAAgBAQAAPwDDqz646SVZFjbWFKHuHfxFxkychf/Z',
};

// ---- The page ----

// The folder as any file server has it, at a port of its own.
function serve() {
    const types = {'.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css'};
    const server = http.createServer((request, response) => fs.readFile(path.join(folder, request.url), (error, content) => {
        response.writeHead(error ? 404 : 200, {'content-type': types[path.extname(request.url)] ?? 'text/plain'}).end(content);
    }));
    return new Promise((ready) => server.listen(0, '127.0.0.1', () => ready(server)));
}

const PIXELS = `(id) => {
    const canvas = document.getElementById(id), data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let letters = '';
    for (let i = 0; i < data.length; i += 4) letters += String.fromCharCode(data[i], data[i + 1], data[i + 2]);
    return {width: canvas.width, height: canvas.height, base64: btoa(letters)};
}`;

async function main() {
    const browser = await openBrowser(chromium, path.join(work, 'profile'));
    const {send, evaluate, waitFor} = browser;
    const errors = [], requests = [];
    browser.on(({method, params}) => {
        if (method === 'Runtime.exceptionThrown') {
            errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
        } else if (method === 'Runtime.consoleAPICalled' || method === 'Log.entryAdded') {
            errors.push(JSON.stringify(params.entry?.text ?? params.args.map((one) => one.value)));
        } else if (method === 'Network.requestWillBeSent') {
            requests.push(params.request.url);
        }
    });
    await Promise.all(['Page', 'Runtime', 'Log', 'Network', 'DOM'].map((domain) => send(domain + '.enable')));
    await send('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: work});
    await send('Page.navigate', {url: page});
    await waitFor(`document.getElementById('status')?.textContent.includes('is shown')`);

    const set = (id, value) => evaluate(`{
        const field = document.getElementById('${id}');
        field[typeof ${JSON.stringify(value)} === 'boolean' ? 'checked' : 'value'] = ${JSON.stringify(value)};
        field.dispatchEvent(new Event(field.type === 'range' ? 'input' : 'change'));
    }`);
    const text = (id) => evaluate(`document.getElementById('${id}').textContent`);

    // Files by the DevTools, as if somebody had picked them; resolves when the page has said something.
    async function pick(...files) {
        await evaluate(`document.getElementById('status').textContent = document.getElementById('error').textContent = ''`);
        const {root} = await send('DOM.getDocument');
        const {nodeId} = await send('DOM.querySelector', {nodeId: root.nodeId, selector: '#files'});
        await send('DOM.setFileInputFiles', {nodeId, files});
        await waitFor(`document.getElementById('status').textContent + document.getElementById('error').textContent !== ''`);
    }

    // Files by name, dropped on the page.
    async function drop(contents) {
        await evaluate(`document.getElementById('status').textContent = document.getElementById('error').textContent = ''`);
        const files = Object.entries(contents).map(([name, content]) => [name, Buffer.from(content).toString('base64')]);
        await evaluate(`{
            const dataTransfer = new DataTransfer();
            for (const [name, base64] of ${JSON.stringify(files)}) {
                dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
            }
            document.body.dispatchEvent(new DragEvent('drop', {dataTransfer, bubbles: true, cancelable: true}));
        }`);
        await waitFor(`document.getElementById('status').textContent + document.getElementById('error').textContent !== ''`);
    }

    async function press(id, key, code) {
        await evaluate(`document.getElementById('${id}').focus()`);
        for (const type of ['keyDown', 'keyUp']) {
            await send('Input.dispatchKeyEvent', {type, key, code: key === ' ' ? 'Space' : key, windowsVirtualKeyCode: code, text: type === 'keyDown' && key === ' ' ? ' ' : undefined});
        }
    }

    // The canvases are what the command draws of the page's scene, to the byte.
    async function comparePictures(name, format, rows) {
        const scene = await evaluate('sceneText(chosen())');
        for (const part of new Set(scene.match(/shown\S*/g))) {
            file(part, Buffer.from(await evaluate(`{ const bytes = engine.get('${part}'); let s = ''; for (const b of bytes) s += String.fromCharCode(b); btoa(s) }`), 'base64'));
        }
        file('page.scene', scene);
        for (const [canvas, words] of [['core', ['--rows', String(rows)]], ['double', ['--reference']]]) {
            const output = path.join(work, 'drawn.ppm');
            execFileSync(qtri, ['render', path.join(work, 'page.scene'), '-o', output, '--format', format, ...words]);
            const shown = await evaluate(`(${PIXELS})('${canvas}')`), drawn = fs.readFileSync(output);
            const header = `P6\n${shown.width} ${shown.height}\n255\n`;
            check(Buffer.concat([Buffer.from(header), Buffer.from(shown.base64, 'base64')]).equals(drawn), `${name}: the canvas '${canvas}' is not what qtri render ${words.join(' ')} draws`);
        }
    }

    // The header that is downloaded is what the command beside the button writes.
    async function compareHeader(name, folderOfModel) {
        const words = await evaluate('headerWords(opened.name, opened.plain)'), header = path.join(work, words[3]);
        fs.rmSync(header, {force: true});
        await evaluate(`document.getElementById('download').click()`);
        for (let i = 0; i < 200 && !fs.existsSync(header); i++) {
            await new Promise((done) => setTimeout(done, 20));
        }
        check(fs.existsSync(header), `${name}: no header is downloaded`);
        const expected = path.join(work, 'expected', words[3]);
        fs.mkdirSync(path.dirname(expected), {recursive: true});
        const run = spawnSync(qtri, [words[0], words[1], '-o', expected, ...words.slice(4)], {cwd: folderOfModel, encoding: 'utf8'});
        check(run.status === 0, `${name}: qtri ${words.join(' ')}: ${run.stderr}`);
        check(fs.existsSync(header) && fs.readFileSync(header).equals(fs.readFileSync(expected)), `${name}: the header is not that of qtri ${words.join(' ')}`);
        check(run.stdout.includes('flash: ' + (await text('flash')).replace(/[^0-9]/g, '') + ' bytes'), `${name}: flash is not that of the command`);
    }

    // The page's scene, seen as --preview sees the header's parts, is that picture but for roundings of normals and at edges.
    async function comparePreview(name) {
        const preview = path.join(work, 'preview.ppm'), drawn = path.join(work, 'drawn.ppm'), header = path.join(work, 'preview.h');
        execFileSync(qtri, ['model', path.join(work, name), '-o', header, '--preview', preview], {stdio: 'ignore'});
        const numbers = (what) => fs.readFileSync(header, 'utf8').match(new RegExp('_' + what + ' (.*)'))[1].match(/-?\d+/g).map((number) => number / 65536);
        const scale = 1 / numbers('RADIUS')[0], camera = `lookat 0 0 3 0 0 0 0 1 0\nrotate 25 1 0 0\nrotate -35 0 1 0\nscale ${scale} ${scale} ${scale}\ntranslate ${numbers('CENTER').map((number) => -number).join(' ')}`;
        file('page.scene', (await evaluate(`sceneText({...chosen(), width: 480, height: 360, depth: 'linear16'})`)).replace(/^light .*$/mg, 'light .4 .6 .7 .25 .75')
            .replace(/^texformat .*$/mg, '').replace(/^perspective .*$/mg, 'perspective 40 1.33333 .5 10').replace(/^orbit .*$/mg, camera));
        execFileSync(qtri, ['render', path.join(work, 'page.scene'), '-o', drawn]);
        const [a, b] = [preview, drawn].map((picture) => fs.readFileSync(picture).subarray(15));
        let far = 0;
        for (let i = 0; i < a.length; i += 3) far += [0, 1, 2].some((channel) => Math.abs(a[i + channel] - b[i + channel]) > 8) ? 1 : 0;
        check(far < 200, `${name}: ${far} pixels are not those of --preview`);
    }

    // At first it turns, until somebody wants it to stand.
    const first = await evaluate('degrees');
    await waitFor(`degrees !== ${first}`);
    await press('play', ' ', 32);
    check(await evaluate('!isPlaying()'), 'the space bar on the button does not stop the turning');
    await set('angle', 62);
    await press('angle', 'ArrowRight', 39);
    check(await evaluate('degrees === 64'), 'an arrow key does not turn the model');
    await comparePictures('knot', 'rgb565', 16);
    await compareHeader('knot', work);
    check(/^5,760 triangles, covering [1-9]/.test(await text('triangles')), 'triangles: ' + await text('triangles'));
    check(/^[0-9.]+ million on a Cortex-M0\+/.test(await text('instructions')), 'instructions: ' + await text('instructions'));
    check((await evaluate(`[...document.querySelectorAll('#chips td:last-child')].every((cell) => Number(cell.textContent) > 0)`)), 'frames a second are no numbers');

    // Every choice has an estimate, and each of these takes more than RGB565 with 16 bits of depth in one band.
    const costs = await evaluate(`{
        const choices = (id) => [...document.getElementById(id).options].map((option) => option.value), before = chosen(), found = [];
        for (const format of choices('format')) for (const depth of choices('depth')) for (const rows of choices('rows')) {
            engine.scene(sceneText({...before, depth}));
            const {m0plus, m3, costError} = engine.count({...before, format: Number(format), depth, rows: Number(rows), degrees});
            found.push([format + ' ' + depth + ' ' + rows, m0plus, m3, costError]);
        }
        refresh();
        found;
    }`);
    check(costs.length === 60, 'only ' + costs.length + ' choices');
    costs.forEach(([choice, m0plus, m3, error], i) => check(m0plus > m3 && m3 > costs[0][2] * (i > 0 ? 1.02 : 0.99) && error >= 10 && error <= 80, 'instructions of ' + choice + ': ' + m0plus + ', ' + m3 + ' within ' + error));

    // What is chosen is what is drawn.
    await set('model', 'gear');
    for (const [id, value] of [['size', '240x240'], ['format', '2'], ['rows', '8'], ['depth', 'linear24'], ['style', 'shade flat']]) {
        await set(id, value);
    }
    await waitFor(`document.getElementById('core').width === 240 && opened.name === 'gear'`);
    await comparePictures('gear', 'gray8', 8);
    await compareHeader('gear', work);
    await set('style', 'polygon line');
    await set('format', '1');
    await comparePictures('lines of the gear', 'rgb888', 8);
    await set('style', '');

    // A model of the user's, with materials, its picture in a folder that the browser does not tell.
    fs.mkdirSync(path.join(work, 'textures'));
    file('textures/skin.ppm', ppm(32, 16));
    await pick(file('small.obj', OBJ), file('small.mtl', MTL), path.join(work, 'textures/skin.ppm'));
    check((await text('status')).startsWith('small.obj is shown: 6 triangles,'), 'small.obj: ' + await text('status') + await text('error'));
    await comparePictures('small.obj', 'rgb888', 8);
    await compareHeader('small.obj', work);
    execFileSync(qtri, ['texture', path.join(work, 'textures/skin.ppm'), '-o', path.join(work, 'skin.png'), '--format', 'xrgb8888']);
    await drop({'small.obj': OBJ, 'small.mtl': MTL.replace('textures/skin.ppm', 'skin.png'), 'skin.png': fs.readFileSync(path.join(work, 'skin.png'))});
    file('small.mtl', MTL.replace('textures/skin.ppm', 'skin.png'));
    await compareHeader('small.obj with a PNG', work);
    // Every kind of picture has the texels that the command gives it.
    const pictures = {'deep.png': png(16, 6), 'palette.png': png(8, 3), 'passes.png': png(8, 2, true), 'alpha.png': png(8, 6)};
    Object.entries(JPEGS).forEach(([name, base64]) => pictures[name + '.jpg'] = Buffer.from(base64, 'base64'));
    for (const [name, content] of Object.entries(pictures)) {
        file('small.mtl', MTL.replace('textures/skin.ppm', name));
        file(name, content);
        await pick(path.join(work, 'small.obj'), path.join(work, 'small.mtl'), path.join(work, name));
        await compareHeader('small.obj with ' + name, work);
    }
    await pick(path.join(work, 'small.obj'));
    check(/left out: .*small.mtl/.test(await text('status')), 'without its MTL: ' + await text('status'));

    // Whatever a GLB has. Every part is drawn with its own picture, sides and opacity.
    for (const moves of [false, true]) {
        const name = moves ? 'moving.glb' : 'rich.glb';
        await pick(file(name, richGlb([png(8, 6), png(8, 2, true)], moves)));
        check(/further scene/.test(await text('status')), name + ': ' + await text('status') + await text('error'));
        await comparePictures(name, 'rgb888', 8);
        await compareHeader(name, work);
        await set('rows', moves ? '16' : '8'); /* the model is read anew */
        await compareHeader(name, work);
        await comparePreview(name);
        const scene = await evaluate('sceneText(chosen())');
        check(new Set(scene.match(/^texture .*$/mg)).size === 3 && /^blend alpha 0\.4/m.test(scene) && /^texkey 255 0 255$/m.test(scene) && /^texwrap clamp repeat/m.test(scene) && /^cull none/m.test(scene),
            name + ': parts have not what their materials say:\n' + scene);
        check((await evaluate(`sceneText({...chosen(), texture: false})`)).includes('texture') === false, 'a texture that is not wanted');
    }
    await pick(file('tetra.glb', glb()));
    check((await text('status')).startsWith('tetra.glb is shown: 4 triangles,'), 'tetra.glb: ' + await text('status') + await text('error'));

    check((await evaluate('sceneText(chosen())')).includes('color 0.486275 0.737255 0.905882'), 'tetra.glb: not the colour of its material');
    await compareHeader('tetra.glb', work);

    // What is wrong is said, and the model before it stays.
    const wrong = [
        [file('broken.obj', 'v 0 0 0\nf 1 2 3\n'), /broken\.obj:2: /],
        [file('words.glb', 'these are words, not a model'), /words\.glb does not begin as a GLB file does/],
        [file('cut.glb', glb().subarray(0, 300)), /cut\.glb ends before its last byte/],
        [file('draco.glb', glb({extensionsRequired: ['KHR_draco_mesh_compression']})), /draco\.glb has meshes that are compressed with Draco/],
        [file('meshopt.glb', glb({extensionsRequired: ['EXT_meshopt_compression']})), /meshopt\.glb: its meshes are compressed with meshopt/],
        [file('nodes.glb', glb({scenes: [{nodes: [7]}]})), /nodes\.glb is broken/],
        [file('notes.txt', 'no model'), /None of these files is a model.*notes\.txt/],
        [file('large.obj', Buffer.alloc((64 << 20) + 1, ' ')), /65 MB; this page takes up to 64/],
        [file('empty.obj', ''), /empty\.obj/],
    ];
    for (const [name, message] of wrong) {
        await pick(name);
        check(message.test(await text('error')), `${path.basename(name)}: '${await text('error')}'`);
        check(await evaluate(`opened.name === 'tetra.glb' && document.getElementById('core').width === 240`), `${name}: the model before it is gone`);
    }

    // A phone: nothing is wider than the screen; every control has a name.
    await send('Emulation.setDeviceMetricsOverride', {width: 320, height: 640, deviceScaleFactor: 2, mobile: true});
    check(await evaluate('document.documentElement.scrollWidth <= 320'), 'the page is wider than 320 pixels: ' + await evaluate('document.documentElement.scrollWidth'));
    await send('Accessibility.enable');
    const {nodes} = await send('Accessibility.getFullAXTree');
    const controls = nodes.filter((node) => !node.ignored && ['button', 'combobox', 'checkbox', 'slider', 'spinbutton', 'image', 'table'].includes(node.role.value));
    controls.filter((node) => !node.name?.value).forEach((node) => check(false, 'a ' + node.role.value + ' has no name'));
    check(controls.length >= 15, 'only ' + controls.length + ' controls and pictures are seen by a screen reader');
    if (process.env.SCREENSHOTS) {
        for (const [name, width, scheme] of [['narrow', 320, 'light'], ['wide', 1100, 'light'], ['dark', 1100, 'dark']]) {
            await send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: scheme}]});
            await send('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: width < 400});
            const {data} = await send('Page.captureScreenshot', {captureBeyondViewport: true, clip: {x: 0, y: 0, width, height: await evaluate('document.documentElement.scrollHeight'), scale: 1}});
            fs.writeFileSync(path.join(process.env.SCREENSHOTS, name + '.png'), Buffer.from(data, 'base64'));
        }
    }

    const server = await serve(), origin = 'http://127.0.0.1:' + server.address().port;
    await send('Page.navigate', {url: origin + '/index.html'});
    await waitFor(`document.getElementById('status')?.textContent.includes('is shown')`);
    server.close();

    errors.forEach((error) => check(false, 'on the console: ' + error));
    requests.filter((url) => !/^(file|data|blob):/.test(url) && !url.startsWith(origin)).forEach((url) => check(false, 'a request to ' + url));
    check(requests.filter((url) => url.endsWith('/page.js')).length === 2, 'requests are not seen');
    await browser.close();
}

main().catch((error) => check(false, String(error.stack))).finally(() => process.exit(findings > 0 ? 1 : 0));
