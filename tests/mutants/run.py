#!/usr/bin/env python3
"""Plants small faults, one at a time, and says which of them the tests of their subject notice.

README.md beside this file says how to use it. Only the standard library; run from anywhere in a clean checkout.
"""

import argparse
import fcntl
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
BUILD = os.path.join(ROOT, "build", "mutants")
STATE = os.path.join(BUILD, "planted")  # the original of what is planted, and where it belongs
SCRATCH = os.path.join(BUILD, "scratch")  # what tests write
LEAST_FREE = 2 << 30  # bytes of disk; a test that leaves less is ended

# What a developer of a folder runs: ninja targets, and programs with the filter of their tests, the quickest first.
# The first row that a path begins with counts. A program is looked for below build/mutants/tests.
UNIT = ["core_test", "io_test", "fit_test", "technique_test"]
LAMPS = ["core_test:*Values*", "lamp_shapes_test", "lamp_sight_test", "capture_sight_test", "parity_test", "shapes_picture_test",
         "glossy_lamps_test",
         "lamp_test", "capture_lamps_test", "explain_test", "baseline_test:*explain*:*shadows*:*reference*"]
LATTICE = ["core_test:*Values*", "lamp_shapes_test", "diffuse_rooms_test", "traced_lattice_test", "parity_test", "sight_picture_test",
           "offscreen_scene_test",
           "explain_test", "baseline_test:*explain*:*view*:*open*"]
SHADOWS = ["core_test:*Values*", "cube_picture_test", "lamp_sight_test", "parity_test", "sun_shadow_test", "shadow_test",
           "sight_picture_test", "baseline_test",
           "explain_test"]
MIRRORS = ["core_test", "explanation_text_test:*Values*", "parity_test", "mirror_test", "planar_mirror_test", "baseline_test",
           "explain_test", "splice_test"]
GLASS = ["explanation_text_test:*Values*", "refraction_test", "projection_rays_test", "parity_test", "glass_test", "explain_test",
         "baseline_test"]
REFINED = ["path_test", "whole_picture_test", "frame_average_test", "refinement_test", "still_view_test", "vtk_program_test", "rest_test",
           "baseline_test"]
DRAWN = ["baseline_test", "edited_test", "still_view_test", "capture_test", "draw_ways_test", "planar_mirror_test", "blending_test",
         "folded_test", "skipped_test", "explain_test", "glass_test", "shadow_test", "windows_test", "offscreen_scene_test"]
