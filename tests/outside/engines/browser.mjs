// A page of this folder in a headless browser, with the files it asks for, and what it sends back. Debian's Chromium draws by ANGLE
// over the display's OpenGL (llvmpipe under xvfb-run).
import { spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { createReadStream, existsSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const here = path.dirname(new URL(import.meta.url).pathname);
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.json': 'application/json', '.wasm': 'application/wasm' };

function body(request) {
  return new Promise((resolve) => {
    const parts = [];
    request.on('data', (part) => parts.push(part));
    request.on('end', () => resolve(Buffer.concat(parts)));
  });
}

/** `page`: script of this folder; `files`: folder of each first part of an address, or the file itself; `config`: its /config.json. */
export function drawnByPage(page, config, files, modules, seconds = 240) {
  return new Promise((resolve, reject) => {
    const result = {};
    const profile = mkdtempSync(path.join(tmpdir(), 'boxprobe-chromium-'));
    let browser, timer;
    const finish = (error) => {
      clearTimeout(timer);
      server.close();
      server.closeAllConnections();
      if (browser) browser.kill('SIGKILL');
      setTimeout(() => {
        rmSync(profile, { recursive: true, force: true, maxRetries: 20, retryDelay: 250 });
        error ? reject(error) : resolve(result);
      }, 300);
    };
    const server = createServer(async (request, response) => {
      const name = decodeURIComponent(new URL(request.url, 'http://x').pathname);
      if (request.method === 'POST') {
        const data = await body(request);
        response.end();
        if (name === '/picture') result.picture = data;
        if (name === '/mask') result.mask = data;
        if (name === '/failed') finish(new Error(page + ': ' + data.toString()));
        if (name === '/done') {
          result.renderer = data.toString();
          finish();
        }
        return;
      }
      if (name === '/') return response.end(readFileSync(path.join(here, 'page.html'), 'utf8').replace('@BUILD@', config.build));
      if (name === '/config.json') return response.end(JSON.stringify(config));
      const [, first, ...rest] = name.split('/');
      let file = name === '/page.js' ? path.join(here, page)
        : first === 'node_modules' ? path.join(modules, ...rest)
        : files[first] ? path.join(files[first], ...rest) : path.join(here, name);
      if (first === 'node_modules' && !existsSync(file) && existsSync(file + '.js')) file += '.js';
      if (!existsSync(file) || !statSync(file).isFile()) {
        response.statusCode = 404;
        return response.end();
      }
      response.setHeader('Content-Type', types[path.extname(file)] || 'application/octet-stream');
      createReadStream(file).pipe(response);
    });
    server.listen(0, '127.0.0.1', () => {
      const address = `http://127.0.0.1:${server.address().port}/`;
      browser = spawn('chromium', ['--headless=new', '--no-sandbox', '--no-first-run', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=gl',
        '--ignore-gpu-blocklist', '--enable-unsafe-swiftshader', `--user-data-dir=${profile}`, address], { stdio: process.env.BOXPROBE_BROWSER_LOG ? 'inherit' : 'ignore' });
      browser.on('error', finish);
    });
    timer = setTimeout(() => finish(new Error(`${page}: nothing drawn in ${seconds} s`)), seconds * 1000);
  });
}
