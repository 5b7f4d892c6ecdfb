#include "tests/unit/model_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

namespace boxprobe {

namespace {

std::string text(double value) {
  char digits[32];
  // Numbers that are 0 but for rounding would have other digits on each machine.
  std::snprintf(digits, sizeof digits, "%.6g", std::fabs(value) < 1e-9 ? 0.0 : value);
  return digits;
}

template <int Length, typename Number, glm::qualifier Q>
std::string text(const glm::vec<Length, Number, Q>& v) {
  std::string all;
  for (int i = 0; i < Length; ++i) all += (i > 0 ? " " : "") + text(static_cast<double>(v[i]));
  return all;
}
template <int Columns, int Rows, typename Number, glm::qualifier Q>
std::string text(const glm::mat<Columns, Rows, Number, Q>& m) {
  std::string all;
  for (int i = 0; i < Columns; ++i) all += (i > 0 ? ", " : "") + text(m[i]);
  return all;
}
std::string text(int value) {
  return std::to_string(value);
}
std::string text(bool value) {
  return value ? "true" : "false";
}
std::string text(const std::string& value) {
  return "'" + value + "'";
}

class Writer {
 public:
  Writer(const Model& model, const std::string& folder, bool defaults) : folder_(folder) {
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
      start("material " + std::to_string(i));
      add(model.materials[i], defaults && i == 0);
    }
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
      start("mesh " + std::to_string(i));
      add(model.meshes[i]);
    }
    for (std::size_t i = 0; i < model.instances.size(); ++i) {
      const Instance& instance = model.instances[i];
      start("instance " + std::to_string(i));
      line("node", text(instance.node) + " mesh " + std::to_string(instance.mesh));
      line("at", text(instance.worldFromModel));
    }
    for (std::size_t i = 0; i < model.lights.size(); ++i) {
      start("light " + std::to_string(i));
      add(model.lights[i]);
    }
    for (std::size_t i = 0; i < model.cameras.size(); ++i) {
      start("camera " + std::to_string(i));
      add(model.cameras[i]);
    }
    start("model");
    for (const std::string& variant : model.variants) line("variant", text(variant));
    line("animationSeconds", text(model.animationSeconds));
    line("triangles", std::to_string(model.triangleCount()));
    for (const std::string& warning : model.warnings) line("warning", withoutFolder(warning, folder));
  }

  std::vector<std::string> lines;

 private:
  void start(const std::string& of) { of_ = of; }
  void line(const std::string& key, const std::string& value) { lines.push_back(of_ + " " + key + " " + value); }
  template <typename Value>
  void field(const char* key, const Value& value, const Value& standard) {
    if (all_ || value != standard) line(key, text(value));
  }

  void add(const Material& m, bool all) {
    all_ = all;
    const Material d;
    line("name", text(m.name));
    field("baseColor", m.baseColor, d.baseColor);
    field("metallic", m.metallic, d.metallic);
    field("roughness", m.roughness, d.roughness);
    field("emissive", m.emissive, d.emissive);
    field("normalScale", m.normalScale, d.normalScale);
    field("occlusionStrength", m.occlusionStrength, d.occlusionStrength);
    field("coat", m.coat, d.coat);
    field("coatRoughness", m.coatRoughness, d.coatRoughness);
    field("coatNormalScale", m.coatNormalScale, d.coatNormalScale);
    field("transmission", m.transmission, d.transmission);
    field("ior", m.ior, d.ior);
    field("specular", m.specular, d.specular);
    field("thin", m.thin, d.thin);
    field("thickness", m.thickness, d.thickness);
    field("thicknessMean", m.thicknessMean, d.thicknessMean);
    field("attenuationDistance", m.attenuationDistance, d.attenuationDistance);
    field("attenuationColor", m.attenuationColor, d.attenuationColor);
    field("unlit", m.unlit, d.unlit);
    field("doubleSided", m.doubleSided, d.doubleSided);
    field("alphaMode", static_cast<int>(m.alphaMode), static_cast<int>(d.alphaMode));
    field("alphaCutoff", m.alphaCutoff, d.alphaCutoff);
    field("glass", static_cast<int>(m.glass), static_cast<int>(d.glass));
    add(m.finish);
    const std::pair<const char*, const TextureUse*> textures[] = {
        {"baseColorTexture", &m.baseColorTexture},
        {"metallicRoughnessTexture", &m.metallicRoughnessTexture},
        {"normalTexture", &m.normalTexture},
        {"occlusionTexture", &m.occlusionTexture},
        {"emissiveTexture", &m.emissiveTexture},
        {"coatTexture", &m.coatTexture},
        {"coatRoughnessTexture", &m.coatRoughnessTexture},
        {"coatNormalTexture", &m.coatNormalTexture},
        {"transmissionTexture", &m.transmissionTexture},
        {"thicknessTexture", &m.thicknessTexture},
        {"specularTexture", &m.finish.specularTexture},
        {"specularColorTexture", &m.finish.specularColorTexture},
        {"sheenColorTexture", &m.finish.sheenColorTexture},
        {"sheenRoughnessTexture", &m.finish.sheenRoughnessTexture},
        {"anisotropyTexture", &m.finish.anisotropyTexture},
        {"iridescenceTexture", &m.finish.iridescenceTexture},
        {"filmThicknessTexture", &m.finish.filmThicknessTexture}};
    for (const auto& [name, use] : textures) add(name, *use);
  }