SUBJECTS = [
    ("shaders/technique/projection_impostor", ["explanation_text_test:*Values*", "technique_test", "true_hit_test", "baseline_test",
                                               "parity_test", "impostor_test", "explain_test"]),
    ("shaders/technique/", ["explanation_text_test:*Values*", "technique_test", "relief_test", "mirror_test", "baseline_test",
                            "parity_test", "footprint_picture_test",
                            "explain_test"]),
    ("shaders/shared/light_sampling", ["technique_test", "splice_test", "baseline_test"]),
    ("shaders/shared/lamp", LAMPS),
    ("shaders/shared/light_", LAMPS),
    ("shaders/shared/lattice", LATTICE),
    ("shaders/shared/sh.", LATTICE),
    ("shaders/shared/s", ["explanation_text_test:*Values*", "technique_test", "cube_picture_test", "lamp_sight_test", "brdf_table_test",
                          "reference_test", "sun_shadow_test",
                          "sight_picture_test", "baseline_test", "parity_test", "edited_test:OddRoom*", "shadow_test", "gltf_picture_test",
                          "explain_test"]),
    ("shaders/shared/mirror", MIRRORS),
    ("shaders/shared/planar", MIRRORS),
    ("shaders/shared/glass", GLASS),
    ("shaders/shared/refraction", GLASS),
    ("shaders/shared/", ["explanation_text_test:*Values*", "technique_test", "cube_picture_test", "relief_test", "refraction_test",
                         "brdf_table_test", "reference_test",
                         "true_hit_test", "baseline_test", "parity_test", "edited_test:OddRoom*", "stress_test", "glass_test",
                         "gltf_picture_test", "explain_test", "shadow_test", "planar_mirror_test", "impostor_test"]),
    ("shaders/published/", ["published_test", "baseline_test", "technique_test", "stress_test"]),
    ("shaders/stress/", ["stress_test", "stress_gpu_test"]),
    ("shaders/gpu/lamp", LAMPS),
    ("shaders/gpu/light_", LAMPS + ["sun_shadow_test"]),
    ("shaders/gpu/fetch_light", ["technique_test", "splice_test", *LAMPS, "sun_shadow_test"]),
    ("shaders/gpu/fetch_lattice", LATTICE),
    ("shaders/gpu/sight", SHADOWS),
    ("shaders/gpu/sky_open", SHADOWS),
    ("shaders/gpu/sun_", SHADOWS),
    ("shaders/gpu/moving_", SHADOWS),
    ("shaders/gpu/ground_", SHADOWS),
    ("shaders/gpu/mirror", MIRRORS),
    ("shaders/gpu/glass", GLASS),
    ("shaders/gpu/behind", GLASS),
    ("shaders/gpu/reflection_", ["frame_average_test", "refinement_test", "still_view_test", "vtk_program_test", "baseline_test"]),
    ("shaders/gpu/", ["baseline_test", "orientation_test", "edited_test", "splice_test", "stock_test", "explain_test", "gltf_picture_test",
                      "true_hit_test", "planar_mirror_test", "prefilter_test", "frame_average_test", "bake_test", "ray_layer_test"]),
    ("filters/math/published/", ["published_test", "baseline_test", "technique_test", "stress_test"]),
    ("filters/math/cube/diffuse_lattice", LATTICE),
    ("filters/math/cube/lamp_free", LAMPS),
    ("filters/math/cube/openings", ["lamp_shapes_test", "capture_sight_test", "diffuse_rooms_test", "sight_picture_test", "baseline_test"]),
    ("filters/math/shared/lamp", LAMPS),
    ("filters/math/shared/finish", ["explanation_text_test:*Values*", "reference_test", "gltf_picture_test", "baseline_test"]),
    ("filters/math/technique/", ["explanation_text_test:*Values*", "technique_test", "bench_test",
                                 "baseline_test:*auto*:*explain*:*level*:*curve*", "bench_cli_test",
                                 "skipped_test", "prefilter_test"]),
    ("filters/math/", ["explanation_text_test:*Values*", "technique_test", "cube_picture_test", "brdf_table_test", "prefilter_unit_test",
                       "refraction_test", "relief_test",
                       "diffuse_rooms_test", "sight_picture_test", "baseline_test", "parity_test", "stress_test", "explain_test"]),
    ("filters/core/geometry/lamp", LAMPS),
    ("filters/core/geometry/light", LAMPS + ["sun_shadow_test", "shadow_test"]),
    ("filters/core/geometry/scene_lamps", LAMPS),
    ("filters/core/geometry/sight", LAMPS + ["sight_picture_test"]),
    ("filters/core/geometry/ground", SHADOWS),
    ("filters/core/geometry/sky", SHADOWS),
    ("filters/core/geometry/traced", LATTICE),
    ("filters/core/geometry/probe_diffuse", ["explanation_text_test", *LATTICE]),
    ("filters/core/geometry/mirror", MIRRORS),
    ("filters/core/base/", ["core_test", "platform_test", "io_test", "files_test", "baseline_test:*info*:*fit*:*bake*:*export*",
                            "cli_test:Info*:Render*:Messages*"]),
    ("filters/core/picture/", ["core_test:*Values*", "bench_test", "cube_file_test", "cube_picture_test", "bake_test",
                               "baseline_test:*info*:*fit*:*bake*:*export*",
                               "cli_test:Bake*", "offscreen_scene_test"]),
    ("filters/core/surface/", ["core_test:*Values*", "explanation_text_test", "reference_test", "path_test", "explain_test",
                               "reference_picture_test",
                               "baseline_test:*reference*:*explain*"]),
    ("filters/core/", ["core_test", "io_test", "cube_picture_test", "lamp_sight_test", "traced_lattice_test", "capture_sight_test",
                       "probe_plan_test", "editor_test", "baseline_test", "edited_test", "explain_test", "cli_test:Info*:Render*:Export*"]),
    ("filters/io/engines/glb_", ["glb_probes_test", "engine_test", "baseline_test:*export*:*info*", "cli_test:Export*"]),
    ("filters/io/engines/", ["engine_test", "glb_probes_test", "rgbm_test", "baseline_test:*export*:*info*", "cli_test:Export*:Import*"]),
    ("filters/io/cube/sky", ["cube_file_test", "environment_test", "cube_picture_test", "io_test", "sun_shadow_test",
                             "environment_drawn_test",
                             "baseline_test:*sky*:*open*:*custom*:*bake*:*export*", "offscreen_scene_test"]),
    ("filters/io/cube/", ["cube_file_test", "environment_test", "files_test", "bake_test",
                          "baseline_test:*sky*:*open*:*custom*:*bake*:*export*",
                          "cli_test:Bake*:Export*", "environment_drawn_test", "exrenvmap_test"]),
    ("filters/io/image/", ["io_test", "environment_test", "files_test", "cube_file_test",
                           "baseline_test:*info*:*bake*:*export*:*sky*:*reference*", "gltf_picture_test", "environment_drawn_test",
                           "cli_test:Bad*"]),
    ("filters/io/gltf/glb_", ["glb_probes_test", "io_test", "files_test", "cli_test:Bad*:Export*"]),
    ("filters/io/scene/lesson", ["lesson_file_test", "cli_test:Lessons*", "lesson_test"]),
    ("filters/io/scene/pareto", ["io_test:ParetoFile*", "bench_test", "frame_report_test", "bench_cli_test", "baseline_test"]),
    ("filters/io/scene/", ["io_test", "files_test", "core_test", "baseline_test:*info*:*fit*:*place*:*reference*",
                           "cli_test:Bad*:Info*:Fit*"]),
    ("filters/io/", ["model_reader_test:*Values*", "io_test", "files_test", "model_reader_test", "cube_file_test", "lesson_file_test",
                     "baseline_test:*info*:*fit*:*place*:*reference*", "cli_test:Bad*", "gltf_picture_test"]),
    ("filters/fit/", ["fit_test:*Values*", "fit_test", "offscreen_scene_test", "baseline_test:*fit*:*place*:*info*",
                      "cli_test:Fit*:Place*", "vtk_program_test",
                      "gui_test:FitPanel*:PlacePanel*:ProbeGauge*"]),
    ("filters/explain/", ["explanation_text_test", "explanation_json_test", "schematic_test", "painted_test",
                          "baseline_test:*explain*:*view*",
                          "explain_test", "edited_test:OddRoom*", "cli_test:Explain*", "gui_test:ExplainCard*:Schematic*"]),
    ("filters/reference/path/", ["path_test", "reference_test", "reference_picture_test", "lamp_test",
                                 "baseline_test:*reference*:*fit*:*place*",
                                 "reference_cli_test", "truth_test"]),
    ("filters/reference/study/", ["bench_test", "technique_test", "published_test", "bench_cli_test"]),
    ("filters/reference/truth/", ["truth_test", "bench_cli_test:TruthBench*", "impostor_truth_test"]),
    ("filters/reference/", ["reference_test", "path_test", "whole_picture_test", "bench_test", "reference_picture_test",
                            "baseline_test:*reference*:*fit*:*place*", "lamp_test", "glass_test", "reference_cli_test", "bench_cli_test"]),
    ("filters/stress_gpu/", ["stress_gpu_test", "cli_test:Stress*"]),
    ("filters/stress/", ["stress_test", "cli_test:Stress*"]),
    ("filters/vtk/import/", ["model_reader_test", "baseline_test", "cli_test:BadModel*"]),
    ("filters/vtk/inspect/", ["vtk_values_test", "frame_report_test", "baseline_test",
                              "gui_test:FramePanel*:Preview*:DebugView*:SelectHere*",
                              "cli_test:Info*:Report*", "explain_test", "offscreen_scene_test"]),
    ("filters/vtk/charts/", ["vtk_values_test", "frame_report_test:FrontChart*", "gui_test:CostPanel*"]),
    ("filters/vtk/actors/", ["vtk_values_test", "actor_probes_test", "vtk_program_test", "probe_widget_test"]),
    ("filters/vtk/placement/", ["vtk_values_test", "vtk_program_test"]),
    ("filters/vtk/widgets/", ["vtk_values_test", "gui_geometry_test", "probe_widget_test", "gui_test:Drag*:Handle*"]),
    ("filters/vtk/surface/glass", GLASS),
    ("filters/vtk/surface/vtkGround", SHADOWS),
    ("filters/vtk/surface/finish", ["gltf_picture_test", "vtk_text_test", "baseline_test", "splice_test", "edited_test", "glass_test"]),
    ("filters/vtk/surface/material_source", ["gltf_picture_test", "vtk_text_test", "baseline_test", "splice_test", "edited_test",
                                             "glass_test"]),
    ("filters/vtk/surface/", ["vtk_text_test", "vtk_text_compile_test", "baseline_test", "splice_test", "orientation_test", "edited_test",
                              "draw_ways_test", "glass_test", "explain_test", "offscreen_scene_test"]),
    ("filters/vtk/draw/lamp", LAMPS),
    ("filters/vtk/draw/light", LAMPS + ["sun_shadow_test"]),
    ("filters/vtk/draw/listed", LAMPS + ["sun_shadow_test"]),
    ("filters/vtk/draw/probe_la", LATTICE + LAMPS),
    ("filters/vtk/draw/mirror", MIRRORS),
    ("filters/vtk/draw/glass", GLASS),
    ("filters/vtk/draw/refined", REFINED),
    ("filters/vtk/frame/mirror", MIRRORS),
    ("filters/vtk/frame/sun", SHADOWS),
    ("filters/vtk/frame/shadow", SHADOWS),
    ("filters/vtk/frame/moving", SHADOWS),
    ("filters/vtk/frame/behind", GLASS),
    ("filters/vtk/frame/", REFINED + ["shadow_test", "glass_test", "frame_report_test", "offscreen_scene_test"]),
    ("filters/vtk/gl/occlusion", ["still_view_test", "many_probes_test", "baseline_test"]),
    ("filters/vtk/gl/", ["pass_scope_test", "baseline_test", "stock_test", "prefilter_test", "capture_test", "gl_trouble_test",
                         "surfaceless_test", "windows_test", "cli_test:Info*:Render*"]),
    ("filters/vtk/maps/lamp", LAMPS),
    ("filters/vtk/maps/lattice", LATTICE),
    ("filters/vtk/maps/sight", LAMPS + SHADOWS),
    ("filters/vtk/maps/openness", ["sight_picture_test:SkyOcclusion*", *SHADOWS]),
    ("filters/vtk/maps/", ["probe_plan_test", "capture_test", "baseline_test", "edited_test", "bake_test", "prefilter_test", "splice_test",
                           "many_probes_test", "sight_picture_test", "offscreen_scene_test"]),
    ("filters/vtk/rays/", ["vtk_values_test:RayColors*", "projection_rays_test", "ray_layer_test", "explain_test", "gui_test:DebugView*"]),
    ("filters/vtk/probes/driver", ["capture_test", "folded_test", "splice_test"]),
    ("filters/vtk/probes/sight", LAMPS + SHADOWS),
    ("filters/vtk/probes/mirror_texels", ["skipped_test", "rest_test", "planar_mirror_test"]),
    ("filters/vtk/probes/stand_in", ["offscreen_scene_test", *DRAWN]),
    ("filters/vtk/probes/", ["probe_plan_test", "skipped_test", "capture_test", "baseline_test", "edited_test", "bake_test",
                             "many_probes_test", "vtk_program_test", "offscreen_scene_test"]),
    ("filters/vtk/scene/model_actors", ["vtk_values_test:DrawnObjects*", "gltf_picture_test", *DRAWN]),
    ("filters/vtk/scene/vtkCulled", ["still_view_test", "many_probes_test", *DRAWN]),
    ("filters/vtk/scene/visible_search", ["still_view_test", "many_probes_test", *DRAWN]),
    ("filters/vtk/draw/probe_binding", ["vtk_values_test:ProbeBindings*", *DRAWN]),
    ("filters/vtk/draw/fewer", ["gl_trouble_test:*GivesUp*:*Textures*:*Fewer*", *DRAWN]),
    ("filters/vtk/capture/", ["baseline_test", "prefilter_test", "bake_test", "capture_test", "edited_test"]),
    ("filters/vtk/", DRAWN),
    ("app/cli/report/view_", ["session_picture_test:*Sheet*", "cli_test:View*", "baseline_test"]),
    ("app/cli/report/contact", ["app_values_test:ContactSheet*", "bench_cli_test"]),
    ("app/cli/report/report_text", ["app_values_test", "baseline_test", "cli_test:Info*"]),
    ("app/cli/report/frame_", ["app_values_test:ReportValues*", "session_picture_test:*Costs*", "baseline_test", "cli_test:Info*:Report*"]),
    ("app/cli/command/extreme_", ["app_values_test:CommandValues*", "cli_test:Stress*", "faults_test"]),
    ("app/cli/command/report_", ["app_values_test:CommandValues*", "cli_test:Report*"]),
    ("app/session/picture_check", ["session_picture_test:*Placing*", "offscreen_scene_test:*Eyes*:PictureCheck*", "cli_test:Place*"]),
    ("app/session/scene_review", ["app_values_test:Reviews*", "session_picture_test:*Review*", "cli_test:Report*"]),
    ("app/session/reference_box", ["session_picture_test:*Integral*", "reference_cli_test", "lessons_test"]),
    ("app/session/truth_stage", ["bench_cli_test:TruthBench*", "truth_test"]),
    ("app/cli/farm/", ["app_values_test", "baseline_test", "bake_farm_test", "cli_test:Bake*"]),
    ("app/cli/options/bench_", ["app_values_test", "bench_cli_test"]),
    ("app/cli/options/", ["app_values_test", "baseline_test", "cli_test:Help*:BadInput*:Messages*:Render*"]),
    ("app/cli/command/bake_", ["app_values_test", "baseline_test", "cli_test:Bake*", "bake_farm_test"]),
    ("app/cli/command/explain_", ["app_values_test", "baseline_test", "cli_test:Explain*"]),
    ("app/cli/command/export_", ["app_values_test", "baseline_test", "cli_test:Export*"]),
    ("app/cli/command/fit_", ["app_values_test", "baseline_test", "cli_test:Fit*"]),
    ("app/cli/report/fit_", ["app_values_test", "baseline_test", "cli_test:Fit*"]),
    ("app/cli/command/info_", ["app_values_test", "baseline_test", "cli_test:Info*"]),
    ("app/cli/report/scene_", ["app_values_test", "baseline_test", "cli_test:Info*"]),
    ("app/cli/command/place_", ["app_values_test", "baseline_test", "cli_test:Place*"]),
    ("app/cli/report/place_", ["app_values_test", "baseline_test", "cli_test:Place*"]),
    ("app/cli/command/stress_", ["app_values_test", "cli_test:Stress*"]),
    ("app/cli/command/bench_", ["app_values_test", "bench_cli_test"]),
    ("app/cli/command/truth_bench", ["app_values_test", "bench_cli_test:TruthBench*"]),
    ("app/cli/command/whole_bench", ["app_values_test", "bench_cli_test:Bench.Whole*"]),
    ("app/cli/command/reference_", ["app_values_test", "reference_cli_test"]),
    ("app/cli/report/stress_", ["app_values_test", "cli_test:Stress*"]),
    ("app/cli/", ["app_values_test", "baseline_test", "cli_test", "faults_test", "bake_farm_test"]),
    ("app/session/", ["app_values_test", "baseline_test", "offscreen_scene_test", "cli_test", "faults_test", "gl_trouble_test",
                      "surfaceless_test",
                      "glb_probes_test", "gui_test:File*:Exposure*:Fit*:Place*"]),
    ("app/gui/handles/", ["gui_geometry_test", "session_values_test:*Handles*", "gui_test:Drag*:Handle*:Probe*:Several*"]),
    ("app/gui/explain/", ["schematic_test", "painted_test", "gui_test:Schematic*:Explain*:DebugView*:Inspectors*"]),
    ("app/gui/edit/", ["editor_test", "view_values_test:*BackgroundWork*", "panel_values_test", "session_values_test", "rest_test",
                       "gui_test:Several*:ValueField*:Probe*:Exposure*:BackgroundWork*:Outliner*"]),
    ("app/gui/formula/", ["formula_test", "painted_test"]),
    ("app/gui/view/rest", ["view_values_test", "rest_test"]),
    ("app/gui/view/viewport", ["session_values_test", "lost_context_test", "gui_test:Camera*:Drag*:Handle*"]),
    ("app/gui/view/", ["view_values_test", "painted_test", "session_values_test", "menu_values_test", "panel_values_test", "rest_test",
                       "gui_test:Camera*:Animation*:Exposure*:*Compar*:*Preview*:Gestures*:SelectHere*:Import*:Picture*:TracedLight*:"
                       "DebugView*:View*:Sky*"]),
    ("app/gui/widgets/", ["painted_test", "panel_values_test", "gui_geometry_test",
                          "gui_test:ValueField*:Panel*:Probe*:Window*:Welcome*:Accessible*:Outliner*:File*:Inspectors*", "language_test"]),
    ("app/gui/lessons/", ["painted_test", "lesson_test:LessonPhotographs*", "lesson_test", "gui_test:LessonList*", "cli_test:Lessons*",
                          "lesson_walk_test"]),
    ("app/gui/window/lessons_command", ["cli_test:Lessons*"]),
    ("app/gui/window/window_signals", ["cli_test:Interrupt*", "gui_test:Recovery*:LeftBehind*"]),
    ("app/gui/window/live_link", ["live_link_test"]),
    ("app/gui/window/language", ["language_test"]),
    ("app/gui/panels/outliner", ["editor_test", "painted_test", "gui_test:Outliner*:Panel*:Several*"]),
    ("app/gui/panels/", ["painted_test", "panel_values_test",
                         "gui_test:*Panel*:Several*:Probe*:Light*:Material*:Object*:Picture*:Technique*:Cheap*"]),
    ("app/gui/window/", ["menu_values_test", "session_values_test", "panel_values_test",
                         "gui_test:File*:Recovery*:LeftBehind*:Window*:Picture*:Camera*:Import*:Inspectors*:Welcome*:Exposure*:Fit*:Place*:"
                         "Probe*:Empty*:Own*",
                         "live_link_test", "language_test"]),
    ("app/gui/", ["gui_geometry_test", "schematic_test", "gui_test"]),
    ("app/lessons/page_", ["painted_test:LessonPage*", "lesson_file_test", "app_values_test", "page_policy_test", "cli_test:Lessons*"]),
    ("app/lessons/", ["lesson_file_test", "app_values_test", "page_policy_test", "lessons_test:LessonValues*:PlayedLesson*",
                      "cli_test:Lessons*", "lessons_test"]),
    ("app/", ["baseline_test", "cli_test"]),
]
FOLDERS = ["shaders", "filters/math", "filters/core", "filters/fit", "filters/io", "filters/explain",
           "filters/reference", "filters/vtk", "app"]

