// boxprobeCone(host): from a rough lobe to texels, in section. A ray from P on the floor is reflected to a wall; its lobe's cone meets a
// patch of that wall; from C the patch fills another solid angle, which says how blurred a level shows it as it should be. Beside it the
// level over P's distance from the wall: first drawn by hand, then as one level for all, by HDRP's ratio, by J at the middle ray, and by
// the integral over the cone. Metres; x along the floor to the wall, y up, z across. Levels as in app/lessons: alpha = p^2 = (2^l - 1) / 63.
'use strict';
(() => {
  const { element, takeHold, ofBrowser } = boxprobeDrawing, WALL = 4, LAST = 6, TEXELS = 256, ELEVATION = 25 * Math.PI / 180, RINGS = 24, AROUND = 48;
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
  const levelOf = (alpha) => clamp(Math.log2(1 + 63 * clamp(alpha, 0, 1)), 0, LAST);
  /** Of the lobe that holds half of the projected area of its microfacets: a ray turns by twice the tilt, whose tangent is alpha. */
  const coneAngle = (alpha) => 2 * Math.atan(alpha);

  /** All that is drawn, for P at `away` metres from the wall. */
  function numbers({ away, origin, roughness }) {
    const alpha = roughness * roughness, delta = coneAngle(alpha), along = [Math.cos(ELEVATION), Math.sin(ELEVATION)];
    const toWall = WALL - origin[0], d = away / along[0], hit = [WALL, away * along[1] / along[0]];
    const seenFrom = Math.hypot(toWall, hit[1] - origin[1]);
    const ratio = Math.min(d / seenFrom, 1), p1 = ratio * roughness;
    const J = d * d / (seenFrom * seenFrom) * (toWall / seenFrom) / along[0];
    // The cone in rings of equal solid angle; each part's own J. Parts that miss the wall or lie below the floor count for nothing.
    let fromC = 0, kept = 0;
    for (let ring = 0; ring < RINGS; ring++) {
      const cosine = 1 - (ring + 0.5) / RINGS * (1 - Math.cos(delta)), sine = Math.sqrt(1 - cosine * cosine);
      for (let k = 0; k < AROUND; k++) {
        const turn = 2 * Math.PI * (k + 0.5) / AROUND, side = sine * Math.sin(turn), up = sine * Math.cos(turn);
        const ray = [cosine * along[0] - up * along[1], cosine * along[1] + up * along[0], side];
        if (ray[0] <= 1e-6 || ray[1] < 0) continue;
        const t = away / ray[0], y = t * ray[1] - origin[1], z = t * ray[2], r = Math.hypot(toWall, y, z);
        fromC += t * t / (r * r) * (toWall / r) / ray[0];
        kept += 1;
      }
    }
    const part = 2 * Math.PI * (1 - Math.cos(delta)) / (RINGS * AROUND), solidAngle = fromC * part;
    // The lobe whose cone, seen from C, fills as much.
    const whole = kept ? solidAngle * RINGS * AROUND / kept : 0, alphaThere = Math.tan(Math.acos(clamp(1 - whole / (2 * Math.PI), -1, 1)) / 2);
    const edge = (s) => { const angle = clamp(ELEVATION + s * delta, 0, 1.55); return away * Math.tan(angle); };
    return {
      alpha, delta, hit, d, seenFrom, ratio, J, solidAngle, along, low: edge(-1), high: edge(1),
      levels: { none: levelOf(alpha), hdrp: levelOf((p1 + (roughness - p1) * roughness) ** 2), J: levelOf(alpha * Math.sqrt(J)), integral: levelOf(alphaThere) },
    };
  }

  const FORMS = [['guess', 'your guess'], ['none', 'one level for all'], ['hdrp', 'ratio of distances (HDRP)'], ['J', 'J of the middle ray'], ['integral', 'integral over the cone']];
  const COLUMNS = 40, FARTHEST = 3.8, WIDTH = 480, HEIGHT = 330;

  class Cone {
    constructor(host) {
      this.host = host;
      this.state = { away: 1.5, origin: [1.6, 1.5], roughness: 0.4 };
      this.guess = new Array(COLUMNS).fill(null);
      this.revealed = false;
      const both = element('div', { class: 'stand-both' }, host);
      this.section = this.figure(both, 'In section: drag P and C');
      this.chart = this.figure(both, 'Which level? Draw it over the distance of P from the wall');
      const bar = element('div', { class: 'figure-bar' }, host);
      const label = element('label', {}, bar);
      element('span', { class: 'name' }, label, 'roughness p');
      this.slider = element('input', { type: 'range', min: 0.1, max: 0.7, step: 0.01, value: 0.4, 'data-control': 'cone roughness' }, label);
      this.output = element('output', {}, label);
      this.show = element('button', { type: 'button', 'data-control': 'reveal' }, bar, 'Show without a guess');
      const again = element('button', { type: 'button' }, bar, 'Start again');
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      this.slider.addEventListener('input', () => { this.state.roughness = Number(this.slider.value); this.draw(); });
      this.show.addEventListener('click', () => { this.revealed = true; this.draw(); });
      again.addEventListener('click', () => {
        Object.assign(this, { state: { away: 1.5, origin: [1.6, 1.5], roughness: 0.4 }, guess: new Array(COLUMNS).fill(null), revealed: false });
        this.slider.value = 0.4;
        this.draw();
      });
      this.handles = [this.handle('P', (s) => [WALL - s.away, 0], (s, at) => { s.away = clamp(WALL - at[0], 0.05, FARTHEST); }),
        this.handle('C', (s) => s.origin, (s, at) => { s.origin = [clamp(at[0], 0.2, WALL - 0.2), clamp(at[1], 0.1, 2.9)]; })];
      this.drawing();
      this.draw();
    }

    figure(parent, caption) {
      const figure = element('figure', { class: 'stand-view' }, parent), frame = element('div', { class: 'stand-frame' }, figure);
      const svg = element('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'group', 'aria-label': caption }, frame);
      element('figcaption', {}, figure, caption);
      return { svg, drawn: element('g', {}, svg) };
    }

    // The section: 4.2 m wide, from 0.2 m below the floor.
    pixel([x, y]) { return [10 + 108 * x, HEIGHT - 22 - 102 * y]; }
    space([u, v]) { return [(u - 10) / 108, (HEIGHT - 22 - v) / 102]; }
    // The chart.
    place(away, level) { return [40 + 420 * away / FARTHEST, 300 - 280 * level / LAST]; }

    at(svg, event) {
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [point.x, point.y];
    }

    handle(name, read, write) {
      const { svg } = this.section;
      const g = element('g', { class: `handle handle-${name}`, tabindex: 0, role: 'button', 'aria-label': `${name}: drag it or use the arrow keys`, 'data-handle': `cone ${name}` }, svg);
      element('circle', { r: 20, class: 'grip' }, g);
      element('circle', { r: 8 }, g);
      element('text', { x: -20, y: -9, class: name === 'C' ? 'lookup' : 'reflected' }, g, name);
      const move = (pixel) => {
        write(this.state, this.space(pixel));
        this.draw();
      };
      takeHold(svg, g, { here: () => this.pixel(read(this.state)), move, far: (event) => 108 * (event.shiftKey ? 0.5 : 0.05) });
      return { g, read };
    }

    /** A guess, by pointer or keys: the level at P's own distance goes up and down. */
    drawing() {
      const { svg } = this.chart;
      svg.style.touchAction = 'pan-y';
      svg.setAttribute('tabindex', 0);
      svg.classList.add('draws');
      let last = null;
      const put = (event) => {
        const [u, v] = this.at(svg, event), column = clamp(Math.floor((u - 40) / 420 * COLUMNS), 0, COLUMNS - 1), level = clamp((300 - v) / 280 * LAST, 0, LAST);
        const from = last || [column, level], count = Math.abs(column - from[0]);
        for (let i = 0; i <= count; i++) this.guess[from[0] + Math.sign(column - from[0]) * i] = count ? from[1] + (level - from[1]) * i / count : level;
        last = [column, level];
        this.draw();
      };
      svg.addEventListener('pointerdown', (event) => {
        if (event.button !== 0 || this.revealed) return;
        event.preventDefault();
        svg.setPointerCapture(event.pointerId);
        last = null;
        put(event);
      });
      svg.addEventListener('pointermove', (event) => { if (svg.hasPointerCapture(event.pointerId)) put(event); });
      for (const end of ['pointerup', 'pointercancel']) svg.addEventListener(end, () => { last = null; });
      svg.addEventListener('keydown', (event) => {
        const way = { ArrowUp: 0.25, ArrowDown: -0.25, ArrowLeft: 0, ArrowRight: 0 }[event.key];
        if (way === undefined || ofBrowser(event) || this.revealed) return;
        event.preventDefault();
        const turn = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0, before = clamp(Math.floor(this.state.away / FARTHEST * COLUMNS), 0, COLUMNS - 1);
        const column = clamp(before + turn, 0, COLUMNS - 1);
        this.guess[column] = clamp((this.guess[column] ?? this.guess[before] ?? 3) + way, 0, LAST);
        this.state.away = (column + 0.5) / COLUMNS * FARTHEST;
        this.draw();
      });
    }

    curves() {
      const columns = this.guess.map((_, i) => numbers({ ...this.state, away: (i + 0.5) / COLUMNS * FARTHEST }).levels);
      const curve = Object.fromEntries(FORMS.slice(1).map(([id]) => [id, columns.map((levels) => levels[id])]));
      curve.guess = this.guess;
      const error = {};
      for (const [id] of FORMS) {
        const off = curve[id].map((v, i) => (v === null ? null : Math.abs(v - curve.integral[i]))).filter((v) => v !== null);
        error[id] = off.length ? off.reduce((sum, v) => sum + v, 0) / off.length : null;
      }
      return { curve, error };
    }

    draw() {
      const n = numbers(this.state), { drawn } = this.section, { origin, away } = this.state;
      const drawnColumns = this.guess.filter((v) => v !== null).length;
      const line = (a, b, kind) => { const [p, q] = [this.pixel(a), this.pixel(b)]; element('line', { x1: p[0], y1: p[1], x2: q[0], y2: q[1], class: kind }, drawn); };
      drawn.replaceChildren();
      const position = [WALL - away, 0], top = 2.95, high = Math.min(n.high, top), low = Math.min(n.low, top);
      const wedge = (from, a, b, kind) => element('polygon', { points: [from, [WALL, a], [WALL, b]].map((p) => this.pixel(p).join()).join(' '), class: kind }, drawn);
      wedge(position, low, high, 'lobe');
      wedge(origin, low, high, 'patch');
      line([0, 0], [WALL, 0], 'floor-line');
      // Texels of the level along the wall: of a face that looks at it they are of one width.
      const level = Math.round(n.levels.integral), texel = 2 * (WALL - origin[0]) / (TEXELS >> level);
      if (this.revealed) {
        for (let i = Math.ceil((0 - origin[1]) / texel); origin[1] + i * texel < top && texel > 0.012; i++) line([WALL, Math.max(origin[1] + i * texel, 0)], [WALL + 0.09, Math.max(origin[1] + i * texel, 0)], 'texel');
      }
      line([WALL, 0], [WALL, top], 'floor-line');
      line(position, [WALL, Math.min(n.hit[1], top)], 'reflected');
      line(origin, [WALL, Math.min(n.hit[1], top)], 'lookup');
      line([WALL, low], [WALL, high], 'footprint');
      for (const { g, read } of this.handles) g.setAttribute('transform', `translate(${this.pixel(read(this.state)).join(' ')})`);
      this.output.textContent = this.state.roughness.toFixed(2);
      // The chart.
      const chart = this.chart.drawn;
      chart.replaceChildren();
      for (let l = 0; l <= LAST; l++) {
        const [x, y] = this.place(0, l);
        element('line', { x1: x, y1: y, x2: 460, y2: y, class: 'grid' }, chart);
        element('text', { x: 14, y: y + 6, class: 'axis' }, chart, String(l));
      }
      for (let m = 1; m <= 3; m++) element('text', { x: this.place(m, 0)[0] - 12, y: 322, class: 'axis' }, chart, `${m} m`);
      element('text', { x: 46, y: 18, class: 'axis' }, chart, 'level');
      const here = this.place(away, 0)[0];
      element('line', { x1: here, y1: 20, x2: here, y2: 300, class: 'here' }, chart);
      const { curve, error } = this.curves();
      for (const [id] of [...FORMS].reverse()) {  // the integral lies below what is to come near it
        if (id !== 'guess' && !this.revealed) continue;
        let path = '', down = false;
        curve[id].forEach((v, i) => {
          if (v !== null) path += `${down ? 'L' : 'M'}${this.place((i + 0.5) / COLUMNS * FARTHEST, v).map((x) => x.toFixed(1)).join(' ')}`;
          down = v !== null;
        });
        if (path) element('path', { d: path, class: `curve curve-${id}` }, chart);
      }
      this.show.hidden = this.revealed;
      this.show.textContent = drawnColumns > 0.7 * COLUMNS ? 'Compare with my guess' : 'Show without a guess';
      this.host.dataset.revealed = this.revealed;
      if (!this.revealed) {
        this.said.textContent = 'Draw your guess: the level at which one lookup is as blurred as the lobe from P makes it.';
      } else {
        this.said.replaceChildren('Mean error in levels: ');
        FORMS.forEach(([id, name]) => {
          if (id === 'integral' || error[id] === null) return;
          element('span', { class: `key key-${id}` }, this.said, `${name} ${error[id].toFixed(2)}`);
        });
        element('span', { class: 'key key-integral' }, this.said, 'integral over the cone');
      }
      this.host.dispatchEvent(new Event('boxprobechange'));
    }
  }

  window.boxprobeCone = (host) => {
    const cone = new Cone(host);
    element('p', {}, host, 'The level is one part of the error. The other is the lobe’s shape, long and narrow where the view is flat, which no level can give: see what was measured on the pictures.');
    host.boxprobeCone = { state: () => JSON.parse(JSON.stringify(cone.state)), numbers: () => numbers(cone.state), curves: () => cone.curves(), guess: () => [...cone.guess] };
  };
})();
