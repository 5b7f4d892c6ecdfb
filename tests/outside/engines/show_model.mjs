// One model drawn by three.js in Chromium, for viewers_sheet.py.
// usage: show_model.mjs MODEL CAMERA.json OUT.png WIDTH HEIGHT NODE_MODULES
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { drawnByPage } from './browser.mjs';

const [model, camera, out, width, height, modules] = process.argv.slice(2);
const { PNG } = createRequire(path.resolve(modules, 'x.js'))('pngjs');
const config = { build: 'three.module.js', file: path.basename(model), camera: JSON.parse(readFileSync(camera)), width: +width, height: +height };
const drawn = await drawnByPage('viewer.js', config, { model: path.dirname(path.resolve(model)) }, path.resolve(modules));
const png = new PNG({ width: +width, height: +height });
drawn.picture.copy(png.data);
writeFileSync(out, PNG.sync.write(png));
