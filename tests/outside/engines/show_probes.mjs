// Exported probes in engines, beside `boxprobe render`: writes pictures and a sheet, prints PSNR over the pixels that reflect.
// usage: show_probes.mjs BOXPROBE SCENES OUT NODE_MODULES [ENGINE ...]
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { drawnByPage } from './browser.mjs';

const [program, scenes, out, modules, ...only] = process.argv.slice(2);
const { PNG } = createRequire(path.resolve(modules, 'x.js'))('pngjs');
const width = 480, height = 300;
const boxprobe = (...args) => execFileSync(program, [...args, '--quiet'], { stdio: ['ignore', 'pipe', 'inherit'] });

// The mirror ball of the six-coloured room, and a box-projected floor.
const views = [
  { name: 'ball', scene: 'six-faces', camera: 'main', nodes: ['ball'], material: 'ball', probe: 'cube' },
  { name: 'floor', scene: 'room', camera: 'A', nodes: ['floor'], material: 'floor', probe: 'room' },
  { name: 'rough-floor', scene: 'room', camera: 'A', nodes: ['floor'], material: 'floor', probe: 'room', roughness: 0.4 },
];
// What each needs, its least roughness, and the least PSNR (dB) of each view.
const engines = [
  { name: 'three', page: 'three.js', export: ['--format', 'ktx2', '--ladder', 'three'], mirror: 0.0525, least: { ball: 25, floor: 25, 'rough-floor': 25 } },
];

function psnr(ours, theirs, mask) {
  let sum = 0, count = 0;
  for (let i = 0; i < mask.length; i += 4) {
    if (mask[i] < 128) continue;
    for (let c = 0; c < 3; c++) sum += (ours[i + c] - theirs[i + c]) ** 2;
    count += 3;
  }
  return { db: count ? 10 * Math.log10(255 * 255 / Math.max(sum / count, 1e-9)) : 0, pixels: count / 3 };
}

function side(pictures) {
  const sheet = new PNG({ width: width * pictures.length, height });
  pictures.forEach((picture, n) => {
    for (let y = 0; y < height; y++) picture.copy(sheet.data, 4 * (y * sheet.width + n * width), 4 * y * width, 4 * (y + 1) * width);
  });
  return PNG.sync.write(sheet);
}

let failed = false;
for (const engine of engines) {
  if (only.length && !only.includes(engine.name)) continue;
  for (const view of views) {
    const folder = path.join(out, engine.name);
    mkdirSync(folder, { recursive: true });
    const scene = path.join(scenes, view.scene + '.boxprobe.json');
    const roughness = view.roughness ?? engine.mirror;
    boxprobe('export', scene, '-o', folder, ...engine.export);
    const png = path.join(folder, view.name + '-boxprobe.png');
    boxprobe('render', scene, '-o', png, '--size', `${width}x${height}`, '--camera', view.camera, '--samples', '1',
      '--set', 'energy="multiple"', '--set', `materials.${view.material}.roughness=${roughness}`, '--technique', 'box');
    const camera = JSON.parse(readFileSync(scene)).cameras[view.camera];
    const drawn = await drawnByPage(engine.page, { ...view, width, height, camera, roughness },
      { export: path.resolve(folder), 'model.glb': path.resolve(scenes, view.scene + '.glb') }, path.resolve(modules));
    const ours = PNG.sync.read(readFileSync(png)).data;
    const { db, pixels } = psnr(ours, drawn.picture, drawn.mask);
    writeFileSync(path.join(folder, view.name + '.png'), side([ours, drawn.picture, drawn.mask]));
    const good = pixels > 1000 && db >= engine.least[view.name];
    failed ||= !good;
    console.log(`${engine.name} ${view.name}: ${db.toFixed(1)} dB over ${pixels} pixels, drawn by ${drawn.renderer}${good ? '' : ', too few'}`);
  }
}
process.exit(failed ? 1 : 0);