CONFIGURE = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DBOXPROBE_UNITY_FILES=3",
             "-DBOXPROBE_ONLY_TESTS=house;unit;vtk;parity;image;cli;baseline;gui;stress;truth"]


# ------------------------------------------------------------------------------------------------ what is changed


def swap(pattern, replacement):
    return re.compile(pattern), replacement


# Each kind: its name, where it applies in a line of code, and what it makes of the match.
KINDS = [
    ("sign", *swap(r"(?<=[\w\)\]] )\+(?= [\w\(])", "-")),
    ("sign", *swap(r"(?<=[\w\)\]] )-(?= [\w\(])", "+")),
    ("factor", *swap(r"(?<=[\w\)\]] )\*(?= [\w\(])", "/")),
    ("extreme", *swap(r"\bmin\(", "max(")),
    ("extreme", *swap(r"\bmax\(", "min(")),
    ("comparison", *swap(r"(?<= )<(?= [\w\(-])", "<=")),
    ("comparison", *swap(r"(?<= )>(?= [\w\(-])", ">=")),
    ("comparison", *swap(r"(?<= )<=(?= )", "<")),
    ("comparison", *swap(r"(?<= )>=(?= )", ">")),
    ("comparison", *swap(r"(?<= )==(?= )", "!=")),
    ("comparison", *swap(r"(?<= )!=(?= )", "==")),
    ("logic", *swap(r"(?<= )&&(?= )", "||")),
    ("logic", *swap(r"(?<= )\|\|(?= )", "&&")),
    ("logic", *swap(r"(?<=[\(= ])!(?=[a-z_]\w*)", "")),
    ("component", *swap(r"(?<=[\w\)\]])\.x\b", ".y")),
    ("component", *swap(r"(?<=[\w\)\]])\.y\b", ".z")),
    ("component", *swap(r"(?<=[\w\)\]])\.z\b", ".x")),
    ("index", *swap(r"\[0\]", "[1]")),
    ("index", *swap(r"\[1\]", "[0]")),
    ("end", *swap(r"\b(\w*)Min\b(?=\.)", r"\1Max")),
    ("end", *swap(r"\b(\w+)\.min\b(?!\()", r"\1.max")),
    ("end", *swap(r"\b(\w+)\.max\b(?!\()", r"\1.min")),
    ("constant", re.compile(r"(?<![\w.\"'-])(\d+\.\d+)(f?)(?![\w.])"),
     lambda m: repr(float(m.group(1)) * 1.1 if float(m.group(1)) else 0.1) + m.group(2)),
    ("constant", re.compile(r"(?<![\w.\[\"'<-])([2-9]|[1-9]\d{1,3})(?![\w.\]\"'>])"), lambda m: str(int(m.group(1)) + 1)),
    ("flag", *swap(r"\btrue\b", "false")),
    ("flag", *swap(r"\bfalse\b", "true")),
    ("term dropped", *swap(r" [+-] [\w.\[\]]+(?=[;,\)])", "")),
    ("factor dropped", *swap(r" \* [\w.\[\]]+(?=[;,\) ])", "")),
    ("arguments swapped", *swap(r"(?<!\bmin)(?<!\bmax)(?<!\bdot)(?<!\bhypot)(?<!distance)\((\w[\w.\[\]]*), (\w[\w.\[\]]*)\)", r"(\2, \1)")),
    ("assignment dropped", re.compile(r"^(\s+)[a-z][\w.\[\]>-]* [*+|-]?= [^;{]+;$"), r"\1;"),
    ("guard dropped", re.compile(r"^(\s+)if \(.*\) (?:return\b[^;{]*|continue|break);$"), r"\1;"),
    ("call dropped", re.compile(r"^(\s+)[a-z][\w.>-]*\([^{]*\);$"), r"\1;"),
]

