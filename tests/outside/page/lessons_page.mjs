// The page of lessons in a browser: the plan's numbers against C++ for 1,000 drags, keys and touch, wipes, questions, the page
// without scripts, printed. usage: lessons_page.mjs BOXPROBE PLAN_NUMBERS SCENES OUT [DRAGS]
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check, roomPsnr } from './browser_page.mjs';
import { checkPolicy } from './viewer_limits.mjs';

const [program, oracle, scenes, out, drags = '1000'] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const file = path.resolve(out, 'floor-mirror.html');
if (!process.env.BOXPROBE_KEEP_PAGE || !existsSync(file)) execFileSync(program, ['lessons', 'floor-mirror', '-o', file, '--quiet', '--language', 'en'], { stdio: 'inherit' });
const address = 'file://' + file;

let seed = 1;
const random = () => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 2147483648; };

const page = await BrowserPage.open(address);
const plan = '(document.querySelector(".plan.live").boxprobePlan)';
await page.until('!!document.querySelector(".plan.live")');

// Formulas are outlines, with the MathML for whoever listens: nothing is cut off, and each is as large as its letters.
const formulas = await page.evaluate(`[...document.querySelectorAll('.math')].filter((m) => m.getClientRects().length).map((m) => { const svg = m.querySelector('svg'), v = svg.viewBox.baseVal, b = svg.querySelector('path').getBBox(), r = m.querySelector('math').getBoundingClientRect();
  return { inside: b.width > 0 && b.x >= v.x - 1 && b.y >= v.y - 1 && b.x + b.width <= v.x + v.width + 1 && b.y + b.height <= v.y + v.height + 1, hidden: r.width <= 1.5 && r.height <= 1.5,
    em: parseFloat(svg.style.width) * 500 / v.width, color: getComputedStyle(svg).fill === getComputedStyle(m).color, said: m.textContent.length }; })`);
check(formulas.length > 10 && formulas.every((f) => f.inside && f.hidden && Math.abs(f.em - 1) < 0.02 && f.color && f.said), `${formulas.length} formulas are outlines of the text's size and colour, none cut off`);

// Questions: what follows one waits for a guess.
const [qx, qy] = await page.middle('.question details.wrong summary');
await page.click(qx, qy);
const [rx, ry] = await page.middle('.question details.right summary');
await page.click(rx, ry);
const question = await page.evaluate(`({ open: [...document.querySelectorAll('.question details')].map((d) => d.open + d.className), tried: document.querySelector('.question').dataset.tried, score: document.querySelector('.score').textContent })`);
check(question.open.filter((o) => o === 'trueright').length === 1 && !question.open.includes('truewrong'), 'one answer is open, the right one');
check(question.tried === 'wrong' && /0 of 1 right/.test(question.score), `the first try counts: ${question.score}`);
await page.click(...await page.middle('.forget'));
const forgotten = await page.evaluate(`({ tried: document.querySelectorAll('[data-tried]').length, kept: localStorage.getItem('boxprobe-lessons'), plan: document.querySelector('.widget:has(.plan)').hidden,
  score: document.querySelector('.score').textContent, button: document.querySelector('.forget').hidden, open: document.querySelectorAll('.question details[open]').length })`);
check(forgotten.tried === 0 && !forgotten.kept && forgotten.plan && forgotten.button && !forgotten.score && !forgotten.open, 'answers are forgotten at a button, and what they showed is hidden');
await page.media({ type: 'print' });
check(await page.evaluate(`['.step:last-child', '.measured', '.exercises', '.widget:has(.plan)'].every((part) => [...document.querySelectorAll(part)].every((e) => getComputedStyle(e).display !== 'none')) && getComputedStyle(document.querySelector('.waiting')).display === 'none'`), 'on paper nothing waits for a guess');
await page.media();
await page.click(...await page.middle('.waiting button'));

