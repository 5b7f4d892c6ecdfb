// What the commands say and write of fits, placements, frames and stress tests, made from results in which every number
// is another, against report_values.txt.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/report/fit_report.h"
#include "app/cli/report/frame_costs.h"
#include "app/cli/report/frame_info.h"
#include "app/cli/report/place_report.h"
#include "app/cli/report/stress_report.h"
#include "filters/stress/stress_subjects.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

std::string text(const nlohmann::ordered_json& json) {
  return json.dump(1);
}

/// Numbers that are all different, a little larger each.
class Numbers {
 public:
  explicit Numbers(double first) : next_(first) {}
  double operator()() { return next_ += 0.0371; }
  glm::dvec3 three() {
    const double x = (*this)(), y = (*this)();
    return {x, y, (*this)()};
  }

 private:
  double next_;
};

BoxFit oddFit(Numbers& n) {
  BoxFit fit;
  fit.outcome = FitOutcome::Fitted;
  fit.probe.name = "fitted";
  fit.probe.origin = n.three();
  fit.probe.box = {-n.three(), 2.0 * n.three()};
  fit.probe.rotationDegrees = n.three();
  fit.before = {n(), n(), n()};
  fit.after = {n(), n(), n()};
  for (std::size_t i = 0; i < fit.faces.size(); ++i) fit.faces[i] = {n(), n(), i == 1 || i == 4};
  fit.hiddenBefore = n();
  fit.hidden = n();
  fit.open = n();
  fit.seconds = n();
  fit.remarks = {Phrase::plain("first remark"), Phrase::plain("second remark")};
  return fit;
}

Probe oddProbe(Numbers& n, const std::string& name) {
  Probe probe;
  probe.name = name;
  probe.origin = n.three();
  probe.box = {-n.three(), n.three()};
  probe.rotationDegrees = {0.0, n(), 0.0};
  return probe;
}

void addFits(test::KeptValues& values) {
  Numbers n(0.2);
  const Probe before = oddProbe(n, "hall");
  BoxFit fit = oddFit(n);
  FitLightErrors light{n(), n(), {}};
  for (double& gain : light.faceGain) gain = n();
  values.part("fit");
  values.add(text(fitJson(before, fit)));
  values.add(fitText(before, fit));
  values.part("fit with light, kept, the origin where it was");
  fit.outcome = FitOutcome::Kept;
  fit.remarks.clear();
  fit.probe.origin = before.origin;
  fit.probe.rotationDegrees = before.rotationDegrees;
  values.add(text(fitJson(before, fit, light)));
  values.add(fitText(before, fit, light));
  fit.outcome = FitOutcome::Fitted;
  for (const double hidden : {0.005, 0.0051}) {
    fit.hidden = hidden;
    values.add(fitText(before, fit).substr(0, 170));
  }
  for (const FitOutcome outcome : {FitOutcome::Open, FitOutcome::Inside}) {
    fit.outcome = outcome;
    values.add(fitText(before, fit) + fitJson(before, fit)["outcome"].get<std::string>());
  }
}

LitErrors oddErrors(Numbers& n) {
  return {n(), n(), n(), n()};
}

Placement oddPlacement() {
  Numbers n(0.1);
  Placement placement;
  for (int i = 0; i < 3; ++i) {
    PlacedRoom room;
    room.name = "room " + std::to_string(i + 1);
    room.extent = {-n.three(), 3.0 * n.three()};
    room.yawDegrees = i == 0 ? -0.05 : i == 1 ? 0.049 : n();
    room.middleWorld = n.three();
    room.volume = n();
    if (i != 1) room.doorways.push_back({static_cast<std::size_t>(i), 1, n(), {}});
    if (i == 2) room.doorways.push_back({2, 0, n(), {}});
    room.reflects = i != 1;
    room.parts = static_cast<std::size_t>(i) + 4;
    room.before = oddErrors(n);
    room.after = oddErrors(n);
    if (i != 2) room.decisions = {Phrase::plain("tried this"), Phrase::plain("and that")};
    placement.rooms.push_back(room);
  }
  for (const std::size_t room : {2u, 0u, 2u}) {
    PlacedProbe placed;
    placed.probe = oddProbe(n, "placed " + std::to_string(placement.probes.size()));
    placed.room = room;
    placed.part = placement.probes.size() == 1;
    placed.gainDegrees = n();
    placed.fit = oddFit(n);
    placed.reason = Phrase::plain("it gains");
    placement.probes.push_back(placed);
  }
  placement.kept = {oddProbe(n, "kept a"), oddProbe(n, "kept b")};
  placement.before = oddErrors(n);
  placement.after = oddErrors(n);
  placement.bareBefore = n();
  placement.bareAfter = n();
  placement.remarks = {Phrase::plain("a remark"), Phrase::plain("another")};
  placement.cell = n();
  placement.cells = 4711;
  placement.roomSeconds = n();
  placement.seconds = n();
  return placement;
}