SKIPPED = re.compile(r"^\s*(//|/\*|\*|#|namespace|using|template|static_assert|class |struct |enum |case .*:$|public:|private:|"
                     r"protected:|Q_OBJECT|vtk\w*Macro|EXPECT|ASSERT|assert|throw|\"|return \"|friend|typedef|extern|layout|"
                     r"uniform |in |out |\}|\{)")
# Words for people: messages, help, tool tips. A test of every word would be a second copy of it. And memory taken beforehand.
WORDS = re.compile(r"(\.reserve\(|tr\(|Error\(|InputError|WorkError|FieldError|->setToolTip|setText|printf|printError|printWarnings|"
                   r"printResult|->footer|add_option|add_flag|add_subcommand|field<&|emplace_back\(\"|os <<|indent)")


def strings_blanked(line):
    """The line with what stands in quotes, and comments behind it, replaced by spaces of the same length."""
    line = re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: " " * len(m.group()), line)
    line = re.sub(r"'(?:[^'\\]|\\.)*'", lambda m: " " * len(m.group()), line)
    return re.sub(r"//.*", lambda m: " " * len(m.group()), line)


def source_files(prefix):
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", prefix], capture_output=True, text=True, check=True).stdout
    return [f for f in listed.split() if f.endswith((".cpp", ".h", ".glsl"))
            and not f.startswith(("app/web", "app/site", "app/install", "shaders/web"))]


