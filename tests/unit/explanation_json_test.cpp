// The JSON of an explained pixel: the documented fields, with null for what is undefined.
#include "app/session/explanation_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/kept_values.h"
#include "tests/unit/explained_hall.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers with five digits; of long lists the first two.
std::string shortText(const Json& json) {
  if (json.is_number_float()) return test::keptNumber(json.get<double>());
  if (!json.is_structured()) return json.dump();
  std::string text;
  std::size_t count = 0;
  for (const auto& [key, value] : json.items()) {
    if (json.is_array() && value.is_structured() && ++count > 2)
      return text + " of " + std::to_string(json.size()) + "]";
    text += (text.empty() ? "" : " ") + (json.is_object() ? key + "=" : std::string()) + shortText(value);
  }
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

TEST(ExplanationJson, HoldsTheDocumentedFields) {
  const Explanation e = ExplainedRoom().explain();
  const auto json = nlohmann::json::parse(explanationJson(e));
  EXPECT_EQ(json["pixel"], nlohmann::json({640, 360}));
  EXPECT_EQ(json["positionWorld"], nlohmann::json({0.5, 0.0, 0.0}));
  EXPECT_FLOAT_EQ(json["color"][0].get<float>(), e.rendered->x) << "as rendered";
  EXPECT_FLOAT_EQ(json["colorComputed"][0].get<float>(), e.color.x);
  for (const char* field : {"normalWorld", "reflectionWorld", "direct", "emissive", "diffuse"}) {
    EXPECT_EQ(json[field].size(), 3u) << field;
  }
  EXPECT_EQ(json["sky"]["weight"], 0.0);
  EXPECT_EQ(json["sky"]["value"].size(), 3u);
  const auto& probe = json["probes"].at(0);
  EXPECT_EQ(probe["name"], "room");
  EXPECT_EQ(probe["weight"], 1.0);
  EXPECT_EQ(probe["technique"], "box+none");
  EXPECT_EQ(probe["face"], "+x");
  EXPECT_NEAR(probe["slabFactors"][1].get<double>(), 4.24264, 1e-5);
  EXPECT_NEAR(probe["hitDistance"].get<double>(), 2.12132, 1e-5);
  EXPECT_NEAR(probe["hitWorld"][1].get<double>(), 1.5, 1e-6);
  const auto& lookup = probe["lookups"].at(0);
  EXPECT_EQ(lookup["direction"].size(), 3u);
  EXPECT_EQ(lookup["weight"], 1.0);
  EXPECT_NEAR(lookup["value"][0].get<double>(), 0.1, 1e-6);
  EXPECT_FALSE(lookup["texels"].empty());
}

TEST(ExplanationJson, TellsLampsAndNodesOfDiffuseLight) {
  Explanation e = ExplainedRoom().explain();
  e.diffuse = {0.3f, 0.2f, 0.1f};
  e.color = {0.6f, 0.5f, 0.4f};
  const auto before = nlohmann::json::parse(explanationJson(e));
  EXPECT_FALSE(before["probes"].at(0).contains("diffuse")) << "of nine coefficients there is nothing to tell";
  EXPECT_NEAR(before["diffuseShare"].get<double>(), 0.4, 1e-6);
  DiffuseExplanation& d = e.probes[0].diffuse;
  d.lamps = {{"ceiling lamp", {0.5f, 0.4f, 0.3f}, 0.06f}};
  d.nodes = {{{2, 0, 1}, {0.1f, -0.9f, 0.7f}, 0.75f}, {{3, 0, 1}, {1.1f, -0.9f, 0.7f}, 0.25f}};
  d.nodeCount = {5, 4, 7};
  d.lattice = {0.11f, 0.12f, 0.13f};
  const auto diffuse = nlohmann::json::parse(explanationJson(e))["probes"].at(0)["diffuse"];
  EXPECT_EQ(diffuse["lamps"].at(0)["object"], "ceiling lamp");
  EXPECT_NEAR(diffuse["lamps"].at(0)["light"][1].get<double>(), 0.4, 1e-6);
  EXPECT_NEAR(diffuse["lamps"].at(0)["filled"].get<double>(), 0.06, 1e-6);
  EXPECT_EQ(diffuse["lattice"]["nodes"], nlohmann::json({5, 4, 7}));
  EXPECT_NEAR(diffuse["lattice"]["light"][2].get<double>(), 0.13, 1e-6);
  EXPECT_EQ(diffuse["lattice"]["at"].at(1)["node"], nlohmann::json({3, 0, 1}));
  EXPECT_EQ(diffuse["lattice"]["at"].at(1)["weight"], 0.25);
  EXPECT_NEAR(diffuse["lattice"]["at"].at(1)["positionProbe"][0].get<double>(), 1.1, 1e-6);
}

TEST(ExplanationJson, WhatIsUndefinedIsNull) {
  ExplainedRoom room;
  room.probe.technique = "infinite";
  const auto json = nlohmann::json::parse(explanationJson(room.explain()));
  EXPECT_TRUE(json["probes"][0]["hitDistance"].is_null());
  EXPECT_TRUE(json["probes"][0]["slabFactors"].is_null());
  EXPECT_FALSE(json["notes"].empty());

  const auto background = nlohmann::json::parse(explanationJson(Explanation{}));
  EXPECT_TRUE(background["positionWorld"].is_null());
  EXPECT_EQ(background["background"], true);
}

// After a change that is wanted, BOXPROBE_WRITE_VALUES=1 writes the file anew.
TEST(ExplanationJson, ValuesAreKept) {
  std::vector<std::string> lines;
  for (const test::HallCase& each : test::hallCases()) {
    test::HallPixel pixel;
    each.change(pixel);
    Explanation e = pixel.explain();
    if (each.name.size() % 2 == 0) e.rendered = e.color * 1.03f + 0.002f;
    const Json json = Json::parse(explanationJson(e, verdictOf(e, pixel.scene)));
    lines.push_back("== " + each.name);
    for (const auto& [key, value] : json.items()) {
      if (key != "probes") lines.push_back(key + " " + shortText(value));
    }
    for (const Json& probe : json["probes"]) {
      lines.push_back("probe");
      for (const auto& [key, value] : probe.items()) lines.push_back("  " + key + " " + shortText(value));
    }
  }
  test::expectKeptValues("unit/values/json_values.txt", lines);
}

TEST(ExplanationJson, NamesOfAnyBytesAreWritten) {
  ExplainedRoom room;
  room.surface.object = "caf\xe9";
  EXPECT_TRUE(nlohmann::json::accept(explanationJson(room.explain())));
}

}  // namespace
}  // namespace boxprobe
