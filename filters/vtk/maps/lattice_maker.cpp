#include "filters/vtk/maps/lattice_maker.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "filters/math/cube/lamp_free.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

namespace {

// Lattices kept per probe; rays for one that is derived continuously.
constexpr std::size_t kKept = 2;
constexpr int kFewRays = 256;

std::mutex costsMutex;
LatticeCosts costs;

void countLattice(const DiffuseLattice& lattice, double cpuSeconds) {
  const std::lock_guard<std::mutex> lock(costsMutex);
  ++costs.lattices;
  costs.nodes += static_cast<std::size_t>(lattice.nodes.x * lattice.nodes.y * lattice.nodes.z);
  costs.bytes += (lattice.texels.size() + lattice.cuts.size()) * sizeof(glm::vec4);
  costs.cpuSeconds += cpuSeconds;
}

CubeMap firstLevel(const CubeTexture& texture) {
  if (!texture.allocated()) return {};
  CubeMap cube(texture.faceSize(), 1);
  for (int face = 0; face < 6; ++face) texture.readFace(face, 0, cube.face(0, face));
  return cube;
}

bool sameLamp(const LampPolygon& a, const LampPolygon& b) {
  return a.count == b.count && a.bothSides == b.bothSides && a.corners == b.corners;
}

// The data read back from the maps, and the other inputs, owned by the deriving thread.
struct LatticeWork {
  CubeMap radiance, distance;
  LatticeSource source;

  std::shared_ptr<const DiffuseLattice> derive() const {
    const double start = processCpuSeconds();
    shading::ProbeShape shape{};
    shape.boxMin = source.boxMin;
    shape.boxMax = source.boxMax;
    shape.projection = source.projection;
    LatticeSettings settings;
    if (source.fewRays) settings.rays = kFewRays;
    if (source.traced.lines && !source.reach.none()) {
      const ProbeReach reach = openReach(source.reach, *source.traced.lines, source.traced.originWorld,
                                         source.traced.worldFromProbe, source.boxMin, source.boxMax);
      settings.reachLow = glm::vec3(reach.low);
      settings.reachHigh = glm::vec3(reach.high);
    }
    const CubeMap capture = latticeCapture(radiance);
    const CubeMap sky = source.sky ? plainMeans(*source.sky) : CubeMap();
    const CubeMap means = plainMeans(source.lamps.empty() ? capture : withoutLamps(capture, distance, source.lamps));
    settings.spacing = source.spacing > 0.0f
                           ? source.spacing / static_cast<float>(metreOf(source.boxMax - source.boxMin))
                           : tracedSpacing(source.boxMin, source.boxMax, settings.spacing, means, source.traced);
    const DiffuseLattice projected = makeDiffuseLattice(means, shape, source.mapFromProbe, source.worldFromProbe,
                                                        settings, source.sky ? &sky : nullptr);
    auto lattice = std::make_shared<const DiffuseLattice>(tracedLattice(projected, means, source.traced));
    countLattice(*lattice, processCpuSeconds() - start);
    return lattice;
  }
};

}  // namespace

LatticeCosts latticeCosts() {
  const std::lock_guard<std::mutex> lock(costsMutex);
  return costs;
}

bool LatticeSource::operator==(const LatticeSource& o) const {
  return boxMin == o.boxMin && boxMax == o.boxMax && reach == o.reach && mapFromProbe == o.mapFromProbe &&
         worldFromProbe == o.worldFromProbe && projection == o.projection && spacing == o.spacing &&
         fewRays == o.fewRays && sky == o.sky && traced == o.traced &&
         std::equal(lamps.begin(), lamps.end(), o.lamps.begin(), o.lamps.end(), sameLamp);
}

void LatticeMaker::keep(LatticeSource source, Lattice lattice) {
  if (made_.size() == kKept) made_.pop_back();
  made_.insert(made_.begin(), {std::move(source), std::move(lattice)});
}

void LatticeMaker::takeNow() {
  keep(std::move(besideSource_), beside_.get());
  beside_ = {};
}

void LatticeMaker::take(int milliseconds) {
  if (pending() && beside_.wait_for(std::chrono::milliseconds(milliseconds)) == std::future_status::ready) takeNow();
}

std::shared_ptr<const DiffuseLattice> LatticeMaker::of(const CubeTexture& radiance, const CubeTexture& distance,
                                                       const LatticeSource& source, LatticeHaste haste) {
  if (haste == LatticeHaste::Now && pending() && besideSource_ == source) takeNow();
  Lattice before = made_.empty() ? nullptr : made_.front().lattice;
  if (haste == LatticeHaste::AsItIs) return before;
  const auto known = std::find_if(made_.begin(), made_.end(), [&](const Made& made) { return made.source == source; });
  if (known != made_.end()) {
    std::rotate(made_.begin(), known, known + 1);
    return made_.front().lattice;
  }
  // One at a time: if a source changes faster than lattices are derived, intermediate states are skipped.
  if (!radiance.allocated() || (pending() && haste != LatticeHaste::Now)) return before;
  auto work = std::make_shared<LatticeWork>();
  work->radiance = firstLevel(radiance);
  if (!source.lamps.empty()) work->distance = firstLevel(distance);
  work->source = source;
  if (haste != LatticeHaste::Beside) {
    keep(source, work->derive());
    return made_.front().lattice;
  }
  const auto task = std::make_shared<std::packaged_task<Lattice()>>([work] { return work->derive(); });
  besideSource_ = source;
  beside_ = task->get_future().share();
  static tbb::task_arena arena;
  arena.enqueue([task] { (*task)(); });
  return before;
}

}  // namespace boxprobe
