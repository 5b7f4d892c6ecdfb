// A page in Firefox, with the calls of BrowserPage (browser_page.mjs), through Firefox's own protocol, Marionette: JSON over a
// socket of this machine, whose port Firefox chooses and writes into the profile. No package.
import { spawn } from 'node:child_process';
import { connect } from 'node:net';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const KEYS = { ArrowLeft: '\uE012', ArrowUp: '\uE013', ArrowRight: '\uE014', ArrowDown: '\uE015', Tab: '\uE004', Enter: '\uE007' };
const MODIFIERS = [[1, '\uE00A'], [2, '\uE009'], [4, '\uE03D'], [8, '\uE008']];  // Alt, Ctrl, Meta, Shift, as Chromium counts them

export class FirefoxPage {
  static async open(url, { width = 1200, height = 900, scripts = true } = {}) {
    const page = new FirefoxPage();
    page.profile = mkdtempSync(path.join(tmpdir(), 'boxprobe-firefox-'));
    // WebGL by whatever OpenGL there is, touch, no visits to anywhere.
    const wanted = { 'marionette.port': 0, 'webgl.force-enabled': true, 'dom.w3c_touch_events.enabled': 1, 'javascript.enabled': scripts, 'app.normandy.enabled': false,
      'browser.shell.checkDefaultBrowser': false, 'datareporting.policy.dataSubmissionEnabled': false, 'browser.startup.page': 0, 'gfx.color_management.mode': 0,
      'network.captive-portal-service.enabled': false, 'browser.safebrowsing.update.enabled': false, 'extensions.update.enabled': false, 'security.fileuri.strict_origin_policy': true };
    writeFileSync(path.join(page.profile, 'user.js'), Object.entries(wanted).map(([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`).join(''));
    page.process = spawn('firefox-esr', ['--headless', '--marionette', '--remote-allow-system-access', '--no-remote', '-profile', page.profile, '--width', '1400', '--height', '1100'],
      { stdio: 'ignore', env: { ...process.env, HOME: page.profile, MOZ_CRASHREPORTER_DISABLE: '1' } });
    process.on('exit', () => page.process.kill('SIGKILL'));  // of a test that ends by an error
    if (process.listenerCount('SIGTERM') === 0) process.once('SIGTERM', () => process.exit(143));  // or is ended
    const port = path.join(page.profile, 'MarionetteActivePort');
    for (let tries = 0; !existsSync(port) || !readFileSync(port, 'utf8'); ++tries) {
      if (tries > 600) throw new Error('Firefox does not start');
      await wait(100);
    }
    page.waiting = new Map();
    page.next = 1;
    page.socket = connect(Number(readFileSync(port, 'utf8')), '127.0.0.1');
    page.socket.on('error', () => {});
    const greeting = new Promise((resolve) => { page.greeted = resolve; });
    let rest = Buffer.alloc(0);
    page.socket.on('data', (data) => {
      rest = Buffer.concat([rest, data]);
      for (let colon; (colon = rest.indexOf(':')) > 0;) {  // LENGTH:JSON
        const end = colon + 1 + Number(rest.subarray(0, colon));
        if (rest.length < end) break;
        page.receive(JSON.parse(rest.subarray(colon + 1, end)));
        rest = rest.subarray(end);
      }
    });
    await greeting;
    await page.send('WebDriver:NewSession', { timeouts: { script: 300000, pageLoad: 300000, implicit: 0 } });
    await page.size(width, height);
    await page.send('WebDriver:Navigate', { url });
    return page;
  }

  receive(message) {
    if (!Array.isArray(message)) return this.greeted();
    const [, id, error, result] = message, { resolve, reject } = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) reject(new Error(`${error.error}: ${error.message}`));
    else resolve(result);
  }

  send(command, parameters = {}) {
    const id = this.next++, text = JSON.stringify([0, id, command, parameters]);
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }

  /** In the page's own world, as Chromium does. */
  async evaluate(expression) {
    const run = async (what) => (await this.send('WebDriver:ExecuteAsyncScript', { args: [expression],
      script: `const done = arguments[1]; (async () => (${what}\n))().then((value) => done({ value }), (error) => done({ error: String(error) + "\\n" + error.stack }));` })).value;
    let value = await run('window.eval(arguments[0])');
    if (/^EvalError: call to eval\(\) blocked by CSP/.test(value.error)) value = await run(expression);  // the page's policy
    if (value.error) throw new Error(`${value.error}\n${expression.slice(0, 200)}`);
    return value.value;
  }

  /** In the browser's own. */
  async chrome(script, args = []) {
    await this.send('Marionette:SetContext', { value: 'chrome' });
    try {
      return (await this.send('WebDriver:ExecuteScript', { script, args })).value;
    } finally {
      await this.send('Marionette:SetContext', { value: 'content' });
    }
  }

  async until(expression, seconds = 120) {
    const end = Date.now() + 1000 * seconds;
    while (!(await this.evaluate(expression))) {
      if (Date.now() > end) throw new Error(`never true: ${expression}\n${(await this.failures()).join('\n')}`);
      await wait(100);
    }
  }

  /** Of the page alone: a window of Firefox is never narrower than 450 pixels. */
  size(width, height) {
    return this.chrome('for (const way of ["min", "max"]) for (const [side, size] of [["width", arguments[0]], ["height", arguments[1]]]) gBrowser.selectedBrowser.style.setProperty(`${way}-${side}`, `${size}px`);', [width, height]);
  }

  media({ type = '', motion, scheme } = {}) {
    return this.chrome(`const [type, motion, scheme] = arguments, { browsingContext } = gBrowser.selectedBrowser;
      browsingContext.mediumOverride = type;
      browsingContext.prefersColorSchemeOverride = scheme || 'none';
      if (motion) Services.prefs.setIntPref('ui.prefersReducedMotion', 1);
      else Services.prefs.clearUserPref('ui.prefersReducedMotion');`, [type, motion || null, scheme || null]);
  }

  reload() { return this.send('WebDriver:Refresh'); }

  failures() {
    return this.chrome(`return Services.console.getMessageArray().filter((m) => m instanceof Ci.nsIScriptError && !(m.flags & (m.warningFlag | m.infoFlag)) && m.category === 'content javascript').map((m) => m.message);`);
  }

  async markup() { return (await this.send('WebDriver:GetPageSource')).value; }

  pointer(kind, actions) { return this.send('WebDriver:PerformActions', { actions: [{ type: 'pointer', id: kind, parameters: { pointerType: kind }, actions }] }); }
  mouse(type, x, y) {
    const move = { type: 'pointerMove', duration: 0, x, y };
    return this.pointer('mouse', { mousePressed: [move, { type: 'pointerDown', button: 0 }], mouseMoved: [move], mouseReleased: [move, { type: 'pointerUp', button: 0 }] }[type]);
  }
  touch(...places) {
    const moves = places.map(([x, y]) => ({ type: 'pointerMove', duration: 0, x, y }));
    return this.pointer('touch', [moves[0], { type: 'pointerDown', button: 0 }, ...moves.slice(1), { type: 'pointerUp', button: 0 }]);
  }
  drag(from, to) {
    const [a, b] = [from, to].map(([x, y]) => ({ type: 'pointerMove', duration: 0, x, y }));
    return this.pointer('mouse', [a, { type: 'pointerDown', button: 0 }, b, { type: 'pointerUp', button: 0 }]);
  }
  click(x, y) { return this.drag([x, y], [x, y]); }
  key(key, modifiers = 0) {
    const held = MODIFIERS.filter(([bit]) => modifiers & bit).map(([, value]) => value), down = (value) => ({ type: 'keyDown', value }), up = (value) => ({ type: 'keyUp', value });
    return this.send('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keys', actions: [...held.map(down), down(KEYS[key]), up(KEYS[key]), ...held.map(up)] }] });
  }
  type(text) {
    const actions = [...text].flatMap((letter) => ['keyDown', 'keyUp'].map((type) => ({ type, value: letter === '\n' ? KEYS.Enter : letter })));
    return this.send('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keys', actions }] });
  }
  middle(selector) {
    return this.evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({block: 'center', behavior: 'instant'}); const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
  }

  async screenshot(file) { writeFileSync(file, Buffer.from((await this.send('WebDriver:TakeScreenshot', { full: false, hash: false })).value, 'base64')); }
  async pdf(file) { writeFileSync(file, Buffer.from((await this.send('WebDriver:Print', { background: true })).value, 'base64')); }

  async close() {
    const gone = new Promise((resolve) => this.process.on('exit', resolve));
    this.send('Marionette:Quit', { flags: ['eForceQuit'] }).catch(() => {});
    const late = setTimeout(() => this.process.kill('SIGKILL'), 20000);
    await gone;
    clearTimeout(late);
    this.socket.destroy();
    for (let tries = 0; ; ++tries) {
      try {
        return rmSync(this.profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
      } catch (error) {
        if (tries > 50) throw error;
        await wait(100);
      }
    }
  }
}
