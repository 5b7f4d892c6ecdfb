// Diffuse light as data/engines/boxprobe_diffuse.py writes it, by other readers: Bevy's KTX2 by ktx-parse and looked up by the formula of
// Bevy's shader; Unity's coefficients by the formula of its shaders. Against the lattice of the .glb, read here.
// usage: read_diffuse.mjs BOXPROBE SCENES LIT SCRIPT OUT NODE_MODULES
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';

const [program, scenes, lit, script, out, modules] = process.argv.slice(2);
const { read } = await import(createRequire(path.resolve(modules, 'x.js')).resolve('ktx-parse'));
mkdirSync(out, { recursive: true });
const half = (h) => {
  const e = (h >> 10) & 31, m = h & 1023, s = h & 0x8000 ? -1 : 1;
  return e === 0 ? s * m * 2 ** -24 : e === 31 ? NaN : s * (1 + m / 1024) * 2 ** (e - 15);
};
let bad = 0;
const check = (holds, text) => { if (!holds) { bad++; console.log('FAILED: ' + text); } };

// A turned box with as many nodes along no two axes, in a room of four colours.
const scene = JSON.parse(readFileSync(path.join(lit, 'closed.boxprobe.json')));
scene.model = path.resolve(lit, 'closed.glb');
Object.assign(scene.probes[0], { name: 'the room/1', faceSize: 32, bounces: 1, rotationDegrees: [0, 20, 0], intensity: 1.5 });
const file = path.join(out, 'diffuse.boxprobe.json'), glb = path.join(out, 'diffuse.glb');
writeFileSync(file, JSON.stringify(scene));
execFileSync(program, ['export', file, '-o', glb, '--format', 'glb', '--quiet'], { stdio: 'inherit' });
for (const engine of ['bevy', 'unity']) execFileSync('python3', [script, glb, '-o', out, '--for', engine], { stdio: 'inherit' });

const data = readFileSync(glb), size = data.readUInt32LE(12), json = JSON.parse(data.subarray(20, 20 + size));
const extension = json.extensions.BOXPROBE_reflection_probes, probe = extension.probes[0], lattice = extension.lattices[probe.lattice];
const [nx, ny, nz] = lattice.nodes, count = nx * ny * nz, view = json.bufferViews[lattice.bufferView], start = 28 + size + (view.byteOffset || 0);
check(new Set(lattice.nodes).size === 3, `the fixture has nodes ${lattice.nodes}: two axes alike`);
const number = (node, k) => half(data.readUInt16LE(start + 2 * (4 * (Math.floor(k / 4) * count + node) + k % 4)));
/** Irradiance over pi by the specification's formula, in the axes of the world. */
const truth = (node, [x, y, z]) => [0, 1, 2].map((c) => [1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y]
  .reduce((sum, basis, k) => sum + basis * number(node, 3 * k + c), 0));
const [qx, qy, qz, qw] = probe.rotation;
const turn = ([x, y, z]) => {
  const tx = 2 * (qy * z - qz * y), ty = 2 * (qz * x - qx * z), tz = 2 * (qx * y - qy * x);
  return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
};
const nodeAt = (i, j, k) => turn([i / (nx - 1), j / (ny - 1), k / (nz - 1)].map((t, a) => lattice.min[a] + t * (lattice.max[a] - lattice.min[a])))
  .map((v, a) => v + probe.origin[a]);

// Bevy: WGSL's lookup in numbers, with texels as ktx-parse reads them.
const volume = JSON.parse(readFileSync(path.join(out, 'the_room_1.json'))), ktx = read(readFileSync(path.join(out, volume.file)));
check(ktx.vkFormat === 97 && ktx.typeSize === 2 && ktx.pixelWidth === nx && ktx.pixelHeight === 2 * ny && ktx.pixelDepth === 3 * nz && ktx.faceCount === 1
  && ktx.layerCount === 0 && ktx.levels.length === 1 && ktx.supercompressionScheme === 0, `the header: ${ktx.vkFormat} ${ktx.pixelWidth} ${ktx.pixelHeight} ${ktx.pixelDepth}`);
const [description] = ktx.dataFormatDescriptor;
check(description.texelBlockDimension.join() === '0,0,0,0' && description.bytesPlane[0] === 8 && description.samples.length === 4
  && description.samples.every((s, i) => s.bitOffset === 16 * i && s.bitLength === 15 && (s.channelType & 0xf0) === 0xc0), 'the data format descriptor');
