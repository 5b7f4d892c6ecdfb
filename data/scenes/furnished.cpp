// The furnished room: x in [-3.5, 3.5], y in [0, 2.8], z in [-2.5, 2.5]. Its walls lie in the planes of the probe's
// box, what stands in it does not: shelves with books, a wardrobe, a cabinet, a table, two columns. Box projection
// paints them all on the walls behind; a projection that knows what the probe saw has something to win here, and,
// behind the columns and on the table, something it cannot know.
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "data/scenes/building_pictures.h"
#include "data/scenes/composer.h"
#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

const glm::dvec3 kLow(-3.5, 0.0, -2.5), kSize(7.0, 2.8, 5.0);
constexpr double kSoft = 0.03;  // metres, of painted edges
constexpr float kGlow = 0.3f;   // of furniture, of its own colour: the light that walls would give it
constexpr float kLampRadiance = 12.0f;

double inside(double d) {
  return softStep(0.0, kSoft, -d);
}

/// `x` metres from the wall's left as seen from inside, `y` metres above the floor.
using Mural = glm::dvec3 (*)(double x, double y);

// Plain colour above a darker panel of 0.9 m, divided by joints: whatever shifts in a reflection shows at its edges.
glm::dvec3 panelled(glm::dvec3 above, glm::dvec3 below, double x, double y) {
  glm::dvec3 color = blend(below, 0.45 * below, softLines(x, 0.5, 0.025, kSoft));
  color = blend(color, above, inside(0.9 - y));
  return blend(color, {0.86, 0.84, 0.78}, inside(std::abs(y - 0.9) - 0.04));
}

glm::dvec3 northMural(double x, double y) {  // a window of four panes
  glm::dvec3 color = panelled({0.62, 0.55, 0.42}, {0.30, 0.20, 0.12}, x, y);
  const double across = std::abs(x - 3.5), up = std::abs(y - 1.7);
  color = blend(color, {0.90, 0.90, 0.88}, inside(std::max(across - 1.0, up - 0.66)));
  const double pane = std::max(std::abs(across - 0.48) - 0.42, std::abs(up - 0.31) - 0.25);
  return blend(color, blend({0.45, 0.70, 0.95}, {0.80, 0.90, 0.98}, (y - 1.1) / 1.2), inside(pane));
}

glm::dvec3 southMural(double x, double y) {  // a door and two pictures
  glm::dvec3 color = panelled({0.24, 0.40, 0.44}, {0.10, 0.18, 0.22}, x, y);
  color = blend(color, {0.45, 0.24, 0.10}, inside(std::max(std::abs(x - 5.4) - 0.48, y - 2.1)));
  color = blend(color, {0.92, 0.75, 0.25}, inside(std::hypot(x - 5.05, y - 1.0) - 0.06));
  color = blend(color, {0.88, 0.85, 0.75}, inside(std::max(std::abs(x - 1.4) - 0.55, std::abs(y - 1.65) - 0.42)));
  color = blend(color, {0.75, 0.15, 0.10}, inside(std::hypot(x - 1.4, y - 1.65) - 0.3));
  color = blend(color, {0.88, 0.85, 0.75}, inside(std::max(std::abs(x - 3.2) - 0.4, std::abs(y - 1.65) - 0.55)));
  return blend(color, {0.10, 0.22, 0.55}, inside(std::abs(x - 3.2) + std::abs(y - 1.65) - 0.34));
}

glm::dvec3 eastMural(double x, double y) {
  return panelled({0.55, 0.30, 0.24}, {0.28, 0.12, 0.10}, x, y);
}

glm::dvec3 westMural(double x, double y) {
  const double stripe = softLines(x, 1.0, 0.25, kSoft);
  return panelled(blend({0.30, 0.42, 0.24}, {0.46, 0.58, 0.36}, stripe), {0.16, 0.22, 0.12}, x, y);
}

