// Draws a .glb of `boxprobe export --format glb` in three.js r187 (WebGLRenderer): box projection, weights of several probes, diffuse
// light from lattices and lamps, as data/glb/README.md specifies.
//   const gltf = await loadBoxprobeGlb('room.glb');
//   scene.add(gltf.scene);                       // gltf.boxprobe is the extension; its scene.cameras are gltf.cameras, too
//   scene.background = gltf.scene.userData.background || null; renderer.shadowMap.enabled = true;
// Left out: shadows of lamps, lamps as shapes in reflections, a sky's picture as the background, techniques other than `box` and `infinite`.
import {
  Box3, Color, CompressedCubeTexture, Data3DTexture, DataTexture, DataUtils, DoubleSide, EquirectangularReflectionMapping, HalfFloatType, LinearFilter,
  LinearMipmapLinearFilter, Matrix3, Matrix4, NoColorSpace, Quaternion, RGBAFormat, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const NAME = 'BOXPROBE_reflection_probes', MOST = 4;  // probes of a mesh

/** Resolves as GLTFLoader does; without the extension the model is as it is. */
export function loadBoxprobeGlb(url) {
  return new GLTFLoader().register((parser) => new Probes(parser)).loadAsync(url);
}

/** Colour by the direction's y, as a scene's sky is without a picture. */
function background({ color, image, top = [0.3, 0.45, 0.7], horizon = [0.75, 0.82, 0.9], ground = [0.18, 0.17, 0.16] } = {}) {
  if (color || image) return color ? new Color().fromArray(color) : null;
  const rows = 1024, heights = [...Array(rows).keys()].map((row) => Math.sin(((row + 0.5) / rows - 0.5) * Math.PI));
  const colors = heights.flatMap((y) => [0, 1, 2].map((c) => horizon[c] + Math.abs(y) * ((y > 0 ? top : ground)[c] - horizon[c])).concat(1));
  const texture = new DataTexture(Uint16Array.from(colors, (v) => DataUtils.toHalfFloat(v)), 1, rows, RGBAFormat, HalfFloatType);
  return Object.assign(linear(texture, LinearFilter), { mapping: EquirectangularReflectionMapping });
}
const turned = (quaternion) => new Matrix3().setFromMatrix4(new Matrix4().makeRotationFromQuaternion(quaternion));
const linear = (texture, minFilter) => Object.assign(texture, { colorSpace: NoColorSpace, minFilter, magFilter: LinearFilter, generateMipmaps: false, needsUpdate: true });
class Probes {
  constructor(parser) { Object.assign(this, { name: NAME, parser }); }
  async afterRoot(gltf) {
    const data = this.parser.json.extensions?.[NAME];
    if (!data) return;
    if (data.version !== 1) throw new Error(`${NAME}: version ${data.version} is not read`);
    gltf.boxprobe = data;
    this.data = data;
    this.maps = await Promise.all(data.maps.map((map) => this.cube(map)));
    this.lattices = await Promise.all((data.lattices || []).map((lattice) => this.lattice(lattice)));
    gltf.scene.userData.background = background(data.scene.sky);
    this.probes = data.probes.filter((probe) => probe.map !== undefined).map((probe) => this.probe(probe))
      .sort((a, b) => b.importance - a.importance);
    gltf.scene.updateMatrixWorld(true);
    const meshes = [], made = new Map(), all = new Box3().setFromObject(gltf.scene, true), size = all.getSize(new Vector3()).length();
    gltf.scene.traverse((object) => {
      object.castShadow = object.isDirectionalLight === true;
      if (object.castShadow) {  // a sun: from the middle of everything, to both sides
        Object.assign(object.shadow.camera, { left: -size / 2, right: size / 2, bottom: -size / 2, top: size / 2, near: -size, far: size });
        Object.assign(object.shadow, { normalBias: size / 4096, bias: -1e-5 }).mapSize.set(4096, 4096);
        object.position.copy(object.parent.worldToLocal(all.getCenter(new Vector3())));
      } else if (object.isMesh) object.castShadow = !object.material.transparent && !object.material.transmission, object.receiveShadow = true, object.material.shadowSide = DoubleSide;
      const objects = data.scene.objects || {}, name = this.nodeName(object), settings = Object.hasOwn(objects, name) ? objects[name] : {};
      if (settings.visible === false) object.visible = false;
      if (object.isMesh && object.material.isMeshStandardMaterial && settings.probeMode !== 'off') meshes.push([object, settings]);
    });
    for (const [mesh, { probeMode }] of meshes) {
      const bounds = new Box3().setFromObject(mesh, true);
      const probes = this.probes.filter((probe) => probe.bounds.intersectsBox(bounds)).slice(0, probeMode === 'simple' ? 1 : MOST);
      const sky = data.sky && (probeMode || 'blend+sky') === 'blend+sky' ? this.maps[data.sky.map] : null;
      const key = [mesh.material.uuid, !!sky, ...probes.map((probe) => probe.name)].join();
      if (!made.has(key)) made.set(key, lit(mesh.material.clone(), probes, sky, data.scene.energy === 'multiple'));
      mesh.material = made.get(key);
    }
  }
  nodeName(object) {
    const node = this.parser.associations.get(object)?.nodes;
    return node !== undefined ? this.parser.json.nodes[node].name : object.parent ? this.nodeName(object.parent) : undefined;
  }
  async halves(view) { return new Uint16Array(await this.parser.getDependency('bufferView', view)); }
  async cube(map) {
    if (map.encoding !== 'rgba16f') throw new Error(`${NAME}: encoding ${map.encoding} is not read`);
    const levels = await Promise.all(map.levels.map(({ bufferView }) => this.halves(bufferView)));
    const faces = [0, 1, 2, 3, 4, 5].map((face) => ({
      width: map.levels[0].size, height: map.levels[0].size,
      mipmaps: levels.map((data, level) => {
        const { size } = map.levels[level], count = 4 * size * size;
        return { data: data.subarray(face * count, (face + 1) * count), width: size, height: size };
      }),
    }));
    // The class that takes given levels; its format need not be a compressed one.
    const texture = linear(new CompressedCubeTexture(faces, RGBAFormat, HalfFloatType), LinearMipmapLinearFilter);
    return { texture, last: map.levels.length - 1, irradiance: map.irradiance.map((c) => new Vector3(...c)), rotation: new Quaternion(...(map.rotation || [0, 0, 0, 1])) };
  }
  async lattice({ nodes, min, max, bufferView, cuts }) {
    const parts = [await this.halves(bufferView)];
    if (cuts !== undefined) parts.push(await this.halves(cuts));
    const data = new Uint16Array(parts[0].length + (parts[1]?.length || 0));
    parts.forEach((part, i) => data.set(part, i * parts[0].length));
    const count = cuts === undefined ? 7 : 10;
    const texture = Object.assign(new Data3DTexture(data, nodes[0], nodes[1], nodes[2] * count), { format: RGBAFormat, type: HalfFloatType });
    const size = max.map((v, i) => v - min[i]);
    return { texture: linear(texture, LinearFilter), count, nodes: new Vector3(...nodes), low: new Vector3(...min), perUnit: new Vector3(...size.map((v, i) => (nodes[i] - 1) / Math.max(v, 1e-30))) };
  }
  probe(json) {
    const rotation = new Quaternion(...json.rotation), origin = new Vector3(...json.origin), map = this.maps[json.map];
    // A surface in a face of the influence box counts as inside.
    const largest = Math.max(...json.influence.max.map((v, i) => v - json.influence.min[i]));
    const low = new Vector3(...json.influence.min).subScalar(1e-4 * largest), high = new Vector3(...json.influence.max).addScalar(1e-4 * largest);
    const bounds = new Box3(low, high).clone().applyMatrix4(new Matrix4().makeRotationFromQuaternion(rotation).setPosition(origin));
    const rate = (side) => new Vector3(...json.blendDistance[side].map((v) => 1 / Math.max(v, 1e-5 * largest)));
    return {
      ...json, bounds, origin, map, low, high, rateMin: rate('min'), rateMax: rate('max'), boxMin: new Vector3(...json.box.min), boxMax: new Vector3(...json.box.max),
      probeFromWorld: turned(rotation.clone().invert()), mapFromProbe: turned(map.rotation.clone().invert().multiply(rotation)),
      lattice: json.lattice === undefined ? null : this.lattices[json.lattice], lamps: (json.lamps || []).map((i) => this.data.lamps[i]),
    };
  }
}
/** The material with the probes' light in place of an environment map's. */
function lit(material, probes, sky, multiple) {
  const uniforms = {}, set = (type, name, value) => { uniforms[name] = { value, type }; };
  const blocks = [], groups = [];
  probes.forEach((probe, i) => {
    for (const [name, key] of [['Origin', 'origin'], ['Low', 'low'], ['High', 'high'], ['RateMin', 'rateMin'], ['RateMax', 'rateMax'], ['BoxMin', 'boxMin'], ['BoxMax', 'boxMax']]) set('vec3', `bp${name}${i}`, probe[key]);
    set('mat3', `bpTurn${i}`, probe.probeFromWorld);
    set('mat3', `bpMapTurn${i}`, probe.mapFromProbe);
    set('samplerCube', `bpMap${i}`, probe.map.texture);
    if (!groups.length || groups.at(-1).importance !== probe.importance) groups.push({ importance: probe.importance, slots: [] });
    groups.at(-1).slots.push(i);
    const diffuse = probe.lattice ? `bpLattice(bpNodes${i}, ${probe.lattice.count}.0, bpNodeCount${i}, bpNodeLow${i}, bpPerUnit${i}, local, bpTurn${i} * n, n)` : sh(`bpSh${i}`);
    if (probe.lattice) {
      set('sampler3D', `bpNodes${i}`, probe.lattice.texture);
      for (const [name, key] of [['NodeCount', 'nodes'], ['NodeLow', 'low'], ['PerUnit', 'perUnit']]) set('vec3', `bp${name}${i}`, probe.lattice[key]);
    } else set('vec3', `bpSh${i}[9]`, probe.map.irradiance);
    const lamps = probe.lattice ? probe.lamps.map((lamp, k) => {
      set('vec3', `bpLamp${i}_${k}[8]`, [...Array(8).keys()].map((c) => new Vector3(...lamp.corners[Math.min(c, lamp.corners.length - 1)])));
      return `diffuse += bpLampDiffuse(bpLamp${i}_${k}, ${lamp.corners.length}, ${!!lamp.bothSides}, p, n) * vec3(${lamp.radiance.map((v) => v.toPrecision(9)).map((v) => (/[.e]/.test(v) ? v : v + '.0')).join()});`;
    }).join('\n') : '';
    blocks.push(`if (w${i} > 0.0) {
      vec3 local = bpTurn${i} * (p - bpOrigin${i}), ray = bpTurn${i} * r;
      ${probe.technique.startsWith('infinite') ? '' : `ray = bpHit(local, ray, bpBoxMin${i}, bpBoxMax${i});`}
      vec4 seen = textureLod(bpMap${i}, bpMapTurn${i} * ray, bpLevel(rough, ${probe.map.last}.0));
      vec3 diffuse = ${diffuse};
      ${lamps}
      light += w${i} * float(${probe.intensity}) * (seen.rgb${probe.open ? ' + clamp(1.0 - seen.a, 0.0, 1.0) * skyLight' : ''});
      irr += w${i} * float(${probe.intensity}) * diffuse; }`);
  });
  const weights = groups.map(({ slots }) => `{ ${slots.map((i) => `vec3 l${i} = bpTurn${i} * (p - bpOrigin${i}); w${i} = bpWeight(l${i} - bpLow${i}, bpRateMin${i}) * bpWeight(bpHigh${i} - l${i}, bpRateMax${i});`).join(' ')}
      float s = ${slots.map((i) => `w${i}`).join(' + ')}, share = remaining * (s < 1.0 ? 1.0 + s * (1.0 - s) : 1.0 / s), t = min(s, 1.0);
      ${slots.map((i) => `w${i} *= share;`).join(' ')} remaining *= max(1.0 - t * (1.0 + t * (1.0 - t)), 0.0); }`).join('\n');
  const only = sky ? '' : `float all = 1.0 - remaining > 1e-4 ? 1.0 / (1.0 - remaining) : 1.0; ${probes.map((_, i) => `w${i} *= all;`).join(' ')}`;
  if (sky) set('samplerCube', 'bpSky', sky.texture), set('vec3', 'bpSkySh[9]', sky.irradiance);
  const body = `{ vec3 p = ((vec4(-vViewPosition, 1.0) - viewMatrix[3]) * viewMatrix).xyz, n = (vec4(geometryNormal, 0.0) * viewMatrix).xyz;
    vec3 v = (vec4(geometryViewDir, 0.0) * viewMatrix).xyz, r = reflect(-v, n), light = vec3(0.0), irr = vec3(0.0);
    float rough = roughnessFactor, remaining = 1.0, nv = clamp(dot(n, v), 0.0, 1.0)${probes.map((_, i) => `, w${i} = 0.0`).join('')};
    vec3 skyLight = ${sky ? `textureLod(bpSky, r, bpLevel(rough, ${sky.last}.0)).rgb` : 'vec3(0.0)'};
    ${weights}\n${only}\n${blocks.join('\n')}
    ${sky ? `light += remaining * skyLight; irr += remaining * ${sh('bpSkySh')};` : ''}
    float edge = pow(1.0 - nv, 5.0);
    vec2 ab = mix(vec2(1.0 - edge, edge), texture2D(dfgLUT, vec2(rough, nv)).rg, smoothstep(0.0, 0.05, rough));
    vec3 f0 = material.specularColorBlended;
    vec3 scattered = ${multiple ? 'vec3(1.0) + f0 * (1.0 / max(ab.x + ab.y, 1e-3) - 1.0)' : 'vec3(1.0)'};
    reflectedLight.indirectSpecular += light * scattered * (f0 * ab.x + material.specularF90 * ab.y);
    reflectedLight.indirectDiffuse += irr * material.diffuseContribution * (1.0 - f0); }`;
  const declared = Object.entries(uniforms).map(([name, { type }]) => `uniform highp ${type} ${name};`).join('\n') + FUNCTIONS;
  material.envMap = null;
  material.onBeforeCompile = (shader) => {
    for (const [name, { value }] of Object.entries(uniforms)) shader.uniforms[name.replace(/\[\d\]$/, '')] = { value };
    shader.fragmentShader = shader.fragmentShader.replace('void main() {', declared + '\nvoid main() {').replace('#include <lights_fragment_maps>', body);
  };
  material.customProgramCacheKey = () => declared + body;
  return material;
}
const sh = (c) => `bpIrradiance(n, ${[...Array(9).keys()].map((i) => `${c}[${i}]`).join()})`;
const FUNCTIONS = `
float bpWeight(vec3 inside, vec3 rate) { vec3 x = clamp(inside * rate, 0.0, 1.0); x = x * x * (3.0 - 2.0 * x); return x.x * x.y * x.z; }
float bpLevel(float roughness, float last) { return log2(1.0 + roughness * roughness * (exp2(last) - 1.0)); }
vec3 bpHit(vec3 p, vec3 r, vec3 low, vec3 high) {
  vec3 speed = max(abs(r), vec3(1e-20)), gap = max(mix(p - low, high - p, step(0.0, r)), 0.0) / speed;
  return p + min(gap.x, min(gap.y, gap.z)) * r; }
vec3 bpIrradiance(vec3 n, vec3 a, vec3 b, vec3 c, vec3 d, vec3 e, vec3 f, vec3 g, vec3 h, vec3 i) {
  return max(a + b * n.y + c * n.z + d * n.x + e * n.x * n.y + f * n.y * n.z + g * (3.0 * n.z * n.z - 1.0) + h * n.x * n.z + i * (n.x * n.x - n.y * n.y), 0.0); }
vec4 bpNode(highp sampler3D map, float parts, vec3 nodes, vec3 place, float part) {
  return textureLod(map, (place + vec3(0.5, 0.5, 0.5 + part * nodes.z)) / vec3(nodes.xy, nodes.z * parts), 0.0); }
vec3 bpLattice(highp sampler3D map, float parts, vec3 nodes, vec3 low, vec3 perUnit, vec3 p, vec3 facing, vec3 n) {
  vec3 place = clamp((p - low) * perUnit, vec3(0.0), nodes - 1.0), first = min(floor(place), nodes - 2.0), seen = place;
  for (int axis = 0; axis < 3 && parts > 7.0; axis++) {
    vec3 at = seen; at[axis] = first[axis];
    vec4 way = bpNode(map, parts, nodes, at, 7.0 + float(axis));
    float t = place[axis] - first[axis], width = max((way.z - way.y) / way.x, 0.04);
    if (way.x > 1e-3) seen[axis] = first[axis] + mix(t, clamp((t + 0.06 * facing[axis] - 0.5 * (way.y + way.z) / way.x) / width + 0.5, 0.0, 1.0), min(way.x, 1.0));
  }
  vec4 t[7]; for (int i = 0; i < 7; i++) t[i] = bpNode(map, parts, nodes, seen, float(i));
  return bpIrradiance(n, t[0].xyz, vec3(t[0].w, t[1].xy), vec3(t[1].zw, t[2].x), t[2].yzw, t[3].xyz, vec3(t[3].w, t[4].xy), vec3(t[4].zw, t[5].x), t[5].yzw, t[6].xyz); }
float bpEdge(vec3 a, vec3 b, vec3 n) {
  vec3 u = normalize(a), v = normalize(b), c = cross(u, v);
  return acos(clamp(dot(u, v), -1.0, 1.0)) * dot(c, n) / max(length(c), 1e-9) / 6.2831853; }
float bpLampDiffuse(vec3 corner[8], int count, bool bothSides, vec3 p, vec3 n) {
  float height = dot(cross(corner[1] - corner[0], corner[2] - corner[0]), p - corner[0]), sum = 0.0;
  if (height <= 0.0 && !bothSides) return 0.0;
  vec3 a = corner[count - 1] - p, leaves = vec3(0.0), enters = vec3(0.0);
  for (int i = 0; i < count; i++) {
    vec3 b = corner[i] - p, from = a, to = b;
    float ha = dot(a, n), hb = dot(b, n);
    if (ha < 0.0 && hb >= 0.0) enters = from = b + hb / (hb - ha) * (a - b);
    if (ha >= 0.0 && hb < 0.0) leaves = to = a + ha / (ha - hb) * (b - a);
    if (ha >= 0.0 || hb >= 0.0) sum += bpEdge(from, to, n);
    a = b;
  }
  if (dot(leaves, leaves) > 0.0 && dot(enters, enters) > 0.0) sum += bpEdge(leaves, enters, n);
  return clamp(abs(sum), 0.0, 1.0);
}`;
