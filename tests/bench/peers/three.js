// The scene in three.js: its own glTF loader, a capture of the probe's face size at the probe's origin, filtered by PMREMGenerator. Its
// WebGL renderer has no box projection.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { config, mark, settled, timed } from './timing.js';

const { width, height, camera: view, probe } = config;
const renderer = new THREE.WebGLRenderer({ antialias: config.samples > 1, preserveDrawingBuffer: true });
renderer.setSize(width, height, false);
const gl = renderer.getContext();
const scene = (await new GLTFLoader().loadAsync('/scene/model.glb')).scene;
const world = new THREE.Scene();
world.add(scene);
for (const light of config.lights) {
  const sun = new THREE.DirectionalLight(new THREE.Color(...light.color), light.intensity);
  sun.position.set(...light.direction).negate();
  world.add(sun);
}
const filter = new THREE.PMREMGenerator(renderer);
if (config.sky) {
  world.background = await new HDRLoader().loadAsync('/scene/' + config.sky);
  world.background.mapping = THREE.EquirectangularReflectionMapping;
  world.environment = filter.fromEquirectangular(world.background).texture;
}
const camera = new THREE.PerspectiveCamera(view.verticalFovDegrees, width / height, 0.01, 1000);
camera.up.set(...view.up);
camera.position.set(...view.position);
camera.lookAt(...view.target);

await settled(gl);
await mark('capture');
const unseen = config.meshes.filter((mesh) => !mesh.seenByProbes).map((mesh) => mesh.name.replaceAll(' ', '_'));
const hidden = scene.children.filter((object) => unseen.includes(object.name));
for (const object of hidden) object.visible = false;
const target = new THREE.WebGLCubeRenderTarget(probe.faceSize, { type: THREE.HalfFloatType });
const cube = new THREE.CubeCamera(0.01, 1000, target);
cube.position.set(...probe.origin);
cube.update(renderer, world);
for (const object of hidden) object.visible = true;
world.environment = filter.fromCubemap(target.texture).texture;
await settled(gl);
await mark('captured');
await timed(gl, renderer.domElement, () => renderer.render(world, camera));
