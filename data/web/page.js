// What brings the page of lessons to life: plans to take hold of, pictures wiped against the one before, questions that
// count the first try. Without it the page is whole: still plans, every picture, answers that open.
'use strict';
(() => {
  const { say } = boxprobeDrawing;
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
    button.textContent = say('Open the room');
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
    const edge = make('div', 'edge'), left = make('span', 'side left', say('before')), right = make('span', 'side right-side', say('after'));
    picture.append(over, edge, left, right);
    const bar = make('div', 'wipe-bar'), range = make('input', ''), close = make('button', '', say('Close'));
    range.type = 'range';
    range.min = 0;
    range.max = 1000;
    range.value = 500;
    range.setAttribute('aria-label', say('how much of the picture before is shown'));
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
    button.textContent = say('Wipe against the picture before');
    button.addEventListener('click', () => {
      button.hidden = true;
      startWipe(figure).focus({ preventScroll: true });
    });
    figure.append(button);
  }

  // Live figures start when they come into view.
  async function startFigure(host) {
    if (host.dataset.figure === 'cone') {
      host.querySelector('.figure-still').remove();
      window.boxprobeCone(host);
      return;
    }
    if (host.dataset.kind || host.dataset.sketch) {
      host.querySelector('.figure-still').remove();
      if (host.dataset.kind) window.boxprobeSurface(host, host.dataset.kind);
      else window.boxprobeSketch(host, host.dataset.sketch);
      return;
    }
    if (host.dataset.figure === 'infinity') {
      await window.boxprobeOpen(host);
      return;
    }
    const scene = window.boxprobeScene(host.dataset.scene), view = JSON.parse(host.dataset.view), still = host.querySelector('.figure-still');
    if (host.dataset.figure === 'stand') {
      const { origin, axes, boxMin, boxMax } = scene.probes[0];
      const world = axes.map((axis) => axis[0] * origin[0] + axis[1] * origin[1] + axis[2] * origin[2]);
      still.remove();
      window.boxprobeStand(host, { eye: view.camera.position, origin, room: { min: boxMin.map((v, i) => v + world[i]), max: boxMax.map((v, i) => v + world[i]) } });
      return;
    }
    await window.boxprobeCode(host, scene, view, JSON.parse(host.dataset.code));
    if (host.boxprobeCode) still.remove();
  }
  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      startFigure(target);
    }
  }, { rootMargin: '200px' });
  for (const host of document.querySelectorAll('.figure-live')) seen.observe(host);
  // On paper the small figures are stills: those that nobody has seen yet begin now.
  window.addEventListener('beforeprint', () => {
    for (const host of document.querySelectorAll('.figure-live[data-sketch], .figure-live[data-kind]')) {
      if (!host.querySelector('.figure-still')) continue;
      seen.unobserve(host);
      startFigure(host);
    }
  });

  // Questions: the answer that is opened first counts, and what follows a question is hidden until then: the next picture answers it.
  // What was answered is kept in the browser.
  const KEPT = 'boxprobe-lessons';
  let kept = {};
  try { kept = JSON.parse(localStorage.getItem(KEPT)) || {}; } catch { /* a browser that keeps nothing */ }
  const questions = [...document.querySelectorAll('.question')];
  const make = (name, className, text) => {
    const made = document.createElement(name);
    made.className = className;
    made.textContent = text;
    return made;
  };

  /** Steps after the first question without a guess are hidden, and with them what answers it: what was measured, films, exercises and
      live figures. One that opens its lesson stays: it answers none of the questions, or has a guess of its own. */
  function hideAnswers(lesson) {
    const steps = [...lesson.querySelectorAll('.step')], shown = Number(lesson.dataset.shown || 0);
    const stop = steps.findIndex((step, i) => i >= shown && step.querySelector('.question:not([data-tried])'));
    steps.forEach((step, i) => { step.hidden = stop >= 0 && i > stop; });
    const hides = stop >= 0;
    for (const part of lesson.querySelectorAll('.measured, .loop, .exercises, .widget:not(.opens)')) part.hidden = hides;
    let wait = lesson.querySelector('.waiting');
    if (!hides) {
      if (wait) wait.remove();
      return;
    }
    if (!wait) {
      wait = make('div', 'waiting', '');
      const button = make('button', '', say('Show it without a guess'));
      button.type = 'button';
      button.addEventListener('click', () => {
        lesson.dataset.shown = steps.length;
        hideAnswers(lesson);
      });
      wait.append(make('p', '', ''), button);
      lesson.querySelector('.steps').append(wait);
    }
    const left = steps.length - 1 - stop;
    wait.firstChild.textContent = !left ? say('Make a guess, and what was measured appears.')
      : left > 1 ? say('Make a guess, and the next picture answers it. ({0} more steps in this lesson.)', left) : say('Make a guess, and the next picture answers it. (1 more step in this lesson.)');
  }

  const score = document.querySelector('.score'), forget = make('button', 'forget', say('Forget my answers'));
  forget.type = 'button';
  forget.hidden = true;
  score.after(forget);
  // A teacher prints the page without its answers.
  const paper = make('label', 'paper check', ''), withAnswers = document.createElement('input');
  withAnswers.type = 'checkbox';
  withAnswers.checked = true;
  withAnswers.addEventListener('change', () => document.body.classList.toggle('no-answers', !withAnswers.checked));
  paper.append(withAnswers, ` ${say('print answers and solutions at the end')}`);
  forget.after(paper);
  function showScore() {
    const tried = questions.filter((q) => q.dataset.tried), right = tried.filter((q) => q.dataset.tried === 'right').length;
    const text = say('{0} of {1} right at the first try, {2} in all.', right, tried.length, questions.length);
    score.textContent = tried.length ? say('Questions: {0}', text) : '';
    forget.hidden = !tried.length;
    return text;
  }

  for (const question of questions) {
    const answers = [...question.querySelectorAll('details')], verdict = make('p', 'verdict', '');
    verdict.setAttribute('aria-live', 'polite');
    question.append(verdict);
    for (const answer of answers) {
      answer.querySelector('summary').addEventListener('click', () => {  // keys click, too
        if (answer.open) return;  // it closes
        for (const other of answers) if (other !== answer) other.open = false;
        const right = answer.classList.contains('right');
        if (!question.dataset.tried) {
          question.dataset.tried = right ? 'right' : 'wrong';
          kept[question.dataset.question] = question.dataset.tried;
          try { localStorage.setItem(KEPT, JSON.stringify(kept)); } catch { /* as above */ }
          hideAnswers(question.closest('section'));
        }
        verdict.className = `verdict ${right ? 'good' : 'bad'}`;
        verdict.textContent = `${right ? say('Right.') : say('Not that one: try another.')} ${say('First tries: {0}', showScore())}`;
      });
    }
    if (kept[question.dataset.question]) question.dataset.tried = kept[question.dataset.question] === 'right' ? 'right' : 'wrong';
  }
  const lessons = [...document.querySelectorAll('section:has(> .steps)')];
  lessons.forEach(hideAnswers);
  showScore();
  forget.addEventListener('click', () => {
    kept = {};
    try { localStorage.removeItem(KEPT); } catch { /* as above */ }
    for (const question of questions) {
      delete question.dataset.tried;
      question.querySelector('.verdict').textContent = '';
      for (const answer of question.querySelectorAll('details')) answer.open = false;
    }
    for (const lesson of lessons) {
      delete lesson.dataset.shown;
      hideAnswers(lesson);
    }
    showScore();
    document.querySelector('#contents a')?.focus();  // the button is gone
  });

  // The address of a step shows the steps up to it: somebody gave it away on purpose.
  function goToAddress() {
    let name = location.hash.slice(1);
    try { name = decodeURIComponent(name); } catch { /* "%" alone is no code: as it is written */ }
    const named = document.getElementById(name), target = named && (named.closest('.step') || named);  // a former lesson's is within
    const lesson = target && target.matches('.step') && target.closest('section');
    if (!lesson || !target.hidden) return;
    lesson.dataset.shown = [...lesson.querySelectorAll('.step')].indexOf(target);
    hideAnswers(lesson);
    target.scrollIntoView();
  }
  window.addEventListener('hashchange', goToAddress);
  goToAddress();

  // A search over titles and texts.
  const contents = document.querySelector('#contents .chapters');
  if (contents && document.querySelectorAll('h3').length > 1) {
    const label = make('label', 'search', `${say('Search')} `), input = document.createElement('input');
    input.type = 'search';
    label.append(input);
    const none = make('p', 'search-none', '');
    none.setAttribute('role', 'status');
    contents.before(label, none);
    const texts = new Map([...contents.querySelectorAll('li li')].map((item) => {
      const heading = document.getElementById(item.querySelector('a').getAttribute('href').slice(1));
      return [item, heading.closest('section').textContent.toLowerCase()];
    }));
    input.addEventListener('input', () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      for (const [item, text] of texts) item.hidden = !words.every((word) => text.includes(word));
      for (const chapter of contents.children) chapter.hidden = words.length > 0 && !chapter.querySelector('li:not([hidden])');
      none.textContent = [...texts.keys()].every((item) => item.hidden) ? say('No lesson has these words.') : '';
    });
  }
})();
