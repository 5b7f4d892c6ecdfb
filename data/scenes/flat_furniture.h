// What stands in `flat`. Each is drawn about or from a place that is given, metres, in the flat's materials. Called by
// flat.cpp; knows nothing of the rooms.
#pragma once

#include <string>

#include "data/scenes/home.h"

namespace boxprobe::scenes {

/// Indices of the flat's materials.
struct FlatMaterials {
  int oak, walnut, white, sofa, armchair, pillow1, pillow2, throwBlanket, rug, linen, brass, steel, black, glassBlack,
      mirror, books, leaf, pot, vase, bark, cabinet, counter, tiles, shade, lampLight, warmLight, shadeLight,
      stripLight, paper, fruit1, fruit2, cream;
  int paintings[4];
};

/// About +Y by `degrees`, then moved.
glm::dmat4 placedAt(glm::dvec3 position, double degrees = 0.0);

/// In their own frames the front is +Z, the floor y = 0 and the back z = 0.
void addSofa(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addArmchair(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addCoffeeTable(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addFloorLamp(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addCeilingLamp(Home& home, const FlatMaterials& m, glm::dvec3 ceiling);
void addBookshelf(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addSideboard(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addPlant(Home& home, const FlatMaterials& m, glm::dvec3 position, double height, int seed);
void addVase(Home& home, const FlatMaterials& m, glm::dvec3 position, double height, bool branches);
/// On the wall behind it: its middle is given.
void addPainting(Home& home, const FlatMaterials& m, int which, const glm::dmat4& placed, glm::dvec2 size);
void addRoundMirror(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double radius);
/// Hung from `top`, `width` along +X, down to the floor.
void addCurtain(Home& home, const FlatMaterials& m, const glm::dmat4& top, double width, double height, int folds);
/// Standing books from left to right along +X.
void addBooks(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double width, double most, double depth,
              int seed);

// The kitchen's.
void addKitchenCounter(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double length);
void addTallCabinet(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addTable(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addChair(Home& home, const FlatMaterials& m, const glm::dmat4& placed);
void addPendant(Home& home, const FlatMaterials& m, glm::dvec3 ceiling, double drop);

}  // namespace boxprobe::scenes
