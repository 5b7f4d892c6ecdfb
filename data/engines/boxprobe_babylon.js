// Boxprobe's probes in Babylon.js 9. Exported with: boxprobe export SCENE -o DIR --format dds --ladder babylon --center
//
//   material.reflectionTexture = await loadBoxprobe('probes/room.json', scene);  // of a PBRMaterial
//
// Babylon's box is not turned, and its lookups start in the middle of the box: --center moves the cubemap there.
import { CubeTexture, Vector3 } from '@babylonjs/core';
import '@babylonjs/core/Materials/Textures/Loaders/ddsTextureLoader.js';

/** `url` of the JSON file; its picture lies beside it. */
export async function loadBoxprobe(url, scene) {
  const place = new URL(url, document.baseURI);
  const probe = await (await fetch(place)).json();
  if (probe.ladder.name !== 'babylon') throw new Error(`${url}: export it with --ladder babylon`);
  const texture = CubeTexture.CreateFromPrefilteredData(new URL(probe.file, place).href, scene, '.dds');
  const [x, y, z] = probe.box.center;
  // glTF files come into a left-handed scene with x negated, and the cube's axes follow that. A right-handed scene keeps x and
  // negates z where it samples: half a turn about Y is the same.
  texture.boundingBoxPosition = new Vector3(scene.useRightHandedSystem ? x : -x, y, z);
  if (probe.projection) texture.boundingBoxSize = new Vector3(...probe.box.size);
  if (scene.useRightHandedSystem) texture.rotationY = Math.PI;
  texture.level = probe.intensity;
  texture.gammaSpace = false;
  return texture;
}
