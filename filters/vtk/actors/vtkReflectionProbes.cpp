#include "filters/vtk/actors/vtkReflectionProbes.h"

#include <vtkActor.h>
#include <vtkAssemblyPath.h>
#include <vtkCallbackCommand.h>
#include <vtkCollectionIterator.h>
#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/io/cube/cube_file.h"
#include "filters/vtk/actors/actor_probes.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"

vtkStandardNewMacro(vtkReflectionProbes);

struct vtkReflectionProbes::Parts {
  struct Entry {
    vtkSmartPointer<vtkReflectionProbe> probe;
    vtkMTimeType synced = 0;  ///< its MTime when its values were applied, or refused
    bool live = false;        ///< exists in the implementation; its index is the number of live probes before it
  };
  /// A program's settings for a prop, which may have been deleted.
  struct Wish {
    vtkWeakPointer<vtkProp> prop;
    bool seen = true, used = true;
  };

  vtkSmartPointer<vtkRenderer> renderer;
  std::unique_ptr<boxprobe::ActorProbes> actors;
  std::vector<Entry> entries;
  std::map<vtkProp*, Wish> wishes;
  std::vector<std::pair<vtkActor*, bool>> shown;  ///< the actors of the implementation, and whether captures show each
  bool emission = false, scattering = false;
  double exposure = 1.0;
  int tone = vtkReflectionProbes::TONE_AS_VTK;
  std::string lastError;
  std::string reported;                  ///< the last error of the implementation that was passed on
  std::set<std::string> remarked;        ///< warnings that were passed on
  bool capturing = false, busy = false;  ///< between StartEvent and EndEvent; inside a call that draws

  boxprobe::RefineSettings refineTo;
  std::uint64_t picture = 0;  ///< the last that was drawn
  bool ended = false;         ///< that one is refined, and EndRefineEvent invoked
  bool refused = false;       ///< the renderer's picture cannot be refined, and that was said
  vtkWeakPointer<vtkRenderWindowInteractor> interactor;  ///< whose timers are heard
  vtkNew<vtkCallbackCommand> timerCall;
  int timer = 0;  ///< 0: none runs

  const Wish* wish(vtkProp* prop) const {
    const auto at = wishes.find(prop);
    return at != wishes.end() && at->second.prop.GetPointer() == prop ? &at->second : nullptr;
  }
  Wish& wishOf(vtkProp* prop) {
    Wish& wish = wishes[prop];
    if (wish.prop.GetPointer() != prop) wish = {prop, true, true};  // of another prop that had the same address
    return wish;
  }
  Entry* entry(vtkReflectionProbe* probe) {
    const auto at = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.probe == probe; });
    return at != entries.end() ? &*at : nullptr;
  }
  std::size_t indexOf(const Entry& entry) const {
    return static_cast<std::size_t>(std::count_if(entries.data(), &entry, [](const Entry& e) { return e.live; }));
  }
};

vtkReflectionProbes::vtkReflectionProbes() : Inside(std::make_unique<Parts>()) {
  this->Inside->timerCall->SetClientData(this);
  this->Inside->timerCall->SetCallback([](vtkObject*, unsigned long, void* client, void* data) {
    static_cast<vtkReflectionProbes*>(client)->OnTimer(data != nullptr ? *static_cast<int*>(data) : 0);
  });
}

vtkReflectionProbes::~vtkReflectionProbes() {
  this->DropTimer();
  if (this->Inside->interactor != nullptr) {
    this->Inside->interactor->RemoveObserver(this->Inside->timerCall);
  }
}

vtkMTimeType vtkReflectionProbes::GetMTime() {
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const Parts::Entry& entry : this->Inside->entries) {
    time = std::max(time, entry.probe->GetMTime());
  }
  return time;
}

void vtkReflectionProbes::SetRenderer(vtkRenderer* renderer) {
  Parts& in = *this->Inside;
  if (renderer == in.renderer) {
    return;
  }
  this->DropTimer();
  in.refineTo = {};
  in.picture = 0;
  in.ended = in.refused = false;
  in.actors.reset();
  in.shown.clear();
  for (Parts::Entry& entry : in.entries) {
    entry.live = false;
    entry.synced = 0;
  }
  in.renderer = renderer;
  in.emission = in.scattering = false;
  in.exposure = 1.0;
  in.tone = TONE_AS_VTK;
  in.reported.clear();
  if (renderer != nullptr) {
    in.actors = std::make_unique<boxprobe::ActorProbes>(renderer);
    in.actors->setFrameCalls([this] { this->BeforeFrame(); }, [this] { this->AfterFrame(); });
    in.actors->setProgress([this](double done) { this->InvokeEvent(vtkCommand::ProgressEvent, &done); });
  }
  this->Modified();
}

