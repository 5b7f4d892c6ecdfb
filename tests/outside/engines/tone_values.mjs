// What three.js makes of 1,000 colours by its three tone curves, drawn with its own shader text in Chromium:
//   tone_values.mjs FILE NODE_MODULES    writes FILE if it is not there, else holds it against what was drawn now
// A row of FILE is a colour in linear light and, times 10,000, its linear red, green and blue by Neutral, AgX and ACES.
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { BrowserPage, serve } from '../page/browser_page.mjs';

const [file, modules] = process.argv.slice(2);
const { ShaderChunk } = await import(path.resolve(modules, 'three/src/renderers/shaders/ShaderChunk.js'));
const curves = ['NeutralToneMapping', 'AgXToneMapping', 'ACESFilmicToneMapping'];

// Greys and colours from a thousandth to 200, more of them where curves bend; no two components alike but in greys.
let state = 20260731;
const random = () => (state = (1664525 * state + 1013904223) % 4294967296) / 4294967296;
const rounded = (value) => Number(value.toPrecision(4));
const colors = [[0, 0, 0], [0.18, 0.18, 0.18], [1, 1, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1], [60, 2, 0.01], [0.004, 0.02, 0.0011]];
while (colors.length < 1000) {
  const light = 0.001 * 200000 ** random() ** 0.8;
  const grey = random() < 0.12;
  colors.push(grey ? Array(3).fill(rounded(light)) : [0, 1, 2].map(() => rounded(light * (1 - random() * random() * 0.999))));
}

const page = `<!doctype html><canvas></canvas><script>
const colors = ${JSON.stringify(colors)}, curves = ${JSON.stringify(curves)}, text = ${JSON.stringify(ShaderChunk.tonemapping_pars_fragment)};
const gl = document.querySelector('canvas').getContext('webgl2');
gl.getExtension('EXT_color_buffer_float');
const texture = (data) => {
  const id = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, id);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, colors.length, 1, 0, gl.RGBA, gl.FLOAT, data);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return id;
};
const into = texture(null);
texture(new Float32Array(colors.flatMap((c) => [...c, 1])));
gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, into, 0);
gl.viewport(0, 0, colors.length, 1);
window.made = curves.map((curve) => {
  const program = gl.createProgram();
  const shader = (kind, source) => {
    const id = gl.createShader(kind);
    gl.shaderSource(id, '#version 300 es\\nprecision highp float;\\n' + source);
    gl.compileShader(id);
    if (!gl.getShaderParameter(id, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(id));
    gl.attachShader(program, id);
  };
  shader(gl.VERTEX_SHADER, 'void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }');
  shader(gl.FRAGMENT_SHADER, text + '\\nuniform sampler2D colors; out vec4 made; void main() { made = vec4(' + curve + '(texelFetch(colors, ivec2(gl_FragCoord.xy), 0).rgb), 1.0); }');
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.uniform1f(gl.getUniformLocation(program, 'toneMappingExposure'), 1);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Float32Array(4 * colors.length);
  gl.readPixels(0, 0, colors.length, 1, gl.RGBA, gl.FLOAT, pixels);
  return Array.from(pixels);
});
</script>`;

const folder = mkdtempSync(path.join(tmpdir(), 'boxprobe-tones-'));
writeFileSync(path.join(folder, 'index.html'), page);
const server = await serve(folder);
const browser = await BrowserPage.open(server.address);
const made = await browser.evaluate('window.made');
await browser.close();
server.close();
rmSync(folder, { recursive: true });

const rows = colors.map((color, i) => [...color, ...curves.flatMap((_, k) => [0, 1, 2].map((c) => Math.round(10000 * Math.min(Math.max(made[k][4 * i + c], 0), 1))))]);
if (!existsSync(file)) {
  writeFileSync(file, rows.map((row) => row.join(' ')).join('\n') + '\n');
  console.log(`${rows.length} colours by ${curves.length} curves of three.js written`);
} else {
  const kept = readFileSync(file, 'utf8').trim().split('\n').map((line) => line.split(' ').map(Number));
  let worst = kept.length === rows.length ? 0 : Infinity;
  kept.forEach((row, i) => row.forEach((value, c) => { worst = Math.max(worst, Math.abs(value - rows[i][c])); }));
  console.log(`${rows.length} colours: at most ${worst / 10000} from what is kept`);
  process.exit(worst <= 3 ? 0 : 1);
}
