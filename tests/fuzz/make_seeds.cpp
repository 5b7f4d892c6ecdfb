// Writes the inputs that fuzzing starts from: one small file of each kind the readers know. Run by hand when a reader
// learns a new kind: fuzz_seeds FOLDER fills FOLDER/scene, FOLDER/cube and FOLDER/model; what fuzzing makes of them,
// minimised, is what tests/fuzz/corpus holds.
#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "filters/core/base/errors.h"
#include "filters/io/cube/cube_file.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/unit/io_glb_builder.h"

namespace {

using namespace boxprobe;
namespace fs = std::filesystem;
using Json = nlohmann::json;

fs::path folder;

void write(const std::string& name, const std::string& bytes) {
  std::ofstream(folder / name, std::ios::binary) << bytes;
}

std::string bytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Scene fullScene() {
  Scene scene;
  scene.models = {{"a.glb", {1, 2, 3}, {0, 90, 0}, 0.5}, {"b/c.gltf", {}, {}, 1.0}};
  scene.cameras = {Camera(), {"side", {1, 2, 3}, {0, 0, 0.5}, {0, 1, 0.1}, 50.0}};
  Light point;
  point.type = LightType::Point;
  point.position = {0, 2, 0};
  scene.lights = {Light(), point};
  MaterialOverride& floor = scene.materials["floor"];
  floor.baseColor = glm::vec3(0.5f);
  floor.metallic = 1.0f;
  floor.roughness = 0.25f;
  floor.emissive = glm::vec3(0, 0, 1);
  floor.ior = 1.4f;
  floor.transmission = 0.5f;
  floor.thickness = 0.1f;
  floor.attenuationColor = glm::vec3(0.9f, 0.5f, 0.4f);
  floor.glass = GlassForm::TwoPass;
  ObjectOverride& ball = scene.objects["ball"];
  ball.visible = false;
  ball.dynamic = true;
  ball.probeUsage = ProbeUsage::Simple;
  ball.translation = {1, 0, 2};
  scene.mirrors["wall"].maxRoughness = 0.2;
  scene.skyRotationDegrees = 30.0;
  scene.lights[0].shadows = LightShadows::CoverageAndMap;
  Probe probe;
  probe.name = "room";
  probe.rotationDegrees = {0, 30, 0};
  probe.influence = Box{{-3, -1, -2}, {2, 1, 2}};
  probe.clear = ClearToOpen();
  probe.technique = "sphere+ray_sample";
  probe.parameters = {{"samples", 16.0}, {"filtered", true}, {"pattern", std::string("blue")}};
  probe.hides = {"ball", "a/b"};
  probe.bevel = Bevel{0.1, 0.3};
  probe.occlusion = BoxOcclusion{1, 2, 0.5};
  probe.lattice = ProbeLattice{true, 0.7};
  scene.probes = {probe};
  probe.name = "hall";
  probe.clear = glm::vec3(1, 0.5f, 0);
  probe.mode = ProbeMode::Custom;
  probe.image = "sky.exr";
  probe.imageLayout = CubeLayout::Cross;
  probe.cubeView = CubeView::Inside;
  probe.imageRotationDegrees = 90.0;
  probe.encoding = ImageEncoding::Rgbm;
  probe.decode = glm::dvec2(34.5, 2.2);
  probe.filter = FilterKind::Gaussian;
  scene.probes.push_back(probe);
  return scene;
}

void makeScenes() {
  Scene scene = fullScene();
  write("scene/full", sceneText(scene, ""));
  scene.sky = SkyColor{glm::vec3(1, 2, 3)};
  scene.models.resize(1);
  scene.probes.clear();
  write("scene/color", sceneText(scene, ""));
  scene.sky = SkyImage{"/sky.hdr", CubeView::Inside, SkySunForm::InPicture};
  write("scene/image", sceneText(scene, ""));
}

CubeMap gradientCube(int faceSize, int levels) {
  CubeMap cube(faceSize, levels);
  for (int level = 0; level < levels; ++level) {
    const int count = 6 * 4 * cube.levelSize(level) * cube.levelSize(level);
    for (int i = 0; i < count; ++i) cube.face(level, 0)[i] = 0.25f * static_cast<float>(i % 37) + 0.5f;
  }
  return cube;
}

void makeCubes() {
  const CubeMap cube = gradientCube(8, 1);
  BakedProbeFile baked;
  baked.maps.radiance = gradientCube(8, 4);
  baked.maps.distance = gradientCube(4, 1);
  baked.info.probe = fullScene().probes.front();
  baked.info.inputHash = "a b c";
  baked.info.program = "Boxprobe";
  saveBakedProbe((folder / "cube/baked.exr").string(), baked);
  CubePictureOptions options;
  options.distance = &baked.maps.distance;
  saveCubePicture((folder / "cube/latlong.exr").string(), cube, CubeLayout::LatLong, options);
  saveCubePicture((folder / "cube/strip.exr").string(), cube, CubeLayout::Strip);
  saveCubePicture((folder / "cube/cross.exr").string(), cube, CubeLayout::Cross);
  const Imf::Rgba* pixels = nullptr;
  Imf::Array<Imf::Rgba> grey(12 * 6);
  for (int i = 0; i < 12 * 6; ++i) grey[i] = Imf::Rgba(0.1f * static_cast<float>(i), 1.0f, 2.0f);
  pixels = grey;
  for (const auto& [name, compression] :
       std::initializer_list<std::pair<const char*, Imf::Compression>>{{"none", Imf::NO_COMPRESSION},
                                                                       {"rle", Imf::RLE_COMPRESSION},
                                                                       {"zips", Imf::ZIPS_COMPRESSION},
                                                                       {"piz", Imf::PIZ_COMPRESSION},
                                                                       {"pxr24", Imf::PXR24_COMPRESSION},
                                                                       {"b44", Imf::B44_COMPRESSION},
                                                                       {"dwaa", Imf::DWAA_COMPRESSION}}) {
    Imf::Header header(12, 6);
    header.compression() = compression;
    Imf::RgbaOutputFile file((folder / "cube" / (std::string(name) + ".exr")).string().c_str(), header,
                             Imf::WRITE_RGBA);
    file.setFrameBuffer(pixels, 1, 12);
    file.writePixels(6);
  }
  const auto lines = [](const std::string& line) { return line + line + line + line; };
  write("cube/old-runs.hdr", "#?RADIANCE\nEXPOSURE=2\n\n-Y 4 +X 8\n" + lines(std::string("\x80\x40\x20\x82\1\1\1\7")));
  write("cube/new-runs.hdr", "#?RGBE\r\nFORMAT=32-bit_rle_xyze\r\nCOLORCORR=1 2 .5\r\n\r\n+Y 4 -X 8\r\n" +
                                 lines(std::string("\2\2\0\10\x88\x80\4\x10\x20\x30\x40\x84\x55\x88\x30\x88\x81", 17)));
  std::string columns;
  for (int i = 0; i < 32; ++i) columns += "\x80\x40\x20\x91";
  write(
      "cube/columns.hdr",
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nPRIMARIES=.708 .292 .17 .797 .131 .046 .3127 .329\n\n+X 8 -Y 4\n" + columns);
  write("cube/flat.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n" + std::string(32, '\x80'));
}

/// The triangle with a probe, its map, a lattice, a lamp and a picture inside.
void makeProbes(const std::string& triangle) {
  write("triangle.glb", triangle);
  write("sky.hdr", "not read here");
  GlbScene content;
  content.scene =
      parseScene(R"({"format": "boxprobe-scene", "version": 1, "model": "triangle.glb", "sky": {"image": "sky.hdr"},
      "probes": [{"name": "a", "origin": [0.1, 0.2, 0.3], "box": {"min": [-1, -2, -3], "max": [3, 2, 1]}, "faceSize": 16}]})",
                 (folder / "a.boxprobe.json").string(), folder.string());
  BakedProbeFile baked;
  baked.maps.radiance = gradientCube(2, 2);
  baked.maps.distance = gradientCube(1, 1);
  baked.info.probe = content.scene.probes.front();
  baked.info.inputHash = "00112233 4455 - -";
  content.maps = {baked};
  ProbeDiffuse diffuse;
  DiffuseLattice lattice;
  lattice.nodes = {2, 2, 2};
  lattice.low = glm::vec3(-1.0f);
  lattice.high = glm::vec3(1.0f);
  lattice.texels.assign(7 * 8, glm::vec4(0.5f));
  diffuse.lattice = std::make_shared<DiffuseLattice>(lattice);
  SceneLamp lamp;
  lamp.corners = {{0, 1, 0}, {1, 1, 0}, {0, 1, 1}};
  diffuse.lamps = {lamp};
  content.diffuse.probes = {diffuse};
  const auto model = std::make_shared<const Model>(loadModelFile((folder / "triangle.glb").string()));
  write("model/probes", glbWithProbes(content, {model}, "probes.glb"));
  for (const char* name : {"triangle.glb", "sky.hdr"}) fs::remove(folder / name);
}