vtkRenderer* vtkReflectionProbes::GetRenderer() const {
  return this->Inside->renderer;
}

void vtkReflectionProbes::AddProbe(vtkReflectionProbe* probe) {
  if (probe == nullptr) {
    this->Fail("AddProbe: the probe is null");
    return;
  }
  if (this->Inside->entry(probe) != nullptr) {
    this->Fail("AddProbe: this probe was added before");
    return;
  }
  this->Inside->entries.push_back({probe, 0, false});
  this->Modified();
}

void vtkReflectionProbes::RemoveProbe(vtkReflectionProbe* probe) {
  Parts& in = *this->Inside;
  Parts::Entry* entry = in.entry(probe);
  if (entry == nullptr) {
    return;
  }
  if (entry->live) {
    in.actors->removeProbe(in.indexOf(*entry));
  }
  in.entries.erase(in.entries.begin() + (entry - in.entries.data()));
  this->Modified();
}

void vtkReflectionProbes::RemoveAllProbes() {
  while (!this->Inside->entries.empty()) {
    this->RemoveProbe(this->Inside->entries.back().probe);
  }
}

int vtkReflectionProbes::GetNumberOfProbes() const {
  return static_cast<int>(this->Inside->entries.size());
}

vtkReflectionProbe* vtkReflectionProbes::GetProbe(int index) const {
  const auto& entries = this->Inside->entries;
  return index >= 0 && index < static_cast<int>(entries.size()) ? entries[static_cast<std::size_t>(index)].probe.Get()
                                                                : nullptr;
}

void vtkReflectionProbes::SetSeenByProbes(vtkProp* prop, bool seen) {
  if (prop == nullptr) {
    this->Fail("SetSeenByProbes: the prop is null");
    return;
  }
  this->Inside->wishOf(prop).seen = seen;
  this->Modified();
}

bool vtkReflectionProbes::GetSeenByProbes(vtkProp* prop) const {
  const Parts::Wish* wish = this->Inside->wish(prop);
  return wish == nullptr || wish->seen;
}

void vtkReflectionProbes::SetUsed(vtkProp* prop, bool used) {
  if (prop == nullptr) {
    this->Fail("SetUsed: the prop is null");
    return;
  }
  this->Inside->wishOf(prop).used = used;
  this->Modified();
}

bool vtkReflectionProbes::GetUsed(vtkProp* prop) const {
  const Parts::Wish* wish = this->Inside->wish(prop);
  return wish == nullptr || wish->used;
}

bool vtkReflectionProbes::Ready(const char* call) {
  if (this->Inside->actors) {
    return true;
  }
  this->Fail(std::string(call) + ": there is no renderer; call SetRenderer() first");
  return false;
}

// Refused values are reported once, until they change.
void vtkReflectionProbes::SyncProbes() {
  Parts& in = *this->Inside;
  for (Parts::Entry& entry : in.entries) {
    const vtkMTimeType now = entry.probe->GetMTime();
    if (now == entry.synced) {
      continue;
    }
    entry.synced = now;
    const std::size_t index = in.indexOf(entry);
    try {
      if (!entry.probe->GetEnabled()) {
        if (entry.live) {
          in.actors->removeProbe(index);
        }
        entry.live = false;
        continue;
      }
      boxprobe::Scene others;
      others.probes = in.actors->probes();
      if (entry.live) {
        others.probes.erase(others.probes.begin() + static_cast<std::ptrdiff_t>(index));
      }
      const char* name = entry.probe->GetName();
      const std::string stem = name != nullptr && *name != '\0' ? name : "probe";
      const boxprobe::Probe probe = entry.probe->ToProbe(boxprobe::unusedProbeName(others, stem));
      if (entry.live) {
        in.actors->setProbe(index, probe);
      } else {
        in.actors->insertProbe(index, probe);
        entry.live = true;
      }
    } catch (const boxprobe::Error& refused) {
      this->Fail(refused.what());
    }
  }
}

