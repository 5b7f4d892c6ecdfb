# Godot 3 draws a mirror ball in a room of six pictures with the probes that boxprobe_live_godot3.gd keeps up to date. Where request.json
# is found, it saves the picture and, as it is asked to, reads another; both as bytes of RGB. Ends with end.txt.
extends Node

var follower
var frames = 0

func vector(list):
	return Vector3(list[0], list[1], list[2])

func read_text(name):
	var file = File.new()
	return "" if file.open(name, File.READ) != OK else file.get_as_text()

func save(image, name):
	image.convert(Image.FORMAT_RGB8)
	var file = File.new()
	file.open("res://" + name, File.WRITE)
	file.store_buffer(image.get_data())
	file.close()

func _ready():
	var config = JSON.parse(read_text("res://config.json")).result
	for wall in config.walls:
		var arrays = []
		arrays.resize(Mesh.ARRAY_MAX)
		var positions = PoolVector3Array()
		var normals = PoolVector3Array()
		var uvs = PoolVector2Array()
		for i in range(wall.positions.size() / 3):
			positions.append(Vector3(wall.positions[3 * i], wall.positions[3 * i + 1], wall.positions[3 * i + 2]))
			normals.append(Vector3(wall.normals[3 * i], wall.normals[3 * i + 1], wall.normals[3 * i + 2]))
			uvs.append(Vector2(wall.uvs[2 * i], wall.uvs[2 * i + 1]))
		arrays[Mesh.ARRAY_VERTEX] = positions
		arrays[Mesh.ARRAY_NORMAL] = normals
		arrays[Mesh.ARRAY_TEX_UV] = uvs
		arrays[Mesh.ARRAY_INDEX] = PoolIntArray(wall.indices)
		var mesh = ArrayMesh.new()
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		var image = Image.new()
		assert(image.load("res://" + wall.picture) == OK)
		var texture = ImageTexture.new()
		texture.create_from_image(image, Texture.FLAG_FILTER | Texture.FLAG_MIPMAPS)
		var material = SpatialMaterial.new()
		material.flags_unshaded = true
		material.params_cull_mode = SpatialMaterial.CULL_DISABLED
		material.albedo_texture = texture
		mesh.surface_set_material(0, material)
		var instance = MeshInstance.new()
		instance.mesh = mesh
		add_child(instance)
	var sphere = SphereMesh.new()
	sphere.radius = config.radius
	sphere.height = 2 * config.radius
	sphere.radial_segments = 128
	sphere.rings = 64
	var mirror = SpatialMaterial.new()
	mirror.metallic = 1.0
	mirror.roughness = 0.0
	sphere.material = mirror
	var ball = MeshInstance.new()
	ball.mesh = sphere
	ball.layers = 2  # seen by the camera, not by probes
	add_child(ball)
	var camera = Camera.new()
	camera.fov = config.camera.verticalFovDegrees
	camera.near = 0.01
	add_child(camera)
	camera.look_at_from_position(vector(config.camera.position), vector(config.camera.target), vector(config.camera.up))
	camera.current = true
	follower = preload("res://boxprobe_live_godot3.gd").new()
	follower.path = "res://live.glb"
	follower.connect("updated", self, "_updated")
	add_child(follower)
	print("drawn by ", VisualServer.get_video_adapter_name())

func _updated(_revision):
	frames = 0

func _process(_delta):
	for child in follower.get_children():
		if child is ReflectionProbe:
			child.cull_mask = 1
			child.interior_enable = true
			# All six faces anew: what is captured once keeps some from before a move.
			child.update_mode = ReflectionProbe.UPDATE_ALWAYS if frames < 2 else ReflectionProbe.UPDATE_ONCE
	frames += 1
	if File.new().file_exists("res://end.txt"):
		get_tree().quit()
	if frames < 8:  # a probe is captured over several frames
		return
	var request = read_text("res://request.json")
	if request == "":
		return
	Directory.new().remove("res://request.json")
	request = JSON.parse(request).result
	var ours = Image.new()
	assert(ours.load("res://" + request.ours) == OK)
	save(ours, request.name + "-ours.rgb")
	var picture = get_viewport().get_texture().get_data()
	picture.flip_y()
	save(picture, request.name + "-godot.rgb")
	print("boxprobe drawn ", request.name)
