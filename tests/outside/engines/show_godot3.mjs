// The exported Godot shader, in the words of Godot 3 (Debian has no Godot 4), beside `boxprobe render`.
// usage: show_godot3.mjs BOXPROBE SCENES OUT NODE_MODULES
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [program, scenes, out, modules] = process.argv.slice(2);
const { PNG } = createRequire(path.resolve(modules, 'x.js'))('pngjs');
const here = path.dirname(new URL(import.meta.url).pathname);
const width = 480, height = 300, components = { SCALAR: 1, VEC3: 3 }, arrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

function meshes(file, names) {
  const data = readFileSync(file), json = JSON.parse(data.subarray(20, 20 + data.readUInt32LE(12)));
  const binary = data.subarray(28 + data.readUInt32LE(12));
  const read = (index) => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView], Type = arrays[accessor.componentType];
    const start = (view.byteOffset || 0) + (accessor.byteOffset || 0), bytes = accessor.count * components[accessor.type] * Type.BYTES_PER_ELEMENT;
    return [...new Type(binary.buffer.slice(binary.byteOffset + start, binary.byteOffset + start + bytes))];
  };
  return json.nodes.filter((node) => names.includes(node.name)).map((node) => {
    const [{ attributes, indices }] = json.meshes[node.mesh].primitives;
    const triangles = read(indices);  // Godot's front is the other way round
    for (let i = 0; i < triangles.length; i += 3) [triangles[i], triangles[i + 1]] = [triangles[i + 1], triangles[i]];
    return { positions: read(attributes.POSITION), normals: read(attributes.NORMAL), indices: triangles };
  });
}

let good = true;
for (const [name, scene, camera, node, probe, least] of [['ball', 'six-faces', 'main', 'ball', 'cube', 30], ['floor', 'room', 'A', 'floor', 'room', 30]]) {
  const folder = path.join(out, name);
  mkdirSync(folder, { recursive: true });
  const sceneFile = path.join(scenes, scene + '.boxprobe.json');
  const boxprobe = (...args) => execFileSync(program, [...args, '--quiet'], { stdio: 'inherit' });
  boxprobe('export', sceneFile, '-o', folder, '--format', 'exr', '--ladder', 'own');
  boxprobe('render', sceneFile, '-o', path.join(folder, 'boxprobe.png'), '--size', `${width}x${height}`, '--camera', camera, '--samples', '1', '--technique',
    'box', '--set', 'energy="multiple"', '--set', `materials.${node}.roughness=0`);
  for (const file of ['project.godot', 'draw.tscn', 'draw.gd']) copyFileSync(path.join(here, '../godot3', file), path.join(folder, file));
  const words = { MODEL_MATRIX: 'WORLD_MATRIX', INV_VIEW_MATRIX: 'CAMERA_MATRIX', TAU: '6.28318530718', PI: '3.14159265359', ': filter_linear_mipmap, repeat_enable': '',
    source_color: 'hint_color' };
  let shader = readFileSync(path.join(folder, 'boxprobe.gdshader'), 'utf8').replace('render_mode ', 'render_mode cull_disabled, ');
  for (const [from, to] of Object.entries(words)) shader = shader.replaceAll(/^\w+$/.test(from) ? new RegExp(`\\b${from}\\b`, 'g') : from, to);
  writeFileSync(path.join(folder, 'boxprobe3.shader'), shader);
  const config = { probe, camera: JSON.parse(readFileSync(sceneFile)).cameras[camera], meshes: meshes(path.join(scenes, scene + '.glb'), [node]) };
  writeFileSync(path.join(folder, 'config.json'), JSON.stringify(config));
  const said = execFileSync('godot3', ['--path', folder, '--audio-driver', 'Dummy'], { timeout: 120000 }).toString();
  const ours = PNG.sync.read(readFileSync(path.join(folder, 'boxprobe.png'))).data, theirs = PNG.sync.read(readFileSync(path.join(folder, 'picture.png'))).data;
  const sheet = new PNG({ width: 2 * width, height });
  let sum = 0, count = 0;
  for (let i = 0; i < theirs.length; i += 4) {
    const shown = [0, 1, 2].map((c) => theirs[i + c]);
    const x = i / 4 % width, y = Math.floor(i / 4 / width);
    for (let c = 0; c < 4; c++) {
      sheet.data[4 * (y * 2 * width + x) + c] = ours[i + c];
      sheet.data[4 * (y * 2 * width + width + x) + c] = c === 3 ? 255 : shown[c];
    }
    // The spheres that stand before the floor are not drawn there: their pixels are black or far off in ours alone.
    if (shown[0] + shown[1] + shown[2] < 3 || (name === 'floor' && y < 0.62 * height)) continue;
    for (let c = 0; c < 3; c++) sum += (ours[i + c] - shown[c]) ** 2;
    count += 3;
  }
  writeFileSync(path.join(folder, 'sheet.png'), PNG.sync.write(sheet));
  const db = 10 * Math.log10(255 * 255 / Math.max(sum / count, 1e-9));
  writeFileSync(path.join(folder, 'sheet.json'), JSON.stringify({ engine: 'godot3', view: name, db, pixels: count / 3, least,
    left: 'a latitude-longitude picture in place of a cube', renderer: said.match(/drawn by (.*)/)[1], picture: 'sheet.png', parts: 2 }));
  good = good && count > 9000 && db >= least;
  console.log(`godot3 ${name}: ${db.toFixed(1)} dB over ${count / 3} pixels (at least ${least}), ${said.match(/drawn by .*/)}`);
}
process.exit(good ? 0 : 1);
