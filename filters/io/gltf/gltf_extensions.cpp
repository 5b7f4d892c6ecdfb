// Which extensions are supported, which are ignored and with what loss, and advice for files that require others.
#include <algorithm>
#include <array>

#include "filters/core/base/one_line.h"
#include "filters/io/gltf/gltf_parts.h"

namespace boxprobe {

namespace {

constexpr std::array kRead = {
    "BOXPROBE_reflection_probes", "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression",
    "EXT_texture_webp",           "KHR_draco_mesh_compression", "KHR_lights_punctual",
    "KHR_materials_anisotropy",   "KHR_materials_clearcoat",    "KHR_materials_emissive_strength",
    "KHR_materials_ior",          "KHR_materials_iridescence",  "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_sheen",        "KHR_materials_specular",     "KHR_materials_transmission",
    "KHR_materials_unlit",        "KHR_materials_variants",     "KHR_materials_volume",
    "KHR_mesh_quantization",      "KHR_texture_transform"};

struct Named {
  const char* name;
  const char* text;
};

/// The rest of the file is still correct without these.
constexpr Named kLeftOut[] = {
    {"KHR_materials_diffuse_transmission", "no light is let through diffusely"},
    {"KHR_materials_dispersion", "glass does not split colours"},
    {"KHR_animation_pointer", "these animations are left out"},
    {"KHR_node_visibility", "every node is drawn"},
    {"KHR_texture_basisu", "the PNG or JPEG beside each KTX2 texture is used"},
    {"MSFT_lod", "the finest level is drawn"},
    {"MSFT_texture_dds", "the PNG or JPEG beside each DDS texture is used"},
};

/// Advice for files that cannot be read without these.
constexpr Named kCures[] = {
    {"KHR_texture_basisu",
     "its textures are KTX2 (Basis Universal), which is not read; convert them: gltf-transform ktxdecompress IN OUT"},
    {"EXT_texture_avif", "its textures are AVIF, which is not read; convert them: gltf-transform png IN OUT"},
    {"MSFT_texture_dds", "its textures are DDS, which is not read; export it with PNG or JPEG textures"},
};

const char* textOf(const std::string& name, const Named* begin, const Named* end) {
  const Named* found = std::find_if(begin, end, [&](const Named& entry) { return name == entry.name; });
  return found == end ? nullptr : found->text;
}

bool isRead(const std::string& name) {
  return std::find(kRead.begin(), kRead.end(), name) != kRead.end();
}

}  // namespace

void checkExtensions(GltfFile& file, const std::vector<std::string>& required, const std::vector<std::string>& used) {
  for (const std::string& name : required) {
    if (isRead(name)) continue;
    if (const char* cure = textOf(name, std::begin(kCures), std::end(kCures))) {
      file.fail("extensionsRequired", "needs " + name + ": " + cure);
    }
    if (textOf(name, std::begin(kLeftOut), std::end(kLeftOut)) != nullptr) continue;
    file.fail("extensionsRequired", "needs " + name + ", which is not supported; export without it");
  }
  std::vector<std::string> named = used;
  named.insert(named.end(), required.begin(), required.end());
  for (const std::string& name : named) {
    if (isRead(name)) continue;
    const char* loss = textOf(name, std::begin(kLeftOut), std::end(kLeftOut));
    file.warn("uses the extension " + oneLine(name) + ", which is not supported" +
              (loss != nullptr ? std::string(": ") + loss : " and is ignored"));
  }
}

}  // namespace boxprobe
