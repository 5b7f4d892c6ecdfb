// Pictures of cubes as they are written and read, of every layout, size and view; and everything in a baked file: value
// by value, against io_cube_values.txt.
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "filters/io/cube/cube_layout.h"
#include "filters/io/cube/cube_names.h"
#include "filters/io/cube/cube_source.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/io/image/exr_reader.h"
#include "filters/io/image/image_file.h"
#include "tests/support/kept_values.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;

class CubeValues : public TemporaryFolder {
 protected:
  ExrPicture part(const std::string& name, int index, int* compression = nullptr) const {
    ExrPicture picture;
    withExrFile(file(name), [&](Imf::MultiPartInputFile& exr) {
      picture = readExrPart(exr, index, file(name));
      if (compression != nullptr) *compression = exr.header(index).compression();
    });
    return picture;
  }
};

/// Levels of their own, channels of their own, coverage.
CubeMap oddCube(int faceSize, int levels) {
  CubeMap cube(faceSize, levels);
  for (int level = 0; level < levels; ++level) {
    const CubeMap own = cubeOf(cube.levelSize(level), 1, [level](const glm::vec3& direction) {
      const glm::vec3 d = glm::normalize(direction);
      return glm::vec3(1.3f + 0.9f * d.x - 0.2f * d.y * d.z, 0.8f + 0.5f * d.y + 0.3f * d.x * d.x,
                       2.1f - 1.1f * d.z + 0.4f * d.x * d.y) *
             (1.0f + 0.5f * static_cast<float>(level));
    });
    const int count = 6 * cube.levelSize(level) * cube.levelSize(level);
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < 3; ++c) cube.face(level, 0)[4 * i + c] = own.face(0, 0)[4 * i + c];
      cube.face(level, 0)[4 * i + 3] = 1.0f - 0.5f * static_cast<float>(i % 13) / 13.0f;
    }
  }
  return cube;
}

void addPicture(test::KeptValues& values, const std::string& label, const ExrPicture& picture) {
  const ImageRgbaF& image = picture.image;
  const double kind = picture.envmap ? (*picture.envmap == EnvmapKind::Cube ? 1 : 0) : -1;
  values.add(label, {double(image.width), double(image.height), kind});
  const std::size_t texels = image.pixels.size() / 4, rows = std::min<std::size_t>(6, std::size_t(image.height));
  for (std::size_t i = 0; i < rows; ++i) {
    values.addTexels("  part " + std::to_string(i), &image.pixels[4 * (texels / rows * i)], texels / rows);
  }
  if (picture.distance.empty()) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < texels; ++i) sum += picture.distance[i] * (1.0 + double(i * 7919 % 97) / 97.0);
  values.add("  distance", {sum / double(texels)});
}

void addCube(test::KeptValues& values, const std::string& label, const LoadedCube& loaded) {
  const int size = loaded.radiance.faceSize();
  values.add(label + ": layout " + std::to_string(static_cast<int>(loaded.layout)) + ", size " + std::to_string(size));
  for (int face = 0; face < 6; ++face) {
    values.addTexels("  face " + std::to_string(face), loaded.radiance.face(0, face), std::size_t(size) * size);
  }
  if (!loaded.distance.empty()) {
    for (int face = 0; face < 6; ++face) {
      values.addTexels("  distance " + std::to_string(face), loaded.distance.face(0, face),
                       std::size_t(loaded.distance.faceSize()) * loaded.distance.faceSize());
    }
  }
  for (const std::string& text : loaded.repairs.sentences()) values.add("  " + text);
}