glm::dvec3 ceilingMural(double x, double y) {
  const double beam = softLines(x, 1.4, 0.12, kSoft);
  return blend(glm::dvec3(0.62, 0.60, 0.55) * (0.8 + 0.05 * y), {0.22, 0.14, 0.08}, beam);
}

/// Books of a board, seen from the front: a spine every few centimetres, each with its colour.
Picture booksPicture() {
  return paint("books", 1024, 128, [](double u, double v) {
    const double spine = 64.0 * u;
    const int book = static_cast<int>(spine);
    const glm::dvec3 color(0.10 + 0.7 * hash(book, 0, 3), 0.08 + 0.5 * hash(book, 1, 3), 0.06 + 0.5 * hash(book, 2, 3));
    const double joint = softLines(spine, 1.0, 0.06, 0.08);
    const double label = inside(std::abs(v - 0.2 - 0.3 * hash(book, 3, 3)) - 0.05);
    return blend(blend(color, {0.85, 0.80, 0.65}, label), 0.2 * color, joint);
  });
}

void addTable(MeshBuilder& wood, glm::dvec3 middle, glm::dvec3 size, double leg) {
  const glm::dvec3 low(middle.x - 0.5 * size.x, 0.0, middle.z - 0.5 * size.z);
  constexpr double kTop = 0.06, kInset = 0.06;
  wood.box({low.x, size.y - kTop, low.z}, {low.x + size.x, size.y, low.z + size.z}, repeating(1.5));
  for (double x : {low.x + kInset, low.x + size.x - kInset - leg}) {
    for (double z : {low.z + kInset, low.z + size.z - kInset - leg}) {
      wood.box({x, 0.0, z}, {x + leg, size.y - kTop, z + leg}, repeating(1.5), kAllFaces & ~(kPlusY | kMinusY));
    }
  }
}

/// Against the east wall: two sides, six boards, books between them.
void addShelves(MeshBuilder& wood, MeshBuilder& books) {
  constexpr double kFront = 2.9, kBack = 3.5, kLeft = -1.7, kRight = 1.7, kBoard = 0.04, kPitch = 0.4;
  constexpr int kBoards = 6;
  for (double z : {kLeft - kBoard, kRight})
    wood.box({kFront, 0.0, z}, {kBack, (kBoards - 1) * kPitch + 0.08 + kBoard, z + kBoard}, repeating(1.5),
             kAllFaces & ~(kPlusX | kMinusY));
  for (int i = 0; i < kBoards; ++i) {
    const double y = 0.08 + kPitch * i;
    wood.box({kFront, y, kLeft}, {kBack, y + kBoard, kRight}, repeating(1.5), kMinusX | kPlusY | kMinusY);
    if (i + 1 == kBoards) continue;
    const double length = i == 2 ? 2.3 : 3.3;
    books.box(
        {kFront + 0.04, y + kBoard, kLeft + 0.05}, {kBack, y + kBoard + 0.3, kLeft + 0.05 + length},
        [length](unsigned face, glm::dvec2) {
          return face == kMinusX ? UvRectangle{0.0, 0.0, length / 3.4, 1.0} : UvRectangle{0.0, 0.9, 0.02, 1.0};
        },
        kAllFaces & ~(kMinusY | kPlusX));
  }
}

/// A wardrobe's front: doors 0.6 m wide with two panels each, handles between them.
Picture wardrobePicture() {
  return paint("wardrobe", 512, 512, [](double u, double v) {
    const double x = 2.4 * u, y = 2.2 * (1.0 - v);
    const double door = std::abs(std::fmod(x, 0.6) - 0.3);
    const double panel = std::max(door - 0.2, std::min(std::abs(y - 0.65) - 0.4, std::abs(y - 1.6) - 0.4));
    glm::dvec3 color = blend({0.62, 0.50, 0.30}, {0.46, 0.34, 0.18}, inside(panel));
    color = blend(color, {0.15, 0.10, 0.06}, softLines(x, 0.6, 0.012, kSoft));
    const double pair = std::abs(std::fmod(x, 1.2) - 0.6);
    return blend(color, {0.95, 0.85, 0.50}, inside(std::max(std::abs(pair - 0.06) - 0.02, std::abs(y - 1.1) - 0.1)));
  });
}

}  // namespace

