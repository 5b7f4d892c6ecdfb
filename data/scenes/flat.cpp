// The flat: a living room, x in [-2.8, 2.8], z in [-2.3, 2.3], and a kitchen south of it, x in [-2.8, 1.8], z in
// [2.45, 5.45], both 2.6 m high, with a doorway between them and windows to the west. Generated, like all scenes here:
// furniture from boxes with rounded edges, cushions, tubes and turned shapes, pictures by formula.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "data/scenes/flat_furniture.h"
#include "data/scenes/flat_pictures.h"
#include "data/scenes/home.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"
#include "data/scenes/soft_shapes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kHeight = 2.6, kWest = -2.8, kEast = 2.8, kNorth = -2.3, kSouth = 2.3, kWall = 0.15;
constexpr double kKitchenEast = 1.8, kKitchenNorth = kSouth + kWall, kKitchenSouth = 5.45;
constexpr double kDoorWest = 0.55, kDoorEast = 1.45, kDoorHeight = 2.05;
constexpr double kOuter = 0.32;  // thickness of the west wall

/// Metres along z and above the floor.
struct Window {
  double north, south, low, high;
  int wings;
  bool holds(double z, double y) const { return z > north && z < south && y > low && y < high; }
};
constexpr Window kLarge{-1.62, 0.42, 0.45, 2.30, 3}, kBalcony{0.86, 1.72, 0.06, 2.30, 1},
    kKitchen{3.05, 4.45, 1.02, 2.25, 2};

Material plain(const std::string& name, glm::vec3 color, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = roughness;
  return material;
}

Material pictured(const std::string& name, const Picture& picture, float roughness, glm::vec3 tint = glm::vec3(1.0f)) {
  Material material = plain(name, tint, roughness);
  material.baseColorTexture = {picture, Wrap::Repeat, Wrap::Repeat};
  return material;
}

Material cloth(const std::string& name, const Picture& picture, glm::vec3 tint) {
  Material material = pictured(name, picture, 0.92f, tint);
  material.finish.sheenColor = glm::min(0.25f * tint + 0.06f, glm::vec3(1.0f));
  material.finish.sheenRoughness = 0.5f;
  return material;
}

Material metal(const std::string& name, glm::vec3 color, float roughness) {
  Material material = plain(name, color, roughness);
  material.metallic = 1.0f;
  return material;
}

