// As sketches.js, for the lessons after the first five.
'use strict';
(() => {
  const { say } = boxprobeDrawing, kinds = boxprobeSketchKinds;
  const { DEGREES, add, sub, scaled, length, unit, clamp, within, degrees, along, mean, percent } = boxprobePlane;
  const { exit, inFloor, SECTION, OVER, shelfOf, firstMet, sees, moveShelf, offShelf, section } = boxprobePlane;

  // Mirrors in mirrors: two mirrors that face each other; a ray leaves between them at the ceiling or at the floor.
  const MOST_BOUNCES = 12;
  kinds.mirrors = {
    start: { wide: 2.6, eye: [0.7, 0.9], height: 1.5, bounces: 2, share: 0.9 },
    make(sketch) {
      this.hall = sketch.drawing(say('Section of a hall between two mirrors'), [-0.2, 4.4, -0.1, 3.75]);
      this.chart = sketch.chart(say('Light that is missing in the right mirror, over the number of bounces'), [0.4, MOST_BOUNCES + 0.6, 0, 1]);
      this.hall.handle('eye', say('the eye'), 'eye', (s) => [Math.min(s.eye[0], s.wide - 0.1), s.eye[1]], (s, to) => { s.eye = [clamp(to[0], 0.1, s.wide - 0.1), clamp(to[1], 0.1, 3.5)]; }, say('eye'));
      this.hall.handle('mirror', say('the right mirror'), 'wall', (s) => [s.wide, 0.25], (s, to) => { s.wide = clamp(to[0], 0.6, 4.2); });
      this.hall.handle('P', say('P, a point of the right mirror'), 'P', (s) => [s.wide, s.height], (s, to) => { s.height = clamp(to[1], 0.02, 3.58); }, 'P', [14, 6]);
      sketch.slide(say('bounces'), 'bounces', 1, MOST_BOUNCES, 1, (v) => String(v));
      sketch.slide(say('share that a mirror reflects'), 'share', 0.3, 1, 0.01);
    },
    /** The way of a ray from the eye by way of the right mirror. */
    way(s, height) {
      const eye = [Math.min(s.eye[0], s.wide - 0.1), s.eye[1]], points = [eye, [s.wide, height]], most = 60;
      let r = unit(sub(points[1], eye)), p = points[1], count = 1;
      for (; count <= most; count++) {
        r = [-r[0], r[1]];
        const across = (r[0] < 0 ? p[0] : s.wide - p[0]) / Math.abs(r[0]), up = r[1] > 1e-12 ? (3.6 - p[1]) / r[1] : r[1] < -1e-12 ? -p[1] / r[1] : Infinity;
        p = add(p, scaled(r, Math.min(across, up)));
        points.push(p);
        if (up <= across) break;
      }
      return { points, count: Math.min(count, most), more: count > most };
    },
    numbers(s) {
      const counts = Array.from({ length: 180 }, (_, i) => this.way(s, 3.6 * (i + 0.5) / 180).count), light = counts.map((count) => s.share ** count), all = light.reduce((a, b) => a + b, 0);
      const lacks = Array.from({ length: MOST_BOUNCES }, (_, i) => light.reduce((sum, v, k) => sum + (counts[k] > i + 1 ? v : 0), 0) / all);
      return { ...this.way(s, s.height), lacks, black: counts.filter((count) => count > s.bounces).length / counts.length };
    },
    draw(sketch, n) {
      const s = sketch.state, { hall, chart } = this;
      hall.rect([0, 3.6], [s.wide, 3.7], 'thing');
      hall.line([0, 0], [s.wide, 0], 'floor-line');
      for (const x of [0, s.wide]) hall.line([x, 0], [x, 3.6], 'glass-line');
      n.points.slice(1).forEach((p, i) => hall.line(n.points[i], p, i === 0 ? 'view' : i <= s.bounces ? 'reflected' : 'dark-ray', 3));
      const last = n.count > s.bounces ? n.points[s.bounces + 1] : n.points[n.points.length - 1];
      hall.circle(last, 7, n.count > s.bounces ? 'black-end' : 'right-point');
      chart.grid(n.lacks.map((_, i) => [i + 1, String(i + 1)]), [[0, '0 %'], [0.5, '50 %'], [1, '100 %']]);
      n.lacks.forEach((lack, i) => chart.rect([i + 0.7, 0], [i + 1.3, lack], i + 1 === s.bounces ? 'bar chosen' : 'bar'));
      const needs = n.more ? say('This ray needs more than {0} reflections.', n.count) : n.count === 1 ? say('This ray needs 1 reflection.') : say('This ray needs {0} reflections.', n.count);
      const ends = n.count > s.bounces ? (s.bounces === 1 ? say('With 1 bounce its end is still black.') : say('With {0} bounces its end is still black.', s.bounces))
        : s.bounces === 1 ? say('With 1 bounce its end is seen.') : say('With {0} bounces its end is seen.', s.bounces);
      return `${needs} ${ends} ` + say('{0} % of the right mirror is black; {1} % of its light is missing.', percent(n.black), percent(n.lacks[s.bounces - 1], 1));
    },
  };

  // Diffuse light of one round lamp, whole and by harmonics. Angles from the upright, clockwise; `lamp` its middle, `wide` its radius.
  const COSINE = [1, 2 / 3, 1 / 4, 0, -1 / 24];  // what the cosine leaves of each degree
  function legendre(degree, x) {
    let [a, b] = [1, x];
    for (let l = 1; l < degree; l++) [a, b] = [b, ((2 * l + 1) * x * b - l * a) / (l + 1)];
    return degree === 0 ? 1 : b;
  }
  /** Light of a lamp of radiance 1 over the cap of `wide`, on a matte surface whose normal is `away` from its middle, over pi. */
  function capLight(wide, away) {
    const count = 256;
    let sum = 0;
    for (let i = 0; i < count; i++) {
      const ring = wide * (i + 0.5) / count, a = Math.cos(ring) * Math.cos(away), b = Math.sin(ring) * Math.abs(Math.sin(away));
      const up = a >= b ? a : a <= -b ? 0 : (a * Math.acos(-a / b) + Math.sqrt(Math.max(b * b - a * a, 0))) / Math.PI;
      sum += up * Math.sin(ring);
    }
    return 2 * sum * wide / count;
  }
  function capHarmonics(wide, away, degree) {
    const edge = Math.cos(wide);
    let sum = (1 - edge) / 2;
    for (let l = 1; l <= degree; l++) sum += COSINE[l] * 0.5 * (legendre(l - 1, edge) - legendre(l + 1, edge)) * legendre(l, Math.cos(away));
    return sum;
  }
  const turn = (angle, far = 1) => [far * Math.sin(angle), far * Math.cos(angle)], angleOf = ([x, y]) => Math.atan2(x, y);
  kinds.harmonics = {
    start: { lamp: -0.6, wide: 0.35, normal: 0.5, degree: 2 },
    make(sketch) {
      this.round = sketch.drawing(say('All directions about C: the lamp on the circle, the light for each normal within'), [-1.75, 1.75, -1.2, 1.2]);
      this.chart = sketch.chart(say('Light on a matte surface, over the angle from its normal to the lamp'), [0, 180, -0.4, 1.4]);
      this.round.handle('lamp', say('the lamp'), 'wall', (s) => turn(s.lamp), (s, to) => { s.lamp = angleOf(to); });
      this.round.handle('edge', say('the lamp’s edge'), 'C', (s) => turn(s.lamp + s.wide), (s, to) => { const by = angleOf(to) - s.lamp; s.wide = clamp(Math.abs(Math.atan2(Math.sin(by), Math.cos(by))), 0.05, 2.5); });
      this.round.handle('normal', say('N, the surface’s normal'), 'P', (s) => turn(s.normal, 0.78), (s, to) => { s.normal = angleOf(to); }, 'N');
      sketch.keys([['integral', say('exact')], ['hdrp', say('by harmonics')]]);
      sketch.slide(say('harmonics up to degree'), 'degree', 0, 4, 1, (v) => (v === 0 ? say('0: 1 number') : say('{0}: {1} numbers', v, (v + 1) ** 2)));
    },
    numbers(s) {
      const most = capLight(s.wide, 0), away = Math.abs(Math.atan2(Math.sin(s.normal - s.lamp), Math.cos(s.normal - s.lamp)));
      const light = (a) => capLight(s.wide, a) / most, kept = (a) => capHarmonics(s.wide, a, s.degree) / most, all = along(0, Math.PI, 180, (a) => Math.abs(kept(a) - light(a)));
      return { away: away * DEGREES, light: light(away), kept: kept(away), worst: Math.max(...all.map((p) => p[1])), exactOver: along(0, Math.PI, 180, light), keptOver: along(0, Math.PI, 180, kept) };
    },
    draw(sketch, n) {
      const s = sketch.state, { round, chart } = this;
      round.path(along(0, 2 * Math.PI, 120, (a) => a).map(([a]) => turn(a)), 'grid ring-line');
      round.path(along(s.lamp - s.wide, s.lamp + s.wide, 40, (a) => a).map(([a]) => turn(a)), 'lamp-arc');
      const polar = (values, kind) => round.path([...values.map(([a, v]) => turn(s.lamp + a, 0.7 * v)), ...values.map(([a, v]) => turn(s.lamp - a, 0.7 * v)).reverse()], `curve ${kind}`);
      polar(n.exactOver, 'curve-integral');
      polar(n.keptOver.map(([a, v]) => [a, Math.max(v, 0)]), 'curve-hdrp');
      round.arrow([0, 0], turn(s.normal, 0.72), 'reflected');
      chart.grid([[0, '0°'], [90, '90°'], [180, '180°']], [[-0.4, '−40 %'], [0, '0'], [0.5, '50 %'], [1, '100 %']]);
      chart.path(n.exactOver.map(([a, v]) => [a * DEGREES, v]), 'curve curve-integral');
      chart.path(n.keptOver.map(([a, v]) => [a * DEGREES, clamp(v, -0.4, 1.4)]), 'curve curve-hdrp');
      chart.line([n.away, -0.4], [n.away, 1.4], 'here');
      const values = [n.away.toFixed(0), percent(n.light, 1), percent(n.kept, 1), (s.degree + 1) ** 2];
      return (s.degree === 0 ? say('A surface turned {0}° from the lamp gets {1} % of the light of one that faces it; 1 number says {2} %.', ...values)
        : say('A surface turned {0}° from the lamp gets {1} % of the light of one that faces it; {3} numbers say {2} %.', ...values))
        + ' ' + (n.kept < -0.005 ? `${say('Light below 0 is impossible.')} ` : '') + say('The largest error over all normals is {0} %.', percent(n.worst, 1));
    },
  };

  // Seams: four texels on each side of an edge of the cube, whose values are dragged.
  const MIDDLES = [-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5];
  kinds.seam = {
    start: { values: [0.15, 0.25, 0.3, 0.35, 0.75, 0.8, 0.7, 0.85], place: 0.2, lookup: 'alone' },
    make(sketch) {
      this.chart = sketch.chart(say('Texels of two faces, and what is looked up between their middles'), [-4, 4, 0, 1]);
      this.strip = sketch.drawing(say('The same as a picture: above as it is looked up, below seamless'), [-4, 4, 0, 1], { chart: true });
      MIDDLES.forEach((x, i) => this.chart.handle(`texel ${i}`, say('texel {0}', i + 1), i < 4 ? 'eye' : 'C', (s) => [x, s.values[i]], (s, to) => { s.values[i] = clamp(to[1], 0, 1); }));
      this.chart.handle('P', say('the place of the lookup'), 'P', (s) => [s.place, 0.02], (s, to) => { s.place = clamp(to[0], -3.95, 3.95); });
      sketch.keys([['hdrp', say('as it is looked up')], ['integral', say('seamless')]]);
      sketch.choose(say('lookup'), 'lookup', [['alone', say('each face by itself')], ['fixup', say('edge fix-up')], ['seamless', say('seamless')]]);
    },
    /** Of a row of texels; `first` and `last` that may be used. */
    between(values, x, first, last) {
      const at = clamp(x + 3.5, first, last), low = Math.min(Math.floor(at), last - 1);
      return values[low] + (at - low) * (values[low + 1] - values[low]);
    },
    /** The texels within two of the edge are pulled over it by half the difference, and by a quarter. */
    mended(values) {
      const gap = values[4] - values[3];
      return values.map((v, i) => v + (i < 4 ? 1 : -1) * gap * 0.5 * Math.max(1 - Math.min(Math.abs(i - 3), Math.abs(i - 4)) / 2, 0));
    },
    at(s, x, lookup = s.lookup) {
      if (lookup === 'seamless') return this.between(s.values, x, 0, 7);
      const values = lookup === 'fixup' ? this.mended(s.values) : s.values;
      return x < 0 ? this.between(values, x, 0, 3) : this.between(values, x, 4, 7);
    },
    numbers(s) {
      const off = along(-3.99, 3.99, 798, (x) => Math.abs(this.at(s, x) - this.at(s, x, 'seamless')));
      return { value: this.at(s, s.place), jump: Math.abs(this.at(s, 1e-9) - this.at(s, -1e-9)), off: mean(off.map((p) => p[1])) };
    },
    draw(sketch, n) {
      const s = sketch.state, { chart, strip } = this;
      chart.grid([[-2, say('one face')], [2, say('the next')]], [[0, '0'], [0.5, '.5'], [1, '1']]);
      chart.line([0, 0], [0, 1], 'floor-line');
      chart.path(along(-4, 4, 400, (x) => this.at(s, x, 'seamless')), 'curve curve-integral');
      chart.path(along(-4, -1e-9, 200, (x) => this.at(s, x)), 'curve curve-hdrp');
      chart.path(along(1e-9, 4, 200, (x) => this.at(s, x)), 'curve curve-hdrp');
      chart.line([s.place, 0], [s.place, n.value], 'here');
      for (let i = 0; i < 160; i++) {
        const x = -4 + 0.05 * i, grey = (v) => `rgb(${[1, 1, 1].map(() => Math.round(255 * v)).join()})`;
        strip.rect([x, 0.5], [x + 0.055, 1], 'swatch', grey(this.at(s, x + 0.025)));
        strip.rect([x, 0], [x + 0.055, 0.5], 'swatch', grey(this.at(s, x + 0.025, 'seamless')));
      }
      return say('At the edge the lookup jumps by {0} % of white; on average it is {1} % away from the seamless one. At the marked place: {2}.', percent(n.jump), percent(n.off, 1), n.value.toFixed(3));
    },
  };

  // Window and sky: what is outside lies between the window, where the box has it, and infinitely far, where R has it.
  const awayOf = (far) => (far >= 1 ? Infinity : 60 * far * far / (1 - far) / 4);  // metres behind the window, of the slider
  kinds.sky = {
    start: { eye: [-2.6, 1.3], origin: [-1.1, 2.7], place: 0, low: 0.8, high: 2.6, far: 1 },
    make(sketch) {
      this.room = sketch.drawing(say('Section of a room with a window; the floor is a mirror'), [-3.15, 4.6, -0.15, 3.95]);
      this.over = sketch.chart(say('Error of the lookup in degrees, over the distance of what is outside'), [0, 1, 0, 60]);
      this.room.handle('eye', say('the eye'), 'eye', (s) => s.eye, (s, to) => { s.eye = within(to, SECTION, 0.1); }, say('eye'));
      this.room.handle('C', say('C, where the probe was captured'), 'C', (s) => s.origin, (s, to) => { s.origin = within(to, SECTION, 0.1); }, 'C');
      this.room.handle('sill', say('the window’s lower edge'), 'wall', (s) => [3, s.low], (s, to) => { s.low = clamp(to[1], 0.1, s.high - 0.2); });
      this.room.handle('lintel', say('the window’s upper edge'), 'wall', (s) => [3, s.high], (s, to) => { s.high = clamp(to[1], s.low + 0.2, 3.6); });
      this.room.handle('P', say('P, a point of the mirror floor'), 'P', (s) => [s.place, 0], (s, to) => { s.place = clamp(to[0], -2.9, 2.9); }, 'P', [-8, -14]);
      sketch.keys([['J', say('through the box')], ['none', say('R alone')]]);
      sketch.slide(say('distance of what is outside'), 'far', 0, 1, 0.005, (v) => (awayOf(v) === Infinity ? say('infinite: the sky') : say('{0} m', awayOf(v).toFixed(1))));
    },
    at(s, far) {
      const position = [s.place, 0], reflection = inFloor(s.eye, s.place), hit = exit(position, reflection, SECTION), away = awayOf(far);
      const through = hit.at[0] > 2.999 && hit.at[1] > s.low && hit.at[1] < s.high, lookup = sub(hit.at, s.origin);
      const seen = !through ? lookup : away === Infinity ? reflection : sub(add(hit.at, scaled(reflection, away / reflection[0])), s.origin);
      const pane = exit(s.origin, unit(seen), SECTION).at, hidden = through && !(pane[0] > 2.999 && pane[1] > s.low && pane[1] < s.high);
      return { position, reflection, hit: hit.at, distance: hit.d, through, hidden, lookup, seen, boxError: degrees(lookup, seen), bareError: degrees(reflection, seen) };
    },
    numbers(s) { return { ...this.at(s, s.far), over: along(0, 1, 100, (far) => this.at(s, far)) }; },
    draw(sketch, n) {
      const s = sketch.state, { room, over } = this;
      section(room);
      room.line([3, s.low], [3, s.high], 'window-line');
      room.line(s.eye, n.position, 'view', 3);
      room.line(n.position, n.hit, 'reflected', 2.5);
      if (n.through) room.arrow(n.hit, add(n.hit, scaled(n.reflection, 1.4)), 'reflected');
      room.arrow(s.origin, add(s.origin, n.lookup), 'lookup');
      room.arrow(n.position, add(n.position, scaled(n.reflection, 1.2)), 'bare');
      room.text(add(n.position, scaled(n.reflection, 1.2)), 'R', 'plain', 4, 20);
      room.text(n.hit, 'H', 'reflected', -22, -8);
      over.grid([[0, say('{0} m', 0)], [0.5, say('{0} m', awayOf(0.5).toFixed(1))], [1, '∞']], [[0, '0°'], [20, '20°'], [40, '40°'], [60, '60°']]);
      over.path(n.over.map(([far, p]) => [far, Math.min(p.boxError, 60)]), 'curve curve-J');
      over.path(n.over.map(([far, p]) => [far, Math.min(p.bareError, 60)]), 'curve curve-none');
      over.line([s.far, 0], [s.far, 60], 'here');
      return n.through ? say('The ray leaves through the window. Sampled through the box it is {0}° off, with R alone {1}°.', n.boxError.toFixed(1), n.bareError.toFixed(1)) + (n.hidden ? ` ${say('C does not see it: a wall is in between.')}` : '')
        : say('The ray ends on a wall: the box is right, R alone is {0}° off.', n.bareError.toFixed(1));
    },
  };

  // What the screen knows: screen-space reflections find what the picture shows, the box finds walls.
  kinds.screen = {
    start: { eye: [-2.6, 1.7], look: [0.4, 0.6], shelf: [1.2, 1.3], place: -0.6 },
    make(sketch) {
      this.room = sketch.drawing(say('Section: what the picture shows lies within the two lines from the eye'), OVER);
      this.strip = sketch.chart(say('The mirror floor, by who finds what its rays meet'), [-3, 3, 0, 3]);
      this.room.handle('eye', say('the eye'), 'eye', (s) => s.eye, (s, to) => { s.eye = offShelf(within(to, SECTION, 0.1), s); }, say('eye'));
      this.room.handle('look', say('where the eye looks'), 'C', (s) => s.look, (s, to) => { s.look = within(to, SECTION, 0.02); });
      this.room.handle('table', say('the table top'), 'wall', (s) => s.shelf, (s, to) => { moveShelf(s, to); s.eye = offShelf(s.eye, s); });
      this.room.handle('P', say('P, a point of the mirror floor'), 'P', (s) => [s.place, 0], (s, to) => { s.place = clamp(to[0], -2.98, 2.98); }, 'P', [-8, -14]);
    },
    shown(s, at) { return degrees(sub(at, s.eye), sub(s.look, s.eye)) < 30 && sees(s.eye, at, shelfOf(s)); },
    at(s, x) {
      const position = [x, 0], reflection = inFloor(s.eye, x), truth = firstMet(position, reflection, shelfOf(s));
      return { position, reflection, truth: truth.at, screen: this.shown(s, truth.at), box: !truth.thing, visible: this.shown(s, position) };
    },
    numbers(s) {
      const floor = along(-2.98, 2.98, 596, (x) => this.at(s, x)), visible = floor.filter(([, p]) => p.visible), share = (of) => (visible.length ? visible.filter(([, p]) => of(p)).length / visible.length : 0);
      return { ...this.at(s, s.place), floor, count: visible.length, screenShare: share((p) => p.screen), boxShare: share((p) => !p.screen && p.box), noneShare: share((p) => !p.screen && !p.box) };
    },
    draw(sketch, n) {
      const s = sketch.state, { room, strip } = this, ahead = Math.atan2(s.look[1] - s.eye[1], s.look[0] - s.eye[0]);
      const edges = [-Math.PI / 6, Math.PI / 6].map((by) => exit(s.eye, [Math.cos(ahead + by), Math.sin(ahead + by)], SECTION).at);
      section(room, shelfOf(s));
      for (const edge of edges) room.line(s.eye, edge, 'view dashed');
      room.line(s.eye, n.position, 'view', 3);
      room.arrow(n.position, n.truth, 'reflected');
      room.circle(n.truth, 10, 'right-point');
      strip.grid([[-3, '−3'], [0, '0'], [3, '3']], []);
      const names = [[2, say('the screen'), 'by-screen'], [1, say('the box'), 'by-box'], [0, say('neither'), 'by-none']];
      for (const [x, p] of n.floor) {
        if (!p.visible) continue;
        const row = p.screen ? 2 : p.box ? 1 : 0;
        strip.rect([x - 0.006, row + 0.1], [x + 0.006, row + 0.75], names[2 - row][2]);
      }
      for (const [row, name] of names) strip.text([-3, row + 0.8], name, 'axis', 2, 0);
      strip.line([s.place, 0], [s.place, 3], 'here');
      if (!n.count) return say('No floor is in the picture.');
      const what = !n.visible ? say('P itself is not in the picture.') : n.screen ? say('The ray from P meets a place that the picture shows: the screen has it.')
        : n.box ? say('The picture does not show what the ray from P meets, but it is a wall: the box has it.') : say('The ray from P meets a side of the table that the picture does not show: neither has it.');
      return `${what} ${say('Of the floor in the picture the screen has {0} %, the box another {1} %; neither has {2} %.', percent(n.screenShare), percent(n.boxShare), percent(n.noneShare))}`;
    },
  };

  // A box with its edges rounded off, in plan.
  kinds.round = {
    start: { place: [-1.2, -0.9], target: [3, 1.9], radius: 1 },
    make(sketch) {
      this.plan = sketch.drawing(say('Plan of the box: sharp, and with its edges rounded off'), [-3.2, 3.2, -2.2, 2.2]);
      this.chart = sketch.chart(say('Distance to the hit, over the direction of the ray'), [-180, 180, 0, 6]);
      this.plan.handle('P', 'P', 'P', (s) => s.place, (s, to) => { s.place = within(to, this.box, 0.02); }, 'P', [-24, 20]);
      this.plan.handle('R', say('where the ray goes'), 'C', (s) => this.numbers(s).hit, (s, to) => { if (length(sub(to, s.place)) > 0.05) s.target = to; });
      this.plan.handle('radius', say('the radius'), 'wall', (s) => [this.box.max[0] - s.radius, this.box.max[1]], (s, to) => { s.radius = clamp(this.box.max[0] - to[0], 0, 2); });
      sketch.keys([['hdrp', say('sharp')], ['integral', say('rounded')]]);
    },
    box: { min: [-3, -2], max: [3, 2] },
    /** By halving: the ray leaves the points that are no farther than r from the inner box. Near two walls the edge is sharper. */
    radiusAt(s) {
      const gap = s.place.map((v, i) => Math.min(v - this.box.min[i], this.box.max[i] - v));
      return Math.min(s.radius, gap[0] + gap[1], 2);
    },
    rounded(s, r, sharp) {
      const radius = this.radiusAt(s);
      if (radius < 1e-7) return sharp;
      const outside = (t) => length(add(s.place, scaled(r, t)).map((v, i) => Math.max(Math.abs(v) - (this.box.max[i] - radius), 0))) > radius;
      if (!outside(sharp * (1 - 1e-12))) return sharp;
      let [low, high] = [0, sharp];
      for (let i = 0; i < 60; i++) {
        const middle = 0.5 * (low + high);
        if (outside(middle)) high = middle;
        else low = middle;
      }
      return low;
    },
    at(s, r) { const sharp = exit(s.place, r, this.box).d; return { sharp, rounded: this.rounded(s, r, sharp) }; },
    numbers(s) {
      const direction = unit(sub(s.target, s.place)), { sharp, rounded } = this.at(s, direction);
      return { direction, sharp, rounded, radius: this.radiusAt(s), hit: add(s.place, scaled(direction, rounded)), sharpHit: add(s.place, scaled(direction, sharp)) };
    },
    draw(sketch, n) {
      const s = sketch.state, { plan, chart, box } = this, outline = [];
      plan.rect(box.min, box.max, 'room-outline');
      for (const [x, y, from] of [[1, 1, 0], [-1, 1, 1], [-1, -1, 2], [1, -1, 3]]) {
        for (let i = 0; i <= 16; i++) {
          const a = (from + i / 16) * Math.PI / 2;
          outline.push([x * (box.max[0] - n.radius) + n.radius * Math.cos(a), y * (box.max[1] - n.radius) + n.radius * Math.sin(a)]);
        }
      }
      plan.path(outline, 'rounded-outline', true);
      plan.line(n.hit, n.sharpHit, 'reflected dashed');
      plan.arrow(s.place, n.hit, 'reflected');
      chart.grid([[-180, '−180°'], [0, '0°'], [180, '180°']], [[0, '0'], [2, '2'], [4, '4'], [6, '6']]);
      const over = along(-180, 180, 360, (a) => this.at(s, [Math.cos(a / DEGREES), Math.sin(a / DEGREES)]));
      chart.path(over.map(([a, d]) => [a, Math.min(d.sharp, 6)]), 'curve curve-hdrp');
      chart.path(over.map(([a, d]) => [a, Math.min(d.rounded, 6)]), 'curve curve-integral');
      const here = Math.atan2(n.direction[1], n.direction[0]) * DEGREES;
      chart.line([here, 0], [here, 6], 'here');
      return say('d = {0} with sharp edges, {1} with a radius of {2}. In a room with sharp corners the hit is {3} too near.', n.sharp.toFixed(3), n.rounded.toFixed(3), n.radius.toFixed(2), (n.sharp - n.rounded).toFixed(3));
    },
  };

  // A rough floor near a dark wall: what it sees, what one level of the cubemap shows, darkened by the distance, and the level by footprint.
  kinds.corner = {
    start: { eye: [-2.4, 2.2], origin: [-0.5, 1.2], place: 2.5, low: 1.7, high: 3.3, rough: 0.57, factor: 0.5, power: 1 },
    make(sketch) {
      this.room = sketch.drawing(say('Section: a dark room with a rough floor and a window high in its wall'), OVER);
      this.over = sketch.chart(say('Light of the floor, over its place'), [-2.9, 2.9, 0, 1]);
      this.room.handle('eye', say('the eye'), 'eye', (s) => s.eye, (s, to) => { s.eye = within(to, SECTION, 0.1); }, say('eye'));
      this.room.handle('C', say('C, where the probe was captured'), 'C', (s) => s.origin, (s, to) => { s.origin = within(to, SECTION, 0.1); }, 'C');
      this.room.handle('sill', say('the window’s lower edge'), 'wall', (s) => [3, s.low], (s, to) => { s.low = clamp(to[1], 0.1, s.high - 0.2); });
      this.room.handle('lintel', say('the window’s upper edge'), 'wall', (s) => [3, s.high], (s, to) => { s.high = clamp(to[1], s.low + 0.2, 3.65); });
      this.room.handle('P', say('P, a point of the rough floor'), 'P', (s) => [s.place, 0], (s, to) => { s.place = clamp(to[0], -2.9, 2.9); }, 'P', [-8, -14]);
      sketch.keys([['integral', say('what P sees')], ['none', say('one level')], ['hdrp', say('darkened')], ['J', say('level by footprint')]]);
      sketch.slide(say('roughness p'), 'rough', 0.3, 1, 0.01);
      sketch.slide(say('multiplier m'), 'factor', 0.1, 1.5, 0.01);
      sketch.slide(say('power u'), 'power', 0, 3, 0.05);
    },
    /** Share of the fan between two angles, counted from the right, counterclockwise, that ends in the window. */
    bright(s, from, low, high) {
      const [a, b] = [s.low, s.high].map((y) => Math.atan2(y - from[1], 3 - from[0]));
      return high > low ? Math.max(Math.min(high, b) - Math.max(low, a), 0) / (high - low) : 0;
    },
    at(s, x) {
      const position = [x, 0], reflection = inFloor(s.eye, x), hit = exit(position, reflection, SECTION), half = 2 * Math.atan(s.rough * s.rough);  // a ray turns by twice the tilt
      const middle = Math.atan2(reflection[1], reflection[0]), low = Math.max(middle - half, 0), high = Math.min(middle + half, Math.PI);
      const angleFrom = (at) => Math.atan2(at[1] - s.origin[1], at[0] - s.origin[0]), lookup = angleFrom(hit.at);
      // The patch never holds what is straight below C: angles are counted from there.
      const patch = [low, high].map((a) => angleFrom(exit(position, [Math.cos(a), Math.sin(a)], SECTION).at)).map((a) => (a < -Math.PI / 2 ? a + 2 * Math.PI : a));
      const open = clamp(s.factor * hit.d ** s.power, 0, 1), one = this.bright(s, s.origin, lookup - half, lookup + half);
      return { position, reflection, hit: hit.at, distance: hit.d, low, high, open, truth: this.bright(s, position, low, high), one, darkened: one * open, level: this.bright(s, s.origin, ...patch) };
    },
    numbers(s) {
      const over = along(-2.9, 2.9, 290, (x) => this.at(s, x)), off = (key) => mean(over.map(([, p]) => Math.abs(p[key] - p.truth)));
      return { ...this.at(s, s.place), over, errors: { one: off('one'), darkened: off('darkened'), level: off('level') } };
    },
    draw(sketch, n) {
      const s = sketch.state, { room, over } = this;
      section(room);
      room.line([3, s.low], [3, s.high], 'lamp-arc');
      const fan = [n.position, ...along(n.low, n.high, 12, (a) => a).map(([a]) => exit(n.position, [Math.cos(a), Math.sin(a)], SECTION).at)];
      room.path(fan, 'lobe', true);
      room.line(s.eye, n.position, 'view', 3);
      room.arrow(n.position, n.hit, 'reflected');
      room.arrow(s.origin, n.hit, 'lookup');
      over.grid([[-2.9, '−2.9'], [0, '0'], [2.9, '2.9']], [[0, '0'], [0.5, '50 %'], [1, '100 %']]);
      for (const [key, kind] of [['truth', 'curve-integral'], ['one', 'curve-none'], ['darkened', 'curve-hdrp'], ['level', 'curve-J']]) over.path(n.over.map(([x, p]) => [x, p[key]]), `curve ${kind}`);
      over.line([s.place, 0], [s.place, 1], 'here');
      return say('At P, {0} % of the window’s light is right. One level shows {1} %; darkened by o = {2}, it shows {3} %. The level by footprint shows {4} %.', percent(n.truth), percent(n.one), n.open.toFixed(2), percent(n.darkened), percent(n.level))
        + ' ' + say('Mean error over the floor: {0} % with one level, {1} % darkened, {2} % with the level by footprint.', percent(n.errors.one, 1), percent(n.errors.darkened, 1), percent(n.errors.level, 1));
    },
  };
})();
