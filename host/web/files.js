/* SPDX-License-Identifier: MIT */
/* Files that somebody picks, as the engine reads them: pictures as PPM, GLB as OBJ with its materials. */
'use strict';

const MOST_BYTES = 64 << 20; /* of all files together */
const MOST_PIXELS = 1 << 26;
const MOST_VERTICES = 1 << 21;

/* ---- Pictures: the browser knows PNG, JPEG and more ---- */

async function pictureToPpm(name, bytes) {
    let bitmap;
    try {
        bitmap = await createImageBitmap(new Blob([bytes]), {premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
    } catch (error) {
        throw new Error(name + ' is not a picture that this browser can read.');
    }
    const {width, height} = bitmap;
    if (width * height > MOST_PIXELS) {
        throw new Error(name + ' has ' + width + ' x ' + height + ' pixels; this page takes up to 8192 x 8192.');
    }
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const rgba = context.getImageData(0, 0, width, height).data;
    const header = new TextEncoder().encode('P6\n' + width + ' ' + height + '\n255\n');
    const ppm = new Uint8Array(header.length + 3 * width * height);
    ppm.set(header);
    for (let i = 0, at = header.length; i < rgba.length; i += 4, at += 3) {
        ppm[at] = rgba[i];
        ppm[at + 1] = rgba[i + 1];
        ppm[at + 2] = rgba[i + 2];
    }
    return ppm;
}

/* ---- GLB ---- */

const GLB_ARRAYS = {5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array};
const GLB_PARTS = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4};

/* {json, binary} of the container. */
function splitGlb(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < 20 || view.getUint32(0, true) !== 0x46546c67) {
        throw new Error('does not begin as a GLB file does.');
    }
    let json = null, binary = new Uint8Array(0);
    for (let at = 12; at + 8 <= bytes.length;) {
        const length = view.getUint32(at, true), kind = view.getUint32(at + 4, true);
        if (at + 8 + length > bytes.length) {
            throw new Error('ends before its last byte.');
        }
        const chunk = bytes.subarray(at + 8, at + 8 + length);
        if (kind === 0x4e4f534a) {
            json = JSON.parse(new TextDecoder().decode(chunk));
        } else if (kind === 0x004e4942) {
            binary = chunk;
        }
        at += 8 + length;
    }
    if (json === null) {
        throw new Error('has no description of what is in it.');
    }
    return {json, binary};
}

/* The numbers of an accessor, a list of lists. */
function readAccessor(glb, index) {
    const accessor = glb.json.accessors[index], parts = GLB_PARTS[accessor.type], Numbers = GLB_ARRAYS[accessor.componentType];
    const slice = glb.json.bufferViews[accessor.bufferView];
    if (accessor.sparse !== undefined || slice === undefined || slice.buffer !== 0 || parts === undefined || Numbers === undefined) {
        throw new Error('stores its numbers in a way that this page does not read.');
    }
    const size = Numbers.BYTES_PER_ELEMENT, stride = slice.byteStride || parts * size;
    const start = (slice.byteOffset || 0) + (accessor.byteOffset || 0);
    if (start + stride * (accessor.count - 1) + parts * size > glb.binary.length) {
        throw new Error('ends before its last number.');
    }
    const scale = accessor.normalized ? {1: [127, 255], 2: [32767, 65535]}[size][accessor.componentType & 1] : 1;
    const items = [];
    for (let i = 0; i < accessor.count; i++) {
        const bytes = glb.binary.slice(start + i * stride, start + i * stride + parts * size);
        items.push(Array.from(new Numbers(bytes.buffer), (number) => number / scale));
    }
    return items;
}

/* ---- Matrices of glTF's nodes, column-major ---- */

function multiply(a, b) {
    return a.map((unused, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + i % 4] * b[4 * (i >> 2) + k], 0));
}

