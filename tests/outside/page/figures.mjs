// The live figures of the page of lessons, by real pointer, touch and key events: the infinity slider against C++ and `boxprobe render`,
// the floor's map of errors against a ray from the mirrored eye through all six walls, computed here; steps that wait for a guess.
// usage: figures.mjs BOXPROBE PLAN_NUMBERS SCENES OUT [POINTS]
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check, roomPsnr } from './browser_page.mjs';
import { checkSketches } from './sketches.mjs';

const [program, oracle, scenes, out, points = '120'] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const made = (lesson) => {
  const file = path.resolve(out, lesson + '.html');
  if (!process.env.BOXPROBE_KEEP_PAGE || !existsSync(file)) execFileSync(program, ['lessons', lesson, '-o', file, '--quiet', '--language', 'en'], { stdio: 'inherit' });
  return 'file://' + file;
};
let seed = 7;
const random = () => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 2147483648; };
const degrees = (a, b) => {
  const chord = Math.hypot(...a.map((v, i) => v / Math.hypot(...a) - b[i] / Math.hypot(...b)));
  return 2 * Math.asin(Math.min(chord / 2, 1)) * 180 / Math.PI;
};
/** What an eye sees in a floor at y = 0 through P: the straight line from the mirrored eye, to the nearest of six walls beyond P. */
function seenInFloor(eye, position, room) {
  const from = [eye[0], -eye[1], eye[2]], along = position.map((v, i) => v - from[i]);
  let nearest = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    for (const wall of [room.min[axis], room.max[axis]]) {
      const t = (wall - from[axis]) / along[axis];
      if (t > 1 + 1e-6 && t < nearest) nearest = t;  // the floor itself is at 1, to the digits of a float
    }
  }
  return from.map((v, i) => v + nearest * along[i]);
}

await checkSketches(path.join(path.dirname(new URL(import.meta.url).pathname), '../../../data/web'), oracle, out);

// A: the infinity slider.
const page = await BrowserPage.open(made('floor-mirror'), { width: 1280, height: 900 });
const began = Date.now();
await page.until('Number(document.querySelector("[data-figure=infinity]").dataset.drawn) > 1');
console.log(`  alive ${((Date.now() - began) / 1000).toFixed(1)} s after the page`);
const host = 'document.querySelector("[data-figure=infinity]")', figure = `${host}.boxprobeInfinity`;
check(await page.evaluate(`${host}.querySelectorAll('.figure-still').length`) === 0, 'the line for browsers without scripts is gone');
const drawnAgain = async (act) => {
  await act();
  await page.evaluate('new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))');
  await page.until(`!${figure}.waiting`, 20);
};
await page.screenshot(path.join(out, 'infinity-0.png'));
/** How far from where P was chosen it is seen, in shares of the picture, by the camera's own axes. */
function placeOff(s) {
  const back = s.camera.position.map((x, i) => x - s.camera.target[i]).map((x, _, all) => x / Math.hypot(...all)), right = [back[2], 0, -back[0]].map((x) => x / Math.hypot(back[2], back[0]));
  const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
  const from = s.position.map((x, i) => x - s.camera.position[i]), dot = (a) => a.reduce((sum, x, i) => sum + x * from[i], 0), tangent = Math.tan(s.camera.fov * Math.PI / 360);
  return Math.max(Math.abs(0.5 + 0.5 * dot(right) / -dot(back) / tangent / 1.6 - s.share[0]), Math.abs(0.5 - 0.5 * dot(up) / -dot(back) / tangent - s.share[1]));
}
const chosen = () => page.evaluate(`(() => { const n = ${figure}.numbers(), c = ${figure}.room.camera; return { ...n, share: ${figure}.share, camera: { position: c.position, target: c.target, fov: c.verticalFovDegrees } }; })()`);
check(placeOff(await chosen()) < 2e-3, 'the first P lies where it was put');

// The slider's knob, dragged.
const knob = () => page.evaluate(`(() => { const r = ${figure}.slider.getBoundingClientRect(), k = 16; return { y: r.y + r.height / 2, at: [0, 0.3, 0.5, 1].map((v) => r.x + k / 2 + (r.width - k) * v), now: r.x + k / 2 + (r.width - k) * ${figure}.slider.value / 1000 }; })()`);
await page.middle('[data-control="box size"]');
let slider = await knob();
await drawnAgain(() => page.drag([slider.now, slider.y], [slider.at[2], slider.y]));
const half = await page.evaluate(`${figure}.size`);
check(Math.abs(half - 0.5) < 0.02, `the knob dragged to the middle: the box is ${(1 / half).toFixed(2)} rooms`);
await page.screenshot(path.join(out, 'infinity-half.png'));
await page.evaluate(`${figure}.slider.focus()`);
await drawnAgain(() => page.key('ArrowRight'));
check(await page.evaluate(`${figure}.size`) > half, 'an arrow key makes the box smaller');

