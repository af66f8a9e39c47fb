/* SPDX-License-Identifier: MIT */
/* The page: what is chosen goes to the engine, pictures and figures come back. */
'use strict';

const element = (id) => document.getElementById(id);

/* core: whose instructions are taken. */
const CHIPS = [
    {name: 'RP2040', core: 'Cortex-M0+', mhz: 133},
    {name: 'SAMD21', core: 'Cortex-M0+', mhz: 48},
    {name: 'STM32F103', core: 'Cortex-M3', mhz: 72},
    {name: 'nRF52840', core: 'Cortex-M4F', mhz: 64},
    {name: 'STM32F411', core: 'Cortex-M4F', mhz: 100},
    {name: 'RP2350', core: 'Cortex-M33', mhz: 150},
];
const CYCLES = 4 / 3; /* an instruction */
const FORMAT_BITS = [16, 24, 8]; /* that are sent */
const CHECKER = 'texture 64 64 8  255 240 220 90 130 200\n';

let engine = null;
/* What is open: a name that `qtri model` knows or a file's, the files, and what the commands said of them. */
let opened = null;
let degrees = Number(element('angle').value);

/* ---- Words ---- */

const count = (number) => Math.round(number).toLocaleString('en');

/* Screen readers say what changes here. */
function say(text) {
    element('error').textContent = '';
    element('status').textContent = text;
}

function complain(text) {
    element('error').textContent = text;
}

/* ---- What is chosen ---- */

function chosen() {
    const [width, height] = element('size').value.split('x').map(Number);
    return {
        width, height,
        format: Number(element('format').value),
        rows: Math.min(Number(element('rows').value) || height, height),
        depth: element('depth').value,
        style: element('style').value,
        texture: element('texture').checked,
        backs: element('backs').checked,
        bus: Math.max(Number(element('bus').value) || 1, 1),
    };
}

/* ---- A model: its header, and what is drawn of it ---- */

