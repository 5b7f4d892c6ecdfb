// What the page of a scene does at its limits: what its policy lets in, a graphics card that is taken away, more rooms than a browser has
// contexts for, names that JavaScript's objects have themselves, files that are cut off or damaged. Called by web_viewer.mjs.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check, serve } from './browser_page.mjs';

const ROOM = '(document.querySelector("#room").boxprobeRoom)', PANEL = '(document.querySelector("#room").boxprobePanel)';
const said = (host = '#room') => `[...document.querySelectorAll('${host} p')].map((p) => p.textContent).join('')`;
const drawn = `Number(document.querySelector('#room').dataset.drawn) > 0`;
const wait = (page, milliseconds) => page.evaluate(`new Promise((resolve) => setTimeout(resolve, ${milliseconds}))`);
/** Mean of the picture's values, of 255. */
const light = (room) => `(() => { const { gl } = ${room}, w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, all = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, all);
  return all.reduce((sum, v, i) => sum + (i % 4 < 3 ? v : 0), 0) / (3 * w * h); })()`;

/** `policy` of a page that is open: what does not stand in it, or beside it, is refused. */
export async function checkPolicy(page, name) {
  const policy = await page.evaluate(`document.querySelector('meta[http-equiv="Content-Security-Policy"]')?.content`) || '';
  const scripts = policy.match(/script-src ([^;]*)/)?.[1] || '';
  check(policy.startsWith("default-src 'none';") && /^('sha256-[\w+/]{43}=' ?|'self' ?)+$/.test(scripts), `${name}: its policy lets in scripts of its own alone`);
  const tried = await page.evaluate(`(async () => {
    const refused = [], note = (event) => refused.push(event.effectiveDirective);
    document.addEventListener('securitypolicyviolation', note);
    const add = (tag, values) => { const made = Object.assign(document.createElement(tag), values); document.body.append(made); return made; };
    const made = [add('script', { textContent: 'window.strange = 1;' }), add('img', { src: 'https://boxprobe.invalid/a.png' }), add('style', { textContent: 'body{outline:0}' }), add('iframe', { src: 'https://boxprobe.invalid/' })];
    made.push(add('p', { innerHTML: '<b onclick="window.strange = 2">b</b>' }));
    made[4].firstChild.click();
    await fetch('https://boxprobe.invalid/b').catch(() => {});
    await new Promise((resolve) => setTimeout(resolve, 300));
    document.removeEventListener('securitypolicyviolation', note);
    for (const one of made) one.remove();
    return { strange: window.strange, refused: [...new Set(refused)].sort().join(' ') };
  })()`);
  check(!tried.strange && tried.refused === 'connect-src frame-src img-src script-src-attr script-src-elem style-src-elem', `${name}: a stranger's script, handler, style, picture, frame and address are refused (${tried.refused})`);
}

