// What the small figures of the first five lessons show (sketch.js): one idea each, in plan or in section. The others are in
// sketches_more.js. The formulas are the lessons' own; tests/outside/page/sketches.mjs holds their numbers to the compiled ones or to
// another form of them. Angles are degrees where they are printed, radians within.
'use strict';
(() => {
  const { say } = boxprobeDrawing, kinds = boxprobeSketchKinds;
  const { add, sub, scaled, dot, length, unit, clamp, within, degrees, along, mean, percent } = boxprobePlane;
  const { exit, inFloor, SECTION, OVER, shelfOf, firstMet, sees, moveShelf, offShelf, shade, section } = boxprobePlane;

  // A mirror needs surroundings: a ball, sampled with N, with R, or with R from where each point is.
  const HALL = { min: [-4, -2.7], max: [4, 2.7] }, BALL = 0.75;
  /** The hall's walls have a colour for every place: four hues, with pale doors. */
  function wallColour(at) {
    const side = [[0, 1, 205], [1, 1, 40], [0, -1, 130], [1, -1, 330]].reduce((best, s) => {
      const off = (w) => Math.abs(at[w[0]] - (w[1] > 0 ? HALL.max : HALL.min)[w[0]]);
      return off(s) < off(best) ? s : best;
    });
    const place = at[1 - side[0]], light = Math.abs(((place + 8.35) % 1.8) - 0.9) < 0.3 ? 78 : 42;
    return `hsl(${side[2]} 60% ${light}%)`;
  }
  const OFF = 96, NEAREST = 1.06 * BALL;  // the eye stays outside of the ball
  kinds.ball = {
    start: { ball: [1.7, 0.5], eye: [-2.4, -1.7], origin: [0.3, -1.6], angle: 3.5, sampled: 'R' },
    make(sketch) {
      this.plan = sketch.drawing(say('Plan: a mirror ball in a room with four walls'), [-4.1, 4.1, -2.8, 2.8]);
      this.strip = sketch.drawing(say('The ball as the eye sees it, from its left rim to its right one'), [-1, 1, 0, 1], { chart: true, inset: [14, 14, 14, 14] });
      const inside = { min: add(HALL.min, [BALL, BALL]), max: sub(HALL.max, [BALL, BALL]) };
      this.plan.handle('ball', say('the ball'), 'wall', (s) => s.ball, (s, to) => { const ball = within(to, inside, 0.1); if (length(sub(ball, s.eye)) >= NEAREST) s.ball = ball; });
      this.plan.handle('eye', say('the eye'), 'eye', (s) => s.eye, (s, to) => { const from = sub(within(to, HALL, 0.05), s.ball), angle = Math.atan2(from[1], from[0]); s.eye = add(s.ball, scaled([Math.cos(angle), Math.sin(angle)], Math.max(length(from), NEAREST))); }, say('eye'));
      this.plan.handle('C', say('C, where the probe was captured'), 'C', (s) => s.origin, (s, to) => { s.origin = within(to, HALL, 0.05); }, 'C');
      this.plan.handle('P', say('P, a point of the ball'), 'P', (s) => this.pointOf(s), (s, to) => { s.angle = Math.atan2(to[1] - s.ball[1], to[0] - s.ball[0]); }, 'P', [10, 22]);
      sketch.choose(say('sampled with'), 'sampled', [['N', say('sampled with N')], ['R', say('with R')], ['box', say('with R, from P, through the box')]]);
    },
    /** P on the half that the eye sees. */
    facing(s) {
      const to = sub(s.eye, s.ball), far = Math.max(length(to), BALL * 1.02), middle = Math.atan2(to[1], to[0]), most = Math.acos(BALL / far);
      const turned = s.angle - middle, off = Math.atan2(Math.sin(turned), Math.cos(turned));
      return { middle, most, angle: middle + clamp(off, -0.98 * most, 0.98 * most) };
    },
    pointOf(s) { return this.at(s, this.facing(s).angle).position; },
    at(s, angle) {
      const normal = [Math.cos(angle), Math.sin(angle)], position = add(s.ball, scaled(normal, BALL)), view = unit(sub(s.eye, position));
      const reflection = sub(scaled(normal, 2 * dot(normal, view)), view), hit = exit(position, reflection, HALL);
      const right = sub(hit.at, s.origin), lookup = { N: normal, R: reflection, box: right }[s.sampled];
      return { position, normal, reflection, hit: hit.at, distance: hit.d, right, lookup, shown: exit(s.origin, unit(lookup), HALL).at, error: degrees(lookup, right) };
    },
    numbers(s) {
      const { middle, most, angle } = this.facing(s), points = Array.from({ length: OFF }, (_, i) => this.at(s, middle + most * (2 * (i + 0.5) / OFF - 1)));
      return { ...this.at(s, angle), points, mean: mean(points.map((p) => p.error)) };
    },
    draw(sketch, n) {
      const s = sketch.state, { plan, strip } = this, thick = 0.1;
      for (let axis = 0; axis < 2; axis++) {
        for (const side of ['min', 'max']) {
          const other = 1 - axis, count = 90;
          for (let i = 0; i < count; i++) {
            const low = [0, 0], high = [0, 0], from = HALL.min[other] + (HALL.max[other] - HALL.min[other]) * i / count, wide = (HALL.max[other] - HALL.min[other]) / count;
            low[other] = from;
            high[other] = from + wide * 1.05;
            low[axis] = side === 'min' ? HALL.min[axis] - thick : HALL.max[axis];
            high[axis] = low[axis] + thick;
            const middle = [0, 0];
            middle[other] = from + wide / 2;
            middle[axis] = HALL[side][axis];
            plan.rect(low, high, 'swatch', wallColour(middle));
          }
        }
      }
      plan.circle(s.ball, BALL * plan.scale[0], 'thing');
      plan.line(s.eye, n.position, 'view', 3);
      plan.arrow(n.position, n.hit, 'reflected');
      plan.arrow(n.position, add(n.position, scaled(n.normal, 0.7)), 'normal');
      plan.text(add(n.position, scaled(n.normal, 0.7)), 'N', 'plain', -8, -10);
      plan.arrow(s.origin, n.shown, 'lookup');
      plan.circle(n.hit, 10, 'right-point');
      plan.circle(n.shown, 6, 'lookup filled');
      n.points.forEach((p, i) => {
        const [low, high] = [i, i + 1.06].map((k) => -1 + 2 * k / OFF);
        strip.rect([low, 0.5], [Math.min(high, 1), 1], 'swatch', wallColour(p.shown));
        strip.rect([low, 0], [Math.min(high, 1), 0.5], 'swatch', wallColour(p.hit));
      });
      strip.line([-1, 0.5], [1, 0.5], 'seam-line');
      const { middle, most, angle } = this.facing(s), here = clamp((angle - middle) / most, -1, 1);
      strip.line([here, 0], [here, 1], 'marker');
      strip.text([-1, 1], say('as it is sampled'), 'plain', 8, 22);
      strip.text([-1, 0.5], say('as it should be'), 'plain', 8, 24);
      return n.error < 0.05 && s.sampled === 'box' ? say('Every point of the ball is right, wherever ball, eye and C are: the ray starts at P.')
        : say('At P the cubemap is sampled {0}° away from the right direction; over the visible half of the ball, {1}° on average.', n.error.toFixed(1), n.mean.toFixed(1));
    },
  };

  // What stands in the room, in section: the box knows the walls, the capture knows what C saw.
  kinds.impostor = {
    start: { eye: [-2.6, 1.5], origin: [-0.6, 2.7], shelf: [0.9, 1.5], place: -0.9 },
    make(sketch) {
      this.room = sketch.drawing(say('Section of a room with a table top; the floor is a mirror. Grey: what C does not see'), OVER);
      this.over = sketch.chart(say('Error of box projection in degrees, over the floor; red: the ray ends where C did not see'), [-3, 3, 0, 60]);
      this.room.handle('eye', say('the eye'), 'eye', (s) => s.eye, (s, to) => { s.eye = within(to, SECTION, 0.1); }, say('eye'));
      this.room.handle('C', say('C, where the probe was captured'), 'C', (s) => s.origin, (s, to) => { s.origin = offShelf(within(to, SECTION, 0.05), s); }, 'C');
      this.room.handle('table', say('the table top'), 'wall', (s) => s.shelf, (s, to) => { moveShelf(s, to); s.origin = offShelf(s.origin, s); });
      this.room.handle('P', say('P, a point of the mirror floor'), 'P', (s) => [s.place, 0], (s, to) => { s.place = clamp(to[0], -2.98, 2.98); }, 'P', [-8, -14]);
    },
    at(s, x) {
      const shelf = shelfOf(s), position = [x, 0], reflection = inFloor(s.eye, x), truth = firstMet(position, reflection, shelf), hit = exit(position, reflection, SECTION);
      const lookup = sub(hit.at, s.origin), shown = firstMet(s.origin, unit(lookup), shelf);
      return { position, reflection, truth: truth.at, met: truth.thing, hit: hit.at, distance: hit.d, lookup, shown: shown.at, seen: sees(s.origin, truth.at, shelf), error: degrees(lookup, sub(truth.at, s.origin)) };
    },
    numbers(s) {
      const floor = along(-2.98, 2.98, 298, (x) => this.at(s, x));
      return { ...this.at(s, s.place), floor, mean: mean(floor.map(([, p]) => p.error)), unseen: mean(floor.map(([, p]) => (p.seen ? 0 : 1))) };
    },
    draw(sketch, n) {
      const s = sketch.state, { room, over } = this;
      shade(room, s.origin, shelfOf(s));
      section(room, shelfOf(s));
      room.line(s.eye, n.position, 'view', 3);
      if (n.met) room.line(n.truth, n.hit, 'reflected dashed');
      room.arrow(n.position, n.truth, 'reflected');
      room.arrow(s.origin, n.shown, 'lookup');
      room.circle(n.truth, 10, 'right-point');
      room.text(n.hit, 'H', 'reflected', -22, -8);
      over.grid([[-3, '−3'], [0, '0'], [3, '3']], [[0, '0°'], [20, '20°'], [40, '40°'], [60, '60°']]);
      over.path(n.floor.map(([x, p]) => [x, Math.min(p.error, 60)]), 'curve curve-hdrp');
      for (const [x, p] of n.floor) if (!p.seen) over.line([x - 0.011, 0.6], [x + 0.011, 0.6], 'unseen-mark', 8);
      over.line([s.place, 0], [s.place, 60], 'here');
      const what = !n.met ? (n.seen ? say('The ray from P ends on a wall: the box is right there.') : say('The ray from P ends on a wall, but C does not see that place: the table hides it, and the lookup shows the table.'))
        : say('The ray from P meets the table: box projection samples {0}° away from it.', n.error.toFixed(1)) + ' ' + (n.seen ? say('C saw it, so a search along the captured distances can find it.') : say('C did not see it: no search finds it.'));
      return `${what} ${say('Over the whole floor: {0}° on average; {1} % of the rays end at places that C did not see.', n.mean.toFixed(1), percent(n.unseen))}`;
    },
  };
})();
