// Tasks that the page measures: the mean over the rays that the program measures itself (app/lessons/room_task.h), by the
// box and the capture origin of the plan or the room they stand beside. boxprobeTask(element, data, state) follows
// `state()`, { boxMin, boxMax, origin } along the box's axes, whenever `measure()` of what it returns is called.
'use strict';
(() => {
  const { say } = boxprobeDrawing, NO_HIT = 3.0e38;

  // As data/web/plan.js has it.
  function slabFactor(position, direction, low, high) {
    const gap = Math.max(direction < 0 ? position - low : high - position, 0), speed = Math.abs(direction);
    return speed * NO_HIT > gap ? gap / speed : NO_HIT;
  }

  function angle(a, b) {
    const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    return Math.atan2(Math.hypot(...cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / Math.PI;
  }

  /** Of one ray: seven numbers, P, R and the true distance. */
  function valueOf(measure, ray, { boxMin, boxMax, origin }) {
    const t = [0, 1, 2].map((i) => slabFactor(ray[i], ray[3 + i], boxMin[i], boxMax[i]));
    if (measure.kind === 'slab') return t[measure.axis];
    const d = Math.min(...t);
    if (measure.kind === 'hit-error') return Math.abs(d - ray[6]);
    const hit = [0, 1, 2].map((i) => Math.min(Math.max(ray[i] + d * ray[3 + i], boxMin[i]), boxMax[i]) - origin[i]);
    return angle(hit, [0, 1, 2].map((i) => ray[i] + ray[6] * ray[3 + i] - origin[i]));
  }

  const mean = (measure, state) => measure.rays.reduce((sum, ray) => sum + valueOf(measure, ray, state), 0) / measure.rays.length;

  const shown = (value, unit) => `${Number(value.toPrecision(3))}${unit === '°' ? '' : ' '}${unit}`;

  window.boxprobeTask = (host, data, state) => {
    const said = document.createElement('p');
    said.className = 'task-said';
    said.setAttribute('aria-live', 'polite');
    host.append(said);
    const measure = () => {
      const now = state(), value = mean(data.measure, now), limit = data.limit * (data.times ? mean(data.times, now) : 1);
      const done = { above: value > limit, below: value < limit, within: Math.abs(value - limit) <= data.tolerance }[data.done];
      const wanted = { above: say('more than {0}', shown(limit, data.unit)), below: say('less than {0}', shown(limit, data.unit)), within: `${shown(limit, data.unit)} ± ${data.tolerance}` }[data.done];
      host.classList.toggle('done', done);
      host.dataset.value = value;
      said.textContent = done ? `${say('Done: {0}.', shown(value, data.unit))} ${data.praise}` : say('Now {0}; done at {1}.', shown(value, data.unit), wanted);
    };
    measure();
    return { measure };
  };
})();