async function checkLoss(page) {
  await page.middle('#room canvas');
  await wait(page, 600);
  const before = await page.evaluate(light(ROOM));
  await page.evaluate(`window.taken = ${ROOM}.gl.getExtension('WEBGL_lose_context'), document.querySelector('#room canvas').focus(), taken.loseContext()`);
  await page.until(`/taken the graphics card away/.test(${said()})`, 20);
  const still = await page.evaluate(`(() => { const c = document.querySelector('#room canvas'), all = c.getContext('2d')?.getImageData(0, 0, c.width, c.height).data; return all ? all.reduce((sum, v, i) => sum + (i % 4 < 3 ? v : 0), 0) / (0.75 * all.length) : 0; })()`);
  check(Math.abs(still - before) < 1, `a graphics card that is taken away is said, and the last picture stands there (${still.toFixed(1)}, ${before.toFixed(1)})`);
  // What is changed meanwhile is there afterwards.
  await page.evaluate(`(() => { const slider = document.querySelector('#room [data-control="origin x"]'); slider.value = Number(slider.max) - 0.1; slider.dispatchEvent(new Event('input')); })()`);
  await page.evaluate('taken.restoreContext()');
  await page.until(`${ROOM}.ready && !${PANEL}.waiting`, 60);
  const after = await page.evaluate(light(ROOM)), moved = await page.evaluate(`${ROOM}.probes[0].map === ${ROOM}.probes[0].captured`);
  check(moved && after > 0.8 * before && after < 1.2 * before && !(await page.evaluate(said())), `it comes back: the picture is drawn again (${after.toFixed(1)}), with what was moved meanwhile, and the line is gone`);
  check(await page.evaluate(`document.activeElement === document.querySelector('#room canvas')`), 'the keys are its own again');
  await page.evaluate(`document.querySelector('#room button').click()`);
  await page.until(`!${PANEL}.waiting`, 60);
  const again = await page.evaluate(light(ROOM));
  check(Math.abs(again - before) < 0.1, `and it starts again as it was (${again.toFixed(1)})`);
  // Taken away while it is loaded: by the first file that is asked for.
  await page.evaluate(`(() => { const host = document.createElement('div'); host.id = 'early'; host.className = 'room-view'; document.body.prepend(host); scrollTo(0, 0);
    let taken = null; const own = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (...values) { const made = own.apply(this, values); if (values[0] === 'webgl2') taken = taken || made.getExtension('WEBGL_lose_context'); return made; };
    fetch('scene.json').then((answer) => answer.json()).then((scene) => boxprobeRoom(host, scene, { files: (name) => { if (taken) { const it = taken; taken = null; it.loseContext(); setTimeout(() => it.restoreContext(), 300); HTMLCanvasElement.prototype.getContext = own; } return name; } })); })()`);
  await page.until(`Number(document.querySelector('#early').dataset.drawn) > 0 || !!document.querySelector('#early p[role=alert]:not(:empty)') && document.querySelector('#early').boxprobeRoom !== undefined`, 60);
  await page.until(`document.querySelector('#early').boxprobeRoom.ready`, 60);
  const early = await page.evaluate(light('document.querySelector("#early").boxprobeRoom'));
  check(early > 0.8 * before && !(await page.evaluate(said('#early'))), `taken away while it is loaded, it is loaded once more (${early.toFixed(1)})`);
  await page.evaluate(`document.querySelector('#early').remove()`);
}

