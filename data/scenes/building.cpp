// The pavilion. Everything that bounds the inner space has its inner face exactly in a plane of the box x, z =
// -4.5..4.5, y = 0..5: there the box is the true geometry. What lies behind (capitals, ground, trees) shows how far the
// proxy bends it.
#include <array>
#include <cmath>
#include <utility>

#include "data/scenes/building_pictures.h"
#include "data/scenes/composer.h"
#include "data/scenes/mesh_builder.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kInner = 4.5;      // half the inner space, x and z
constexpr double kPillar = 0.5;     // pillars are square
constexpr double kSpacing = 2.375;  // between the middles of pillars: five a side, corners included
constexpr double kEaves = 4.45;     // underside of the beams
constexpr double kTop = 5.0;        // underside of the rafters
constexpr double kGround = -0.3;
constexpr double kHorizon = 60.0;  // radius of the ground

/// A box given along a side of the pavilion: `along` to the right as seen from inside, `out` away from the inner space.
struct SideBox {
  double along0, along1, y0, y1, out0, out1;
};

void addSideBox(MeshBuilder& builder, int side, const SideBox& b, const FaceUv& uv, unsigned faces = kAllFaces) {
  glm::dvec3 low, high;
  const double near = kInner + b.out0, far = kInner + b.out1;
  switch (side) {
    case kNorth:
      low = {b.along0, b.y0, -far}, high = {b.along1, b.y1, -near};
      break;
    case kEast:
      low = {near, b.y0, b.along0}, high = {far, b.y1, b.along1};
      break;
    case kSouth:
      low = {-b.along1, b.y0, near}, high = {-b.along0, b.y1, far};
      break;
    default:
      low = {-far, b.y0, -b.along1}, high = {-near, b.y1, -b.along0};
      break;
  }
  builder.box(low, high, uv, faces);
}

/// Column `side` of an atlas of four, the part of its height from y0 to y1 out of `total`.
FaceUv atlasColumn(int side, double y0, double y1, double total) {
  return [=](unsigned, glm::dvec2) {
    constexpr double kInset = 1.0 / 512.0;  // keeps bilinear lookups out of the neighbour's column
    return UvRectangle{0.25 * side + kInset, 1.0 - y1 / total, 0.25 * (side + 1) - kInset, 1.0 - y0 / total};
  };
}

FaceUv atlasRow(int side) {
  return [side](unsigned, glm::dvec2) {
    constexpr double kInset = 1.0 / 512.0;
    return UvRectangle{0.0, 0.25 * side + kInset, 1.0, 0.25 * (side + 1) - kInset};
  };
}

/// A picture of 2 m by 1 m, its u along the beam.
UvRectangle alongBeam(unsigned, glm::dvec2 size) {
  return {0.0, 0.0, size.x / 2.0, size.y / 1.0};
}

constexpr float kGlow = 0.12f;  // about an eighth of full daylight

/// A picture that repeats.
Material tiled(const char* name, const Picture& picture, float glow) {
  Material material = lit(name, picture, glow);
  for (TextureUse* use : {&material.baseColorTexture, &material.emissiveTexture})
    use->wrapS = use->wrapT = Wrap::Repeat;
  return material;
}

/// What stands in the four bays of a side, counted from the left as seen from inside: a wall with the side's sign, two
/// tiled parapets, and one bay open down to the ground.
struct Bays {
  int screen, parapetA, parapetB;
};
constexpr std::array<Bays, kSides> kBays = {{{1, 0, 3}, {2, 0, 1}, {2, 0, 3}, {1, 2, 3}}};

/// Five pillars a side; the corner ones belong to the north and south sides. Plinth and capital stand out outwards, and
/// sideways where no wall adjoins (two faces in one plane would flicker).
void addPillars(MeshBuilder& shafts, MeshBuilder& stones) {
  constexpr double kPlinth = 0.3, kCapital = 0.18, kOverhang = 0.06;
  for (int side = 0; side < kSides; ++side) {
    const Bays& bays = kBays[side];
    const auto screened = [&bays](int bay) { return bay == bays.screen; };
    const auto walled = [&](int bay) { return screened(bay) || bay == bays.parapetA || bay == bays.parapetB; };
    const int last = side == kNorth || side == kSouth ? 2 : 1;
    for (int i = -last; i <= last; ++i) {
      const double left = i * kSpacing - 0.5 * kPillar, right = left + kPillar;
      const int bayLeft = i + 1, bayRight = i + 2;
      const auto overhang = [](bool blocked) { return blocked ? 0.0 : kOverhang; };
      const double capitalBase = kEaves - kCapital;
      addSideBox(shafts, side, {left, right, kPlinth, capitalBase, 0.0, kPillar},
                 atlasColumn(side, kPlinth, capitalBase, kTop), kAllFaces & ~(kPlusY | kMinusY));
      addSideBox(stones, side,
                 {left - overhang(walled(bayLeft)), right + overhang(walled(bayRight)), 0.0, kPlinth, 0.0,
                  kPillar + kOverhang},
                 repeating(1.5), kAllFaces & ~kMinusY);
      addSideBox(stones, side,
                 {left - overhang(screened(bayLeft)), right + overhang(screened(bayRight)), capitalBase, kEaves, 0.0,
                  kPillar + kOverhang},
                 repeating(1.5));
    }
  }
}

