# Boxprobe's probes and lamps in Godot 3 while they are edited: follows a .glb of `boxprobe export --format glb --watch` or of File > Live
# link in the window. A script of a Spatial at the scene's origin; it runs in the editor, too.
#
# Makes and moves a ReflectionProbe for each probe, and an OmniLight for each lamp, as children. Godot 3 has one box for influence and
# projection, and no area lights: a lamp becomes a point with its light straight ahead at a distance of one metre.
tool
extends Spatial

signal updated(revision)

const NAME = "BOXPROBE_reflection_probes"

export(String) var path = "res://live.glb"

var seen = ""
var wait = 0.0

func _process(delta):
	wait -= delta
	if wait > 0.0:
		return
	wait = 0.1
	# Times of files are whole seconds here, so the text of the revision counts. It is written after the file.
	var revision = read_text(path + ".revision")
	if revision == "" or revision == seen:
		return
	var extension = read_extension()
	if extension == null:
		return  # not whole: looked at again
	seen = revision
	update(extension)
	emit_signal("updated", revision)

func read_text(name):
	var file = File.new()
	if file.open(name, File.READ) != OK:
		return ""
	var text = file.get_as_text()
	file.close()
	return text

# The JSON chunk alone.
func read_extension():
	var file = File.new()
	if file.open(path, File.READ) != OK:
		return null
	var magic = file.get_32()
	var version = file.get_32()
	var length = file.get_32()
	var size = file.get_32()
	var kind = file.get_32()
	if magic != 0x46546C67 or version != 2 or kind != 0x4E4F534A or length != file.get_len() or size > length:
		return null
	var parsed = JSON.parse(file.get_buffer(size).get_string_from_utf8())
	file.close()
	if parsed.error != OK or not parsed.result.get("extensions", {}).has(NAME):
		return null
	return parsed.result.extensions[NAME]

func vector(list):
	return Vector3(list[0], list[1], list[2])

# The child that stands for `key`, made where it is missing; edits of it elsewhere stay.
func placed(key, name, kind):
	for child in get_children():
		if child.has_meta("boxprobe") and child.get_meta("boxprobe") == key:
			return child
	var made = kind.new()
	made.set_meta("boxprobe", key)
	for special in ["/", ".", ":", "@", "%", "\""]:
		name = name.replace(special, "_")
	made.name = name
	add_child(made)
	if Engine.editor_hint:
		made.owner = get_tree().edited_scene_root
	return made

func set_probe(probe):
	var each = placed("probe " + probe.name, probe.name, ReflectionProbe)
	var low = vector(probe.box.min)
	var high = vector(probe.box.max)
	var middle = 0.5 * (low + high)
	var turn = Basis(Quat(probe.rotation[0], probe.rotation[1], probe.rotation[2], probe.rotation[3]))
	each.transform = Transform(turn, vector(probe.origin) + turn.xform(middle))
	each.extents = 0.5 * (high - low)
	each.origin_offset = -middle
	each.box_projection = not probe.technique.begins_with("infinite")
	each.intensity = probe.intensity
	each.max_distance = probe.far

func set_lamp(number, lamp):
	var each = placed("lamp %d" % number, "lamp %d" % number, OmniLight)
	var middle = Vector3()
	var area = Vector3()
	for i in range(lamp.corners.size()):
		var corner = vector(lamp.corners[i])
		middle += corner / lamp.corners.size()
		area += 0.5 * corner.cross(vector(lamp.corners[(i + 1) % lamp.corners.size()]))
	var brightest = max(max(lamp.radiance[0], lamp.radiance[1]), max(lamp.radiance[2], 1e-9))
	each.translation = middle + 0.02 * area.normalized()
	each.light_color = Color(lamp.radiance[0] / brightest, lamp.radiance[1] / brightest, lamp.radiance[2] / brightest)
	each.light_energy = brightest * area.length()
	each.omni_range = 20.0

func update(extension):
	var kept = {}
	for probe in extension.probes:
		set_probe(probe)
		kept["probe " + probe.name] = true
	var lamps = extension.get("lamps", [])
	for number in range(lamps.size()):
		set_lamp(number, lamps[number])
		kept["lamp %d" % number] = true
	for child in get_children():
		if child.has_meta("boxprobe") and not kept.has(child.get_meta("boxprobe")):
			child.free()