// 1,000 drags of random handles to random places of their drawing.
const handles = await page.evaluate(`[...document.querySelectorAll('.plan.live .plan-view')].flatMap((view, i) => [...view.querySelectorAll('.handle')].map((h) => [i, h.dataset.handle]))`);
await page.middle('.plan.live .plan-views');
const given = [], shown = [];
for (let n = 0; n < Number(drags); n++) {
  if (n % 20 === 0) await page.evaluate(`document.querySelector('.plan.live .plan-bar button:last-child').click()`);  // walls that met hold each other
  const [view, id] = handles[Math.floor(random() * handles.length)];
  const [x, y, left, top, width, height] = await page.evaluate(`(() => { const v = document.querySelectorAll('.plan.live .plan-view')[${view}]; const s = v.querySelector('svg').getBoundingClientRect();
    const h = v.querySelector('[data-handle="${id}"] > :last-child').getBoundingClientRect(); return [h.x + h.width / 2, h.y + h.height / 2, s.x, s.y, s.width, s.height]; })()`);
  await page.drag([x, y], [left + width * (0.04 + 0.92 * random()), top + height * (0.04 + 0.92 * random())]);
  const { state, numbers, text } = await page.evaluate(`({ state: ${plan}.state(), numbers: ${plan}.numbers(), text: [...document.querySelectorAll('.plan.live tr')].find((r) => r.firstChild.textContent === 'd').children[1].textContent })`);
  given.push([...state.position, ...state.normal, ...state.eye, ...state.origin, ...state.box.min, ...state.box.max]);
  shown.push({ ...numbers, text, size: Math.hypot(...state.box.max.map((v, i) => v - state.box.min[i])) });
}
const answers = execFileSync(oracle, { input: given.map((row) => row.join(' ')).join('\n') + '\n' }).toString().trim().split('\n').map((line) => line.split(' ').map(Number));
let worst = 0, worstT = 0, otherAxis = 0, otherText = 0, moved = 0;
answers.forEach((v, n) => {
  const s = shown[n];
  for (let i = 0; i < 3; i++) {
    worst = Math.max(worst, Math.abs(v[9 + i] - s.lookup[i]) / s.size, Math.abs(v[6 + i] - s.reflection[i]));
    // A ray almost along a wall meets it far away: the error of R grows with the square of that distance.
    if (v[i] < 1e30 && s.t[i] < 1e30) worstT = Math.max(worstT, Math.abs(v[i] - s.t[i]) / Math.max(s.size, v[i] * v[i] / s.size));
  }
  worst = Math.max(worst, Math.abs(v[3] - s.distance) / s.size);
  if (v[12] !== s.axis && Math.abs(s.t[v[12]] - s.t[s.axis]) > 1e-5 * s.size) otherAxis++;
  if (Math.abs(Number(s.text.replace('−', '-')) - s.distance) > 5.1e-4) otherText++;
  if (n > 0 && given[n].some((value, i) => value !== given[n - 1][i])) moved++;
});
check(answers.length === Number(drags), `${answers.length} drags answered by the C++ numbers`);
check(moved > 0.75 * Number(drags), `${moved} of them moved something; the others pulled a handle against its stop or one that another covers`);
check(worst <= 1e-5, `d, R, H - C off by at most ${worst.toExponential(1)} of the box (1e-5)`);
check(worstT <= 1e-5, `t_x, t_y, t_z by at most ${worstT.toExponential(1)} (1e-5)`);
check(otherAxis === 0 && otherText === 0, `the same wall wins and the table says so (${otherAxis}, ${otherText})`);

// Keys and touch.
await page.evaluate(`document.querySelector('.plan.live .plan-bar button:last-child').click()`);
const before = await page.evaluate(`${plan}.state()`);
await page.evaluate(`document.querySelector('.plan.live [data-handle="C"]').focus()`);
await page.key('ArrowRight');
const keyed = await page.evaluate(`${plan}.state()`);
check(Math.abs(keyed.origin[0] - before.origin[0] - 0.05) < 1e-6, 'an arrow key moves C by .05');
const [tx, ty] = await page.middle('.plan.live [data-handle="P"] > :last-child');
await page.touch([tx, ty], [tx + 30, ty - 20]);
const touched = await page.evaluate(`${plan}.state()`);
check(touched.position[0] > keyed.position[0] + 0.05, 'a finger moves P');
await page.screenshot(path.join(out, 'plan.png'));

