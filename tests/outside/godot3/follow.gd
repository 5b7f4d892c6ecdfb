# Prints what data/engines/boxprobe_live_godot3.gd made of each revision, one JSON line each, until the file end.txt is there.
extends SceneTree

var follower

func _initialize():
	follower = preload("res://boxprobe_live_godot3.gd").new()
	follower.path = "res://live.glb"
	follower.connect("updated", self, "_updated")
	get_root().add_child(follower)

func _idle(_delta):
	return File.new().file_exists("res://end.txt")

func _updated(revision):
	var probes = {}
	var lamps = 0
	for child in follower.get_children():
		if child is ReflectionProbe:
			var corners = []
			for i in range(8):
				var side = Vector3(-1 if i & 1 == 0 else 1, -1 if i & 2 == 0 else 1, -1 if i & 4 == 0 else 1)
				var corner = child.transform.xform(child.extents * side)
				corners.append([corner.x, corner.y, corner.z])
			var origin = child.transform.xform(child.origin_offset)
			probes[child.name] = {"corners": corners, "origin": [origin.x, origin.y, origin.z]}
		else:
			lamps += 1
	print("boxprobe ", JSON.print({"revision": JSON.parse(revision).result.revision, "probes": probes, "lamps": lamps}))
