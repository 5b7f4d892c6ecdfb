// What the pages of three.js share: the scene's camera, and the meshes that reflect.

export function sceneCamera(THREE, { camera, width, height }) {
  const result = new THREE.PerspectiveCamera(camera.verticalFovDegrees, width / height, 0.01, 1000);
  result.up.set(...camera.up);
  result.position.set(...camera.position);
  result.lookAt(...camera.target);
  return result;
}

/** GLTFLoader writes spaces in names as underscores. */
export function chosenMeshes(scene, names) {
  const plain = names.map((name) => name.replaceAll(' ', '_'));
  const meshes = [];
  scene.traverse((object) => {
    if (object.isMesh && (plain.includes(object.name) || plain.includes(object.parent.name))) meshes.push(object);
  });
  return meshes;
}
