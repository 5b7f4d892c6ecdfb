// What the tests of the engines drew, on one sheet: ours beside theirs, PSNR, renderer, and why the rest differs.
// usage: engines_sheet.mjs SHEET.png FOLDER ... NODE_MODULES    (folders that show_probes, show_godot3 and Blender wrote into)
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [sheet, ...folders] = process.argv.slice(2);
const { PNG } = createRequire(path.resolve(folders.pop(), 'x.js'))('pngjs');
const results = [];
for (const folder of folders.filter(existsSync)) {
  for (const name of readdirSync(folder, { recursive: true })) {
    if (!name.endsWith('.json')) continue;
    const file = path.join(folder, name), result = JSON.parse(readFileSync(file));
    if (result.engine && result.picture) results.push({ ...result, picture: path.resolve(path.dirname(file), result.picture) });
  }
}
if (!results.length) {
  console.log(`left out: ${folders.join(', ')}: no engine has drawn anything; run the tests outside_engines, outside_godot3 and outside_blender first`);
  process.exit(77);
}
results.sort((a, b) => (a.engine + a.view < b.engine + b.view ? -1 : 1));
const escape = (text) => String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;');
const one = (r) => `<figure><div class="pair">${[0, 1].map((n) =>
  `<div style="background: url('${pathToFileURL(r.picture)}') -${n * 320}px 0 / ${r.parts * 320}px 200px"></div>`).join('')}</div>
<figcaption><b>${escape(r.engine)}, ${escape(r.view)}: ${r.db.toFixed(1)} dB</b> over ${r.pixels} pixels${r.db < r.least ? ' <em>too little</em>' : ''}<br>
what is left: ${escape(r.left)}<br><small>${escape(r.renderer)}</small></figcaption></figure>`;
const rows = Math.ceil(results.length / 2), width = 1340, height = 96 + rows * 292;
const page = `<!doctype html><meta charset="utf-8"><style>
body { margin: 16px; width: ${width - 32}px; font: 13px/1.35 "DejaVu Sans", sans-serif; color: #222; background: #fff }
main { display: grid; grid-template-columns: 1fr 1fr; gap: 12px }
figure { margin: 0; height: 280px } .pair { display: flex; gap: 4px } .pair div { width: 320px; height: 200px }
h1 { font-size: 18px; margin: 0 0 4px } p { margin: 0 0 12px } small { color: #777 } em { color: #b00 }
</style><h1>Exported probes in engines</h1><p>Left boxprobe render, right the engine, from the same camera.</p><main>${results.map(one).join('\n')}</main>`;
const work = mkdtempSync(path.join(tmpdir(), 'boxprobe-sheet-'));
try {
  const html = path.join(work, 'sheet.html'), drawn = path.join(work, 'sheet.png');
  writeFileSync(html, page);
  const done = spawnSync('chromium', ['--headless=new', '--no-sandbox', '--no-first-run', '--disable-dev-shm-usage', '--disable-gpu', '--hide-scrollbars',
    `--user-data-dir=${path.join(work, 'profile')}`, `--window-size=${width},${height}`, `--screenshot=${drawn}`, pathToFileURL(html).href],
  { encoding: 'utf8', timeout: 120000 });
  const { data, ...size } = PNG.sync.read(readFileSync(drawn));
  if (done.status !== 0 || size.width !== width) throw new Error(done.stderr || `the sheet is ${size.width} pixels wide`);
  // Pictures that were not found leave white: each pair must show something.
  results.forEach((r, n) => {
    const x0 = 16 + (n % 2) * 660, y0 = 70 + Math.floor(n / 2) * 292;
    let dark = 0;
    for (let y = 20; y < 180; y += 4) for (let x = 0; x < 640; x += 4) dark += data[4 * ((y0 + y) * width + x0 + x) + 1] < 200;
    if (dark < 400) throw new Error(`${r.engine} ${r.view}: the sheet shows no picture there`);
  });
  copyFileSync(drawn, sheet + '.new');
  renameSync(sheet + '.new', sheet);
} catch (problem) {
  console.log(`engines_sheet.mjs: ${problem.message}`);
  process.exitCode = 1;
} finally {
  rmSync(work, { recursive: true, force: true, maxRetries: 5 });
}
if (!process.exitCode) console.log(`${sheet}: ${results.length} pairs of ${new Set(results.map((r) => r.engine)).size} engines`);
