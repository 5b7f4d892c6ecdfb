// A scene in PlayCanvas, drawn once: the surfaces `config.nodes` reflect the exported probe by the file that comes with it; everything
// else is black.
import * as pc from 'playcanvas';
import { report, display } from './report.js';
import { glbMeshes } from './glb.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;
const canvas = document.createElement('canvas');
canvas.width = width;
canvas.height = height;
const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
app.autoRender = false;
app.start();
const device = app.graphicsDevice;
const colorBuffer = new pc.Texture(device, { width, height, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false, minFilter: pc.FILTER_NEAREST, magFilter: pc.FILTER_NEAREST });
const target = new pc.RenderTarget({ colorBuffer, depth: true });
const eye = new pc.Entity('eye');
eye.addComponent('camera', { fov: config.camera.verticalFovDegrees, nearClip: 0.01, farClip: 1000, clearColor: new pc.Color(0, 0, 0, 1) });
eye.camera.renderTarget = target;
eye.camera.gammaCorrection = pc.GAMMA_NONE;
eye.camera.toneMapping = pc.TONEMAP_LINEAR;
eye.setPosition(...config.camera.position);
eye.lookAt(new pc.Vec3(...config.camera.target), new pc.Vec3(...config.camera.up));
app.root.addChild(eye);
app.scene.ambientLight = new pc.Color(0, 0, 0);

const { loadBoxprobe, applyBoxprobe } = await import('/export/boxprobe_playcanvas.js');
const probed = new pc.StandardMaterial();
probed.useMetalness = true;
probed.metalness = 1;
probed.gloss = 1 - config.roughness;
probed.useFog = false;
probed.cull = pc.CULLFACE_NONE;
applyBoxprobe(await loadBoxprobe('/export/' + config.probe + '.json', device), probed);
const plain = (color) => {
  const material = new pc.StandardMaterial();
  material.useLighting = false;
  material.diffuse = new pc.Color(0, 0, 0);
  material.emissive = color;
  material.cull = pc.CULLFACE_NONE;
  material.update();
  return material;
};
const black = plain(new pc.Color(0, 0, 0)), white = plain(new pc.Color(1, 1, 1));
const drawnMeshes = [];
for (const { name, positions, normals, indices } of await glbMeshes('/model.glb')) {
  const geometry = new pc.Mesh(device);
  geometry.setPositions(positions);
  geometry.setNormals(normals);
  geometry.setIndices(indices);
  geometry.update();
  const instance = new pc.MeshInstance(geometry, config.nodes.includes(name) ? probed : black);
  const entity = new pc.Entity(name);
  entity.addComponent('render', { meshInstances: [instance] });
  app.root.addChild(entity);
  drawnMeshes.push(instance);
}
async function drawn() {
  app.render();
  return colorBuffer.read(0, 0, width, height, { renderTarget: target, immediate: true });
}
const picture = await drawn();
for (const instance of drawnMeshes) instance.material = instance.material === probed ? white : black;
const mask = await drawn();
await report(device.gl, display(picture, width, height), display(mask, width, height));
