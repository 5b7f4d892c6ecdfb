// Diffuse light of a .glb of `boxprobe export --format glb` for three.js r187's own materials, with GLTFLoader alone: a LightProbeGridWebGL
// for each lattice, and a RectAreaLight for each lamp. Reflections are boxprobe_glb_three.js's.
//   const gltf = await new GLTFLoader().loadAsync('room.glb');
//   scene.add(gltf.scene, ...await boxprobeLightGrids(gltf), ...boxprobeAreaLights(gltf));
//
// Left out: boxes that are turned, since grids cannot be; surfaces between nodes; a grid looks half a cell ahead of the surface.
import { Color, Data3DTexture, DataUtils, HalfFloatType, LinearFilter, Matrix4, RectAreaLight, RGBAFormat, Vector3 } from 'three';
import { LightProbeGridWebGL } from 'three/addons/lighting/LightProbeGridWebGL.js';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';

// Ours is a polynomial of irradiance over pi; three's is the same with constants of its own before each coefficient, and no division by pi.
const SCALE = [0.886227, 1.023328, 1.023328, 1.023328, 0.858086, 0.858086, 0.247708, 0.858086, 0.429043].map((c) => Math.PI / c);

const extensionOf = (gltf) => gltf.parser.json.extensions?.BOXPROBE_reflection_probes || { probes: [] };

export async function boxprobeLightGrids(gltf) {
  const { probes, lattices } = extensionOf(gltf);
  return Promise.all(probes.filter(({ lattice, rotation }) => lattice !== undefined && rotation[3] ** 2 > 0.999999).map(async (probe) => {
    const { nodes, min, max, bufferView } = lattices[probe.lattice], [nx, ny, nz] = nodes;
    const halves = new Uint16Array(await gltf.parser.getDependency('bufferView', bufferView)), slice = 4 * nx * ny;
    const data = new Uint16Array(7 * (nz + 2) * slice);
    for (let part = 0; part < 7; part++) {
      for (let z = -1; z <= nz; z++) {  // each part with a copy of its first and its last slice around it
        const from = (part * nz + Math.min(Math.max(z, 0), nz - 1)) * slice, to = (part * (nz + 2) + z + 1) * slice;
        for (let i = 0; i < slice; i++) {
          const number = 4 * part + i % 4, scale = number < 27 ? probe.intensity * SCALE[Math.floor(number / 3)] : 1;
          data[to + i] = DataUtils.toHalfFloat(scale * DataUtils.fromHalfFloat(halves[from + i]));
        }
      }
    }
    // Nodes stand in the middle of a grid's cells.
    const size = max.map((v, i) => (v - min[i]) * nodes[i] / (nodes[i] - 1));
    const grid = new LightProbeGridWebGL(...size, ...nodes);
    grid.position.set(...probe.origin.map((v, i) => v + 0.5 * (min[i] + max[i])));
    grid.updateBoundingBox();
    grid.priority = probe.importance;
    grid.texture = Object.assign(new Data3DTexture(data, nx, ny, 7 * (nz + 2)), { format: RGBAFormat, type: HalfFloatType, minFilter: LinearFilter, magFilter: LinearFilter, needsUpdate: true });
    return grid;
  }));
}

/** A polygon as the rectangle along its longest side that has its area. */
export function boxprobeAreaLights(gltf) {
  RectAreaLightUniformsLib.init();
  return (extensionOf(gltf).lamps || []).map(({ corners, radiance }) => {
    const points = corners.map((corner) => new Vector3(...corner)), next = (i) => points[(i + 1) % points.length];
    const edges = points.map((point, i) => next(i).clone().sub(point)), along = edges.reduce((a, b) => (b.length() > a.length() ? b : a)).clone().normalize();
    const twice = points.reduce((sum, point, i) => sum.add(point.clone().cross(next(i))), new Vector3()), normal = twice.clone().normalize();
    const reach = points.map((point) => point.dot(along)), width = Math.max(...reach) - Math.min(...reach);
    const brightest = Math.max(...radiance, 1e-9);
    const light = new RectAreaLight(new Color().fromArray(radiance.map((v) => v / brightest)), brightest, width, twice.length() / 2 / width);
    // It shines along its own -Z.
    light.applyMatrix4(new Matrix4().makeBasis(along, normal.clone().negate().cross(along), normal.clone().negate()).setPosition(points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length)));
    return light;
  });
}
