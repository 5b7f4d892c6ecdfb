// See stress_gpu.h.
#include "filters/stress_gpu/stress_gpu.h"

#include <tbb/parallel_for.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "filters/math/sampling/blue_noise.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/stress/stress_light.h"
#include "filters/stress/stress_subjects.h"
#include "filters/stress_gpu/stress_program.h"
#include "filters/vtk/gl/framebuffer.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

using namespace stress;

namespace {

// A batch: the inputs that one pass draws.
constexpr int kWidth = 512, kHeight = 512;
constexpr std::size_t kBatch = static_cast<std::size_t>(kWidth) * kHeight;
constexpr int kFixedTextures = 8;  // for every input; parameters follow, four per texture

using Texels = std::vector<glm::vec4>;

/// As texels: exact, and invisible to a driver's constant folding.
void pack(const StressInput& input, const std::vector<const ParameterRow*>& parameters, std::size_t at,
          std::vector<Texels>& textures) {
  const LocalInput in = unguardedInput(input);
  const shading::ShadingPoint& p = in.point;
  textures[0][at] = {p.position, p.roughness};
  textures[1][at] = {p.normal, in.probe.maxLevel};
  textures[2][at] = {p.view, static_cast<float>(p.frame)};
  textures[3][at] = {p.reflection, in.probe.bevel};
  textures[4][at] = {in.probe.boxMin, static_cast<float>(p.pixel.x)};
  textures[5][at] = {in.probe.boxMax, static_cast<float>(p.pixel.y)};
  textures[6][at] = {lobeNumbers(input), blendRate(input), static_cast<float>(input.pixel.x & 1)};
  const shading::ShadingPoint guarded = localInput(input).point;
  textures[7][at] = {blueNoiseAt(p.pixel), splitSum(shading::footprintLobe(guarded, 1.0f).view.z, guarded.roughness)};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterRow& row = *parameters[i];
    const float value = row.number != nullptr
                            ? input.parameters.*row.number
                            : (row.choice != nullptr ? static_cast<float>(input.parameters.*row.choice) : 0.0f);
    textures[kFixedTextures + i / 4][at][static_cast<int>(i % 4)] = value;
  }
}

std::string sourceOf(const StressProgram& program, const std::vector<const ParameterRow*>& parameters, int textures) {
  std::string text = program.declarations;
  for (int i = 0; i < textures; ++i) text += "uniform sampler2D stressIn" + std::to_string(i) + ";\n";
  text += "void main()\n{\n  ivec2 at = ivec2(gl_FragCoord.xy);\n";
  for (int i = 0; i < textures; ++i) {
    text += "  vec4 in" + std::to_string(i) + " = texelFetch(stressIn" + std::to_string(i) + ", at, 0);\n";
  }
  text +=
      "  ProbeShape probe;\n  probe.boxMin = in4.xyz;\n  probe.boxMax = in5.xyz;\n  probe.maxLevel = in1.w;\n"
      "  probe.projection = 0;\n  probe.bevel = 0.0;\n  probe.slot = 0;\n";
  constexpr const char* kComponents[] = {".x", ".y", ".z", ".w"};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterRow& row = *parameters[i];
    if (row.number == nullptr && row.choice == nullptr) continue;
    const std::string value = "in" + std::to_string(kFixedTextures + i / 4) + kComponents[i % 4];
    text += "  probe.parameters." + std::string(row.name) + " = " +
            (row.number != nullptr ? value : "int(" + value + ")") + ";\n";
  }
  // The order of bpGatherLight in gpu/probe_lighting.glsl, except for R, which inputs contain.
  text +=
      "  ShadingPoint point;\n  point.position = finiteOr(in0.xyz, vec3(0.0));\n"
      "  point.view = directionOr(in2.xyz, vec3(0.0, 0.0, 1.0));\n  point.normal = directionOr(in1.xyz, point.view);\n"
      "  point.reflection = directionOr(in3.xyz, reflectedView(point.normal, point.view));\n"
      "  point.roughness = roughnessWithin(in0.w); point.fresnel = point.roughness;\n  "
      "point.f0 = max(point.roughness, 1.0e-2);\n  point.pixel = ivec2(in4.w, "
      "in5.w);\n"
      "  point.frame = int(in2.w);\n  vec4 extra = in6;\n  stressBlueNoise = in7.xy;\n  stressSplitSum = in7.zw;\n"
      "  vec4 out0 = vec4(0.0);\n  vec4 out1 = vec4(0.0);\n" +
      program.body + "  gl_FragData[0] = out0;\n  gl_FragData[1] = out1;\n}\n";
  return text;
}

