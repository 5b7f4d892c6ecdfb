# The scene of config.json with Godot's own materials, sun, sky and reflection probe (captured once, box-projected). Prints CPU seconds of
# this process at three moments, saves picture.png and ends.
extends Spatial

const SEEN = 1
const UNSEEN = 2
const SETTLED = 30  # frames by which the probe, one face or one level of it a frame, is finished

var config

func vector(list):
	return Vector3(list[0], list[1], list[2])

func color(list):
	return Color(list[0], list[1], list[2])

func read_text(path):
	var file = File.new()
	assert(file.open(path, File.READ) == OK)
	var text = file.get_as_text()
	file.close()
	return text

# User and system time of all threads, in hundredths of a second.
func cpu_ticks():
	var file = File.new()
	assert(file.open("/proc/self/stat", File.READ) == OK)
	var words = file.get_line().split(") ")[1].split(" ")
	file.close()
	return int(words[11]) + int(words[12])

func texture(name):
	var image = Image.new()
	assert(image.load("res://" + name) == OK)
	var result = ImageTexture.new()
	result.create_from_image(image, Texture.FLAG_FILTER | Texture.FLAG_MIPMAPS | Texture.FLAG_REPEAT | Texture.FLAG_CONVERT_TO_LINEAR)
	return result

func material(source):
	var result = SpatialMaterial.new()
	result.params_cull_mode = SpatialMaterial.CULL_DISABLED
	result.flags_unshaded = source.unlit
	result.albedo_color = color(source.color)
	result.metallic = source.metallic
	result.roughness = source.roughness
	if source.texture != null:
		result.albedo_texture = texture(source.texture)
	var light = max(max(source.emissive[0], source.emissive[1]), source.emissive[2])
	if light > 0:
		result.emission_enabled = true
		result.emission = color(source.emissive) / light
		result.emission_energy = light
		if source.emissiveTexture != null:
			result.emission_operator = SpatialMaterial.EMISSION_OP_MULTIPLY
			result.emission_texture = texture(source.emissiveTexture)
	return result

func mesh_of(source, materials):
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	var positions = PoolVector3Array()
	var normals = PoolVector3Array()
	var coordinates = PoolVector2Array()
	for i in range(0, source.positions.size(), 3):
		positions.append(Vector3(source.positions[i], source.positions[i + 1], source.positions[i + 2]))
		normals.append(Vector3(source.normals[i], source.normals[i + 1], source.normals[i + 2]))
	for i in range(0, source.coordinates.size(), 2):
		coordinates.append(Vector2(source.coordinates[i], source.coordinates[i + 1]))
	var indices = PoolIntArray(source.indices)
	for i in range(0, indices.size(), 3):  # Godot's front is the other way round
		var first = indices[i]
		indices[i] = indices[i + 1]
		indices[i + 1] = first
	arrays[Mesh.ARRAY_VERTEX] = positions
	arrays[Mesh.ARRAY_NORMAL] = normals
	arrays[Mesh.ARRAY_TEX_UV] = coordinates
	arrays[Mesh.ARRAY_INDEX] = indices
	var mesh = ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, materials[source.material])
	var instance = MeshInstance.new()
	instance.mesh = mesh
	instance.layers = SEEN if source.seenByProbes else UNSEEN
	add_child(instance)

func light_scene():
	var environment = Environment.new()
	environment.background_mode = Environment.BG_COLOR
	environment.background_color = Color(0, 0, 0)
	environment.ambient_light_energy = 0
	if config.sky != null:
		var image = Image.new()
		assert(image.load("res://" + config.sky) == OK)
		var panorama = ImageTexture.new()
		panorama.create_from_image(image, Texture.FLAG_FILTER)
		var sky = PanoramaSky.new()
		sky.panorama = panorama
		environment.background_mode = Environment.BG_SKY
		environment.background_sky = sky
		environment.ambient_light_energy = 1
	var world = WorldEnvironment.new()
	world.environment = environment
	add_child(world)
	for source in config.lights:
		var sun = DirectionalLight.new()
		sun.light_color = color(source.color)
		sun.light_energy = source.intensity / PI  # Godot's sun of 1 lights a white wall as 1
		add_child(sun)
		sun.look_at_from_position(Vector3(0, 0, 0), vector(source.direction), Vector3(0, 1, 0))

func place_probe():
	var probe = ReflectionProbe.new()
	var low = vector(config.probe.influence.min)
	var high = vector(config.probe.influence.max)
	probe.translation = 0.5 * (low + high)
	probe.extents = 0.5 * (high - low)
	probe.origin_offset = vector(config.probe.origin) - probe.translation
	probe.box_projection = true
	probe.interior_enable = config.sky == null
	probe.update_mode = ReflectionProbe.UPDATE_ONCE
	probe.cull_mask = SEEN
	add_child(probe)

func frames(count):
	for _frame in range(count):
		yield(VisualServer, "frame_post_draw")

func _ready():
	config = JSON.parse(read_text("res://config.json")).result
	OS.window_size = Vector2(config.width, config.height)
	if config.samples > 1:
		get_viewport().msaa = Viewport.MSAA_4X
	var materials = []
	for source in config.materials:
		materials.append(material(source))
	for source in config.meshes:
		mesh_of(source, materials)
	light_scene()
	place_probe()
	var camera = Camera.new()
	camera.fov = config.camera.verticalFovDegrees
	camera.near = 0.01
	camera.far = 1000
	add_child(camera)
	camera.look_at_from_position(vector(config.camera.position), vector(config.camera.target), vector(config.camera.up))
	camera.current = true
	yield(frames(1), "completed")
	var first = cpu_ticks()
	yield(frames(SETTLED), "completed")
	var settled = cpu_ticks()
	yield(frames(int(config.frames)), "completed")
	var end = cpu_ticks()
	var picture = get_viewport().get_texture().get_data()
	picture.flip_y()
	picture.save_png("res://picture.png")
	print("ticks ", first, " ", settled, " ", end, " settled ", SETTLED)
	print("drawn by ", VisualServer.get_video_adapter_name())
	get_tree().quit()