function matrixOf(node) {
    if (node.matrix !== undefined) {
        return node.matrix;
    }
    const [x, y, z, w] = node.rotation || [0, 0, 0, 1], s = node.scale || [1, 1, 1], t = node.translation || [0, 0, 0];
    return [
        (1 - 2 * (y * y + z * z)) * s[0], 2 * (x * y + z * w) * s[0], 2 * (x * z - y * w) * s[0], 0,
        2 * (x * y - z * w) * s[1], (1 - 2 * (x * x + z * z)) * s[1], 2 * (y * z + x * w) * s[1], 0,
        2 * (x * z + y * w) * s[2], 2 * (y * z - x * w) * s[2], (1 - 2 * (x * x + y * y)) * s[2], 0,
        t[0], t[1], t[2], 1,
    ];
}

function transformPoint(m, [x, y, z]) {
    return [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]);
}

/* By the cofactors: right for scales that differ by axis, and for mirrors. */
function transformNormal(m, [x, y, z]) {
    const row = (a, b) => [m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1], m[a + 2] * m[b] - m[a] * m[b + 2], m[a] * m[b + 1] - m[a + 1] * m[b]];
    const columns = [row(4, 8), row(8, 0), row(0, 4)];
    const n = [0, 1, 2].map((i) => columns[0][i] * x + columns[1][i] * y + columns[2][i] * z);
    const length = Math.hypot(...n) * Math.sign(columns[0][0] * m[0] + columns[0][1] * m[1] + columns[0][2] * m[2]) || 1;
    return n.map((number) => number / length);
}

/* ---- GLB to OBJ and MTL ---- */

function primitiveToObj(glb, primitive, matrix, obj) {
    const attributes = primitive.attributes;
    if ((primitive.mode ?? 4) !== 4 || attributes.POSITION === undefined) {
        return;
    }
    const positions = readAccessor(glb, attributes.POSITION);
    const normals = attributes.NORMAL !== undefined ? readAccessor(glb, attributes.NORMAL) : null;
    const uvs = attributes.TEXCOORD_0 !== undefined ? readAccessor(glb, attributes.TEXCOORD_0) : null;
    const indices = primitive.indices !== undefined ? readAccessor(glb, primitive.indices).flat() : positions.map((unused, i) => i);
    const corner = (i) => {
        const at = obj.vertices + i + 1;
        return at + (uvs ? '/' + (obj.uvs + i + 1) : normals ? '/' : '') + (normals ? '/' + (obj.normals + i + 1) : '');
    };
    positions.forEach((p) => obj.lines.push('v ' + transformPoint(matrix, p).join(' ')));
    (uvs || []).forEach((uv) => obj.lines.push('vt ' + uv[0] + ' ' + (1 - uv[1])));
    (normals || []).forEach((n) => obj.lines.push('vn ' + transformNormal(matrix, n).join(' ')));
    obj.lines.push('usemtl m' + (primitive.material ?? 'none'));
    for (let i = 0; i + 2 < indices.length; i += 3) {
        if (Math.max(indices[i], indices[i + 1], indices[i + 2]) >= positions.length) {
            throw new Error('has a triangle of vertices that are not there.');
        }
        obj.lines.push('f ' + corner(indices[i]) + ' ' + corner(indices[i + 1]) + ' ' + corner(indices[i + 2]));
    }
    obj.vertices += positions.length;
    if (obj.vertices > MOST_VERTICES) {
        throw new Error('has more than ' + MOST_VERTICES + ' vertices.');
    }
    obj.uvs += uvs ? uvs.length : 0;
    obj.normals += normals ? normals.length : 0;
}

function nodesToObj(glb, nodes, parent, depth, obj) {
    if (depth > 100) {
        throw new Error('has nodes that go in a circle.');
    }
    for (const node of nodes.map((index) => glb.json.nodes[index])) {
        const matrix = multiply(parent, matrixOf(node));
        const mesh = node.mesh !== undefined ? glb.json.meshes[node.mesh] : {primitives: []};
        mesh.primitives.forEach((primitive) => primitiveToObj(glb, primitive, matrix, obj));
        nodesToObj(glb, node.children || [], matrix, depth + 1, obj);
    }
}