// Points of the floor under a moving pointer, for several sizes of the box.
const lines = [], shown = [];
let moved = 0, last = '';
for (let n = 0; n < Number(points); n++) {
  if (n % 20 === 0) {
    slider = await knob();
    const to = slider.at[0] + (slider.at[3] - slider.at[0]) * (n === 0 ? 0.2 : random());
    if (Math.abs(to - slider.now) > 2) await drawnAgain(() => page.drag([slider.now, slider.y], [to, slider.y]));
  }
  const at = await page.evaluate(`(() => { const r = ${figure}.canvas.getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()`);
  const share = [0.02 + 0.96 * random(), 0.55 + 0.42 * random()];
  await page.mouse('mouseMoved', at[0] + share[0] * at[2], at[1] + share[1] * at[3]);
  const s = await chosen();
  const text = s.position.join();
  if (text !== last) moved++;
  last = text;
  if (!s.box) continue;
  shown.push(s);
  lines.push([...s.position, 0, 1, 0, ...s.eye, ...s.origin, ...s.box.min, ...s.box.max].join(' '));
}
check(moved > 0.6 * Number(points), `${moved} of ${points} pointer moves moved P; any others were over a wall`);
const answers = execFileSync(oracle, { input: lines.join('\n') + '\n' }).toString().trim().split('\n').map((line) => line.split(' ').map(Number));
let worst = 0, worstPlace = 0, worstError = 0;
answers.forEach((v, n) => {
  const s = shown[n], size = Math.hypot(...s.box.max.map((x, i) => x - s.box.min[i]));
  worst = Math.max(worst, Math.abs(v[3] - s.distance) / size, ...[0, 1, 2].flatMap((i) => [Math.abs(v[6 + i] - s.reflection[i]), Math.abs(v[9 + i] - s.lookup[i]) / size]));
  worstPlace = Math.max(worstPlace, placeOff(s));
  const seen = seenInFloor(s.eye, s.position, s.room);
  worstError = Math.max(worstError, Math.abs(degrees(s.lookup, seen.map((x, i) => x - s.origin[i])) - s.errorDegrees));
});
check(answers.length > 0.3 * Number(points) && worst <= 1e-5, `${answers.length} rays: R, d, H - C off from C++ by at most ${worst.toExponential(1)} of the box (1e-5)`);
check(worstPlace < 2e-3, `P lies under the pointer, to ${worstPlace.toExponential(1)} of the picture`);
check(worstError < 1e-3, `the error in degrees, from the mirrored eye: off by at most ${worstError.toExponential(1)}`);

// Dot and ring: apart for R alone, together for the room's box.
const apart = () => page.evaluate(`(() => { const [ring, dot] = ['.ring', '.dot'].map((c) => ${figure}.mapOver.querySelector(c)); return Math.hypot(ring.cx.baseVal.value - dot.cx.baseVal.value, ring.cy.baseVal.value - dot.cy.baseVal.value); })()`);
await page.middle('[data-control="box size"]');
slider = await knob();
await drawnAgain(() => page.drag([slider.now, slider.y], [slider.at[0] - 12, slider.y]));
const far = await apart();
const png = path.join(out, 'render.png'), width = 480, height = 300;
const psnr = async (technique) => {
  execFileSync(program, ['render', path.join(scenes, 'room.boxprobe.json'), '-o', png, '--size', `${width}x${height}`, '--camera', 'A', '--samples', '4', '--quiet', '--technique', technique,
    '--set', 'probes.room.faceSize=128', ...[1, 2, 3].flatMap((n) => ['--set', `objects.sphere ${n}.visible=false`])]);
  const db = await roomPsnr(page, `${host}.boxprobeRoom`, png, width, height);
  await drawnAgain(() => page.evaluate(`${figure}.redraw()`));
  return db;
};
const bare = await psnr('infinite');
await page.middle('[data-control="box size"]');
slider = await knob();
await drawnAgain(() => page.drag([slider.now, slider.y], [slider.at[3] + 12, slider.y]));
const near = await apart(), boxed = await psnr('box');
check(far > 20 && near < 0.5, `dot and ring are ${far.toFixed(0)} apart with R alone, ${near.toFixed(2)} with the box`);
check(bare >= 40 && boxed >= 40, `R alone ${bare.toFixed(1)} dB, the room's box ${boxed.toFixed(1)} dB from render (at least 40)`);
check(/is right/.test(await page.evaluate(`${figure}.said.textContent`)), 'and it says that the pixel is right');
await page.middle('[data-figure=infinity] canvas');
await page.screenshot(path.join(out, 'infinity-1.png'));

