#include "tests/baseline/baseline_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "filters/io/image/image_file.h"

namespace boxprobe::test {

namespace {

using Json = nlohmann::ordered_json;
using Vec = std::array<double, 3>;

std::string base64(const std::string& bytes) {
  static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      block = block << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    }
    for (int k = 0; k < 4; ++k) {
      const bool filled = i + static_cast<std::size_t>(k) <= bytes.size();
      text += filled ? digits[block >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

void writeText(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

struct Part {
  std::string node;
  std::vector<float> positions, normals, texcoords, colors;
  std::vector<std::uint16_t> indices;
  Json material;
};

void addCorner(Part& part, const Vec& position, const Vec& normal, double u, double v) {
  for (const double x : position) part.positions.push_back(static_cast<float>(x));
  for (const double x : normal) part.normals.push_back(static_cast<float>(x));
  part.texcoords.push_back(static_cast<float>(u));
  part.texcoords.push_back(static_cast<float>(v));
}

/// Of a block the six outer faces, or one wall of it (0..5: -x +x -y +y -z +z) seen from within.
Part block(const std::string& node, const Vec& low, const Vec& high, const Json& material, int wall = -1) {
  Part part;
  part.node = node;
  part.material = material;
  for (int face = 0; face < 6; ++face) {
    if (wall >= 0 && face != wall) continue;
    const auto axis = static_cast<std::size_t>(face / 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool upper = face % 2 == 1, outward = wall < 0;
    const auto first = static_cast<std::uint16_t>(part.positions.size() / 3);
    Vec normal{};
    normal[axis] = upper == outward ? 1.0 : -1.0;
    for (int i = 0; i < 4; ++i) {
      Vec corner{};
      corner[axis] = upper ? high[axis] : low[axis];
      corner[u] = i == 1 || i == 2 ? high[u] : low[u];
      corner[v] = i >= 2 ? high[v] : low[v];
      addCorner(part, corner, normal, 0.37 * corner[u] + 0.11, 0.53 * corner[v] + 0.23);
    }
    const bool turned = normal[axis] < 0.0;
    for (const int i : {0, turned ? 2 : 1, turned ? 1 : 2, 0, turned ? 3 : 2, turned ? 2 : 3}) {
      part.indices.push_back(static_cast<std::uint16_t>(first + i));
    }
  }
  return part;
}

Part ball(const std::string& node, const Vec& middle, double radius, const Json& material) {
  constexpr int kAround = 20, kDown = 12;
  constexpr double kPi = 3.14159265358979323846;
  Part part;
  part.node = node;
  part.material = material;
  for (int j = 0; j <= kDown; ++j) {
    for (int i = 0; i <= kAround; ++i) {
      const double theta = kPi * j / kDown, phi = 2.0 * kPi * (i % kAround) / kAround;
      const Vec n = {std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi)};
      addCorner(part, {middle[0] + radius * n[0], middle[1] + radius * n[1], middle[2] + radius * n[2]}, n,
                static_cast<double>(i) / kAround, static_cast<double>(j) / kDown);
      if (i == kAround || j == kDown) continue;
      const auto a = static_cast<std::uint16_t>(j * (kAround + 1) + i), b = static_cast<std::uint16_t>(a + kAround + 1);
      const auto put = [&](int x, int y, int z) {
        for (const int k : {x, y, z}) part.indices.push_back(static_cast<std::uint16_t>(k));
      };
      if (j > 0) put(a, b + 1, a + 1);
      if (j < kDown - 1) put(a, b, b + 1);
    }
  }
  return part;
}

Json paint(const std::string& name, const std::vector<double>& color, double metallic, double roughness) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {color[0], color[1], color[2], color.size() > 3 ? color[3] : 1.0}},
            {"metallicFactor", metallic},
            {"roughnessFactor", roughness}}}};
}

