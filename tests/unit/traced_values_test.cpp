// What is traced in a house, against sight_values.txt, lattice_values.txt and outdoor_values.txt: visibilities of
// lamps, light from node to node, how open the sky is, shadows on the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/ground_shadow.h"
#include "filters/core/geometry/lamp_reach.h"
#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_diffuse.h"
#include "filters/core/geometry/sky_openness.h"
#include "filters/core/geometry/traced_lattice.h"
#include "tests/support/kept_values.h"
#include "tests/unit/geometry_house.h"

namespace boxprobe::test {
namespace {

using Lines = std::vector<std::string>;
using glm::dvec3;

std::string nodesText(const glm::ivec3& nodes) {
  return std::to_string(nodes.x) + " x " + std::to_string(nodes.y) + " x " + std::to_string(nodes.z);
}

std::string channelsText(const std::vector<int>& channels) {
  std::string text;
  for (const int channel : channels) text += " " + std::to_string(channel);
  return text;
}

void addSight(Lines& lines, const ProbeSight& sight) {
  std::string lamps;
  for (const std::size_t lamp : sight.lamps) lamps += " " + std::to_string(lamp);
  lines.push_back("  lamps" + lamps + " in" + channelsText(sight.lampChannel) + ", sources in" +
                  channelsText(sight.sourceChannel) + ", " + std::to_string(sight.rays) + " rays, whole " +
                  std::to_string(sight.unshadowed) + ", " + nodesText(sight.lattice.nodes) + " nodes of " +
                  std::to_string(sight.lattice.channels) + " from " + keptVector(sight.lattice.low) + " to " +
                  keptVector(sight.lattice.high) + " about " + keptVector(sight.middleWorld));
  const std::size_t nodes =
      sight.lattice.texels.size() / 4 / static_cast<std::size_t>(std::max(sight.lattice.parts(), 1));
  for (int channel = 0; channel < 4 * sight.lattice.parts(); ++channel) {
    std::vector<double> shares;
    for (std::size_t node = 0; node < nodes; ++node) {
      const std::size_t first = 4 * nodes * static_cast<std::size_t>(channel / 4);
      shares.push_back(sight.lattice.texels[first + 4 * node + static_cast<std::size_t>(channel % 4)] / 255.0);
    }
    lines.push_back("  channel " + std::to_string(channel) + " " + digest(shares));
  }
}

void addSights(Lines& lines) {
  const House house;
  const Scene scene = house.scene();
  const SceneLamps lamps = sceneLamps(scene, {house.model()});
  const std::atomic<bool> go{false};
  const SightSettings settings{0.45, 900};
  for (const Probe& probe : scene.probes) {
    lines.push_back("== sight of " + probe.name);
    SightTask task = sightTask(scene, lamps, probe);
    task.box = openBox(house, task);
    lines.push_back("  in " + keptBox(task.box));
    const ProbeSight sight = probeSight(house, task, go, settings);
    addSight(lines, sight);
    const ProbeGeometry geometry = probeGeometry(probe, probe.origin);
    const dvec3 places[] = {{0.4, 0.02, 0.9}, {-1.3, 0.02, -1.4}, {1.5, 1.0, -0.9}, {-0.6, 1.4, -3.0}};
    for (const dvec3& place : places) {
      std::string text = "  seen at " + keptVector(place);
      for (int channel = -2; channel < sight.lattice.channels; ++channel) {
        text +=
            " " + keptNumber(seenAt(&sight, channel, geometry, place, glm::normalize(glm::vec3(0.2f, 1.0f, 0.1f))), 3);
      }
      const std::array<double, 6> around = {place.x - 0.2, place.x + 0.3, place.y,
                                            place.y + 0.1, place.z,       place.z + 0.4};
      for (int channel = -2; channel < sight.lattice.channels; ++channel) {
        text += seenWithin(sight, channel, around) ? " yes" : " no";
      }
      lines.push_back(text);
    }
    lines.push_back("  captured from " + keptBox(boxSeenFrom(house, probe.origin)));
    SightTask captured = captureSightTask(scene, lamps, probe);
    captured.box = boxSeenFrom(house, probe.origin);
    addSight(lines, probeSight(house, captured, go, {0.9, 400}));
  }
}

/// What a capture in the house could look like: a sky of its own through the window.
CubeMap capture(double seed, bool window) {
  CubeMap map(16, 1);
  for (int i = 0; i < 6 * 256; ++i) {
    const int face = i / 256, row = i / 16 % 16, column = i % 16;
    const dvec3 d(glm::normalize(shading::cubeDirection(face, (2.0f * static_cast<float>(column) + 1.0f) / 16.0f - 1.0f,
                                                        (2.0f * static_cast<float>(row) + 1.0f) / 16.0f - 1.0f)));
    const double alpha = window && d.x > 0.6 && std::abs(d.y) < 0.3 ? 0.4 + d.z * 0.5 : 1.0;
    map.setTexel(0, face, column, row,
                 glm::vec4(glm::dvec4(0.9 + 0.5 * std::sin(3.0 * d.x + seed), 0.8 + 0.4 * std::cos(2.0 * d.y + seed),
                                      0.7 + 0.3 * std::sin(4.0 * d.z - seed), alpha)));
  }
  return map;
}

void addLattice(Lines& lines, const std::string& name, const DiffuseLattice& lattice) {
  const std::size_t nodes = lattice.texels.size() / DiffuseLattice::kParts;
  lines.push_back("  " + name + " " + nodesText(lattice.nodes) + " from " + keptVector(lattice.low) + " to " +
                  keptVector(lattice.high) + ", ways cut " + std::to_string(lattice.cutWays));
  for (std::size_t part = 0; part < DiffuseLattice::kParts; ++part) {
    for (int c = 0; c < 4; ++c) {
      std::vector<double> values;
      for (std::size_t node = 0; node < nodes; ++node) values.push_back(lattice.texels[part * nodes + node][c]);
      lines.push_back("    part " + std::to_string(part) + " " + std::to_string(c) + ": " + digest(values));
    }
  }
  for (int c = 0; c < 3 && !lattice.cuts.empty(); ++c) {
    std::vector<double> values;
    for (const glm::vec4& cut : lattice.cuts) values.push_back(cut[c]);
    lines.push_back("    cuts " + std::to_string(c) + ": " + digest(values));
  }
}

void addLattices(Lines& lines) {
  auto house = std::make_shared<House>();
  const Scene scene = house->scene();
  LatticeSurroundings in;
  in.lines = house;
  in.lamps = std::make_shared<const SceneLamps>(sceneLamps(scene, {house->model()}));
  in.lights = std::make_shared<const std::vector<Light>>(scene.lights);
  for (const Probe& probe : scene.probes) {
    const dvec3 capturedRotation = probe.name == "first" ? dvec3(0.0) : dvec3(4.0, -9.0, 2.0);
    const ProbeGeometry geometry = probeGeometry(probe, probe.origin, capturedRotation);
    in.originWorld = probe.origin;
    in.worldFromProbe = geometry.worldFromProbe;
    in.mapFromProbe = geometry.mapFromProbe;
    in.drawn = probeLamps(in.lamps->lamps, probe);
    const CubeMap means = plainMeans(capture(0.7, true));
    LatticeSettings settings;
    settings.spacing = 1.1f;
    settings.rays = 96;
    settings.reachLow = {0.0f, 0.0f, 0.5f};
    settings.reachHigh = {0.4f, 0.0f, 0.0f};
    const CubeMap skyMeans = plainMeans(capture(2.9, false));
    const DiffuseLattice base =
        makeDiffuseLattice(means, probeShape(geometry, 4.0f, 0.0f), glm::mat3(geometry.mapFromProbe),
                           glm::mat3(geometry.worldFromProbe), settings, probe.name == "first" ? &skyMeans : nullptr);
    lines.push_back("== lattice of " + probe.name);
    addLattice(lines, "by projection", base);
    for (int form = 0; form < 3; ++form) {
      in.sky = form == 0 ? nullptr : std::make_shared<const CubeMap>(capture(2.9, false));
      in.open = form == 2;
      lines.push_back("  spacing " + keptNumber(tracedSpacing(geometry.boxMin, geometry.boxMax, 1.0f, means, in)));
      const DiffuseLattice traced = tracedLattice(base, means, in, 96);
      addLattice(lines, form == 0 ? "traced" : form == 1 ? "traced under a sky" : "traced, open", traced);
      if (form != 1) continue;
      ProbeDiffuse diffuse;
      diffuse.lattice = std::make_shared<const DiffuseLattice>(traced);
      for (const std::size_t i : in.drawn) diffuse.lamps.push_back(in.lamps->lamps[i]);
      for (const dvec3& place : {dvec3(0.4, 0.02, 0.9), dvec3(-1.3, 0.4, -1.4), dvec3(-0.6, 1.4, -3.0)}) {
        lines.push_back("    diffuse at " + keptVector(place) + " " +
                        keptVector(diffuseAt(diffuse, geometry, place, glm::normalize(glm::vec3(0.2f, 1.0f, 0.1f)))));
      }
    }
  }
}

void addOutdoors(Lines& lines) {
  House bench;
  bench.panels.erase(
      std::remove_if(bench.panels.begin(), bench.panels.end(),
                     [](const Panel& p) { return p.node != "table" && p.node != "screen" && p.node != "box lamp"; }),
      bench.panels.end());
  const Box around{{-0.7, 0.0, 0.4}, {1.63, 1.5, 1.9}};
  lines.emplace_back("== outdoors");
  const SkyOpenness open = tracedSkyOpenness(bench, {{-0.9, 0.4, 0.3}, {1.8, 0.9, 1.5}});
  lines.push_back("openness " + nodesText(open.nodes) + " from " + keptVector(open.low) + " by " +
                  keptNumber(open.spacing) + ", " + std::to_string(open.rays) + " rays");
  for (std::size_t c = 0; c < 4; ++c) {
    std::vector<double> values;
    for (std::size_t i = c; i < open.texels.size(); i += 4) values.push_back(open.texels[i] / 255.0);
    lines.push_back("  channel " + std::to_string(c) + " " + digest(values));
  }
  for (const dvec3& place :
       {dvec3(0.1, 0.74, 0.8), dvec3(0.2, 0.68, 0.9), dvec3(1.63, 0.7, 1.2), dvec3(-0.7, 0.7, 0.6)}) {
    for (const glm::vec3& normal : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(-1, 0, 0)}) {
      lines.push_back("  open at " + keptVector(place) + " " + keptNumber(open.at(place, normal)));
    }
  }
  const GroundShadow ground = tracedGroundShadow(bench, around);
  lines.push_back("ground " + keptNumber(ground.height) + " " + keptNumber(ground.low.x) + " " +
                  keptNumber(ground.low.y) + " to " + keptNumber(ground.high.x) + " " + keptNumber(ground.high.y) +
                  ", " + std::to_string(ground.columns) + " x " + std::to_string(ground.rows) + " " +
                  digest({ground.light.begin(), ground.light.end()}));
}

TEST(TracedValues, OfSightsAreKept) {
  Lines lines;
  addSights(lines);
  test::expectKeptValues("unit/values/sight_values.txt", lines);
}

TEST(TracedValues, OfLatticesAreKept) {
  Lines lines;
  addLattices(lines);
  test::expectKeptValues("unit/values/lattice_values.txt", lines);
}

TEST(TracedValues, OutdoorsAreKept) {
  Lines lines;
  addOutdoors(lines);
  test::expectKeptValues("unit/values/outdoor_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