function headerWords(name, plain) {
    const look = chosen(), stem = name.replace(/^.*\//, '').replace(/\.[^.]*$/, '');
    return ['model', name, '-o', stem + '.h', '--panel', look.width + 'x' + look.height, '--rows', String(look.rows)]
        .concat(engine.hasOrder ? [] : ['--keep-order'], plain ? ['--plain'] : []);
}

function numbersOf(report, pattern) {
    const found = pattern.exec(report);
    return found === null ? [] : found.slice(1).map(Number);
}

/* `qtri model`, without materials where these are missing. */
function runModel(name) {
    let result = engine.model(headerWords(name, false)), left = '';
    if (!result.ok && /--plain does without|there is no picture/.test(result.message)) {
        left = 'Materials and pictures are left out: ' + result.message.replace(/^qtri model: /, '').replace('; --plain does without', '') + '. Pick these files together.';
        result = engine.model(headerWords(name, true));
    }
    if (!result.ok) {
        throw new Error(result.message.replace(/^qtri model: /, ''));
    }
    return {result, left: [left, result.message].filter((text) => text !== '').join(' '), plain: left !== ''};
}

/* Throws what is wrong; then nothing is open. */
function open(name, files) {
    engine.clear();
    files.forEach((content, fileName) => engine.put(fileName, content));
    const {result, left, plain} = runModel(name), words = headerWords(name, plain);
    opened = {name, files, plain, left, parts: engine.show(words), isBuiltIn: files.size === 0, report: result.report, words: words.join()};
}

/* The report on RAM is that of a display. */
function reportOfModel() {
    const words = headerWords(opened.name, opened.plain);
    if (words.join() !== opened.words) {
        opened.report = engine.model(words).report;
        opened.words = words.join();
    }
    return opened.report;
}

/* What a part does to the state of its pass. */
function stateOf(look, [texture, hasKey, clampU, clampV, twoSided, hasNormals, opacity]) {
    const wrap = (clamps) => clamps ? 'clamp' : 'repeat', isTextured = look.texture && texture >= 0;
    return 'cull ' + (look.backs || twoSided ? 'none' : 'back') + '\n' + (look.style || (hasNormals ? '' : 'shade flat')) + '\n' +
        (opacity < 255 ? 'depthmask off\nblend alpha ' + (opacity / 255).toFixed(6) + '\n' : '') +
        (isTextured ? 'texture shown_' + texture + '.ppm\ntexformat rgb565\ntexwrap ' + wrap(clampU) + ' ' + wrap(clampV) + '\n' + (hasKey ? 'texkey 255 0 255\n' : '')
            : look.texture && opened.isBuiltIn ? CHECKER : '');
}

function meshOf(part, i) {
    const color = opened.isBuiltIn ? [1, 0.75, 0.4] : part.slice(7, 10).map((byte) => byte / 255), matrix = part.slice(10);
    const mesh = 'mesh shown_' + i + '.obj color ' + color.map((share) => share.toFixed(6)).join(' ') + '\n';
    return matrix.every((number, at) => number === (at % 5 === 0 ? 1 : 0)) ? mesh : 'push\nmult ' + matrix.map((number) => number.toFixed(6)).join(' ') + '\n' + mesh + 'pop\n';
}

/* Parts are drawn as the header has them, a pass for those of one state. */
function sceneText(look) {
    const whole = 'viewport ' + look.width + ' ' + look.height + '\nclear .094118 .125490 .188235\ndepthformat ' + look.depth + '\n';
    const begin = 'depth less\nlight .4 .6 .69282032 .2 .8\n';
    const camera = 'mode projection\nperspective 40 ' + (look.width / look.height).toFixed(6) + ' .1 100\nmode modelview\norbit 0 0 0 4.2 ' + degrees + ' 20\n';
    const passes = [];
    opened.parts.forEach((part, i) => {
        const state = stateOf(look, part);
        if (passes.length === 0 || passes[passes.length - 1].state !== state) {
            passes.push({state, meshes: ''});
        }
        passes[passes.length - 1].meshes += meshOf(part, i);
    });
    return whole + passes.map(({state, meshes}) => begin + state + camera + meshes).join('pass\n');
}

/* ---- Pictures ---- */

function paint(id, what, look) {
    const canvas = element(id), pixels = look.width * look.height;
    const rgb = engine.draw(what, {...look, degrees}, pixels);
    if (canvas.width !== look.width || canvas.height !== look.height) {
        canvas.width = look.width;
        canvas.height = look.height;
    }
    const context = canvas.getContext('2d', {willReadFrequently: true}), image = context.createImageData(look.width, look.height);
    for (let i = 0, at = 0; i < pixels; i++, at += 3) {
        image.data[4 * i] = rgb[at];
        image.data[4 * i + 1] = rgb[at + 1];
        image.data[4 * i + 2] = rgb[at + 2];
        image.data[4 * i + 3] = 255;
    }
    context.putImageData(image, 0, 0);
}

/* Bands do not change a pixel: what moves is drawn in one, which is quicker here. */
function drawFrame() {
    const look = {...chosen(), ...(isPlaying() ? {rows: 0} : {})};
    paint('core', 0, look);
    if (element('compare').checked) {
        paint('double', 1, look);
        paint('difference', 2, look);
    }
}

/* ---- Figures ---- */

function showChips(look, figures) {
    const sendSeconds = look.width * look.height * FORMAT_BITS[look.format] / (look.bus * 1e6);
    const rows = CHIPS.map((chip) => {
        const instructions = chip.core === 'Cortex-M0+' ? figures.m0plus : figures.m3;
        const seconds = instructions * CYCLES / (chip.mhz * 1e6);
        const perSecond = (time) => instructions === 0 ? 'unknown' : (1 / time).toFixed(1 / time < 10 ? 1 : 0);
        return [chip.name, chip.core, chip.mhz, perSecond(seconds), perSecond(seconds + sendSeconds)];
    });
    element('chips').replaceChildren(...rows.map((cells) => {
        const row = document.createElement('tr');
        cells.forEach((cell, i) => {
            const box = document.createElement(i === 0 ? 'th' : 'td');
            if (i === 0) {
                box.scope = 'row';
            }
            box.textContent = cell;
            row.append(box);
        });
        return row;
    }));
}

function showFigures(look, report) {
    const figures = engine.count({...look, degrees});
    const [flash] = numbersOf(report, /^flash: (\d+)/m);
    const [line, vertices, lists] = numbersOf(report, /(\d+) line, (\d+) vertices, (\d+) lists/);
    const millions = (number) => (number / 1e6).toFixed(2);
    element('triangles').textContent = count(figures.triangles) + ' triangles, covering ' + count(figures.pixels) + ' pixels';
    element('flash').textContent = count(flash) + ' bytes';
    element('ram').textContent = count(figures.bandBytes + line + vertices + lists) + ' bytes: ' + count(figures.bandBytes) + ' for colour and depth, ' +
        count(line) + ' to send, ' + count(vertices + lists) + ' for vertices and lists';
    element('instructions').textContent = figures.m3 === 0 ? 'unknown for lines that are seen through'
        : millions(figures.m0plus) + ' million on a Cortex-M0+, ' + millions(figures.m3) + ' on an M3, within ' + figures.costError + ' %';
    if (isPlaying()) {
        element('differing').textContent = 'counted when it stands';
    } else if (element('compare').checked) {
        element('differing').textContent = figures.differing === 0 ? 'none'
            : count(figures.differing) + ' pixels, by at most ' + figures.largestError + ' of 255';
    }
    showChips(look, figures);
}

/* Everything that follows from what is chosen and what is open. */
function refresh() {
    const look = chosen();
    engine.scene(sceneText(look));
    drawFrame();
    showFigures(look, reportOfModel());
    element('command').textContent = 'qtri ' + headerWords(opened.name, opened.plain).map((word) => /[^\w.\/-]/.test(word) ? "'" + word + "'" : word).join(' ');
    element('equality').textContent = 'Byte for byte' + (engine.hasOrder ? '.' : '; --keep-order, since this page was built without the library that orders triangles for the vertex cache.') +
        (/^motion:/m.test(opened.report) ? ' It holds the motion; the pictures show its beginning.' : '');
    ['core', 'double'].forEach((id, i) => element(id).setAttribute('aria-label', opened.name + ' in ' + ['fixed point', 'double precision'][i] + ', ' + look.width + ' by ' + look.height + ' pixels'));
}

/* ---- What the user does ---- */

/* After a crash the module's memory is not to be trusted. */
async function guard(action) {
    const before = opened;
    try {
        await action();
    } catch (error) {
        const isCrash = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
        if (isCrash) {
            engine = await createEngine();
        }
        if (before !== null) {
            open(before.name, before.files);
            refresh();
        }
        complain(isCrash ? 'This model is more than the page can take: ' + error.message : error.message);
    }
}

function openAnd(name, files, title) {
    open(name, files);
    refresh();
    say(title + ' is shown: ' + element('triangles').textContent + '.' + (opened.left ? ' ' + opened.left : ''));
}

const openBuiltIn = () => guard(() => openAnd(element('model').value, new Map(), 'The ' + element('model').value));

const openPicked = (picked) => guard(async () => {
    const {name, files} = await readPicked(picked);
    openAnd(name, files, name);
    element('model').querySelector('[value=opened]').hidden = false;
    element('model').value = 'opened';
});

function download() {
    const bytes = engine.get(headerWords(opened.name, false)[3]);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes], {type: 'text/x-c'}));
    link.download = headerWords(opened.name, false)[3];
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    say(link.download + ', ' + count(bytes.length) + ' bytes, is downloaded.');
}

