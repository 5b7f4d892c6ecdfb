// A scene in three.js, drawn once: the surfaces `config.nodes` reflect the exported probe by the file that comes with it. Everything
// else is as the glTF file has it.
import * as THREE from 'three/webgpu';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { report, display } from './report.js';
import { chosenMeshes, sceneCamera } from './scene.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;
const engine = await import('/export/boxprobe_three.js');
const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: true });
await renderer.init();
renderer.toneMapping = THREE.NoToneMapping;
const scene = (await new GLTFLoader().loadAsync('/model.glb')).scene;
const target = new THREE.RenderTarget(width, height, { type: THREE.FloatType, samples: 0 });
async function drawn() {
  renderer.setRenderTarget(target);
  renderer.render(scene, sceneCamera(THREE, config));
  renderer.setRenderTarget(null);
  return renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
}
const material = new THREE.MeshStandardNodeMaterial({ color: 0xffffff, metalness: 1, roughness: config.roughness });
material.envNode = engine.boxprobeNode(await engine.loadBoxprobe('/export/' + config.probe + '.json'));
const chosen = chosenMeshes(scene, config.nodes);
for (const mesh of chosen) mesh.material = material;
const picture = await drawn();
const white = new THREE.MeshBasicNodeMaterial({ color: 0xffffff }), black = new THREE.MeshBasicNodeMaterial({ color: 0 });
scene.traverse((object) => { if (object.isMesh) object.material = chosen.includes(object) ? white : black; });
const mask = await drawn();
await report(renderer.backend.gl, display(picture, width, height), display(mask, width, height));