TEST_F(CubeValues, EveryLayoutWrittenAndRead) {
  test::KeptValues values;
  const CubeMap cube = oddCube(32, 3);
  CubeMap distance(8, 1);
  for (int i = 0; i < 6 * 64; ++i) distance.face(0, 0)[4 * i] = 0.5f + 0.25f * static_cast<float>(i * 31 % 101);
  struct Wish {
    CubeLayout layout;
    const char* name;
    int level, faceSize;
    bool distance, exact;
  };
  const std::vector<Wish> wishes = {
      {CubeLayout::LatLong, "l0.exr", 0, 0, true, false},     {CubeLayout::LatLong, "l1.exr", 1, 12, false, true},
      {CubeLayout::Strip, "s0.exr", 0, 0, true, true},        {CubeLayout::Automatic, "s1.exr", 2, 5, false, false},
      {CubeLayout::Cross, "c0.exr", 0, 0, true, false},       {CubeLayout::Cross, "c1.exr", 1, 6, true, true},
      {CubeLayout::SixFiles, "gl_%s.exr", 0, 0, true, false}, {CubeLayout::SixFiles, "gl1_%s.exr", 1, 8, false, true},
      {CubeLayout::SixFiles, "own%.exr", 0, 10, true, false}, {CubeLayout::Strip, "one.exr", 2, 1, false, true}};
  for (const Wish& wish : wishes) {
    CubePictureOptions options;
    options.level = wish.level;
    options.faceSize = wish.faceSize;
    options.precision = wish.exact ? ExrPrecision::Float : ExrPrecision::Half;
    if (wish.distance) options.distance = &distance;
    saveCubePicture(file(wish.name), cube, wish.layout, options);
    const std::string name = wish.name;
    const std::size_t at = name.find('%');
    for (int face = 0; face < (at == std::string::npos ? 1 : 6); ++face) {
      const char* const ours[] = {"px", "nx", "py", "ny", "pz", "nz"};
      const char* const theirs[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
      const bool letter = at != std::string::npos && name[at + 1] == 's';
      const std::string own = at == std::string::npos ? name
                                                      : name.substr(0, at) + (letter ? ours[face] : theirs[face]) +
                                                            name.substr(at + (letter ? 2 : 1));
      int compression = 0;
      const ExrPicture picture = part(own, 0, &compression);
      addPicture(values, "written " + own + " " + std::to_string(compression), picture);
    }
    for (const int size : {0, 16, 64}) {
      addCube(values, "read " + name + " at " + std::to_string(size),
              loadCube(file(name), CubeLayout::Automatic, size));
    }
  }
  for (const char* name : {"c0.exr", "gl_%s.exr", "s0.exr", "own%.exr"}) {
    Probe probe;
    probe.image = file(name);
    probe.cubeView = CubeView::Inside;
    addCube(values, std::string("from inside ") + name, loadCustomCube(probe, 16));
    probe.cubeView = CubeView::Outside;
    probe.imageRotationDegrees = -400.0;
    addCube(values, std::string("turned ") + name, loadCustomCube(probe, 16));
  }
  values.expect("unit/values/io_cube_values.txt");
}

TEST_F(CubeValues, PicturesOfOtherPrograms) {
  // Without an attribute: texels at the centres of cells, OpenGL's faces; each pixel another value.
  const auto picture = [](int width, int height) {
    ImageRgbaF image;
    image.width = width;
    image.height = height;
    for (int i = 0; i < width * height; ++i) {
      const float t = static_cast<float>(i * 37 % 211);
      image.pixels.insert(image.pixels.end(), {1.0f + t, 300.0f - t, 0.5f * t, 1.0f});
    }
    return image;
  };
  test::KeptValues values;
  for (const auto& [width, height] : {std::pair{48, 24}, {24, 4}, {4, 24}, {16, 12}, {12, 16}, {49, 24}, {50, 24}}) {
    std::vector<ExtraChannel> extra(1);
    extra[0].name = "distance";
    for (int i = 0; i < width * height; ++i) extra[0].values.push_back(i == 7 ? -3.0f : 0.25f * float(i * 13 % 53));
    if (width < 30) extra[0].values[9] = std::numeric_limits<float>::infinity();
    saveExr(file("a.exr"), picture(width, height), extra);
    const CubeLayout layout = width >= 48 ? CubeLayout::LatLong : CubeLayout::Automatic;
    const std::string label = std::to_string(width) + " x " + std::to_string(height);
    for (const int size : {0, 4, 32}) {
      addCube(values, label + " at " + std::to_string(size), loadCube(file("a.exr"), layout, size));
    }
    if (width < 48) {
      addCube(values, label + " from inside", loadCube(file("a.exr"), layout, 4, {}, CubeView::Inside));
      addCube(values, label + " as it is", loadCube(file("a.exr"), layoutOfShape(width, height), 4));
    }
    SkyPictureNotes notes;
    ExrPicture sky;
    sky.image = loadSkyPicture({file("a.exr"), width == 16 ? CubeView::Inside : CubeView::Outside}, &notes);
    addPicture(values, "sky " + std::to_string(static_cast<int>(notes.layout)), sky);
  }
  // Six files, one with what is no radiance.
  const char* const names[6] = {"px", "nx", "py", "ny", "pz", "nz"};
  for (int face = 0; face < 6; ++face) {
    ImageRgbaF image = picture(4, 4);
    for (float& value : image.pixels) value += 10.0f * float(face);
    if (face == 3) image.pixels[4 * 5] = -1.0f;
    if (face == 4) image.pixels[4 * 6 + 1] = -2.0f;
    saveExr(file(std::string(names[face]) + ".exr"), image);
  }
  addCube(values, "six", loadCube(file("ny.exr"), CubeLayout::Automatic, 4));
  addCube(values, "six from inside", loadCube(file("ny.exr"), CubeLayout::SixFiles, 4, {}, CubeView::Inside));
  // As exrenvmap names them, which is asked for no view.
  saveCubePicture(file("own%.exr"), oddCube(4, 1), CubeLayout::SixFiles);
  addCube(values, "exrenvmap's", loadCube(file("own+X.exr"), CubeLayout::Automatic, 4, {}, CubeView::Inside));
  values.expect("unit/values/io_cube_pictures.txt");
}

BakedProbeFile oddBake() {
  BakedProbeFile baked;
  baked.maps.radiance = oddCube(16, 5);
  baked.maps.distance = CubeMap(8, 1);
  for (int i = 0; i < 6 * 64; ++i) baked.maps.distance.face(0, 0)[4 * i] = 0.25f * static_cast<float>(i % 100);
  for (std::size_t i = 0; i < 9; ++i) {
    const float t = static_cast<float>(i);
    baked.maps.irradiance[i] = {0.5f - 0.125f * t, 0.25f * t, 1.0f / (1.0f + t)};
  }
  baked.maps.capturedAt = {0.1, 1e6 + 1e-7, -3.5};
  baked.maps.capturedRotation = {10, 30.5, -20};
  Probe& probe = baked.info.probe;
  probe.name = "true";
  probe.origin = {1.5, 2.25, -3.1};
  probe.box = {{-1.25, -2, -3}, {4, 5, 6.1}};
  probe.influence = Box{{-1, -1.5, -2}, {1, 2, 3}};
  probe.rotationDegrees = {10, 30.5, -20};
  probe.blendDistance = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  probe.clear = glm::vec3(0.3f, 0.0f, 1.0f);
  probe.technique = "sphere";
  probe.parameters = {{"samples", 64.0}, {"animated", true}, {"pattern", std::string("blue")}};
  probe.faceSize = 16;
  probe.hides = {"lamp", "mirror [1]"};
  probe.bevel = Bevel{0.3, 1.0};
  baked.info.inputHash = "k v - -";
  baked.info.program = "Boxprobe 9";
  baked.info.renderer = "softpipe";
  return baked;
}

std::string attributeText(const Imf::Attribute& attribute) {
  std::ostringstream text;
  if (const auto* a = dynamic_cast<const Imf::IntAttribute*>(&attribute)) text << a->value();
  if (const auto* a = dynamic_cast<const Imf::DoubleAttribute*>(&attribute)) text << a->value();
  if (const auto* a = dynamic_cast<const Imf::StringAttribute*>(&attribute)) text << a->value();
  if (const auto* a = dynamic_cast<const Imf::V3fAttribute*>(&attribute)) text << a->value();
  if (const auto* a = dynamic_cast<const Imf::V3dAttribute*>(&attribute)) text << a->value();
  if (const auto* a = dynamic_cast<const Imf::StringVectorAttribute*>(&attribute)) {
    for (const std::string& each : a->value()) text << "'" << each << "' ";
  }
  if (const auto* a = dynamic_cast<const Imf::FloatVectorAttribute*>(&attribute)) {
    for (const float each : a->value()) text << each << " ";
  }
  return text.str();
}

TEST_F(CubeValues, EverythingInABakedFile) {
  test::KeptValues values;
  BakedProbeFile plain = oddBake();
  plain.maps.capturedRotation = glm::dvec3(0.0);
  plain.maps.distance = CubeMap();
  plain.info.renderer.clear();
  plain.maps.radiance.setTexel(0, 4, 3, 2, {80000.0f, -70000.0f, 1.0f, 1.0f});
  for (const bool turned : {true, false}) {
    saveBakedProbe(file("a.exr"), turned ? oddBake() : plain, turned ? ExrPrecision::Half : ExrPrecision::Float);
    values.add(turned ? "== turned" : "== plain");
    int parts = 0;
    withExrFile(file("a.exr"), [&](Imf::MultiPartInputFile& exr) {
      parts = exr.parts();
      for (int i = 0; i < parts; ++i) {
        const Imf::Header& header = exr.header(i);
        values.add("part " + std::to_string(i) + " " + header.name() + " " + header.type() + " " +
                   std::to_string(header.compression()));
        for (auto it = header.begin(); it != header.end(); ++it) {
          const std::string name = it.name(), text = attributeText(it.attribute());
          if (text.empty() || name == "checksum" || name == "name" || name == "type" || name == "chunkCount") continue;
          values.add("  " + name + " " + it.attribute().typeName() + " " + text);
        }
        const Imath::Box2i display = header.displayWindow();
        values.add("  display",
                   {double(display.min.x), double(display.min.y), double(display.max.x), double(display.max.y)});
      }
    });
    for (int i = 0; i < parts; ++i) {
      if (!turned || i + 1 < parts) addPicture(values, "part " + std::to_string(i), part("a.exr", i));
    }
    addCube(values, "as a picture", loadCube(file("a.exr")));
    addCube(values, "as a smaller picture", loadCube(file("a.exr"), CubeLayout::Strip, 8));
    addCube(values, "as a larger picture", loadCube(file("a.exr"), CubeLayout::Automatic, 32));
  }
  values.expect("unit/values/io_cube_baked.txt");
}

/// The file with bytes exchanged, of the version that had no checksum.
std::string withoutSeal(std::string bytes, const std::vector<std::pair<std::string, std::string>>& changes) {
  const std::string version("boxprobe\0int\0\4\0\0\0\2", 18);
  const std::size_t at = bytes.find(version);
  EXPECT_NE(at, std::string::npos);
  bytes[at + 17] = 1;
  bytes.replace(bytes.find("checksum"), 1, "k");
  for (const auto& [from, to] : changes) {
    EXPECT_EQ(from.size(), to.size());
    const std::size_t place = bytes.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    if (place != std::string::npos) bytes.replace(place, from.size(), to);
  }
  return bytes;
}

TEST_F(CubeValues, DamageOfABakedFileIsNamed) {
  BakedProbeFile baked = oddBake();
  saveBakedProbe(file("a.exr"), baked);
  const std::string bytes = read("a.exr");
  const auto said = [&](const std::vector<std::pair<std::string, std::string>>& changes) {
    const std::string path = write("b.exr", withoutSeal(bytes, changes));
    const std::string text = errorText([&] { loadBakedProbe(path); });
    EXPECT_EQ(text.rfind(path + ": ", 0), 0u) << text;
    return text.substr(std::min(text.size(), path.size() + 2));
  };
  ASSERT_NO_THROW(loadBakedProbe(write("b.exr", withoutSeal(bytes, {}))));
  const auto number = [](const char* name, char value) {
    return std::string(name) + std::string("\0int\0\4\0\0\0", 9) + value;
  };
  const std::string missing = " is missing: this is not a probe that was baked; bake it again";
  const std::string fit = "part 0: attribute levels does not fit faces of 16 texels; bake it again";
  EXPECT_EQ(said({{number("levels", 5), number("levels", 0)}}), fit);
  EXPECT_EQ(said({{number("levels", 5), number("levels", 6)}}), fit);
  EXPECT_EQ(said({{number("levels", 5), number("levels", 14)}}), fit);
  EXPECT_EQ(said({{number("levels", 5), number("levelz", 5)}}), fit);
  EXPECT_EQ(said({{"level.3", "level.9"}}), "has no part level.3; bake it again");
  EXPECT_EQ(said({{"level.0", "level.9"}}),
            "attribute boxprobe = 2 and a part level.0 are not there: no probe baked by this version; bake it again");
  EXPECT_EQ(said({{number("boxprobe", 1), number("boxprobe", 3)}}),
            "attribute boxprobe = 2 and a part level.0 are not there: no probe baked by this version; bake it again");
  for (const char* name : {"capturedAt", "irradiance", "inputHash", "software"}) {
    std::string other = name;
    other[0] = 'x';
    EXPECT_EQ(said({{name, other}}), "part 0: attribute " + std::string(name) + missing) << name;
  }
  EXPECT_EQ(said({{"level.1", "level.X"}, {"level.2", "level.1"}, {"level.X", "level.2"}}),
            "part 3: is 4 x 24 pixels and must be 8 x 48; bake it again");
  EXPECT_EQ(said({{std::string("probe.far\0", 10), std::string("probe.fbr\0", 10)}}),
            "part 0: attributes: probes.true.fbr: unknown key; did you mean \"far\"?; bake it again");
  EXPECT_EQ(said({{"probe.bevel.radius", "probe.farxx.radius"}, {"probe.farxx.radius", "probe.name.xradius"}}),
            "part 0: attribute probe.name.xradius stands below another value; bake it again");
  baked.maps.irradiance[8].z = std::nanf("");
  saveBakedProbe(file("c.exr"), baked);
  EXPECT_EQ(errorText([&] { loadBakedProbe(file("c.exr")); }),
            file("c.exr") + ": part 0: attribute irradiance is not finite; bake it again");
  const std::string plain = write("b.exr", withoutSeal(bytes, {{number("boxprobe", 1), number("boxprobe", 2)}}));
  EXPECT_EQ(errorText([&] { loadBakedProbe(plain); }), plain + ": is damaged: it has no checksum; bake it again");
  EXPECT_EQ(bakedProbeDamage(plain),
            plain + ": is damaged, or from an earlier version: its checksum differs or is missing");
  BakedProbeFile distances = oddBake();
  distances.maps.distance.face(0, 0)[4 * 9] = -1.0f;
  distances.maps.distance.face(0, 0)[4 * 10] = std::numeric_limits<float>::infinity();
  distances.maps.radiance.setTexel(2, 1, 1, 1, {1.0f, 1.0f, std::nanf(""), 1.0f});
  distances.maps.radiance.setTexel(0, 1, 1, 1, {std::nanf(""), std::nanf(""), 2.0f, std::nanf("")});
  saveBakedProbe(file("d.exr"), distances, ExrPrecision::Float);
  const BakedProbeFile again = loadBakedProbe(file("d.exr"));
  EXPECT_EQ(again.texelsNotFinite, 2u);
  EXPECT_EQ(again.maps.distance.face(0, 0)[4 * 9], 0.0f);
  EXPECT_EQ(again.maps.distance.face(0, 0)[4 * 10], 0.0f);
  EXPECT_EQ(again.maps.distance.face(0, 0)[4 * 11], 2.75f);
  EXPECT_EQ(again.maps.radiance.texel(0, 1, 1, 1), glm::vec4(0.0f, 0.0f, 2.0f, 0.0f));
  for (const auto& [size, levels] : {std::pair{24, 1}, {16, 6}, {0, 0}}) {
    BakedProbeFile odd = oddBake();
    odd.maps.radiance = size > 0 ? CubeMap(size, levels) : CubeMap();
    const std::string text = errorText<WorkError>([&] { saveBakedProbe(file("e.exr"), odd); });
    EXPECT_NE(text.find(": not written: faces of " + std::to_string(size) + " texels with " + std::to_string(levels) +
                        " levels are no probe's; use a power of two"),
              std::string::npos)
        << text;
  }
}

TEST_F(CubeValues, OptionsOutOfRangeAreNamed) {
  const CubeMap cube = oddCube(4, 2);
  CubePictureOptions options;
  const auto said = [&] {
    return errorText([&] { saveCubePicture(file("a.exr"), cube, CubeLayout::Cross, options); });
  };
  options.level = 2;
  EXPECT_EQ(said(), file("a.exr") + ": level 2 was asked for; the cube has 2 levels, counted from 0");
  options.level = -1;
  EXPECT_EQ(said(), file("a.exr") + ": level -1 was asked for; the cube has 2 levels, counted from 0");
  options.level = 1;
  options.faceSize = 4097;
  EXPECT_EQ(said(), file("a.exr") + ": faces of 4097 texels were asked for; use 1 to 4096");
  options.faceSize = -1;
  EXPECT_EQ(said(), file("a.exr") + ": faces of -1 texels were asked for; use 1 to 4096");
  for (const int size : {-16, 3, 8192}) {
    EXPECT_EQ(
        errorText([&] { loadCube(file("a.exr"), CubeLayout::Automatic, size); }),
        file("a.exr") + ": a face size of " + std::to_string(size) + " was asked for; use a power of two up to 4096");
  }
}

TEST(CubeLayoutValues, PlacesOfTexelsAreTheirFormulas) {
  using P = TexelPlacement;
  EXPECT_DOUBLE_EQ(texelPosition(0.25, 7, P::Edges), 0.625 * 6.0);
  EXPECT_DOUBLE_EQ(texelPosition(0.25, 7, P::Centres), 0.625 * 7.0 - 0.5);
  EXPECT_DOUBLE_EQ(texelCoordinate(2.0, 7, P::Edges), 2.0 * 2.0 / 6.0 - 1.0);
  EXPECT_DOUBLE_EQ(texelCoordinate(2.0, 7, P::Centres), 2.0 * 2.5 / 7.0 - 1.0);
  EXPECT_EQ(texelCoordinate(0.0, 1, P::Edges), 0.0);
  EXPECT_EQ(texelCoordinate(1.0, 2, P::Edges), 1.0);
  for (int face = 0; face < 6; ++face) {
    const CubePoint point = mirroredOpenExr({face, 0.25f, 0.5f});
    const bool floorOrCeiling = face == 2 || face == 3;
    EXPECT_EQ(point.face, face);
    EXPECT_EQ(point.s, floorOrCeiling ? 0.25f : -0.25f);
    EXPECT_EQ(point.t, floorOrCeiling ? -0.5f : 0.5f);
  }
  EXPECT_EQ(layoutOfShape(8, 4), CubeLayout::LatLong);
  EXPECT_EQ(layoutOfShape(4, 8), CubeLayout::Automatic);
  EXPECT_EQ(layoutOfShape(6, 1), CubeLayout::Strip);
  EXPECT_EQ(layoutOfShape(1, 6), CubeLayout::Strip);
  EXPECT_EQ(layoutOfShape(8, 6), CubeLayout::Cross);
  EXPECT_EQ(layoutOfShape(6, 8), CubeLayout::Cross);
  EXPECT_EQ(layoutOfShape(7, 6), CubeLayout::Automatic);
  EXPECT_EQ(layoutOfShape(6, 7), CubeLayout::Automatic);
}

TEST_F(CubeValues, SixNamesAreFoundFromEach) {
  const auto make = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) write(name, "x");
  };
  const auto found = [&](const std::string& name) {
    const auto names = findSixNames(file(name));
    std::string text = names ? (names->openExr ? "exr" : "gl") : "none";
    if (names) {
      for (const std::string& path : names->paths) text += " " + std::filesystem::path(path).filename().string();
    }
    return text;
  };
  make({"posx.e", "negx.e", "posy.e", "negy.e", "posz.e", "negz.e"});
  EXPECT_EQ(found("negy.e"), "gl posx.e negx.e posy.e negy.e posz.e negz.e");
  make({"roomPosX.e", "roomNegX.e", "roomPosY.e", "roomNegY.e", "roomPosZ.e", "roomNegZ.e"});
  EXPECT_EQ(found("roomPosZ.e"), "gl roomPosX.e roomNegX.e roomPosY.e roomNegY.e roomPosZ.e roomNegZ.e");
  make({"a_Right.e", "a_Left.e", "a_Top.e", "a_Bottom.e", "a_Front.e", "a_Back.e"});
  EXPECT_EQ(found("a_Back.e"), "gl a_Right.e a_Left.e a_Top.e a_Bottom.e a_Front.e a_Back.e");
  EXPECT_EQ(found("a_%s.e"), "gl a_Right.e a_Left.e a_Top.e a_Bottom.e a_Front.e a_Back.e");
  EXPECT_EQ(found("a_right.e"), "none");
  make({"b+X.e", "b-X.e", "b+Y.e", "b-Y.e", "b+Z.e", "b-Z.e"});
  EXPECT_EQ(found("b-Y.e"), "exr b+X.e b-X.e b+Y.e b-Y.e b+Z.e b-Z.e");
  EXPECT_EQ(found("b%.e"), "exr b+X.e b-X.e b+Y.e b-Y.e b+Z.e b-Z.e");
  make({"cpx.e", "cnx.e", "cpy.e", "cny.e", "cpz.e", "cnz.e"});
  EXPECT_EQ(found("cpx.e"), "none") << "no separator";
  EXPECT_EQ(found("c%s.e"), "gl cpx.e cnx.e cpy.e cny.e cpz.e cnz.e");
  make({"d.px.e", "d.nx.e", "d.py.e", "d.ny.e", "d.pz.e"});
  EXPECT_EQ(found("d.px.e"), "none") << "five";
  EXPECT_EQ(found("x.e"), "none");
  EXPECT_EQ(found("no.e"), "none");
  EXPECT_THAT(sixNamesToWrite("a_%s.exr").paths,
              ElementsAre("a_px.exr", "a_nx.exr", "a_py.exr", "a_ny.exr", "a_pz.exr", "a_nz.exr"));
  EXPECT_FALSE(sixNamesToWrite("a_%s.exr").openExr);
  EXPECT_THAT(sixNamesToWrite("a%b").paths, ElementsAre("a+Xb", "a-Xb", "a+Yb", "a-Yb", "a+Zb", "a-Zb"));
  EXPECT_TRUE(sixNamesToWrite("a%").openExr);
  EXPECT_EQ(errorText([] { sixNamesToWrite("a.exr"); }),
            "a.exr: six files need a %s where the face goes, as in room_%s.exr");
}

}  // namespace
}  // namespace boxprobe
