// Makes the models beside it: one plain glTF file each and the same with an extension, by glTF-Transform, and the
// vertices that three.js computes for skins, morph targets and animations.
//   npm install @gltf-transform/core @gltf-transform/extensions @gltf-transform/functions draco3dgltf meshoptimizer sharp three
//   node make_models.mjs FOLDER
import fs from 'node:fs';
import {Document, NodeIO} from '@gltf-transform/core';
import {ALL_EXTENSIONS, EXTMeshGPUInstancing, EXTMeshoptCompression, KHRDracoMeshCompression, KHRMaterialsVariants} from '@gltf-transform/extensions';
import {cloneDocument, quantize, reorder, textureCompress} from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import {MeshoptDecoder, MeshoptEncoder} from 'meshoptimizer';
import sharp from 'sharp';
import * as THREE from 'three';

const folder = process.argv[2] ?? '.';
await MeshoptEncoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.encoder': await draco3d.createEncoderModule(),
  'draco3d.decoder': await draco3d.createDecoderModule(),
  'meshopt.encoder': MeshoptEncoder, 'meshopt.decoder': MeshoptDecoder});
const write = (name, document) => io.write(`${folder}/${name}`, document);

/// A torus with normals and texture coordinates; `n` corners round it and `m` round its tube.
function torus(n, m) {
  const position = [], normal = [], uv = [], index = [];
  for (let i = 0; i <= n; ++i) {
    for (let j = 0; j <= m; ++j) {
      const a = 2 * Math.PI * i / n, b = 2 * Math.PI * j / m;
      normal.push(Math.cos(a) * Math.cos(b), Math.sin(b), Math.sin(a) * Math.cos(b));
      position.push(Math.cos(a) * (1 + .4 * Math.cos(b)), .4 * Math.sin(b), Math.sin(a) * (1 + .4 * Math.cos(b)));
      uv.push(2 * i / n, j / m);
      if (i === n || j === m) continue;
      const at = i * (m + 1) + j;
      index.push(at, at + 1, at + m + 1, at + 1, at + m + 2, at + m + 1);
    }
  }
  return {position, normal, uv, index};
}

async function picture() {
  const size = 16, raw = Buffer.alloc(size * size * 3);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const light = (x >> 2) + (y >> 2) & 1;
      raw.set([light ? 230 : 40 + 8 * x, light ? 200 - 6 * y : 90, light ? 60 : 180], 3 * (y * size + x));
    }
  }
  return sharp(raw, {raw: {width: size, height: size, channels: 3}}).png().toBuffer();
}

async function torusDocument() {
  const document = new Document(), buffer = document.createBuffer(), shape = torus(24, 12);
  const list = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const texture = document.createTexture('checks').setImage(await picture()).setMimeType('image/png');
  const material = document.createMaterial('checks').setBaseColorTexture(texture).setMetallicFactor(0).setRoughnessFactor(.4);
  const primitive = document.createPrimitive().setMaterial(material)
    .setAttribute('POSITION', list('VEC3', new Float32Array(shape.position)))
    .setAttribute('NORMAL', list('VEC3', new Float32Array(shape.normal)))
    .setAttribute('TEXCOORD_0', list('VEC2', new Float32Array(shape.uv)))
    .setIndices(list('SCALAR', new Uint16Array(shape.index)));
  const mesh = document.createMesh('torus').addPrimitive(primitive);
  document.createScene().addChild(document.createNode('torus').setMesh(mesh));
  return document;
}

const plain = await torusDocument();
await write('torus.glb', plain);

const draco = cloneDocument(plain);
draco.createExtension(KHRDracoMeshCompression).setRequired(true)
  .setEncoderOptions({method: KHRDracoMeshCompression.EncoderMethod.EDGEBREAKER, encodeSpeed: 5, decodeSpeed: 5});
await write('torus-draco.glb', draco);

const sequential = cloneDocument(plain);
sequential.createExtension(KHRDracoMeshCompression).setRequired(true)
  .setEncoderOptions({method: KHRDracoMeshCompression.EncoderMethod.SEQUENTIAL, encodeSpeed: 5, decodeSpeed: 5});
await write('torus-draco-sequential.glb', sequential);

