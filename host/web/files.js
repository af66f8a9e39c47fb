/* SPDX-License-Identifier: MIT */
/* Files that somebody picks, as the engine reads them. */
'use strict';

const MOST_BYTES = 64 << 20; /* of all files together */

/* ---- GLB ---- */

const GLB_ARRAYS = {5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array};
const GLB_PARTS = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16};

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

/* `count` elements of `width` numbers, as they are stored, which lie in a view of the buffer; null: all zero. */
function readView(glb, index, offset, Numbers, width, count) {
    const size = width * Numbers.BYTES_PER_ELEMENT, slice = glb.json.bufferViews[index], packed = new Uint8Array(count * size);
    if (slice !== undefined) {
        const stride = slice.byteStride || size, start = (slice.byteOffset || 0) + (offset || 0);
        if (slice.buffer !== 0 || start + stride * (count - 1) + size > glb.binary.length) {
            throw new Error('ends before its last number.');
        }
        for (let i = 0; i < count; i++) {
            packed.set(glb.binary.subarray(start + i * stride, start + i * stride + size), i * size);
        }
    }
    return new Numbers(packed.buffer);
}

/* {values, width, count} of an accessor; whole numbers that are shares of the largest as such. */
function readAccessor(glb, index) {
    const {type, componentType, count, bufferView, byteOffset, sparse, normalized} = glb.json.accessors[index];
    const width = GLB_PARTS[type], Numbers = GLB_ARRAYS[componentType];
    if (width === undefined || Numbers === undefined || !(count <= MOST_BYTES)) {
        throw new Error('stores its numbers in a way that this page does not read.');
    }
    const values = readView(glb, bufferView, byteOffset, Numbers, width, count);
    if (sparse !== undefined) {
        const own = readView(glb, sparse.values.bufferView, sparse.values.byteOffset, Numbers, width, sparse.count);
        readView(glb, sparse.indices.bufferView, sparse.indices.byteOffset, GLB_ARRAYS[sparse.indices.componentType], 1, sparse.count)
            .forEach((at, i) => values.set(own.subarray(i * width, i * width + width), at * width));
    }
    const largest = 2 ** (8 * Numbers.BYTES_PER_ELEMENT - (componentType & 1 ? 0 : 1)) - 1;
    return {values: normalized ? Float32Array.from(values, (value) => value / largest) : values, width, count};
}

/* The values of an attribute; null where there is none for every vertex. */
function readAttribute(glb, index, width, count) {
    const accessor = index !== undefined ? readAccessor(glb, index) : {};
    return accessor.count === count && accessor.width === width ? accessor.values : null;
}

/* ---- GLB to the words that web_import.c reads ---- */

class Words {
    pieces = [];
    whole(...numbers) {
        this.pieces.push(new Uint8Array(Uint32Array.from(numbers).buffer));
    }
    reals(numbers) {
        this.pieces.push(new Uint8Array(Float32Array.from(numbers).buffer));
    }
    bytes(bytes) {
        this.whole(bytes.length);
        this.pieces.push(bytes, new Uint8Array(-bytes.length & 3));
    }
    text(text) {
        this.bytes(new TextEncoder().encode(text));
    }
}

/* The library assimp numbers materials and pictures by when they are met. */
function numberOf(list, index) {
    if (!list.includes(index)) {
        list.push(index);
    }
    return list.indexOf(index);
}

const nodeName = (json, index) => json.nodes[index].name || 'nodes_' + index;

/* A picture's bytes; null: a file beside the GLB. */
function pictureBytes(glb, image) {
    const slice = glb.json.bufferViews[image.bufferView], start = slice !== undefined ? slice.byteOffset || 0 : 0;
    const inside = /^data:[^,]*;base64,(.*)$/.exec(image.uri || '');
    return slice !== undefined ? glb.binary.subarray(start, start + slice.byteLength)
        : inside !== null ? Uint8Array.from(atob(inside[1]), (letter) => letter.charCodeAt(0)) : null;
}

