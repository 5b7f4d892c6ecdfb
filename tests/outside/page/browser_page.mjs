// A page in headless Chromium, driven by real pointer and key events through the DevTools protocol over a pipe
// (--remote-debugging-pipe): no package, no port. Debian's Chromium draws by ANGLE over the display's OpenGL (llvmpipe under xvfb-run).
// With BOXPROBE_BROWSER=firefox the same calls drive Firefox (firefox_page.mjs); only `send` is Chromium's own.
import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { createReadStream, existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { FirefoxPage } from './firefox_page.mjs';

export const firefox = process.env.BOXPROBE_BROWSER === 'firefox';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.css': 'text/css', '.png': 'image/png' };

/** A folder as any static server has it: { address, close }. */
export function serve(folder) {
  const server = createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, 'http://x').pathname);
    const file = path.join(folder, name === '/' ? 'index.html' : name);
    if (!existsSync(file) || !statSync(file).isFile()) {
      response.statusCode = 404;
      return response.end();
    }
    response.setHeader('Content-Type', types[path.extname(file)] || 'application/octet-stream');
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve({ address: `http://127.0.0.1:${server.address().port}/`, close: () => { server.close(); server.closeAllConnections(); } })));
}

export class BrowserPage {
  /** `more`: further options of Chromium. */
  static async open(url, options = {}) {
    if (firefox) return FirefoxPage.open(url, options);
    const { width = 1200, height = 900, mobile = false, scripts = true, more = [] } = options;
    const page = new BrowserPage();
    page.profile = mkdtempSync(path.join(tmpdir(), 'boxprobe-chromium-'));
    page.process = spawn('chromium', ['--headless=new', '--no-sandbox', '--no-first-run', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=gl', '--ignore-gpu-blocklist',
      '--enable-unsafe-swiftshader', '--remote-debugging-pipe', `--user-data-dir=${page.profile}`, '--force-color-profile=srgb', ...more, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    page.waiting = new Map();
    page.messages = [];
    page.next = 1;
    let rest = '';
    page.process.stdio[4].on('data', (data) => {
      const parts = (rest + data).split('\0');
      rest = parts.pop();
      for (const part of parts) page.receive(JSON.parse(part));
    });
    const { targetId } = await page.send('Target.createTarget', { url: 'about:blank' });
    page.session = (await page.send('Target.attachToTarget', { targetId, flatten: true })).sessionId;
    await page.send('Page.enable');
    await page.send('Runtime.enable');
    await page.send('Log.enable');
    await page.send('Emulation.setFocusEmulationEnabled', { enabled: true });
    await page.size(width, height, mobile);
    if (!scripts) await page.send('Emulation.setScriptExecutionDisabled', { value: true });
    const loaded = page.event('Page.loadEventFired');
    await page.send('Page.navigate', { url });
    await loaded;
    return page;
  }

  receive(message) {
    if (message.id) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      message.error ? reject(new Error(message.error.message)) : resolve(message.result);
    } else if (this.awaited && this.awaited.method === message.method) {
      this.awaited.resolve(message.params);
      this.awaited = null;
    } else if (message.method === 'Runtime.exceptionThrown') {
      this.messages.push(message.params.exceptionDetails.exception?.description || message.params.exceptionDetails.text);
    } else if (message.method === 'Log.entryAdded' && message.params.entry.source === 'security') {
      this.messages.push(message.params.entry.text);  // what the page's policy refused
    }
  }

  event(method) { return new Promise((resolve) => { this.awaited = { method, resolve }; }); }

  send(method, params = {}) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
    });
  }

  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
    return result.value;
  }

  /** Until the expression is true. */
  async until(expression, seconds = 120) {
    const end = Date.now() + 1000 * seconds;
    while (!(await this.evaluate(expression))) {
      if (Date.now() > end) throw new Error(`never true: ${expression}\n${this.messages.join('\n')}`);
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }

  /** `type`: '' or 'print'; `motion`: 'reduce'; `scheme`: 'dark'. What is left out is as the machine has it. */
  media({ type = '', motion, scheme } = {}) {
    const features = [['prefers-reduced-motion', motion], ['prefers-color-scheme', scheme]].filter(([, value]) => value).map(([name, value]) => ({ name, value }));
    return this.send('Emulation.setEmulatedMedia', { media: type, features });
  }

  async reload() {
    const loaded = this.event('Page.loadEventFired');
    await this.send('Page.reload');
    await loaded;
  }

  /** What scripts threw and nobody caught, and what the page's policy refused. */
  failures() { return this.messages; }

  /** The document as it stands, scripts or not. */
  async markup() {
    await this.send('DOM.enable');
    const { root } = await this.send('DOM.getDocument', { depth: -1 });
    return (await this.send('DOM.getOuterHTML', { nodeId: root.nodeId })).outerHTML;
  }

  size(width, height, mobile = false) { return this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile }); }

  mouse(type, x, y) { return this.send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1 }); }
  /** A finger put down, moved and lifted. */
  async touch(...places) {
    await this.send('Emulation.setTouchEmulationEnabled', { enabled: true });
    for (const [i, [x, y]] of places.entries()) await this.send('Input.dispatchTouchEvent', { type: i ? 'touchMove' : 'touchStart', touchPoints: [{ x, y }] });
    await this.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await this.send('Emulation.setTouchEmulationEnabled', { enabled: false });
  }
  async drag(from, to) {
    await this.mouse('mousePressed', ...from);
    await this.mouse('mouseMoved', ...to);
    await this.mouse('mouseReleased', ...to);
  }
  async click(x, y) { await this.mouse('mousePressed', x, y); await this.mouse('mouseReleased', x, y); }
  async key(key, modifiers = 0) {
    const windowsVirtualKeyCode = { ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9, Enter: 13 }[key];
    await this.send('Input.dispatchKeyEvent', { type: 'rawKeyDown', key, code: key, windowsVirtualKeyCode, modifiers });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, code: key, windowsVirtualKeyCode, modifiers });
  }
  /** Into what has the focus. */
  type(text) { return this.send('Input.insertText', { text }); }
  /** Middle of an element, scrolled into view. */
  middle(selector) {
    return this.evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)}); e.scrollIntoView({block: 'center', behavior: 'instant'}); const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()`);
  }

  async screenshot(file) { writeFileSync(file, Buffer.from((await this.send('Page.captureScreenshot', { format: 'png' })).data, 'base64')); }
  async pdf(file) { writeFileSync(file, Buffer.from((await this.send('Page.printToPDF', { printBackground: true, preferCSSPageSize: true })).data, 'base64')); }

  async close() {
    this.process.kill('SIGKILL');
    await new Promise((resolve) => this.process.on('exit', resolve));
    // Its children end a little later, and write until then.
    for (let tries = 0; ; ++tries) {
      try {
        return rmSync(this.profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
      } catch (error) {
        if (tries > 50) throw error;
        await new Promise((resolve) => setTimeout(resolve, 100));
      }
    }
  }
}

export function check(good, text) {
  console.log(`${good ? 'holds' : 'FAILED'}: ${text}`);
  if (!good) process.exitCode = 1;
  return good;
}

/** PSNR, dB, of a room's picture in the page (data/web/room.js; `room`: an expression) against a PNG file of `boxprobe render`. */
export async function roomPsnr(page, room, png, width, height) {
  const { readFileSync } = await import('node:fs');
  return page.evaluate(`(async () => {
    const room = ${room}, gl = room.gl, ours = new Uint8Array(${4 * width * height});
    Object.assign(gl.canvas, { width: ${width}, height: ${height} });
    room.draw(${width}, ${height});
    gl.readPixels(0, 0, ${width}, ${height}, gl.RGBA, gl.UNSIGNED_BYTE, ours);
    const bytes = Uint8Array.from(atob('${readFileSync(png).toString('base64')}'), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { colorSpaceConversion: 'none' });
    const canvas = new OffscreenCanvas(${width}, ${height}), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const theirs = context.getImageData(0, 0, ${width}, ${height}).data;
    let sum = 0;
    for (let y = 0; y < ${height}; y++) for (let x = 0; x < ${width}; x++) for (let c = 0; c < 3; c++) {
      sum += (ours[4 * ((${height} - 1 - y) * ${width} + x) + c] - theirs[4 * (y * ${width} + x) + c]) ** 2;
    }
    return 10 * Math.log10(255 * 255 / Math.max(sum / (3 * ${width * height}), 1e-9));
  })()`);
}