/** 18 rooms on a page, and 18 pages in frames of one: every one is alive when it is looked at. */
async function checkMany(address, folder) {
  const count = 18, page = await BrowserPage.open(address, { width: 1000, height: 700 });
  await page.until(drawn, 60);
  await page.evaluate(`(async () => { const scene = await (await fetch('scene.json')).json();
    for (let i = 1; i < ${count}; i++) { const host = document.createElement('div'); host.id = 'room' + i; host.className = 'room-view'; host.style.minHeight = '900px'; document.body.append(host); boxprobeRoom(host, scene, { panel: i % 2 === 0 }); } })()`);
  const hosts = ['#room', ...Array.from({ length: count - 1 }, (_, i) => `#room${i + 1}`)];
  const lights = [];
  let most = 0;
  for (const host of [...hosts, '#room']) {
    await page.evaluate(`document.querySelector('${host}').scrollIntoView({ behavior: 'instant' })`);
    await page.until(`document.querySelector('${host}').boxprobeRoom?.ready`, 60);
    await page.evaluate(`document.querySelector('${host}').boxprobeRoom.draw()`);
    lights.push(await page.evaluate(light(`document.querySelector('${host}').boxprobeRoom`)));
    most = Math.max(most, await page.evaluate(`[...document.querySelectorAll('.room-view')].filter((host) => host.boxprobeRoom && !host.boxprobeRoom.gl.isContextLost()).length`));
  }
  const alerts = await page.evaluate(`document.querySelectorAll('[role=alert]').length`);
  check(lights.every((v) => v > 30) && alerts === 0, `${count} rooms on a page: each is alive in view, the first one again (at least ${Math.min(...lights).toFixed(0)} of 255)`);
  check(most <= 6, `and no more than ${most} of them hold a context at a time`);
  const stills = await page.evaluate(`[...document.querySelectorAll('.room-view')].filter((host) => host.boxprobeRoom.gl.isContextLost()).map((host) => { const c = host.querySelector('canvas'), all = c.getContext('2d')?.getImageData(c.width / 4, c.height / 4, c.width / 2, c.height / 2).data; return all ? all.reduce((sum, v) => sum + v, 0) / all.length : 0; })`);
  check(stills.length >= count - 6 && stills.every((v) => v > 30), `the other ${stills.length} are stills`);
  check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
  await page.close();

  // More than a browser keeps, all in view: those without a context say so, and their last pictures stand there.
  const crowd = await BrowserPage.open(address, { width: 1000, height: 700 });
  await crowd.until(drawn, 60);
  await crowd.evaluate(`(async () => { const scene = await (await fetch('scene.json')).json(), all = document.createElement('div'); document.querySelector('#room').remove(); all.style = 'display:grid;grid-template-columns:repeat(6,1fr)'; document.body.prepend(all); scrollTo(0, 0);
    for (let i = 0; i < 20; i++) { const host = document.createElement('div'); host.className = 'room-view'; all.append(host); await boxprobeRoom(host, scene, { panel: false }); await new Promise((resolve) => setTimeout(resolve, 400)); } })()`);
  await wait(crowd, 1000);
  const states = await crowd.evaluate(`[...document.querySelectorAll('.room-view')].map((host) => { const c = host.querySelector('canvas'), all = c.getContext('2d')?.getImageData(0, 0, c.width, c.height).data; return { lost: host.boxprobeRoom.gl.isContextLost(), said: /taken the graphics card away/.test(host.textContent), still: all ? all.reduce((sum, v) => sum + v, 0) / all.length : 0 }; })`);
  const without = states.filter(({ lost }) => lost);
  check(states.every(({ lost, said: line }) => lost === line) && without.every(({ still }) => still > 30), `20 rooms in view at once: ${without.length} of them have no context, and say so below their last pictures`);
  await crowd.close();

  writeFileSync(path.join(folder, 'frames.html'), `<!DOCTYPE html><title>frames</title>${'<iframe src="index.html" width="960" height="800" style="display:block"></iframe>'.repeat(count)}`);
  const frames = await BrowserPage.open(address + 'frames.html', { width: 1000, height: 700 });
  let alive = 0;
  for (const i of [...Array(count).keys(), 0]) {
    await frames.evaluate(`document.querySelectorAll('iframe')[${i}].scrollIntoView({ behavior: 'instant' })`);
    const room = `document.querySelectorAll('iframe')[${i}].contentDocument.querySelector('#room').boxprobeRoom`;
    await frames.until(`${room}?.ready`, 60);
    await frames.evaluate(`${room}.draw()`);
    if (await frames.evaluate(light(room)) > 30) alive++;
  }
  check(alive === count + 1, `${count} pages in frames: each is alive in view, the first one again`);
  await frames.close();
}

