// bench_robust: what it costs that nothing can go wrong. CPU time of frames, and of full-screen passes that do nothing
// but project, with the program's own forms over the same with the published ones, drawn in turn in one process and
// window.
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>

#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "filters/core/base/errors.h"
#include "filters/math/shared/shader_source.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"
#include "tests/bench/harness.h"
#include "tests/bench/published_sources.h"

namespace {

using namespace boxprobe;

struct BenchOptions : bench::FrameOptions {
  std::vector<std::string> techniques = {"box", "hdrp", "sphere"};
};

void print(const std::string& what, const bench::Comparison& result) {
  std::printf("  %-28s own %8.2f ms   published %8.2f ms   %s\n", what.c_str(), result.first, result.second,
              result.ratioText().c_str());
}

// Rays of a pixel's own, so that nothing is constant. `lookup`: with the texture lookup that every technique ends in;
// without it nothing but arithmetic is timed.
std::string passSource(const Technique& technique, bool lookup) {
  const ProjectionRow& projection = projectionRows()[static_cast<std::size_t>(technique.projection)];
  const EvaluationRow& evaluation = evaluationRows()[static_cast<std::size_t>(technique.evaluation)];
  std::string text = joinShaderSources({"shared/types.glsl", "shared/finite.glsl", "shared/slab.glsl",
                                        "shared/roughness.glsl", std::string(projection.shaderFile)});
  text += "ProbeHit projectRay(ProbeShape probe, vec3 p, vec3 n, vec3 r) { return " + std::string(projection.function) +
          "(probe, p, n, r); }\n#define PROBE_MAP int\nuniform samplerCube benchMap;\n"
          "vec4 fetchProbe(int map, ProbeShape probe, vec3 d, float level) { return " +
          (lookup ? "textureLod(benchMap, lookupDirection(d), level)" : "vec4(lookupDirection(d), level)") + "; }\n";
  text += joinShaderSources({"shared/level_curve.glsl", std::string(evaluation.shaderFile)});
  text +=
      "uniform vec3 benchMin;\nuniform vec3 benchMax;\nin vec2 texCoord;\nvoid main()\n{\n"
      "  vec3 sum = vec3(0.0);\n  ProbeShape probe;\n  probe.boxMin = benchMin;\n  probe.boxMax = benchMax;\n"
      "  probe.maxLevel = 6.0;\n  probe.projection = 0;\n  probe.bevel = 0.0;\n  probe.slot = 0;\n"
      "  probe.parameters.curve = 0;\n  for (int i = 0; i < 16; ++i)\n  {\n    float turn = 0.39 * float(i) + "
      "texCoord.x;\n"
      "    ShadingPoint point;\n    point.position = vec3(texCoord - 0.5, 0.05 * float(i) - 0.4);\n"
      "    point.normal = finiteOr(vec3(0.0, 1.0, 0.0), vec3(0.0));\n    point.view = normalize(vec3(cos(turn), "
      "texCoord.y + "
      "0.1, sin(turn)));\n    point.view = directionOr(point.view, vec3(0.0, 0.0, 1.0));\n    point.position = "
      "finiteOr(point.position, vec3(0.0));\n    point.reflection = reflectedView(point.normal, point.view);\n"
      "    point.roughness = roughnessWithin(texCoord.y); point.f0 = 1.0;\n    vec4 value = " +
      std::string(evaluation.function) +
      "(0, probe, point);\n    sum += value.xyz + value.www;\n  }\n  gl_FragData[0] = vec4(sum, 1.0);\n}\n";
  return text;
}

void measurePass(vtkOpenGLRenderWindow* window, const std::string& id, int pairs, bool lookup) {
  CubeTexture map;
  map.allocate(64, 7, GL_RGBA16F);
  for (int level = 0; level < 7; ++level) {
    for (int face = 0; face < 6; ++face) map.writeFace(face, level, std::vector<float>(4u << (12 - 2 * level), 0.5f));
  }
  FloatTarget target;
  target.allocate(512, 512);
  bench::usePublishedShaders(true);
  FullScreenPass published("published", passSource(*parseTechnique(id), lookup));
  bench::usePublishedShaders(false);
  FullScreenPass own("own", passSource(*parseTechnique(id), lookup));
  const auto draw = [&](FullScreenPass& pass, bool isPublished) {
    bench::usePublishedShaders(isPublished);
    const PassState saved(window);
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    window->GetState()->vtkglViewport(0, 0, target.width(), target.height());
    const BoundTexture bound(window, GL_TEXTURE_CUBE_MAP, map.handle());
    const double start = processCpuSeconds();
    pass.draw(window, [&bound](vtkShaderProgram* program) {
      const float low[3] = {-2.0f, -1.0f, -1.5f}, high[3] = {1.0f, 2.0f, 1.5f};
      program->SetUniform3f("benchMin", low);
      program->SetUniform3f("benchMax", high);
      if (program->IsUniformUsed("benchMap")) program->SetUniformi("benchMap", bound.unit());
    });
    glFinish();
    const double seconds = processCpuSeconds() - start;
    bench::usePublishedShaders(false);
    return seconds;
  };
  print(id, bench::compare(
                3, 4 * pairs, [&] { return draw(own, false); }, [&] { return draw(published, true); }));
  own.release();
  published.release();
}

void measureFrame(const CLI::App& program, const BenchOptions& options, const std::string& id) {
  LoadedScene loaded = loadScene(options.scene);
  chooseTechnique(loaded.scene, id);
  OffscreenScene own(windowSettings(program, options)), published(own.window());
  const auto drawOnly = [&](const OffscreenScene& one) {
    bench::usePublishedShaders(&one == &published);
    bench::drawOnly(one, {&own, &published});
  };
  for (OffscreenScene* drawn : {&own, &published}) {
    drawOnly(*drawn);
    bench::prepare(*drawn, loaded.scene, loaded.models);
  }
  const auto frame = [&](OffscreenScene& one) {
    drawOnly(one);
    return one.timedFrame();
  };
  print(id, bench::compare(
                2, options.frames, [&] { return frame(own); }, [&] { return frame(published); }));
  own.requireHealthy();
  published.requireHealthy();
  bench::usePublishedShaders(false);
}

void run(const CLI::App& program, const BenchOptions& options) {
  {
    const auto window = openOffscreenWindow(bench::smallWindowSettings(program));
    for (const bool lookup : {true, false}) {
      std::printf("full-screen pass of 512 x 512 pixels, 16 rays each, %s: %d pairs, CPU time\n",
                  lookup ? "each looked up" : "arithmetic alone", 4 * options.frames);
      for (const std::string& id : options.techniques) measurePass(window, id, options.frames, lookup);
    }
  }
  std::printf("%s, %s, %d samples per pixel: %d pairs of frames, CPU time\n", options.scene.c_str(),
              options.size.c_str(), options.samples, options.frames);
  for (const std::string& id : options.techniques) measureFrame(program, options, id);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time with the program's own projection mathematics over the published forms", "bench_robust");
  BenchOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  options.frames = 60;
  addFrameOptions(program, options, "--pairs");
  program.add_option("--technique", options.techniques, "Techniques with published counterparts")
      ->capture_default_str();
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