// Keys, a finger, and motion that is not wanted.
const place = () => page.evaluate(`${figure}.share`);
await page.evaluate(`${figure}.canvas.focus()`);
await page.evaluate(`${figure}.choose(0.5, 0.75)`);
await drawnAgain(() => page.key('ArrowLeft'));
check(Math.abs((await place())[0] - 0.49) < 1e-6, 'an arrow key moves P');
const canvas = await page.evaluate(`(() => { const r = ${figure}.canvas.getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()`);
await page.touch([canvas[0] + 0.3 * canvas[2], canvas[1] + 0.8 * canvas[3]]);
check(Math.abs((await place())[0] - 0.3) < 0.01, 'a finger moves P');
const held = (await place())[1];
await page.evaluate(`${figure}.canvas.focus()`);
for (const modifier of [1, 2, 4]) await page.key('ArrowDown', modifier);
check(Math.abs((await place())[1] - held) < 1e-6, 'with Alt, Ctrl or Meta it is left to the browser');
await page.media({ motion: 'reduce' });
await page.evaluate(`${figure}.setSize(0)`);
await page.click(...await page.middle('[data-figure=infinity] .figure-bar button'));
check(await page.evaluate(`${figure}.size`) === 1, 'with reduced motion Play goes to its end at once');
await page.media();
// Steps of the slider's way in ten frames, after Stop and Play within one.
const moves = await page.evaluate(`(async () => {
  const f = ${figure}, set = f.setSize.bind(f);
  let count = 0;
  set(0);
  f.setSize = (size) => { count++; set(size); };
  f.run(); f.stop(); f.run();
  for (let i = 0; i < 10; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  f.stop();
  delete f.setSize;
  return count;
})()`);
check(moves >= 9 && moves <= 11, `stopped and played again it moves once a frame: ${moves} times in 10`);

// Steps wait for a guess, and the verdict stands in the question.
const steps = () => page.evaluate(`[...document.querySelectorAll('.step')].map((step) => getComputedStyle(step).display !== 'none')`);
check((await steps()).join() === 'true,false,false,false,false,false', 'the step that answers is hidden, and all after it');
const answering = () => page.evaluate(`['.measured', '.exercises', '.widget:has(.plan)', '.widget:has(.room-view)'].map((part) => document.querySelector(part).hidden).join()`);
check(await answering() === 'true,true,true,true', 'and what was measured, the exercises, the plan and the room with it');
await page.click(...await page.middle('.question details.wrong summary'));
check((await steps()).join() === 'true,true,true,false,false,false' && await answering() === 'true,true,true,true', 'after a guess the steps up to the next question stand there');
const verdict = await page.evaluate(`document.querySelector('.question .verdict').textContent`);
check(/Not that one.*0 of 1 right/.test(verdict), `the verdict stands in the question: ${verdict}`);
await page.click(...await page.middle('.question details.right summary'));
check(/^Right.*0 of 1 right/.test(await page.evaluate(`document.querySelector('.question .verdict').textContent`)), 'the first try counts');
await page.reload();
await page.until('document.querySelectorAll(".question .verdict").length > 0');
check((await steps()).join() === 'true,true,true,false,false,false', 'the guess is kept');
await page.click(...await page.middle('.step:nth-of-type(3) .question details.right summary'));
check((await steps()).join() === 'true,true,true,true,true,true' && await answering() === 'false,false,false,false', 'after the last guess everything stands there');
await page.middle('[data-figure=infinity]');  // a figure begins when it is seen
await page.until('Number(document.querySelector("[data-figure=infinity]").dataset.drawn) > 1');
check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
await page.size(360, 780, true);
check(await page.evaluate('document.documentElement.scrollWidth') <= 360, 'a telephone of 360 pixels is wide enough');
await page.middle('[data-figure=infinity] .figure-both');
await page.until(`!${figure}.waiting`, 20);
await page.screenshot(path.join(out, 'infinity-phone.png'));
await page.evaluate(`window.taken = ${figure}.room.gl.getExtension('WEBGL_lose_context'), taken.loseContext()`);
await page.until(`/load the page again/.test(${host}.querySelector('.room-said')?.textContent)`, 20);
const drawnBefore = await page.evaluate(`${host}.dataset.drawn`);
await drawnAgain(() => page.evaluate(`${figure}.redraw()`));
check(await page.evaluate(`${host}.dataset.drawn`) === drawnBefore && (await page.failures()).length === 0, 'a graphics card that is taken away is said, and nothing is drawn by it');
await page.evaluate('taken.restoreContext()');
await page.until(`!${host}.querySelector('.room-said') && Number(${host}.dataset.drawn) > ${drawnBefore} && !${figure}.waiting`, 60);
await page.evaluate(`${figure}.setSize(1)`);
const restored = await psnr('box');
check(restored >= 40, `one that comes back draws as before: ${restored.toFixed(1)} dB from render (at least 40)`);
await page.evaluate('scrollTo(0, document.documentElement.scrollHeight)');
await page.until(`${figure}.room.gl.isContextLost()`, 20);
await page.middle('[data-figure=infinity] .figure-both');
await page.until(`${figure}.room.ready && !${figure}.waiting`, 60);
check(await page.evaluate(`${figure}.canvas.isConnected && ${figure}.canvas.nextSibling === ${figure}.over && !${host}.querySelector('.room-said')`), 'scrolled away and back, it is alive again');
const again = await psnr('box');
check(again >= 40, `and draws as before: ${again.toFixed(1)} dB from render (at least 40)`);
await page.close();
const addressed = await BrowserPage.open(made('floor-mirror') + '#floor-mirror-2');
check(await addressed.evaluate(`!document.getElementById('floor-mirror-2').hidden`), "a step's own address shows it");
await addressed.close();
const former = await BrowserPage.open(made('floor-mirror') + '#in-the-cubemap');
check(await former.evaluate(`!document.getElementById('floor-mirror-3').hidden && document.getElementById('floor-mirror-4').hidden && Math.abs(document.getElementById('floor-mirror-3').getBoundingClientRect().top) < innerHeight`), 'the name of a lesson that was merged into this one shows where it begins');
await former.close();
const odd = await BrowserPage.open(made('floor-mirror') + '#%');
check(await odd.evaluate(`document.querySelectorAll('.waiting').length`) === 1 && (await odd.failures()).length === 0, 'an address that is no code does no harm');
await odd.close();

