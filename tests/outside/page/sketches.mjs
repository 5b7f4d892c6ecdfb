// The small figures of the lessons (data/web/sketches.js) in a page of their scripts alone, dragged by real events. What each prints is
// computed here in another way: by the compiled shader files, by crossing the edges of what stands there, by unfolding mirrors, by sums
// over the sphere, by areas under the curves. Called by figures.mjs.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check } from './browser_page.mjs';

const KINDS = ['ball', 'impostor', 'mirrors', 'harmonics', 'seam', 'sky', 'screen', 'round', 'corner'];
const HALL = [[-4, -2.7], [4, 2.7]], ROOM = [[-3, 0], [3, 3.7]];

const sub = (a, b) => [a[0] - b[0], a[1] - b[1]], cross = (a, b) => a[0] * b[1] - a[1] * b[0];
const apart = (a, b) => { const by = (Math.atan2(a[1], a[0]) - Math.atan2(b[1], b[0])) * 180 / Math.PI; return Math.abs(((by + 540) % 360) - 180); };
const edges = ([low, high]) => { const c = [low, [high[0], low[1]], high, [low[0], high[1]]]; return c.map((p, i) => [p, c[(i + 1) % 4]]); };
/** Distances along a ray, in its own lengths, at which it crosses segments. */
const crossings = (from, along, segments) => segments.map(([a, b]) => { const side = sub(b, a), n = cross(along, side), t = cross(sub(a, from), side) / n, u = cross(sub(a, from), along) / n; return n !== 0 && u >= -1e-9 && u <= 1 + 1e-9 ? t : -1; }).filter((t) => t > 1e-7);
const ends = (from, along, segments) => { const t = Math.min(...crossings(from, along, segments)); return [from[0] + t * along[0], from[1] + t * along[1]]; };
const open = (from, to, thing) => !crossings(from, sub(to, from), edges(thing)).some((t) => t < 1 - 1e-6);
const reflected = (eye, x) => [x - eye[0], eye[1]];  // by the mirrored eye
const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;
const shelfOf = ({ shelf }) => [[shelf[0] - 0.8, shelf[1] - 0.12], [shelf[0] + 0.8, shelf[1] + 0.12]];
const inShelf = (p, s) => shelfOf(s)[0].every((low, i) => p[i] > low && p[i] < shelfOf(s)[1][i]);

/** P, R, distance and H - C by the compiled formulas, for points of a plane: `flat` 1 for a section, 2 for a plan. */
function compiled(oracle, lines, flat, bevel = 0) {
  const space = (v, other = 0) => (flat === 1 ? [v[0], v[1], other] : [v[0], other, v[1]]);
  const input = lines.map(({ position, normal, eye, origin, box }) => [...space(position), ...space(normal), ...space(eye), ...space(origin), ...space(box[0], -50), ...space(box[1], 50)].join(' '));
  return execFileSync(oracle, bevel ? [String(bevel)] : [], { input: input.join('\n') + '\n' }).toString().trim().split('\n').map((line) => line.split(' ').map(Number))
    .map((v) => ({ distance: v[3], reflection: [v[6], v[6 + flat]], lookup: [v[9], v[9 + flat]] }));
}

