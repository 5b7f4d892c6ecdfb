// One .glb with its probes in three.js by data/glb/boxprobe_glb_three.js, beside `boxprobe render` by the same camera, and before
// Khronos' validator. Prints the PSNR over the surfaces named, and over all of the picture.
// usage: show_glb.mjs BOXPROBE SCENES LIT LOADER OUT [VIEW] NODE_MODULES    LIT: folder of scenes with lamps; LOADER: folder of the loader
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { drawnByPage } from './browser.mjs';

const [program, scenes, lit, loader, out, ...rest] = process.argv.slice(2);
const modules = rest.pop(), only = rest;
const require = createRequire(path.resolve(modules, 'x.js'));
const { PNG } = require('pngjs'), validator = require('gltf-validator');
const width = 320, height = 200;
const boxprobe = (...args) => execFileSync(program, [...args, '--quiet'], { stdio: ['ignore', 'pipe', 'inherit'] });

// A second probe of the same importance, which shares the floor with the first one.
const second = {
  name: 'second', origin: [2, 1.2, 1.5], box: { min: [-1, -0.005, -4.505], max: [4.505, 5.005, 4.505] }, rotationDegrees: [0, 12, 0],
  influence: { min: [-2, -0.5, -4], max: [4, 4, 4] }, blendDistance: 2, faceSize: 128,
};

// `least`: dB over the surfaces `nodes`. `light`: how far their mean light may be from ours.
const views = [
  { name: 'floor', scene: path.join(scenes, 'room'), camera: 'A', nodes: ['floor'], least: 50, light: 0.02 },
  { name: 'two-probes', scene: path.join(scenes, 'building'), camera: 'main', nodes: ['mirror'], least: 35, light: 0.02, probes: [second] },
  // The same room under its sky and sun.
  { name: 'sun', scene: path.join(scenes, 'building'), camera: 'main', nodes: ['mirror'], least: 35, light: 0.02, all: 30 },
  // Two models, one of them no glTF, placed by the scene: one file all the same.
  { name: 'joined', scene: path.join(scenes, 'room'), camera: 'A', nodes: ['floor', 'crate'], least: 35, light: 0.02, crate: true },
  { name: 'lamp', scene: path.join(lit, 'closed'), camera: 'corner', nodes: ['floor', 'wall north', 'wall east'], least: 35, light: 0.05 },
  // three's own materials, with a grid of light probes and area lights in place of the loader.
  { name: 'grid', scene: path.join(lit, 'closed'), camera: 'corner', nodes: ['floor', 'wall north', 'wall east'], least: 33, light: 0.05, grid: true },
];

function compared(ours, theirs, mask) {
  let sum = 0, count = 0;
  const light = [0, 0], linear = (v) => (v <= 10.31475 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);
  for (let i = 0; i < ours.length; i += 4) {
    if (mask && mask[i] < 128) continue;
    for (let c = 0; c < 3; c++) {
      sum += (ours[i + c] - theirs[i + c]) ** 2;
      light[0] += linear(ours[i + c]);
      light[1] += linear(theirs[i + c]);
    }
    count += 3;
  }
  return { db: count ? 10 * Math.log10(255 * 255 / Math.max(sum / count, 1e-9)) : 0, pixels: count / 3, light: light[1] / Math.max(light[0], 1e-9) };
}

let good = true;
for (const view of views) {
  if (only.length && !only.includes(view.name)) continue;
  mkdirSync(out, { recursive: true });
  const json = JSON.parse(readFileSync(view.scene + '.boxprobe.json'));
  json.model = path.resolve(path.dirname(view.scene), json.model);
  for (const probe of json.probes) probe.faceSize = 128;
  json.probes.push(...(view.probes || []));
  if (view.crate) {
    writeFileSync(path.join(out, 'crate.mtl'), 'newmtl paint\nKd 0.7 0.3 0.1\nPr 0.6\nPm 0\n');
    writeFileSync(path.join(out, 'crate.obj'), 'mtllib crate.mtl\no crate\nusemtl paint\nv 0 0 0\nv 40 0 0\nv 40 0 70\nv 0 0 70\nv 0 90 0\nv 40 90 0\nv 40 90 70\nv 0 90 70\n' +
      'f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n');
    json.models = [{ file: json.model }, { file: 'crate.obj', unit: 'cm', translation: [0.6, 0.01, -0.4], rotationDegrees: [0, 20, 0] }];
    delete json.model;
  }
  const scene = path.join(out, view.name + '.boxprobe.json');
  writeFileSync(scene, JSON.stringify(json));
  const file = path.join(out, view.name + '.glb'), png = path.join(out, view.name + '-boxprobe.png');
  boxprobe('export', scene, '-o', file, '--format', 'glb');
  boxprobe('render', file, '-o', png, '--size', `${width}x${height}`, '--camera', view.camera, '--samples', '1', '--tone', 'none', '--set', 'exposure=1');
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 100 });
  const errors = issues.messages.filter(({ severity }) => severity === 0);
  for (const { code, message, pointer } of errors) console.log(`  ${code} ${pointer}: ${message}`);
  const config = { width, height, nodes: view.nodes, view: view.camera, file: view.name + '.glb', grid: view.grid, build: 'three.module.js' };
  const drawn = await drawnByPage('glb_three.js', config, { scene: path.resolve(out), loader: path.resolve(loader) }, path.resolve(modules));
  const ours = PNG.sync.read(readFileSync(png)).data;
  const on = compared(ours, drawn.picture, drawn.mask), all = compared(ours, drawn.picture);
  const sheet = new PNG({ width: 3 * width, height });
  [ours, drawn.picture, drawn.mask].forEach((picture, n) => {
    for (let y = 0; y < height; y++) picture.copy(sheet.data, 4 * (y * sheet.width + n * width), 4 * y * width, 4 * (y + 1) * width);
  });
  writeFileSync(path.join(out, view.name + '.png'), PNG.sync.write(sheet));
  const right = all.db >= (view.all || 0) && on.pixels > 1000 && on.db >= view.least && Math.abs(on.light - 1) <= view.light && !errors.length && !issues.numWarnings;
  console.log(`${view.name}: ${on.db.toFixed(1)} dB over ${on.pixels} pixels (at least ${view.least}), ${on.light.toFixed(3)} of their light; ` +
    `${all.db.toFixed(1)} dB over all, ${all.light.toFixed(3)}; validator: ${errors.length} errors, ${issues.numWarnings} warnings; drawn by ${drawn.renderer}${right ? '' : ': FAILED'}`);
  good = good && right;
}
process.exit(good ? 0 : 1);