function writeMaterial(out, glb, material, pictures) {
    const surface = material.pbrMetallicRoughness || {}, use = surface.baseColorTexture;
    const others = [material.normalTexture, material.occlusionTexture, material.emissiveTexture].filter((other) => other !== undefined);
    const texture = use !== undefined ? glb.json.textures[use.index] : {}, image = (glb.json.images || [])[texture.source];
    const sampler = (glb.json.samplers || [])[texture.sampler] || {}, wraps = {33071: 1, 33648: 2};
    const {offset = [0, 0], rotation = 0, scale = [1, 1], texCoord = (use || {}).texCoord} = ((use || {}).extensions || {}).KHR_texture_transform || {};
    const path = image === undefined ? '' : pictureBytes(glb, image) !== null ? '*' + numberOf(pictures, texture.source) : image.uri;
    out.text(material.name || '');
    out.text(material.alphaMode || 'OPAQUE');
    out.reals([...(surface.baseColorFactor || [1, 1, 1, 1]), ...(material.emissiveFactor || [0, 0, 0]), 1]);
    out.whole(material.doubleSided ? 1 : 0, others.length, image !== undefined ? 1 : 0);
    out.text(path);
    out.whole(texCoord || 0, wraps[sampler.wrapS] || 0, wraps[sampler.wrapT] || 0);
    out.reals([...offset, rotation, ...scale]);
}

/* Corners of triangles, three each. */
function trianglesOf(mode, corners) {
    const list = [];
    for (let i = 0; i + 2 < corners.length && mode > 4; i++) {
        list.push(corners[mode === 6 ? 0 : i + i % 2], corners[mode === 6 ? i + 1 : i + 1 - i % 2], corners[i + 2]);
    }
    return mode > 4 ? list : mode === 4 ? corners.slice(0, corners.length - corners.length % 3) : [];
}

/* Which joints move a primitive's vertices: lists of a vertex and a weight. */
function writeBones(out, glb, skin, {JOINTS_0, WEIGHTS_0}, count) {
    const joints = readAttribute(glb, JOINTS_0, 4, count), weights = readAttribute(glb, WEIGHTS_0, 4, count);
    const matrices = readAttribute(glb, skin.inverseBindMatrices, 16, skin.joints.length), uses = skin.joints.map(() => []);
    if (joints === null || weights === null || matrices === null) {
        throw new Error('has a skin that is not complete.');
    }
    weights.forEach((weight, i) => weight > 0 && uses[joints[i]] !== undefined && uses[joints[i]].push(i));
    out.whole(uses.length);
    uses.forEach((list, i) => {
        const pairs = new Uint32Array(2 * list.length);
        list.forEach((at, k) => pairs[2 * k] = at >> 2);
        list.forEach((at, k) => new Float32Array(pairs.buffer, 8 * k + 4, 1)[0] = weights[at]);
        out.text(nodeName(glb.json, skin.joints[i]));
        out.reals(matrices.subarray(16 * i, 16 * i + 16));
        out.whole(list.length);
        out.pieces.push(new Uint8Array(pairs.buffer));
    });
}

/* Whether there are any, and the values of all vertices. */
function writeOptional(out, values) {
    out.whole(values !== null ? 1 : 0);
    out.reals(values || []);
}