/** A closed room of an OBJ file with a name for each wall and its material, two of them for cameras and probes, too. */
function namedScene(folder, names) {
  const [x, y, z] = [[-2, 2], [0, 3], [-2, 2]];
  const walls = [[[x[0], y[0], z[1]], [x[1], y[0], z[1]], [x[1], y[0], z[0]], [x[0], y[0], z[0]]], [[x[0], y[1], z[0]], [x[1], y[1], z[0]], [x[1], y[1], z[1]], [x[0], y[1], z[1]]],
    [[x[0], y[0], z[0]], [x[1], y[0], z[0]], [x[1], y[1], z[0]], [x[0], y[1], z[0]]], [[x[1], y[0], z[1]], [x[0], y[0], z[1]], [x[0], y[1], z[1]], [x[1], y[1], z[1]]],
    [[x[0], y[0], z[1]], [x[0], y[0], z[0]], [x[0], y[1], z[0]], [x[0], y[1], z[1]]], [[x[1], y[0], z[0]], [x[1], y[0], z[1]], [x[1], y[1], z[1]], [x[1], y[1], z[0]]]];
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, 'room.mtl'), names.map((name, i) => `newmtl ${name}\nKd ${0.2 + 0.1 * i} 0.5 ${0.8 - 0.1 * i}\nKe 0.2 0.2 ${0.1 * i}\n`).join(''));
  writeFileSync(path.join(folder, 'room.obj'), 'mtllib room.mtl\n' + walls.map((wall, i) => `o ${names[i]}\nusemtl ${names[i]}\n${wall.map((at) => `v ${at.join(' ')}\n`).join('')}f ${[1, 2, 3, 4].map((k) => 4 * i + k).join(' ')}\n`).join(''));
  const camera = (side) => `{"position": [${-side}, 1.5, 1.5], "target": [${side}, 1, -1], "up": [0, 1, 0], "verticalFovDegrees": 60}`;
  const probe = (name, at) => `{"name": "${name}", "origin": [${at}, 1.5, 0], "box": {"min": [-2, 0, -2], "max": [2, 3, 2]}, "influence": {"min": [-2.1, -0.1, -2.1], "max": [2.1, 3.1, 2.1]}, "blendDistance": 0, "faceSize": 32}`;
  const file = path.join(folder, 'room.boxprobe.json');
  writeFileSync(file, `{"format": "boxprobe-scene", "version": 1, "model": "room.obj", "cameras": {"${names[0]}": ${camera(1)}, "${names[1]}": ${camera(-1)}}, "objects": {"${names[1]}": {"seenByProbes": true}},
    "materials": {"${names[0]}": {"metallic": 1, "roughness": 0.1, "baseColor": [0.9, 0.9, 0.9]}, "${names[1]}": {"roughness": 0.3}}, "probes": [${probe(names[0], 0)}, ${probe(names[1], 0.3)}]}`);
  return file;
}

/** Names of what every object of JavaScript has: the same pictures as with any others, in the same order. */
async function checkNames(boxprobe, out) {
  const strange = ['constructor', '__proto__', 'toString', 'hasOwnProperty', 'valueOf', 'prototype'], pictures = [];
  for (const names of [['b', 'a', 'c', 'd', 'e', 'f'], strange]) {
    const folder = path.join(out, names[0]);
    boxprobe('export', namedScene(folder, names), '-o', path.join(folder, 'page'), '--format', 'web');
    const server = await serve(path.join(folder, 'page')), page = await BrowserPage.open(server.address, { width: 900, height: 900 });
    await page.until(`${drawn} || !!${said()}`, 60);
    for (const camera of names.slice(0, 2)) {
      await page.middle('#room canvas');
      await page.evaluate(`(() => { const select = document.querySelector('[data-control="camera"]'); select.value = '${camera}'; select.dispatchEvent(new Event('change')); })()`);
      await page.until(`${ROOM}.ready && !${PANEL}.waiting && ${ROOM}.camera.name === '${camera}'`, 60);
      pictures.push(await page.evaluate(`(() => { const { gl } = ${ROOM}, w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, all = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, all);
        return { light: all.reduce((sum, v) => sum + v, 0) / all.length, text: all.reduce((sum, v, i) => (Math.imul(sum, 31) + v * (i % 7 + 1)) | 0, 0) }; })()`));
    }
    if (names === strange) {
      await page.evaluate(`(() => { const select = document.querySelector('[data-control="probe"]'); select.value = '1'; select.dispatchEvent(new Event('change')); })()`);
      check(await page.evaluate(`document.querySelector('[data-control="probe"]').selectedOptions[0].textContent`) === '__proto__', 'a probe is chosen by whatever name');
      // A lesson's view of them.
      const values = await page.evaluate(`(() => { const room = ${ROOM}; boxprobeView(room, { camera: { ...room.scene.cameras[0], name: 'toString' }, hidden: ['toString'], technique: 'box+none', roughness: JSON.parse('{"__proto__": 0.7}'), boxes: [] });
        return { roughness: room.scene.materials.map((m) => typeof m.roughness), own: room.scene.materials.find((m) => m.name === '__proto__').roughness, hidden: room.scene.objects.filter((o) => !o.visible).map((o) => o.name).join() }; })()`);
      check(values.roughness.every((kind) => kind === 'number') && values.own === 0.7 && values.hidden === 'toString', "a lesson's view changes what it names, and nothing else");
    }
    check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
    await page.close();
    server.close();
  }
  check(pictures.every(({ light: mean }) => mean > 70) && [0, 1].every((i) => pictures[i].text === pictures[i + 2].text), `objects, materials, probes and cameras named ${strange.join(', ')}: the pictures are those of any names`);
}