def mutants_of(path):
    """(line number, kind, old text, new text) of every change there could be in a file."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as stream:
        lines = stream.read().split("\n")
    found = []
    for number, line in enumerate(lines):
        blank = strings_blanked(line)
        # A line that goes on from the one before, or into the next, may be half of a declaration.
        if SKIPPED.match(line) or WORDS.search(line) or not blank.strip() or "operator" in line:
            continue
        if "constexpr" in line and "=" not in line:
            continue
        for kind, pattern, replacement in KINDS:
            for match in pattern.finditer(blank):
                made = match.expand(replacement) if isinstance(replacement, str) else replacement(match)
                new = line[:match.start()] + made + line[match.end():]
                if new != line:
                    found.append((number, kind, line, new))
    return found


def drawn(prefix, count, chance):
    """`count` mutants below a folder: a file by its length in changes, then a change of a kind that is drawn first, so that
    frequent kinds do not crowd out the others."""
    pool = {f: mutants_of(f) for f in source_files(prefix)}
    files = [f for f, changes in pool.items() if changes]
    picked = []
    while files and len(picked) < count:
        path = chance.choices(files, [len(pool[f]) for f in files])[0]
        kind = chance.choice(sorted({c[1] for c in pool[path]}))
        change = chance.choice([c for c in pool[path] if c[1] == kind])
        pool[path].remove(change)  # each at most once
        if not pool[path]:
            files.remove(path)
        picked.append((path, *change))
    return picked


# --------------------------------------------------------------------------------------------- planting and putting back


class Planted:
    """One change in a file. The original is kept aside first, so that whatever ends this program, the next start puts it
    back."""

    def __init__(self, path, old, new, line=None):
        self.path, self.whole = path, os.path.join(ROOT, path)
        with open(self.whole, encoding="utf-8") as stream:
            text = stream.read()
        if line is None:
            if text.count(old) != 1:
                raise ValueError(f"{path}: {text.count(old)} times {old!r}")
            changed = text.replace(old, new)
        else:
            lines = text.split("\n")
            assert lines[line] == old
            lines[line] = new
            changed = "\n".join(lines)
        # All that needs room on the disk comes first; from there on names change, which needs none.
        os.makedirs(STATE, exist_ok=True)
        shutil.copy2(self.whole, os.path.join(STATE, "original"))
        for name, content in (("path.new", path), ("changed", changed)):
            with open(os.path.join(STATE, name), "w", encoding="utf-8") as stream:
                stream.write(content)
        shutil.copymode(self.whole, os.path.join(STATE, "changed"))
        os.replace(os.path.join(STATE, "path.new"), os.path.join(STATE, "path"))
        os.replace(os.path.join(STATE, "changed"), self.whole)


def put_back():
    """Puts a planted file back, if there is one."""
    note = os.path.join(STATE, "path")
    if not os.path.exists(note):
        return None
    with open(note, encoding="utf-8") as stream:
        path = stream.read()
    original = os.path.join(STATE, "original")
    if os.path.exists(original):  # else an earlier call was ended between the next two lines
        os.utime(original)  # newer than what was built from the fault
        os.replace(original, os.path.join(ROOT, path))
    os.remove(note)
    return path


# ------------------------------------------------------------------------------------------------------ building, running


def limits():
    gigabyte = 1 << 30
    resource.setrlimit(resource.RLIMIT_FSIZE, (gigabyte, gigabyte))
    resource.setrlimit(resource.RLIMIT_AS, (16 * gigabyte, 16 * gigabyte))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, seconds, variables=None):
    """(what happened, seconds): "ok", "failed", "hung", "crashed", "filled the disk"; the whole group of processes ends with it."""
    start = time.time()
    shutil.rmtree(SCRATCH, ignore_errors=True)  # what an ended test left
    os.makedirs(SCRATCH)
    environment = dict(os.environ, GALLIVM_PERF="nopt", LP_NATIVE_VECTOR_WIDTH="128", GTEST_FAIL_FAST="1", TMPDIR=SCRATCH,
                       CCACHE_SLOPPINESS="pch_defines,time_macros")
    environment.update(variables or {})
    status = "hung"
    with open(os.path.join(BUILD, "last-output.txt"), "w", encoding="utf-8") as output:
        process = subprocess.Popen(command, cwd=ROOT, stdout=output, stderr=subprocess.STDOUT, env=environment,
                                   start_new_session=True, preexec_fn=limits)
        try:
            while time.time() - start < seconds:
                try:
                    status = process.wait(1.0)
                    break
                except subprocess.TimeoutExpired:
                    if shutil.disk_usage(SCRATCH).free < LEAST_FREE:
                        status = "filled the disk"
                        break
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()
    if not isinstance(status, str):
        status = "ok" if status == 0 else "crashed" if status < 0 or status > 128 else "failed"
    return status, time.time() - start


def build(targets, seconds=1800):
    what, _ = run(["ninja", "-C", BUILD, *targets], seconds)
    return what == "ok"


def shader_refused():
    """Whether the driver's compiler refused a shader in the last run: that is a fault which does not compile."""
    with open(os.path.join(BUILD, "last-output.txt"), encoding="utf-8", errors="replace") as stream:
        return any(re.search(r"\b\d+:\d+\(\d+\): error: ", line) for line in stream)


