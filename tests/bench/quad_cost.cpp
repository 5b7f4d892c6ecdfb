// bench_quads: time of every technique by full-screen quads: the shader text that draws, one evaluation a pixel, its
// lookups computed instead of fetched, so that arithmetic is compared and not a driver's filtering. Nanoseconds of CPU
// time per pixel, which on a software driver is the time it takes; the median of several draws of all techniques in
// turn.
#include <vtkOpenGLState.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "filters/stress/stress_light.h"
#include "filters/stress/stress_subjects.h"
#include "filters/stress_gpu/stress_program.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::stress;

constexpr int kSide = 512;

struct Quad {
  std::string id;
  std::unique_ptr<FullScreenPass> pass;
  std::vector<double> seconds;
};

// A room as large as the rays need; points, views and roughness vary over the picture, so that nothing is constant.
std::string sourceOf(const StressProgram& program, const StressSubject& subject) {
  std::string text = program.declarations +
                     "uniform vec3 benchMin;\nuniform vec3 benchMax;\nin vec2 texCoord;\nvoid main()\n{\n"
                     "  ProbeShape probe;\n  probe.boxMin = benchMin;\n  probe.boxMax = benchMax;\n"
                     "  probe.maxLevel = 6.0;\n  probe.projection = 0;\n  probe.bevel = 0.0;\n  probe.slot = 0;\n";
  const shading::TechniqueParameters standard = standardParameters();
  for (const ParameterRow* row : subject.parameters) {
    const std::string name = "  probe.parameters." + std::string(row->name) + " = ";
    if (row->number != nullptr) text += name + std::to_string(standard.*row->number) + ";\n";
    if (row->choice != nullptr) text += name + std::to_string(standard.*row->choice) + ";\n";
  }
  return text +
         "  float turn = 6.28 * texCoord.x;\n  ShadingPoint point;\n"
         "  point.position = vec3(texCoord - 0.5, 0.4 * cos(9.0 * turn));\n  point.normal = vec3(0.0, 1.0, 0.0);\n"
         "  point.view = normalize(vec3(cos(turn), texCoord.y + 0.05, sin(turn)));\n"
         "  point.reflection = reflectedView(point.normal, point.view);\n  point.roughness = texCoord.y;\n"
         "  point.fresnel = 0.5;\n  point.pixel = ivec2(gl_FragCoord.xy);\n  point.frame = 0;\n"
         "  vec4 extra = vec4(0.0);\n  stressBlueNoise = texCoord;\n  vec4 out0 = vec4(0.0);\n  vec4 out1 = "
         "vec4(0.0);\n" +
         program.body + "  gl_FragData[0] = out0 + out1;\n}\n";
}

double draw(vtkOpenGLRenderWindow* window, const FloatTarget& target, FullScreenPass& pass) {
  const PassState saved(window);
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  window->GetState()->vtkglViewport(0, 0, kSide, kSide);
  const double start = processCpuSeconds();
  pass.draw(window, [](vtkShaderProgram* program) {
    const float low[3] = {-2.0f, -1.0f, -1.5f}, high[3] = {1.0f, 2.0f, 1.5f};
    program->SetUniform3f("benchMin", low);
    program->SetUniform3f("benchMax", high);
    if (!program->IsUniformUsed("stressLight")) return;
    const std::vector<glm::vec4>& cells = stressLightTable().cells;
    program->SetUniform4fv("stressLight", static_cast<int>(cells.size()),
                           reinterpret_cast<const float(*)[4]>(cells.data()));
  });
  glFinish();
  return processCpuSeconds() - start;
}

void run(const CLI::App& program, const std::vector<std::string>& ids, int draws) {
  const auto window = openOffscreenWindow(bench::smallWindowSettings(program));
  FloatTarget target;
  target.allocate(kSide, kSide);
  std::vector<Quad> quads;
  for (const StressSubject& subject : techniqueSubjects()) {
    if (!ids.empty() && std::find(ids.begin(), ids.end(), subject.id) == ids.end()) continue;
    const auto source = stressProgram(subject);
    if (!source) continue;  // chosen in C++
    quads.push_back({subject.id, std::make_unique<FullScreenPass>(subject.id, sourceOf(*source, subject)), {}});
    draw(window, target, *quads.back().pass);  // compiles
  }
  for (int i = 0; i < draws; ++i) {
    for (Quad& quad : quads) quad.seconds.push_back(draw(window, target, *quad.pass));
  }
  std::printf("%d x %d pixels, one evaluation each, median of %d draws\n", kSide, kSide, draws);
  for (Quad& quad : quads) {
    std::printf("  %-24s %8.1f ns a pixel\n", quad.id.c_str(), 1e9 * bench::median(quad.seconds) / (kSide * kSide));
    quad.pass->release();
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of every technique by full-screen quads", "bench_quads");
  std::vector<std::string> ids;
  int draws = 15;
  program.add_option("--technique", ids, "Only these, by full id (default: all)");
  program.add_option("--draws", draws, "Draws of each")->check(CLI::Range(1, 100000))->capture_default_str();
  return bench::runProgram(program, argc, argv, [&] { run(program, ids, draws); });
}