// What the renderer shows now, with parts in place of assemblies. Skips sky boxes, which are the environment, and props
// without a mapper of their own (axes), which draw by the camera.
void vtkReflectionProbes::SyncActors() {
  Parts& in = *this->Inside;
  std::vector<std::pair<vtkActor*, bool>> now;
  std::set<vtkActor*> taken;
  const auto take = [&](vtkProp* prop, vtkProp* owner) {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor == nullptr || actor->GetMapper() == nullptr || vtkSkybox::SafeDownCast(prop) != nullptr) {
      return;
    }
    if (this->GetUsed(actor) && this->GetUsed(owner) && taken.insert(actor).second) {
      now.emplace_back(actor, this->GetSeenByProbes(actor) && this->GetSeenByProbes(owner));
    }
  };
  vtkPropCollection* props = in.renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it)) {
    if (prop->IsA("vtkAssembly") == 0) {
      take(prop, prop);
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath()) {
      take(path->GetLastNode()->GetViewProp(), prop);
    }
  }
  if (now == in.shown) {
    return;
  }
  for (const auto& [actor, seen] : in.shown) {
    if (taken.count(actor) == 0) {
      in.actors->removeActor(actor);
    }
  }
  // Retries refused actors: the object that has one may have been deleted.
  in.shown.clear();
  for (const auto& [actor, seen] : now) {
    if (in.actors->addActor(actor, seen)) {
      in.shown.emplace_back(actor, seen);
    }
  }
}

void vtkReflectionProbes::Sync() {
  Parts& in = *this->Inside;
  if (!in.actors) {
    return;
  }
  if (in.exposure != this->Exposure) {
    in.exposure = this->Exposure;
    in.actors->setExposure(in.exposure);
  }
  if (in.tone != this->ToneMapping) {
    constexpr boxprobe::Tone kTones[] = {boxprobe::Tone::AsVtk, boxprobe::Tone::None, boxprobe::Tone::Neutral,
                                         boxprobe::Tone::Agx, boxprobe::Tone::Aces};
    in.tone = this->ToneMapping;
    in.actors->setTone(kTones[in.tone]);
  }
  if (in.emission != this->Emission) {
    in.emission = this->Emission;
    in.actors->setEmission(in.emission);
  }
  if (in.scattering != this->MultipleScattering) {
    in.scattering = this->MultipleScattering;
    in.actors->setEnergy(in.scattering ? boxprobe::Energy::Multiple : boxprobe::Energy::Single);
  }
  boxprobe::RefineSettings to;
  if (this->RefineAtRest) {
    to.rays = this->RefineRays;
    to.seconds = this->RefineSeconds;
  }
  if (!(to == in.refineTo)) {
    in.refineTo = to;
    in.ended = false;
    in.actors->setRefinement(to);
  }
  this->SyncProbes();
  this->SyncActors();
}

void vtkReflectionProbes::Fail(const std::string& line) {
  this->Inside->lastError = line;
  vtkErrorMacro(<< line);
}

// Reports errors of frames and captures, but not the same line twice in a row; warnings once.
void vtkReflectionProbes::Report() {
  Parts& in = *this->Inside;
  if (!in.actors) {
    return;
  }
  const std::string error = in.actors->error();
  if (error != in.reported) {
    in.reported = error;
    if (!error.empty()) {
      this->Fail(error);
    }
  }
  const std::vector<std::string> remarks = in.actors->remarks();
  for (const std::string& remark : remarks) {
    if (in.remarked.insert(remark).second) {
      vtkWarningMacro(<< remark);
    }
  }
}

// Ends the span between the two events.
void vtkReflectionProbes::Finish(bool done) {
  Parts& in = *this->Inside;
  this->Report();
  if (done && in.capturing) {
    in.capturing = false;
    this->InvokeEvent(vtkCommand::EndEvent);
  }
}

bool vtkReflectionProbes::GetStale() {
  this->Sync();
  return this->Inside->actors && this->Inside->actors->stale();
}