def configure():
    os.makedirs(BUILD, exist_ok=True)
    options = list(CONFIGURE)
    if shutil.which("ccache"):
        options += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache",
                    "-DCMAKE_CXX_FLAGS=-fpch-preprocess"]  # else it keeps nothing that reads precompiled headers
    if shutil.which("mold"):
        options += [f"-DCMAKE_{kind}_LINKER_FLAGS=-fuse-ld=mold" for kind in ("EXE", "SHARED", "MODULE")]
    if not os.path.exists(os.path.join(BUILD, "build.ninja")):
        subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", *options], check=True,
                       stdout=subprocess.DEVNULL)


def program(name):
    for folder, _, files in os.walk(os.path.join(BUILD, "tests")):
        if name in files and os.access(os.path.join(folder, name), os.X_OK):
            return os.path.join(folder, name)
    return None


def command_of(test):
    path = program(test.partition(":")[0])
    # As CTest runs it: with a display of its own, whether it needs one or not.
    return path and ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24 -noreset", path]


def quick_variables():
    """What CTest sets for each program: among it the cases that the quick suite leaves out."""
    listed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], capture_output=True, text=True, check=True).stdout
    found = {}
    for test in json.loads(listed)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        found[test["name"]] = dict(v.split("=", 1) for v in properties.get("ENVIRONMENT", []))
    return found


