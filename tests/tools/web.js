// SPDX-License-Identifier: MIT
// The page of host/web in a browser, against the command: web.js CHROMIUM PAGE-FOLDER QTRI WORK-FOLDER
// Prints what is wrong; the status is how much of it there was.
'use strict';
const {execFileSync, spawnSync} = require('child_process');
const fs = require('fs');
const http = require('http');
const path = require('path');
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

// A tetrahedron with a material, moved by its node.
function glb() {
    const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const indices = new Uint16Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
    const binary = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(indices.buffer)]);
    const json = JSON.stringify({
        asset: {version: '2.0'}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0, scale: [2, 1, 1]}],
        meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
        materials: [{pbrMetallicRoughness: {baseColorFactor: [0.2, 0.5, 0.8, 1]}}],
        buffers: [{byteLength: binary.length}],
        bufferViews: [{buffer: 0, byteOffset: 0, byteLength: 48}, {buffer: 0, byteOffset: 48, byteLength: 24}],
        accessors: [{bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 1]},
            {bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR'}],
    });
    const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
    const numbers = (...list) => Buffer.from(new Uint32Array(list).buffer);
    return Buffer.concat([numbers(0x46546c67, 2, 28 + text.length + binary.length, text.length, 0x4e4f534a), text,
        numbers(binary.length, 0x004e4942), binary]);
}

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
        for (const part of scene.match(/shown\S*/g)) {
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
    await pick(path.join(work, 'small.obj'));
    check(/left out: .*small.mtl/.test(await text('status')), 'without its MTL: ' + await text('status'));
    await pick(file('tetra.glb', glb()));
    check((await text('status')).startsWith('tetra.glb is shown: 4 triangles,'), 'tetra.glb: ' + await text('status') + await text('error'));

    check((await evaluate('sceneText(chosen())')).includes('color 0.486275 0.737255 0.905882'), 'tetra.glb: not the colour of its material');

    // What is wrong is said, and the model before it stays.
    const wrong = [
        [file('broken.obj', 'v 0 0 0\nf 1 2 3\n'), /broken\.obj:2: /],
        [file('words.glb', 'these are words, not a model'), /words\.glb does not begin as a GLB file does/],
        [file('cut.glb', glb().subarray(0, 300)), /cut\.glb ends before its last byte/],
        [file('notes.txt', 'no model'), /None of these files is a model.*notes\.txt/],
        [file('large.obj', Buffer.alloc((64 << 20) + 1, ' ')), /65 MB; this page takes up to 64/],
        [file('empty.obj', ''), /empty\.obj/],
    ];
    for (const [name, message] of wrong) {
        await pick(name);
        check(message.test(await text('error')), `${path.basename(name)}: '${await text('error')}'`);
        check(await evaluate(`opened.name === 'tetra.obj' && document.getElementById('core').width === 240`), `${name}: the model before it is gone`);
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