bool vtkReflectionProbes::Update() {
  Parts& in = *this->Inside;
  if (!this->Ready("Update") || in.busy) {
    return false;
  }
  in.busy = true;
  const boxprobe::ScopeExit free([&in] { in.busy = false; });
  this->Sync();
  bool done = true;
  try {
    if (in.actors->stale()) {
      if (!in.capturing) {
        in.capturing = true;
        this->InvokeEvent(vtkCommand::StartEvent);
      }
      done = in.actors->update();
    }
  } catch (const boxprobe::Error& failure) {
    this->Fail(failure.what());
    done = false;
  }
  this->Finish(true);
  return done;
}

bool vtkReflectionProbes::UpdateStep() {
  Parts& in = *this->Inside;
  if (!this->Ready("UpdateStep") || in.busy) {
    return false;
  }
  in.busy = true;
  const boxprobe::ScopeExit free([&in] { in.busy = false; });
  this->Sync();
  bool more = false;
  try {
    if (in.actors->stale()) {
      if (!in.capturing) {
        in.capturing = true;
        this->InvokeEvent(vtkCommand::StartEvent);
      }
      more = in.actors->updateStep();
    }
  } catch (const boxprobe::Error& failure) {
    this->Fail(failure.what());
  }
  this->Finish(!more);
  return more;
}

bool vtkReflectionProbes::Capture() {
  Parts& in = *this->Inside;
  if (!this->Ready("Capture") || in.busy) {
    return false;
  }
  in.busy = true;
  const boxprobe::ScopeExit free([&in] { in.busy = false; });
  this->Sync();
  bool done = false;
  try {
    in.capturing = true;
    this->InvokeEvent(vtkCommand::StartEvent);
    done = in.actors->capture();
  } catch (const boxprobe::Error& failure) {
    this->Fail(failure.what());
  }
  this->Finish(true);
  return done;
}

void vtkReflectionProbes::BeforeFrame() {
  Parts& in = *this->Inside;
  if (in.busy) {
    return;
  }
  if (!this->AutoUpdate) {
    this->Sync();
    return;
  }
  if (this->StepsPerRender == 0) {
    this->Update();
    return;
  }
  for (int step = 0; step < this->StepsPerRender; ++step) {
    if (!this->UpdateStep()) {
      break;
    }
  }
}

void vtkReflectionProbes::SetRefineAtRest(bool refine) {
  if (refine == this->RefineAtRest) {
    return;
  }
  this->RefineAtRest = refine;
  this->Inside->refused = false;
  if (!refine) {
    this->DropTimer();
  }
  this->Sync();
  this->Modified();
}

bool vtkReflectionProbes::RefineStep() {
  Parts& in = *this->Inside;
  if (!this->Ready("RefineStep") || in.busy || !this->RefineAtRest) {
    return false;
  }
  this->Sync();
  const std::string refused = in.actors->refusedRefinement();
  if (!refused.empty()) {
    if (!in.refused) {
      vtkWarningMacro(<< refused);
    }
    in.refused = true;
    return false;
  }
  const bool more = in.actors->refineStep();
  if (!more && in.actors->refining() && !in.ended) {
    in.ended = true;
    this->InvokeEvent(EndRefineEvent);
  }
  return more;
}

bool vtkReflectionProbes::GetRefining() const {
  return this->Inside->actors && this->Inside->actors->refining();
}

double vtkReflectionProbes::GetRefineProgress() const {
  return this->Inside->actors ? this->Inside->actors->refineProgress() : 0.0;
}

double vtkReflectionProbes::GetRefineLeft() const {
  return this->Inside->actors ? this->Inside->actors->refineState().left : -1.0;
}

// Another picture than before is left to rest first.
void vtkReflectionProbes::AfterFrame() {
  Parts& in = *this->Inside;
  this->Report();
  if (!this->RefineAtRest || in.actors->pictures() == in.picture) {
    return;
  }
  in.picture = in.actors->pictures();
  in.ended = false;
  this->SetTimer(this->RefineDelay);
}

void vtkReflectionProbes::FollowInteractor() {
  Parts& in = *this->Inside;
  vtkRenderWindow* window = in.renderer != nullptr ? in.renderer->GetRenderWindow() : nullptr;
  vtkRenderWindowInteractor* now = window != nullptr ? window->GetInteractor() : nullptr;
  if (now == in.interactor.GetPointer()) {
    return;
  }
  if (in.interactor != nullptr) {
    in.interactor->RemoveObserver(in.timerCall);
  }
  in.timer = 0;
  in.interactor = now;
  if (now != nullptr) {
    now->AddObserver(vtkCommand::TimerEvent, in.timerCall);
  }
}

