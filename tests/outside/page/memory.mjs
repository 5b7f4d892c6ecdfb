// Memory of the page of lessons while its figures are dragged, in Chromium: JavaScript's heap after a collection, nodes, listeners, canvases'
// contexts and the browser's processes. usage: memory.mjs PAGE.html [MINUTES, 10]
// Fails if the heap or the count of nodes of the last third is more than a tenth above that of the third before.
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { BrowserPage, check } from './browser_page.mjs';

const [file, minutes = '10'] = process.argv.slice(2);
const page = await BrowserPage.open('file://' + path.resolve(file), { width: 1280, height: 900 });
await page.evaluate(`document.querySelectorAll('.waiting button').forEach((button) => button.click())`);
await page.send('Performance.enable');
await page.send('HeapProfiler.enable');
let seed = 11;
const random = () => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 2147483648; };
/** Resident memory of the browser and its children, MB. */
function resident() {
  const rows = execFileSync('ps', ['-eo', 'pid=,ppid=,rss=']).toString().trim().split('\n').map((line) => line.trim().split(/\s+/).map(Number));
  const family = new Set([page.process.pid]);
  for (let grown = true; grown;) {
    grown = false;
    for (const [pid, parent] of rows) if (family.has(parent) && !family.has(pid)) { family.add(pid); grown = true; }
  }
  return rows.filter(([pid]) => family.has(pid)).reduce((sum, row) => sum + row[2], 0) / 1024;
}
async function measure() {
  await page.send('HeapProfiler.collectGarbage');
  const metrics = Object.fromEntries((await page.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]));
  return { heap: metrics.JSHeapUsedSize / 1e6, nodes: metrics.Nodes, listeners: metrics.JSEventListeners, resident: resident() };
}
const count = await page.evaluate(`document.querySelectorAll('.figure-live, .plan.live').length`);
// Figures start when they are seen: that is no growth.
for (let n = 0; n < count; n++) {
  await page.evaluate(`document.querySelectorAll('.figure-live, .plan.live')[${n}].scrollIntoView({ block: 'center', behavior: 'instant' })`);
  await page.until(`(() => { const host = document.querySelectorAll('.figure-live, .plan.live')[${n}]; return host.matches('.plan') || !host.querySelector('.figure-still'); })()`);
}
const began = Date.now(), end = began + 60000 * Number(minutes), all = [];
let drags = 0, next = 0;
for (let n = 0; Date.now() < end; n++) {
  // Each figure in turn: all of its handles, its sliders and, where it is a room, the pointer over it.
  await page.evaluate(`document.querySelectorAll('.figure-live, .plan.live')[${n % count}].scrollIntoView({ block: 'center', behavior: 'instant' })`);
  await page.evaluate('new Promise((resolve) => setTimeout(resolve, 150))');
  const places = await page.evaluate(`(() => { const host = document.querySelectorAll('.figure-live, .plan.live')[${n % count}];
    return [...host.querySelectorAll('.handle, .figure-picture canvas, input[type=range]')].map((e) => e.querySelector?.('circle:not(.grip), rect') || e).map((e) => { const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; }).filter(([, y]) => y > 5 && y < 895); })()`);
  for (const [x, y] of places) {
    await page.mouse('mousePressed', x, y);
    for (let i = 0; i < 6; i++) await page.mouse('mouseMoved', x + 120 * (random() - 0.5), y + 80 * (random() - 0.5));
    await page.mouse('mouseReleased', x, y);
    drags++;
  }
  if (Date.now() - began > 60000 * next * Number(minutes) / 20) {
    next++;
    all.push(await measure());
    const { heap, nodes, listeners, resident: mb } = all[all.length - 1];
    console.log(`  ${((Date.now() - began) / 60000).toFixed(1)} min, ${drags} drags: heap ${heap.toFixed(1)} MB, ${nodes} nodes, ${listeners} listeners, ${mb.toFixed(0)} MB resident`);
  }
}
const third = Math.floor(all.length / 3), median = (list, key) => list.map((one) => one[key]).sort((a, b) => a - b)[Math.floor(list.length / 2)];
const [before, last] = [all.slice(third, 2 * third), all.slice(2 * third)];
for (const key of ['heap', 'nodes', 'listeners']) check(median(last, key) <= 1.1 * median(before, key), `${key}: ${median(before, key).toFixed(1)}, then ${median(last, key).toFixed(1)}`);
check(page.failures().length === 0, `no script failed ${page.failures().join(' ')}`);
await page.close();
