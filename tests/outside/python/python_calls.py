"""What the Python package answers: values that go in come out, a technique changes the picture, wrong input is an exception of
one line. python_calls.py SHINING.glb"""
import gc
import os
import sys
import tempfile
import unittest

import boxprobe
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImport import vtkGLTFImporter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkActor2D, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

MODEL = sys.argv.pop(1)


class Room:
    """The six-colour room with its mirror ball, in a window off the screen."""

    def __init__(self):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(120, 120)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        importer = vtkGLTFImporter()
        importer.SetFileName(MODEL)
        importer.SetRenderWindow(self.window)
        importer.Update()
        self.renderer.GetActiveCamera().SetPosition(0.9, 0.5, 1.8)
        dark = vtkLight()
        dark.SetIntensity(0.0)
        self.renderer.AddLight(dark)

    def probes(self, **fields):
        probes = boxprobe.ActorProbes(self.renderer)
        probes.add_probe("cube", **{"box": {"min": (-2, -2, -2), "max": (2, 2, 2)}, "faceSize": 64, **fields})
        for actor in self.renderer.GetActors():
            probes.add_actor(actor, actor.GetProperty().GetTexture("albedoTex") is not None)
        return probes

    def picture(self):
        self.window.Render()
        pixels = vtkWindowToImageFilter()
        pixels.SetInput(self.window)
        pixels.ReadFrontBufferOff()
        pixels.Update()
        return vtk_to_numpy(pixels.GetOutput().GetPointData().GetScalars()).astype(int)


