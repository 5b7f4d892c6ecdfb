// What a model file may be meant as: its unit and its up axis, on rooms and things made here.
#include "filters/fit/import_guess.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "filters/fit/fit_model.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

std::optional<ImportGuess> guessOf(const std::string& name, Model model, const glm::dmat4& placed = glm::dmat4(1.0),
                                   const ModelFile& as = {}) {
  for (Instance& instance : model.instances) instance.worldFromModel = placed * instance.worldFromModel;
  Scene scene;
  ModelFile file = as;
  file.file = name;
  scene.models = {file};
  return fitModel(scene, {std::make_shared<const Model>(std::move(model))}).guess;
}

Model boxModel(const Box& bounds, bool inwards) {
  MadeModel made;
  made.box(bounds, inwards);
  return made.model;
}

const Box kFlatRoom{glm::dvec3(-4, 0, -3), glm::dvec3(4, 2.8, 3)};

glm::dmat4 scaled(double factor) {
  return glm::scale(glm::dmat4(1.0), glm::dvec3(factor));
}

/// +Y of the room becomes +Z of the file.
glm::dmat4 lyingDown() {
  return glm::rotate(glm::dmat4(1.0), glm::radians(90.0), {1.0, 0.0, 0.0});
}

TEST(ImportGuess, WhatIsPlausibleIsNotAskedAbout) {
  EXPECT_FALSE(guessOf("room.glb", boxModel(kFlatRoom, true)));
  EXPECT_FALSE(guessOf("room.obj", boxModel(kFlatRoom, true)));
  EXPECT_FALSE(guessOf("crate.glb", boxModel({glm::dvec3(-0.5, 0, -0.5), glm::dvec3(0.5, 1, 0.5)}, false)));
  EXPECT_FALSE(guessOf("crate.stl", boxModel({glm::dvec3(-0.5, 0, -0.5), glm::dvec3(0.5, 1, 0.5)}, false)));
  // Higher than wide, and a corridor narrower than high.
  EXPECT_FALSE(guessOf("tower.glb", boxModel({glm::dvec3(-2, 0, -2), glm::dvec3(2, 20, 2)}, true)));
  EXPECT_FALSE(guessOf("corridor.glb", boxModel({glm::dvec3(-10, -1, -1), glm::dvec3(10, 2, 1)}, true)));
  // A picture on a wall, in a file that is in metres with Y up.
  EXPECT_FALSE(guessOf("picture.glb", boxModel({glm::dvec3(-0.5, -0.4, 0), glm::dvec3(0.5, 0.4, 0.05)}, false)));
}

TEST(ImportGuess, ARoomInCentimetresOrMillimetres) {
  const auto centimetres = guessOf("room.glb", boxModel(kFlatRoom, true), scaled(100.0));
  ASSERT_TRUE(centimetres);
  EXPECT_EQ(centimetres->unit, LengthUnit::Centimetre);
  EXPECT_EQ(centimetres->upAxis, UpAxis::Y);
  EXPECT_EQ(centimetres->reason.english(), "In metres it would be 800 m wide");
  const auto millimetres = guessOf("room.obj", boxModel(kFlatRoom, true), scaled(1000.0));
  ASSERT_TRUE(millimetres);
  EXPECT_EQ(millimetres->unit, LengthUnit::Millimetre);
}

TEST(ImportGuess, ThingsOfFilesWithoutAUnit) {
  const Box crate{glm::dvec3(-30, 0, -30), glm::dvec3(30, 60, 30)};
  const auto printed = guessOf("crate.STL", boxModel(crate, false));
  ASSERT_TRUE(printed);
  EXPECT_EQ(printed->unit, LengthUnit::Millimetre) << "what is printed is drawn in millimetres";
  const auto drawn = guessOf("crate.obj", boxModel(crate, false));
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->unit, LengthUnit::Centimetre);
  EXPECT_FALSE(guessOf("crate.glb", boxModel(crate, false))) << "this file says that it is in metres";
}

// No room: what it stands on is all there is to tell by.
TEST(ImportGuess, AThingThatStandsOnZIsTurnedUpright) {
  const auto standing =
      guessOf("statue.obj", boxModel({glm::dvec3(-0.31, -0.27, 0), glm::dvec3(0.4, 0.33, 1.9)}, false));
  ASSERT_TRUE(standing);
  EXPECT_EQ(standing->upAxis, UpAxis::Z);
  // A tenth of its depth below y = 0 may be a lip.
  EXPECT_FALSE(guessOf("relief.obj", boxModel({glm::dvec3(-0.31, -0.06, 0), glm::dvec3(0.4, 0.54, 1.9)}, false)));
}

TEST(ImportGuess, ARoomOnItsSideIsTurnedUpright) {
  const auto lying = guessOf("room.obj", boxModel(kFlatRoom, true), lyingDown());
  ASSERT_TRUE(lying);
  EXPECT_EQ(lying->upAxis, UpAxis::Z);
  EXPECT_EQ(lying->unit, LengthUnit::Metre);
  const auto both = guessOf("room.glb", boxModel(kFlatRoom, true), scaled(100.0) * lyingDown());
  ASSERT_TRUE(both);
  EXPECT_EQ(both->upAxis, UpAxis::Z);
  EXPECT_EQ(both->unit, LengthUnit::Centimetre);
}

TEST(ImportGuess, WhatTheSceneSaysIsNotAskedAgain) {
  ModelFile said;
  said.unit = LengthUnit::Centimetre;
  EXPECT_FALSE(guessOf("room.glb", boxModel(kFlatRoom, true), scaled(1000.0), said));
  said = {};
  said.scale = 0.01;
  EXPECT_FALSE(guessOf("room.glb", boxModel(kFlatRoom, true), scaled(100000.0), said));
}

}  // namespace
}  // namespace boxprobe