// For each kind: handles that are dragged, in pixels of the page; the largest error of what it computes; all numbers that it prints, in the
// sentence's order (`off` has compared them before); phrases that it must say, or must not. `onto`: handles dragged on to another, and
// whether one would then be inside of what stands there.
const OTHERS = {
  ball: {
    drags: [['eye', 40, -60], ['C', -90, 20], ['P', 20, 40], ['ball', -40, 30], ['eye', 160, 90]],
    clicks: { 1: 'sampled N', 3: 'sampled box' },
    onto: { pairs: [['eye', 'ball'], ['ball', 'eye']], inside: (s) => Math.hypot(...sub(s.eye, s.ball)) < 0.75 },
    off(s, n, oracle) {
      const to = sub(s.eye, s.ball), middle = Math.atan2(to[1], to[0]), most = Math.acos(0.75 / Math.hypot(...to));
      const at = (angle) => {
        const position = [s.ball[0] + 0.75 * Math.cos(angle), s.ball[1] + 0.75 * Math.sin(angle)], v = sub(s.eye, position), r = 2 * angle - Math.atan2(v[1], v[0]), along = [Math.cos(r), Math.sin(r)];
        const right = sub(ends(position, along, edges(HALL)), s.origin);
        return { position, error: apart({ N: [Math.cos(angle), Math.sin(angle)], R: along, box: right }[s.sampled], right) };
      };
      const all = mean(Array.from({ length: 96 }, (_, i) => at(middle + most * (2 * (i + 0.5) / 96 - 1)).error)), own = at(Math.atan2(n.normal[1], n.normal[0]));
      const [c] = compiled(oracle, [{ position: n.position, normal: n.normal, eye: s.eye, origin: s.origin, box: HALL }], 2);
      return { off: Math.max(Math.abs(all - n.mean), Math.abs(own.error - n.error), Math.abs(c.distance - n.distance), ...[0, 1].flatMap((i) => [Math.abs(c.reflection[i] - n.reflection[i]), Math.abs(c.lookup[i] - n.right[i])])),
        prints: s.sampled === 'box' ? [] : [own.error.toFixed(1), all.toFixed(1)] };
    },
  },
  impostor: {
    drags: [['C', 30, 80], ['table', -60, 20], ['P', 70, 0], ['eye', 20, -40], ['C', 60, 60]],
    onto: { pairs: [['C', 'table'], ['table', 'C']], inside: (s) => inShelf(s.origin, s) },
    off(s, n, oracle) {
      const shelf = shelfOf(s), at = (x) => {
        const truth = ends([x, 0], reflected(s.eye, x), [...edges(shelf), ...edges(ROOM)]), hit = ends([x, 0], reflected(s.eye, x), edges(ROOM));
        return { truth, error: apart(sub(hit, s.origin), sub(truth, s.origin)), seen: open(s.origin, truth, shelf) };
      };
      const floor = Array.from({ length: 299 }, (_, i) => at(-2.98 + 5.96 * i / 298)), own = at(s.place), all = mean(floor.map((p) => p.error)), unseen = mean(floor.map((p) => (p.seen ? 0 : 1)));
      const [c] = compiled(oracle, [{ position: [s.place, 0], normal: [0, 1], eye: s.eye, origin: s.origin, box: ROOM }], 1);
      return { off: Math.max(Math.abs(own.error - n.error), Math.abs(all - n.mean), Math.abs(unseen - n.unseen), own.seen === n.seen ? 0 : 1, Math.abs(c.distance - n.distance), ...[0, 1].map((i) => Math.abs(c.lookup[i] - n.lookup[i]))),
        prints: [...(n.met ? [own.error.toFixed(1)] : []), all.toFixed(1), (100 * unseen).toFixed(0)] };
    },
  },
  mirrors: {
    drags: [['P', 0, 30], ['mirror', -60, 0], ['eye', -20, -30], ['P', 0, -90], ['mirror', 70, 0]],
    slides: { 1: ['bounces', 1], 3: ['bounces', 12] },
    off(s, n) {
      // The straight line through rooms that are mirrored again and again.
      const eye = [Math.min(s.eye[0], s.wide - 0.1), s.eye[1]], count = (height) => {
        const slope = (height - eye[1]) / (s.wide - eye[0]), beyond = Math.abs(slope) < 1e-9 ? Infinity : ((slope > 0 ? 3.6 : 0) - height) / slope;
        return Math.min(1 + Math.floor(beyond / s.wide), 60);
      };
      const counts = Array.from({ length: 180 }, (_, i) => count(3.6 * (i + 0.5) / 180)), light = counts.map((c) => s.share ** c), all = light.reduce((a, b) => a + b);
      const lack = light.filter((_, i) => counts[i] > s.bounces).reduce((a, b) => a + b, 0) / all, black = counts.filter((c) => c > s.bounces).length / 180;
      return { off: Math.max(Math.abs(count(s.height) - n.count), Math.abs(lack - n.lacks[s.bounces - 1]), Math.abs(black - n.black)), prints: [String(count(s.height)), String(s.bounces), (100 * black).toFixed(0), (100 * lack).toFixed(1)],
        says: [[' 1 reflections', false], ['1 reflection.', count(s.height) === 1], ['With 1 bounce its', s.bounces === 1], ['still black', count(s.height) > s.bounces]] };
    },
  },
  harmonics: {
    drags: [['lamp', 70, 60], ['edge', 20, 30], ['normal', -90, 40], ['edge', -30, 60], ['lamp', -120, -20]],
    slides: { 1: ['degree', 0], 3: ['degree', 3] },
    bound: 2e-3,
    off(s, n) {
      const P = [() => 1, (x) => x, (x) => 1.5 * x * x - 0.5, (x) => 2.5 * x ** 3 - 1.5 * x, (x) => (35 * x ** 4 - 30 * x * x + 3) / 8];
      const integral = (f, a, b, count = 4000) => { let sum = 0; for (let i = 0; i < count; i++) sum += f(a + (b - a) * (i + 0.5) / count); return sum * (b - a) / count; };
      /** Light over pi: all directions of the lamp, each by its cosine to the normal. */
      const light = (away, rings = 400) => integral((ring) => { const [c, r] = [Math.cos(ring), Math.sin(ring)]; return r * integral((turn) => Math.max(c * Math.cos(away) + r * Math.sin(away) * Math.cos(turn), 0), 0, 2 * Math.PI, rings); }, 0, s.wide, rings) / Math.PI;
      const away = Math.abs(((s.normal - s.lamp) * 180 / Math.PI + 540) % 360 - 180) * Math.PI / 180, most = light(0);
      const parts = P.slice(0, s.degree + 1).map((p, l) => 2 * integral((x) => x * p(x), 0, 1) * (2 * l + 1) / 2 * integral(p, Math.cos(s.wide), 1) / most);
      const kept = (away) => parts.reduce((sum, part, l) => sum + part * P[l](Math.cos(away)), 0);
      const worst = Math.max(...Array.from({ length: 181 }, (_, i) => i * Math.PI / 180).map((a) => Math.abs(kept(a) - light(a, 160) / most))), [lit, by, far] = [n.light, n.kept, n.worst].map((v) => (100 * v).toFixed(1));
      return { off: Math.max(Math.abs(light(away) / most - n.light), Math.abs(kept(away) - n.kept), Math.abs(worst - n.worst), Math.abs(away * 180 / Math.PI - n.away)),
        prints: [n.away.toFixed(0), lit, ...(s.degree === 0 ? ['1', by] : [String((s.degree + 1) ** 2), by]), ...(n.kept < -0.005 ? ['0'] : []), far], says: [['1 numbers', false], ['1 number says', s.degree === 0]] };
    },
  },
  seam: {
    drags: [['texel 3', 0, 40], ['texel 4', 0, -20], ['texel 1', 0, -50], ['P', 30, 0], ['texel 6', 0, 60]],
    clicks: { 1: 'lookup fixup', 3: 'lookup seamless', 4: 'lookup alone' },
    bound: 2e-4,
    off(s, n) {
      const gap = Math.abs(s.values[4] - s.values[3]), area = { alone: 0.25, fixup: 1.25, seamless: 0 }[s.lookup], jump = s.lookup === 'alone' ? gap : 0;  // areas under triangles and trapezia
      const pull = s.lookup === 'fixup' ? (s.values[4] - s.values[3]) / 4 : 0, at = s.values.map((v, i) => v + ([0, 0, 1, 2, -2, -1, 0, 0][i]) * pull), x = s.place + 3.5, low = Math.min(Math.max(Math.floor(x), 0), 6);
      const within = s.lookup !== 'seamless' && low === 3 ? at[s.place < 0 ? 3 : 4] : at[low] + Math.min(Math.max(x - low, 0), 1) * (at[low + 1] - at[low]);
      return { off: Math.max(Math.abs(jump - n.jump), Math.abs(area * gap / 7.98 - n.off), Math.abs(within - n.value)), prints: [(100 * n.jump).toFixed(0), (100 * n.off).toFixed(1), n.value.toFixed(3)] };
    },
  },
  sky: {
    drags: [['P', 40, 0], ['C', 60, 60], ['eye', 30, -20], ['sill', 0, -20], ['lintel', 0, 60]],
    slides: { 1: ['far', 0.4], 3: ['far', 0.75] },
    off(s, n, oracle) {
      const along = reflected(s.eye, s.place), hit = ends([s.place, 0], along, edges(ROOM)), through = Math.abs(hit[0] - 3) < 1e-9 && hit[1] > s.low && hit[1] < s.high, away = 15 * s.far * s.far / (1 - s.far);
      const met = !through ? sub(hit, s.origin) : s.far === 1 ? along : sub([3 + away, along[1] / along[0] * (3 + away - s.place)], s.origin);
      const [c] = compiled(oracle, [{ position: [s.place, 0], normal: [0, 1], eye: s.eye, origin: s.origin, box: ROOM }], 1), box = apart(sub(hit, s.origin), met), bare = apart(along, met);
      const height = s.origin[1] + met[1] / met[0] * (3 - s.origin[0]), hidden = through && !(height > s.low && height < s.high);  // where C's line crosses the window's plane
      return { off: Math.max(through === n.through ? 0 : 1, hidden === n.hidden ? 0 : 1, Math.abs(box - n.boxError), Math.abs(bare - n.bareError), Math.abs(c.distance - n.distance), ...[0, 1].map((i) => Math.abs(c.lookup[i] - n.lookup[i]))),
        prints: [...(through ? [box.toFixed(1)] : []), bare.toFixed(1)], says: [['a wall is in between', hidden]] };
    },
  },
  screen: {
    drags: [['P', 60, 0], ['table', -50, -40], ['look', 40, -50], ['eye', 20, 40], ['P', 90, 0], ['look', -60, -190]],
    onto: { pairs: [['eye', 'table'], ['table', 'eye']], inside: (s) => inShelf(s.eye, s) },
    off(s, n) {
      const shelf = shelfOf(s), shown = (at) => apart(sub(at, s.eye), sub(s.look, s.eye)) < 30 && open(s.eye, at, shelf), at = (x) => {
        const thing = crossings([x, 0], reflected(s.eye, x), edges(shelf)), truth = ends([x, 0], reflected(s.eye, x), [...edges(shelf), ...edges(ROOM)]);
        return { visible: shown([x, 0]), screen: shown(truth), box: !thing.length };
      };
      const floor = Array.from({ length: 597 }, (_, i) => at(-2.98 + 5.96 * i / 596)).filter((p) => p.visible), share = (of) => floor.filter(of).length / (floor.length || 1), own = at(s.place);
      const shares = [share((p) => p.screen), share((p) => !p.screen && p.box), share((p) => !p.screen && !p.box)];
      return { off: Math.max(...['visible', 'screen', 'box'].map((key) => (own[key] === n[key] ? 0 : 1)), ...[n.screenShare, n.boxShare, n.noneShare].map((v, i) => Math.abs(v - shares[i]))), prints: floor.length ? shares.map((v) => (100 * v).toFixed(0)) : [], says: [['No floor', !floor.length]] };
    },
  },
  round: {
    drags: [['R', -30, 20], ['radius', -40, 0], ['P', -110, 60], ['P', -40, 20], ['R', 10, 60], ['radius', 70, 0]],
    off(s, n, oracle) {
      const box = [[-3, -2], [3, 2]], one = { position: s.place, normal: n.direction, eye: [s.place[0] + n.direction[0], s.place[1] + n.direction[1]], origin: [0, 0], box };
      const sharp = compiled(oracle, [one], 2)[0].distance, rounded = compiled(oracle, [one], 2, s.radius)[0].distance;
      const radius = Math.min(s.radius, 3 - Math.abs(s.place[0]) + 2 - Math.abs(s.place[1]), 2);
      return { off: Math.max(Math.abs(sharp - n.sharp), Math.abs(rounded - n.rounded), Math.abs(radius - n.radius)), prints: [n.sharp.toFixed(3), n.rounded.toFixed(3), radius.toFixed(2), (n.sharp - n.rounded).toFixed(3)] };
    },
  },
  corner: {
    drags: [['P', -60, 0], ['C', 70, -20], ['sill', 0, 30], ['eye', 40, 20], ['P', 40, 0]],
    slides: { 2: ['rough', 0.4], 3: ['power', 2], 4: ['rough', 0.95] },
    bound: 1e-3,
    off(s, n) {
      const angle = (v) => Math.atan2(v[1], v[0]), bright = (from, low, high, count = 8000) => mean(Array.from({ length: count }, (_, i) => {
        const a = low + (high - low) * (i + 0.5) / count, at = ends(from, [Math.cos(a), Math.sin(a)], edges(ROOM));
        return Math.abs(at[0] - 3) < 1e-9 && at[1] > s.low && at[1] < s.high ? 1 : 0;
      }));
      const fromBelow = (v) => Math.atan2(-v[0], v[1]) + Math.PI / 2;  // the same angle, cut where nothing but floor lies
      const at = (x, count) => {
        const along = reflected(s.eye, x), half = 2 * Math.atan(s.rough ** 2), [low, high] = [Math.max(angle(along) - half, 0), Math.min(angle(along) + half, Math.PI)], hit = ends([x, 0], along, edges(ROOM));
        const lookup = angle(sub(hit, s.origin)), open = Math.min(s.factor * Math.exp(s.power * Math.log(Math.hypot(...sub(hit, [x, 0])))), 1), one = bright(s.origin, lookup - half, lookup + half, count);
        const rim = [low, high].map((a) => fromBelow(sub(ends([x, 1e-12], [Math.cos(a), Math.sin(a)], edges(ROOM).slice(1)), s.origin)));
        return { truth: bright([x, 0], low, high, count), one, open, darkened: one * open, level: bright(s.origin, ...rim, count) };
      };
      const own = at(s.place, 8000), floor = Array.from({ length: 291 }, (_, i) => at(-2.9 + 5.8 * i / 290, 400)), keys = ['one', 'darkened', 'level'];
      const errors = keys.map((key) => mean(floor.map((p) => Math.abs(p[key] - p.truth)))), [right, one, darkened, level] = ['truth', ...keys].map((key) => (100 * n[key]).toFixed(0));
      return { off: Math.max(...['truth', 'open', ...keys].map((key) => Math.abs(own[key] - n[key])), ...keys.map((key, i) => Math.abs(errors[i] - n.errors[key]))),
        prints: [right, one, n.open.toFixed(2), darkened, level, ...keys.map((key) => (100 * n.errors[key]).toFixed(1))] };
    },
  },
};

