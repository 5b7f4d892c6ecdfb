// Boxprobe's probes in three.js r187 and later (TSL). Exported with: boxprobe export SCENE -o DIR --format ktx2 --ladder three
//
//   const probe = await loadBoxprobe('probes/room.json');
//   material.envNode = boxprobeNode(probe);  // of a MeshStandardNodeMaterial
//
// three.js' own getParallaxCorrectNormal() knows neither a turned box nor a capture origin beside the box's middle; this does.
import {
  CompressedCubeTexture, HalfFloatType, LinearFilter, LinearMipmapLinearFilter, NoColorSpace, Quaternion, RGBAFormat, Vector3,
} from 'three/webgpu';
import { Fn, dot, float, max, min, normalize, pmremTexture, positionWorld, vec3 } from 'three/tsl';
import { read } from 'three/addons/libs/ktx-parse.module.js';

/** `url` of the JSON file; its picture lies beside it. */
export async function loadBoxprobe(url) {
  const place = new URL(url, document.baseURI);
  const description = await (await fetch(place)).json();
  if (description.ladder.name !== 'three') throw new Error(`${url}: export it with --ladder three`);
  const file = await (await fetch(new URL(description.file, place))).arrayBuffer();
  return { description, texture: cubeTexture(read(new Uint8Array(file))) };
}

// KTX2Loader of r187 makes a flat picture of an uncompressed cube, so the texture is put together here. CompressedCubeTexture is the
// class that takes given levels; its format need not be a compressed one.
function cubeTexture(container) {
  const size = container.pixelWidth;
  const faces = [];
  for (let face = 0; face < 6; face++) {
    const mipmaps = container.levels.map(({ levelData }, level) => {
      const bytes = levelData.byteLength / 6;
      const copy = levelData.slice(face * bytes, (face + 1) * bytes);
      return { data: new Uint16Array(copy.buffer), width: size >> level, height: size >> level };
    });
    faces.push({ mipmaps, width: size, height: size });
  }
  const texture = new CompressedCubeTexture(faces, RGBAFormat, HalfFloatType);
  texture.colorSpace = NoColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.isPMREMTexture = true;
  texture.needsUpdate = true;
  return texture;
}

/** Reflection and irradiance of the probe, box-projected, for `envNode`. World units are metres, +Y up, as in glTF. */
export function boxprobeNode({ description, texture }) {
  const turn = new Quaternion(...description.rotationQuaternion);
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => new Vector3(...axis).applyQuaternion(turn));
  const center = new Vector3(...description.box.center);
  const origin = new Vector3(...description.origin);
  const half = new Vector3(...description.box.size).multiplyScalar(0.5);
  const middle = new Vector3(...axes.map((axis) => axis.dot(center.clone().sub(origin))));  // of the box, in its own axes
  const node = (v) => vec3(v.x, v.y, v.z);
  const turned = (v) => vec3(...axes.map((axis) => dot(v, node(axis))));
  const direction = Fn((_, builder) => {
    const ray = turned(normalize(builder.context.getUV(null, builder))).toVar();
    if (!description.projection) return ray;
    const from = turned(positionWorld.sub(node(origin))).sub(node(middle)).toVar();
    const speed = max(ray.abs(), 1e-20);
    const gaps = max(node(half).sub(from.mul(ray.sign())), 0);
    const reach = min(gaps.x.div(speed.x), gaps.y.div(speed.y), gaps.z.div(speed.z));
    return from.add(ray.mul(reach)).add(node(middle));
  });
  return pmremTexture(texture, direction()).mul(float(description.intensity));
}
