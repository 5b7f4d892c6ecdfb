// A .glb of `export --format glb` drawn once by data/glb/boxprobe_glb_three.js; the mask has the surfaces `config.nodes`.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { report, display } from './report.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;
const { loadBoxprobeGlb } = await import('/loader/boxprobe_glb_three.js');
const renderer = new THREE.WebGLRenderer({ antialias: false });
renderer.debug.onShaderError = (gl, program, vertex, fragment) => { throw new Error(gl.getProgramInfoLog(program) + gl.getShaderInfoLog(fragment)); };
renderer.toneMapping = THREE.NoToneMapping;
renderer.shadowMap.enabled = !config.grid;
const scene = new THREE.Scene();
const gltf = config.grid ? await new GLTFLoader().loadAsync('/scene/' + config.file) : await loadBoxprobeGlb('/scene/' + config.file);
scene.add(gltf.scene);
if (config.grid) {
  const { boxprobeAreaLights, boxprobeLightGrids } = await import('/loader/boxprobe_light_grid.js');
  scene.add(...await boxprobeLightGrids(gltf), ...boxprobeAreaLights(gltf));
}
scene.background = gltf.scene.userData.background || null;
const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType, samples: 0 });
const camera = gltf.cameras.find((each) => (each.userData.name ?? each.name) === config.view);
camera.aspect = width / height;
camera.updateProjectionMatrix();
camera.updateMatrixWorld();
function drawn() {
  const pixels = new Float32Array(width * height * 4);
  renderer.setRenderTarget(target);
  renderer.clear();
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  return pixels;
}
const picture = drawn();
const { associations, json } = gltf.parser;
const white = new THREE.MeshBasicMaterial({ color: 0xffffff }), black = new THREE.MeshBasicMaterial({ color: 0 });
scene.background = null;
scene.traverse((object) => {
  if (!object.isMesh) return;
  const node = associations.get(object)?.nodes ?? associations.get(object.parent)?.nodes;
  object.material = config.nodes.includes(json.nodes[node]?.name) ? white : black;
});
const mask = drawn();
await report(renderer.getContext(), display(picture, width, height), display(mask, width, height));
