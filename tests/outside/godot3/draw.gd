# Draws the ball and the floor of config.json with the exported shader, saves picture.png (sRGB) and ends.
extends Spatial

func vector(list):
	return Vector3(list[0], list[1], list[2])

func read_text(path):
	var file = File.new()
	assert(file.open(path, File.READ) == OK)
	var text = file.get_as_text()
	file.close()
	return text

func _ready():
	var config = JSON.parse(read_text("res://config.json")).result
	var probe = JSON.parse(read_text("res://" + config.probe + ".json")).result
	var image = Image.new()
	assert(image.load("res://" + probe.file) == OK)
	var texture = ImageTexture.new()
	texture.create_from_image(image, Texture.FLAG_FILTER | Texture.FLAG_MIPMAPS | Texture.FLAG_REPEAT)
	var shader = Shader.new()
	shader.code = read_text("res://boxprobe3.shader")
	var material = ShaderMaterial.new()
	material.shader = shader
	material.set_shader_param("picture", texture)
	material.set_shader_param("origin", vector(probe.origin))
	material.set_shader_param("box_center", vector(probe.box.center))
	material.set_shader_param("box_half", 0.5 * vector(probe.box.size))
	for mesh_data in config.meshes:
		var arrays = []
		arrays.resize(Mesh.ARRAY_MAX)
		var positions = PoolVector3Array()
		var normals = PoolVector3Array()
		for i in range(0, mesh_data.positions.size(), 3):
			positions.append(Vector3(mesh_data.positions[i], mesh_data.positions[i + 1], mesh_data.positions[i + 2]))
			normals.append(Vector3(mesh_data.normals[i], mesh_data.normals[i + 1], mesh_data.normals[i + 2]))
		arrays[Mesh.ARRAY_VERTEX] = positions
		arrays[Mesh.ARRAY_NORMAL] = normals
		arrays[Mesh.ARRAY_INDEX] = PoolIntArray(mesh_data.indices)
		var mesh = ArrayMesh.new()
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		mesh.surface_set_material(0, material)
		var instance = MeshInstance.new()
		instance.mesh = mesh
		add_child(instance)
	var camera = Camera.new()
	camera.fov = config.camera.verticalFovDegrees
	camera.near = 0.01
	add_child(camera)
	camera.look_at_from_position(vector(config.camera.position), vector(config.camera.target), vector(config.camera.up))
	camera.current = true
	for frame in range(5):
		yield(get_tree(), "idle_frame")
	yield(VisualServer, "frame_post_draw")
	var picture = get_viewport().get_texture().get_data()
	picture.flip_y()
	picture.save_png("res://picture.png")
	print("drawn by ", VisualServer.get_video_adapter_name())
	get_tree().quit()
