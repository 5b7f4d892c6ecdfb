// vtkReflectionProbe, vtkReflectionProbes and vtkReflectionProbeFit as plain objects: defaults, each setter once, what
// counts as a change, conversion field by field, and which actors of a renderer are taken. No window.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkSphereSource.h>

#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "filters/vtk/placement/vtkReflectionProbeFit.h"

namespace boxprobe {
namespace {

/// What it prints from a line on.
std::string printed(vtkObject* object, const std::string& from) {
  std::ostringstream text;
  object->PrintSelf(text, vtkIndent());
  const std::size_t at = text.str().find(from);
  return at == std::string::npos ? text.str() : text.str().substr(at);
}

struct Lines {
  explicit Lines(vtkObject* object) {
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* client, void* data) {
      static_cast<Lines*>(client)->all.emplace_back(static_cast<const char*>(data));
    });
    object->AddObserver(vtkCommand::ErrorEvent, command);
  }
  vtkNew<vtkCallbackCommand> command;
  std::vector<std::string> all;
  /// VTK puts the class before an error's text.
  bool lastEndsWith(const std::string& end) const {
    if (all.empty()) return false;
    std::string last = all.back();
    while (!last.empty() && last.back() == '\n') last.pop_back();
    return last.size() >= end.size() && last.compare(last.size() - end.size(), end.size(), end) == 0;
  }
};

template <typename Object>
using Setters = std::vector<std::pair<std::string, std::function<void(Object*)>>>;

/// Each setter once on a new object: it is modified, prints the line, and is not modified by the same value again.
template <typename Object>
void expectEachToModify(const Setters<Object>& setters) {
  for (const auto& [line, set] : setters) {
    vtkNew<Object> object;
    const vtkMTimeType before = object->GetMTime();
    EXPECT_EQ(printed(object, "").find("\n" + line + "\n"), std::string::npos) << line << " is the default";
    set(object);
    const vtkMTimeType after = object->GetMTime();
    EXPECT_GT(after, before) << line;
    EXPECT_NE(printed(object, "").find("\n" + line + "\n"), std::string::npos) << line << " in\n"
                                                                               << printed(object, "");
    if (line.rfind("Name:", 0) == 0) continue;  // VTK's macro for texts does not compare
    set(object);
    EXPECT_EQ(object->GetMTime(), after) << line << " again";
  }
}

