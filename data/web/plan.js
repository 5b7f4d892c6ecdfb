// The plan and the elevation of one reflected ray, to take hold of: P, the eye, C and the walls are dragged, the numbers
// follow. One call per figure, boxprobePlan(element, data); the element holds the same figure as a still one until then.
// Lengths are scene units along the box's axes. The formulas are those of shaders/technique/projection_box.glsl and
// shaders/shared/slab.glsl and finite.glsl; tests/outside/page holds them to the compiled ones.
'use strict';
(() => {
  const { element, say, takeHold, slabFactor } = boxprobeDrawing, AXES = 'xyz';
  const add = (a, b) => a.map((v, i) => v + b[i]), sub = (a, b) => a.map((v, i) => v - b[i]);
  const scaled = (a, s) => a.map((v) => v * s), dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const length = (a) => Math.sqrt(dot(a, a));
  const unit = (a) => { const size = length(a); return size > 1e-18 ? scaled(a, 1 / size) : [0, 1, 0]; };
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
  const degreesBetween = (a, b) => Math.acos(clamp(dot(unit(a), unit(b)), -1, 1)) * 180 / Math.PI;

  const slabFactors = (p, r, box) => p.map((v, i) => slabFactor(v, r[i], box.min[i], box.max[i]));
  const exit = (p, r, box) => {
    const t = slabFactors(p, r, box), d = Math.min(...t);
    return p.map((v, i) => clamp(v + d * r[i], box.min[i], box.max[i]));
  };

  /** All that the figure shows, from { position, normal, eye, origin, box, room }. `room`: the walls that are really there. */
  function numbers(s) {
    const view = unit(sub(s.eye, s.position));
    const reflection = sub(scaled(s.normal, 2 * Math.max(dot(s.normal, view), 0)), view);
    const t = slabFactors(s.position, reflection, s.box);
    const axis = t[0] <= t[1] ? (t[0] <= t[2] ? 0 : 2) : (t[1] <= t[2] ? 1 : 2);
    const distance = Math.min(...t);
    const hit = exit(s.position, reflection, s.box), lookup = sub(hit, s.origin);
    const truth = exit(s.position, reflection, s.room), seen = sub(truth, s.origin);
    return {
      view, reflection, t, axis, distance, hit, lookup, truth, behind: dot(s.normal, view) <= 0,
      outside: s.position.some((v, i) => v < s.box.min[i] - 1e-5 || v > s.box.max[i] + 1e-5),  // a floor's points are off by a float's last digits
      bareHit: exit(s.origin, reflection, s.room), boxHit: exit(s.origin, unit(lookup), s.room),
      bareError: degreesBetween(reflection, seen), boxError: degreesBetween(lookup, seen),
    };
  }

  const views = {
    plan: { title: say('Plan, from above'), right: [0, 1], up: [2, -1] },
    front: { title: say('Elevation, from the front'), right: [0, 1], up: [1, 1] },
    side: { title: say('Elevation, from the side'), right: [2, -1], up: [1, 1] },
  };

  /** Text in which "_x" is a subscript, within HTML or SVG. */
  function subscripted(parent, text) {
    text.split(/_([xyz])/).forEach((part, i) => {
      if (parent instanceof SVGElement) element('tspan', i % 2 ? { dy: 4, 'font-size': 11 } : { dy: i ? -4 : 0 }, parent, part);
      else if (i % 2) element('sub', {}, parent, part);
      else parent.append(part);
    });
  }

  const WIDTH = 420, MARGIN = 34, STEP = 0.05;

  /** One of the drawings: takes the state, draws it, and says where its handles were dragged to. */
  class Drawing {
    constructor(parent, name, state, changed) {
      this.view = views[name];
      this.changed = changed;
      const points = [state.box.min, state.box.max, state.room.min, state.room.max, state.eye, state.position, state.origin].map((p) => this.paper(p));
      this.low = [0, 1].map((i) => Math.min(...points.map((p) => p[i])));
      const high = [0, 1].map((i) => Math.max(...points.map((p) => p[i])));
      this.scale = (WIDTH - 2 * MARGIN) / Math.max(high[0] - this.low[0], 1e-6);
      const tallest = 360;
      this.scale = Math.min(this.scale, (tallest - 2 * MARGIN) / Math.max(high[1] - this.low[1], 1e-6));
      this.inset = (WIDTH - this.scale * (high[0] - this.low[0])) / 2;
      this.height = this.scale * (high[1] - this.low[1]) + 2 * MARGIN;
      this.figure = element('figure', { class: 'plan-view' }, parent);
      this.svg = element('svg', { viewBox: `0 0 ${WIDTH} ${this.height.toFixed(0)}`, role: 'group', 'aria-label': this.view.title }, null);
      this.figure.append(this.svg);
      element('figcaption', {}, this.figure, this.view.title);
      this.drawn = element('g', {}, this.svg);
      this.handles = new Map();
      const hold = (id, label, kind, read, write) => this.addHandle(id, label, kind, read, write);
      const [a, b] = [this.view.right[0], this.view.up[0]];
      for (const side of ['min', 'max']) {
        for (const axis of [a, b]) {
          hold(`wall-${side}-${AXES[axis]}`, say('wall {0}', `${side === 'min' ? '−' : '+'}${AXES[axis]}`), axis === a ? 'wall-across' : 'wall-along',
            (s) => { const middle = scaled(add(s.box.min, s.box.max), 0.5); middle[axis] = s.box[side][axis]; return middle; },
            (s, to) => {
              const other = side === 'min' ? s.box.max[axis] : s.box.min[axis], least = 0.1;
              s.box[side][axis] = side === 'min' ? Math.min(to[axis], other - least) : Math.max(to[axis], other + least);
            });
        }
      }
      const plain = (key) => [(s) => s[key], (s, to) => { s[key][a] = to[a]; s[key][b] = to[b]; }];
      hold('eye', say('the eye'), 'eye', ...plain('eye'));
      hold('C', say('C, where the probe was captured'), 'C', ...plain('origin'));
      hold('P', say('P, the point that reflects'), 'P', ...plain('position'));
    }

    paper(p) { const [i, s] = this.view.right, [j, t] = this.view.up; return [s * p[i], t * p[j]]; }
    pixel(p) { const [u, v] = this.paper(p); return [this.inset + (u - this.low[0]) * this.scale, this.height - MARGIN - (v - this.low[1]) * this.scale]; }
    /** `pixel`: of the drawing; what the drawing does not show of the point stays as it is in `p`. */
    space(pixel, p) {
      const [i, s] = this.view.right, [j, t] = this.view.up, moved = [...p];
      moved[i] = s * ((pixel[0] - this.inset) / this.scale + this.low[0]);
      moved[j] = t * ((this.height - MARGIN - pixel[1]) / this.scale + this.low[1]);
      return moved;
    }

    addHandle(id, label, kind, read, write) {
      const g = element('g', { class: `handle handle-${kind}`, tabindex: 0, role: 'button', 'aria-label': say('{0}: drag it or use the arrow keys', label), 'data-handle': id }, this.svg);
      element('circle', { r: 20, class: 'grip' }, g);
      const wall = kind.startsWith('wall');
      if (wall) element('rect', kind === 'wall-across' ? { x: -4, y: -11, width: 8, height: 22, rx: 3 } : { x: -11, y: -4, width: 22, height: 8, rx: 3 }, g);
      else element('circle', { r: 7 }, g);
      const move = (pixel) => this.changed((s) => write(s, this.space([clamp(pixel[0], 4, WIDTH - 4), clamp(pixel[1], 4, this.height - 4)], read(s))));
      takeHold(this.svg, g, { here: () => this.pixel(read(this.state)), move, far: (event) => this.scale * STEP * (event.shiftKey ? 10 : 1) });
      this.handles.set(id, { g, read });
    }

    line(from, to, kind) {
      const [a, b] = [this.pixel(from), this.pixel(to)];
      element('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: kind }, this.drawn);
    }

    arrow(from, to, kind) {
      this.line(from, to, kind);
      const [a, b] = [this.pixel(from), this.pixel(to)], size = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (size < 12) return;  // seen end on
      const u = [(b[0] - a[0]) / size, (b[1] - a[1]) / size];
      const corner = (s) => `${b[0] - 10 * u[0] - s * 4.5 * u[1]},${b[1] - 10 * u[1] + s * 4.5 * u[0]}`;
      element('polygon', { points: `${b[0]},${b[1]} ${corner(1)} ${corner(-1)}`, class: `${kind} head` }, this.drawn);
    }

    label(at, text, kind, dx, dy) {
      const [x, y] = this.pixel(at);
      if (x < 0 || y < 0 || x > WIDTH || y > this.height) return;
      const middle = kind === 'view' || kind === 'reflected' || kind === 'lookup';
      subscripted(element('text', { x: clamp(x + dx, 10, WIDTH - 10), y: clamp(y + dy, 14, this.height - 5), class: `label ${kind}`, 'text-anchor': middle ? 'middle' : 'start' }, this.drawn), text);
    }

    box(box, kind) {
      const a = this.pixel(box.min), b = this.pixel(box.max);
      element('rect', { x: Math.min(a[0], b[0]), y: Math.min(a[1], b[1]), width: Math.abs(a[0] - b[0]), height: Math.abs(a[1] - b[1]), class: kind }, this.drawn);
    }

    draw(s, n) {
      this.state = s;
      this.drawn.replaceChildren();
      const reach = 0.3 * length(sub(s.room.max, s.room.min));
      this.box(s.room, 'room');
      this.box(s.box, 'box');
      // The ray goes on to the planes of the other walls that this drawing shows edge-on.
      for (const [axis] of [this.view.right, this.view.up]) {
        if (axis === n.axis || n.t[axis] > 1e3 * length(sub(s.box.max, s.box.min))) continue;
        const crossing = add(s.position, scaled(n.reflection, n.t[axis]));
        this.line(n.hit, crossing, 'beyond');
        const [x, y] = this.pixel(crossing);
        element('circle', { cx: x, cy: y, r: 3.5, class: 'crossing' }, this.drawn);
        this.label(crossing, `t_${AXES[axis]}`, 'beyond', 9, -7);
      }
      // Beside a line, a share of the way along it; one that is seen end on has none. `side`: 1 or -1, which side.
      const beside = (a, b, share, side, text, kind) => {
        const [p, q] = [this.pixel(a), this.pixel(b)], size = Math.hypot(q[0] - p[0], q[1] - p[1]);
        if (size < 24) return;
        const away = (13 + 2.5 * text.length * Math.abs(q[1] - p[1]) / size) * side / size;
        this.label(add(a, scaled(sub(b, a), share)), text, kind, -away * (q[1] - p[1]), away * (q[0] - p[0]) + 5);
      };
      this.line(s.eye, s.position, 'view');
      beside(s.eye, s.position, 0.5, -1, 'V', 'view');
      const top = add(s.position, scaled(s.normal, 0.36 * reach));
      this.arrow(s.position, top, 'normal');
      if (Math.hypot(...sub(this.pixel(top), this.pixel(s.position))) > 12) this.label(top, 'N', 'normal', -18, 2);
      this.arrow(s.position, n.hit, 'reflected');
      const left = (a, b, c) => Math.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) || 1;
      const [p, c, h] = [s.position, s.origin, n.hit].map((at) => this.pixel(at));
      beside(s.position, n.hit, 0.4, -left(p, h, c), 'R', 'reflected');  // each on the far side from the other
      this.arrow(s.origin, n.bareHit, 'bare');
      this.arrow(s.origin, n.hit, 'lookup');
      beside(s.origin, n.hit, 0.42, -left(c, h, this.pixel(n.bareHit)), 'H − C', 'lookup');
      for (const [at, kind] of [[n.truth, 'truth'], [n.hit, 'hit']]) {
        const [x, y] = this.pixel(at);
        element('circle', { cx: x, cy: y, r: kind === 'hit' ? 5 : 8, class: kind }, this.drawn);
      }
      this.label(n.hit, 'H', 'hit', 9, -9);
      this.label(s.position, 'P', 'P', -18, 19);
      this.label(s.origin, 'C', 'C', -18, -9);
      this.label(s.eye, say('eye'), 'eye', p[0] > this.pixel(s.eye)[0] ? -38 : 10, -10);  // not over the V of its line
      for (const { g, read } of this.handles.values()) {
        const [x, y] = this.pixel(read(s));
        g.setAttribute('transform', `translate(${x} ${y})`);
      }
    }
  }

  const copy = (data) => JSON.parse(JSON.stringify(data));
  const fixed = (v) => (Math.abs(v) > 1e6 ? '∞' : (Math.abs(v) < 5e-4 ? 0 : v).toFixed(3).replace('-', '−'));
  const within = (v) => (fixed(v).startsWith('−') ? `(${fixed(v)})` : fixed(v));  // of a formula
  const triple = (v) => `(${v.map(fixed).join(', ')})`;
  const angle = (v) => `${v.toFixed(1)}°`;

  function rows(s, n) {
    const walls = n.t.map((v, i) => ({ name: `t_${AXES[i]}`, value: fixed(v), wins: i === n.axis,
      how: `(${n.reflection[i] < 0 ? 'min' : 'max'}_${AXES[i]} − P_${AXES[i]}) / R_${AXES[i]} = (${fixed(n.reflection[i] < 0 ? s.box.min[i] : s.box.max[i])} − ${within(s.position[i])}) / ${within(n.reflection[i])}` }));
    return [
      { name: 'P', value: triple(s.position), how: say('the point that reflects') },
      { name: 'N', value: triple(s.normal), how: say('its normal') },
      { name: 'V', value: triple(n.view), how: say('from P towards the eye') },
      { name: 'R', value: triple(n.reflection), how: '2 (N · V) N − V' },
      ...walls,
      { name: 'd', value: fixed(n.distance), how: say('the smallest: {0} wins', `t_${AXES[n.axis]}`) },
      { name: 'H', value: triple(n.hit), how: 'P + d R' },
      { name: 'C', value: triple(s.origin), how: say('where the probe was captured') },
      { name: 'R', value: triple(n.reflection), how: say('sampled without box projection: {0} off', angle(n.bareError)), kind: 'bare' },
      { name: 'H − C', value: triple(n.lookup), how: say('sampled with box projection: {0} off', angle(n.boxError)), kind: 'lookup' },
    ];
  }

  function remark(s, n) {
    if (n.behind) return say('The eye is behind the mirror: R goes straight on.');
    if (n.outside) return say('P is outside of the box: a wall that it has passed gives t = 0, and H is pulled on to the box.');
    if (n.boxError > 0.05) return say('The box does not fit the room (dotted): the ray ends in the ring, the cubemap is sampled elsewhere.');
    return say('The box fits: H is where the ray ends, and H − C finds it in the cubemap, wherever C is.');
  }

  window.boxprobePlan = (host, data) => {
    const start = { position: data.position, normal: data.normal, eye: data.eye, origin: data.origin, box: data.box, room: data.room || data.box };
    let state = copy(start), sideways = data.elevation === 'side', drawings = [];
    host.replaceChildren();
    host.classList.add('live');
    const pictures = element('div', { class: 'plan-views' }, host);
    const bar = element('div', { class: 'plan-bar' }, host);
    const turn = element('button', { type: 'button' }, bar);
    const reset = element('button', { type: 'button' }, bar, say('Start again'));
    const said = element('p', { class: 'plan-said', 'aria-live': 'polite' }, host);
    const table = element('table', { class: 'plan-numbers' }, host);
    const body = element('tbody', {}, table);
    const show = () => {
      const n = numbers(state);
      for (const drawing of drawings) drawing.draw(state, n);
      said.textContent = remark(state, n);
      body.replaceChildren();
      for (const row of rows(state, n)) {
        const tr = element('tr', { class: [row.wins ? 'wins' : '', row.kind || ''].join(' ').trim() }, body);
        subscripted(element('th', { scope: 'row' }, tr), row.name);
        element('td', { class: 'value' }, tr, row.value);
        subscripted(element('td', { class: 'how' }, tr), row.how);
      }
      host.dispatchEvent(new Event('boxprobechange'));
    };
    const changed = (change) => { change(state); show(); };
    const build = () => {
      pictures.replaceChildren();
      drawings = ['plan', sideways ? 'side' : 'front'].map((name) => new Drawing(pictures, name, start, changed));
      turn.textContent = sideways ? say('Look from the front') : say('Look from the side');
      show();
    };
    turn.addEventListener('click', () => { sideways = !sideways; build(); });
    reset.addEventListener('click', () => { state = copy(start); build(); });
    build();
    host.boxprobePlan = { state: () => copy(state), numbers: () => numbers(state) };
  };
})();
