"""What the Python package does with a plain VTK program: properties, captures, fits, errors. python_probes.py"""
import gc
import importlib.metadata
import unittest

import boxprobe
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor,
                                         vtkWindowToImageFilter)


def plane(origin, first, second, color=None):
    source, mapper, actor = vtkPlaneSource(), vtkPolyDataMapper(), vtkActor()
    source.SetOrigin(origin)
    source.SetPoint1(first)
    source.SetPoint2(second)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    if color is None:
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetMetallic(1.0)
        actor.GetProperty().SetRoughness(0.0)
    else:
        actor.GetProperty().SetLighting(False)
        actor.GetProperty().SetColor(color)
    return actor


class Room:
    """4 x 2 x 4 about the origin, a mirror as floor, a grey wall at -z."""

    def __init__(self):
        self.window, self.renderer = vtkRenderWindow(), vtkRenderer()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(160, 160)
        self.window.AddRenderer(self.renderer)
        self.floor = plane((-2, -1, 2), (2, -1, 2), (-2, -1, -2))
        self.wall = plane((-2, -1, -2), (2, -1, -2), (-2, 1, -2), (0.5, 0.5, 0.5))
        others = [plane((-2, -1, 2), (-2, -1, -2), (-2, 1, 2), (1, 0, 0)), plane((2, -1, -2), (2, -1, 2), (2, 1, -2), (0, 1, 0)),
                  plane((2, -1, 2), (-2, -1, 2), (2, 1, 2), (0, 0, 1)), plane((-2, 1, -2), (2, 1, -2), (-2, 1, 2), (1, 1, 1))]
        for actor in [self.floor, self.wall, *others]:
            self.renderer.AddActor(actor)
        dark = vtkLight()
        dark.SetIntensity(0.0)
        self.renderer.AddLight(dark)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 1.9)
        camera.SetFocalPoint(0, -0.45, 0)
        camera.SetViewAngle(60)
        camera.SetClippingRange(0.01, 20)

    def picture(self):
        """Its pixels' colours, row by row from below."""
        self.window.Render()
        pixels = vtkWindowToImageFilter()
        pixels.SetInput(self.window)
        pixels.ReadFrontBufferOff()
        pixels.Update()
        colors = pixels.GetOutput().GetPointData().GetScalars()
        return [tuple(int(v) for v in colors.GetTuple(i)) for i in range(colors.GetNumberOfTuples())]

    def mirrored(self):
        """The colour of the floor where it shows the wall."""
        return self.picture()[(159 - 112) * 160 + 80]