// Wipe.
const [wx, wy] = await page.middle('.compare');
await page.click(wx, wy);
await page.until('!!document.querySelector(".wipe")');
await page.middle('.wipe .picture');
const picture = await page.evaluate(`(() => { const r = document.querySelector('.wipe .picture').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()`);
for (const share of [0.25, 0.8]) {
  await page.drag([picture[0] + picture[2] / 2, picture[1] + picture[3] / 2], [picture[0] + share * picture[2], picture[1] + picture[3] / 2]);
  const cut = await page.evaluate(`document.querySelector('.wipe .before').style.clipPath`);
  check(Math.abs(parseFloat(cut.match(/inset\(0(?:px)? ([\d.]+)%/)[1]) - 100 * (1 - share)) < 0.6, `the wipe follows the pointer to ${share}: ${cut}`);
}
await page.screenshot(path.join(out, 'wipe.png'));
const covered = () => page.evaluate(`getComputedStyle(document.querySelector('.wipe .before')).display !== 'none'`);
const onScreen = await covered();
await page.media({ type: 'print' });
check(onScreen && !(await covered()), 'on paper an open wipe leaves the picture itself');
await page.media();

// The room, at the face size it is in the page with, as the step with the task has it: its box ends a metre behind the wall.
const [ox, oy] = await page.middle('.open-room');
await page.click(ox, oy);
await page.until('Number(document.querySelector(".room-view").dataset.drawn) > 0 || !!document.querySelector(".room-said")?.textContent', 240);
await page.screenshot(path.join(out, 'room.png'));
const png = path.join(out, 'render.png'), width = 480, height = 300;
for (const technique of ['infinite', 'box']) {
  execFileSync(program, ['render', path.join(scenes, 'room.boxprobe.json'), '-o', png, '--size', `${width}x${height}`, '--camera', 'A', '--samples', '1', '--quiet', '--technique', technique,
    '--set', 'probes.room.faceSize=128', '--set', 'probes.room.box.max=[5,3,3]', ...[1, 2, 3].flatMap((n) => ['--set', `objects.sphere ${n}.visible=false`])]);
  await page.evaluate(`(async () => { const host = document.createElement('div'); host.className = 'room-view'; document.body.append(host); host.scrollIntoView(); const from = document.querySelector('.room-view');
    await boxprobeRoom(host, JSON.parse(document.getElementById(from.dataset.scene).textContent), { antialias: false, prepare: (room) => boxprobeView(room, JSON.parse(from.dataset.view)) });
    host.boxprobePanel.redraw = () => {}; window.plainRoom = host.boxprobeRoom; plainRoom.row = plainRoom.findRow('${technique}', 'none'); })()`);
  const db = await roomPsnr(page, 'plainRoom', png, width, height);
  check(db >= 40, `the room by ${technique}: ${db.toFixed(1)} dB from render (at least 40)`);
}

// A task in its room: measured as the program does, done by dragging the slider of the face, and undone again.
const taskFile = path.resolve(out, 'fit-the-box.html');
if (!process.env.BOXPROBE_KEEP_PAGE || !existsSync(taskFile)) execFileSync(program, ['lessons', 'fit-the-box', '-o', taskFile, '--quiet', '--language', 'en'], { stdio: 'inherit' });
const taskPage = await BrowserPage.open('file://' + taskFile);
await taskPage.evaluate(`document.querySelector('.waiting button')?.click()`);
const [tox, toy] = await taskPage.middle('.open-room');
await taskPage.click(tox, toy);
await taskPage.until('!!document.querySelector(".room-view + .task .task-said") || !!document.querySelector(".room-said")?.textContent', 240);
const task = '.room-view + .task';
const measured = () => taskPage.evaluate(`({ value: Number(document.querySelector('${task}').dataset.value), done: document.querySelector('${task}').classList.contains('done'),
  start: JSON.parse(document.querySelector('${task}').dataset.task).start })`);
const begun = await measured();
check(Math.abs(begun.value - begun.start) < 1e-3, `the task begins at ${begun.value.toFixed(4)}, in the program at ${begun.start.toFixed(4)}`);
check(!begun.done, 'it is not done yet');
await taskPage.middle('[data-control="box +x"]');
// Looked up before each drag: what is said of the task may be a line longer, and the slider lies below it.
const where = () => taskPage.evaluate(`(() => { const s = document.querySelector('[data-control="box +x"]'), r = s.getBoundingClientRect(), knob = 16;
  const at = (v) => r.x + knob / 2 + (r.width - knob) * (v - s.min) / (s.max - s.min); return { y: r.y + r.height / 2, now: at(s.value), right: at(4), wrong: at(4.6) }; })()`);
let slider = await where();
await taskPage.drag([slider.now, slider.y], [slider.right, slider.y]);
await taskPage.until(`document.querySelector('${task}').classList.contains('done')`, 30);
const solved = await measured();
check(solved.value < 0.05, `dragged to the wall it is done, at ${solved.value.toFixed(4)} m`);
await taskPage.screenshot(path.join(out, 'task.png'));
slider = await where();
await taskPage.drag([slider.now, slider.y], [slider.wrong, slider.y]);
await taskPage.until(`!document.querySelector('${task}').classList.contains('done')`, 30);
check((await measured()).value > 0.1, 'dragged past it, it is not');
check((await taskPage.failures()).length === 0, `no script failed ${(await taskPage.failures()).join(' ')}`);
await taskPage.close();

// On paper and in a hand.
await page.pdf(path.join(out, 'page.pdf'));
check(statSync(path.join(out, 'page.pdf')).size > 20000, 'it prints');
await page.size(390, 844, true);
await page.middle('.plan.live');
const wide = await page.evaluate('document.documentElement.scrollWidth');
check(wide <= 390, `a telephone's width is enough (${wide} of 390)`);
await page.screenshot(path.join(out, 'phone.png'));
check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
await checkPolicy(page, 'the page of lessons');
await page.close();

// Without scripts: still plans with the same letters, answers that open.
const still = await BrowserPage.open(address, { scripts: false });
const text = await still.markup();
check((text.match(/plan-view/g) || []).length >= 2 && /H [-−] C/.test(text), 'without scripts the plan and the elevation stand there');
await still.screenshot(path.join(out, 'still.png'));
await still.close();