TEST(ProbeObjects, EachValueOfAProbeIsAChangeOnce) {
  vtkNew<vtkReflectionProbe> plain;
  EXPECT_EQ(printed(plain, "Name:"),
            "Name: \nEnabled: 1\nBounds: -1 1 -1 1 -1 1\nOrigin: 0 0 0\nOriginAtCenter: 1\nOrientation: 0 0 0\n"
            "InfluenceBounds: -1 1 -1 1 -1 1\nUseInfluenceBounds: 0\nBlendDistances: 0 0 0 0 0 0\nImportance: 1\n"
            "Intensity: 1\nTechnique: box (0 parameters set)\nFaceSize: 256\nBounces: 1\nSamplesPerPixel: 4\n"
            "NearDistance: 0\nFarDistance: 0\nClear: 0\nClearColor: 0 0 0\n");
  using P = vtkReflectionProbe;
  expectEachToModify<P>({
      {"Name: hall", [](P* p) { p->SetName("hall"); }},
      {"Enabled: 0", [](P* p) { p->EnabledOff(); }},
      {"Bounds: 0.5 1 2 4 5 8.5", [](P* p) { p->SetBounds(0.5, 1, 2, 4, 5, 8.5); }},
      {"Origin: 0.75 3 6.75", [](P* p) { p->SetBounds(0.5, 1, 2, 4, 5, 8.5); }},  // the middle
      {"Origin: 0.1 0.2 0.3", [](P* p) { p->SetOrigin(0.1, 0.2, 0.3); }},
      {"OriginAtCenter: 0", [](P* p) { p->SetOrigin(0.0, 0.0, 0.0); }},
      {"OriginAtCenter: 0", [](P* p) { p->OriginAtCenterOff(); }},
      {"Orientation: 3 5 7", [](P* p) { p->SetOrientation(3, 5, 7); }},
      {"InfluenceBounds: -2 3 -4 5 -6 7", [](P* p) { p->SetInfluenceBounds(-2, 3, -4, 5, -6, 7); }},
      {"UseInfluenceBounds: 1", [](P* p) { p->UseInfluenceBoundsOn(); }},
      {"BlendDistances: 0.1 0.2 0.3 0.4 0.5 0.6", [](P* p) { p->SetBlendDistances(0.1, 0.2, 0.3, 0.4, 0.5, 0.6); }},
      {"BlendDistances: 0.7 0.7 0.7 0.7 0.7 0.7", [](P* p) { p->SetBlendDistance(0.7); }},
      {"Importance: 2.5", [](P* p) { p->SetImportance(2.5); }},
      {"Intensity: 0.4", [](P* p) { p->SetIntensity(0.4); }},
      {"Technique: sphere (0 parameters set)", [](P* p) { p->SetTechnique("sphere"); }},
      {"Technique:  (0 parameters set)", [](P* p) { p->SetTechnique(nullptr); }},
      {"FaceSize: 32", [](P* p) { p->SetFaceSize(32); }},
      {"Bounces: 3", [](P* p) { p->SetBounces(3); }},
      {"Bounces: 16", [](P* p) { p->SetBouncesToAll(); }},
      {"SamplesPerPixel: 16", [](P* p) { p->SetSamplesPerPixel(16); }},
      {"NearDistance: 0.02", [](P* p) { p->SetNearDistance(0.02); }},
      {"FarDistance: 70", [](P* p) { p->SetFarDistance(70); }},
      {"Clear: 1", [](P* p) { p->SetClear(P::COLOR); }},
      {"Clear: 2", [](P* p) { p->SetClear(77); }},  // clamped
      {"ClearColor: 0.5 0.25 1", [](P* p) { p->SetClearColor(0.5, 0.25, 1.0); }},
  });
  // A parameter is a change each time, and a technique forgets them all.
  vtkNew<vtkReflectionProbe> tuned;
  const Lines errors(tuned);
  for (const auto& set : std::vector<std::function<void()>>{[&] { tuned->SetTechniqueNumber("samples", 24); },
                                                            [&] { tuned->SetTechniqueChoice("pattern", "blue"); }}) {
    const vtkMTimeType before = tuned->GetMTime();
    set();
    EXPECT_GT(tuned->GetMTime(), before);
  }
  EXPECT_NE(printed(tuned, "Technique:").find("box (2 parameters set)"), std::string::npos);
  const Probe given = tuned->ToProbe("t");
  EXPECT_EQ(given.parameters.at("samples"), ParameterValue(24.0));
  EXPECT_EQ(given.parameters.at("pattern"), ParameterValue(std::string("blue")));
  const vtkMTimeType before = tuned->GetMTime();
  tuned->SetTechnique("box");
  EXPECT_GT(tuned->GetMTime(), before) << "the same technique without its parameters";
  EXPECT_TRUE(tuned->ToProbe("t").parameters.empty());
  const vtkMTimeType still = tuned->GetMTime();
  tuned->SetTechniqueNumber(nullptr, 1.0);
  tuned->SetTechniqueChoice(nullptr, "blue");
  tuned->SetTechniqueChoice("pattern", nullptr);
  EXPECT_EQ(errors.all.size(), 3u);
  EXPECT_EQ(tuned->GetMTime(), still);
}