const meshopt = cloneDocument(plain);
await meshopt.transform(reorder({encoder: MeshoptEncoder}), quantize());
await write('torus-quantized.glb', meshopt);
meshopt.createExtension(EXTMeshoptCompression).setRequired(true)
  .setEncoderOptions({method: EXTMeshoptCompression.EncoderMethod.FILTER});
await write('torus-meshopt.glb', meshopt);

const webp = cloneDocument(plain);
await webp.transform(textureCompress({encoder: sharp, targetFormat: 'webp', lossless: true}));
await write('torus-webp.glb', webp);

/// Nine tori, as nodes and as instances of one.
const nodes = cloneDocument(plain), instanced = cloneDocument(plain);
const count = 9, translation = [], rotation = [], scale = [];
for (let i = 0; i < count; ++i) {
  const turn = new THREE.Quaternion().setFromEuler(new THREE.Euler(.4 * i, .3 * i, 0));
  translation.push(4 * (i % 3), .5 * i, 4 * Math.floor(i / 3));
  rotation.push(...turn.toArray());
  scale.push(.5 + .1 * i, .8, 1);
}
{
  const root = nodes.getRoot(), scene = root.listScenes()[0], first = root.listNodes()[0];
  for (let i = 0; i < count; ++i) {
    scene.addChild(nodes.createNode('torus').setMesh(root.listMeshes()[0]).setTranslation(translation.slice(3 * i, 3 * i + 3))
      .setRotation(rotation.slice(4 * i, 4 * i + 4)).setScale(scale.slice(3 * i, 3 * i + 3)));
  }
  first.dispose();
  await write('tori.glb', nodes);
}
{
  const root = instanced.getRoot(), buffer = root.listBuffers()[0];
  const extension = instanced.createExtension(EXTMeshGPUInstancing).setRequired(true);
  const list = (type, array) => instanced.createAccessor().setType(type).setArray(new Float32Array(array)).setBuffer(buffer);
  root.listNodes()[0].setExtension('EXT_mesh_gpu_instancing', extension.createInstancedMesh()
    .setAttribute('TRANSLATION', list('VEC3', translation)).setAttribute('ROTATION', list('VEC4', rotation))
    .setAttribute('SCALE', list('VEC3', scale)));
  await write('tori-instanced.glb', instanced);
}

/// The torus in red, and with the variants "red" and "blue"; the same in blue.
{
  const color = async factor => {
    const document = await torusDocument();
    document.getRoot().listMaterials()[0].setBaseColorTexture(null).setBaseColorFactor(factor);
    return document;
  };
  const red = [.8, .05, .05, 1], blue = [.05, .1, .8, 1];
  const document = await color(red), extension = document.createExtension(KHRMaterialsVariants);
  const other = document.createMaterial('blue').setBaseColorFactor(blue).setMetallicFactor(0).setRoughnessFactor(.4);
  const primitive = document.getRoot().listMeshes()[0].listPrimitives()[0];
  const list = extension.createMappingList();
  const names = [['red', primitive.getMaterial()], ['blue', other]];
  for (const [name, material] of names) {
    list.addMapping(extension.createMapping().setMaterial(material).addVariant(extension.createVariant(name)));
  }
  primitive.setExtension('KHR_materials_variants', list);
  document.getRoot().listTextures().forEach(t => t.dispose());
  await write('torus-variants.glb', document);
  const plainBlue = await color(blue);
  plainBlue.getRoot().listTextures().forEach(t => t.dispose());
  await write('torus-blue.glb', plainBlue);
}