/** Each file cut off at places by chance, missing, and with bytes changed: one line, and no canvas. */
async function checkDamage(whole, out) {
  let seed = 5;
  const random = () => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 2147483648; };
  const folder = path.join(out, 'damaged');
  rmSync(folder, { recursive: true, force: true });
  cpSync(whole, folder, { recursive: true });
  const server = await serve(folder), page = await BrowserPage.open(server.address, { width: 700, height: 600 }), wrong = [];
  let tried = 0;
  const names = readdirSync(whole).filter((name) => /\.(bin|ktx2|json|png)$|^room\.js$/.test(name) && !/texture-[2-9]/.test(name));
  for (const name of names) {
    const bytes = readFileSync(path.join(whole, name)), cut = () => bytes.subarray(0, Math.floor(bytes.length * random()));
    const changed = () => { const copy = Buffer.from(bytes); copy[Math.floor(copy.length * (0.1 + 0.8 * random()))] ^= 0x10; return copy; };
    // A byte of JSON or of a script that is another one may still be right: there is nothing to tell it by.
    const ways = [['cut', cut], ['cut', cut], ['empty', () => Buffer.alloc(0)], ['less a byte', () => bytes.subarray(0, name === 'room.js' ? -9 : -4)], ['missing', null], ...(/\.js/.test(name) ? [] : [['changed', changed]])];
    for (const [way, make] of ways) {
      if (make) writeFileSync(path.join(folder, name), make());
      else rmSync(path.join(folder, name));
      await page.reload();
      const seen = await page.until(`!!document.querySelector('#room') && (${drawn} || !!${said()})`, 30).then(() => page.evaluate(`({ said: ${said()}, lines: document.querySelectorAll('#room p').length, canvas: !!document.querySelector('#room canvas') })`), () => ({ lines: 0 }));
      if (seen.lines !== 1 || seen.canvas || !/cannot be (drawn here|read)/.test(seen.said)) wrong.push(`${name}, ${way}: ${JSON.stringify(seen)}`);
      tried++;
    }
    writeFileSync(path.join(folder, name), bytes);
  }
  check(wrong.length === 0, `${tried} damaged files of ${names.length}: one line each, and no room that is drawn by half ${wrong.join('; ')}`);
  await page.reload();
  await page.until(`${drawn} || !!${said()}`, 60);
  check(await page.evaluate(light(ROOM)) > 30, 'whole again, it is drawn');
  await page.close();
  server.close();
}

/** `folder`: of a scene that was exported. */
export async function checkLimits(program, scenes, out) {
  const boxprobe = (...args) => execFileSync(program, [...args, '--quiet'], { stdio: 'inherit' }), folder = path.join(out, 'limits');
  boxprobe('export', path.join(scenes, 'room.boxprobe.json'), '-o', folder, '--format', 'web', '--size', '64');
  const server = await serve(folder), page = await BrowserPage.open(server.address, { width: 1000, height: 900 });
  await page.until(`${drawn} || !!${said()}`, 120);
  check((await page.failures()).length === 0, `its policy refuses nothing of its own ${(await page.failures()).join(' ')}`);
  await checkLoss(page);
  check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
  await checkPolicy(page, 'the viewer');
  await page.close();
  const disk = await BrowserPage.open('file://' + path.resolve(folder, 'index.html'));
  await disk.until(`!!${said()}`, 30);
  check(/Put the folder on a web server/.test(await disk.evaluate(said())), 'opened from the disk it says what it needs');
  await disk.close();
  await checkMany(server.address, folder);
  server.close();
  await checkNames(boxprobe, out);
  await checkDamage(folder, out);
}
