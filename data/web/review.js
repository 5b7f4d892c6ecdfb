// A report's pictures wiped against each other: the drawn one lies over the traced one, cut off at the slider, which keys
// move and a finger or the mouse on the picture, too. Without scripts both stand side by side.
'use strict';
for (const pair of document.querySelectorAll('.pair')) {
  const slider = document.createElement('input'), edge = document.createElement('span');
  slider.type = 'range';
  slider.className = 'slider';
  slider.min = 0;
  slider.max = 100;
  slider.step = 0.5;
  const camera = pair.closest('article').querySelector('h3').textContent, scene = pair.closest('section').querySelector('h2').textContent;
  slider.setAttribute('aria-label', `${scene}, ${camera}: drawn to the left, path traced to the right`);
  edge.className = 'edge';
  const put = (at) => {
    slider.value = Math.min(100, Math.max(0, at));
    slider.setAttribute('aria-valuetext', `${Math.round(slider.value)} % drawn`);
    pair.style.setProperty('--at', `${slider.value}%`);
  };
  pair.classList.add('wipe');
  pair.append(edge);
  pair.after(slider);
  for (const img of pair.querySelectorAll('img')) img.draggable = false;
  put(50);
  slider.addEventListener('input', () => put(slider.value));
  const follow = (event) => {
    const place = pair.getBoundingClientRect();
    put((100 * (event.clientX - place.left)) / place.width);
  };
  pair.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    pair.setPointerCapture(event.pointerId);
    follow(event);
  });
  pair.addEventListener('pointermove', (event) => {
    if (pair.hasPointerCapture(event.pointerId)) follow(event);
  });
}