void vtkReflectionProbes::SetTimer(double seconds) {
  Parts& in = *this->Inside;
  this->FollowInteractor();
  this->DropTimer();
  if (in.interactor != nullptr && in.interactor->GetInitialized()) {
    in.timer = in.interactor->CreateOneShotTimer(std::max(1ul, static_cast<unsigned long>(1000.0 * seconds)));
  }
}

void vtkReflectionProbes::DropTimer() {
  Parts& in = *this->Inside;
  if (in.timer != 0 && in.interactor != nullptr) {
    in.interactor->DestroyTimer(in.timer);
  }
  in.timer = 0;
}

// Each step takes a turn of the interactor's own loop, so that what the user does comes in between.
void vtkReflectionProbes::OnTimer(int timer) {
  constexpr double kBetween = 0.005;
  Parts& in = *this->Inside;
  if (in.timer == 0 || timer != in.timer) {
    return;
  }
  this->DropTimer();
  if (!this->RefineAtRest) {
    return;
  }
  // Events may come in the middle of a capture, from an observer of its progress.
  if (in.busy) {
    this->SetTimer(this->RefineDelay);
  } else if (this->RefineStep() && in.timer == 0) {
    this->SetTimer(kBetween);
  }
}

bool vtkReflectionProbes::LoadMaps(vtkReflectionProbe* probe, const char* file) {
  Parts& in = *this->Inside;
  if (!this->Ready("LoadMaps")) {
    return false;
  }
  this->Sync();
  const Parts::Entry* entry = in.entry(probe);
  if (entry == nullptr || !entry->live || file == nullptr) {
    this->Fail(file == nullptr ? "LoadMaps: the file is null" : "LoadMaps: the probe was not added, or is refused");
    return false;
  }
  try {
    in.actors->setMaps(in.indexOf(*entry), boxprobe::loadBakedProbe(file).maps);
  } catch (const boxprobe::Error& failure) {
    this->Fail(failure.what());
    return false;
  }
  return true;
}

void vtkReflectionProbes::ForgetMaps(vtkReflectionProbe* probe) {
  Parts& in = *this->Inside;
  const Parts::Entry* entry = in.entry(probe);
  if (in.actors && entry != nullptr && entry->live) {
    in.actors->setMaps(in.indexOf(*entry), std::shared_ptr<const boxprobe::ProbeMaps>());
  }
}

const char* vtkReflectionProbes::GetLastError() const {
  return this->Inside->lastError.c_str();
}

void vtkReflectionProbes::ClearError() {
  Parts& in = *this->Inside;
  in.lastError.clear();
  in.reported.clear();
  in.remarked.clear();
  if (in.actors) {
    in.actors->clearError();
  }
}

void vtkReflectionProbes::ReleaseGraphicsResources() {
  if (this->Inside->actors) {
    this->Inside->actors->releaseGraphics();
  }
}

void vtkReflectionProbes::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  const Parts& in = *this->Inside;
  os << indent << "Renderer: " << in.renderer.Get() << "\n";
  os << indent << "AutoUpdate: " << this->AutoUpdate << "\n";
  os << indent << "StepsPerRender: " << this->StepsPerRender << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "ToneMapping: " << this->ToneMapping << "\n";
  os << indent << "Emission: " << this->Emission << "\n";
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n";
  os << indent << "RefineAtRest: " << this->RefineAtRest << "\n";
  os << indent << "RefineRays: " << this->RefineRays << "\n";
  os << indent << "RefineSeconds: " << this->RefineSeconds << "\n";
  os << indent << "RefineDelay: " << this->RefineDelay << "\n";
  os << indent << "LastError: " << in.lastError << "\n";
  os << indent << "Actors: " << in.shown.size() << "\n";
  os << indent << "Probes: " << in.entries.size() << "\n";
  for (const Parts::Entry& entry : in.entries) {
    entry.probe->PrintSelf(os, indent.GetNextIndent());
  }
}