function writePrimitive(out, glb, mesh, primitive, material, skin) {
    const {attributes, mode = 4, targets = []} = primitive, {values: positions, width, count} = readAccessor(glb, attributes.POSITION);
    const sets = (name, least) => [0, 1, 2, 3, 4, 5, 6, 7].map((i) => attributes[name + i]).filter((index) => index !== undefined).map((index) => readAccessor(glb, index))
        .filter((set) => set.count === count && set.width >= least);
    const corners = primitive.indices !== undefined ? readAccessor(glb, primitive.indices).values : Uint32Array.from({length: count}, (unused, i) => i);
    const uvs = sets('TEXCOORD_', 2), colors = sets('COLOR_', 3), triangles = trianglesOf(mode, corners);
    if (width !== 3) {
        throw new Error('has positions that are not of three numbers.');
    }
    out.whole(mode >= 4 ? 1 : 0, material, count);
    out.reals(positions);
    writeOptional(out, readAttribute(glb, attributes.NORMAL, 3, count));
    for (const [list, kept] of [[uvs, 2], [colors, 4]]) {
        out.whole(list.length);
        list.forEach((set) => out.reals(set.width === kept ? set.values
            : Float32Array.from({length: kept * count}, (unused, i) => i % kept < set.width ? set.values[Math.floor(i / kept) * set.width + i % kept] : 1)));
    }
    out.whole(triangles.length / 3);
    out.pieces.push(new Uint8Array(Uint32Array.from(triangles).buffer));
    out.whole(targets.length);
    targets.forEach((target, i) => {
        out.reals([(mesh.weights || [])[i] || 0]);
        out.whole(target.NORMAL !== undefined ? 1 : 0);
        writeOptional(out, readAttribute(glb, target.POSITION, 3, count));
    });
    if (skin !== undefined && attributes.JOINTS_0 !== undefined) {
        writeBones(out, glb, skin, attributes, count);
    } else {
        out.whole(0);
    }
}

function writeNode(out, glb, index, depth, used) {
    const node = glb.json.nodes[index], mesh = node.mesh !== undefined ? glb.json.meshes[node.mesh] : {primitives: []};
    if (depth > 100) {
        throw new Error('has nodes that go in a circle.');
    }
    out.text(nodeName(glb.json, index));
    out.whole(node.matrix !== undefined ? 1 : 0);
    out.reals(node.matrix || [...(node.translation || [0, 0, 0]), ...(node.rotation || [0, 0, 0, 1]), ...(node.scale || [1, 1, 1])]);
    const children = new Words();
    (node.children || []).forEach((child) => writeNode(children, glb, child, depth + 1, used));
    const light = ((node.extensions || {}).KHR_lights_punctual || {}).light;
    node.camera !== undefined && numberOf(used.cameras, node.camera);
    light !== undefined && numberOf(used.lights, light);
    const primitives = mesh.primitives.filter((primitive) => primitive.attributes.POSITION !== undefined);
    out.whole(primitives.length, ...primitives.map((primitive, i) => used.meshes.push([mesh, primitive, primitive.material !== undefined ? numberOf(used.materials, primitive.material) : -1, (glb.json.skins || [])[node.skin]]) - 1));
    out.whole((node.children || []).length);
    out.pieces.push(...children.pieces);
}

/* The times of keys, and `width` values at each, 0: as many as there are. Of a curve they stand between its slopes. */
function readSampler(glb, sampler, width) {
    const times = readAccessor(glb, sampler.input).values, values = readAccessor(glb, sampler.output).values;
    const isCurve = sampler.interpolation === 'CUBICSPLINE', each = width || Math.floor(values.length / times.length / (isCurve ? 3 : 1));
    const first = (i) => isCurve ? (3 * i + 1) * each : i * each;
    if (times.length === 0 || first(times.length - 1) + each > values.length) {
        throw new Error('has fewer values than times in its animation.');
    }
    return {times, each, valuesAt: (i) => values.subarray(first(i), first(i) + each)};
}

function writeKeys(out, glb, sampler, width, rest) {
    if (sampler === undefined) {
        out.whole(rest !== undefined ? 1 : 0);
        out.reals(rest !== undefined ? [0, ...rest] : []);
        return;
    }
    const {times, valuesAt} = readSampler(glb, sampler, width);
    out.whole(times.length);
    times.forEach((time, i) => out.reals([time, ...valuesAt(i)]));
}

