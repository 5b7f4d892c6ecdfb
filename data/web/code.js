// boxprobeCode(host, scene, view, data): a room (data/web/room.js) whose lookup the reader writes. Beside the picture stands `lookup`, GLSL
// that is compiled here and takes the place of the program's own box projection; below it the picture's difference from that.
//
// What is written cannot hang the page: each turn of a loop asks bpGo(), which says no after LOOPS of them, and there is neither
// preprocessor nor recursion. A graphics card that is taken away all the same comes back with the code that is there at the start.
'use strict';
(() => {
  const { element, say } = boxprobeDrawing, LOOPS = 256, LONGEST = 8000, MARK = '//bp-code\n', PIECE = 'technique/projection_box.glsl';
  const WRAP = `
ProbeHit projectBox(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  ProbeHit hit;
  hit.slabFactors = slabFactors(position, reflection, probe.boxMin, probe.boxMax);
  hit.distance = min(min(hit.slabFactors.x, hit.slabFactors.y), hit.slabFactors.z);
  hit.direction = lookup(position, reflection, probe.boxMin, probe.boxMax);
  hit.face = 0;
  hit.refined = 0.0f;
  return hit;
}
`;

  /** { text } of the code with its loops bounded, line by line as it was, or { line, message }. */
  function bounded(code) {
    const lineAt = (at) => code.slice(0, at).split('\n').length;
    if (code.length > LONGEST) return { line: 1, message: say('more than {0} letters', LONGEST) };
    // Comments become spaces, so that nothing within them counts and every line keeps its place.
    const plain = code.replace(/\/\*[^]*?(\*\/|$)|\/\/[^\n]*/g, (comment) => comment.replace(/[^\n]/g, ' '));
    const odd = plain.search(/[#\\]|[^\x00-\x7f]/);
    if (odd >= 0) return { line: lineAt(odd), message: say('{0} is left out here: no preprocessor, and plain letters', plain[odd]) };
    let text = '', from = 0;
    for (const found of plain.matchAll(/\b(for|while)\b\s*/g)) {
      const head = found.index + found[0].length;
      if (plain[head] !== '(') return { line: lineAt(found.index), message: `'${found[1]}' : a bracket has to follow` };
      let depth = 0, end = head, first = -1, second = -1;
      for (; end < plain.length; end++) {
        if (plain[end] === '(') depth++;
        else if (plain[end] === ')' && --depth === 0) break;
        else if (plain[end] === ';' && depth === 1) { if (first < 0) first = end; else if (second < 0) second = end; }
      }
      if (end === plain.length) return { line: lineAt(head), message: `'${found[1]}' : its bracket is not closed` };
      if (found[1] === 'while') {
        text += `${plain.slice(from, head + 1)}bpGo() && (`;
        from = head + 1;
        text += `${plain.slice(from, end)})`;
      } else {
        if (second < 0) return { line: lineAt(head), message: "'for' : two semicolons belong into its bracket" };
        text += `${plain.slice(from, first + 1)} bpGo()`;
        if (plain.slice(first + 1, second).trim()) text += ` && (${plain.slice(first + 1, second)})`;
        else text += plain.slice(first + 1, second);
        text += plain.slice(second, end);
      }
      from = end;
    }
    return { text: text + plain.slice(from) };
  }

  class Code {
    constructor(host, scene, view, data) {
      Object.assign(this, { host, scene, view, data });
      const both = element('div', { class: 'figure-both code-both' }, host);
      const shown = element('div', {}, both);
      this.picture = element('div', { class: 'figure-picture' }, shown);
      const side = element('div', { class: 'code-side' }, both);
      this.frame = element('div', { class: 'code-frame' }, side);
      this.lines = element('div', { class: 'code-lines', 'aria-hidden': 'true' }, this.frame);
      this.area = element('textarea', { spellcheck: 'false', autocomplete: 'off', autocapitalize: 'off', wrap: 'off', 'aria-label': say('GLSL: the function lookup'), 'data-control': 'code' }, this.frame);
      this.errors = element('ul', { class: 'code-errors', 'aria-live': 'polite' }, side);
      this.map = element('canvas', { class: 'code-difference', role: 'img', 'aria-label': say('Difference from the program’s own box projection, four times as bright') }, shown);
      element('p', { class: 'code-caption' }, shown, say('Difference from the program’s own box projection, four times as bright'));
      const bar = element('div', { class: 'figure-bar' }, host);
      this.reset = element('button', { type: 'button', 'data-control': 'reset code' }, bar, say('Reset the code'));
      this.show = element('button', { type: 'button', 'data-control': 'show code' }, bar, say('Show a solution'));
      this.said = element('p', { class: 'figure-said', 'aria-live': 'polite' }, host);
      this.area.value = data.start;
      this.area.addEventListener('input', () => { clearTimeout(this.later); this.number(); this.later = setTimeout(() => this.compile(), 250); });
      this.area.addEventListener('scroll', () => { this.lines.scrollTop = this.area.scrollTop; });
      this.reset.addEventListener('click', () => this.put(data.start));
      this.show.addEventListener('click', () => this.put(data.answer));
    }

    /** A room on a canvas of its own; again when the graphics card was taken away. */
    async begin() {
      await window.boxprobeRoom(this.picture, JSON.parse(JSON.stringify(this.scene)), { antialias: false, panel: false, prepare: (room) => window.boxprobeView(room, this.view) });
      this.room = this.picture.boxprobeRoom;
      if (!this.room) return false;
      const { canvas } = this.room.gl;
      this.room.row = this.room.findRow('box', 'none');
      canvas.setAttribute('aria-label', say('The room, with the code’s lookup in its mirror floor'));
      // Taken away, it may have been by what was written; given back out of view, it was not.
      canvas.addEventListener('webglcontextlost', () => {
        if (this.room.given) return;
        this.room.custom = null;
        this.said.textContent = say('The browser has taken the graphics card away: when it comes back, the code is the one at the start.');
      });
      this.picture.addEventListener('boxproberestored', ({ detail }) => (detail.given ? this.compile() : this.put(this.data.start)));
      new ResizeObserver(() => this.redraw()).observe(canvas);
      this.put(this.data.start);
      return true;
    }

    put(code) {
      this.area.value = code;
      this.compile();
    }

    number(bad = []) {
      this.lines.replaceChildren();
      this.area.value.split('\n').forEach((_, i) => element('div', bad.includes(i + 1) ? { class: 'bad' } : {}, this.lines, String(i + 1)));
      this.lines.scrollTop = this.area.scrollTop;
    }

    /** Takes the code if it compiles; otherwise what ran before goes on, and the errors stand at their lines. */
    compile() {
      const { room } = this, code = this.area.value, count = code.split('\n').length, safe = bounded(code);
      let errors = safe.text === undefined ? [safe] : [];
      if (!errors.length && room.ready) {
        const before = room.custom;
        room.custom = { [PIECE]: `int bpTurns = ${LOOPS};\nbool bpGo() { return bpTurns-- > 0; }\n${MARK}${safe.text}\n${WRAP}` };
        try {
          room.tryCustom();
          room.forgetCustom(before);
        } catch (error) {
          room.custom = before;
          const first = (error.source || '').split(MARK)[0].split('\n').length;
          errors = [...error.message.matchAll(/ERROR:\s*\d+:(\d+):\s*([^\n]*)/g)].map(([, line, message]) => ({ line: Math.min(Math.max(Number(line) - first, 1), count), message }));
          errors = errors.filter((a, i) => errors.findIndex((b) => a.line === b.line && a.message === b.message) === i);  // said for each stage
          if (!errors.length) errors = [{ line: 1, message: error.message.trim().split('\n')[0] || 'does not link' }];
        }
      }
      this.number(errors.map(({ line }) => line));
      this.errors.replaceChildren();
      for (const { line, message } of errors.slice(0, 5)) element('li', {}, this.errors, say('Line {0}: {1}', line, message));
      this.host.dataset.errors = errors.map(({ line }) => line).join();
      this.failed = errors.length > 0;
      this.redraw();
    }

    redraw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => { this.waiting = false; this.draw(); });
    }

    draw() {
      const { room } = this, { gl } = room, { canvas } = gl;
      if (!room.ready) return;
      const width = Math.max(Math.min(Math.round(canvas.clientWidth), 800), 1), height = Math.max(Math.round(width / 1.6), 1), bytes = 4 * width * height;
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      const read = () => { const pixels = new Uint8Array(bytes); gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels); return pixels; };
      const { custom } = room;
      room.custom = null;
      room.draw();
      const right = read();
      room.custom = custom;
      room.draw();
      const ours = read(), image = new ImageData(width, height);
      let sum = 0, most = 0;
      for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
          const from = 4 * (y * width + x), to = 4 * ((height - 1 - y) * width + x);
          for (let c = 0; c < 3; c++) {
            const off = Math.abs(ours[from + c] - right[from + c]);
            sum += off * off;
            most = Math.max(most, off);
            image.data[to + c] = 4 * off;
          }
          image.data[to + 3] = 255;
        }
      }
      Object.assign(this.map, { width, height });
      this.map.getContext('2d').putImageData(image, 0, 0);
      this.difference = Math.sqrt(sum / (3 * width * height)) / 255;
      this.host.dataset.difference = this.difference;
      this.host.dataset.drawn = String(Number(this.host.dataset.drawn || 0) + 1);
      this.said.textContent = (this.failed ? `${say('It does not compile: the picture is of the code before.')} ` : '')
        + (most <= 2 ? say('No difference: this is box projection.') : say('Difference: {0} of white (root mean square).', this.difference.toFixed(4)));
    }
  }

  window.boxprobeCode = async (host, scene, view, data) => {
    const code = new Code(host, scene, view, data);
    if (await code.begin()) {
      host.boxprobeCode = code;
    } else {
      for (const part of host.querySelectorAll('.code-side,.figure-bar,.figure-said')) part.remove();
    }
  };
  window.boxprobeCode.bounded = bounded;
})();