/// A bar of two joints with a morph target, turned and bent by an animation of a second.
const joints = [], bar = {position: [], normal: [], move: [], joint: [], weight: [], index: []};
for (let y = 0; y <= 4; ++y) {
  for (let k = 0; k < 4; ++k) {
    const a = Math.PI / 2 * k;
    bar.position.push(.3 * Math.cos(a), .5 * y, .3 * Math.sin(a));
    bar.normal.push(Math.cos(a), 0, Math.sin(a));
    bar.move.push(.1 * y * Math.cos(a), 0, .05 * y);
    bar.joint.push(0, 1, 0, 0);
    bar.weight.push(1 - y / 4, y / 4, 0, 0);
    if (y < 4) {
      const n = (k + 1) % 4, at = 4 * y;
      bar.index.push(at + k, at + 4 + k, at + n, at + n, at + 4 + k, at + 4 + n);
    }
  }
}
const poses = {
  rest: {turn: [0, 0, Math.sin(.2), Math.cos(.2)], weight: .25},
  end: {turn: [0, Math.sin(.3), Math.sin(.4), Math.sqrt(1 - Math.sin(.3) ** 2 - Math.sin(.4) ** 2)], weight: 1}};
{
  const document = new Document(), buffer = document.createBuffer();
  const list = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document.createPrimitive()
    .setAttribute('POSITION', list('VEC3', new Float32Array(bar.position)))
    .setAttribute('NORMAL', list('VEC3', new Float32Array(bar.normal)))
    .setAttribute('JOINTS_0', list('VEC4', new Uint8Array(bar.joint)))
    .setAttribute('WEIGHTS_0', list('VEC4', new Float32Array(bar.weight)))
    .setIndices(list('SCALAR', new Uint16Array(bar.index)))
    .addTarget(document.createPrimitiveTarget().setAttribute('POSITION', list('VEC3', new Float32Array(bar.move))));
  const mesh = document.createMesh('bar').addPrimitive(primitive).setWeights([poses.rest.weight]);
  const lower = document.createNode('lower').setTranslation([1, 0, 0]).setScale([2, 2, 2]);
  const upper = document.createNode('upper').setTranslation([0, 1, 0]).setRotation(poses.rest.turn);
  lower.addChild(upper);
  const inverse = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const skin = document.createSkin().addJoint(lower).addJoint(upper).setInverseBindMatrices(
    list('MAT4', new Float32Array([...inverse, ...inverse.slice(0, 13), -1, 0, 1])));
  const node = document.createNode('bar').setMesh(mesh).setSkin(skin).setTranslation([5, 5, 5]);
  document.createScene().addChild(lower).addChild(node);
  const times = list('SCALAR', new Float32Array([0, 1]));
  const animation = document.createAnimation('bend');
  const channel = (target, path, type, values) => {
    const sampler = document.createAnimationSampler().setInput(times).setOutput(list(type, new Float32Array(values)));
    animation.addSampler(sampler).addChannel(
      document.createAnimationChannel().setTargetNode(target).setTargetPath(path).setSampler(sampler));
  };
  channel(upper, 'rotation', 'VEC4', [...poses.rest.turn, ...poses.end.turn]);
  channel(node, 'weights', 'SCALAR', [poses.rest.weight, poses.end.weight]);
  await write('bar.glb', document);
}

/// What three.js makes of the bar, with the animation's values at a quarter of its second and at its end.
function verticesAt(turn, weight) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(bar.position, 3));
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(bar.joint, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(bar.weight, 4));
  geometry.morphAttributes.position = [new THREE.Float32BufferAttribute(bar.move, 3)];
  geometry.morphTargetsRelative = true;
  const lower = new THREE.Bone(), upper = new THREE.Bone();
  lower.position.set(1, 0, 0);
  lower.scale.set(2, 2, 2);
  upper.position.set(0, 1, 0);
  upper.quaternion.copy(turn);
  lower.add(upper);
  lower.updateMatrixWorld(true);
  const mesh = new THREE.SkinnedMesh(geometry);
  mesh.bind(new THREE.Skeleton([lower, upper], [new THREE.Matrix4(), new THREE.Matrix4().makeTranslation(0, -1, 0)]), new THREE.Matrix4());
  mesh.morphTargetInfluences = [weight];
  mesh.updateMatrixWorld(true);
  const vertices = [];
  for (let i = 0; i < geometry.attributes.position.count; ++i) {
    const v = mesh.getVertexPosition(i, new THREE.Vector3()).applyMatrix4(mesh.matrixWorld);
    vertices.push(v.toArray().map(x => Number(x.toFixed(6))));
  }
  return vertices;
}
const q = numbers => new THREE.Quaternion(...numbers), mix = (a, b, t) => a + t * (b - a);
const at = t => verticesAt(q(poses.rest.turn).slerp(q(poses.end.turn), t), mix(poses.rest.weight, poses.end.weight, t));
fs.writeFileSync(`${folder}/bar-vertices.json`, JSON.stringify({'0': at(0), '0.25': at(.25), '1': at(1)}) + '\n');