/** `web`: the folder of scripts. */
export async function checkSketches(web, oracle, out) {
  const text = (name) => readFileSync(path.join(web, name), 'utf8'), file = path.resolve(out, 'sketches.html');
  const scripts = ['drawing.js', 'sketch.js', 'plane.js', 'sketches.js', 'sketches_more.js'].map((name) => `<script>${text(name)}</script>`).join('');
  writeFileSync(file, `<!DOCTYPE html><html><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><style>${text('page.css')}</style></head><body>${
    KINDS.map((kind) => `<div class="widget"><h4>${kind}</h4><div class="figure-live" data-sketch="${kind}"></div></div>`).join('')}${scripts}<script>for (const host of document.querySelectorAll('[data-sketch]')) boxprobeSketch(host, host.dataset.sketch);</script></body></html>`);
  const page = await BrowserPage.open('file://' + file, { width: 1280, height: 900 });
  for (const kind of KINDS) {
    const host = `document.querySelector("[data-sketch=${kind}]")`, at = `${host}.boxprobeSketch`, { drags, clicks = {}, slides = {}, onto, bound = 1e-4, off } = OTHERS[kind];
    const settle = () => page.evaluate('new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))');
    const now = () => page.evaluate(`({ state: ${at}.state(), numbers: ${at}.numbers(), said: ${host}.querySelector('.figure-said').textContent })`);
    const grip = (name) => page.evaluate(`(() => { const r = ${host}.querySelector('[data-handle="${name}"] circle:not(.grip)').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
    let worst = 0, unsaid = '', moved = 0, last = '';
    const measure = async () => {
      const { state, numbers, said } = await now(), other = off(state, numbers, oracle), text = JSON.stringify(state);
      if (text !== last) moved++;
      last = text;
      worst = Math.max(worst, other.off);
      const numbersSaid = said.match(/-?\d+(\.\d+)?/g) ?? [], phrase = (other.says ?? []).find(([words, wanted]) => said.includes(words) !== wanted);
      if (numbersSaid.join() !== other.prints.join()) unsaid = `${other.prints.join()} in "${said}"`;
      if (phrase) unsaid = `${phrase.join(': ')} in "${said}"`;
    };
    await measure();
    for (const [i, [name, across, down]] of drags.entries()) {
      await page.middle(`[data-sketch=${kind}] .stand-both`);
      const from = await grip(name);
      await page.drag(from, [from[0] + across, from[1] + down]);
      if (clicks[i]) await page.click(...await page.middle(`[data-sketch=${kind}] [data-control="${clicks[i]}"]`));
      if (slides[i]) await page.evaluate(`(() => { const input = ${host}.querySelector('[data-control="${slides[i][0]}"]'); input.value = ${slides[i][1]}; input.dispatchEvent(new Event('input')); })()`);
      await settle();
      await measure();
    }
    check(moved === drags.length + 1 && worst < bound && !unsaid, `${kind}: each of ${drags.length} drags moves it, off by at most ${worst.toExponential(1)} ${unsaid && `not said: ${unsaid}`}`);
    for (const [one, other] of onto?.pairs ?? []) {
      await page.drag(await grip(one), await grip(other));
      await settle();
      check(!onto.inside((await now()).state), `${one} dragged on to ${other} stays outside of it`);
    }
    const [first] = drags[0];
    await page.evaluate(`${host}.querySelector('[data-handle="${first}"]').focus()`);
    const before = JSON.stringify((await now()).state);
    for (const key of ['ArrowLeft', 'ArrowUp', 'ArrowUp']) await page.key(key);
    await settle();
    check(JSON.stringify((await now()).state) !== before, 'and by arrow keys');
    await page.click(...await page.middle(`[data-sketch=${kind}] [data-control="start again"]`));
    await settle();
    check(JSON.stringify((await now()).state) === await page.evaluate(`JSON.stringify(boxprobeSketchKinds.${kind}.start)`), 'Start again');
  }
  await page.middle('[data-sketch=round]');
  const finger = await page.evaluate(`(() => { const r = document.querySelector('[data-sketch=round] [data-handle=P] circle').getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
  const placed = await page.evaluate(`document.querySelector('[data-sketch=round]').boxprobeSketch.state().place[0]`);
  await page.touch(finger, [finger[0] + 40, finger[1]]);
  check(await page.evaluate(`document.querySelector('[data-sketch=round]').boxprobeSketch.state().place[0]`) > placed + 0.1, 'a finger moves a handle');
  await page.size(360, 780, true);
  check(await page.evaluate('document.documentElement.scrollWidth') <= 360, 'a telephone is wide enough for all of them');
  check((await page.failures()).length === 0, `no script failed ${(await page.failures()).join(' ')}`);
  await page.close();
}