/// A square picture whose texels are all of another colour. Kinds: 0 colours, 1 normals, 2 occlusion, roughness and
/// metalness, 3 holes in alpha.
std::string pictureBytes(int kind) {
  ImageRgba8 image;
  image.width = image.height = 8;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const int n = (x * 37 + y * 61 + x * y * 11) % 97;
      std::array<int, 4> texel = {80 + n, 230 - 2 * n + 3 * x, 60 + 14 * y + n / 2, 255};
      if (kind == 1) texel = {128 + (n - 48) / 2, 128 + (x * 5 - y * 3), 240, 255};
      if (kind == 2) texel = {255 - n, 90 + n, 130 + x * 9, 255};
      if (kind == 3) texel[3] = n % 3 == 0 ? 30 : 240 - n;
      for (const int channel : texel) image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(channel, 0, 255)));
    }
  }
  return encodePng("baseline", image);
}

Json texture(int index, double scaleU = 1.0, double scaleV = 1.0, double rotation = 0.0, double u = 0.0,
             double v = 0.0) {
  Json texture = {{"index", index}};
  if (scaleU != 1.0) {
    texture["extensions"]["KHR_texture_transform"] = {
        {"scale", {scaleU, scaleV}}, {"rotation", rotation}, {"offset", {u, v}}};
  }
  return texture;
}