/* glTF's colours are linear, MTL's are sRGB. */
function toSrgb(linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}

async function materialsToMtl(glb, stem, files) {
    const lines = ['newmtl mnone', 'Kd 1 1 1'];
    for (const [i, material] of (glb.json.materials || []).entries()) {
        const surface = material.pbrMetallicRoughness || {}, color = surface.baseColorFactor || [1, 1, 1, 1];
        lines.push('newmtl m' + i, 'Kd ' + color.slice(0, 3).map(toSrgb).join(' '));
        if (material.alphaMode === 'BLEND') {
            lines.push('d ' + color[3]);
        }
        if (surface.baseColorTexture !== undefined) {
            const source = glb.json.textures[surface.baseColorTexture.index].source;
            const slice = glb.json.bufferViews[(glb.json.images[source] || {}).bufferView];
            if (slice === undefined) {
                throw new Error('has a picture that is not inside of it.');
            }
            const name = stem + '_' + source + '.ppm', start = slice.byteOffset || 0;
            files.set(name, await pictureToPpm('A picture inside of it', glb.binary.slice(start, start + slice.byteLength)));
            lines.push('map_Kd ' + name);
        }
    }
    return lines.join('\n') + '\n';
}

/* Puts STEM.obj, STEM.mtl and pictures into `files`. */
async function glbToObj(stem, bytes, files) {
    const glb = splitGlb(bytes), json = glb.json;
    const unknown = (json.extensionsRequired || []).filter((name) => name !== 'KHR_materials_unlit' && name !== 'KHR_mesh_quantization');
    if (unknown.length > 0) {
        throw new Error('needs ' + unknown.join(', ') + ', which this page does not read.');
    }
    const obj = {lines: ['mtllib ' + stem + '.mtl'], vertices: 0, uvs: 0, normals: 0};
    const scene = (json.scenes || [])[json.scene || 0] || {nodes: (json.nodes || []).map((unused, i) => i)};
    nodesToObj(glb, scene.nodes || [], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], 0, obj);
    files.set(stem + '.mtl', await materialsToMtl(glb, stem, files));
    files.set(stem + '.obj', obj.lines.join('\n') + '\n');
}

/* ---- What was picked ---- */

const plainName = (name) => name.replace(/[^A-Za-z0-9._-]/g, '_');

/* {name, files, isGlb, title}: the name of an OBJ file, the content of all by their names. Throws what is wrong in words. */
async function readPicked(picked) {
    const files = new Map();
    const total = picked.reduce((sum, file) => sum + file.size, 0);
    const models = picked.filter((file) => /\.(obj|glb)$/i.test(file.name));
    if (models.length !== 1) {
        const what = models.length === 0 ? 'None of these files is' : 'There is more than one';
        throw new Error(what + ' a model, a file named .obj or .glb' + (models.length === 0 ? ': ' + picked.map((file) => file.name).join(', ') : '') + '.');
    }
    if (total > MOST_BYTES) {
        throw new Error('These files have ' + Math.ceil(total / (1 << 20)) + ' MB; this page takes up to ' + (MOST_BYTES >> 20) + '.');
    }
    const isGlb = /\.glb$/i.test(models[0].name);
    const name = isGlb ? plainName(models[0].name).replace(/\.glb$/i, '.obj') : models[0].name;
    for (const file of picked) {
        const bytes = new Uint8Array(await file.arrayBuffer());
        if (isGlb && file === models[0]) {
            try {
                await glbToObj(name.slice(0, -4), bytes, files);
            } catch (error) {
                throw new Error(file.name + ' ' + (error instanceof SyntaxError || error instanceof TypeError ? 'is broken: ' : '') + error.message);
            }
        } else if (/\.(obj|mtl|ppm|pgm)$/i.test(file.name)) {
            files.set(file.name, bytes);
        } else {
            files.set(file.name, await pictureToPpm(file.name, bytes));
        }
    }
    return {name, files, isGlb, title: models[0].name};
}
