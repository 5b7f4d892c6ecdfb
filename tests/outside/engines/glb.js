// Meshes of a GLB file as plain arrays in world space: what engines whose own loaders would stand between need. Nodes without
// children, as this project's scenes have them.

const components = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const arrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

/** [{ name, positions, normals, indices }] */
export async function glbMeshes(url) {
  const file = await (await fetch(url)).arrayBuffer();
  const jsonLength = new DataView(file).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(file, 20, jsonLength)));
  const binary = file.slice(28 + jsonLength);
  const read = (index) => {
    const accessor = json.accessors[index], view = json.bufferViews[accessor.bufferView];
    const Type = arrays[accessor.componentType], count = accessor.count * components[accessor.type];
    if (view.byteStride && view.byteStride !== components[accessor.type] * Type.BYTES_PER_ELEMENT) throw new Error('interleaved: not read here');
    const start = (view.byteOffset || 0) + (accessor.byteOffset || 0);
    return new Type(binary.slice(start, start + count * Type.BYTES_PER_ELEMENT));
  };
  return json.nodes.flatMap((node) => {
    if (node.rotation || node.scale || node.matrix || node.children) throw new Error(node.name + ': only moved nodes are read here');
    const move = node.translation || [0, 0, 0];
    return json.meshes[node.mesh].primitives.map((primitive) => ({
      name: node.name,
      positions: read(primitive.attributes.POSITION).map((v, i) => v + move[i % 3]),
      normals: read(primitive.attributes.NORMAL),
      indices: read(primitive.indices),
    }));
  });
}
