// What brings the page of lessons to life: plans to take hold of, pictures wiped against the one before, questions that
// count the first try. Without it the page is whole: still plans, every picture, answers that open.
'use strict';
(() => {
  for (const host of document.querySelectorAll('.plan[data-plan]')) window.boxprobePlan(host, JSON.parse(host.dataset.plan));

  // Tasks are measured in the plan or the room that they stand below.
  function startTask(task, host, state) {
    const { measure } = window.boxprobeTask(task, JSON.parse(task.dataset.task), state);
    host.addEventListener('boxprobechange', measure);
  }
  for (const host of document.querySelectorAll('.plan[data-plan]')) {
    const task = host.parentNode.querySelector('.task[data-task]');
    if (!task) continue;
    startTask(task, host, () => {
      const { box, origin } = host.boxprobePlan.state();
      return { boxMin: box.min, boxMax: box.max, origin };
    });
  }

  // Rooms start when they are asked for: each takes a share of the graphics card.
  for (const host of document.querySelectorAll('.room-view[data-scene]')) {
    const button = document.createElement('button'), view = JSON.parse(host.dataset.view);
    button.type = 'button';
    button.className = 'open-room';
    button.textContent = 'Open the room';
    button.addEventListener('click', async () => {
      button.remove();
      const prepare = (room) => window.boxprobeView(room, view);
      await window.boxprobeRoom(host, JSON.parse(document.getElementById(host.dataset.scene).textContent), { wheel: false, prepare });
      host.querySelector('canvas')?.focus({ preventScroll: true });
      const task = host.parentNode.querySelector('.task[data-task]');
      if (!task || !host.boxprobeRoom) return;
      startTask(task, host, () => {
        const { origin, axes, boxMin, boxMax } = host.boxprobeRoom.probes[0];
        const world = axes.map((axis) => axis[0] * origin[0] + axis[1] * origin[1] + axis[2] * origin[2]);
        return { boxMin: boxMin.map((v, i) => v + world[i]), boxMax: boxMax.map((v, i) => v + world[i]), origin: world };
      });
    });
    host.append(button);
  }

  // Before and after: the picture before lies over this one, cut off at the slider; dragging on the picture moves it.
  function startWipe(figure) {
    const picture = figure.querySelector('.picture'), before = document.getElementById(figure.dataset.before);
    const over = before.cloneNode();
    over.removeAttribute('id');
    over.className = 'before';
    over.alt = '';
    const make = (name, className, text) => {
      const made = document.createElement(name);
      made.className = className;
      made.textContent = text || '';
      return made;
    };
    const edge = make('div', 'edge'), left = make('span', 'side left', 'before'), right = make('span', 'side right-side', 'after');
    picture.append(over, edge, left, right);
    const bar = make('div', 'wipe-bar'), range = make('input', ''), close = make('button', '', 'Close');
    range.type = 'range';
    range.min = 0;
    range.max = 1000;
    range.value = 500;
    range.setAttribute('aria-label', 'how much of the picture before is shown');
    close.type = 'button';
    bar.append(range, close);
    figure.querySelector('.compare').after(bar);
    figure.classList.add('wipe');
    const show = () => {
      const share = range.value / 1000;
      over.style.clipPath = `inset(0 ${100 * (1 - share)}% 0 0)`;
      edge.style.left = `${100 * share}%`;
      left.hidden = share < 0.15;
      right.hidden = share > 0.85;
    };
    range.addEventListener('input', show);
    const to = (event) => {
      const at = picture.getBoundingClientRect();
      range.value = Math.round(1000 * Math.min(Math.max((event.clientX - at.left) / at.width, 0), 1));
      show();
    };
    const held = new AbortController();
    picture.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      picture.setPointerCapture(event.pointerId);
      to(event);
    }, held);
    picture.addEventListener('pointermove', (event) => { if (picture.hasPointerCapture(event.pointerId)) to(event); }, held);
    close.addEventListener('click', () => {
      held.abort();
      for (const part of [over, edge, left, right, bar]) part.remove();
      figure.classList.remove('wipe');
      figure.querySelector('.compare').hidden = false;
      figure.querySelector('.compare').focus();
    });
    show();
    return range;
  }
  for (const figure of document.querySelectorAll('figure[data-before]')) {
    if (!document.getElementById(figure.dataset.before)) continue;
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'compare';
    button.textContent = 'Wipe against the picture before';
    button.addEventListener('click', () => {
      button.hidden = true;
      startWipe(figure).focus({ preventScroll: true });
    });
    figure.append(button);
  }

  // Questions: the answer that is opened first counts.
  const questions = [...document.querySelectorAll('.question')];
  let tried = 0, right = 0;
  for (const question of questions) {
    const answers = [...question.querySelectorAll('details')];
    for (const answer of answers) {
      answer.querySelector('summary').addEventListener('click', () => {  // keys click, too
        if (answer.open) return;  // it closes
        for (const other of answers) if (other !== answer) other.open = false;
        if (question.dataset.tried) return;
        question.dataset.tried = answer.classList.contains('right') ? 'right' : 'wrong';
        tried += 1;
        right += question.dataset.tried === 'right' ? 1 : 0;
        const score = document.querySelector('.score');
        score.textContent = `Questions: ${right} of ${tried} right at the first try, ${questions.length} in all.`;
      });
    }
  }
})();