const lastStep = await BrowserPage.open(made('bounces'));
await lastStep.click(...await lastStep.middle('.question details.wrong summary'));
check(/^Make a guess, and what was measured appears\.Show/.test(await lastStep.evaluate(`document.querySelector('.waiting').textContent`)), 'a question in the last step says what it hides');
await lastStep.close();

// B: where must you stand?
const stand = await BrowserPage.open(made('floor-mirror'), { width: 1280, height: 900 });
const stood = 'document.querySelector("[data-figure=stand]")';
check(await stand.evaluate(`${stood}.getBoundingClientRect().height`) === 0, 'it waits for a guess');
await stand.click(...await stand.middle('.waiting button'));
await stand.middle('[data-figure=stand]');
await stand.until(`!!${stood}.boxprobeStand && !!${stood}.dataset.mean`);
const state = () => stand.evaluate(`({ ...${stood}.boxprobeStand.state, room: ${stood}.boxprobeStand.room, mean: Number(${stood}.dataset.mean), columns: ${stood}.querySelector('canvas').width, rows: ${stood}.querySelector('canvas').height })`);
const settled = async (act) => {
  await act();
  await stand.until(`!${stood}.boxprobeStand.waiting`);
  return state();
};
const grip = (name) => stand.evaluate(`(() => { const r = ${stood}.querySelector('[data-handle="${name}"] circle:not(.grip)').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
const dragged = async (name, across, down) => {
  const from = await grip(name);
  return settled(() => stand.drag(from, [from[0] + across, from[1] + down]));
};
/** Mean over the same points; R alone. */
function meanOf({ eye, origin, room, columns, rows }) {
  let sum = 0;
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const p = [room.min[0] + (column + 0.5) / columns * (room.max[0] - room.min[0]), 0, room.min[2] + (row + 0.5) / rows * (room.max[2] - room.min[2])];
      sum += degrees([p[0] - eye[0], eye[1], p[2] - eye[2]], seenInFloor(eye, p, room).map((v, i) => v - origin[i]));
    }
  }
  return sum / (columns * rows);
}
// The place to be found is not given away: neither by its button nor by its ring, until C is brought there or it is asked for.
const given = () => stand.evaluate(`!document.querySelector('[data-control="mirrored eye"]').hidden || !!${stood}.querySelector('.mirrored') || ${stood}.innerText.includes('mirrored')`);
const pressed = (control) => settled(async () => stand.click(...await stand.middle(control)));
check(!(await given()), 'the place is not shown');
check((await pressed('[data-control=box]')).mean < 1e-4 && !(await given()), 'nor is it by the box');
await pressed('[data-control=box]');
await stand.middle('[data-figure=stand] .stand-both');
let [from, to] = [await grip('plan origin'), await grip('plan eye')];
await settled(() => stand.drag(from, to));
check(!(await given()), 'nor with C at the eye');
// Down in the elevation to as far below the floor's line as the eye is above it.
[from, to] = [await grip('elevation origin'), await grip('elevation eye')];
const floorLine = await stand.evaluate(`(() => { const r = ${stood}.querySelector('.floor-line').getBoundingClientRect(); return r.y + r.height / 2; })()`);
const brought = await settled(() => stand.drag(from, [to[0], 2 * floorLine - to[1]]));
check(brought.mean < 1 && await given(), `C brought there by hand, to ${brought.mean.toFixed(2)} degrees: the place is shown`);
await pressed('[data-figure=stand] .figure-bar button:last-of-type');
check(!(await given()), 'Start again hides it');
await pressed('[data-control="show the place"]');
check(await given(), 'and a button shows it');
await stand.middle('[data-figure=stand]');
let worstMean = 0, kinds = 0;
for (const [name, across, down] of [['plan origin', 40, -25], ['elevation origin', -30, 20], ['plan eye', 60, -40], ['elevation eye', -20, -25], ['plan origin', -120, 50]]) {
  const before = await state(), now = await dragged(name, across, down), key = name.split(' ')[1];
  if (now[key].some((v, i) => Math.abs(v - before[key][i]) > 0.1)) kinds++;
  worstMean = Math.max(worstMean, Math.abs(meanOf(now) - now.mean));
}
check(kinds === 5, 'C and the eye are dragged in plan and elevation');
check(worstMean < 1e-6, `the floor's mean error is that of rays from the mirrored eye, off by at most ${worstMean.toExponential(1)} degrees`);
await stand.screenshot(path.join(out, 'stand.png'));
let now = await settled(async () => stand.click(...await stand.middle('[data-control="mirrored eye"]')));
check(now.mean < 1e-4, `C on the mirrored eye: the whole floor is right (${now.mean.toExponential(1)} degrees)`);
await stand.screenshot(path.join(out, 'stand-mirrored.png'));
now = await dragged('plan eye', -40, 20);
check(now.mean > 0.5, `the eye moved: wrong again by ${now.mean.toFixed(2)} degrees`);
now = await settled(async () => stand.click(...await stand.middle('[data-control=box]')));
check(now.mean < 1e-4, 'with the box every point is right');
now = await dragged('plan origin', 70, 30);
check(now.mean < 1e-4, 'and for another C as well');
await stand.evaluate(`${stood}.querySelector('[data-handle="plan origin"]').focus()`);
const keyed = (await state()).origin[0];
now = await settled(() => stand.key('ArrowRight'));
check(Math.abs(now.origin[0] - keyed - 0.05) < 1e-6, 'an arrow key moves C by .05');
check((await stand.failures()).length === 0, `no script failed ${(await stand.failures()).join(' ')}`);
await stand.media({ scheme: 'dark' });
await stand.screenshot(path.join(out, 'stand-dark.png'));
await stand.close();

// C: from cone to texels.
const cone = await BrowserPage.open(made('contact-hardening'), { width: 1280, height: 900 });
const coned = 'document.querySelector("[data-figure=cone]")';
await cone.middle('[data-figure=cone]');
await cone.until(`!!${coned}.boxprobeCone`);
/** Solid angle of the cone's patch as C sees it: a fan of triangles on the wall (Van Oosterom and Strackee 1983). */
function patchFrom({ away, origin, roughness }, elevation = 25 * Math.PI / 180) {
  const delta = 2 * Math.atan(roughness ** 2), count = 720;
  const point = (angle) => {
    const [c, s] = [Math.cos(delta), Math.sin(delta)], ray = [c * Math.cos(elevation) - s * Math.cos(angle) * Math.sin(elevation), c * Math.sin(elevation) + s * Math.cos(angle) * Math.cos(elevation), s * Math.sin(angle)];
    return [4 - origin[0], away / ray[0] * ray[1] - origin[1], away / ray[0] * ray[2]];
  };
  const middle = [4 - origin[0], away * Math.tan(elevation) - origin[1], 0];
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const [a, b, c] = [middle, point(2 * Math.PI * i / count), point(2 * Math.PI * (i + 1) / count)], dot = (p, q) => p.reduce((t, v, k) => t + v * q[k], 0), size = (p) => Math.hypot(...p);
    const triple = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    sum += 2 * Math.atan2(Math.abs(triple), size(a) * size(b) * size(c) + dot(a, b) * size(c) + dot(a, c) * size(b) + dot(b, c) * size(a));
  }
  return sum;
}
const handleAt = (name) => cone.evaluate(`(() => { const r = ${coned}.querySelector('[data-handle="cone ${name}"] circle:not(.grip)').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
let worstAngle = 0, worstLevel = 0, positions = 0, before = '';
for (const [name, across, down] of [['P', 60, 0], ['C', 40, 30], ['P', -130, 0], ['C', -50, -60], ['P', 175, 0]]) {
  const from = await handleAt(name);
  await cone.drag(from, [from[0] + across, from[1] + down]);
  const s = await cone.evaluate(`({ state: ${coned}.boxprobeCone.state(), ...${coned}.boxprobeCone.numbers() })`), text = JSON.stringify(s.state);
  if (text !== before) positions++;
  before = text;
  const angle = patchFrom(s.state), alpha = Math.tan(Math.acos(1 - angle / (2 * Math.PI)) / 2);
  worstAngle = Math.max(worstAngle, Math.abs(s.solidAngle / angle - 1));
  worstLevel = Math.max(worstLevel, Math.abs(s.levels.integral - Math.min(Math.log2(1 + 63 * alpha), 6)));
}
check(positions === 5, 'P and C are dragged');
check(worstAngle < 0.01 && worstLevel < 0.02, `the patch from C, as a fan of triangles: solid angle off by ${(100 * worstAngle).toFixed(2)} %, level by ${worstLevel.toFixed(4)}`);
const curves = () => cone.evaluate(`({ ...${coned}.boxprobeCone.curves(), revealed: ${coned}.dataset.revealed, drawn: ${coned}.querySelectorAll('.curve').length })`);
check((await curves()).drawn === 0, 'no curve before a guess');
const area = await cone.evaluate(`(() => { const r = ${coned}.querySelector('.draws').getBoundingClientRect(); return [r.x, r.y, r.width / 480, r.height / 330]; })()`);
const chartAt = (share, level) => [area[0] + area[2] * (40 + 420 * share), area[1] + area[3] * (300 - 280 * level / 6)];
await cone.mouse('mousePressed', ...chartAt(0.01, 1));
for (let i = 1; i <= 10; i++) await cone.mouse('mouseMoved', ...chartAt(0.01 + 0.098 * i, 1 + 0.2 * i));
await cone.mouse('mouseReleased', ...chartAt(0.99, 3));
const guess = await cone.evaluate(`${coned}.boxprobeCone.guess()`);
check(guess.every((level, i) => Math.abs(level - (1 + 2 * ((i + 0.5) / 40 - 0.01) / 0.98)) < 0.08), 'the drawn line is the guess');
await cone.click(...await cone.middle('[data-control=reveal]'));
const shownCurves = await curves(), mean = shownCurves.curve.guess.reduce((sum, level, i) => sum + Math.abs(level - shownCurves.curve.integral[i]), 0) / 40;
check(shownCurves.drawn === 5 && Math.abs(shownCurves.error.guess - mean) < 1e-9, `then five curves; the guess is off by ${mean.toFixed(2)} levels`);
console.log(`  none ${shownCurves.error.none.toFixed(2)}, ratio of distances ${shownCurves.error.hdrp.toFixed(2)}, J ${shownCurves.error.J.toFixed(2)} levels from the integral`);
check(shownCurves.error.J < shownCurves.error.hdrp && shownCurves.error.hdrp < shownCurves.error.none, 'J is nearest');
check((await cone.failures()).length === 0, `no script failed ${(await cone.failures()).join(' ')}`);
await cone.screenshot(path.join(out, 'cone.png'));
await cone.size(360, 780, true);
await cone.middle('[data-figure=cone]');
check(await cone.evaluate('document.documentElement.scrollWidth') <= 360, 'a telephone is wide enough for it');
await cone.screenshot(path.join(out, 'cone-phone.png'));
await cone.close();

// Code: GLSL that is typed takes the place of the program's box projection.
const bench = await BrowserPage.open(made('bug-bench'), { width: 1280, height: 900 });
const coding = 'document.querySelector("[data-figure=code]")', code = `${coding}.boxprobeCode`;
await bench.evaluate(`document.querySelector('.waiting button').click()`);
await bench.middle('[data-figure=code]');
await bench.until(`Number(${coding}.dataset.drawn) > 0`);
const written = async (text) => {
  await bench.evaluate(`${code}.area.focus(), ${code}.area.select()`);
  const drawn = await bench.evaluate(`Number(${coding}.dataset.drawn)`);
  await bench.type(text);
  await bench.until(`Number(${coding}.dataset.drawn) > ${drawn} && ${code}.area.value === ${JSON.stringify(text)} && !${code}.waiting`, 60);
  await bench.evaluate('new Promise((resolve) => setTimeout(resolve, 400))');  // it waits for a pause
  await bench.until(`!${code}.waiting`, 60);
  return bench.evaluate(`({ difference: ${code}.difference, errors: ${coding}.dataset.errors, said: ${code}.said.textContent, list: [...${code}.errors.children].map((e) => e.textContent).join(), bad: [...${code}.lines.querySelectorAll('.bad')].map((e) => e.textContent).join(), lost: ${code}.room.gl.isContextLost() })`);
};
const body = (...lines) => `vec3 lookup(vec3 P, vec3 R, vec3 A, vec3 B)\n{\n${lines.join('\n')}\n}`;
const before0 = await bench.evaluate(`${code}.difference`);
check(before0 > 0.05, `the printed form is wrong by ${before0.toFixed(3)}`);
const codePsnr = async (technique) => {
  execFileSync(program, ['render', path.join(scenes, 'room.boxprobe.json'), '-o', png, '--size', `${width}x${height}`, '--camera', 'A', '--samples', '1', '--quiet', '--technique', technique,
    '--set', 'probes.room.faceSize=128', ...[1, 2, 3].flatMap((n) => ['--set', `objects.sphere ${n}.visible=false`])]);
  return roomPsnr(bench, `${code}.room`, png, width, height);
};
const alone = await written(body('return R;')), aloneDb = await codePsnr('infinite');
check(alone.difference > 0.05 && !alone.errors && aloneDb >= 40, `R alone, typed: off by ${alone.difference.toFixed(3)}, ${aloneDb.toFixed(1)} dB from render (at least 40)`);
const mended = await written(body('vec3 wall = mix(A, B, step(0.0, R));', 'vec3 t = (wall - P) * sign(R) / max(abs(R), 1.0e-20);', 'return P + min(max(t.x, 0.0), min(max(t.y, 0.0), max(t.z, 0.0))) * R;')), mendedDb = await codePsnr('box');
check(mended.difference < 1e-3 && /No difference/.test(mended.said) && mendedDb >= 40, `mended: off by ${mended.difference.toExponential(1)}, ${mendedDb.toFixed(1)} dB from render (at least 40)`);
const mistyped = await written(body('vec3 a = P;', '/* two', 'lines */ vec3 b = a + nothing;', 'return b;'));
check(mistyped.errors === '5' && mistyped.bad === '5' && /Line 5: .*nothing/.test(mistyped.list) && mistyped.difference === mended.difference, `an error at its line, and the picture is of the code before: ${mistyped.list}`);
check((await written(body('return R'))).errors !== '' && (await written('vec3 lookup(')).errors !== '' && (await written(' ')).errors !== '', 'a semicolon, a bracket, all of it missing: said');
const preprocessor = await written(body('return R; // # here it is none', '#define F for'));
check(preprocessor.errors === '4', 'a preprocessor line is left out, at its line');
const keptPrograms = await bench.evaluate(`${code}.room.programs.size`);
// Code that does not end.
for (const endless of ['for (;;) { R = -R; }', 'while (true) { R += P; }', 'do { R = R.yzx; } while (R.x < 2.0 || true);', 'for/**/ (int i = 0; i < 10; ) { while (i < 100) R = -R; }', 'for (int i = 0; i < 2000000000; i++) for (int j = 0; j < 2000000000; j++) R = R.zxy;']) {
  const began = Date.now(), s = await written(body(endless, 'return R;'));
  check(!s.errors && !s.lost && Date.now() - began < 60000, `${endless} ends, after ${((Date.now() - began) / 1000).toFixed(1)} s ${s.list}`);
}
check(await bench.evaluate(`${code}.room.programs.size`) <= keptPrograms + 1, 'programs of code that was written over are freed');
const counted = await written(body('int n = 0;', 'for (int i = 0; i < 5; i++) n += i;', 'int m = 4; while (m > 0) m--; do m++; while (m < 3);', 'return n == 10 && m == 3 ? R : -R;'));
check(!counted.errors && Math.abs(counted.difference - alone.difference) < 1e-6, `loops that end are as they are written: ${counted.list}`);
await bench.click(...await bench.middle('[data-control="show code"]'));
await bench.until(`!${code}.waiting && ${code}.difference < 1e-3`, 30);
await bench.middle('[data-figure=code]');
await bench.screenshot(path.join(out, 'code.png'));
check(true, 'a solution is shown on demand');
await bench.click(...await bench.middle('[data-control="reset code"]'));
await bench.until(`!${code}.waiting && ${code}.difference === ${before0}`, 30);
check((await bench.evaluate(`${code}.area.value === ${code}.data.start`)), 'Reset brings the printed form back');
await bench.evaluate(`window.taken = ${code}.room.gl.getExtension('WEBGL_lose_context'), ${code}.put(${code}.data.answer), ${code}.difference = -1, taken.loseContext()`);
await bench.until(`/taken the graphics card away/.test(${coding}.textContent)`, 20);
await bench.evaluate('new Promise((resolve) => setTimeout(resolve, 200)).then(() => { taken.restoreContext(); })');
await bench.until(`!${code}.room.gl.isContextLost() && !${code}.waiting && ${code}.difference === ${before0}`, 60);
check(await bench.evaluate(`!${coding}.querySelector('.room-said') && ${code}.area.value === ${code}.data.start`), 'a graphics card that comes back draws the code of the start again');
// Out of view its context is given back; in view again, what was written is still there.
await written(body('return R;'));
await bench.evaluate('scrollTo(0, 0)');
await bench.until(`${code}.room.gl.isContextLost()`, 20);
await bench.middle('[data-figure=code]');
await bench.until(`${code}.room.ready && !${code}.waiting`, 60);
const back = await codePsnr('infinite');
check(back >= 40 && await bench.evaluate(`/return R;/.test(${code}.area.value) && !${coding}.querySelector('.room-said')`), `scrolled away and back, the code is as it was written: ${back.toFixed(1)} dB from render (at least 40)`);
check((await bench.failures()).length === 0, `no script failed ${(await bench.failures()).join(' ')}`);
await bench.size(360, 780, true);
await bench.middle('[data-figure=code]');
check(await bench.evaluate('document.documentElement.scrollWidth') <= 360, 'a telephone is wide enough for it');
await bench.close();

// Light at a surface: the share by sines and tangents (Fresnel's own form), refraction by Snell's law, the lobe by the usual form of GGX.
for (const kind of ['fresnel', 'glass', 'lobe']) {
  const surface = await BrowserPage.open(made(kind), { width: 1280, height: 900 }), lit = `document.querySelector("[data-figure=${kind}]")`, at = `${lit}.boxprobeSurface`;
  await surface.evaluate(`document.querySelectorAll('.waiting button').forEach((button) => button.click())`);
  await surface.middle(`[data-figure=${kind}]`);
  await surface.until(`!!${at}`);
  let off = 0, turned = 0, last = null;
  if (kind === 'glass') await surface.click(...await surface.middle('[data-control=within]'));
  await surface.middle(`[data-figure=${kind}] .stand-both`);
  for (const [across, down] of [[-40, 10], [-60, 70], [70, -30], [60, -60], [-120, 110]]) {
    const from = await surface.evaluate(`(() => { const r = ${lit}.querySelector('.handle circle:not(.grip)').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
    await surface.drag(from, [from[0] + across, from[1] + down]);
    const s = await surface.evaluate(`({ ...${at}.state(), ...${at}.numbers(), lobe: [-60, -20, 0.5, 30, 70].map((out) => [out, ${at}.lobe(out)]) })`), i = s.angle * Math.PI / 180;
    if (last === null || Math.abs(last - s.angle) > 1) turned++;
    last = s.angle;
    const n = s.within ? 1 / s.index : s.index, sine = Math.sin(i) / n;
    if (sine >= 1) {
      off = Math.max(off, Math.abs(s.exact - 1), s.inside === null ? 0 : 1);
    } else {
      const t = Math.asin(sine), exact = i < 1e-3 ? ((n - 1) / (n + 1)) ** 2 : 0.5 * ((Math.sin(i - t) / Math.sin(i + t)) ** 2 + (Math.tan(i - t) / Math.tan(i + t)) ** 2);
      off = Math.max(off, Math.abs(s.exact - exact), Math.abs(s.inside - t * 180 / Math.PI) / 100);
    }
    for (const [out, value] of s.lobe) {
      const l = out * Math.PI / 180, h = (l - i) / 2, a2 = s.roughness ** 4 || 1e-8, D = a2 / (Math.PI * (Math.cos(h) ** 2 * (a2 - 1) + 1) ** 2), root = (c) => Math.sqrt(a2 + (1 - a2) * c * c), [cl, cv] = [Math.cos(l), Math.cos(i)];
      const visible = 0.5 / (cl * root(cv) + cv * root(cl));  // Smith's, for light and eye together, over 4 N.L N.V
      off = Math.max(off, kind === 'lobe' ? Math.abs(value / (D * visible * cl) - 1) : 0);
    }
  }
  check(turned >= 4 && off < 1e-9, `${kind}: the eye dragged, off by at most ${off.toExponential(1)}`);
  await surface.evaluate(`${lit}.querySelector('.handle').focus()`);
  await surface.key('ArrowLeft');
  check(await surface.evaluate(`${at}.state().angle`) !== last, 'and by an arrow key');
  check((await surface.failures()).length === 0, `no script failed ${(await surface.failures()).join(' ')}`);
  await surface.middle(`[data-figure=${kind}]`);
  await surface.screenshot(path.join(out, `${kind}.png`));
  await surface.close();
}
