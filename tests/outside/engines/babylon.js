// A scene in Babylon.js, drawn once, left-handed as by default: the surfaces `config.nodes` reflect the exported probe by the file that
// comes with it; everything else is black.
import * as BABYLON from '@babylonjs/core';
import { report, display } from './report.js';
import { glbMeshes } from './glb.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;
const canvas = document.createElement('canvas');
canvas.width = width;
canvas.height = height;
const engine = new BABYLON.Engine(canvas, false);
const scene = new BABYLON.Scene(engine);
scene.clearColor = new BABYLON.Color4(0, 0, 0, 1);
scene.imageProcessingConfiguration.applyByPostProcess = true;  // materials write linear values
const mirrored = ([x, y, z]) => new BABYLON.Vector3(-x, y, z);
const camera = new BABYLON.TargetCamera('camera', mirrored(config.camera.position), scene);
camera.upVector = mirrored(config.camera.up);
camera.setTarget(mirrored(config.camera.target));
camera.fov = config.camera.verticalFovDegrees * Math.PI / 180;
camera.minZ = 0.01;

const { loadBoxprobe } = await import('/export/boxprobe_babylon.js');
const probed = new BABYLON.PBRMaterial('probed', scene);
probed.albedoColor = BABYLON.Color3.White();
probed.metallic = 1;
probed.roughness = config.roughness;
probed.backFaceCulling = false;
probed.reflectionTexture = await loadBoxprobe('/export/' + config.probe + '.json', scene);
const plain = (color) => {
  const material = new BABYLON.StandardMaterial('plain', scene);
  material.disableLighting = true;
  material.emissiveColor = color;
  material.backFaceCulling = false;
  return material;
};
const black = plain(BABYLON.Color3.Black()), white = plain(BABYLON.Color3.White());
for (const { name, positions, normals, indices } of await glbMeshes('/model.glb')) {
  const data = new BABYLON.VertexData();
  data.positions = positions.map((v, i) => i % 3 === 0 ? -v : v);
  data.normals = normals.map((v, i) => i % 3 === 0 ? -v : v);
  data.indices = indices;
  const mesh = new BABYLON.Mesh(name, scene);
  data.applyToMesh(mesh);
  mesh.material = config.nodes.includes(name) ? probed : black;
}
const target = new BABYLON.RenderTargetTexture('target', { width, height }, scene, { generateMipMaps: false, type: BABYLON.Constants.TEXTURETYPE_FLOAT });
target.renderList = scene.meshes;
target.activeCamera = camera;
target.clearColor = new BABYLON.Color4(0, 0, 0, 1);
async function drawn() {
  await scene.whenReadyAsync();
  while (!target.isReadyForRendering()) await new Promise((resolve) => setTimeout(resolve, 50));
  target.render();
  return target.readPixels();
}
const picture = await drawn();
for (const mesh of scene.meshes) mesh.material = mesh.material === probed ? white : black;
const mask = await drawn();
await report(engine._gl, display(picture, width, height), display(mask, width, height));