const isPlaying = () => element('play').getAttribute('aria-pressed') === 'true';

function showDegrees(value) {
    degrees = value;
    element('angle').value = String(value);
    drawFrame();
}

let lastStep = 0; /* of 2 degrees, 18 a second: ten seconds for a turn, whatever a frame takes */

function animate(milliseconds) {
    const step = Math.floor(milliseconds * 0.018);
    if (isPlaying() && opened !== null && step !== lastStep) {
        showDegrees((degrees + 2 * (step - lastStep)) % 360);
    }
    lastStep = step;
    requestAnimationFrame(animate);
}

function setPlaying(plays) {
    element('play').setAttribute('aria-pressed', String(plays));
    if (!plays && opened !== null) {
        guard(refresh);
    }
}

function listen() {
    element('play').addEventListener('click', () => setPlaying(!isPlaying()));
    element('angle').addEventListener('input', () => {
        const value = Number(element('angle').value);
        setPlaying(false);
        showDegrees(value);
        guard(refresh);
    });
    element('model').addEventListener('change', () => element('model').value !== 'opened' && openBuiltIn());
    element('files').addEventListener('click', () => element('files').value = ''); /* the same file may have changed */
    element('files').addEventListener('change', () => element('files').files.length > 0 && openPicked([...element('files').files]));
    element('download').addEventListener('click', download);
    ['size', 'format', 'rows', 'depth', 'style', 'texture', 'backs', 'bus', 'compare'].forEach((id) => element(id).addEventListener('change', () => guard(() => {
        refresh();
        say(element('triangles').textContent + '; RAM ' + element('ram').textContent + '.');
    })));
    document.addEventListener('dragover', (event) => {
        event.preventDefault();
        document.body.classList.add('over');
    });
    document.addEventListener('dragleave', () => document.body.classList.remove('over'));
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        document.body.classList.remove('over');
        if (event.dataTransfer.files.length > 0) {
            openPicked([...event.dataTransfer.files]);
        }
    });
}

async function start() {
    try {
        engine = await createEngine();
    } catch (error) {
        complain('This browser cannot run the page: ' + error.message);
        return;
    }
    listen();
    setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches);
    await openBuiltIn();
    requestAnimationFrame(animate);
}

start();