TEST(ProbeObjects, AnOriginAtTheMiddleGoesWithTheBounds) {
  vtkNew<vtkReflectionProbe> probe;
  const auto origin = [&probe] { return std::vector<double>(probe->GetOrigin(), probe->GetOrigin() + 3); };
  probe->SetBounds(1, 2, 3, 5, 7, 11);
  EXPECT_EQ(origin(), (std::vector<double>{1.5, 4, 9}));
  probe->SetOrigin(1.25, 3.5, 8);
  EXPECT_FALSE(probe->GetOriginAtCenter());
  probe->SetBounds(1, 3, 3, 6, 7, 12);
  EXPECT_EQ(origin(), (std::vector<double>{1.25, 3.5, 8}));
  probe->SetOriginAtCenter(true);
  EXPECT_EQ(origin(), (std::vector<double>{2, 4.5, 9.5}));
  probe->SetOriginAtCenter(false);
  EXPECT_EQ(origin(), (std::vector<double>{2, 4.5, 9.5}));
  probe->SetBounds(1, 4, 3, 7, 7, 13);
  EXPECT_EQ(origin(), (std::vector<double>{2, 4.5, 9.5}));
}

TEST(ProbeObjects, EachFieldIsTheLibrariesOwn) {
  vtkNew<vtkReflectionProbe> probe;
  const Probe standard;
  {
    const Probe p = probe->ToProbe("plain");
    EXPECT_EQ(p.name, "plain");
    EXPECT_EQ(p.nearDistance, standard.nearDistance);
    EXPECT_EQ(p.farDistance, standard.farDistance);
    EXPECT_FALSE(p.influence);
    EXPECT_EQ(p.blendDistance.max, glm::dvec3(0.0));
    EXPECT_TRUE(std::holds_alternative<ClearToSky>(p.clear));
  }
  probe->SetBounds(0, 1, 2, 4, 5, 8);
  probe->SetOrigin(0.5, 3.25, 6);
  probe->SetOrientation(10, 20, 30);
  probe->SetInfluenceBounds(-1, 2, 1, 5, 4, 9);
  probe->UseInfluenceBoundsOn();
  probe->SetBlendDistances(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  probe->SetImportance(3);
  probe->SetIntensity(0.5);
  probe->SetTechnique("sphere+hdrp");
  probe->SetFaceSize(128);
  probe->SetBounces(4);
  probe->SetSamplesPerPixel(16);
  probe->SetNearDistance(0.2);
  probe->SetFarDistance(81);
  probe->SetClear(vtkReflectionProbe::COLOR);
  probe->SetClearColor(0.5, 0.25, 0.75);
  const Probe p = probe->ToProbe("hall");
  EXPECT_EQ(p.name, "hall");
  EXPECT_EQ(p.box, (Box{{0, 2, 5}, {1, 4, 8}}));
  EXPECT_EQ(p.origin, glm::dvec3(0.5, 3.25, 6));
  EXPECT_EQ(p.rotationDegrees, glm::dvec3(10, 20, 30));
  ASSERT_TRUE(p.influence);
  EXPECT_EQ(*p.influence, (Box{{-1, 1, 4}, {2, 5, 9}}));
  EXPECT_EQ(p.blendDistance.min, glm::dvec3(0.1, 0.3, 0.5));
  EXPECT_EQ(p.blendDistance.max, glm::dvec3(0.2, 0.4, 0.6));
  EXPECT_EQ(p.importance, 3.0);
  EXPECT_EQ(p.intensity, 0.5);
  EXPECT_EQ(p.technique, "sphere+hdrp");
  EXPECT_EQ(p.faceSize, 128);
  EXPECT_EQ(p.bounces, 4);
  EXPECT_EQ(p.samplesPerPixel, 16);
  EXPECT_EQ(p.nearDistance, 0.2);
  EXPECT_EQ(p.farDistance, 81.0);
  ASSERT_NE(std::get_if<glm::vec3>(&p.clear), nullptr);
  EXPECT_EQ(std::get<glm::vec3>(p.clear), glm::vec3(0.5f, 0.25f, 0.75f));
  probe->SetClear(vtkReflectionProbe::OPEN);
  EXPECT_TRUE(std::holds_alternative<ClearToOpen>(probe->ToProbe("hall").clear));

  vtkNew<vtkReflectionProbe> back;
  vtkMTimeType before = back->GetMTime();
  back->FromProbe(p);
  EXPECT_GT(back->GetMTime(), before);
  EXPECT_EQ(
      printed(back, "Name:"),
      "Name: hall\nEnabled: 1\nBounds: 0 1 2 4 5 8\nOrigin: 0.5 3.25 6\nOriginAtCenter: 0\nOrientation: 10 20 30\n"
      "InfluenceBounds: -1 2 1 5 4 9\nUseInfluenceBounds: 1\nBlendDistances: 0.1 0.2 0.3 0.4 0.5 0.6\n"
      "Importance: 3\nIntensity: 0.5\nTechnique: sphere+hdrp (0 parameters set)\nFaceSize: 128\nBounces: 4\n"
      "SamplesPerPixel: 16\nNearDistance: 0.2\nFarDistance: 81\nClear: 1\nClearColor: 0.5 0.25 0.75\n");
  Probe other;
  other.box = {{0, 2, 5}, {1, 4, 8}};
  other.origin = {0.5, 3, 6.5};
  other.clear = ClearToOpen{};
  back->FromProbe(other);
  EXPECT_TRUE(back->GetOriginAtCenter());
  EXPECT_FALSE(back->GetUseInfluenceBounds());
  for (const int i : {0, 1, 2, 3, 4, 5}) EXPECT_EQ(back->GetInfluenceBounds()[i], back->GetBounds()[i]);
  EXPECT_EQ(back->GetClear(), vtkReflectionProbe::OPEN);
  EXPECT_EQ(back->GetNearDistance(), 0.0);
  EXPECT_EQ(back->GetFarDistance(), 0.0);
  other.clear = ClearToSky{};
  back->FromProbe(other);
  EXPECT_EQ(back->GetClear(), vtkReflectionProbe::SURROUNDINGS);
}

TEST(ProbeObjects, EachValueOfARenderersProbesIsAChangeOnce) {
  using P = vtkReflectionProbes;
  vtkNew<P> plain;
  EXPECT_EQ(
      printed(plain, "AutoUpdate:"),
      "AutoUpdate: 1\nStepsPerRender: 0\nExposure: 1\nToneMapping: 0\nEmission: 0\nMultipleScattering: 0\n"
      "RefineAtRest: 0\nRefineRays: 256\nRefineSeconds: 0\nRefineDelay: 0.5\nLastError: \nActors: 0\nProbes: 0\n");
  expectEachToModify<P>({
      {"AutoUpdate: 0", [](P* p) { p->AutoUpdateOff(); }},
      {"StepsPerRender: 3", [](P* p) { p->SetStepsPerRender(3); }},
      {"Exposure: 2.5", [](P* p) { p->SetExposure(2.5); }},
      {"Exposure: 1e-06", [](P* p) { p->SetExposure(-2.5); }},
      {"ToneMapping: 3", [](P* p) { p->SetToneMapping(P::TONE_AGX); }},
      {"ToneMapping: 4", [](P* p) { p->SetToneMapping(9); }},
      {"Emission: 1", [](P* p) { p->EmissionOn(); }},
      {"MultipleScattering: 1", [](P* p) { p->MultipleScatteringOn(); }},
      {"RefineAtRest: 1", [](P* p) { p->RefineAtRestOn(); }},
      {"RefineRays: 64", [](P* p) { p->SetRefineRays(64); }},
      {"RefineRays: 16384", [](P* p) { p->SetRefineRays(99999); }},
      {"RefineSeconds: 1.5", [](P* p) { p->SetRefineSeconds(1.5); }},
      {"RefineDelay: 0.25", [](P* p) { p->SetRefineDelay(0.25); }},
  });
  vtkNew<P> still;
  const vtkMTimeType before = still->GetMTime();
  still->SetStepsPerRender(-4);
  still->SetRenderer(nullptr);
  still->RemoveAllProbes();
  EXPECT_EQ(still->GetMTime(), before);
  EXPECT_EQ(still->GetRenderer(), nullptr);
  EXPECT_EQ(still->GetRefineLeft(), -1.0);
  EXPECT_EQ(still->GetRefineProgress(), 0.0);
  EXPECT_FALSE(still->GetRefining());
  EXPECT_FALSE(still->GetStale());
}

TEST(ProbeObjects, ProbesAreKeptInTheirOrder) {
  vtkNew<vtkReflectionProbes> probes;
  const Lines errors(probes);
  vtkNew<vtkReflectionProbe> a, b, c, never;
  std::vector<vtkMTimeType> times = {probes->GetMTime()};
  const auto changed = [&] {
    times.push_back(probes->GetMTime());
    return times.back() > times[times.size() - 2];
  };
  for (vtkReflectionProbe* probe : {a.Get(), b.Get(), c.Get()}) {
    probes->AddProbe(probe);
    EXPECT_TRUE(changed());
  }
  probes->AddProbe(b);
  EXPECT_FALSE(changed());
  EXPECT_TRUE(errors.lastEndsWith("AddProbe: this probe was added before"));
  EXPECT_STREQ(probes->GetLastError(), "AddProbe: this probe was added before");
  probes->AddProbe(nullptr);
  EXPECT_TRUE(errors.lastEndsWith("AddProbe: the probe is null"));
  EXPECT_EQ(errors.all.size(), 2u);
  ASSERT_EQ(probes->GetNumberOfProbes(), 3);
  EXPECT_EQ(probes->GetProbe(-1), nullptr);
  EXPECT_EQ(probes->GetProbe(0), a.Get());
  EXPECT_EQ(probes->GetProbe(2), c.Get());
  EXPECT_EQ(probes->GetProbe(3), nullptr);
  probes->RemoveProbe(never);
  EXPECT_FALSE(changed());
  b->SetIntensity(0.5);
  EXPECT_TRUE(changed()) << "a probe's own";
  EXPECT_EQ(probes->GetMTime(), b->GetMTime());
  probes->RemoveProbe(b);
  EXPECT_TRUE(changed());
  ASSERT_EQ(probes->GetNumberOfProbes(), 2);
  EXPECT_EQ(probes->GetProbe(0), a.Get());
  EXPECT_EQ(probes->GetProbe(1), c.Get());
  probes->RemoveAllProbes();
  EXPECT_TRUE(changed());
  EXPECT_EQ(probes->GetNumberOfProbes(), 0);
}

vtkSmartPointer<vtkActor> ball() {
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

TEST(ProbeObjects, TakeTheActorsThatHaveAMapperOfTheirOwn) {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkReflectionProbes> probes;
  const Lines errors(probes);
  probes->SetRenderer(renderer);
  EXPECT_EQ(probes->GetRenderer(), renderer.Get());
  const auto actors = [&] {
    EXPECT_TRUE(probes->GetStale()) << "nothing was drawn yet";
    const std::string text = printed(probes, "Actors:");
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(actors(), "Actors: 0");
  const auto one = ball(), two = ball(), part = ball(), inner = ball();
  vtkNew<vtkActor> bare;
  vtkNew<vtkSkybox> sky;
  renderer->AddActor(one);
  renderer->AddActor(bare);
  renderer->AddActor(sky);
  EXPECT_EQ(actors(), "Actors: 1");
  vtkNew<vtkAssembly> assembly, within;
  assembly->AddPart(part);
  assembly->AddPart(bare);
  within->AddPart(inner);
  assembly->AddPart(within);
  renderer->AddActor(assembly);
  EXPECT_EQ(actors(), "Actors: 3");
  renderer->AddActor(inner);  // once, although it is there twice
  renderer->AddActor(two);
  EXPECT_EQ(actors(), "Actors: 4");
  const vtkMTimeType before = probes->GetMTime();
  probes->SetUsed(two, false);
  EXPECT_GT(probes->GetMTime(), before);
  EXPECT_FALSE(probes->GetUsed(two));
  EXPECT_TRUE(probes->GetSeenByProbes(two));
  EXPECT_EQ(actors(), "Actors: 3");
  probes->SetUsed(assembly, false);
  EXPECT_EQ(actors(), "Actors: 2");  // `inner` by itself
  probes->SetUsed(assembly, true);
  const vtkMTimeType then = probes->GetMTime();
  probes->SetSeenByProbes(one, false);
  EXPECT_GT(probes->GetMTime(), then);
  EXPECT_FALSE(probes->GetSeenByProbes(one));
  EXPECT_TRUE(probes->GetUsed(one));
  EXPECT_EQ(actors(), "Actors: 3");
  renderer->RemoveActor(one);
  EXPECT_EQ(actors(), "Actors: 2");
  EXPECT_EQ(errors.all.size(), 0u);
  probes->SetRenderer(nullptr);
  EXPECT_EQ(probes->GetRenderer(), nullptr);
  EXPECT_NE(printed(probes, "Actors:").find("Actors: 0\n"), std::string::npos);
}

TEST(ProbeObjects, NamesThatAreTakenAreNumberedInMessages) {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkReflectionProbes> probes;
  const Lines errors(probes);
  probes->SetRenderer(renderer);
  std::vector<vtkSmartPointer<vtkReflectionProbe>> all;
  for (const char* name : {"hall", "hall", "", "", "hall"}) {
    all.push_back(vtkSmartPointer<vtkReflectionProbe>::New());
    all.back()->SetName(name);
    probes->AddProbe(all.back());
  }
  probes->GetStale();
  EXPECT_TRUE(errors.all.empty()) << errors.all.front();
  const auto refusedName = [&](std::size_t which) {
    const std::size_t said = errors.all.size();
    all[which]->SetFaceSize(100);
    probes->GetStale();
    probes->GetStale();  // said once
    EXPECT_EQ(errors.all.size(), said + 1);
    const std::string error = probes->GetLastError();
    all[which]->SetFaceSize(64);
    probes->GetStale();
    return error.substr(0, error.find(".faceSize"));
  };
  EXPECT_EQ(refusedName(0), "probes.hall");
  EXPECT_EQ(refusedName(1), "probes.hall 2");
  EXPECT_EQ(refusedName(2), "probes.probe");
  EXPECT_EQ(refusedName(3), "probes.probe 2");
  EXPECT_EQ(refusedName(4), "probes.hall 3");
  // One that is switched off leaves its name to others.
  all[0]->EnabledOff();
  probes->GetStale();
  all[1]->SetIntensity(0.5);
  EXPECT_EQ(refusedName(1), "probes.hall");
  probes->ClearError();
  EXPECT_STREQ(probes->GetLastError(), "");
  probes->RemoveProbe(all[2]);
  EXPECT_EQ(refusedName(3), "probes.probe");
  EXPECT_FALSE(probes->LoadMaps(all[0], "none.exr"));
  EXPECT_TRUE(errors.lastEndsWith("LoadMaps: the probe was not added, or is refused"));
  EXPECT_FALSE(probes->LoadMaps(all[1], nullptr));
  EXPECT_TRUE(errors.lastEndsWith("LoadMaps: the file is null"));
  probes->ForgetMaps(all[0]);
}

TEST(ProbeObjects, EachValueOfAFitIsAChangeOnce) {
  using F = vtkReflectionProbeFit;
  vtkNew<F> plain;
  EXPECT_EQ(printed(plain, "UpAxis:"),
            "UpAxis: 1\nMetresPerUnit: 1\nNumberOfRays: 4096\nTurning: 1\nAbortFlag: 0\nReport: \n");
  expectEachToModify<F>({
      {"UpAxis: 2", [](F* f) { f->SetUpAxis(5); }},
      {"UpAxis: 0", [](F* f) { f->SetUpAxis(-1); }},
      {"MetresPerUnit: 0.01", [](F* f) { f->SetMetresPerUnit(0.01); }},
      {"NumberOfRays: 64", [](F* f) { f->SetNumberOfRays(2); }},
      {"Turning: 0", [](F* f) { f->TurningOff(); }},
      {"AbortFlag: 1", [](F* f) { f->SetAbortFlag(true); }},
  });
  vtkNew<vtkReflectionProbes> probes;
  const vtkMTimeType before = plain->GetMTime();
  plain->SetProbes(probes);
  const vtkMTimeType after = plain->GetMTime();
  EXPECT_GT(after, before);
  EXPECT_EQ(plain->GetProbes(), probes.Get());
  plain->SetProbes(probes);
  EXPECT_EQ(plain->GetMTime(), after);
}

}  // namespace
}  // namespace boxprobe
