// The scene in Babylon.js, left-handed as by default: a reflection probe of the same face size and box, filtered by HDRFiltering.
import * as BABYLON from '@babylonjs/core';
import { config, mark, settled, timed } from './timing.js';

const { width, height, camera: view, probe } = config;
const canvas = document.createElement('canvas');
canvas.width = width;
canvas.height = height;
const engine = new BABYLON.Engine(canvas, config.samples > 1, { preserveDrawingBuffer: true });
const scene = new BABYLON.Scene(engine);
scene.clearColor = new BABYLON.Color4(0, 0, 0, 1);
const mirrored = ([x, y, z]) => new BABYLON.Vector3(-x, y, z);
const camera = new BABYLON.TargetCamera('camera', mirrored(view.position), scene);
camera.upVector = mirrored(view.up);
camera.setTarget(mirrored(view.target));
camera.fov = view.verticalFovDegrees * Math.PI / 180;
camera.minZ = 0.01;
for (const light of config.lights) {
  const sun = new BABYLON.DirectionalLight('sun', mirrored(light.direction), scene);
  sun.diffuse = sun.specular = new BABYLON.Color3(...light.color);
  sun.intensity = light.intensity;
}
const picture = (name) => name && new BABYLON.Texture('/scene/' + name, scene, false, false);
const black = BABYLON.Color3.Black();
const materials = config.materials.map((source, index) => {
  const material = new BABYLON.PBRMaterial('material ' + index, scene);
  const color = new BABYLON.Color3(...source.color);
  material.backFaceCulling = false;
  material.unlit = source.unlit;
  material.albedoColor = color;
  material.albedoTexture = picture(source.texture);
  material.metallic = source.metallic;
  material.roughness = source.roughness;
  material.emissiveColor = source.unlit ? black : new BABYLON.Color3(...source.emissive);
  material.emissiveTexture = picture(source.emissiveTexture);
  return material;
});
const meshes = config.meshes.map(({ name, material, positions, normals, coordinates, indices }) => {
  const data = new BABYLON.VertexData();
  data.positions = positions.map((v, i) => i % 3 === 0 ? -v : v);
  data.normals = normals.map((v, i) => i % 3 === 0 ? -v : v);
  data.uvs = coordinates;
  data.indices = indices;
  const mesh = new BABYLON.Mesh(name, scene);
  data.applyToMesh(mesh);
  mesh.material = materials[material];
  return mesh;
});
if (config.sky) {
  const sky = await new Promise((resolve, reject) => {
    const texture = new BABYLON.HDRCubeTexture('/scene/' + config.sky, scene, 256, false, true, false, false, () => resolve(texture), reject);
  });
  scene.environmentTexture = sky;
  meshes.push(scene.createDefaultSkybox(sky, true, 1000, 0));
}
await scene.whenReadyAsync();

const seen = meshes.filter((mesh, index) => !config.meshes[index] || config.meshes[index].seenByProbes);
const capture = new BABYLON.ReflectionProbe('probe', probe.faceSize, scene, true, true, true);
capture.position = mirrored(probe.origin);
capture.renderList.push(...seen);
capture.refreshRate = BABYLON.RenderTargetTexture.REFRESHRATE_RENDER_ONCE;
const { min, max } = probe.box;
capture.cubeTexture.boundingBoxSize = new BABYLON.Vector3(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
capture.cubeTexture.boundingBoxPosition = mirrored(min.map((value, axis) => 0.5 * (value + max[axis])));
// Drawn with frames of the scene, the first ones before the clock is read: they leave out what is not compiled yet.
scene.customRenderTargets.push(capture.cubeTexture);
for (let i = 0; i < 3; i++) {
  await scene.whenReadyAsync(true);
  capture.cubeTexture.resetRefreshCounter();
  scene.render();
}
await settled(engine._gl);
await mark('capture');
capture.cubeTexture.resetRefreshCounter();
scene.render();
scene.customRenderTargets.pop();
const filtering = new BABYLON.HDRFiltering(engine);
filtering.quality = 64;  // samples, as ours at mip 1; its own 4096 take many minutes here
await filtering.prefilter(capture.cubeTexture);
for (const material of materials) material.reflectionTexture = capture.cubeTexture;
await settled(engine._gl);
await mark('captured');
for (let i = 0; i < 3; i++) {  // what reflects is compiled anew
  scene.render();
  await scene.whenReadyAsync();
}
await timed(engine._gl, canvas, () => scene.render(), 1);