FlatMaterials makeMaterials(Home& home) {
  FlatMaterials m{};
  const Picture weave = clothPicture();
  const Picture oakGrain = grainPicture("oak", {0.27, 0.155, 0.075}, {0.50, 0.325, 0.185});
  const Picture walnutGrain = grainPicture("walnut", {0.062, 0.032, 0.017}, {0.20, 0.112, 0.058});
  m.oak = home.material(pictured("oak", oakGrain, 0.42f));
  m.walnut = home.material(pictured("walnut", walnutGrain, 0.36f));
  m.white = home.material(plain("white paint", {0.78f, 0.765f, 0.735f}, 0.35f));
  m.sofa = home.material(cloth("sofa", weave, {0.56f, 0.53f, 0.48f}));
  m.armchair = home.material(cloth("armchair", weave, {0.52f, 0.23f, 0.10f}));
  m.pillow1 = home.material(cloth("cushion rust", weave, {0.50f, 0.17f, 0.075f}));
  m.pillow2 = home.material(cloth("cushion blue", weave, {0.10f, 0.17f, 0.21f}));
  m.throwBlanket = home.material(cloth("blanket", weave, {0.66f, 0.49f, 0.24f}));
  m.rug = home.material(pictured("rug", rugPicture(), 0.95f));
  Material linen = cloth("linen", weave, {0.86f, 0.82f, 0.74f});
  linen.doubleSided = true;
  m.linen = home.material(linen);
  m.brass = home.brushedMaterial(metal("brass", {0.83f, 0.62f, 0.32f}, 0.30f));
  m.steel = home.brushedMaterial(metal("steel", {0.62f, 0.61f, 0.59f}, 0.28f));
  m.black = home.material(plain("black paint", {0.022f, 0.022f, 0.023f}, 0.40f));
  m.glassBlack = home.material(plain("black glass", {0.012f, 0.012f, 0.013f}, 0.06f));
  m.mirror = home.bareMaterial(metal("mirror", {0.93f, 0.93f, 0.92f}, 0.01f));
  Material books = pictured("books", booksPicture(), 0.55f);
  books.baseColorTexture.wrapS = books.baseColorTexture.wrapT = Wrap::ClampToEdge;
  m.books = home.material(books);
  Material leaf = pictured("leaf", leafPicture(), 0.38f);
  leaf.baseColorTexture.wrapS = leaf.baseColorTexture.wrapT = Wrap::ClampToEdge;
  leaf.doubleSided = true;
  m.leaf = home.material(leaf);
  m.pot = home.material(plain("clay", {0.44f, 0.225f, 0.135f}, 0.60f));
  m.vase = home.material(plain("glaze", {0.105f, 0.165f, 0.165f}, 0.16f));
  m.cream = home.material(plain("porcelain", {0.74f, 0.70f, 0.62f}, 0.22f));
  m.bark = home.material(plain("earth", {0.075f, 0.052f, 0.034f}, 0.95f));
  m.cabinet = home.material(plain("cabinet paint", {0.135f, 0.205f, 0.195f}, 0.38f));
  m.counter = home.material(pictured("terrazzo", terrazzoPicture(), 0.22f));
  Material tiles = pictured("tiles", glazedTiles(), 1.0f);
  tiles.metallicRoughnessTexture = {glazedTilesRoughness(), Wrap::Repeat, Wrap::Repeat};
  tiles.metallic = 0.0f;
  m.tiles = home.material(tiles);
  m.paper = home.material(plain("paper", {0.76f, 0.73f, 0.66f}, 0.90f));
  m.fruit1 = home.material(plain("orange", {0.70f, 0.26f, 0.035f}, 0.45f));
  m.fruit2 = home.material(plain("lemon", {0.74f, 0.55f, 0.08f}, 0.42f));
  m.shade = home.bareMaterial(lamp("lamp shade", {0.46f, 0.315f, 0.175f}));
  m.lampLight = home.bareMaterial(lamp("ceiling light", {12.0f, 9.4f, 6.4f}));
  m.warmLight = home.bareMaterial(lamp("warm light", {19.0f, 13.0f, 7.4f}));
  m.shadeLight = home.bareMaterial(lamp("shade light", {8.0f, 5.5f, 3.1f}));
  m.stripLight = home.bareMaterial(lamp("strip light", {24.0f, 18.5f, 12.4f}));
  for (int i = 0; i < 4; ++i) {
    Material painting = pictured("painting " + std::to_string(i + 1), paintingPicture(i), 0.70f);
    painting.baseColorTexture.wrapS = painting.baseColorTexture.wrapT = Wrap::ClampToEdge;
    m.paintings[i] = home.material(painting);
  }
  return m;
}

/// Frame, wings, handles and sill of a window in the west wall.
void addWindow(Home& home, const FlatMaterials& m, const Window& w) {
  const double inner = kWest, width = w.south - w.north;
  const double out = inner - 0.20, in = inner - 0.13, bar = 0.05;  // of the frame
  const Pen frame = home.pen("window frames", m.white);
  frame.box({out, w.low, w.north}, {in, w.high, w.north + bar}, 0.004);
  frame.box({out, w.low, w.south - bar}, {in, w.high, w.south}, 0.004);
  frame.box({out, w.high - bar, w.north + bar}, {in, w.high, w.south - bar}, 0.004);
  frame.box({out, w.low, w.north + bar}, {in, w.low + bar, w.south - bar}, 0.004);
  const double wing = (width - 2.0 * bar) / w.wings, sash = 0.052;
  for (int i = 0; i < w.wings; ++i) {
    const double a = w.north + bar + i * wing + 0.003, b = a + wing - 0.006, low = w.low + bar + 0.003,
                 high = w.high - bar - 0.003;
    frame.box({out + 0.014, low, a}, {in + 0.012, high, a + sash}, 0.006);
    frame.box({out + 0.014, low, b - sash}, {in + 0.012, high, b}, 0.006);
    frame.box({out + 0.014, high - sash, a + sash}, {in + 0.012, high, b - sash}, 0.006);
    frame.box({out + 0.014, low, a + sash}, {in + 0.012, low + sash + (w.low < 0.2 ? 0.10 : 0.0), b - sash}, 0.006);
    const double z = i % 2 == 0 ? b - 0.5 * sash : a + 0.5 * sash, y = w.low < 0.2 ? 1.05 : 0.5 * (low + high) - 0.1;
    const Pen handle = home.pen("window handles", m.steel);
    handle.box({in + 0.012, y - 0.035, z - 0.013}, {in + 0.020, y + 0.035, z + 0.013}, 0.003);
    handle.add(tube({{in + 0.018, y, z}, {in + 0.05, y, z}}, {0.007, 0.007}, 10));
    handle.add(tube({{in + 0.05, y + 0.008, z}, {in + 0.052, y - 0.11, z}}, {0.008, 0.0065}, 10));
  }
  if (w.low > 0.2)
    home.pen("window sills", m.oak)
        .box({in - 0.01, w.low - 0.034, w.north - 0.05}, {inner + 0.09, w.low + 0.004, w.south + 0.05}, 0.006);
}