  void add(const MaterialFinish& f) {
    const MaterialFinish d;
    field("specularTint", f.specularTint, d.specularTint);
    field("specularEdge", f.specularEdge, d.specularEdge);
    field("sheenColor", f.sheenColor, d.sheenColor);
    field("sheenRoughness", f.sheenRoughness, d.sheenRoughness);
    field("anisotropy", f.anisotropy, d.anisotropy);
    field("anisotropyRotation", f.anisotropyRotation, d.anisotropyRotation);
    field("iridescence", f.iridescence, d.iridescence);
    field("filmIor", f.filmIor, d.filmIor);
    field("filmThicknessMin", f.filmThicknessMin, d.filmThicknessMin);
    field("filmThicknessMax", f.filmThicknessMax, d.filmThicknessMax);
  }

  void add(const std::string& name, const TextureUse& use) {
    const TextureUse d;
    const bool plain = use.wrapS == d.wrapS && use.wrapT == d.wrapT && use.uvSet == 0 && !use.nearest;
    if (!use.image && plain && use.uvTransform == d.uvTransform) return;
    if (!plain) {
      line(name, "wrap " + std::to_string(static_cast<int>(use.wrapS)) + " " +
                     std::to_string(static_cast<int>(use.wrapT)) + " uv " + std::to_string(use.uvSet) +
                     (use.nearest ? " nearest" : ""));
    }
    if (use.uvTransform != d.uvTransform) line(name, "transform " + text(use.uvTransform));
    line(name, use.image ? pictureOf(*use.image) : "without a picture");
  }

  std::string pictureOf(const ImageRgba8& image) const {
    std::string all = std::to_string(image.width) + " x " + std::to_string(image.height);
    all += " " + text(withoutFolder(image.name, folder_));
    std::replace(all.begin(), all.end(), '\n', '|');
    constexpr std::size_t kMost = 40;
    for (std::size_t i = 0; i < std::min(image.pixels.size(), 4 * kMost); ++i) {
      all += (i % 4 == 0 ? "  " : " ") + std::to_string(image.pixels[i]);
    }
    return all;
  }

  void add(const Mesh& mesh) {
    line("name", text(mesh.name) + " material " + std::to_string(mesh.material));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      std::string all = std::to_string(i) + ": " + text(mesh.positions[i]);
      const auto more = [&](const char* what, const auto& values) {
        if (i < values.size()) all += std::string(" ") + what + " " + text(values[i]);
      };
      more("n", mesh.normals);
      more("t", mesh.tangents);
      more("uv", mesh.uv);
      more("uv1", mesh.uv1);
      more("c", mesh.colors);
      line("vertex", all);
    }
    for (const std::size_t size :
         {mesh.normals.size(), mesh.tangents.size(), mesh.uv.size(), mesh.uv1.size(), mesh.colors.size()}) {
      if (size != 0 && size != mesh.positions.size()) line("has a list of", std::to_string(size));
    }
    std::string all;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      all += (i % 3 == 0 && i > 0 ? ", " : i > 0 ? " " : "") + std::to_string(mesh.indices[i]);
    }
    line("indices", all);
  }

  void add(const Light& light) {
    all_ = true;
    field("type", static_cast<int>(light.type), 0);
    field("direction", light.direction, {});
    field("position", light.position, {});
    field("color", light.color, {});
    field("intensity", light.intensity, 0.0f);
    field("cones", glm::dvec2(light.innerConeDegrees, light.outerConeDegrees), {});
    field("range", light.range, 0.0);
  }

  void add(const Camera& camera) {
    all_ = true;
    line("name", text(camera.name));
    field("position", camera.position, {});
    field("target", camera.target, {});
    field("up", camera.up, {});
    field("verticalFovDegrees", camera.verticalFovDegrees, 0.0);
    field("parallelHeight", camera.parallelHeight, 0.0);
  }

  const std::string& folder_;
  std::string of_;
  bool all_ = false;
};

}  // namespace

std::string withoutFolder(std::string text, const std::string& folder) {
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
    text.erase(at, folder.size() + (text[at + folder.size()] == '/' ? 1 : 0));
  }
  return text;
}

std::vector<std::string> modelLines(const Model& model, const std::string& folder, bool defaults) {
  return Writer(model, folder, defaults).lines;
}

std::string differenceOf(const std::vector<std::string>& before, const std::vector<std::string>& after) {
  std::map<std::string, int> counts;
  for (const std::string& line : before) ++counts[line];
  std::vector<std::string> added, removed;
  for (const std::string& line : after) {
    if (--counts[line] < 0) added.push_back("+ " + line);
  }
  for (const auto& [line, count] : counts) {
    if (count > 0) removed.push_back("- " + line);
  }
  const std::vector<std::string>& told = added.empty() ? removed : added;
  constexpr std::size_t kMost = 2;
  std::string all;
  for (std::size_t i = 0; i < std::min(told.size(), kMost); ++i) all += (i > 0 ? " | " : "") + told[i];
  if (added.size() + removed.size() > kMost) {
    all += " | in all +" + std::to_string(added.size()) + " -" + std::to_string(removed.size());
  }
  return all.empty() ? "the same" : all;
}

}  // namespace boxprobe