const level = ktx.levels[0].levelData, texels = new DataView(level.buffer, level.byteOffset, level.byteLength);
check(level.byteLength === 8 * 6 * count, 'the level has ' + level.byteLength + ' bytes');
const texel = (x, y, z, c) => half(texels.getUint16(2 * (4 * (x + nx * (y + 2 * ny * z)) + c), true));
const sample = (s, t, p) => [0, 1, 2].map((c) => {  // linear, at unnormalized coordinates
  let sum = 0;
  for (let i = 0; i < 8; i++) {
    const at = [s, t, p].map((v, a) => { const low = Math.floor(v - 0.5), f = v - 0.5 - low; return i >> a & 1 ? [low + 1, f] : [low, 1 - f]; });
    const weight = at.reduce((w, [, f]) => w * f, 1);
    if (weight > 0) sum += weight * texel(...at.map(([v]) => v), c);
  }
  return sum;
});
const bevy = (world, n) => {
  const back = turn.length && (([x, y, z]) => {  // by the conjugate
    const tx = 2 * (-qy * z + qz * y), ty = 2 * (-qz * x + qx * z), tz = 2 * (-qx * y + qy * x);
    return [x + qw * tx - qy * tz + qz * ty, y + qw * ty - qz * tx + qx * tz, z + qw * tz - qx * ty + qy * tx];
  });
  const unit = back(world.map((v, a) => v - volume.translation[a])).map((v, a) => v / volume.scale[a]);
  const stp = unit.map((v, a) => Math.min(Math.max((v + 0.5) * lattice.nodes[a], 0.5), lattice.nodes[a] - 0.5));
  const sides = [0, 1, 2].map((axis) => sample(stp[0], stp[1] + (n[axis] < 0 ? ny : 0), stp[2] + axis * nz));
  return [0, 1, 2].map((c) => sides.reduce((sum, side, axis) => sum + side[c] * n[axis] ** 2, 0));
};
const axes = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
let worst = 0, largest = 0, spread = 0;
for (let k = 0; k < nz; k++) for (let j = 0; j < ny; j++) for (let i = 0; i < nx; i++) {
  const node = i + nx * (j + ny * k);
  for (const n of axes) {
    const wanted = truth(node, n).map((v) => Math.max(v, 0)), got = bevy(nodeAt(i, j, k), n);
    for (let c = 0; c < 3; c++) {
      worst = Math.max(worst, Math.abs(got[c] - wanted[c]));
      largest = Math.max(largest, wanted[c]);
      spread = Math.max(spread, Math.abs(wanted[c] - Math.max(truth(0, n)[c], 0)));
    }
  }
}
check(worst < 2e-3 * largest && spread > 0.1 * largest, `Bevy: ${worst} of ${largest} at the nodes; they differ by ${spread}`);
// Between the axes an ambient cube is a coarser basis than nine coefficients: said, and not judged.
let cubic = 0, mean = 0, directions = 0;
for (let i = 0; i < 200; i++) {
  const z = 1 - (2 * i + 1) / 200, r = Math.sqrt(1 - z * z), n = [r * Math.cos(2.399963 * i), r * Math.sin(2.399963 * i), z], node = i % count;
  const at = nodeAt(node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny)));
  const wanted = truth(node, n), got = bevy(at, n);
  cubic += wanted.reduce((sum, v, c) => sum + (v - got[c]) ** 2, 0); mean += wanted.reduce((sum, v) => sum + v * v, 0); directions++;
}
console.log(`bevy: ${nx} x ${ny} x ${nz} voxels, at the nodes along the axes within ${(100 * worst / largest).toFixed(3)} % of the brightest; `
  + `${directions} other directions ${(100 * Math.sqrt(cubic / mean)).toFixed(1)} % (root mean square): six sides in place of nine coefficients`);

// Unity: SHEvalLinearL0L1 and L2 of UnityCG.cginc, whose vectors SphericalHarmonicsL2 fills as (3, 1, 2, 0 - 6), (4, 5, 3 * 6, 7) and 8.
const unity = JSON.parse(readFileSync(path.join(out, 'light-probes.json')));
check(unity.positions.length === 3 * count && unity.coefficients.length === 27 * count, 'counts of Unity');
let off = 0, moved = 0;
for (let node = 0; node < count; node++) {
  const at = nodeAt(node % nx, Math.floor(node / nx) % ny, Math.floor(node / (nx * ny)));
  moved = Math.max(moved, Math.abs(unity.positions[3 * node] + at[0]), Math.abs(unity.positions[3 * node + 1] - at[1]), Math.abs(unity.positions[3 * node + 2] - at[2]));
  const n = [0.36, -0.48, 0.8], m = [-n[0], n[1], n[2]];  // ours, and what Unity has there
  for (let c = 0; c < 3; c++) {
    const sh = (k) => unity.coefficients[27 * node + 9 * c + k];
    const linear = sh(3) * m[0] + sh(1) * m[1] + sh(2) * m[2] + sh(0) - sh(6);
    const quadratic = sh(4) * m[0] * m[1] + sh(5) * m[1] * m[2] + 3 * sh(6) * m[2] * m[2] + sh(7) * m[2] * m[0] + sh(8) * (m[0] * m[0] - m[1] * m[1]);
    off = Math.max(off, Math.abs(linear + quadratic - 1.5 * truth(node, n)[c]));
  }
}
check(off < 1e-5 * largest && moved < 1e-6, `Unity: light off by ${off}, places by ${moved}`);
console.log(`unity: ${count} light probes, light off by ${off.toExponential(1)}, places by ${moved.toExponential(1)}`);

// Bad input gets one line.
for (const [what, text] of [[path.join(out, 'none.glb'), 'No such file'], [path.join(scenes, 'room.glb'), 'holds no probes'], [file, 'not a whole glTF']]) {
  const said = spawnSync('python3', [script, what, '-o', out, '--for', 'bevy'], { encoding: 'utf8' });
  check(said.status === 1 && said.stderr.includes(text) && said.stderr.trim().split('\n').length === 1, `${what}: ${said.stderr}`);
}
process.exit(bad ? 1 : 0);
