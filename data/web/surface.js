// boxprobeSurface(host, kind): light at a surface, in section. The eye is dragged around a point of it; the arrows are as long as the shares
// of light they carry, and a chart has these shares over the angle. `kind`: "fresnel", a dielectric or a metal; "glass", with the ray that goes
// in; "lobe", with the lobe of a rough surface (GGX with Smith's term, as shaders/shared/ggx.glsl has it), in the plane of the eye.
'use strict';
(() => {
  const { element, takeHold } = boxprobeDrawing, WIDTH = 480, HEIGHT = 330, MIDDLE = [240, 185], FAR = 150, LAST = 88;
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high), radians = (degrees) => degrees * Math.PI / 180;
  const schlick = (f0, cosine) => f0 + (1 - f0) * (1 - cosine) ** 5;

  /** Share that a border between indices 1 and n reflects, unpolarised, from the cosines on both sides. 1: all of it. */
  function fresnel(n, cosine) {
    const inside = 1 - (1 - cosine * cosine) / (n * n);
    if (inside <= 0) return 1;
    const c = Math.sqrt(inside), across = (cosine - n * c) / (cosine + n * c), along = (n * cosine - c) / (n * cosine + c);
    return 0.5 * (across * across + along * along);
  }

  function numbers({ angle, index, roughness, kind, metal, within }) {
    const cosine = Math.cos(radians(angle)), n = within ? 1 / index : index, f0 = metal ? 0.9 : ((index - 1) / (index + 1)) ** 2;
    const sine = Math.sin(radians(angle)) / n, exact = metal ? schlick(f0, cosine) : fresnel(n, cosine);
    const alpha = Math.max(roughness * roughness, 1e-4);
    return { kind, f0, exact, schlick: schlick(f0, cosine), alpha, inside: Math.abs(sine) < 1 ? Math.asin(sine) * 180 / Math.PI : null,
      // Light that leaves at `out` degrees, per unit of solid angle, in the plane of the eye; the other side is negative.
      lobe: (out) => {
        const h = radians(0.5 * (out - angle)), v = radians(angle), l = radians(out);  // the half vector's tilt
        const cv = Math.cos(v), cl = Math.cos(l), tan = Math.tan(h), a2 = alpha * alpha;
        if (cl <= 0 || cv <= 0) return 0;
        const D = 1 / (Math.PI * a2 * Math.cos(h) ** 4 * (1 + tan * tan / a2) ** 2), hidden = (c) => 0.5 * (Math.sqrt(1 + a2 * (1 / (c * c) - 1)) - 1);
        return D / (1 + hidden(cv) + hidden(cl)) / (4 * cv);
      } };
  }

  class Surface {
    constructor(host, kind) {
      this.host = host;
      this.state = { kind, angle: 40, index: 1.5, roughness: kind === 'lobe' ? 0.4 : 0, metal: false, within: false };
      const both = element('div', { class: 'stand-both' }, host);
      this.section = this.figure(both, 'In section: drag the eye');
      this.chart = this.figure(both, kind === 'lobe' ? 'Light over the direction in which it leaves' : 'Share that is reflected, over the angle');
      const bar = element('div', { class: 'figure-bar' }, host);
      if (kind === 'lobe') this.slide(bar, 'roughness p', 'roughness', 0.1, 1);
      else this.slide(bar, 'index of refraction n', 'index', 1.05, 2.5);
      if (kind === 'fresnel') this.check(bar, 'a metal (F₀ = 0.9)', 'metal');
      if (kind === 'glass') this.check(bar, 'from within the glass', 'within');
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      const g = this.grip = element('g', { class: 'handle handle-eye', tabindex: 0, role: 'slider', 'aria-label': 'the eye: drag it or use the arrow keys', 'aria-valuemin': -LAST, 'aria-valuemax': LAST, 'data-handle': `${kind} eye` }, this.section.svg);
      element('circle', { r: 22, class: 'grip' }, g);
      element('circle', { r: 8 }, g);
      element('text', { x: -14, y: -14, class: 'view' }, g, 'eye');
      takeHold(this.section.svg, g, { here: () => this.place(-this.state.angle, FAR), far: (event) => (event.shiftKey ? 26 : 2.6),
        move: ([x, y]) => { this.state.angle = clamp(-Math.atan2(x - MIDDLE[0], Math.max(MIDDLE[1] - y, 1e-6)) * 180 / Math.PI, 0, LAST); this.draw(); } });
      this.draw();
    }

    figure(parent, caption) {
      const figure = element('figure', { class: 'stand-view' }, parent), frame = element('div', { class: 'stand-frame' }, figure);
      const svg = element('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'group', 'aria-label': caption }, frame);
      element('figcaption', {}, figure, caption);
      return { svg, drawn: element('g', {}, svg) };
    }

    slide(bar, name, key, low, high) {
      const label = element('label', {}, bar);
      element('span', { class: 'name' }, label, name);
      const input = element('input', { type: 'range', min: low, max: high, step: 0.01, value: this.state[key], 'data-control': name }, label), output = element('output', {}, label);
      const show = () => { output.textContent = this.state[key].toFixed(2); };
      input.addEventListener('input', () => { this.state[key] = Number(input.value); show(); this.draw(); });
      show();
    }

    check(bar, name, key) {
      const label = element('label', { class: 'check' }, bar), input = element('input', { type: 'checkbox', 'data-control': key }, label);
      label.append(` ${name}`);
      input.addEventListener('change', () => { this.state[key] = input.checked; this.draw(); });
    }

    /** `angle` from the normal, to the right; `far` pixels away. */
    place(angle, far) { return [MIDDLE[0] + far * Math.sin(radians(angle)), MIDDLE[1] - far * Math.cos(radians(angle))]; }

    draw() {
      const { state } = this, n = numbers(state), { drawn } = this.section, { angle } = state;
      const line = (parent, a, b, kind, width) => element('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: kind, ...(width ? { style: `stroke-width:${width}` } : {}) }, parent);
      drawn.replaceChildren();
      line(drawn, [20, MIDDLE[1]], [WIDTH - 20, MIDDLE[1]], 'floor-line');
      line(drawn, [MIDDLE[0], MIDDLE[1] - 165], [MIDDLE[0], MIDDLE[1] + 135], 'here');
      const eye = this.place(-angle, FAR);
      line(drawn, eye, MIDDLE, 'view', 3);
      if (state.kind === 'lobe') {
        const outs = Array.from({ length: 359 }, (_, i) => (i - 179) / 2), values = outs.map(n.lobe), most = Math.max(...values);
        element('polygon', { points: outs.map((out, i) => this.place(out, FAR * values[i] / most).join()).join(' '), class: 'lobe' }, drawn);
        line(drawn, MIDDLE, this.place(angle, FAR), 'reflected');
      } else {
        line(drawn, MIDDLE, this.place(angle, FAR * n.exact), 'reflected', 6);
        if (!state.metal && n.inside !== null) line(drawn, MIDDLE, this.place(180 - n.inside, 135 * (1 - n.exact)), 'lookup', 6);
        element('text', { x: WIDTH - 130, y: MIDDLE[1] - 10, class: 'axis' }, drawn, state.within ? 'glass' : 'air');
        element('text', { x: WIDTH - 130, y: MIDDLE[1] + 24, class: 'axis' }, drawn, state.metal ? 'metal' : state.within ? 'air' : `n = ${state.index.toFixed(2)}`);
      }
      this.grip.setAttribute('transform', `translate(${eye.join(' ')})`);
      this.grip.setAttribute('aria-valuenow', Math.round(angle));
      this.plot(n);
      this.host.dataset.angle = angle;
      if (state.kind === 'lobe') {
        const outs = Array.from({ length: 1799 }, (_, i) => (i - 899) / 10), peak = outs.reduce((best, out) => (n.lobe(out) > n.lobe(best) ? out : best), 0);
        this.said.textContent = `The eye at ${angle.toFixed(0)}°, α = ${n.alpha.toFixed(2)}: the mirrored direction is ${angle.toFixed(0)}°, the lobe is brightest at ${peak.toFixed(0)}°.`;
      } else {
        const off = n.exact > 0 ? 100 * (n.schlick / n.exact - 1) : 0;
        this.said.textContent = `At ${angle.toFixed(0)}° ${n.exact >= 1 ? 'all of the light is reflected.' : `${(100 * n.exact).toFixed(1)} % is reflected`}${n.exact >= 1 ? '' : state.metal || state.within ? '.' : `; Schlick’s approximation says ${(100 * n.schlick).toFixed(1)} % (${off >= 0 ? '+' : '−'}${Math.abs(off).toFixed(0)} %).`}${state.kind === 'glass' && n.inside !== null ? ` The rest goes on at ${n.inside.toFixed(1)}°.` : ''}`;
      }
    }

    plot(n) {
      const { drawn } = this.chart, { state } = this, low = state.kind === 'lobe' ? -90 : 0, at = (angle, share) => [44 + 416 * (angle - low) / (90 - low), 296 - 266 * clamp(share, 0, 1)];
      drawn.replaceChildren();
      for (let i = 0; i <= 4; i++) {
        const [x, y] = at(low, i / 4);
        element('line', { x1: x, y1: y, x2: 460, y2: y, class: 'grid' }, drawn);
        if (state.kind !== 'lobe') element('text', { x: 2, y: y + 5, class: 'axis' }, drawn, `${25 * i} %`);
      }
      for (let angle = low; angle <= 90; angle += 30) element('text', { x: at(angle, 0)[0] - 14, y: 320, class: 'axis' }, drawn, `${angle}°`);
      const graph = (value, kind) => element('path', { d: Array.from({ length: 181 }, (_, i) => { const angle = low + (90 - low) * i / 180; return `${i ? 'L' : 'M'}${at(angle, value(angle)).map((v) => v.toFixed(1)).join(' ')}`; }).join(''), class: `curve ${kind}` }, drawn);
      if (state.kind === 'lobe') {
        const most = Math.max(...Array.from({ length: 359 }, (_, i) => n.lobe((i - 179) / 2)));
        graph((angle) => n.lobe(angle) / most, 'curve-integral');
      } else {
        graph((angle) => numbers({ ...state, angle }).exact, 'curve-integral');
        if (!state.within) graph((angle) => numbers({ ...state, angle }).schlick, 'curve-hdrp');
        element('text', { x: 56, y: 54, class: 'axis' }, drawn, state.metal ? 'Schlick’s approximation' : state.within ? 'thick: exact' : 'thick: exact, thin: Schlick');
      }
      const here = at(state.angle, 0)[0];
      element('line', { x1: here, y1: 30, x2: here, y2: 296, class: 'here' }, drawn);
    }
  }

  window.boxprobeSurface = (host, kind) => {
    const surface = new Surface(host, kind);
    host.boxprobeSurface = { state: () => ({ ...surface.state }), numbers: () => { const { lobe, ...rest } = numbers(surface.state); return rest; }, lobe: (out) => numbers(surface.state).lobe(out) };
  };
})();