function writeAnimation(out, glb, animation) {
    const nodes = [...new Set(animation.channels.map((channel) => channel.target.node))].filter((index) => index !== undefined);
    const samplerOf = (index, path) => animation.samplers[(animation.channels.find(({target}) => target.node === index && target.path === path) || {}).sampler];
    const moved = nodes.filter((index) => ['translation', 'rotation', 'scale'].some((path) => samplerOf(index, path) !== undefined));
    const shaped = nodes.filter((index) => samplerOf(index, 'weights') !== undefined);
    out.whole(moved.length);
    moved.forEach((index) => {
        out.text(nodeName(glb.json, index));
        [['translation', 3], ['rotation', 4], ['scale', 3]].forEach(([path, width]) => writeKeys(out, glb, samplerOf(index, path), width, glb.json.nodes[index][path]));
    });
    out.whole(shaped.length);
    shaped.forEach((index) => {
        const {times, each, valuesAt} = readSampler(glb, samplerOf(index, 'weights'), 0);
        out.text(nodeName(glb.json, index));
        out.whole(times.length, each);
        times.forEach((time, i) => out.reals([time, ...valuesAt(i)]));
    });
}

/* What web_import.c reads. */
function glbToWords(bytes) {
    const glb = splitGlb(bytes), json = glb.json, out = new Words(), nodes = new Words(), materials = new Words();
    if ((json.extensionsRequired || []).includes('KHR_draco_mesh_compression')) {
        throw new Error('has meshes that are compressed with Draco, which this page does not read.');
    }
    if ((json.extensionsRequired || []).some((name) => /meshopt|quantization|basisu|webp/.test(name))) {
        return new Uint8Array(0); /* model_check_gltf says it by name */
    }
    const roots = ((json.scenes || [])[json.scene || 0] || {}).nodes || [], used = {meshes: [], materials: [], pictures: [], cameras: [], lights: []};
    if (roots.length !== 1) {
        nodes.text('ROOT');
        nodes.whole(0);
        nodes.reals([0, 0, 0, 0, 0, 0, 1, 1, 1, 1]);
        nodes.whole(0, roots.length);
    }
    roots.forEach((index) => writeNode(nodes, glb, index, 0, used));
    used.materials.forEach((index) => writeMaterial(materials, glb, json.materials[index], used.pictures));
    writeMaterial(materials, glb, {}, used.pictures);
    out.whole(used.pictures.length);
    used.pictures.forEach((index) => out.bytes(pictureBytes(glb, json.images[index])));
    out.whole(used.materials.length + 1);
    out.pieces.push(...materials.pieces);
    out.whole(used.meshes.length);
    used.meshes.forEach(([mesh, primitive, material, skin]) => writePrimitive(out, glb, mesh, primitive, material < 0 ? used.materials.length : material, skin));
    out.pieces.push(...nodes.pieces);
    out.whole((json.animations || []).length);
    (json.animations || []).slice(0, 1).forEach((animation) => writeAnimation(out, glb, animation));
    out.whole(used.cameras.length, used.lights.length);
    return joinBytes(out.pieces);
}

function joinBytes(pieces) {
    const joined = new Uint8Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
    pieces.reduce((at, piece) => {
        joined.set(piece, at);
        return at + piece.length;
    }, 0);
    return joined;
}

/* ---- What was picked ---- */

/* {name, files}: the name of a model, the content of all files by their names. Throws what is wrong in words. */
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
    for (const file of picked) {
        files.set(file.name, new Uint8Array(await file.arrayBuffer()));
    }
    const name = models[0].name;
    if (/\.glb$/i.test(name)) {
        try {
            files.set(name + '.words', glbToWords(files.get(name)));
        } catch (error) {
            throw new Error(name + ' ' + (error instanceof SyntaxError || error instanceof TypeError ? 'is broken: ' : '') + error.message);
        }
    }
    return {name, files};
}
