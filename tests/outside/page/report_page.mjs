// The file of `boxprobe report` in a browser: whole by itself, its slider by mouse, finger and keys, on a telephone, on paper, in the dark.
// usage: report_page.mjs BOXPROBE SCENES OUT
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { BrowserPage, check } from './browser_page.mjs';

const [program, scenes, out] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const file = path.resolve(out, 'report.html');
execFileSync(program, ['report', path.join(scenes, 'room.boxprobe.json'), path.join(scenes, 'building.boxprobe.json'), '--size', '160x90', '--rays', '8', '-o', file, '--quiet'], { stdio: 'inherit' });
const html = readFileSync(file, 'utf8');
check(!/(?:src|href)="(?!data:|#)/.test(html) && !/https?:\/\//.test(html.replace(/base64,[^"]*/g, '')), 'the file names no address outside it');

const at = 'parseFloat(document.querySelector(".pair").style.getPropertyValue("--at"))';
const address = pathToFileURL(file).href;
for (const [width, mobile] of [[1280, false], [360, true]]) {
  const page = await BrowserPage.open(address, { width, height: 800, mobile });
  check(await page.evaluate('document.documentElement.scrollWidth <= innerWidth'), `${width} pixels: nothing is wider than the page`);
  check(await page.evaluate('[...document.images].every((i) => i.complete && i.naturalWidth === 160)'), `${width} pixels: every picture is there`);
  const [x, y] = await page.middle('.pair'), third = await page.evaluate('document.querySelector(".pair").clientWidth / 4');
  if (mobile) {
    await page.touch([x, y], [x - third, y]);
  } else {
    await page.drag([x, y], [x - third, y]);
  }
  check(Math.abs((await page.evaluate(at)) - 25) < 3, `${width} pixels: ${mobile ? 'a finger' : 'the mouse'} moves the edge: ${await page.evaluate(at)} %`);
  const before = await page.evaluate(at);
  await page.evaluate('document.querySelector(".slider").focus()');
  for (let i = 0; i < 4; ++i) await page.key('ArrowRight');
  check(Math.abs((await page.evaluate(at)) - before - 2) < 0.01, `${width} pixels: four keys move it by two percent`);
  check(await page.evaluate('[...document.querySelectorAll(".slider")].every((s) => s.getAttribute("aria-label").length > 20) && new Set([...document.querySelectorAll(".slider")].map((s) => s.getAttribute("aria-label"))).size === document.querySelectorAll(".slider").length'), 'every slider has a name of its own');
  check(await page.evaluate('document.querySelectorAll("main").length === 1 && document.querySelector("main").contains(document.querySelector("h1"))'), 'what is to be read is the main part');
  await page.screenshot(path.join(out, `report-${width}.png`));
  await page.middle('.probes');
  await page.screenshot(path.join(out, `report-${width}-probes.png`));
  if (!mobile) {
    await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: 'dark' }] });
    await page.evaluate('scrollTo(0, 0)');
    await page.screenshot(path.join(out, 'report-dark.png'));
    check(await page.evaluate('getComputedStyle(document.body).backgroundColor') === 'rgb(20, 23, 27)', 'dark where the reader is');
    await page.send('Emulation.setEmulatedMedia', { media: 'print', features: [] });
    check(await page.evaluate('(() => { const p = document.querySelector(".pair").children; const a = p[0].getBoundingClientRect(), b = p[1].getBoundingClientRect(); return a.right <= b.left && getComputedStyle(document.querySelector(".slider")).display === "none"; })()'), 'on paper both pictures stand side by side');
    await page.pdf(path.join(out, 'report.pdf'));
  }
  check(page.messages.length === 0, `no error in the page${page.messages.length ? ': ' + page.messages[0] : ''}`);
  await page.close();
}
const plain = await BrowserPage.open(address, { width: 1280, scripts: false });
await plain.screenshot(path.join(out, 'report-plain.png'));
await plain.close();