class Calls(unittest.TestCase):
    def near(self, found, wanted):
        for a, b in zip(found, wanted):
            self.assertAlmostEqual(a, b, delta=2, msg=f"{found} {wanted}")

    def quiet(self, thing):
        """Errors as a list in place of VTK's window for messages."""
        lines = []

        def heard(caller, event, text):
            lines.append(text)

        heard.CallDataType = "string0"
        thing.AddObserver(vtkCommand.ErrorEvent, heard)
        thing.AddObserver(vtkCommand.WarningEvent, heard)
        return lines

    def test_three_lines(self):
        room = Room()
        probes = boxprobe.attach(room.renderer)
        probes.add(bounds=(-2, 2, -1, 1, -2, 2), face_size=64)
        self.near(room.mirrored(), (128, 128, 128))
        self.assertFalse(probes.stale)
        room.wall.GetProperty().SetColor(1, 0.5, 0)
        self.assertTrue(probes.stale)
        self.near(room.mirrored(), (255, 128, 0))

    def test_values_come_out_as_they_went_in(self):
        probe = boxprobe.Probe(bounds=[0, 2, 0, 2, 0, 4], technique="sphere", blend_distance=0.5, name="hall", bounces=2)
        self.assertEqual(probe.bounds, (0, 2, 0, 2, 0, 4))
        self.assertEqual(probe.origin, (1, 1, 2))
        self.assertEqual((probe.technique, probe.blend_distance, probe.name, probe.bounces), ("sphere", 0.5, "hall", 2))
        self.assertIsNone(probe.influence_bounds)
        probe.influence_bounds = (0, 1, 0, 1, 0, 1)
        self.assertEqual(probe.influence_bounds, (0, 1, 0, 1, 0, 1))
        probe.origin = (0, 0, 0)
        self.assertFalse(probe.GetOriginAtCenter())

    def test_a_list_of_probes(self):
        probes = boxprobe.attach(vtkRenderer())
        first, second = probes.add(), probes.add(face_size=64)
        self.assertIs(probes[0], first)
        self.assertIs(probes[-1], second)
        self.assertEqual([p.face_size for p in probes], [256, 64])
        del first, second
        gc.collect()
        self.assertIsInstance(probes[1], boxprobe.Probe)
        probes.remove(probes[0])
        self.assertEqual(len(probes), 1)
        with self.assertRaises(IndexError):
            probes[1]

    def test_fit_and_place(self):
        room = Room()
        probes = boxprobe.attach(room.renderer)
        probe = probes.add(bounds=(-1, 1, -0.5, 0.5, -1, 1), face_size=64)
        probes.fit()
        for found, wanted in zip(probe.bounds, (-2, 2, -1, 1, -2, 2)):
            self.assertAlmostEqual(found, wanted, delta=0.05)
        probes.remove(probe)
        placed = probes.place()
        self.assertEqual(len(placed), 1)
        self.near(room.mirrored(), (128, 128, 128))

    def test_the_widget_by_events(self):
        room = Room()
        probes = boxprobe.attach(room.renderer)
        probe = probes.add(bounds=(-1.3, 1.1, -1.0, 0.6, -1.2, 0.4), origin=(0.2, -0.3, 0.1), face_size=64)
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(room.window)
        widget = boxprobe.vtkReflectionProbeWidget()
        widget.SetInteractor(interactor)
        widget.SetProbe(probe)
        widget.On()
        room.window.Render()
        shown = widget.GetReflectionProbeRepresentation()
        self.assertIsInstance(shown, boxprobe.vtkReflectionProbeRepresentation)
        self.assertIs(widget.GetProbe(), probe)
        seen = []
        for event in (vtkCommand.StartInteractionEvent, vtkCommand.InteractionEvent, vtkCommand.EndInteractionEvent):
            widget.AddObserver(event, lambda caller, name: seen.append(name))

        def send(event, x):  # along the line on which the face +X moves
            room.renderer.SetWorldPoint(x, -0.2, -0.4, 1)
            room.renderer.WorldToDisplay()
            at = room.renderer.GetDisplayPoint()
            interactor.SetEventInformation(round(at[0]), round(at[1]), 0, 0)
            interactor.InvokeEvent(event)

        send(vtkCommand.MouseMoveEvent, 1.1)
        self.assertEqual(shown.GetInteractionState(), shown.MovingFace)
        send(vtkCommand.LeftButtonPressEvent, 1.1)
        for x in (1.0, 0.8, 0.6):
            send(vtkCommand.MouseMoveEvent, x)
        self.assertIn("+X  0.", shown.GetReadout())
        send(vtkCommand.LeftButtonReleaseEvent, 0.6)
        self.assertEqual(seen, ["StartInteractionEvent"] + 3 * ["InteractionEvent"] + ["EndInteractionEvent"])
        self.assertAlmostEqual(probe.bounds[1], 0.6, delta=0.04)  # a pixel and a half
        self.assertEqual(probe.bounds[0], -1.3)
        self.assertEqual(probe.origin, (0.2, -0.3, 0.1))
        widget.Off()

    def test_errors(self):
        for thing in (None, 7, "renderer", vtkActor()):
            with self.assertRaises(TypeError):
                boxprobe.attach(thing)
        with self.assertRaisesRegex(TypeError, "no value face"):
            boxprobe.Probe(face=3)
        with self.assertRaisesRegex(AttributeError, "Probe has no value face_sise"):
            boxprobe.Probe().face_sise = 64
        with self.assertRaisesRegex(AttributeError, "Probes has no value autoupdate"):
            boxprobe.attach(vtkRenderer()).autoupdate = False
        with self.assertRaises(TypeError):
            boxprobe.Probe(bounds="a")
        probes = boxprobe.attach(vtkRenderer())
        lines = self.quiet(probes)
        with self.assertRaises(TypeError):
            probes.AddProbe(vtkActor())
        with self.assertRaisesRegex(RuntimeError, "AddRenderer"):
            probes.update()
        probes.add(face_size=100)
        probes.stale
        self.assertTrue(any("faceSize" in line for line in lines), lines)
        with self.assertRaises(RuntimeError):
            probes.load_maps(probes[0], "missing.exr")

    def test_events_and_orders_of_deletion(self):
        for first in ("probes", "window", "renderer"):
            room = Room()
            probes = boxprobe.attach(room.renderer)
            seen = []
            probes.AddObserver(vtkCommand.EndEvent, lambda caller, event: seen.append(event))
            probes.add(bounds=(-2, 2, -1, 1, -2, 2), face_size=16)
            room.mirrored()
            self.assertEqual(seen, ["EndEvent"])
            if first == "probes":
                del probes
                gc.collect()
                self.near(room.mirrored(), (0, 0, 0))
            elif first == "window":
                room.window = None
                gc.collect()
                del probes
            else:
                room.renderer = None
                gc.collect()
                del probes
            gc.collect()

    def test_a_view_at_rest_is_refined(self):
        room = Room()
        room.floor.GetProperty().SetRoughness(0.4)
        probes = boxprobe.attach(room.renderer)
        probes.add(bounds=(-2, 2, -1, 1, -2, 2), face_size=64, technique="box")
        own = room.picture()
        self.assertFalse(probes.RefineStep())  # off
        probes.refine_at_rest, probes.refine_rays, probes.refine_delay = True, 64, 0.25
        self.assertEqual((probes.refine_at_rest, probes.refine_rays, probes.refine_seconds, probes.refine_delay), (True, 64, 0.0, 0.25))
        ends = []
        probes.AddObserver(boxprobe.vtkReflectionProbes.EndRefineEvent, lambda caller, event: ends.append(probes.GetRefineProgress()))
        frames = 1
        while probes.RefineStep():
            frames += 1
        self.assertEqual(ends, [1.0])
        self.assertGreater(frames, 8)
        changed = sum(a != b for a, b in zip(room.picture(), own))
        self.assertGreater(changed, 1000)
        self.assertTrue(probes.GetRefining())
        room.renderer.GetActiveCamera().Azimuth(5)
        room.picture()
        self.assertFalse(probes.GetRefining())
        room.renderer.GetActiveCamera().Azimuth(-5)
        self.assertEqual(room.picture(), own)
        with self.assertRaises(AttributeError):
            probes.refine = True

    def test_version(self):
        self.assertRegex(boxprobe.__version__, r"^\d+\.\d+\.\d+$")
        self.assertEqual(importlib.metadata.version("boxprobe"), boxprobe.__version__)


unittest.main(verbosity=1)