def variables_of(test, quick):
    """Those of CTest, the filter narrowed to the cases that a row of the table names."""
    name, _, chosen = test.partition(":")
    variables = dict(quick.get(name, {}))
    if chosen:
        left_out = variables.get("GTEST_FILTER", "").removeprefix("-")
        variables["GTEST_FILTER"] = f"{chosen}-{left_out}" if left_out else chosen
    return variables


def tests_of(path):
    for prefix, tests in SUBJECTS:
        if path.startswith(prefix):
            return tests
    return UNIT


class Tests:
    """The tests of subjects, in the order of the table; none gets longer than ten times what it takes by itself."""

    def __init__(self):
        self.seconds = {}  # of those that pass without any fault planted; None: not built, or it fails by itself
        self.built = set()
        self.quick = quick_variables()

    def prepare(self, tests):
        """Builds what is not yet known to compile, without any fault planted."""
        unknown = sorted({t.partition(":")[0] for t in tests} - self.built)
        if unknown and not build(unknown, 4 * 3600):  # everything, perhaps on a busy machine
            sys.exit(f"{', '.join(unknown)}: not built without any fault planted; see {BUILD}/last-output.txt")
        self.built.update(unknown)
        for test in tests:
            if test not in self.seconds and command_of(test) is None:
                self.seconds[test] = None
                print(f"  {test}: is not built; left out", flush=True)

    def passes_by_itself(self, test):
        """Without any fault planted: whoever calls has put it back."""
        if not build([test.partition(":")[0]]):
            sys.exit(f"{test}: not built without any fault planted; see {BUILD}/last-output.txt")
        what, seconds = run(command_of(test), 1800, variables_of(test, self.quick))
        self.seconds[test] = seconds if what == "ok" else None
        if what != "ok":
            print(f"  {test}: {what} without any fault planted; left out", flush=True)
        return what == "ok"

    def notice(self, tests, plant):
        """(who noticed and how, or None; seconds). A test that passes with the fault would pass without it; one that fails for the
        first time is run again without."""
        start = time.time()
        plant()
        for test in tests:
            known = self.seconds.get(test)
            if test in self.seconds and known is None:
                continue
            if not build([test.partition(":")[0]]):
                return "does not compile", time.time() - start
            what, seconds = run(command_of(test), max(60.0, 10.0 * known) if known is not None else 900.0, variables_of(test, self.quick))
            if what == "ok":
                self.seconds.setdefault(test, seconds)
                continue
            if what == "failed" and shader_refused():
                return "does not compile", time.time() - start
            if known is None:
                put_back()
                own = self.passes_by_itself(test)
                if not own:
                    plant()
                    continue
            return f"{test} {what}", time.time() - start
        return None, time.time() - start


# ------------------------------------------------------------------------------------------------------------------ main


def invisible():
    """Changes that nobody can see, with the reason: lines of invisible.txt."""
    known = {}
    try:
        with open(os.path.join(HERE, "invisible.txt"), encoding="utf-8") as stream:
            for line in stream:
                if line.strip() and not line.startswith("#"):
                    entry = json.loads(line)
                    known[(entry["file"], entry["old"].strip(), entry["new"].strip())] = entry["why"]
    except FileNotFoundError:
        pass
    return known


