// Writes a glTF file again without one extension, by glTF-Transform: the same model for readers that do not know it.
//   npm install @gltf-transform/core @gltf-transform/extensions @gltf-transform/functions draco3dgltf meshoptimizer sharp
//   node foreign_rewrite.mjs IN OUT.glb EXTENSION [VARIANT]
import {NodeIO} from '@gltf-transform/core';
import {ALL_EXTENSIONS} from '@gltf-transform/extensions';
import {dequantize, textureCompress, uninstance} from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import {MeshoptDecoder} from 'meshoptimizer';
import sharp from 'sharp';

const [from, to, name, variant] = process.argv.slice(2);
await MeshoptDecoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.decoder': await draco3d.createDecoderModule(), 'meshopt.decoder': MeshoptDecoder});
const document = await io.read(from);
if (!document.getRoot().listExtensionsUsed().some(e => e.extensionName === name)) throw new Error(`${from} does not use ${name}`);
if (name === 'EXT_texture_webp') await document.transform(textureCompress({encoder: sharp, targetFormat: 'png'}));
if (name === 'EXT_mesh_gpu_instancing') await document.transform(uninstance());
if (name === 'EXT_meshopt_compression') await document.transform(dequantize());
if (name === 'KHR_materials_variants') {
  for (const mesh of document.getRoot().listMeshes()) {
    for (const primitive of mesh.listPrimitives()) {
      const list = primitive.getExtension(name);
      const chosen = list?.listMappings().find(m => m.listVariants().some(v => v.getName() === variant));
      if (chosen) primitive.setMaterial(chosen.getMaterial());
    }
  }
}
for (const extension of document.getRoot().listExtensionsUsed()) {
  const quantization = name === 'EXT_meshopt_compression' && extension.extensionName === 'KHR_mesh_quantization';
  if (extension.extensionName === name || quantization) extension.dispose();
}
await io.write(to, document);
