// The page of all lessons with its films: at most 8 MB, whole by itself, every picture and film readable, every task measured
// as the program does, printed with its answers. usage: whole_page.mjs BOXPROBE LESSONS OUT
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { BrowserPage, check } from './browser_page.mjs';

const [program, lessons, out] = process.argv.slice(2);
mkdirSync(out, { recursive: true });
const file = path.resolve(out, 'lessons.html');
if (!process.env.BOXPROBE_KEEP_PAGE || !existsSync(file)) {
  execFileSync(program, ['lessons', '-o', file, '--quiet', '--language', 'en'], { stdio: 'inherit', env: { ...process.env, GALLIVM_PERF: 'nopt' } });
}
const bytes = statSync(file).size, text = readFileSync(file, 'utf8'), widgets = JSON.parse(readFileSync(path.join(lessons, 'page.json')));
check(bytes <= 8e6, `${(bytes / 1e6).toFixed(2)} MB (at most 8)`);
check((text.match(/src="data:video\/webm;base64,/g) || []).length === widgets.loops.length, `with its ${widgets.loops.length} films`);
check(!/src="(?!data:)/.test(text) && !/<link|href="(?!#|https:)/.test(text), 'nothing is loaded from elsewhere');
check(!text.includes('does not hold'), 'every claim and every exercise holds');

const page = await BrowserPage.open('file://' + file);
// When the opening figure is alive, in a browser just started and when the page is opened again: measured, not judged.
for (const how of ['first', 'again']) {
  if (how === 'again') await page.evaluate('location.reload()');
  await new Promise((resolve) => setTimeout(resolve, 300));
  await page.until(`performance.getEntriesByName('the opening figure is alive').length > 0`);
  console.log(`  the opening figure is alive ${(await page.evaluate(`performance.getEntriesByName('the opening figure is alive')[0].startTime`) / 1000).toFixed(2)} s after the page was opened ${how}`);
}
await page.until('[...document.images].every((image) => image.complete)');
const found = await page.evaluate(`({ lessons: document.querySelectorAll('h3').length, pictures: document.images.length, broken: [...document.images].filter((image) => !image.naturalWidth).length,
  plans: document.querySelectorAll('.plan.live').length, rooms: document.querySelectorAll('.room-view').length, tasks: document.querySelectorAll('[data-task]').length,
  links: [...document.querySelectorAll('nav a')].filter((a) => !document.querySelector(a.getAttribute('href'))).length })`);
const files = readdirSync(lessons).filter((name) => name.endsWith('.lesson.json')).length;
check(found.lessons === files && found.broken === 0 && found.links === 0, `${found.lessons} lessons, ${found.pictures} pictures, every link leads to its lesson`);
check(await page.evaluate(`[...document.querySelectorAll('img')].every((image) => image.alt.includes(': ')) && new Set([...document.images].map((image) => image.alt)).size === document.images.length`), 'each picture has a text of its own');
check(await page.evaluate(`[...document.querySelectorAll('main > section:not(.answers):not(.opening)')].every((lesson) => lesson.querySelector('h3 .minutes') && lesson.querySelector('.lesson-nav'))`), 'each lesson has its time and its neighbours');
check(found.plans === Object.keys(widgets.plans).length && found.rooms === widgets.rooms.length, `${found.plans} plans and ${found.rooms} rooms`);
check(await page.evaluate(`[...document.querySelectorAll('section:has(> .steps)')].every((lesson) => lesson.querySelector('.plan, .room-view, .figure-live'))`), 'each lesson has something to drag');
// Charts are of the page's colours by day and by night: letters stand out from the ground.
for (const scheme of ['light', 'dark']) {
  await page.media({ scheme });
  const charts = await page.evaluate(`(() => { const light = (c) => c.match(/[\\d.]+/g).slice(0, 3).map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    return [...document.querySelectorAll('svg.chart')].map((chart) => { const ground = light(getComputedStyle(chart).backgroundColor);
      return Math.min(...[...chart.querySelectorAll('text')].map((t) => { const ink = light(getComputedStyle(t).fill); return (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05); })); }); })()`);
  check(charts.length >= 3 && Math.min(...charts) >= 4.5, `${charts.length} charts, ${scheme}: contrast at least ${Math.min(...charts).toFixed(1)} (4.5)`);
}
await page.media();
// A search.
const search = (words) => page.evaluate(`(() => { const s = document.querySelector('.search input'); s.value = '${words}'; s.dispatchEvent(new Event('input')); return { none: document.querySelector('.search-none').textContent, left: document.querySelectorAll('nav li li:not([hidden])').length }; })()`);
const [nothing, some, all] = [await search('zzyzx'), await search('pillar arcade'), await search('')];
check(nothing.left === 0 && nothing.none === 'No lesson has these words.' && some.left > 0 && some.left < files && !some.none && all.left === files && !all.none, `a search finds ${some.left} lessons, and says when it finds none`);
await page.evaluate(`document.querySelectorAll('.waiting button').forEach((button) => button.click())`);
await page.evaluate(`document.querySelectorAll('video').forEach((video) => { video.preload = 'auto'; video.load(); })`);
await page.until(`[...document.querySelectorAll('video')].every((video) => video.readyState >= 2 || video.error)`);
const films = await page.evaluate(`[...document.querySelectorAll('video')].map((video) => ({ seconds: video.duration, error: video.error?.message || '' }))`);
check(films.every((film, i) => !film.error && Math.abs(film.seconds - widgets.loops[i].seconds) < 0.5), `films play: ${films.map((film) => film.seconds.toFixed(1)).join(', ')} s`);

// Every task that stands beside a plan or a room: the browser begins where the program does.
check(found.tasks >= 4, `${found.tasks} tasks are measured in the page`);
for (let i = 0; i < found.tasks; i++) {
  const name = await page.evaluate(`(() => { const task = document.querySelectorAll('[data-task]')[${i}]; const open = task.closest('section').querySelector('.open-room'); open?.scrollIntoView({ behavior: 'instant' }); open?.click(); return task.closest('section').querySelector('h3').id; })()`);
  await page.until(`!!document.querySelectorAll('[data-task]')[${i}].dataset.value`, 240);
  const task = await page.evaluate(`(() => { const task = document.querySelectorAll('[data-task]')[${i}]; return { value: Number(task.dataset.value), start: JSON.parse(task.dataset.task).start, done: task.classList.contains('done') }; })()`);
  check(!task.done && Math.abs(task.value - task.start) < 2e-3 * Math.max(1, task.start), `${name}: ${task.value.toFixed(4)}, in the program ${task.start.toFixed(4)}, not done yet`);
}
check(page.messages.length === 0, `no script failed ${page.messages.join(' ')}`);
await page.pdf(path.join(out, 'lessons.pdf'));
const answers = (text.match(/<fieldset class="question"/g) || []).length;
const paper = readFileSync(path.join(out, 'lessons.pdf'), 'latin1'), pages = (paper.match(/\/Type \/Page\b/g) || []).length;
check(paper.length > 1e6 && answers > 40 && pages > 20 && pages <= 45, `it prints on ${pages} pages (at most 45), ${answers} answers at its end`);
await page.close();
