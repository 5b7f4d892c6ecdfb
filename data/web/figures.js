// Two figures that open the page of lessons.
//
// boxprobeInfinity(host, scene, view): a live room (data/web/room.js) whose floor is a mirror, and one slider: the probe's box from
// infinite, which is R alone, to the room. Beside it the cubemap, unfolded. A point P of the floor, chosen by pointer, finger or arrow
// key, has its ray drawn to what it truly meets, the arrow from C along which the cubemap is sampled, and both places in the cubemap.
//
// boxprobeStand(host, data): the floor in plan as a map of the lookup's error, with the eye and C to drag, in plan and elevation.
//
// Lengths are scene units, in the world. The mathematics is that of data/web/plan.js; tests/outside/page holds both to the compiled one.
'use strict';
(() => {
  const { element, say, takeHold, slabFactor, wayOf } = boxprobeDrawing, ASPECT = 1.6;
  const add = (a, b) => a.map((v, i) => v + b[i]), sub = (a, b) => a.map((v, i) => v - b[i]), scaled = (a, s) => a.map((v) => v * s);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], length = (a) => Math.sqrt(dot(a, a)), unit = (a) => scaled(a, 1 / length(a));
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const clamp = (v, low, high) => Math.min(Math.max(v, low), high);
  const degrees = (a, b) => Math.atan2(length(cross(a, b)), dot(a, b)) * 180 / Math.PI;
  const still = () => window.matchMedia('(prefers-reduced-motion: reduce)').matches;

  const exit = (p, r, box) => {
    const d = Math.min(...p.map((v, i) => slabFactor(v, r[i], box.min[i], box.max[i])));
    return { d, at: p.map((v, i) => clamp(v + d * r[i], box.min[i], box.max[i])) };
  };

  /** Of the point P of a floor that faces up. `box` null: infinite. `room`: the walls that are there. */
  function lookupOf({ position, eye, origin, box, room }) {
    const view = unit(sub(eye, position)), reflection = [-view[0], view[1], -view[2]];
    const truth = exit(position, reflection, room).at, seen = sub(truth, origin);
    const hit = box ? exit(position, reflection, box) : null;
    const lookup = hit ? sub(hit.at, origin) : reflection;
    return { view, reflection, truth, seen, lookup, hit: hit && hit.at, distance: hit ? hit.d : Infinity, errorDegrees: degrees(lookup, seen) };
  }

  function arrow(svg, from, to, kind, head = true) {
    element('line', { x1: from[0], y1: from[1], x2: to[0], y2: to[1], class: kind }, svg);
    const size = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (!head || size < 10) return;
    const u = [(to[0] - from[0]) / size, (to[1] - from[1]) / size], corner = (s) => `${to[0] - 11 * u[0] - s * 5 * u[1]},${to[1] - 11 * u[1] + s * 5 * u[0]}`;
    element('polygon', { points: `${to[0]},${to[1]} ${corner(1)} ${corner(-1)}`, class: `${kind} head` }, svg);
  }

  // The unfolded cube as it is seen from within: each face by its middle, its right and its up, and its place in the cross.
  const FACES = [
    { forward: [-1, 0, 0], right: [0, 0, -1], up: [0, 1, 0], column: 0, row: 1, name: '−x' }, { forward: [0, 0, -1], right: [1, 0, 0], up: [0, 1, 0], column: 1, row: 1, name: '−z' },
    { forward: [1, 0, 0], right: [0, 0, 1], up: [0, 1, 0], column: 2, row: 1, name: '+x' }, { forward: [0, 0, 1], right: [-1, 0, 0], up: [0, 1, 0], column: 3, row: 1, name: '+z' },
    { forward: [0, 1, 0], right: [1, 0, 0], up: [0, 0, 1], column: 1, row: 0, name: '+y' }, { forward: [0, -1, 0], right: [1, 0, 0], up: [0, 0, -1], column: 1, row: 2, name: '−y' },
  ];
  /** Place of a direction in the cross, in faces from the top left: x to 4, y to 3. */
  function inCross(direction) {
    const face = FACES.reduce((best, f) => (dot(f.forward, direction) > dot(best.forward, direction) ? f : best)), depth = dot(face.forward, direction);
    return [face.column + 0.5 + 0.5 * dot(face.right, direction) / depth, face.row + 0.5 - 0.5 * dot(face.up, direction) / depth];
  }

  class Infinity_ {
    constructor(host, room) {
      this.host = host;
      this.room = room;
      this.canvas = room.gl.canvas;
      const probe = room.probes[0], world = probe.axes.map((axis) => dot(probe.origin, axis));
      this.origin = probe.origin;
      this.walls = { min: add(probe.boxMin, world), max: add(probe.boxMax, world) };
      this.fit = { min: [...probe.boxMin], max: [...probe.boxMax] };
      const floor = room.scene.objects.find((object) => object.name === 'floor');
      this.floor = { y: floor.max[1], min: floor.min, max: floor.max };
      this.size = 0;  // one over the box's size, in rooms
      this.share = [0.62, 0.78];  // place of P in the picture, from the top left
      this.build();
      this.unfold();
      this.choose(...this.share);
      new ResizeObserver(() => this.redraw()).observe(this.canvas);
      host.addEventListener('boxproberestored', () => { this.unfold(); this.redraw(); });
      this.redraw();
    }

    build() {
      const { host, canvas } = this;
      const both = element('div', { class: 'figure-both' }, host);
      this.picture = element('div', { class: 'figure-picture' }, both);
      this.picture.append(canvas);
      canvas.setAttribute('role', 'application');  // its keys are its own
      canvas.setAttribute('aria-label', say('A room with a mirror floor. Point at the floor, or move the point by the arrow keys.'));
      canvas.style.touchAction = 'pan-y';
      this.over = element('svg', { class: 'figure-over', 'aria-hidden': 'true' }, this.picture);
      const side = element('div', { class: 'figure-map' }, both);
      this.map = element('canvas', { width: 512, height: 384, role: 'img', 'aria-label': say('The cubemap, unfolded: six pictures captured at C') }, side);
      this.mapOver = element('svg', { class: 'figure-over', viewBox: '0 0 512 384', 'aria-hidden': 'true' }, side);
      const bar = element('div', { class: 'figure-bar' }, host);
      const label = element('label', {}, bar);
      element('span', { class: 'name' }, label, say('size of the box'));
      element('span', { class: 'end' }, label, say('infinite: R alone'));
      this.slider = element('input', { type: 'range', min: 0, max: 1000, step: 1, value: 0, 'data-control': 'box size', 'aria-label': say('size of the box, from infinite to the room') }, label);
      element('span', { class: 'end' }, label, say('the room'));
      this.output = element('output', {}, label);
      this.play = element('button', { type: 'button' }, bar, say('Play'));
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      this.slider.addEventListener('input', () => { this.stop(); this.setSize(this.slider.value / 1000); });
      this.play.addEventListener('click', () => (this.running ? this.stop() : this.run()));
      const to = (event) => {
        const at = canvas.getBoundingClientRect();
        if (this.choose((event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height)) this.redraw();
      };
      canvas.addEventListener('pointermove', to);
      canvas.addEventListener('pointerdown', to);
      canvas.addEventListener('keydown', (event) => {
        const way = wayOf(event);
        if (!way) return;
        event.preventDefault();
        const far = event.shiftKey ? 0.05 : 0.01;
        if (this.choose(this.share[0] + far * way[0], this.share[1] + far * way[1])) this.redraw();
      });
    }

    /** 0: infinite; 1: the room. */
    setSize(size) {
      this.size = size;
      const { room } = this, probe = room.probes[0];
      room.row = size > 0 ? room.findRow('box', 'none') : room.findRow('infinite', 'none');
      if (size > 0) Object.assign(probe, { boxMin: scaled(this.fit.min, 1 / size), boxMax: scaled(this.fit.max, 1 / size) });
      this.slider.value = Math.round(1000 * size);
      this.redraw();
    }

    run() {
      if (still()) return this.setSize(this.size < 1 ? 1 : 0);
      const from = this.size < 1 ? this.size : 0, to = 1, began = performance.now(), seconds = 4;
      const turn = this.turn = (this.turn || 0) + 1;  // one that was stopped does not go on beside the next
      this.running = true;
      this.play.textContent = say('Stop');
      const frame = (now) => {
        if (!this.running || turn !== this.turn) return;
        const t = clamp((now - began) / (1000 * seconds), 0, 1), eased = t * t * (3 - 2 * t);
        this.setSize(from + (to - from) * eased);
        if (t < 1) requestAnimationFrame(frame);
        else this.stop();
      };
      requestAnimationFrame(frame);
    }

    stop() {
      this.running = false;
      this.play.textContent = say('Play');
    }

    axes() {
      const { camera } = this.room, back = unit(sub(camera.position, camera.target)), right = unit(cross(camera.up, back));
      return { right, up: cross(back, right), back };
    }

    tangents() {
      const tangent = Math.tan(this.room.camera.verticalFovDegrees * Math.PI / 360);
      return [ASPECT * tangent, tangent];  // before the canvas has a size, too
    }

    /** P where the picture shows the floor at these shares of it; false elsewhere. */
    choose(x, y) {
      const { camera } = this.room, { right, up, back } = this.axes(), shape = this.tangents();
      const away = sub(add(scaled(right, (2 * x - 1) * shape[0]), scaled(up, (1 - 2 * y) * shape[1])), back);
      if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1) || away[1] >= 0) return false;
      const at = add(camera.position, scaled(away, (this.floor.y - camera.position[1]) / away[1]));
      if ([0, 2].some((i) => at[i] < this.floor.min[i] || at[i] > this.floor.max[i])) return false;
      this.share = [x, y];
      this.position = at;
      return true;
    }

    state() {
      const box = this.size > 0 ? { min: add(this.origin, scaled(this.fit.min, 1 / this.size)), max: add(this.origin, scaled(this.fit.max, 1 / this.size)) } : null;
      return { position: this.position, eye: this.room.camera.position, origin: this.origin, box, room: this.walls };
    }

    numbers() { return { ...this.state(), ...lookupOf(this.state()), shown: exit(this.origin, unit(lookupOf(this.state()).lookup), this.walls).at }; }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => {
        this.waiting = false;
        if (!this.room.ready) return;
        const finer = Math.min(window.devicePixelRatio || 1, 2);
        const width = Math.max(Math.round(this.canvas.clientWidth * finer), 1), height = Math.max(Math.round(width / ASPECT), 1);
        if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
        this.room.draw();
        this.overlay();
        this.host.dataset.drawn = String(Number(this.host.dataset.drawn || 0) + 1);
      });
    }

    /** Pixels of the overlay; null behind the eye. */
    pixel(at) {
      const { right, up, back } = this.axes(), [tx, ty] = this.tangents(), from = sub(at, this.room.camera.position), depth = -dot(from, back);
      if (depth < 0.02) return null;
      return [320 * (1 + dot(from, right) / depth / tx), 200 * (1 - dot(from, up) / depth / ty)];
    }

    overlay() {
      const n = this.numbers(), { over, mapOver } = this;
      over.setAttribute('viewBox', '0 0 640 400');
      over.replaceChildren();
      const draw = (from, to, kind) => {
        const [a, b] = [this.pixel(from), this.pixel(to)];
        if (a && b) arrow(over, a, b, kind);
      };
      const large = clamp(520 / Math.max(this.canvas.clientWidth, 1), 1, 2);  // on a telephone letters are to be read, too
      const mark = (at, text, kind, dx = 9, dy = -9, hollow = false) => {  // a text at the left of its place ends there
        const pixel = this.pixel(at);
        if (!pixel) return;
        element('circle', { cx: pixel[0], cy: pixel[1], r: large * (hollow ? 8 : 4.5), class: `${kind} ${hollow ? 'ring' : 'dot'}` }, over);
        const wide = 8.5 * large * text.length, x = dx < 0 ? pixel[0] + dx - wide : pixel[0] + dx;
        element('text', { x: clamp(x, 4, 636 - wide), y: clamp(pixel[1] + dy, 14 * large, 394), class: kind, style: `font-size:${15 * large}px` }, over, text);
      };
      draw(n.position, n.truth, 'reflected');
      draw(n.origin, n.shown, 'lookup');
      const apart = length(sub(n.truth, n.shown)) > 0.05;
      const [toTruth, toShown] = [n.truth, n.shown].map((at) => this.pixel(at)), right = !toTruth || !toShown || toTruth[0] >= toShown[0] ? 1 : -1;
      mark(n.truth, apart ? say('should be seen') : 'H', 'reflected', 12 * right, -8, true);
      mark(n.shown, apart ? say('is seen') : '', 'lookup', -10 * right, -10);
      mark(n.origin, 'C', 'lookup', -8, -8);
      mark(n.position, 'P', 'reflected', -8, 18);
      mapOver.replaceChildren();
      const place = (direction) => scaled(inCross(direction), 128);
      const a = unit(n.seen), b = unit(n.lookup), steps = 48;
      let last = place(a);
      for (let i = 1; i <= steps; i++) {  // along the sphere; a step from face to face may leap
        const next = place(unit(add(scaled(a, 1 - i / steps), scaled(b, i / steps))));
        if (Math.hypot(next[0] - last[0], next[1] - last[1]) < 60) element('line', { x1: last[0], y1: last[1], x2: next[0], y2: next[1], class: 'between' }, mapOver);
        last = next;
      }
      const [ring, dotAt] = [place(a), place(b)];
      element('circle', { cx: ring[0], cy: ring[1], r: 10, class: 'reflected ring' }, mapOver);
      element('circle', { cx: dotAt[0], cy: dotAt[1], r: 6, class: 'lookup dot' }, mapOver);
      this.output.textContent = this.size > 0 ? say('{0} × the room', (1 / this.size).toFixed(2)) : say('infinite');
      this.host.dataset.error = n.errorDegrees;
      this.said.textContent = n.errorDegrees < 0.05 ? say('The ray from P and the arrow from C end in one place: this pixel is right.')
        : say('The cubemap is sampled {0}° away from the place where the ray from P ends.', n.errorDegrees.toFixed(1));
    }

    /** The capture into the map, drawn once by the same context. */
    unfold() {
      const { room } = this, { gl } = room, { texts } = room.scene.shaders, width = 512, height = 384, face = 128;
      const program = room.fullScreen('unfold', `${texts['shared/display.glsl']}\nuniform samplerCube bpMap0;\nuniform mat3 bpFace;\nuniform float bpExposure;\nvoid main()\n{\n  vec3 d = bpFace * vec3(2.0 * texCoord - 1.0, 1.0);\n  bpColor = vec4(srgbEncoded(clamp(textureLod(bpMap0, d, 0.0).rgb * bpExposure, 0.0, 1.0)), 1.0);\n}\n`);
      const target = gl.createTexture(), framebuffer = gl.createFramebuffer();
      gl.bindTexture(gl.TEXTURE_2D, target);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT);
      for (const { forward, right, up, column, row } of FACES) {
        gl.viewport(face * column, height - face * (row + 1), face, face);
        room.plain(program, () => {
          room.texture(program, 'bpMap0', 0, gl.TEXTURE_CUBE_MAP, room.probes[0].map);
          gl.uniformMatrix3fv(program.at('bpFace'), false, [...right, ...up, ...forward]);
          gl.uniform1f(program.at('bpExposure'), Math.max(room.scene.exposure, 0));
        });
      }
      const bytes = new Uint8Array(4 * width * height), image = new ImageData(width, height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      for (let y = 0; y < height; y++) image.data.set(bytes.subarray(4 * width * (height - 1 - y), 4 * width * (height - y)), 4 * width * y);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      gl.deleteFramebuffer(framebuffer);
      gl.deleteTexture(target);
      this.map.getContext('2d').putImageData(image, 0, 0);
    }
  }

  /** Resolves when the figure is alive; `host.boxprobeInfinity` is it then. Without WebGL2 a line says so. */
  window.boxprobeInfinity = async (host, scene, view) => {
    await window.boxprobeRoom(host, scene, { panel: false, prepare: (room) => window.boxprobeView(room, view) });
    if (!host.boxprobeRoom) return;
    host.boxprobeInfinity = new Infinity_(host, host.boxprobeRoom);
    host.boxprobeInfinity.setSize(0);
  };

  /** The scene in the element `id`, read once for all figures. */
  const scenes = new Map();
  window.boxprobeScene = (id) => {
    if (!scenes.has(id)) scenes.set(id, JSON.parse(document.getElementById(id).textContent));
    return scenes.get(id);
  };

  /** Starts the infinity slider, once: where it opens the page, while the rest is still read. */
  window.boxprobeOpen = async (host) => {
    if ('begun' in host.dataset) return;
    host.dataset.begun = '';
    await window.boxprobeInfinity(host, window.boxprobeScene(host.dataset.scene), JSON.parse(host.dataset.view));
    if (!host.boxprobeInfinity) return;
    host.querySelector('.figure-still').remove();
    performance.mark('the opening figure is alive');
  };

  // Of the error: black is none; the far end is that of 60 degrees and more. Perceived evenly, and told apart without colours.
  const HEAT = [[0, 0, 0], [46, 20, 94], [130, 30, 110], [214, 72, 66], [250, 160, 60], [252, 250, 180]], HEAT_END = 60;
  function heat(error) {
    const t = clamp(error / HEAT_END, 0, 1) * (HEAT.length - 1), i = Math.min(Math.floor(t), HEAT.length - 2);
    return HEAT[i].map((v, c) => v + (t - i) * (HEAT[i + 1][c] - v));
  }

  const COLUMNS = 128, WIDTH = 480, FOUND_DEGREES = 1;

  class Stand {
    constructor(host, data) {
      this.host = host;
      this.start = data;
      this.room = data.room;
      this.state = { eye: [...data.eye], origin: [...data.origin], box: false };
      const size = sub(this.room.max, this.room.min);
      this.scale = WIDTH / size[0];
      this.depth = Math.round(size[2] * this.scale);
      this.height = size[1] * this.scale;
      const both = element('div', { class: 'stand-both' }, host);
      this.views = ['plan', 'elevation'].map((name) => this.view(both, name));
      const bar = element('div', { class: 'figure-bar' }, host);
      const label = element('label', { class: 'check' }, bar);
      this.check = element('input', { type: 'checkbox', 'data-control': 'box' }, label);
      label.append(` ${say('box projection')}`);
      // The place to be found is not shown before it is: then its ring, its name and a button are.
      this.show = element('button', { type: 'button', 'data-control': 'show the place' }, bar, say('Show the place'));
      this.under = element('button', { type: 'button', 'data-control': 'mirrored eye', hidden: '' }, bar, say('Drop C on the mirrored eye'));
      const again = element('button', { type: 'button' }, bar, say('Start again'));
      const key = element('span', { class: 'stand-key' }, bar);
      key.append('0°');
      element('span', { class: 'stand-scale', style: `background:linear-gradient(to right,${HEAT.map((c) => `rgb(${c})`).join(',')})` }, key);
      key.append(say('{0}° and more', HEAT_END));
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      this.check.addEventListener('change', () => { this.state.box = this.check.checked; this.redraw(); });
      this.show.addEventListener('click', () => { this.found = true; this.redraw(); });
      this.under.addEventListener('click', () => { const [x, y, z] = this.state.eye; this.state.origin = [x, 2 * this.room.min[1] - y, z]; this.redraw(); });
      again.addEventListener('click', () => { this.state = { eye: [...data.eye], origin: [...data.origin], box: false }; this.check.checked = this.found = false; this.redraw(); });
      this.redraw();
    }

    /** Paper of a view: plan with z downwards; elevation with the mirrored room below the floor. */
    pixel(name, p) {
      const x = (p[0] - this.room.min[0]) * this.scale;
      return name === 'plan' ? [x, (p[2] - this.room.min[2]) * this.scale] : [x, this.height - (p[1] - this.room.min[1]) * this.scale];
    }

    view(parent, name) {
      const tall = name === 'plan' ? this.depth : 2 * this.height, figure = element('figure', { class: 'stand-view' }, parent);
      const frame = element('div', { class: 'stand-frame' }, figure), view = { name, tall };
      if (name === 'plan') view.canvas = element('canvas', { width: COLUMNS, height: Math.round(COLUMNS * this.depth / WIDTH), role: 'img', 'aria-label': say('Error of the lookup over the floor') }, frame);
      view.svg = element('svg', { viewBox: `0 0 ${WIDTH} ${tall.toFixed(0)}`, role: 'group', 'aria-label': name === 'plan' ? say('Plan of the floor') : say('Elevation, with the mirror world below the floor') }, frame);
      element('figcaption', {}, figure, name === 'plan' ? say('The floor, from above: how far each point’s lookup is off') : say('From the front; below the line lies the mirror world'));
      view.drawn = element('g', {}, view.svg);
      view.handles = ['eye', 'origin'].map((key) => this.handle(view, key));
      return view;
    }

    handle(view, key) {
      const said = key === 'eye' ? say('the eye') : say('C, the capture origin');
      const g = element('g', { class: `handle handle-${key === 'eye' ? 'eye' : 'C'}`, tabindex: 0, role: 'button', 'aria-label': say('{0}: drag it or use the arrow keys', said), 'data-handle': `${view.name} ${key}` }, view.svg);
      element('circle', { r: 22, class: 'grip' }, g);
      element('circle', { r: 8 }, g);
      element('text', { x: 13, y: -9, class: key === 'eye' ? 'view' : 'lookup' }, g, key === 'eye' ? say('eye') : 'C');
      const move = (pixel) => {
        const p = this.state[key], { min, max } = this.room;
        p[0] = clamp(min[0] + pixel[0] / this.scale, min[0], max[0]);
        if (view.name === 'plan') p[2] = clamp(min[2] + pixel[1] / this.scale, min[2], max[2]);
        else p[1] = clamp(min[1] + (this.height - pixel[1]) / this.scale, key === 'eye' ? min[1] + 0.05 : 2 * min[1] - max[1], max[1]);
        this.redraw();
      };
      takeHold(view.svg, g, { here: () => this.pixel(view.name, this.state[key]), move, far: (event) => this.scale * (event.shiftKey ? 0.5 : 0.05) });
      return { g, key };
    }

    errorAt(x, z) {
      const { eye, origin, box } = this.state;
      return lookupOf({ position: [x, this.room.min[1], z], eye, origin, box: box ? this.room : null, room: this.room }).errorDegrees;
    }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => { this.waiting = false; this.draw(); });
    }

    draw() {
      const { min, max } = this.room, { canvas } = this.views[0], { width, height } = canvas;
      const image = new ImageData(width, height);
      let sum = 0, most = 0;
      for (let row = 0; row < height; row++) {
        for (let column = 0; column < width; column++) {
          const error = this.errorAt(min[0] + (column + 0.5) / width * (max[0] - min[0]), min[2] + (row + 0.5) / height * (max[2] - min[2]));
          sum += error;
          most = Math.max(most, error);
          image.data.set([...heat(error), 255], 4 * (row * width + column));
        }
      }
      canvas.getContext('2d').putImageData(image, 0, 0);
      this.mean = sum / (width * height);
      const { eye, origin, box } = this.state, mirrored = [eye[0], 2 * min[1] - eye[1], eye[2]];
      if (!box && this.mean < FOUND_DEGREES) this.found = true;
      this.show.hidden = !!this.found;
      this.under.hidden = !this.found;
      for (const view of this.views) {
        view.drawn.replaceChildren();
        if (view.name === 'elevation') {
          element('rect', { x: 0, y: 0, width: WIDTH, height: this.height, class: 'above' }, view.drawn);
          element('line', { x1: 0, y1: this.height, x2: WIDTH, y2: this.height, class: 'floor-line' }, view.drawn);
        }
        const at = this.pixel(view.name, mirrored);
        if (this.found) element('circle', { cx: at[0], cy: at[1], r: 13, class: 'mirrored' }, view.drawn);
        if (this.found && view.name === 'elevation') element('text', { x: clamp(at[0] + 18, 4, WIDTH - 120), y: at[1] + 5, class: 'view' }, view.drawn, say('mirrored eye'));
        // The point of the floor that sees C in the mirror is right whatever the technique.
        if (!box && origin[1] > min[1]) {
          const t = (eye[1] - min[1]) / (eye[1] + origin[1] - 2 * min[1]), p = this.pixel(view.name, [eye[0] + t * (origin[0] - eye[0]), min[1], eye[2] + t * (origin[2] - eye[2])]);
          element('circle', { cx: p[0], cy: p[1], r: 11, class: 'right-point' }, view.drawn);
        }
        for (const { g, key } of view.handles) g.setAttribute('transform', `translate(${this.pixel(view.name, this.state[key]).join(' ')})`);
      }
      this.host.dataset.mean = this.mean;
      const where = origin[1] > min[1] ? say('Right only in the black spot, where the eye sees C itself in the mirror.')
        : this.found ? say('Right only where the line through the mirrored eye and C meets the floor.') : say('Right only in the black spot.');
      this.said.textContent = most < 0.05 ? (box ? say('Right everywhere, for every C that sees the walls, and for every eye: the box says where the walls are.') : say('Right everywhere, for this eye only: a capture at the mirrored eye is a planar reflection. Move the eye.'))
        : `${say('Mean error {0}°.', this.mean.toFixed(1))} ${where}`;
      this.host.dispatchEvent(new Event('boxprobechange'));
    }
  }

  window.boxprobeStand = (host, data) => { host.boxprobeStand = new Stand(host, data); };
})();
