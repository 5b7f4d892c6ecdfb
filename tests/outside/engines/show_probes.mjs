// Exported probes and techniques in engines, beside `boxprobe render`: writes each pair of pictures as a sheet (ours, theirs, the
// pixels that reflect) and prints the PSNR over those pixels; VIEW.json beside it is for engines_sheet.mjs.
// usage: show_probes.mjs BOXPROBE SCENES OUT [ENGINE ...] NODE_MODULES
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { drawnByPage } from './browser.mjs';

const [program, scenes, out, ...rest] = process.argv.slice(2);
const modules = rest.pop(), only = rest;
const { PNG } = createRequire(path.resolve(modules, 'x.js'))('pngjs');
const width = 480, height = 300;
const run = (name, ...args) => execFileSync(name, args, { stdio: ['ignore', 'pipe', 'inherit'] });
const boxprobe = (...args) => run(program, ...args, '--quiet');

// The mirror ball of the six-coloured room, and the box-projected floor and balls of another. White metal, so that a picture shows what
// was looked up; no lamp, because engines spread its light over rough surfaces each by its own rule.
const ball = { name: 'ball', scene: 'six-faces', camera: 'main', nodes: ['ball'], materials: ['ball'], probe: 'cube', set: [] };
const floor = {
  name: 'floor', scene: 'room', camera: 'A', nodes: ['floor', 'sphere 1', 'sphere 2', 'sphere 3'], materials: ['floor', 'sphere'], probe: 'room',
  set: ['--set', 'materials.lamp.emissive=[0.5,0.5,0.5]'],
};
const rough = { ...floor, name: 'rough-floor', nodes: ['floor'], materials: ['floor'], roughness: 0.4 };

// `mirror`: the least roughness that the engine draws. Of each view the dB that it must reach. `left`: why the rest differs.
const engines = [
  { name: 'three', page: 'three.js', export: ['--format', 'ktx2', '--ladder', 'three'], mirror: 0.0525, left: 'roughness at least 0.0525, mixed with the normal; levels between other levels', views: [[ball, 33], [floor, 33], [rough, 28]] },
  { name: 'babylon', page: 'babylon.js', export: ['--format', 'dds', '--ladder', 'babylon', '--center'], mirror: 0, left: 'the box is about the probe (--center); irradiance mixed in by alpha', views: [[ball, 30], [floor, 30], [rough, 25]] },
  { name: 'playcanvas', page: 'playcanvas.js', export: ['--format', 'ktx2', '--ladder', 'three', '--center'], mirror: 0, left: 'a filter and an atlas of its own', views: [[ball, 25], [floor, 25], [rough, 20]] },
  { name: 'technique-glsl', page: 'technique.js', export: ['--format', 'ktx2', '--ladder', 'own'], shader: 'glsl', mirror: 0, left: 'rounding', views: [[ball, 50], [floor, 50], [rough, 50]] },
  { name: 'technique-hlsl', page: 'technique.js', export: ['--format', 'ktx2', '--ladder', 'own'], shader: 'hlsl', mirror: 0, left: 'rounding', views: [[rough, 50]] },
];

// An exported technique as the fragment shader of a page; HLSL by way of glslang and spirv-cross.
function fragmentShader(language, text, view, roughness, folder) {
  const stem = view.probe.replaceAll('-', '_');
  if (language === 'glsl') {
    return `precision highp float;\nprecision highp int;\nprecision highp samplerCube;\n${text}\nuniform samplerCube probeMap;\nin vec3 p, n, v;\nout vec4 color;\n` +
      `void main() { color = boxprobeReflection(probeMap, boxprobe_${stem}(), p, normalize(n), normalize(v), ${roughness.toFixed(6)}); }\n`;
  }
  const source = path.join(folder, 'technique.hlsl'), binary = path.join(folder, 'technique.spv');
  writeFileSync(source, `${text}\nTextureCube probeMap;\nfloat4 main(float3 p : P, float3 n : N, float3 v : V) : SV_Target\n{\n` +
    `  return boxprobeReflection(probeMap, boxprobe_${stem}(), p, normalize(n), normalize(v), ${roughness.toFixed(6)}f);\n}\n`);
  run('glslangValidator', '-D', '-V', '-e', 'main', '-S', 'frag', source, '-o', binary);
  const es = run('spirv-cross', binary, '--es', '--version', '300').toString();
  return es.replace('#version 300 es\n', '').replaceAll(/SPIRV_Cross_Combined\w+/g, 'probeMap');
}