std::vector<double> lengths(std::vector<double> places, double from, bool backwards) {
  for (double& place : places) place = backwards ? from - place : place - from;
  std::sort(places.begin(), places.end());
  return places;
}

void addSkirting(Home& home, const FlatMaterials& m, glm::dvec3 from, glm::dvec3 to) {
  home.pen("skirting", m.white).box(glm::min(from, to), glm::max(from, to) + glm::dvec3(0.0, 0.085, 0.0), 0.004);
}

void addRooms(Home& home, const FlatMaterials& m) {
  const Picture plasterPaint = plasterPicture();
  // Matt: all but the last fifth of what a smooth surface would reflect is gone.
  const auto wallPaint = [&](const std::string& name, glm::vec3 color) {
    Material material = pictured(name, plasterPaint, 0.9f, color);
    material.finish.specularEdge = 0.2f;
    return material;
  };
  const glm::vec3 warmWhite(0.82f, 0.775f, 0.70f), sage(0.235f, 0.285f, 0.235f), ceilingWhite(0.86f, 0.845f, 0.81f);
  Material boards = pictured("floor", planksPicture(), 1.0f);
  boards.metallicRoughnessTexture = {planksRoughness(), Wrap::Repeat, Wrap::Repeat};
  const auto named = [](Material material, const std::string& name) {
    material.name = name;
    return material;
  };
  const double h = kHeight;
  const glm::dvec3 up(0, h, 0);
  const auto floorAndCeiling = [&](const std::string& room, double west, double east, double north, double south) {
    const std::vector<double> x = {0.0, east - west}, z = {0.0, south - north};
    home.surface(room + "floor", named(boards, room + "floor"), {west, 0, south}, {east - west, 0, 0},
                 {0, 0, north - south}, x, z, 3.0);
    home.surface(room + "ceiling", wallPaint(room + "ceiling", ceilingWhite), {west, h, north}, {east - west, 0, 0},
                 {0, 0, south - north}, x, z, 2.0);
  };
  floorAndCeiling("", kWest, kEast, kNorth, kSouth);
  floorAndCeiling("kitchen ", kWest, kKitchenEast, kKitchenNorth, kKitchenSouth);

  // Seen from the east, or from outside.
  const auto west = [&](const std::string& name, double north, double south, std::vector<Window> windows,
                        bool outside = false) {
    std::vector<double> z = {north, south}, y = {0.0, h};
    for (const Window& w : windows) {
      z.insert(z.end(), {w.north, w.south});
      y.insert(y.end(), {w.low, w.high});
    }
    std::sort(y.begin(), y.end());
    y.erase(std::unique(y.begin(), y.end()), y.end());
    const double first = outside ? north : south, last = outside ? south : north;
    home.surface(name, wallPaint(name, warmWhite), {outside ? kWest - kOuter : kWest, 0, first}, {0, 0, last - first},
                 up, lengths(z, first, !outside), y, 2.0, [&](double along, double above) {
                   return std::none_of(windows.begin(), windows.end(), [&](const Window& w) {
                     return w.holds(outside ? north + along : south - along, above);
                   });
                 });
  };
  west("wall west", kNorth, kSouth, {kLarge, kBalcony});
  west("kitchen wall west", kKitchenNorth, kKitchenSouth, {kKitchen});
  // What the sun shines on from outside is as thick as a house is: through the edges of one face its light would leak.
  west("facade", kNorth - kOuter, kKitchenSouth + kOuter, {kLarge, kBalcony, kKitchen}, true);
  const double roofEast = std::max(kEast, kKitchenEast) + kOuter;
  home.surface("roof", wallPaint("roof", ceilingWhite), {kWest - kOuter, h + kOuter, kKitchenSouth + kOuter},
               {roofEast - kWest + kOuter, 0, 0}, {0, 0, kNorth - kKitchenSouth - 2.0 * kOuter},
               {0.0, roofEast - kWest + kOuter}, {0.0, kKitchenSouth - kNorth + 2.0 * kOuter}, 2.0);
  const std::vector<double> full = {0.0, h}, doorRows = {0.0, kDoorHeight, h};
  home.surface("wall north", wallPaint("wall north", sage), {kWest, 0, kNorth}, {kEast - kWest, 0, 0}, up,
               {0.0, kEast - kWest}, full, 2.0);
  home.surface("wall east", wallPaint("wall east", warmWhite), {kEast, 0, kNorth}, {0, 0, kSouth - kNorth}, up,
               {0.0, kSouth - kNorth}, full, 2.0);
  home.surface("wall south", wallPaint("wall south", warmWhite), {kEast, 0, kSouth}, {kWest - kEast, 0, 0}, up,
               lengths({kEast, kDoorEast, kDoorWest, kWest}, kEast, true), doorRows, 2.0,
               [](double along, double above) {
                 return !(above < kDoorHeight && along > kEast - kDoorEast && along < kEast - kDoorWest);
               });
  home.surface("kitchen wall north", wallPaint("kitchen wall north", warmWhite), {kWest, 0, kKitchenNorth},
               {kKitchenEast - kWest, 0, 0}, up, lengths({kWest, kDoorWest, kDoorEast, kKitchenEast}, kWest, false),
               doorRows, 2.0, [](double along, double above) {
                 return !(above < kDoorHeight && along > kDoorWest - kWest && along < kDoorEast - kWest);
               });
  home.surface("kitchen wall east", wallPaint("kitchen wall east", warmWhite), {kKitchenEast, 0, kKitchenNorth},
               {0, 0, kKitchenSouth - kKitchenNorth}, up, {0.0, kKitchenSouth - kKitchenNorth}, full, 2.0);
  home.surface("kitchen wall south", wallPaint("kitchen wall south", warmWhite), {kKitchenEast, 0, kKitchenSouth},
               {kWest - kKitchenEast, 0, 0}, up, {0.0, kKitchenEast - kWest}, full, 2.0);

  // The west wall's thickness about the windows, and the doorway's lining.
  const auto lining = [&](const std::string& name, const Material& material, glm::dvec3 corner, glm::dvec3 right,
                          glm::dvec3 upwards) {
    home.surface(name, named(material, name), corner, right, upwards, {0.0, glm::length(right)},
                 {0.0, glm::length(upwards)}, 2.0);
  };
  const Material reveal = wallPaint("reveal", warmWhite);
  int number = 0;
  for (const Window& w : {kLarge, kBalcony, kKitchen}) {
    const double outer = kWest - kOuter, tall = w.high - w.low, wide = w.south - w.north;
    const std::string name = "reveal " + std::to_string(++number);
    lining(name + " north", reveal, {outer, w.low, w.north}, {kOuter, 0, 0}, {0, tall, 0});
    lining(name + " south", reveal, {kWest, w.low, w.south}, {-kOuter, 0, 0}, {0, tall, 0});
    lining(name + " top", reveal, {outer, w.high, w.north}, {kOuter, 0, 0}, {0, 0, wide});
    lining(name + " bottom", reveal, {kWest, w.low, w.north}, {-kOuter, 0, 0}, {0, 0, wide});
  }
  const Material white = pictured("door lining", plasterPaint, 0.35f, {0.84f, 0.82f, 0.79f});
  lining("door lining west", white, {kDoorWest, 0, kKitchenNorth}, {0, 0, -kWall}, {0, kDoorHeight, 0});
  lining("door lining east", white, {kDoorEast, 0, kSouth}, {0, 0, kWall}, {0, kDoorHeight, 0});
  lining("door lining top", white, {kDoorWest, kDoorHeight, kSouth}, {kDoorEast - kDoorWest, 0, 0}, {0, 0, kWall});
  lining("threshold", boards, {kDoorWest, 0, kKitchenNorth}, {kDoorEast - kDoorWest, 0, 0}, {0, 0, -kWall});
  for (int side = 0; side < 2; ++side) {
    const double z = side == 0 ? kSouth - 0.016 : kKitchenNorth, casing = 0.072;
    const Pen frame = home.pen("door frame", m.white);
    frame.box({kDoorWest - casing, 0.0, z}, {kDoorWest + 0.006, kDoorHeight + casing, z + 0.016}, 0.004);
    frame.box({kDoorEast - 0.006, 0.0, z}, {kDoorEast + casing, kDoorHeight + casing, z + 0.016}, 0.004);
    frame.box({kDoorWest + 0.006, kDoorHeight - 0.006, z}, {kDoorEast - 0.006, kDoorHeight + casing, z + 0.016}, 0.004);
  }

  constexpr double t = 0.015, casing = 0.072;
  addSkirting(home, m, {kWest, 0, kNorth}, {kEast, 0, kNorth + t});
  addSkirting(home, m, {kEast - t, 0, kNorth + t}, {kEast, 0, kSouth});
  addSkirting(home, m, {kDoorEast + casing, 0, kSouth - t}, {kEast - t, 0, kSouth});
  addSkirting(home, m, {kWest, 0, kSouth - t}, {kDoorWest - casing, 0, kSouth});
  addSkirting(home, m, {kWest, 0, kNorth + t}, {kWest + t, 0, kBalcony.north});
  addSkirting(home, m, {kWest, 0, kBalcony.south}, {kWest + t, 0, kSouth - t});
  addSkirting(home, m, {kWest, 0, kKitchenNorth}, {kDoorWest - casing, 0, kKitchenNorth + t});
  addSkirting(home, m, {kDoorEast + casing, 0, kKitchenNorth}, {kKitchenEast, 0, kKitchenNorth + t});
  addSkirting(home, m, {kKitchenEast - t, 0, kKitchenNorth + t}, {kKitchenEast, 0, kKitchenSouth - 0.64});
  addSkirting(home, m, {kWest, 0, kKitchenNorth + t}, {kWest + t, 0, kKitchenSouth});
}

}  // namespace