void addPlacements(test::KeptValues& values) {
  Placement placement = oddPlacement();
  Numbers n(0.3);
  PictureCheck check;
  check.eyes = 17;
  check.before = {n(), n(), n()};
  check.after = {n(), n(), n()};
  check.better = true;
  check.sentences = {Phrase::plain("tried one"), Phrase::plain("tried two")};
  check.rooms = {{true, n(), n()}, {false, n(), n()}};
  check.seconds = n();
  values.part("placement");
  values.add(text(placeJson(placement, &check)));
  values.add(placeText(placement, &check));
  values.part("placement without pictures");
  values.add(placeText(placement));
  values.add(text(placeJson(placement)["pictures"]));
  values.part("pictures that tell nothing");
  const std::size_t all = placeText(placement).size();
  check.eyes = 0;
  values.add(placeText(placement, &check).substr(all));
  check.eyes = 3;
  check.before.error = 0.0;
  values.add(placeText(placement, &check).substr(all));
  placement.rooms.clear();
  values.part("placement without rooms");
  values.add(placeText(placement, &check));
}

void addCosts(test::KeptValues& values) {
  Numbers n(1.3);
  FrameCosts costs;
  costs.rounds = 7;
  const auto cost = [&n] { return Cost{10.0 * n(), n(), 100.0 * n()}; };
  costs.frame = cost();
  costs.parts = {{"reflection", "light of probes", cost()}, {"sky", "what is behind", cost()}};
  costs.overdraw = cost();
  for (const std::size_t objects : {1u, 4u, 5u, 9u}) {
    FrameCosts::Program program{{}, cost()};
    for (std::size_t i = 0; i < objects; ++i) program.objects.push_back("object " + std::to_string(i));
    costs.programs.push_back(program);
  }
  costs.objects = {{"floor", "not told", cost()}, {"wall", "", cost()}};
  values.part("costs of a frame");
  values.add(text(frameCostsJson(costs)));
  values.add(frameCostsText(costs));
  costs.cpuTime = false;
  costs.frame.median = 0.0;
  costs.programs.clear();
  values.part("costs of nothing");
  values.add(text(frameCostsJson(costs)));
  values.add(frameCostsText(costs));
}

FrameReport oddFrame() {
  FrameReport report;
  report.drawsByProbeCount = {3, 14, 15, 92, 65};
  report.variants = 35;
  report.bytes = 8979323;
  report.mirrorBytes = 846264;
  report.lookups = FrameReport::Lookups{3.38327, 95.0};
  report.mirrors = {{"floor", true, {}, 640, 360, 5, 2}, {"pond", false, Phrase::plain("it is rough"), 33, 22, 1, 7}};
  for (std::size_t i = 0; i < 45; ++i) {
    FrameReport::Object object;
    object.node = "object " + std::to_string(i);
    object.material = "material " + std::to_string(i % 3);
    object.drawn = i % 5 != 1;
    object.unlit = i == 3;
    if (i % 4 != 2) object.probes = {{"hall", 0.3 + 0.013 * static_cast<double>(i)}, {"store", 0.11}};
    object.sky = 0.02 * static_cast<double>(i);
    object.leftOut = i == 7 ? 2 : 0;
    object.variant = std::to_string(i % 6);
    report.objects.push_back(object);
  }
  report.probes = {{"hall", 12, 9, 3000000, 7, 2}, {"none", 1, 1, 0, 0, 0}, {"store", 5, 4, 7000001, 8, 3}};
  return report;
}