void addWalls(MeshBuilder& screens, MeshBuilder& parapets, MeshBuilder& stones) {
  constexpr double kParapet = 0.94, kCoping = 0.08, kThickness = 0.25;
  constexpr unsigned kUpright = kAllFaces & ~(kPlusY | kMinusY);
  const auto left = [](int bay) { return (bay - 2) * kSpacing + 0.5 * kPillar; };
  const double width = kSpacing - kPillar;
  for (int side = 0; side < kSides; ++side) {
    const double screen = left(kBays[side].screen);
    addSideBox(screens, side, {screen, screen + width, 0.0, kEaves, 0.0, kThickness}, atlasColumn(side, 0.0, 1.0, 1.0),
               kUpright);
    for (int bay : {kBays[side].parapetA, kBays[side].parapetB}) {
      const double x0 = left(bay), x1 = x0 + width;
      addSideBox(parapets, side, {x0, x1, 0.0, kParapet, 0.0, kThickness}, atlasRow(side), kUpright);
      addSideBox(stones, side, {x0, x1, kParapet, kParapet + kCoping, 0.0, kThickness + 0.05}, repeating(1.5));
    }
  }
}

void addBeams(MeshBuilder& beams, MeshBuilder& rafters) {
  const double outer = kInner + kPillar;
  for (int side = 0; side < kSides; ++side) {
    const double reach = side == kNorth || side == kSouth ? outer : kInner;
    addSideBox(beams, side, {-reach, reach, kEaves, kTop, 0.0, kPillar}, alongBeam);
  }
  constexpr double kHalf = 0.11, kDepth = 0.34, kRafterSpacing = 1.5, kOverhang = 0.7;
  for (int i = -2; i <= 2; ++i) {
    const double z = i * kRafterSpacing;
    rafters.box({-outer - kOverhang, kTop, z - kHalf}, {outer + kOverhang, kTop + kDepth, z + kHalf}, alongBeam);
  }
  // Cross pieces between the rafters: undersides in the same plane, no two faces on top of each other.
  for (double x : {-1.5, 1.5}) {
    for (int i = -3; i <= 2; ++i) {
      const double z0 = i == -3 ? -outer - kOverhang : i * kRafterSpacing + kHalf;
      const double z1 = i == 2 ? outer + kOverhang : (i + 1) * kRafterSpacing - kHalf;
      rafters.box({x - kHalf, kTop, z0}, {x + kHalf, kTop + kDepth, z1}, alongBeam);
    }
  }
}

/// A stone frame around the mirror, level with it, and a step down to the lawn.
void addSlab(MeshBuilder& slab) {
  const auto frame = [&slab](double inner, double outer, double top, double bottom) {
    for (int side = 0; side < kSides; ++side) {
      const double reach = side == kNorth || side == kSouth ? outer : inner;
      addSideBox(slab, side, {-reach, reach, bottom, top, inner - kInner, outer - kInner}, repeating(1.5),
                 kAllFaces & ~kMinusY);
    }
  };
  frame(kInner, 5.7, 0.0, -0.15);
  frame(5.7, 6.3, -0.15, kGround);
}

/// A ring of hills: the outline of three sines, flat-coloured, seen from inside only.
MeshBuilder hills(double radius, double height, double phase) {
  constexpr int kSteps = 96;
  constexpr double kTurn = 6.283185307179586;
  MeshBuilder builder;
  const auto top = [&](double a) {
    return height * (0.55 + 0.2 * std::sin(3 * a + phase) + 0.15 * std::sin(7 * a + 2.1 * phase) +
                     0.1 * std::sin(13 * a + 0.7 * phase));
  };
  const auto point = [&](double a, double y) { return glm::dvec3(radius * std::sin(a), y, -radius * std::cos(a)); };
  for (int i = 0; i < kSteps; ++i) {
    const double a = kTurn * i / kSteps, b = i + 1 == kSteps ? 0.0 : kTurn * (i + 1) / kSteps;
    builder.quadrilateral(point(a, kGround), point(b, kGround), point(b, top(b)), point(a, top(a)));
  }
  return builder;
}

