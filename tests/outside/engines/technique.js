// An exported technique in a page: the surfaces `config.nodes` are drawn by /fragment.glsl, whose only input is the exported cubemap of
// `--ladder own`, read here without an engine's loader. three.js places the scene.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { read } from 'ktx-parse';
import { report, display } from './report.js';
import { chosenMeshes, sceneCamera } from './scene.js';

const config = await (await fetch('/config.json')).json();
const { width, height } = config;
const container = read(new Uint8Array(await (await fetch('/export/' + config.probe + '.ktx2')).arrayBuffer()));
const faces = [0, 1, 2, 3, 4, 5].map((face) => ({
  width: container.pixelWidth, height: container.pixelWidth,
  mipmaps: container.levels.map(({ levelData }, level) => {
    const bytes = levelData.byteLength / 6;
    return { data: new Uint16Array(levelData.slice(face * bytes, (face + 1) * bytes).buffer), width: container.pixelWidth >> level, height: container.pixelWidth >> level };
  }),
}));
const cube = new THREE.CompressedCubeTexture(faces, THREE.RGBAFormat, THREE.HalfFloatType);
cube.minFilter = THREE.LinearMipmapLinearFilter;
cube.magFilter = THREE.LinearFilter;
cube.needsUpdate = true;

const renderer = new THREE.WebGLRenderer({ antialias: false });
const scene = (await new GLTFLoader().loadAsync('/model.glb')).scene;
const material = new THREE.RawShaderMaterial({
  glslVersion: THREE.GLSL3,
  uniforms: { probeMap: { value: cube } },
  vertexShader: `uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
    uniform vec3 cameraPosition;
    in vec3 position, normal;
    out vec3 p, n, v;
    void main() {
      vec4 world = modelMatrix * vec4(position, 1.0);
      p = world.xyz;
      n = mat3(modelMatrix) * normal;
      v = cameraPosition - world.xyz;
      gl_Position = projectionMatrix * viewMatrix * world;
    }`,
  fragmentShader: await (await fetch('/fragment.glsl')).text(),
});
const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
function drawn() {
  renderer.setRenderTarget(target);
  renderer.render(scene, sceneCamera(THREE, config));
  const pixels = new Float32Array(width * height * 4);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
  return pixels;
}
renderer.debug.onShaderError = (gl, program, vertex, fragment) => { throw new Error(gl.getShaderInfoLog(fragment) + gl.getShaderInfoLog(vertex)); };
const chosen = chosenMeshes(scene, config.nodes);
for (const mesh of chosen) mesh.material = material;
const picture = drawn();
const white = new THREE.MeshBasicMaterial({ color: 0xffffff }), black = new THREE.MeshBasicMaterial({ color: 0 });
scene.traverse((object) => { if (object.isMesh) object.material = chosen.includes(object) ? white : black; });
const mask = drawn();
await report(renderer.getContext(), display(picture, width, height), display(mask, width, height));