def judged_before(seed, commit):
    """Verdicts of an interrupted run of this seed on this commit, by file, line, old and new text."""
    verdicts = {}
    try:
        with open(os.path.join(BUILD, "log.jsonl"), encoding="utf-8") as stream:
            for line in stream:
                entry = json.loads(line)
                if entry.get("seed") == seed and entry.get("commit") == commit:
                    verdicts[entry["file"], entry["line"], entry["old"], entry["new"]] = entry["verdict"]
    except FileNotFoundError:
        pass
    return verdicts


def campaign(arguments, tests, log):
    chance = random.Random(arguments.seed)
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "HEAD"], capture_output=True, text=True, check=True).stdout.strip()
    before = judged_before(arguments.seed, commit)
    prefixes = arguments.only or FOLDERS
    share = -(-arguments.count // len(prefixes))
    known = invisible()
    order = []
    for prefix in prefixes:
        order.append(drawn(prefix, 4 * share, chance))
    counts = {p: {"noticed": 0, "survived": 0, "invisible": 0, "does not compile": 0, "header": 0} for p in prefixes}
    done = 0
    for turn in range(4 * share):
        for prefix, changes in zip(prefixes, order):
            if turn >= len(changes) or done >= arguments.count or counts[prefix]["noticed"] + counts[prefix]["survived"] >= share:
                continue
            path, number, kind, old, new = changes[turn]
            entry = {"file": path, "line": number + 1, "kind": kind, "old": old.strip(), "new": new.strip()}
            if arguments.list:
                print(f"{path}:{number + 1} {kind}: {old.strip()}  ->  {new.strip()}")
                done += 1
                continue
            why = known.get((path, old.strip(), new.strip()))
            if why:
                counts[prefix]["invisible"] += 1
                continue
            if verdict := before.get((path, number + 1, old.strip(), new.strip())):
                counts[prefix][verdict] += 1
                done += verdict != "does not compile"
                continue
            if arguments.no_headers and path.endswith(".h"):
                counts[prefix]["header"] += 1
                continue
            tests.prepare(tests_of(path))
            try:
                found, seconds = tests.notice(tests_of(path), lambda: Planted(path, old, new, number))
            finally:
                put_back()
            verdict = "survived" if found is None else found if found == "does not compile" else "noticed"
            counts[prefix][verdict] += 1
            entry.update(verdict=verdict, by=found, seconds=round(seconds, 1), seed=arguments.seed, commit=commit)
            log.write(json.dumps(entry) + "\n")
            log.flush()
            print(f"{verdict:17} {path}:{number + 1} {kind}: {old.strip()}  ->  {new.strip()}"
                  f"{'  [' + found + ']' if verdict == 'noticed' else ''} {seconds:.0f} s", flush=True)
            done += verdict != "does not compile"
    if arguments.list:
        return 0
    print(f"\n{'folder':20} noticed survived invisible  not compiled  headers")
    for prefix, c in counts.items():
        print(f"{prefix:20} {c['noticed']:7} {c['survived']:8} {c['invisible']:9} {c['does not compile']:13} {c['header']:8}")
    noticed = sum(c["noticed"] for c in counts.values())
    print(f"{'all':20} {noticed:7} {done - noticed:8}: {100.0 * noticed / max(done, 1):.0f} % noticed")
    return 0


def replay(path, tests, log):
    """Faults of a list, one JSON object a line: file, old, new, tests. Status 1 if one is not noticed."""
    missed = 0
    with open(path, encoding="utf-8") as stream:
        faults = [json.loads(line) for line in stream if line.strip() and not line.startswith("#")]
    for fault in faults:
        chosen = fault["tests"]
        tests.prepare(chosen)
        try:
            found, seconds = tests.notice(chosen, lambda: Planted(fault["file"], fault["old"], fault["new"]))
        finally:
            put_back()
        missed += found is None or found == "does not compile"
        log.write(json.dumps(dict(fault, by=found, seconds=round(seconds, 1))) + "\n")
        print(f"{'NOT NOTICED' if found is None else found:45} {fault['what']} {seconds:.0f} s", flush=True)
    print(f"{len(faults) - missed} of {len(faults)} noticed")
    return 1 if missed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seed", type=int, default=1, help="other mutants; the same ones for the same seed and tree")
    parser.add_argument("--count", type=int, default=20, help="how many that compile")
    parser.add_argument("--only", action="append", help="only below this folder (repeatable)")
    parser.add_argument("--list", action="store_true", help="print what would be planted, and nothing more")
    parser.add_argument("--no-headers", action="store_true", help="leave out faults in headers: what includes one takes long to build")
    parser.add_argument("--replay", metavar="FILE", help="plant the faults of this list in place of random ones")
    arguments = parser.parse_args()

    os.makedirs(BUILD, exist_ok=True)
    lock = open(os.path.join(BUILD, "lock"), "w", encoding="utf-8")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit("another run works in this checkout")
    if path := put_back():
        print(f"put back {path}, which an earlier run had left changed", flush=True)
    dirty = subprocess.run(["git", "-C", ROOT, "status", "--porcelain", "--untracked-files=no", "filters", "shaders", "app"],
                           capture_output=True, text=True, check=True).stdout
    if dirty and not arguments.list:
        sys.exit("commit or stash first: these files differ from the last commit\n" + dirty)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: sys.exit(1))  # by way of every `with`
    if not arguments.list:
        configure()
    tests = None if arguments.list else Tests()
    with open(os.path.join(BUILD, "log.jsonl"), "a", encoding="utf-8") as log:
        try:
            return replay(arguments.replay, tests, log) if arguments.replay else campaign(arguments, tests, log)
        except KeyboardInterrupt:
            return 130
        finally:
            put_back()


if __name__ == "__main__":
    sys.exit(main())
