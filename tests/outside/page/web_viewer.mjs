// The folder of `export --format web` on a static server: its pixels against `boxprobe render`, its handles by real pointer events.
// usage: web_viewer.mjs BOXPROBE SCENES OUT
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check, roomPsnr, serve } from './browser_page.mjs';
import { checkLimits } from './viewer_limits.mjs';

const [program, scenes, out] = process.argv.slice(2);
const width = 480, height = 300;
mkdirSync(out, { recursive: true });
const boxprobe = (...args) => execFileSync(program, [...args, '--quiet'], { stdio: 'inherit' });

const mirror = ['floor', 'sphere'];
// The page lights everything from the probes' maps, and second bounces in them stay as they were exported. `render` lights by the shapes of
// lamps if the scene does not say otherwise, and bakes second bounces by the technique and the roughness that a case names.
const oneBounce = 'probes.room.bounces=1', inMap = 'lamps=in-map';
// `least`: dB. `set`: of the scene that is exported and of the one that is rendered. The building has sky and diffuse light.
const cases = [
  { scene: 'room', camera: 'A', technique: 'box', least: 40 },
  { scene: 'room', set: [oneBounce, inMap], camera: 'main', technique: 'infinite', least: 40 },
  { scene: 'room', set: [oneBounce, inMap], camera: 'B', technique: 'box+footprint4', roughness: 0.4, materials: mirror, least: 40 },
  { scene: 'room', set: [oneBounce, inMap], camera: 'A', technique: 'sphere+hdrp', roughness: 0.3, materials: mirror, least: 40 },
  { scene: 'room', set: [oneBounce, inMap], camera: 'A', technique: 'box', origin: [-1.5, 1.0, 0.8], least: 40 },
  { scene: 'six-faces', camera: 'main', technique: 'box', least: 40 },
  { scene: 'building', set: [inMap], camera: 'main', technique: 'box+footprint4', least: 30 },
];

let page, server, open = '';
for (const test of cases) {
  const set = test.set || [], title = [test.scene, ...set].join(' ');
  const file = path.join(scenes, test.scene + '.boxprobe.json'), folder = path.join(out, title), sets = set.flatMap((value) => ['--set', value]);
  if (open !== title) {
    if (page) await page.close();
    if (server) server.close();
    boxprobe('export', file, '-o', folder, '--format', 'web', ...sets);
    const bytes = readdirSync(folder).reduce((sum, name) => sum + statSync(path.join(folder, name)).size, 0);
    server = await serve(folder);
    page = await BrowserPage.open(server.address, { width: 1000, height: 900 });
    await page.until('!!document.querySelector("#room").boxprobePanel && Number(document.querySelector("#room").dataset.drawn) > 0 || !!document.querySelector("#room p")', 240);
    open = title;
    console.log(`${title}: ${(bytes / 1e6).toFixed(1)} MB, drawn by ${await page.evaluate('document.querySelector("#room").boxprobeRoom?.renderer ?? document.querySelector("#room").textContent')}`);
    await page.screenshot(path.join(out, title + '.png'));
    await page.evaluate(`(async () => { const host = document.createElement('div'); host.id = 'plain'; host.className = 'room-view'; document.body.append(host); host.scrollIntoView(); await boxprobeRoom(host, await (await fetch('scene.json')).json(), { antialias: false }); host.boxprobePanel.redraw = () => {}; })()`);
  }
  const png = path.join(out, 'render.png');
  boxprobe('render', file, '-o', png, '--size', `${width}x${height}`, '--camera', test.camera, '--samples', '1', '--technique', test.technique, ...sets,
    ...(test.materials || []).flatMap((name) => ['--set', `materials.${name}.roughness=${test.roughness}`]),
    ...(test.origin ? ['--set', `probes.room.origin=${JSON.stringify(test.origin)}`] : []));
  const [projection, evaluation = 'none'] = test.technique.split('+');
  await page.middle('#plain');
  await page.until(`document.querySelector('#plain').boxprobeRoom.ready`, 60);
  await page.evaluate(`(() => { const room = document.querySelector('#plain').boxprobeRoom; room.camera = room.scene.cameras.find((c) => c.name === '${test.camera}');
    room.row = room.findRow('${projection}', '${evaluation}'); room.roughness = ${test.roughness ?? null};
    ${test.origin ? `room.recapture(room.probes[0], ${JSON.stringify(test.origin)});` : ''} })()`);
  const db = await roomPsnr(page, 'document.querySelector("#plain").boxprobeRoom', png, width, height);
  check(db >= test.least, `${title} ${test.camera} ${test.technique}${test.roughness ? ', roughness ' + test.roughness : ''}${test.origin ? ', captured in the browser' : ''}: ${db.toFixed(1)} dB (at least ${test.least})`);
  if (test.scene === 'room' && test === cases[0]) {
    // Handles of the page itself.
    const position = '(document.querySelector("#room").boxprobeRoom.camera.position)';
    const before = await page.evaluate(position), [x, y] = await page.middle('#room canvas');
    await page.drag([x, y], [x + 80, y + 10]);
    const after = await page.evaluate(position);
    check(Math.hypot(...after.map((v, i) => v - before[i])) > 0.3, 'dragging turns the camera');
    const drawn = await page.evaluate('Number(document.querySelector("#room").dataset.drawn)');
    await page.middle('#room [data-control="projection"]');
    await page.evaluate('document.querySelector(\'#room [data-control="projection"]\').focus()');
    await page.key('ArrowUp');
    await page.until(`Number(document.querySelector("#room").dataset.drawn) > ${drawn}`);
    check(await page.evaluate('document.querySelector("#room").boxprobeRoom.row.projection[0] !== "box"'), 'the technique is chosen by key');
    const [rx, ry] = await page.middle('#room [data-control="roughness"]');
    await page.click(rx, ry);
    check(Math.abs(await page.evaluate('document.querySelector("#room").boxprobeRoom.roughness') - 0.5) < 0.05, 'the roughness follows the pointer');
    await page.size(390, 844, true);
    check(await page.evaluate('document.documentElement.scrollWidth') <= 390, "a telephone's width is enough");
    await page.screenshot(path.join(out, 'phone.png'));
    await page.size(1000, 900);
  }
}
check(page.messages.length === 0, `no script failed ${page.messages.join(' ')}`);
await page.close();
server.close();
await checkLimits(program, scenes, out);