class Calls(unittest.TestCase):
    def fails(self, kind, part, call, *arguments, **fields):
        with self.assertRaises(kind) as caught:
            call(*arguments, **fields)
        text = str(caught.exception)
        self.assertIs(type(caught.exception), kind)
        self.assertNotIn("\n", text)
        self.assertIn(part, text)

    def test_fields_come_out_as_they_went_in(self):
        probes = boxprobe.ActorProbes(vtkRenderer())
        probes.add_probe("a", origin=numpy.array([0.5, 1, 0]), technique="sphere", faceSize=numpy.int64(128))
        probes.add_probe("b", influence={"min": (-1, -1, -1), "max": (1, 1, 1)})
        self.assertEqual(probes.probes(), ["a", "b"])
        self.assertEqual(probes.probe("a")["origin"], [0.5, 1, 0])
        self.assertEqual(probes.probe("a")["faceSize"], 128)
        probes.set_probe("a", technique="box", intensity=0.5)
        self.assertEqual((probes.probe("a")["technique"], probes.probe("a")["intensity"]), ("box", 0.5))
        self.assertEqual(probes.probe("a")["faceSize"], 128)
        probes.set_probe("b", influence=None)
        self.assertNotIn("influence", probes.probe("b"))

    def test_wrong_fields_change_nothing(self):
        probes = boxprobe.ActorProbes(vtkRenderer())
        probes.add_probe("a")
        before = probes.probe("a")
        for part, fields in (
            ("probes.a.faceSize", {"faceSize": 3}),
            ("probes.a", {"facesize": 64}),
            ("technique", {"technique": "bax"}),
            ("probes.a.box", {"box": {"min": (1, 1, 1), "max": (0, 0, 0)}}),
            ("probes.a.box", {"box": 7}),
            ("only \"baked\" probes", {"mode": "realtime"}),
            ("intensity", {"intensity": float("nan")}),
            ("fields:1:", {"intensity": 10**400}),
        ):
            self.fails(ValueError, part, probes.set_probe, "a", **fields)
            self.assertEqual(probes.probe("a"), before)
        self.fails(ValueError, "probes", probes.add_probe, "a")
        self.fails(ValueError, "probes", probes.add_probe, "")
        self.fails(ValueError, "name", probes.add_probe, "\ud800")
        self.fails(ValueError, "there is no probe \"b\"", probes.set_probe, "b", intensity=1)
        self.fails(TypeError, "origin", probes.set_probe, "a", origin={1, 2, 3})
        self.fails(TypeError, "origin", probes.set_probe, "a", origin=vtkActor())
        self.fails(TypeError, "name", probes.add_probe, 7)
        endless = []
        endless.append(endless)
        self.fails(ValueError, "origin", probes.set_probe, "a", origin=endless)
        self.assertEqual(probes.probes(), ["a"])

    def test_wrong_objects(self):
        for thing in (None, 7, "renderer", vtkActor(), vtkRenderer, object()):
            self.fails(TypeError, "renderer", boxprobe.ActorProbes, thing)
        probes = boxprobe.ActorProbes(vtkRenderer())
        for thing in (None, 7, vtkRenderer(), vtkActor, vtkActor2D(), "_0000deadbeef_p_vtkActor"):
            self.fails(TypeError, "actor", probes.add_actor, thing)
            self.fails(TypeError, "actor", probes.remove_actor, thing)
        probes.remove_actor(vtkActor())  # was never added
        self.fails(TypeError, "exposure", probes.set_exposure, "bright")
        self.fails(ValueError, "exposure", probes.set_exposure, float("inf"))
        self.fails(ValueError, "exposure", probes.set_exposure, -1)
        self.fails(ValueError, "energy", probes.set_energy, "triple")
        self.fails(ValueError, "sky", probes.set_sky, colour=(1, 1, 1))
        self.fails(ValueError, "missing.hdr", probes.set_sky, image="missing.hdr")
        probes.add_probe("a")
        self.fails(TypeError, "file", probes.set_maps, "a", 7)
        self.fails(ValueError, "missing.exr", probes.set_maps, "a", "missing.exr")

    def test_without_a_window(self):
        probes = boxprobe.ActorProbes(vtkRenderer())
        probes.add_probe("a")
        self.fails(ValueError, "AddRenderer", probes.capture)

    def test_what_is_not_shaded_physically_is_captured_as_it_looks(self):
        room = Room()
        probes = room.probes()
        sphere, mapper, actor = vtkSphereSource(), vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor.SetMapper(mapper)
        room.renderer.AddActor(actor)
        probes.add_actor(actor)
        probes.capture()
        self.assertEqual(probes.error(), "")

    def test_a_probe_that_lights_nothing_warns(self):
        room = Room()
        probes = room.probes(influence={"min": (50, 50, 50), "max": (51, 51, 51)})
        with self.assertWarnsRegex(RuntimeWarning, "\"cube\" lights nothing"):
            probes.capture()

    def test_techniques_and_taking_off(self):
        room = Room()
        stock = room.picture()
        probes = room.probes()
        probes.capture()
        box = room.picture()
        self.assertGreater(abs(box - stock).max(), 50)
        probes.set_probe("cube", technique="infinite")
        infinite = room.picture()
        self.assertGreater((abs(box - infinite).max(axis=1) > 20).sum(), 100)
        probes.set_probe("cube", technique="box")
        self.assertTrue((room.picture() == box).all())
        probes.remove_all_actors()
        self.assertTrue((room.picture() == stock).all())
        self.assertEqual(probes.error(), "")

    def test_any_order_of_deletion(self):
        for first in ("probes", "window", "renderer", "finalized"):
            room = Room()
            probes = room.probes(faceSize=16)
            probes.capture()
            room.picture()
            if first == "probes":
                del probes
                gc.collect()
                room.picture()
            elif first == "window":
                room.window = None
                gc.collect()
                del probes
            elif first == "renderer":
                room.renderer = None
                gc.collect()
                room.picture()
            else:
                room.window.Finalize()
                del probes
            gc.collect()

    def test_two_on_one_renderer(self):
        room = Room()
        first = room.probes(faceSize=16)
        second = room.probes(faceSize=16)
        for probes in (first, second):
            try:
                probes.capture()
            except RuntimeError as said:
                self.assertNotIn("\n", str(said))
        room.picture()

    def test_baked_maps(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "damaged.exr")
            with open(file, "wb") as out:
                out.write(b"no picture")
            room = Room()
            probes = room.probes()
            self.fails(ValueError, "damaged.exr", probes.set_maps, "cube", file)


unittest.main(verbosity=1)