std::string gltf(const std::vector<Part>& parts, const Json& more = Json::object()) {
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  std::string bytes;
  Json accessors = Json::array(), views = Json::array(), meshes = Json::array(), nodes = Json::array(),
       materials = Json::array(), roots = Json::array();
  const auto add = [&](const void* data, std::size_t size, int type, const char* shape, std::size_t count, int target) {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}, {"target", target}});
    bytes.append(static_cast<const char*>(data), size);
    while (bytes.size() % 4 != 0) bytes += '\0';
    accessors.push_back({{"bufferView", views.size() - 1}, {"componentType", type}, {"count", count}, {"type", shape}});
    return accessors.size() - 1;
  };
  const auto addFloats = [&](const std::vector<float>& values, std::size_t each) {
    const char* shape = each == 2 ? "VEC2" : each == 3 ? "VEC3" : "VEC4";
    return add(values.data(), values.size() * sizeof(float), 5126, shape, values.size() / each, 34962);
  };
  for (const Part& part : parts) {
    Json attributes;
    attributes["POSITION"] = addFloats(part.positions, 3);
    Json least = Json::array(), greatest = Json::array();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float low = part.positions[axis], high = low;
      for (std::size_t i = axis; i < part.positions.size(); i += 3) {
        low = std::min(low, part.positions[i]);
        high = std::max(high, part.positions[i]);
      }
      least.push_back(low);
      greatest.push_back(high);
    }
    accessors.back()["min"] = least;
    accessors.back()["max"] = greatest;
    attributes["NORMAL"] = addFloats(part.normals, 3);
    attributes["TEXCOORD_0"] = addFloats(part.texcoords, 2);
    if (!part.colors.empty()) attributes["COLOR_0"] = addFloats(part.colors, 4);
    const std::size_t indices = add(part.indices.data(), part.indices.size() * sizeof(std::uint16_t), 5123, "SCALAR",
                                    part.indices.size(), 34963);
    Json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", materials.size()}};
    materials.push_back(part.material);
    meshes.push_back({{"primitives", Json::array({primitive})}});
    roots.push_back(nodes.size());
    nodes.push_back({{"name", part.node}, {"mesh", meshes.size() - 1}});
  }
  // A camera and a light of the model's own, placed by a node that is turned.
  json["cameras"] = Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1.13}, {"znear", 0.07}}}}});
  json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "spot"},
                    {"color", {0.9, 0.7, 0.5}},
                    {"intensity", 1900.0},
                    {"range", 7.5},
                    {"spot", {{"innerConeAngle", 0.31}, {"outerConeAngle", 0.83}}}}});
  roots.push_back(nodes.size());
  nodes.push_back({{"name", "view"},
                   {"camera", 0},
                   {"translation", {2.3, 1.7, 2.1}},
                   {"rotation", {-0.1386, 0.4056, 0.0623, 0.9013}}});
  roots.push_back(nodes.size());
  nodes.push_back({{"name", "spot"},
                   {"translation", {1.9, 2.6, 1.2}},
                   {"rotation", {-0.6, 0.2, 0.1, 0.7681}},
                   {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  json["extensionsUsed"] = {"KHR_lights_punctual"};
  json["scenes"] = Json::array({{{"nodes", roots}}});
  json["nodes"] = nodes;
  json["meshes"] = meshes;
  json["materials"] = materials;
  json["accessors"] = accessors;
  json["bufferViews"] = views;
  json["buffers"] =
      Json::array({{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
  for (const auto& [key, value] : more.items()) json[key] = value;
  return json.dump();
}

const Vec kLow = {-2.3, 0.2, -1.7}, kHigh = {3.1, 2.9, 2.6};

std::vector<Part> roomParts() {
  const auto with = [](Json material, const char* extension, const Json& values) {
    material["extensions"][extension] = values;
    return material;
  };
  Json west = paint("west", {0.71, 0.83, 0.69}, 0.0, 0.72);
  west["pbrMetallicRoughness"]["baseColorTexture"] = texture(0, 0.83, 1.27, 0.41, 0.13, 0.29);
  Json east = paint("east", {0.24, 0.62, 0.31}, 0.0, 0.54);
  east["emissiveFactor"] = {0.31, 0.22, 0.07};
  east["emissiveTexture"] = texture(0, 1.7, 0.6, -0.3, 0.2, 0.4);
  Json floor = paint("floor", {0.83, 0.78, 0.66}, 0.93, 0.13);
  floor["occlusionTexture"] = texture(2, 0.7, 1.9, 0.4, 0.2, 0.6);
  floor["occlusionTexture"]["strength"] = 0.81;
  Json ceiling = paint("ceiling", {0.91, 0.93, 0.87}, 0.0, 0.97);
  Json north = with(paint("north", {0.63, 0.66, 0.74}, 0.86, 0.31), "KHR_materials_anisotropy",
                    {{"anisotropyStrength", 0.73}, {"anisotropyRotation", 0.57}});
  Json south = paint("south", {0.58, 0.47, 0.12}, 0.9, 0.93);
  south["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture(2, 0.9, 1.4, 0.2, 0.3, 0.1);
  south["occlusionTexture"] = texture(2);
  south["occlusionTexture"]["strength"] = 0.77;
  Json coated =
      with(paint("coated", {0.42, 0.06, 0.29}, 0.08, 0.61), "KHR_materials_clearcoat",
           {{"clearcoatFactor", 0.74}, {"clearcoatRoughnessFactor", 0.09}, {"clearcoatNormalTexture", {{"index", 1}}}});
  coated["normalTexture"] = texture(1, 2.1, 1.3, 0.7, 0.1, 0.6);
  coated["normalTexture"]["scale"] = 0.63;
  Json film = with(paint("film", {0.93, 0.86, 0.71}, 0.81, 0.17), "KHR_materials_iridescence",
                   {{"iridescenceFactor", 0.87},
                    {"iridescenceIor", 1.37},
                    {"iridescenceThicknessMinimum", 120.0},
                    {"iridescenceThicknessMaximum", 410.0}});
  Json cloth = with(paint("cloth", {0.13, 0.21, 0.33}, 0.0, 0.83), "KHR_materials_sheen",
                    {{"sheenColorFactor", {0.81, 0.53, 0.37}}, {"sheenRoughnessFactor", 0.43}});
  Json glass =
      with(paint("glass", {0.88, 0.94, 0.91}, 0.0, 0.04), "KHR_materials_transmission", {{"transmissionFactor", 0.93}});
  glass = with(glass, "KHR_materials_ior", {{"ior", 1.37}});
  glass = with(glass, "KHR_materials_volume",
               {{"thicknessFactor", 0.46}, {"attenuationDistance", 0.92}, {"attenuationColor", {0.35, 0.71, 0.52}}});
  Json drop = glass;
  drop["name"] = "drop";
  drop["pbrMetallicRoughness"]["roughnessFactor"] = 0.0;
  Json pane =
      with(paint("pane", {0.67, 0.85, 0.93}, 0.0, 0.07), "KHR_materials_transmission", {{"transmissionFactor", 0.79}});
  Json lace = paint("lace", {0.91, 0.83, 0.77}, 0.0, 0.66);
  lace["pbrMetallicRoughness"]["baseColorTexture"] = texture(3);
  lace["alphaMode"] = "MASK";
  lace["alphaCutoff"] = 0.41;
  lace["doubleSided"] = true;
  Json veil = paint("veil", {0.87, 0.31, 0.22, 0.43}, 0.0, 0.28);
  veil["alphaMode"] = "BLEND";
  Json edge = with(paint("edge", {0.21, 0.35, 0.27}, 0.0, 0.19), "KHR_materials_specular",
                   {{"specularFactor", 0.64}, {"specularColorFactor", {0.9, 0.7, 0.4}}});
  std::vector<Part> parts;
  const Json walls[] = {west, east, floor, ceiling, north, south};
  for (int i = 0; i < 6; ++i) {
    const Json& wall = walls[i];
    parts.push_back(block(wall["name"], kLow, kHigh, wall, i));
  }
  parts.push_back(block("pillar", {-1.41, 0.2, 0.38}, {-0.81, 1.73, 0.94}, coated));
  Part& pillar = parts.back();
  for (std::size_t i = 0; i < pillar.positions.size() / 3; ++i) {
    for (const double c : {0.9 - 0.02 * static_cast<double>(i), 0.6 + 0.015 * static_cast<double>(i), 0.8, 1.0}) {
      pillar.colors.push_back(static_cast<float>(c));
    }
  }
  parts.push_back(ball("bubble", {-0.35, 0.63, -0.85}, 0.43, film));
  parts.push_back(block("cushion", {-1.9, 0.2, -1.3}, {-1.1, 0.71, -0.55}, cloth));
  parts.push_back(block("glass", {0.89, 0.2, -0.62}, {1.66, 0.95, 0.09}, glass));
  parts.push_back(ball("drop", {0.35, 0.52, 0.55}, 0.31, drop));
  parts.push_back(block("pane", {0.55, 0.2, -1.35}, {1.95, 1.55, -1.34}, pane));
  parts.push_back(block("lace", {-0.75, 1.25, -1.12}, {0.25, 2.05, -1.11}, lace));
  parts.push_back(block("veil", {-0.2, 0.9, 1.06}, {0.4, 1.5, 1.07}, veil));
  parts.push_back(block("step", {0.05, 0.2, 1.45}, {0.75, 0.43, 2.1}, edge));
  parts.push_back(
      block("mover", {-0.57, 0.2, 0.99}, {-0.17, 0.67, 1.46}, paint("toy", {0.93, 0.55, 0.07}, 0.04, 0.36)));
  parts.push_back(
      block("mirror", {-2.27, 0.6, -1.1}, {0.0, 2.2, 1.7}, paint("silver", {0.93, 0.91, 0.88}, 1.0, 0.02), 0));
  return parts;
}

Json roomImages() {
  Json more = {{"images", Json::array()}, {"textures", Json::array()}};
  for (int kind = 0; kind < 4; ++kind) {
    more["images"].push_back({{"uri", "data:image/png;base64," + base64(pictureBytes(kind))}});
    more["textures"].push_back({{"source", kind}});
  }
  return more;
}

/// Every length times `scale`, then moved by `shift`.
struct Placed {
  double scale = 1.0;
  Vec shift{};
  Json at(double x, double y, double z) const {
    return {scale * x + shift[0], scale * y + shift[1], scale * z + shift[2]};
  }
  Json box(const Vec& low, const Vec& high) const {
    return {{"min", at(low[0], low[1], low[2])}, {"max", at(high[0], high[1], high[2])}};
  }
  Json lengths(double x, double y, double z) const { return {scale * x, scale * y, scale * z}; }
};

/// `all`: with the glass and the mirror.
Json roomScene(const Placed& p, const Json& model, bool all = false) {
  const auto probe = [&](const char* name, const Json& origin, const Json& box, const Json& influence,
                         const Json& blendMin, const Json& blendMax) {
    return Json{{"name", name},
                {"origin", origin},
                {"box", box},
                {"influence", influence},
                {"blendDistance", {{"min", blendMin}, {"max", blendMax}}},
                {"near", 0.01 * p.scale},
                {"far", 1000.0 * p.scale},
                {"faceSize", 32},
                {"filterSamples", 24}};
  };
  Json scene = {{"format", "boxprobe-scene"}, {"version", 1}, {"models", Json::array({model})}};
  scene["sky"] = {{"top", {0.12, 0.31, 0.67}}, {"horizon", {0.81, 0.74, 0.58}}, {"ground", {0.17, 0.09, 0.05}}};
  scene["cameras"]["main"] = {
      {"position", p.at(2.4, 1.85, 2.2)}, {"target", p.at(-0.65, 0.55, -0.3)}, {"verticalFovDegrees", 67}};
  scene["cameras"]["low"] = {{"position", p.at(-1.7, 0.55, 2.3)},
                             {"target", p.at(1.1, 0.75, -1.2)},
                             {"up", {0.07, 1, 0.04}},
                             {"verticalFovDegrees", 71}};
  scene["cameras"]["level"] = {
      {"position", p.at(2.1, 1.6, 2.3)}, {"target", p.at(-0.4, 0.9, -0.5)}, {"parallelHeight", 3.3 * p.scale}};
  const double strength = p.scale * p.scale;
  scene["lights"] = Json::array({{{"type", "directional"},
                                  {"direction", {-0.42, -0.83, -0.27}},
                                  {"color", {0.97, 0.91, 0.79}},
                                  {"intensity", 0.63},
                                  {"angleDegrees", 2.3}},
                                 {{"type", "point"},
                                  {"position", p.at(-0.9, 2.35, -0.75)},
                                  {"color", {0.86, 0.69, 0.44}},
                                  {"intensity", 1.7 * strength},
                                  {"range", 6.2 * p.scale},
                                  {"radius", 0.06 * p.scale}},
                                 {{"type", "spot"},
                                  {"position", p.at(2.6, 2.5, -1.1)},
                                  {"direction", {-0.61, -0.72, 0.38}},
                                  {"color", {0.54, 0.77, 0.95}},
                                  {"intensity", 2.9 * strength},
                                  {"innerConeDegrees", 17},
                                  {"outerConeDegrees", 41},
                                  {"range", 8.4 * p.scale},
                                  {"radius", 0.04 * p.scale}}});
  scene["objects"] = {{"mover", {{"dynamic", true}}}, {"step", {{"probeMode", "blend"}}}};
  if (all) scene["mirrors"] = {{"mirror", Json::object()}};
  Json a =
      probe("a", p.at(-0.95, 1.25, -0.3), p.box({-2.3, 0.2, -1.7}, {3.05, 2.85, 2.55}),
            p.box({-2.45, 0.05, -1.85}, {1.15, 2.97, 2.72}), p.lengths(0.21, 0.34, 0.47), p.lengths(0.93, 0.58, 0.71));
  Json b =
      probe("b", p.at(1.45, 1.62, 0.85), p.box({-2.25, 0.23, -1.68}, {3.1, 2.9, 2.6}),
            p.box({-0.62, 0.01, -1.93}, {3.27, 3.04, 2.81}), p.lengths(1.06, 0.29, 0.52), p.lengths(0.37, 0.66, 0.83));
  Json c =
      probe("c", p.at(0.35, 1.18, 0.15), p.box({-1.9, 0.2, -1.6}, {2.7, 2.9, 2.5}),
            p.box({-0.75, -0.04, -0.68}, {1.85, 1.42, 1.37}), p.lengths(0.44, 0.18, 0.61), p.lengths(0.27, 0.53, 0.39));
  b["bounces"] = 2;
  c["rotationDegrees"] = {0, 23, 0};
  c["importance"] = 2;
  c["intensity"] = 0.87;
  c["hides"] = {all ? "drop" : "cushion"};
  scene["probes"] = Json::array({a, b, c});
  return scene;
}

/// In inches, z up: x stays, y becomes z, z becomes -y.
void writeInches(const std::string& folder, const std::vector<Part>& parts) {
  std::ostringstream obj, mtl;
  obj.precision(9);
  mtl.precision(9);
  obj << "mtllib inches.mtl\n";
  std::size_t first = 1;
  for (const Part& part : parts) {
    const Json& base = part.material["pbrMetallicRoughness"];
    const auto color = base["baseColorFactor"].get<std::vector<double>>();
    const std::string name = part.material["name"];
    mtl << "newmtl " << name << "\nKd " << color[0] << ' ' << color[1] << ' ' << color[2] << "\nPr "
        << base["roughnessFactor"].get<double>() << "\nPm " << base["metallicFactor"].get<double>() << '\n';
    obj << "o " << part.node << "\nusemtl " << name << '\n';
    const double inch = 1.0 / 0.0254;
    for (std::size_t i = 0; i < part.positions.size(); i += 3) {
      const auto at = [&](std::size_t axis) { return static_cast<double>(part.positions[i + axis]) * inch; };
      obj << "v " << at(0) << ' ' << -at(2) << ' ' << at(1) << '\n';
      obj << "vn " << part.normals[i] << ' ' << -part.normals[i + 2] << ' ' << part.normals[i + 1] << '\n';
    }
    for (std::size_t i = 0; i < part.indices.size(); i += 3) {
      obj << 'f';
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t index = first + part.indices[i + k];
        obj << ' ' << index << "//" << index;
      }
      obj << '\n';
    }
    first += part.positions.size() / 3;
  }
  writeText(folder + "/inches.obj", obj.str());
  writeText(folder + "/inches.mtl", mtl.str());
}

/// A plan of walls a quarter thick: two rooms joined by a doorway with a lintel, and a low store beside them.
std::vector<Part> hallParts(double scale) {
  std::vector<Part> parts;
  const auto add = [&](const char* node, Vec low, Vec high, const Json& material) {
    for (double& x : low) x *= scale;
    for (double& x : high) x *= scale;
    parts.push_back(block(node, low, high, material));
  };
  const Json plaster = paint("plaster", {0.8, 0.75, 0.7}, 0.0, 0.7), tiles = paint("tiles", {0.5, 0.5, 0.6}, 0.0, 0.15);
  add("ground", {-0.2, -0.2, -0.2}, {9.4, 0.0, 6.3}, tiles);
  add("roof", {-0.2, 3.1, -0.2}, {9.4, 3.3, 6.3}, plaster);
  add("west wall", {-0.2, 0.0, -0.2}, {0.0, 3.1, 6.3}, plaster);
  add("east wall", {9.2, 0.0, -0.2}, {9.4, 3.1, 6.3}, plaster);
  add("north wall", {0.0, 0.0, -0.2}, {9.2, 3.1, 0.0}, plaster);
  add("south wall", {0.0, 0.0, 6.1}, {9.2, 3.1, 6.3}, plaster);
  add("partition", {5.1, 0.0, 0.0}, {5.35, 3.1, 2.2}, plaster);
  add("partition", {5.1, 0.0, 3.25}, {5.35, 3.1, 6.1}, plaster);
  add("lintel", {5.1, 2.15, 2.2}, {5.35, 3.1, 3.25}, plaster);
  add("store wall", {5.35, 0.0, 4.1}, {6.7, 3.1, 4.3}, plaster);
  add("store wall", {7.55, 0.0, 4.1}, {9.2, 3.1, 4.3}, plaster);
  add("store lintel", {6.7, 1.95, 4.1}, {7.55, 3.1, 4.3}, plaster);
  add("store ceiling", {5.35, 2.3, 4.3}, {9.2, 2.4, 6.1}, plaster);
  add("dais", {3.1, 0.0, 3.6}, {5.1, 0.21, 6.1}, plaster);
  add("cupboard", {0.0, 0.0, 0.0}, {1.6, 2.0, 0.6}, plaster);
  return parts;
}

}  // namespace

void writeBaselineScenes(const std::string& folder) {
  const std::vector<Part> parts = roomParts();
  writeText(folder + "/odd.gltf", gltf(parts, roomImages()));
  const auto write = [&](const std::string& name, const Json& scene) {
    writeText(folder + "/" + name + ".boxprobe.json", scene.dump(1));
  };
  // Walls and blocks alone, and no textures: few programs to compile.
  std::vector<Part> few(parts.begin(), parts.begin() + 7);
  for (const char* node : {"cushion", "step", "mover"}) {
    few.push_back(*std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.node == node; }));
  }
  for (Part& part : few) {
    const Json base = part.material["pbrMetallicRoughness"];
    part.colors.clear();
    part.material =
        paint(part.material["name"], base["baseColorFactor"], base["metallicFactor"], base["roughnessFactor"]);
  }
  writeText(folder + "/plain.gltf", gltf(few));
  write("odd", roomScene({}, {{"file", "odd.gltf"}}, true));
  Json finish = roomScene({}, {{"file", "odd.gltf"}});
  finish["probes"].erase(1);
  finish["probes"].erase(1);
  finish["probes"][0].erase("influence");
  write("finish", finish);
  write("plain", roomScene({}, {{"file", "plain.gltf"}}));
  const Placed far{1.0, {31250.0, -407.5, 18734.0}};
  write("far", roomScene(far, {{"file", "plain.gltf"}, {"translation", far.at(0, 0, 0)}}));
  for (const auto& [name, scale] : {std::pair("big", 100.0), std::pair("small", 0.01)}) {
    write(name, roomScene({scale, {}}, {{"file", "plain.gltf"}, {"scale", scale}}));
  }
  writeInches(folder, few);
  Json inches = roomScene({}, {{"file", "inches.obj"}, {"unit", "in"}, {"upAxis", "z"}});
  inches["objects"] = {{"pillar", {{"translation", {0.21, 0.0, -0.13}}, {"rotationDegrees", {3, 17, -5}}}}};
  write("inches", inches);
  Json bare = roomScene({}, {{"file", "plain.gltf"}});
  for (const char* key : {"cameras", "lights"}) bare.erase(key);
  bare["probes"].erase(1);
  bare["probes"].erase(1);
  bare["probes"][0].erase("influence");
  write("bare", bare);
  for (const auto& [name, scale] : {std::pair("halls", 1.0), std::pair("halls-cm", 100.0)}) {
    const std::string file = std::string(name) + ".gltf";
    writeText(folder + "/" + file, gltf(hallParts(scale)));
    const Placed p{scale, {}};
    Json scene = {{"format", "boxprobe-scene"}, {"version", 1}, {"model", file}};
    scene["cameras"]["main"] = {{"position", p.at(1.2, 1.6, 4.7)}, {"target", p.at(8.0, 1.0, 2.4)}};
    scene["probes"] = Json::array({{{"name", "first"},
                                    {"origin", p.at(2.4, 1.5, 3.3)},
                                    {"box", p.box({0.3, 0.1, 0.2}, {4.9, 2.9, 5.8})},
                                    {"faceSize", 32}}});
    write(name, scene);
  }
}

}  // namespace boxprobe::test