function psnr(ours, theirs, mask) {
  let sum = 0, count = 0;
  for (let i = 0; i < mask.length; i += 4) {
    if (mask[i] < 128) continue;
    for (let c = 0; c < 3; c++) sum += (ours[i + c] - theirs[i + c]) ** 2;
    count += 3;
  }
  return { db: count ? 10 * Math.log10(255 * 255 / Math.max(sum / count, 1e-9)) : 0, pixels: count / 3 };
}

function sheet(pictures) {
  const all = new PNG({ width: width * pictures.length, height });
  pictures.forEach((picture, n) => {
    for (let y = 0; y < height; y++) picture.copy(all.data, 4 * (y * all.width + n * width), 4 * y * width, 4 * (y + 1) * width);
  });
  return PNG.sync.write(all);
}

async function show(engine, view, least) {
  const folder = path.join(out, engine.name);
  mkdirSync(folder, { recursive: true });
  const scene = path.join(scenes, view.scene + '.boxprobe.json');
  const roughness = view.roughness ?? engine.mirror;
  const technique = engine.shader && view.roughness ? 'box+footprint4' : 'box';
  boxprobe('export', scene, '-o', folder, ...engine.export, ...view.set);
  const files = { export: path.resolve(folder), 'model.glb': path.resolve(scenes, view.scene + '.glb') };
  if (engine.shader) {
    const text = path.join(folder, 'technique.' + engine.shader);
    boxprobe('export', scene, '-o', text, '--shader', engine.shader, '--technique', technique);
    files['fragment.glsl'] = path.resolve(folder, 'fragment.glsl');
    writeFileSync(files['fragment.glsl'], fragmentShader(engine.shader, readFileSync(text).toString(), view, roughness, folder));
  }
  const png = path.join(folder, view.name + '-boxprobe.png');
  boxprobe('render', scene, '-o', png, '--size', `${width}x${height}`, '--camera', view.camera, '--samples', '1', '--technique', technique, '--set',
    'energy="multiple"', ...view.set, ...view.materials.flatMap((name) => ['--set', `materials.${name}.roughness=${roughness}`]));
  const camera = JSON.parse(readFileSync(scene)).cameras[view.camera];
  const build = engine.shader ? 'three.module.js' : 'three.webgpu.js';
  const drawn = await drawnByPage(engine.page, { ...view, width, height, camera, roughness, build }, files, path.resolve(modules));
  const ours = PNG.sync.read(readFileSync(png)).data;
  const { db, pixels } = psnr(ours, drawn.picture, drawn.mask);
  writeFileSync(path.join(folder, view.name + '.png'), sheet([ours, drawn.picture, drawn.mask]));
  writeFileSync(path.join(folder, view.name + '.json'), JSON.stringify({ engine: engine.name, view: view.name, db, pixels, least, left: engine.left,
    renderer: drawn.renderer, picture: view.name + '.png', parts: 3 }));
  const good = pixels > 1000 && db >= least;
  console.log(`${engine.name} ${view.name}: ${db.toFixed(1)} dB over ${pixels} pixels (at least ${least}), drawn by ${drawn.renderer}${good ? '' : ': FAILED'}`);
  return good;
}

let good = true;
for (const engine of engines) {
  if (only.length && !only.includes(engine.name)) continue;
  for (const [view, least] of engine.views) good = await show(engine, view, least) && good;
}
process.exit(good ? 0 : 1);