/// Float textures of one size, released by the destructor.
class Textures {
 public:
  Textures(vtkOpenGLRenderWindow* window, int count) : window_(window), handles_(static_cast<std::size_t>(count)) {
    glGenTextures(count, handles_.data());
    for (const GLuint handle : handles_) {
      const BoundTexture bound(window_, GL_TEXTURE_2D, handle);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, kHeight, 0, GL_RGBA, GL_FLOAT, nullptr);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    }
  }
  ~Textures() { glDeleteTextures(static_cast<GLsizei>(handles_.size()), handles_.data()); }
  Textures(const Textures&) = delete;
  Textures& operator=(const Textures&) = delete;

  /// Uploads the lowest `rows`.
  void upload(std::size_t i, const Texels& texels, int rows) {
    const BoundTexture bound(window_, GL_TEXTURE_2D, handles_[i]);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth, rows, GL_RGBA, GL_FLOAT, texels.data());
  }
  GLuint operator[](std::size_t i) const { return handles_[i]; }

 private:
  vtkOpenGLRenderWindow* window_;
  std::vector<GLuint> handles_;
};

/// Two float targets in a framebuffer.
class Targets {
 public:
  explicit Targets(vtkOpenGLRenderWindow* window) : window_(window), textures_(window, 2) {
    framebuffer_.attach({textureImage(textures_[0]), textureImage(textures_[1])}, {}, floatRefusal("stress inputs"));
  }

  /// Draws the lowest `rows` only.
  std::array<Texels, 2> draw(FullScreenPass& pass, const Textures& inputs, int count, int rows) {
    const PassState saved(window_);
    window_->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.handle());
    window_->GetState()->vtkglViewport(0, 0, kWidth, rows);
    std::vector<std::unique_ptr<BoundTexture>> bound;
    pass.draw(window_, [&](vtkShaderProgram* program) {
      if (program->IsUniformUsed("stressLight")) {
        const std::vector<glm::vec4>& cells = stressLightTable().cells;
        program->SetUniform4fv("stressLight", static_cast<int>(cells.size()),
                               reinterpret_cast<const float(*)[4]>(cells.data()));
      }
      for (int i = 0; i < count; ++i) {
        bound.push_back(std::make_unique<BoundTexture>(window_, GL_TEXTURE_2D, inputs[static_cast<std::size_t>(i)]));
        const std::string name = "stressIn" + std::to_string(i);
        if (program->IsUniformUsed(name.c_str())) program->SetUniformi(name.c_str(), bound.back()->unit());
      }
    });
    std::array<Texels, 2> results;
    for (std::size_t i = 0; i < 2; ++i) {
      results[i].resize(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(rows));
      glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
      glReadPixels(0, 0, kWidth, rows, GL_RGBA, GL_FLOAT, results[i].data());
    }
    return results;
  }

 private:
  vtkOpenGLRenderWindow* window_;
  Textures textures_;
  Framebuffer framebuffer_;
};

bool finite4(const glm::vec4& v) {
  return finite(glm::vec3(v)) && std::isfinite(v.w);
}

double farthest(const glm::vec3& a, const glm::vec3& b) {
  const glm::dvec3 off = glm::abs(glm::dvec3(a) - glm::dvec3(b));
  return std::max({off.x, off.y, off.z});
}

