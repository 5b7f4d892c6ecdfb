// What small figures share (sketch.js): two-dimensional vectors, boxes, and a room in section with a table top.
'use strict';
const boxprobePlane = (() => {
  const DEGREES = 180 / Math.PI;
  const add = (a, b) => [a[0] + b[0], a[1] + b[1]], sub = (a, b) => [a[0] - b[0], a[1] - b[1]], scaled = (a, s) => [a[0] * s, a[1] * s];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1], length = (a) => Math.hypot(a[0], a[1]), unit = (a) => scaled(a, 1 / (length(a) || 1));
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high), within = (p, box, gap = 0) => p.map((v, i) => clamp(v, box.min[i] + gap, box.max[i] - gap));
  const degrees = (a, b) => Math.abs(Math.atan2(a[0] * b[1] - a[1] * b[0], dot(a, b))) * DEGREES;
  const along = (from, to, count, value) => Array.from({ length: count + 1 }, (_, i) => { const x = from + (to - from) * i / count; return [x, value(x)]; });
  const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;
  const percent = (v, digits = 0) => (100 * v).toFixed(digits);

  /** Where a ray from within leaves a box: { d, at, axis }. */
  function exit(p, r, box) {
    const t = [0, 1].map((i) => (Math.abs(r[i]) > 1e-12 ? Math.max(((r[i] > 0 ? box.max[i] : box.min[i]) - p[i]) / r[i], 0) : Infinity)), axis = t[0] < t[1] ? 0 : 1;
    return { d: t[axis], at: add(p, scaled(r, t[axis])), axis };
  }
  /** Where a ray from outside meets a box: its distance, or nothing. */
  function meets(p, r, box) {
    let near = 0, far = Infinity;
    for (let i = 0; i < 2; i++) {
      if (Math.abs(r[i]) < 1e-12) {
        if (p[i] < box.min[i] || p[i] > box.max[i]) return Infinity;
        continue;
      }
      const a = (box.min[i] - p[i]) / r[i], b = (box.max[i] - p[i]) / r[i];
      near = Math.max(near, Math.min(a, b));
      far = Math.min(far, Math.max(a, b));
    }
    return near > 1e-9 && near <= far ? near : Infinity;
  }
  const inFloor = (eye, x) => unit([x - eye[0], eye[1]]);  // the view's direction, mirrored in a floor at 0

  // A room in section, with a table top.
  const SECTION = { min: [-3, 0], max: [3, 3.7] }, OVER = [-3.15, 3.15, -0.15, 3.95];
  const shelfOf = (s) => ({ min: [s.shelf[0] - 0.8, s.shelf[1] - 0.12], max: [s.shelf[0] + 0.8, s.shelf[1] + 0.12] });
  const firstMet = (p, r, shelf) => { const wall = exit(p, r, SECTION), thing = meets(p, r, shelf); return thing < wall.d ? { d: thing, at: add(p, scaled(r, thing)), thing: true } : { ...wall, thing: false }; };
  const sees = (from, at, shelf) => { const way = sub(at, from); return Math.abs(firstMet(from, unit(way), shelf).d - length(way)) < 1e-4; };
  const moveShelf = (s, to) => { s.shelf = within(to, { min: [-2.1, 0.5], max: [2.1, 3.4] }); };
  /** The place on or outside of the shelf that is next to `p`: from within, rays would pass it. */
  function offShelf(p, s) {
    const { min, max } = shelfOf(s), gap = 0.02, ways = [0, 1].flatMap((i) => [[i, min[i] - gap], [i, max[i] + gap]]);
    if (p.some((v, i) => v <= min[i] - gap || v >= max[i] + gap)) return p;
    const [axis, to] = ways.reduce((best, way) => (Math.abs(way[1] - p[way[0]]) < Math.abs(best[1] - p[best[0]]) ? way : best));
    return p.map((v, i) => (i === axis ? to : v));
  }
  /** Everything that `from` cannot see behind the shelf. */
  function shade(drawing, from, shelf) {
    const count = 720;
    let run = [];
    const flush = () => {
      if (run.length > 1) drawing.path([...run.map((r) => r[0]), ...run.map((r) => r[1]).reverse()], 'unseen', true);
      run = [];
    };
    for (let i = 0; i <= count; i++) {
      const r = [Math.cos(2 * Math.PI * i / count), Math.sin(2 * Math.PI * i / count)], thing = meets(from, r, shelf);
      if (thing === Infinity) flush();
      else run.push([add(from, scaled(r, thing)), exit(from, r, SECTION).at]);
    }
    flush();
  }
  function section(drawing, shelf) {
    drawing.rect(SECTION.min, SECTION.max, 'room-outline');
    if (shelf) drawing.rect(shelf.min, shelf.max, 'thing');
  }


  return { DEGREES, add, sub, scaled, dot, length, unit, clamp, within, degrees, along, mean, percent, exit, inFloor, SECTION, OVER, shelfOf, firstMet, sees, moveShelf, offShelf, shade, section };
})();
