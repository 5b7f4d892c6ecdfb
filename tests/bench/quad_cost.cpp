// bench_quads: time of every technique by full-screen quads: the shader text that draws, one evaluation a pixel, its
// lookups computed instead of fetched, so that arithmetic is compared and not a driver's filtering; or, with --lookups,
// what the fetch takes, from a cubemap and from its flat picture. Nanoseconds of CPU time per pixel, which on a
// software driver is the time it takes; the median of several draws of all in turn.
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
#include "filters/vtk/maps/flat_texture.h"
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
         "  point.fresnel = 0.5;  point.f0 = 0.5;\n  point.pixel = ivec2(gl_FragCoord.xy);\n  point.frame = 0;\n"
         "  vec4 extra = vec4(0.0);\n  stressBlueNoise = texCoord;\n  vec4 out0 = vec4(0.0);\n  vec4 out1 = "
         "vec4(0.0);\n" +
         program.body + "  gl_FragData[0] = out0 + out1;\n}\n";
}

double draw(vtkOpenGLRenderWindow* window, const FloatTarget& target, FullScreenPass& pass, int map = 0) {
  const PassState saved(window);
  window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  window->GetState()->vtkglViewport(0, 0, kSide, kSide);
  const double start = processCpuSeconds();
  pass.draw(window, [map](vtkShaderProgram* program) {
    const float low[3] = {-2.0f, -1.0f, -1.5f}, high[3] = {1.0f, 2.0f, 1.5f};
    program->SetUniform3f("benchMin", low);
    program->SetUniform3f("benchMax", high);
    program->SetUniformi("benchMap", map);
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

// As a footprint technique's lookups: near each other, each at a level of its own.
std::string lookupSource(const char* sampler, const char* lookup) {
  return joinShaderSources({"gpu/flat_lookup.glsl"}) + "uniform " + sampler +
         " benchMap;\nin vec2 texCoord;\nvoid main()\n{\n  vec4 sum = vec4(0.0);\n"
         "  for (int i = 0; i < 4; ++i)\n  {\n    float turn = 3.0 * texCoord.x + 0.3 * float(i);\n"
         "    vec3 d = vec3(sin(turn), texCoord.y - 0.5, cos(turn));\n"
         "    float level = 1.2 + 0.7 * float(i) * texCoord.x + 0.1 * texCoord.y;\n    sum += " +
         lookup + ";\n  }\n  gl_FragData[0] = sum;\n}\n";
}

void runLookups(const CLI::App& program, int draws) {
  constexpr int kFaceSize = 256, kLookups = 4;
  const auto window = openOffscreenWindow(bench::smallWindowSettings(program));
  FloatTarget target;
  target.allocate(kSide, kSide);
  CubeTexture chain;
  chain.allocate(kFaceSize, 7, GL_RGBA16F);
  for (int level = 0; level < chain.levels(); ++level) {
    const int size = kFaceSize >> level;
    std::vector<float> texels(4 * static_cast<std::size_t>(size * size));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<float>(i % 251) / 251.0f;
    for (int face = 0; face < 6; ++face) chain.writeFace(face, level, texels);
  }
  FlatTexture flat;
  flat.make(chain, std::make_shared<std::size_t>(0));
  struct Kind {
    Quad quad;
    GLenum texture;
    GLuint handle;
  };
  std::vector<Kind> kinds;
  const auto add = [&](const char* id, const std::string& source, GLenum texture, GLuint handle) {
    kinds.push_back({{id, std::make_unique<FullScreenPass>(id, source), {}}, texture, handle});
  };
  add("nothing", lookupSource("sampler2D", "vec4(d, level)"), GL_TEXTURE_2D, flat.handle());
  add("cubemap", lookupSource("samplerCube", "textureLod(benchMap, d, level)"), GL_TEXTURE_CUBE_MAP, chain.handle());
  add("flat picture", lookupSource("sampler2D", "bpFlatLookup(benchMap, d, level, 256.0, 6.0)"), GL_TEXTURE_2D,
      flat.handle());
  for (int i = -1; i < draws; ++i) {  // the first one compiles
    for (Kind& kind : kinds) {
      const BoundTexture map(window, kind.texture, kind.handle);
      const double seconds = draw(window, target, *kind.quad.pass, map.unit());
      if (i >= 0) kind.quad.seconds.push_back(seconds);
    }
  }
  const double nothing = bench::median(kinds.front().quad.seconds);
  std::printf("faces of %d texels, %d lookups a pixel, median of %d draws, without what a pixel takes besides\n",
              kFaceSize, kLookups, draws);
  for (Kind& kind : kinds) {
    const double seconds = bench::median(kind.quad.seconds) - nothing;
    if (seconds > 0.0)
      std::printf("  %-24s %8.1f ns a lookup\n", kind.quad.id.c_str(), 1e9 * seconds / (kLookups * kSide * kSide));
    kind.quad.pass->release();
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of every technique by full-screen quads", "bench_quads");
  std::vector<std::string> ids;
  int draws = 15;
  program.add_option("--technique", ids, "Only these, by full id (default: all)");
  bool lookups = false;
  program.add_flag("--lookups", lookups, "A lookup in a cubemap and in its flat picture instead");
  program.add_option("--draws", draws, "Draws of each")->check(CLI::Range(1, 100000))->capture_default_str();
  return bench::runProgram(program, argc, argv,
                           [&] { lookups ? runLookups(program, draws) : run(program, ids, draws); });
}
