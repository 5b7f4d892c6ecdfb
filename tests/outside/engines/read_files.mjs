// Exported files read by readers that this project did not write: ktx-parse, Babylon.js' DDS loader (parse-dds knows no half floats),
// three.js' EXR and HDR loaders; roughness of the levels by three.js' own function.
// usage: read_files.mjs BOXPROBE SCENES OUT NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import path from 'node:path';

const [program, scenes, out, modules] = process.argv.slice(2);
const module = (name) => import(path.resolve(modules, name));
const { read } = await module('ktx-parse/dist/index.mjs');
const { DDSTools } = await module('@babylonjs/core/Misc/dds.pure.js');
const { DataUtils, PMREMGenerator } = await module('three/build/three.module.js');
const scene = path.join(scenes, 'six-faces.boxprobe.json');
mkdirSync(out, { recursive: true });
const exported = (...options) => {
  execFileSync(program, ['export', scene, '-o', out, '--quiet', ...options], { stdio: 'inherit' });
  return JSON.parse(readFileSync(path.join(out, 'cube.json')));
};
const bytes = (name) => readFileSync(path.join(out, name));
const halves = (data, start, count) => new Uint16Array(data.buffer.slice(data.byteOffset + start, data.byteOffset + start + 2 * count));

for (const ladder of ['own', 'three', 'bevy', 'babylon', 'unity']) {
  const json = exported('--format', 'ktx2', '--ladder', ladder, '--size', '64');
  const ktx = read(new Uint8Array(bytes('cube.ktx2')));
  assert.equal(ktx.vkFormat, 97);
  assert.equal(ktx.faceCount, 6);
  assert.equal(ktx.levels.length, json.ladder.levels.length);
  assert.equal(ktx.dataFormatDescriptor[0].samples.length, 4);
  exported('--format', 'dds', '--ladder', ladder, '--size', '64');
  const file = bytes('cube.dds');
  const data = new Uint8Array(file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
  const info = DDSTools.GetDDSInfo(data);
  assert.deepEqual([info.width, info.height, info.isCube, info.mipmapCount], [64, 64, true, ktx.levels.length]);
  let values = 0, uploads = 0;
  const engine = {  // what the loader asks of a graphics card
    getCaps: () => ({ textureHalfFloat: true, textureHalfFloatLinearFiltering: true }),
    _getRGBABufferInternalSizedFormat: () => 0,
    _uploadDataToTextureDirectly: (texture, array, face, level) => {
      const count = json.ladder.levels[level].size ** 2 * 4;
      assert.deepEqual(array, halves(ktx.levels[level].levelData, face * count * 2, count), `${ladder} face ${face} level ${level}`);
      values += count;
      uploads++;
    },
  };
  DDSTools.UploadDDSLevels(engine, {}, data, info, true, 6);
  assert.equal(uploads, 6 * ktx.levels.length);
  const last = json.ladder.levels.length - 1;
  for (const { level, roughness } of json.ladder.levels) {
    const engines = { three: () => PMREMGenerator.lodToRoughness(level, last), bevy: () => level / last };
    if (engines[ladder]) assert.ok(Math.abs(roughness - engines[ladder]()) < 1e-6, `${ladder} level ${level}`);
  }
  console.log(`${ladder}: ${ktx.levels.length} levels, ${values} values equal in KTX2 (ktx-parse) and DDS (Babylon.js)`);
}

// The pictures against the cube of --ladder own, whose axes are OpenGL's.
exported('--format', 'ktx2', '--ladder', 'own', '--size', '64');
const level0 = read(new Uint8Array(bytes('cube.ktx2'))).levels[0].levelData;
function cubeValue([x, y, z]) {
  const [ax, ay, az] = [x, y, z].map(Math.abs);
  const [face, s, t, m] = ax >= ay && ax >= az ? (x > 0 ? [0, -z, -y, ax] : [1, z, -y, ax]) : ay >= az ? (y > 0 ? [2, x, z, ay] : [3, x, -z, ay])
    : z > 0 ? [4, x, -y, az] : [5, -x, -y, az];
  const texel = (v) => Math.min(63, Math.floor((v / m * 0.5 + 0.5) * 64));
  return [...halves(level0, 8 * ((face * 64 + texel(t)) * 64 + texel(s)), 3)].map(DataUtils.fromHalfFloat);
}
for (const [format, loader] of [['exr', 'EXRLoader'], ['hdr', 'HDRLoader']]) {
  const json = exported('--format', format, '--ladder', 'three', '--size', '64');
  if (format === 'exr') assert.match(execFileSync('exrheader', [path.join(out, 'cube.exr')]).toString(), /dataWindow \(type box2i\): \(0 0\) - \(255 127\)/);
  const { [loader]: Loader } = await module(`three/examples/jsm/loaders/${loader}.js`);
  const file = bytes('cube.' + format);
  const picture = new Loader().parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
  assert.deepEqual([picture.width, picture.height], [256, 128]);
  assert.equal(json.latLong.center, '+X');
  let near = 0, count = 0;
  for (let row = 4; row < 128; row += 5) {
    for (let column = 2; column < 256; column += 5) {
      const turn = 2 * Math.PI * ((column + 0.5) / 256 - 0.5), up = Math.PI * (0.5 - (row + 0.5) / 128);
      const seen = cubeValue([Math.cos(up) * Math.cos(turn), Math.sin(up), Math.cos(up) * Math.sin(turn)]);
      const fromTop = format === 'exr' ? 127 - row : row;  // three.js turns EXR's rows round for its textures
      const value = [0, 1, 2].map((c) => picture.data[4 * (fromTop * 256 + column) + c]).map((v) => picture.data instanceof Uint16Array ? DataUtils.fromHalfFloat(v) : v);
      near += value.every((v, c) => Math.abs(v - seen[c]) <= 0.02 * seen[c] + 0.02) ? 1 : 0;
      count++;
    }
  }
  console.log(`${format}: ${near} of ${count} directions as in the cube (${loader} of three.js)`);
  assert.ok(near >= 0.9 * count, `${format}: the picture is another than the cube`);  // the rest lies on edges between colours
}