/// A slim tree of unit height.
MeshBuilder cypress() {
  constexpr int kRings = 9;
  std::vector<glm::dvec2> profile, normals;
  for (int i = 0; i <= kRings; ++i) {
    const double t = static_cast<double>(i) / kRings;
    const double radius = i == kRings ? 0.0 : 0.115 * std::sqrt(1.0 - t) * (0.35 + 0.65 * std::sqrt(t)) + 0.0;
    profile.emplace_back(radius, 0.02 + 0.98 * t);
    normals.emplace_back(std::sqrt(1.0 - 0.3 * t * t), std::sqrt(0.3) * t);
  }
  MeshBuilder builder;
  builder.lathe(profile, normals, 14);
  return builder;
}

}  // namespace

Model building() {
  Composer scene;
  MeshBuilder shafts, stones, screens, parapets, beams, rafters, slab, ground, mirror;
  addPillars(shafts, stones);
  addWalls(screens, parapets, stones);
  addBeams(beams, rafters);
  addSlab(slab);
  ground.disc({0.0, kGround, 0.0}, kHorizon, 64, 8.0);
  mirror.quad({-kInner, 0.0, kInner}, {2.0 * kInner, 0.0, 0.0}, {0.0, 0.0, -2.0 * kInner});

  const int mirrorMaterial = scene.material(perfectMirror("mirror"));
  const int sphereMaterial = scene.material(perfectMirror("sphere"));
  const int stoneMaterial = scene.material(tiled("stone", stonePicture(), kGlow));
  const int woodMaterial = scene.material(tiled("wood", woodPicture(), kGlow));
  scene.add("mirror", std::move(mirror), mirrorMaterial);
  scene.add("pillars", std::move(shafts), scene.material(lit("pillars", pillarPicture(), kGlow)));
  scene.add("plinths and copings", std::move(stones), stoneMaterial);
  scene.add("screens", std::move(screens), scene.material(lit("screens", screenPicture(), kGlow)));
  scene.add("parapets", std::move(parapets), scene.material(lit("parapets", parapetPicture(), kGlow)));
  scene.add("beams", std::move(beams), woodMaterial);
  scene.add("rafters", std::move(rafters), woodMaterial);
  scene.add("slab", std::move(slab), stoneMaterial);
  scene.add("ground", std::move(ground), scene.material(tiled("lawn", lawnPicture(), 0.2f)));
  scene.add("near hills", hills(52.0, 4.6, 1.0), scene.material(unlit("near hills", glm::vec3(0.10f, 0.19f, 0.17f))));
  scene.add("far hills", hills(kHorizon - 0.5, 9.5, 4.2),
            scene.material(unlit("far hills", glm::vec3(0.22f, 0.33f, 0.42f))));

  const int tree =
      scene.mesh(cypress(), "cypress", scene.material(lit("cypress", glm::vec3(0.03f, 0.075f, 0.03f), 0.2f)));
  struct Tree {
    double x, z, height;
  };
  int number = 0;
  for (const Tree& t : {Tree{-3.6, -11.5, 5.6}, Tree{1.2, -15.0, 6.4}, Tree{4.6, -10.2, 5.0}, Tree{11.0, -7.5, 6.0},
                        Tree{12.5, -1.4, 5.2}, Tree{10.4, 3.6, 6.6}, Tree{6.8, 11.5, 5.4}, Tree{0.9, 13.5, 6.2},
                        Tree{-4.8, 10.8, 5.0}, Tree{-10.6, 6.2, 6.1}, Tree{-13.0, 0.8, 5.5}, Tree{-10.8, -5.6, 6.5}})
    scene.place("cypress " + std::to_string(++number), tree, {t.x, kGround, t.z}, t.height);

  // Eight along the edges, each turned to other parts of the building, and one near the middle.
  const int ball = scene.mesh(sphere(0.5, 48), "sphere", sphereMaterial);
  number = 0;
  for (const glm::dvec2& p : {glm::dvec2(-3.6, -3.6), glm::dvec2(0.2, -3.7), glm::dvec2(3.6, -3.4),
                              glm::dvec2(3.7, 0.3), glm::dvec2(3.5, 3.6), glm::dvec2(-0.3, 3.6), glm::dvec2(-3.6, 3.5),
                              glm::dvec2(-3.7, -0.2), glm::dvec2(0.4, -0.3)})
    scene.place("sphere " + std::to_string(++number), ball, {p.x, 0.5, p.y});
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