void addFrames(test::KeptValues& values) {
  FrameReport report = oddFrame();
  values.part("frame");
  values.add(text(frameReportJson(report)).substr(0, 6000));
  values.add(frameReportText(report));
  values.part("frame of few objects");
  report.lookups.reset();
  report.mirrors.clear();
  while (report.objects.size() > 6) report.objects.pop_back();
  for (std::size_t i = 0; i < 42; ++i) report.probes.push_back({"p" + std::to_string(i), i, i / 2, 1000 * i, 7, 0});
  values.add(text(frameReportJson(report)));
  values.add(frameReportText(report));
  values.part("frame of as many objects as are listed");
  for (std::size_t i = 0; i < 40; ++i) report.objects.push_back(report.objects[2]);
  report.objects.resize(6);
  const FrameReport::Object drawn = report.objects[4];
  report.objects.assign(40, drawn);
  values.add("ends in", std::vector<std::size_t>{frameReportText(report).find("more; --json") == std::string::npos});
  report.objects.push_back(drawn);
  values.add("ends in", std::vector<std::size_t>{frameReportText(report).find("1 more; --json")});
}

/// What a run might have counted; every cell has other numbers.
stress::StressTally tallyOf(std::uint64_t number) {
  stress::StressTally tally;
  tally.count = 40000 + 13 * number;
  tally.nonFinite = number % 3;
  tally.badLookups = 2 * number + 1;
  tally.broken = 3 * number + 2;
  tally.wrong = number == 2 ? 0 : 7 * number * number + (number % 5 == 0 ? 39000 : 0);
  for (std::size_t m = 0; m < stress::kMeasures; ++m) {
    if ((number + m) % 4 == 3) continue;
    for (int i = 0; i < 20; ++i) tally.errors[m].add(1e-7 * (1.0 + static_cast<double>(number + 3 * m)) * i * i);
  }
  tally.worstSeverity = 0.1 * static_cast<double>(number);
  tally.worstIndex = 77 + number;
  return tally;
}

void addStress(test::KeptValues& values) {
  using namespace stress;
  std::vector<StressCell> cells;
  std::uint64_t number = 0;
  std::vector<const StressClass*> classes;
  for (const StressClass& c : stressClasses()) {
    // Of each kind of promise, and two of the first.
    const auto same = std::count_if(classes.begin(), classes.end(), [&](const auto* k) { return k->held == c.held; });
    if (same < (c.held == Held::All ? 2 : 1)) classes.push_back(&c);
  }
  for (const StressClass* c : classes) {
    for (const char* id : {"box+none", "sphere+none", "term:level", "published:box-select", "published:sphere"}) {
      StressCell cell{c, findSubject(id), tallyOf(number++)};
      if (number == 6) cell.tally = {};
      cells.push_back(cell);
    }
  }
  values.part("stress");
  values.add(stressTable(cells, "cpu"));
  values.add(stressTable(cells, "gpu").substr(0, 120));
  values.add(stressTable({cells.front()}, "gpu"));
  values.add(publishedTable(cells));
  for (std::size_t i = 0; i < 7; ++i) values.add(stressLine(cells[i], 5, "cpu").dump());
  values.add(replayText(cells[2], 5));
  values.part("replay");
  for (const std::size_t i : {0u, 3u, 9u}) {
    values.add(replayReport(*cells[i].inputs, *cells[i].subject, cells[i].worstInput(5)));
  }
  values.part("shares in percent");
  StressCell published = cells[3];
  for (const std::uint64_t wrong : {0u, 3u, 4u, 5u, 39799u, 39800u, 39801u, 40000u}) {
    published.tally.count = 40000;
    published.tally.wrong = wrong;
    values.add(publishedTable({published}).substr(0, 140));
  }
}

TEST(ReportValues, AreThoseOfTheFile) {
  test::KeptValues values;
  addFits(values);
  addPlacements(values);
  addCosts(values);
  addFrames(values);
  addStress(values);
  values.expect("unit/values/report_values.txt");
}

}  // namespace
}  // namespace boxprobe
