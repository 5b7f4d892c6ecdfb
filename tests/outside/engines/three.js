// A scene in three.js, drawn once: the surface `config.node` reflects the exported probe, by the file that comes with it or by an
// exported technique. Everything else is as the glTF file has it.
import * as THREE from 'three/webgpu';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { report, display } from './report.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;

function camera() {
  const c = config.camera;
  const result = new THREE.PerspectiveCamera(c.verticalFovDegrees, width / height, 0.01, 1000);
  result.up.set(...c.up);
  result.position.set(...c.position);
  result.lookAt(...c.target);
  return result;
}

async function probedMaterial() {
  const engine = await import('/export/boxprobe_three.js');
  const probe = await engine.loadBoxprobe('/export/' + config.probe + '.json');
  const material = new THREE.MeshStandardNodeMaterial({ color: 0xffffff, metalness: 1, roughness: config.roughness });
  material.envNode = engine.boxprobeNode(probe);
  return material;
}

const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: true });
await renderer.init();
renderer.setSize(width, height, false);
renderer.toneMapping = THREE.NoToneMapping;
const scene = (await new GLTFLoader().loadAsync('/model.glb')).scene;
const chosen = await probedMaterial();
const target = new THREE.RenderTarget(width, height, { type: THREE.FloatType, samples: 0 });
async function drawn() {
  renderer.setRenderTarget(target);
  await renderer.renderAsync(scene, camera());
  renderer.setRenderTarget(null);
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
}
const ofNode = (object) => config.nodes.some((name) => object.name === name || object.name === name.replaceAll(' ', '_'));
scene.traverse((object) => { if (object.isMesh && (ofNode(object) || ofNode(object.parent))) object.material = chosen; });
const picture = await drawn();
const white = new THREE.MeshBasicNodeMaterial({ color: 0xffffff, side: THREE.DoubleSide });
const black = new THREE.MeshBasicNodeMaterial({ color: 0x000000, side: THREE.DoubleSide });
scene.traverse((object) => { if (object.isMesh) object.material = object.material === chosen ? white : black; });
const mask = await drawn();
const gl = renderer.backend.gl;
await report(gl, display(picture, width, height), display(mask, width, height));