Model flat() {
  Home home;
  const FlatMaterials m = makeMaterials(home);
  addRooms(home, m);
  for (const Window& w : {kLarge, kBalcony, kKitchen}) addWindow(home, m, w);

  // The living room.
  addSofa(home, m, placedAt({-0.35, 0, kNorth + 0.05}));
  addArmchair(home, m, placedAt({-2.10, 0, 0.50}, 76.0));
  addCoffeeTable(home, m, placedAt({-0.42, 0, -0.42}, 1.5));
  addFloorLamp(home, m, placedAt({-2.40, 0, 1.97}, 12.0));
  addCeilingLamp(home, m, {-0.40, kHeight, -0.35});
  addBookshelf(home, m, placedAt({2.12, 0, kSouth - 0.018}, 180.0));
  addSideboard(home, m, placedAt({-0.95, 0, kSouth - 0.02}, 180.0));
  addPlant(home, m, {-2.10, 0, -1.88}, 1.62, 41);
  addPlant(home, m, {-0.40, 0.66, 2.06}, 0.34, 43);
  addVase(home, m, {-1.50, 0.66, 2.08}, 0.30, true);
  MeshBuilder rug = bevelBox({-1.3, 0.001, -0.95}, {1.3, 0.012, 0.95}, 0.005, 1e6, {0.02, 0.02});
  rug.quad({-1.294, 0.0126, 0.944}, {2.588, 0, 0}, {0, 0, -1.888});
  home.pen("rug", m.rug, placedAt({-0.45, 0, -0.38}, -1.0)).add(rug);
  addRoundMirror(home, m, placedAt({-0.98, 1.58, kNorth + 0.001}), 0.42);
  addPainting(home, m, 0, placedAt({-0.04, 1.56, kNorth + 0.002}), {0.44, 0.56});
  addPainting(home, m, 1, placedAt({0.47, 1.56, kNorth + 0.002}), {0.44, 0.56});
  addPainting(home, m, 3, placedAt({-0.95, 1.48, kSouth - 0.002}, 180.0), {1.08, 0.74});
  addPainting(home, m, 2, placedAt({-0.86, 1.52, kKitchenNorth + 0.002}), {0.62, 0.78});
  addCurtain(home, m, placedAt({kWest + 0.085, 2.43, kNorth + 0.62}, 90.0), 0.56, 2.41, 6);
  addCurtain(home, m, placedAt({kWest + 0.085, 2.43, kSouth - 0.06}, 90.0), 0.46, 2.41, 5);
  home.pen("curtain rod", m.brass)
      .add(tube({{kWest + 0.085, 2.445, kNorth + 0.02}, {kWest + 0.085, 2.445, kSouth - 0.02}}, {0.011, 0.011}, 14));

  // The kitchen.
  addKitchenCounter(home, m, placedAt({kKitchenEast - 0.605, 0, kKitchenSouth - 0.001}, 180.0), 3.0);
  addTallCabinet(home, m, placedAt({kKitchenEast - 0.001, 0, kKitchenSouth - 0.001}, 180.0));
  addTable(home, m, placedAt({-1.55, 0, 3.45}, 0.0));
  addChair(home, m, placedAt({-1.20, 0, 3.00}, 8.0));
  addChair(home, m, placedAt({-1.90, 0, 3.94}, 173.0));
  addChair(home, m, placedAt({-0.72, 0, 3.52}, -82.0));
  addVase(home, m, {-1.70, 0.74, 3.40}, 0.22, true);
  addPendant(home, m, {-1.50, kHeight, 3.45}, 1.05);
  return std::move(home).finish();
}

}  // namespace boxprobe::scenes
