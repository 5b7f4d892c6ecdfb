// Boxprobe's probes in PlayCanvas 2.22 and later. Exported with: boxprobe export SCENE -o DIR --format ktx2 --ladder three --center
//
//   applyBoxprobe(await loadBoxprobe('probes/room.json', app.graphicsDevice), material);  // a StandardMaterial
//
// PlayCanvas filters by itself, from level 0, into an atlas. Its box is not turned, and its lookups start in the middle of the box:
// --center moves the cubemap there.
import * as pc from 'playcanvas';
import { read } from 'ktx-parse';

/** `url` of the JSON file; its picture lies beside it. */
export async function loadBoxprobe(url, device) {
  const place = new URL(url, document.baseURI);
  const description = await (await fetch(place)).json();
  if (description.ladder.name !== 'three') throw new Error(`${url}: export it with --ladder three`);
  const container = read(new Uint8Array(await (await fetch(new URL(description.file, place))).arrayBuffer()));
  const { levelData } = container.levels[0];
  const bytes = levelData.byteLength / 6;
  const faces = [0, 1, 2, 3, 4, 5].map((face) => new Uint16Array(levelData.slice(face * bytes, (face + 1) * bytes).buffer));
  const cubemap = new pc.Texture(device, {
    name: description.name, cubemap: true, width: container.pixelWidth, height: container.pixelWidth, format: pc.PIXELFORMAT_RGBA16F,
    mipmaps: true, addressU: pc.ADDRESS_CLAMP_TO_EDGE, addressV: pc.ADDRESS_CLAMP_TO_EDGE, levels: [faces],
  });
  const lighting = pc.EnvLighting.generateLightingSource(cubemap);
  const envAtlas = pc.EnvLighting.generateAtlas(lighting);
  lighting.destroy();
  return { description, cubemap, envAtlas };
}

export function applyBoxprobe({ description, cubemap, envAtlas }, material) {
  material.cubeMap = cubemap;
  material.envAtlas = envAtlas;
  material.reflectivity = description.intensity;
  if (description.projection) {
    material.cubeMapProjection = pc.CUBEPROJ_BOX;
    const half = description.box.size.map((side) => side / 2);
    material.cubeMapProjectionBox = new pc.BoundingBox(new pc.Vec3(...description.box.center), new pc.Vec3(...half));
  }
  material.update();
}