void makeModels() {
  GlbBuilder plain;
  plain.triangle();
  write("model/triangle", plain.glb());
  makeProbes(plain.glb());

  ImageRgba8 image;
  image.width = image.height = 4;
  image.pixels.assign(64, 200);
  const std::string png = (folder / "model/picture.png").string();
  savePng(png, image);
  const std::string encoded = bytesOf(png);
  fs::remove(png);

  GlbBuilder rich;
  const int picture = rich.view(std::vector<unsigned char>(encoded.begin(), encoded.end()));
  const int indices = rich.accessor(rich.view(std::vector<std::uint8_t>{0, 1, 2, 3}), GlbBuilder::UByte, "SCALAR", 4);
  const int normals =
      rich.accessor(rich.view(std::vector<std::int8_t>{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 1, 0, 0}),
                    GlbBuilder::Byte, "VEC3", 4);
  rich.json["accessors"][normals]["normalized"] = true;
  rich.json["bufferViews"][rich.json["accessors"][normals]["bufferView"].get<int>()]["byteStride"] = 4;
  const int positions = rich.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const int sparseIndex = rich.view(std::vector<std::uint16_t>{1});
  const int sparseValue = rich.view(std::vector<float>{2, 0, 0});
  rich.json["accessors"][positions]["sparse"] = {{"count", 1},
                                                 {"indices", {{"bufferView", sparseIndex}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", sparseValue}}}};
  const int uv = rich.floats("VEC2", 2, {0, 0, 1, 0, 0, 1, 1, 1});
  const int tangents = rich.floats("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1});
  rich.json["images"] = Json::array({{{"bufferView", picture}, {"mimeType", "image/png"}}});
  rich.json["samplers"] = Json::array({{{"wrapS", 33071}, {"wrapT", 33648}}});
  rich.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
  rich.json["materials"] = Json::array(
      {{{"name", "paint"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {1, 0.5, 0.25, 1}}, {"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.3}}},
        {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
        {"occlusionTexture", {{"index", 0}, {"strength", 0.5}}},
        {"emissiveFactor", {1, 0, 0}},
        {"alphaMode", "BLEND"},
        {"doubleSided", true},
        {"extensions",
         {{"KHR_materials_emissive_strength", {{"emissiveStrength", 3}}},
          {"KHR_materials_ior", {{"ior", 1.4}}},
          {"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
          {"KHR_materials_unlit", Json::object()}}}}});
  rich.json["extensionsUsed"] = {"KHR_materials_ior"};
  const int mesh = rich.mesh(
      {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uv}, {"TANGENT", tangents}}},
       {"indices", indices},
       {"material", 0},
       {"mode", 5}});
  rich.node({{"name", "root"},
             {"scale", {-1, 1, 1}},
             {"rotation", {0, 0, 0, 1}},
             {"translation", {0, 1, 0}},
             {"children", {1}}});
  rich.json["nodes"].push_back({{"mesh", mesh}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  write("model/rich", rich.glb());

  // No tangents for its normal map, two sets of coordinates, colours, a lamp, a camera, everything transformed.
  GlbBuilder features;
  const int png2 = features.view(std::vector<unsigned char>(encoded.begin(), encoded.end()));
  features.json["images"] = Json::array({{{"bufferView", png2}, {"mimeType", "image/png"}}});
  features.json["textures"] = Json::array({{{"source", 0}}});
  const Json moved = {
      {"index", 0},
      {"texCoord", 1},
      {"extensions",
       {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}, {"scale", {2, -1}}, {"rotation", 0.7}, {"texCoord", 0}}}}}};
  features.json["materials"] = Json::array(
      {{{"alphaMode", "MASK"},
        {"alphaCutoff", 0.3},
        {"pbrMetallicRoughness", {{"baseColorTexture", moved}, {"metallicRoughnessTexture", moved}}},
        {"normalTexture", {{"index", 0}}},
        {"extensions",
         {{"KHR_materials_clearcoat",
           {{"clearcoatFactor", 1},
            {"clearcoatTexture", moved},
            {"clearcoatNormalTexture", {{"index", 0}, {"scale", 2}}}}},
          {"KHR_materials_transmission", {{"transmissionFactor", 0.5}, {"transmissionTexture", moved}}},
          {"KHR_materials_volume", {{"thicknessFactor", 0.5}, {"thicknessTexture", moved}}}}}},
       {{"extensions",
         {{"KHR_materials_specular", {{"specularColorFactor", {1, 0.5, 2}}, {"specularTexture", moved}}},
          {"KHR_materials_sheen", {{"sheenColorFactor", {1, 0.5, 0}}, {"sheenRoughnessTexture", moved}}},
          {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}, {"anisotropyTexture", moved}}},
          {"KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceThicknessTexture", moved}}}}}}});
  const Json corners = {{"POSITION", features.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})},
                        {"NORMAL", features.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
                        {"TEXCOORD_0", features.floats("VEC2", 2, {0, 0, 1, 0, 0, 1, 0, 0})},
                        {"TEXCOORD_1", features.floats("VEC2", 2, {0, 0, 1, 0, 0, 1, 1, 1})},
                        {"COLOR_0", features.floats("VEC3", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1})}};
  const int order =
      features.accessor(features.view(std::vector<std::uint16_t>{0, 1, 2, 2, 1, 3}), GlbBuilder::UShort, "SCALAR", 6);
  const int part = features.mesh({{"attributes", corners}, {"indices", order}, {"material", 0}});
  features.json["cameras"] = Json::array(
      {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}},
       {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 10}}}}});
  features.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array(
      {{{"type", "spot"}, {"range", 5}, {"intensity", 3}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}}},
       {{"type", "directional"}}});
  features.node({{"mesh", part}, {"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  features.node({{"camera", 1}, {"scale", {-2, 1, 1}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  write("model/features", features.glb());

  Json text = plain.json;
  // 36 bytes: three positions.
  text["buffers"] = Json::array({{{"byteLength", 36},
                                  {"uri",
                                   "data:application/octet-stream;base64,"
                                   "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}});
  write("model/text", text.dump());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n"), 2;
  folder = arguments[1];
  for (const char* kind : {"scene", "cube", "model"}) fs::create_directories(folder / kind);
  try {
    makeScenes();
    makeCubes();
    makeModels();
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "fuzz_seeds: %s\n", error.what()), 1;
  }
  return 0;
}
