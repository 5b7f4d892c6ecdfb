// boxprobeSketch(host, kind): a small figure of its own for a lesson, two drawings with handles and a line that says what they show. The
// kinds are in sketches.js. Each is { start: its state, make(sketch), draw(sketch, numbers), numbers(state) }, numbers without drawing.
// Drawings have coordinates of their own, y upwards; handles are dragged by pointer, finger and arrow keys, Shift for ten times as far.
'use strict';
const boxprobeSketchKinds = {};
(() => {
  const { element, say, takeHold } = boxprobeDrawing, WIDTH = 480, HEIGHT = 330, INSET = 14;

  class Drawing {
    /** `window`: [left, right, bottom, top] that fits into the paper; `chart`: across and up have scales of their own. */
    constructor(sketch, caption, [left, right, bottom, top], { chart = false, inset = [INSET, INSET, INSET, INSET] } = {}) {
      this.sketch = sketch;
      const figure = element('figure', { class: 'stand-view' }, sketch.both), frame = element('div', { class: 'stand-frame' }, figure);
      this.svg = element('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'group', 'aria-label': caption }, frame);
      element('figcaption', {}, figure, caption);
      this.drawn = element('g', {}, this.svg);
      const wide = (WIDTH - inset[0] - inset[1]) / (right - left), tall = (HEIGHT - inset[2] - inset[3]) / (top - bottom);
      this.scale = chart ? [wide, tall] : [Math.min(wide, tall), Math.min(wide, tall)];
      const spare = [WIDTH - inset[0] - inset[1] - this.scale[0] * (right - left), HEIGHT - inset[2] - inset[3] - this.scale[1] * (top - bottom)];
      this.corner = [inset[0] + spare[0] / 2 - this.scale[0] * left, HEIGHT - inset[2] - spare[1] / 2 + this.scale[1] * bottom];
      this.handles = [];
    }

    pixel([x, y]) { return [this.corner[0] + this.scale[0] * x, this.corner[1] - this.scale[1] * y]; }
    space([x, y]) { return [(x - this.corner[0]) / this.scale[0], (this.corner[1] - y) / this.scale[1]]; }

    clear() { this.drawn.replaceChildren(); }
    line(from, to, kind, width) {
      const [a, b] = [this.pixel(from), this.pixel(to)];
      return element('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: kind, ...(width ? { style: `stroke-width:${width}` } : {}) }, this.drawn);
    }
    path(points, kind, closed = false) {
      const d = points.map((p, i) => `${i ? 'L' : 'M'}${this.pixel(p).map((v) => v.toFixed(1)).join(' ')}`).join('');
      return element('path', { d: closed ? `${d}Z` : d, class: kind }, this.drawn);
    }
    rect(low, high, kind, colour) {
      const [a, b] = [this.pixel(low), this.pixel(high)];
      element('rect', { x: Math.min(a[0], b[0]), y: Math.min(a[1], b[1]), width: Math.abs(b[0] - a[0]), height: Math.abs(b[1] - a[1]), class: kind, ...(colour ? { style: `fill:${colour}` } : {}) }, this.drawn);
    }
    circle(at, radius, kind) {
      const [x, y] = this.pixel(at);
      element('circle', { cx: x, cy: y, r: radius, class: kind }, this.drawn);
    }
    arrow(from, to, kind) {
      this.line(from, to, kind, 2.5);
      const [a, b] = [this.pixel(from), this.pixel(to)], size = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (size < 12) return;
      const u = [(b[0] - a[0]) / size, (b[1] - a[1]) / size], corner = (s) => `${b[0] - 11 * u[0] - s * 5 * u[1]},${b[1] - 11 * u[1] + s * 5 * u[0]}`;
      element('polygon', { points: `${b[0]},${b[1]} ${corner(1)} ${corner(-1)}`, class: `${kind} head` }, this.drawn);
    }
    text(at, text, kind, dx = 10, dy = -9) {
      const [x, y] = this.pixel(at), made = element('text', { class: kind }, this.drawn, text), wide = 10 * text.length;
      made.setAttribute('x', Math.min(Math.max(x + dx, 4), WIDTH - 4 - Math.min(wide, WIDTH - 8)));
      made.setAttribute('y', Math.min(Math.max(y + dy, 17), HEIGHT - 5));
    }
    /** Lines of a chart: `across` and `up` are lists of [value, text]. */
    grid(across, up) {
      const [left, right, bottom] = this.frame;
      for (const [value, text] of up) {
        this.line([left, value], [right, value], 'grid');
        element('text', { x: 3, y: this.pixel([left, value])[1] + 5, class: 'axis' }, this.drawn, text);
      }
      for (const [value, text] of across) element('text', { x: this.pixel([value, bottom])[0], y: HEIGHT - 8, class: 'axis', 'text-anchor': 'middle' }, this.drawn, text);
    }

    /** `read(state)` is its place, `write(state, place)` puts it; `text` stands beside it. */
    handle(name, label, kind, read, write, text = '', [dx, dy] = [12, -9]) {
      const g = element('g', { class: `handle handle-${kind}`, tabindex: 0, role: 'button', 'aria-label': say('{0}: drag it or use the arrow keys', label), 'data-handle': name }, this.svg);
      element('circle', { r: 22, class: 'grip' }, g);
      element('circle', { r: 8 }, g);
      if (text) element('text', { x: dx, y: dy, class: { eye: 'view', C: 'lookup', P: 'reflected' }[kind] || 'plain' }, g, text);
      takeHold(this.svg, g, { here: () => this.pixel(read(this.sketch.state)), far: (event) => 0.05 * this.scale[0] * (event.shiftKey ? 10 : 1),
        move: (pixel) => { write(this.sketch.state, this.space(pixel)); this.sketch.redraw(); } });
      this.handles.push({ g, read });
    }

    placeHandles() {
      for (const { g, read } of this.handles) g.setAttribute('transform', `translate(${this.pixel(read(this.sketch.state)).map((v) => v.toFixed(2)).join(' ')})`);
    }
  }

  class Sketch {
    constructor(host, kind) {
      this.host = host;
      this.kind = Object.create(boxprobeSketchKinds[kind]);  // two lessons may have one figure
      this.state = JSON.parse(JSON.stringify(this.kind.start));
      this.both = element('div', { class: 'stand-both' }, host);
      this.drawings = [];
      this.inputs = [];
      this.bar = element('div', { class: 'figure-bar sketch-bar' }, host);
      this.kind.make(this);
      element('button', { type: 'button', 'data-control': 'start again' }, this.bar, say('Start again')).addEventListener('click', () => {
        this.state = JSON.parse(JSON.stringify(this.kind.start));
        for (const show of this.inputs) show();
        this.draw();
      });
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      this.draw();
    }

    drawing(caption, window, options) {
      const made = new Drawing(this, caption, window, options);
      this.drawings.push(made);
      return made;
    }
    /** A chart has room for its letters at the left and below. */
    chart(caption, [left, right, bottom, top]) {
      const made = this.drawing(caption, [left, right, bottom, top], { chart: true, inset: [58, 16, 34, 16] });
      made.frame = [left, right, bottom, top];
      return made;
    }

    slide(name, key, low, high, step, shown = (v) => v.toFixed(2)) {
      const label = element('label', {}, this.bar);
      element('span', { class: 'name' }, label, name);
      const input = element('input', { type: 'range', min: low, max: high, step, 'data-control': key }, label), output = element('output', {}, label);
      const show = () => { input.value = this.state[key]; output.textContent = shown(this.state[key]); };
      input.addEventListener('input', () => { this.state[key] = Number(input.value); show(); this.redraw(); });
      this.inputs.push(show);
      show();
    }

    /** One of several: `options` are [value, text]. */
    choose(name, key, options) {
      const group = element('span', { class: 'choices', role: 'radiogroup', 'aria-label': name }, this.bar), id = `${key}-${Math.random().toString(36).slice(2)}`;
      const inputs = options.map(([value, text]) => {
        const label = element('label', { class: 'check' }, group), input = element('input', { type: 'radio', name: id, value, 'data-control': `${key} ${value}` }, label);
        label.append(` ${text}`);
        input.addEventListener('change', () => { this.state[key] = value; this.redraw(); });
        return input;
      });
      const show = () => { for (const input of inputs) input.checked = input.value === this.state[key]; };
      this.inputs.push(show);
      show();
    }

    /** What the curves of the chart are: `keys` are [kind, text]. */
    keys(keys) {
      const line = element('p', { class: 'keys' }, this.host);
      for (const [kind, text] of keys) element('span', { class: `key key-${kind}` }, line, text);
    }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => { this.waiting = false; this.draw(); });
    }

    draw() {
      const numbers = this.kind.numbers(this.state);
      for (const drawing of this.drawings) drawing.clear();
      this.said.textContent = this.kind.draw(this, numbers);
      for (const drawing of this.drawings) drawing.placeHandles();
      this.host.dataset.drawn = String(Number(this.host.dataset.drawn || 0) + 1);
    }
  }

  window.boxprobeSketch = (host, kind) => {
    const sketch = new Sketch(host, kind);
    host.boxprobeSketch = { state: () => JSON.parse(JSON.stringify(sketch.state)), put: (state) => { Object.assign(sketch.state, state); sketch.draw(); }, numbers: () => sketch.kind.numbers(sketch.state) };
  };
})();