Model furnished() {
  Composer scene;
  const glm::dvec3 x(kSize.x, 0, 0), y(0, kSize.y, 0), z(0, 0, kSize.z);
  const auto addWall = [&scene](const std::string& name, Mural mural, glm::dvec3 corner, glm::dvec3 right,
                                glm::dvec3 up) {
    const glm::dvec2 metres(glm::length(right), glm::length(up));
    const Picture picture =
        paint(name, static_cast<int>(96 * metres.x), static_cast<int>(96 * metres.y),
              [mural, metres](double u, double v) { return mural(metres.x * u, metres.y * (1.0 - v)); });
    MeshBuilder builder;
    builder.quad(corner, right, up);
    scene.add(name, std::move(builder), scene.material(unlit(name, picture)));
  };
  MeshBuilder floor, wood, books, columns, wardrobe, cabinet, lampPanel;
  floor.quad(kLow + z, x, -z);
  addTable(wood, {-0.1, 0.0, -2.0}, {1.8, 0.8, 0.8}, 0.09);
  addShelves(wood, books);
  for (double columnX : {-2.2, 1.6})
    columns.box({columnX, 0.0, -2.2}, {columnX + 0.45, kSize.y, -1.75}, repeating(1.5),
                kAllFaces & ~(kPlusY | kMinusY));
  const FaceUv front = [](unsigned face, glm::dvec2) {
    return face == kPlusX ? UvRectangle{} : UvRectangle{0.25, 0.005, 0.26, 0.02};
  };
  wardrobe.box({-3.5, 0.0, -0.9}, {-2.85, 2.2, 1.5}, front, kAllFaces & ~(kMinusY | kMinusX));
  cabinet.box({-1.6, 0.0, 1.9}, {1.0, 1.1, 2.5}, repeating(1.0), kAllFaces & ~(kMinusY | kPlusZ));
  lampPanel.box({-0.7, 2.5, -0.4}, {0.7, 2.58, 0.4}, repeating(1.0));

  scene.add("floor", std::move(floor), scene.material(perfectMirror("floor")));
  addWall("wall north", northMural, kLow, x, y);
  addWall("wall south", southMural, kLow + x + z, -x, y);
  addWall("wall east", eastMural, kLow + x, z, y);
  addWall("wall west", westMural, kLow + z, -z, y);
  addWall("ceiling", ceilingMural, kLow + y, x, z);
  const auto tiled = [](const char* name, const Picture& picture) {
    Material material = lit(name, picture, kGlow);
    for (TextureUse* use : {&material.baseColorTexture, &material.emissiveTexture})
      use->wrapS = use->wrapT = Wrap::Repeat;
    return material;
  };
  scene.add("furniture", std::move(wood), scene.material(tiled("wood", woodPicture())));
  scene.add("books", std::move(books), scene.material(lit("books", booksPicture(), kGlow)));
  scene.add("columns", std::move(columns), scene.material(tiled("stone", stonePicture())));
  scene.add("wardrobe", std::move(wardrobe), scene.material(lit("wardrobe", wardrobePicture(), kGlow)));
  scene.add("cabinet", std::move(cabinet), scene.material(lit("cabinet", glm::vec3(0.04f, 0.16f, 0.26f), kGlow)));
  scene.add("lamp", std::move(lampPanel), scene.material(lamp("lamp", glm::vec3(kLampRadiance))));

  const int ball = scene.mesh(sphere(0.3, 64), "sphere", scene.material(perfectMirror("sphere")));
  scene.place("sphere 1", ball, {1.9, 0.3, 0.4});
  scene.place("sphere 2", ball, {-0.9, 0.3, 0.2});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
