// What the figures of the page of lessons share: elements of SVG, points to take hold of, the distance to a wall, words in the page's language.
'use strict';
const boxprobeDrawing = (() => {
  const NO_HIT = 3.0e38;

  // The page's own words in its language, by the English ones (data/lessons/page); without them it is English.
  const words = new Map(Object.entries(JSON.parse(document.getElementById('page-texts')?.textContent || '{}')));
  /** "{0}", "{1}" .. in the text are the values. */
  const say = (text, ...values) => (words.get(text) ?? text).replace(/\{(\d)\}/g, (_, i) => values[i]);

  function element(name, attributes, parent, text) {
    const made = name === 'svg' || parent instanceof SVGElement ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  }

  /** Whether the browser's own keys are meant: Alt and an arrow goes back a page. */
  const ofBrowser = (event) => event.altKey || event.ctrlKey || event.metaKey;
  /** Where an arrow key leads, to the right and downwards; nothing for other keys. */
  const wayOf = (event) => (ofBrowser(event) ? undefined : { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key]);

  /** Makes `handle`, an element within `svg`, follow pointer, finger and arrow keys: `move(pixel)` in the drawing's own units, `here()`
      where it is, `far(event)` how far a key takes it. */
  function takeHold(svg, handle, { here, move, far }) {
    let offset = null;
    const place = (event) => {
      const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [point.x, point.y];
    };
    handle.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      handle.setPointerCapture(event.pointerId);
      handle.focus({ preventScroll: true });
      const at = place(event), from = here();
      offset = [from[0] - at[0], from[1] - at[1]];
    });
    handle.addEventListener('pointermove', (event) => {
      if (!offset) return;
      const at = place(event);
      move([at[0] + offset[0], at[1] + offset[1]]);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) handle.addEventListener(end, () => { offset = null; });
    handle.addEventListener('keydown', (event) => {
      const way = wayOf(event);
      if (!way) return;
      event.preventDefault();
      const step = far(event), from = here();
      move([from[0] + step * way[0], from[1] + step * way[1]]);
    });
  }

  /** How far along the direction the wall of one axis is; 0 for a start beyond it. That of shaders/shared/slab.glsl. */
  function slabFactor(position, direction, low, high) {
    const gap = Math.max(direction < 0 ? position - low : high - position, 0), speed = Math.abs(direction);
    return speed * NO_HIT > gap ? gap / speed : NO_HIT;
  }

  return { element, say, takeHold, slabFactor, wayOf, ofBrowser };
})();