Trial compare(const StressProgram& program, const StressClass& inputs, const StressInput& input, const glm::vec4& value,
              const glm::vec4& hit) {
  Trial trial;
  trial.require(finite4(value) && finite4(hit));
  if (!trial.finite || !program.onCpu) return trial;
  const StressValues cpu = program.onCpu(input);
  const auto differ = [&trial](Measure what, double by) {
    trial.measure(what, by, 1.0, false);
    trial.severity = std::max(trial.severity, by);
  };
  const double scale = std::max(1.0, static_cast<double>(std::abs(cpu.value.x)));  // for terms without a size
  differ(kRelative, farthest(glm::vec3(value), glm::vec3(cpu.value)) / (program.technique ? 1.0 : scale));
  differ(kLevels, std::abs(static_cast<double>(value.w) - static_cast<double>(cpu.value.w)));
  if (program.technique) {
    const LocalInput in = localInput(input);
    differ(kBoxSizes, farthest(glm::vec3(hit), glm::vec3(cpu.hit)) / lengthScale(in, inputs));
  }
  return trial;
}

/// The cell and index of an input in a batch.
struct Place {
  std::size_t cell;
  std::uint64_t index;
};

}  // namespace

std::vector<StressCell> runStressGpu(vtkOpenGLRenderWindow* window, const StressPlan& plan,
                                     const std::function<bool(double)>& progress) {
  StressPlan possible = plan;
  possible.subjects.clear();
  for (const StressSubject* subject : plan.subjects) {
    if (stressProgram(*subject)) possible.subjects.push_back(subject);
  }
  std::vector<StressCell> cells = stressCells(possible);
  Targets targets(window);
  std::uint64_t done = 0;
  for (std::size_t s = 0; s < possible.subjects.size(); ++s) {
    const StressSubject& subject = *possible.subjects[s];
    const StressProgram program = *stressProgram(subject);
    const int count = kFixedTextures + static_cast<int>((subject.parameters.size() + 3) / 4);
    Textures inputs(window, count);
    std::vector<Texels> texels(static_cast<std::size_t>(count), Texels(kBatch, glm::vec4(0.0f)));
    FullScreenPass pass("of the stress test for " + subject.id, sourceOf(program, subject.parameters, count));

    std::vector<Place> batch;
    const auto flush = [&] {
      // Short runs draw only the rows they need.
      const int rows = static_cast<int>((batch.size() + kWidth - 1) / kWidth);
      std::vector<StressInput> made(batch.size());
      const auto each = [&batch](const auto& work) { tbb::parallel_for(std::size_t{0}, batch.size(), work); };
      each([&](std::size_t i) {
        made[i] = makeInput(*cells[batch[i].cell].inputs, subject.id, plan.seed, batch[i].index, subject.parameters);
        pack(made[i], subject.parameters, i, texels);
      });
      for (std::size_t t = 0; t < texels.size(); ++t) inputs.upload(t, texels[t], rows);
      const std::array<Texels, 2> results = targets.draw(pass, inputs, count, rows);
      std::vector<Trial> trials(batch.size());
      each([&](std::size_t i) {
        trials[i] = compare(program, *cells[batch[i].cell].inputs, made[i], results[0][i], results[1][i]);
      });
      for (std::size_t i = 0; i < batch.size(); ++i) cells[batch[i].cell].tally.add(trials[i], batch[i].index);
      done += batch.size();
      batch.clear();
      return progress(static_cast<double>(done) / static_cast<double>(plan.count));
    };
    bool goOn = true;
    for (std::size_t c = 0; c < possible.classes.size() && goOn; ++c) {
      const std::size_t cell = c * possible.subjects.size() + s;
      for (std::uint64_t i = 0; i < inputsOfCell(possible, cell) && goOn; ++i) {
        batch.push_back({cell, i});
        if (batch.size() == kBatch) goOn = flush();
      }
    }
    if (goOn && !batch.empty()) goOn = flush();
    pass.release();
    if (!goOn) return {};
  }
  return cells;
}

}  // namespace boxprobe
