// placed_pictures: what placing does to pictures. Of every interior, the error against the path tracer from eyes of its
// own with one probe of the bounds, with one fitted probe, with the scene's own probes and as `boxprobe place` places.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "app/session/fit_scene.h"
#include "filters/core/base/errors.h"
#include "filters/fit/fit_model.h"
#include "filters/io/image/image_file.h"
#include "filters/reference/path/reference_path.h"
#include "filters/reference/trace/picture_rays.h"
#include "filters/reference/trace/scene_tracer.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

struct Options {
  std::vector<std::string> scenes;
  std::string program = BOXPROBE_PROGRAM, size = "64x36", folder;
  int eyes = 4, rays = 128, faceSize = 128;
  unsigned seed = 1;
  std::vector<std::string> assignments;
};

/// A pixel's surface, and how far the path tracer is to be trusted there.
struct Seen {
  bool counts = false, glossy = false;
  int object = -1;
  glm::dvec3 position{0.0}, normal{0.0};
};

struct View {
  Camera camera;
  ReferencePicture truth;
  std::vector<Seen> seen;
};

struct Interior {
  LoadedScene loaded;
  std::vector<View> views;
  double white = 0.0;  ///< brighter is shown as white, and counts as that
  int width = 0, height = 0;
};

/// Pixels that are noisier than this share of their value, a tenth of white added, are left out.
constexpr double kNoisy = 0.25;

glm::dvec3 turned(double degreesX, double degreesY, double degreesZ, const glm::dvec3& v) {
  const double a = glm::radians(degreesX), b = glm::radians(degreesY), c = glm::radians(degreesZ);
  const glm::dvec3 x(v.x, std::cos(a) * v.y - std::sin(a) * v.z, std::sin(a) * v.y + std::cos(a) * v.z);
  const glm::dvec3 y(std::cos(b) * x.x + std::sin(b) * x.z, x.y, -std::sin(b) * x.x + std::cos(b) * x.z);
  return {std::cos(c) * y.x - std::sin(c) * y.y, std::sin(c) * y.x + std::cos(c) * y.y, y.z};
}

/// The weight of a probe's influence at a point: 1 inside, falling to 0 at the outer faces.
double weightAt(const Probe& probe, const glm::dvec3& world) {
  const glm::dvec3 pivot = probe.box.center(), &r = probe.rotationDegrees;
  glm::dvec3 p(0.0);  // turned back: the transpose, component by component
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    p[axis] = glm::dot(world - pivot, turned(r.x, r.y, r.z, unit));
  }
  p += pivot;
  const Box& box = probe.influenceBox();
  double weight = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto ramp = [](double inside, double over) {
      return over > 0.0 ? std::clamp(inside / over, 0.0, 1.0) : (inside >= 0.0 ? 1.0 : 0.0);
    };
    weight *= ramp(p[axis] - box.min[axis], probe.blendDistance.min[axis]);
    weight *= ramp(box.max[axis] - p[axis], probe.blendDistance.max[axis]);
  }
  return weight;
}

/// The probe that lights most of a point; -1: none has any weight there.
int dominantAt(const std::vector<Probe>& probes, const glm::dvec3& world) {
  int best = -1;
  double most = 0.0, rank = -1e300;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const double weight = weightAt(probes[i], world);
    if (!(weight > 0.0)) continue;
    const bool above = probes[i].importance > rank && weight > 0.5;
    if (best < 0 || above || (probes[i].importance == rank && weight > most)) {
      best = static_cast<int>(i), most = weight, rank = probes[i].importance;
    }
  }
  return best;
}

/// Eyes at a person's height in places that are closed in, far from each other.
std::vector<Camera> eyesOf(const SceneTracer& tracer, int wanted, unsigned seed) {
  constexpr int kTries = 6000, kLooks = 64;
  const glm::dvec3 middle = tracer.scene().anchorWorld;
  const double radius = tracer.scene().radius;
  glm::dvec3 low(1e300), high(-1e300);
  for (const TracedObject& object : tracer.scene().objects) {
    if (!object.inPicture) continue;
    for (const glm::vec3& p : object.positions) {
      low = glm::min(low, middle + glm::dvec3(p));
      high = glm::max(high, middle + glm::dvec3(p));
    }
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  struct Stand {
    glm::dvec3 eye;
    double height;
  };
  std::vector<Stand> stands;
  for (int i = 0; i < kTries && stands.size() < 400; ++i) {
    const glm::dvec3 from = low + glm::dvec3(unit(random), unit(random), unit(random)) * (high - low);
    const double tall = 1.2 + 0.6 * unit(random);
    const auto floor = tracer.firstHit(from, -up), ceiling = tracer.firstHit(from, up);
    if (!floor || !ceiling || floor->frontWorld.y < 0.7) continue;
    const double height = floor->distance + ceiling->distance;
    if (height < 1.9 && radius < 1000.0 && radius > 3.0) continue;  // under a table
    const glm::dvec3 eye = floor->positionWorld + up * std::clamp(tall, 0.3 * height, 0.65 * height);
    int closed = 0, backs = 0;
    double nearest = 1e300;
    for (int k = 0; k < kLooks; ++k) {
      const double y = 1.0 - (2.0 * k + 1.0) / kLooks, s = std::sqrt(1.0 - y * y), turn = 2.399963 * k;
      const auto hit = tracer.firstHit(eye, {s * std::cos(turn), y, s * std::sin(turn)});
      closed += hit ? 1 : 0;
      backs += hit && hit->backSide ? 1 : 0;
      if (hit) nearest = std::min(nearest, hit->distance);
    }
    // Among back sides a place is inside of a thing.
    if (closed < 0.85 * kLooks || 2 * backs > closed || nearest < 0.1 * height) continue;
    stands.push_back({eye, height});
  }
  std::vector<Camera> cameras;
  std::vector<double> away(stands.size(), 1e300);
  while (static_cast<int>(cameras.size()) < wanted && !stands.empty()) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < stands.size(); ++i) {
      if (away[i] > away[next]) next = i;
    }
    if (!(away[next] > 0.05 * stands[next].height)) break;
    const Stand& stand = stands[next];
    Camera camera;
    camera.name = "eye " + std::to_string(cameras.size() + 1);
    camera.position = stand.eye;
    camera.verticalFovDegrees = 60.0;
    double deepest = -1.0;
    for (int k = 0; k < 5; ++k) {  // of a few looks at random the deepest: nobody looks at a wall from a hand's breadth
      const double yaw = 6.283185307 * unit(random);
      const glm::dvec3 along = glm::normalize(glm::dvec3(std::cos(yaw), -0.15, std::sin(yaw)));
      const auto hit = tracer.firstHit(stand.eye, along);
      const double depth = hit ? hit->distance : 0.0;
      if (depth > deepest) deepest = depth, camera.target = stand.eye + stand.height * along;
    }
    cameras.push_back(camera);
    for (std::size_t i = 0; i < stands.size(); ++i) {
      away[i] = std::min(away[i], glm::length(stands[i].eye - stand.eye));
    }
  }
  return cameras;
}

std::vector<Seen> seenFrom(const SceneTracer& tracer, const Camera& camera, int width, int height) {
  std::vector<Seen> seen;
  const PictureRays rays(camera, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Seen& point = seen.emplace_back();
      const glm::dvec3 eye = rays.origin(x + 0.5, y + 0.5);
      const auto hit = tracer.firstHit(eye, rays.direction(x + 0.5, y + 0.5));
      if (!hit) continue;
      const SurfacePoint surface = tracer.surface(*hit, eye);
      const Material& material = tracer.object(*hit).material;
      point.counts = !material.unlit && surface.emissive == glm::vec3(0.0f);
      const double roughness = surface.coatStrength > 0.0f ? surface.coatRoughness : surface.roughness;
      point.glossy = surface.coatStrength > 0.0f || surface.metallic > 0.5f || roughness < 0.3;
      point.object = hit->object;
      point.position = hit->positionWorld;
      point.normal = hit->frontWorld;
    }
  }
  return seen;
}

struct Numbers {
  double all = 0.0, glossy = 0.0, unlit = 0.0, seam = 0.0, light = 1.0;
  std::size_t probes = 0;
};

struct Sums {
  double squares = 0.0, noise = 0.0, truth = 0.0;
  double error() const { return truth > 0.0 ? std::sqrt(std::max(squares - noise, 0.0) / truth) : 0.0; }
};

void savePicture(const std::string& path, const ImageRgbaF& picture, double white) {
  ImageRgba8 shown;
  shown.width = picture.width;
  shown.height = picture.height;
  shown.pixels.resize(picture.pixels.size(), 255);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double value = std::pow(std::clamp(picture.pixels[i] / white, 0.0, 1.0), 1.0 / 2.2);
    shown.pixels[i] = static_cast<unsigned char>(std::lround(255.0 * value));
  }
  savePng(path, shown);
}

Numbers measure(OffscreenScene& shown, const Interior& interior, const std::vector<Probe>& probes,
                const std::string& pictures) {
  Scene scene = interior.loaded.scene;
  scene.probes = probes;
  Numbers numbers;
  numbers.probes = probes.size();
  Sums all, glossy;
  std::size_t points = 0, unlit = 0;
  double sum = 0.0, truthSum = 0.0;
  for (const View& view : interior.views) {
    shown.show(scene, interior.loaded.models, {view.camera});
    shown.capture();
    const ImageRgbaF picture = shown.renderer().renderLinear(interior.width, interior.height, 16);
    shown.requireHealthy();
    if (!pictures.empty())
      savePicture(pictures + "-" + std::to_string(&view - interior.views.data()) + ".png", picture, interior.white);
    const auto value = [&](const ImageRgbaF& image, std::size_t i, std::size_t c) {
      return std::clamp(static_cast<double>(image.pixels[4 * i + c]), 0.0, interior.white);
    };
    const auto noiseAt = [&](std::size_t i) {
      double noise = 0.0, bright = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        noise += view.truth.standardError.pixels[4 * i + c];
        bright += value(view.truth.color, i, c) + 0.1 * interior.white;
      }
      return noise / bright;
    };
    std::vector<int> lights(view.seen.size(), -1);
    for (std::size_t i = 0; i < view.seen.size(); ++i) {
      if (view.seen[i].object < 0) continue;
      lights[i] = dominantAt(probes, view.seen[i].position);
      ++points;
      unlit += lights[i] < 0 ? 1 : 0;
      if (!view.seen[i].counts || noiseAt(i) > kNoisy) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const double p = value(picture, i, c), t = value(view.truth.color, i, c);
        const double e = view.truth.standardError.pixels[4 * i + c];
        sum += p;
        truthSum += t;
        for (Sums* part : {&all, view.seen[i].glossy ? &glossy : nullptr}) {
          if (part == nullptr) continue;
          part->squares += (p - t) * (p - t);
          part->noise += e * e;
          part->truth += t * t;
        }
      }
    }
    for (int y = 0; y + 1 < interior.height; ++y) {
      for (int x = 0; x + 1 < interior.width; ++x) {
        for (const int step : {1, interior.width}) {
          const auto i = static_cast<std::size_t>(y * interior.width + x), k = i + static_cast<std::size_t>(step);
          const Seen &a = view.seen[i], &b = view.seen[k];
          if (a.object < 0 || a.object != b.object || !a.counts || glm::dot(a.normal, b.normal) < 0.99) continue;
          if (lights[i] == lights[k] || noiseAt(i) > 0.3 * kNoisy || noiseAt(k) > 0.3 * kNoisy) continue;
          double off = 0.0, bright = 0.0;
          for (std::size_t c = 0; c < 3; ++c) {
            const double p = value(picture, i, c) - value(picture, k, c);
            const double t = value(view.truth.color, i, c) - value(view.truth.color, k, c);
            off += std::abs(p - t);
            bright += 0.5 * (value(view.truth.color, i, c) + value(view.truth.color, k, c)) + 0.1 * interior.white;
          }
          numbers.seam = std::max(numbers.seam, off / bright);
        }
      }
    }
  }
  numbers.all = all.error();
  numbers.glossy = glossy.error();
  numbers.unlit = points > 0 ? static_cast<double>(unlit) / static_cast<double>(points) : 0.0;
  numbers.light = truthSum > 0.0 ? sum / truthSum : 1.0;
  return numbers;
}

struct PlacedScene {
  std::vector<Probe> probes;
  double seconds = 0.0, mebibytes = 0.0;
};

/// Runs the program as a person would, and reads what it wrote.
PlacedScene placedBy(const Options& options, const std::string& scene) {
  char name[] = "/tmp/placed-XXXXXX.boxprobe.json";
  const int file = mkstemps(name, 14);
  if (file < 0) throw WorkError("no temporary file");
  close(file);
  std::vector<std::string> words = {options.program, "place", scene, "-o", name, "--quiet"};
  for (const std::string& assignment : options.assignments) words.insert(words.end(), {"--set", assignment});
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const auto begun = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execv(options.program.c_str(), pointers.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  PlacedScene placed;
  placed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  placed.mebibytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  if (status != 0) {
    std::filesystem::remove(name);
    throw WorkError(scene + ": place failed");
  }
  placed.probes = loadScene(name).scene.probes;
  std::filesystem::remove(name);
  return placed;
}

void judge(OffscreenScene& shown, Options options, const std::string& path) {
  Interior interior;
  interior.loaded = loadScene(path, options.assignments);
  if (interior.loaded.fit && interior.loaded.fit->guess) {  // as whoever says yes to what the window asks
    const ImportGuess& guess = *interior.loaded.fit->guess;
    const std::string unit = guess.unit == LengthUnit::Millimetre   ? "mm"
                             : guess.unit == LengthUnit::Centimetre ? "cm"
                                                                    : "m";
    options.assignments.push_back("models.0.unit=" + unit);
    if (guess.upAxis == UpAxis::Z) options.assignments.emplace_back("models.0.upAxis=z");
    std::printf("%s: opened in %s%s, as the window proposes\n", path.c_str(), unit.c_str(),
                guess.upAxis == UpAxis::Z ? " with z up" : "");
    interior.loaded = loadScene(path, options.assignments);
  }
  if (std::sscanf(options.size.c_str(), "%dx%d", &interior.width, &interior.height) != 2) {
    throw InputError("--size " + options.size + ": expected WxH");
  }
  const Scene& scene = interior.loaded.scene;
  const SceneTracer tracer(makeTriangleScene(scene, interior.loaded.models));
  const ReferencePath reference(scene, interior.loaded.models, loadSkyImage(scene));
  PathSettings settings;
  settings.width = interior.width;
  settings.height = interior.height;
  settings.raysPerPixel = options.rays;
  double sum = 0.0;
  std::size_t count = 0;
  std::vector<Camera> cameras = eyesOf(tracer, options.eyes, options.seed);
  if (cameras.empty()) cameras = scene.cameras;
  for (const Camera& camera : cameras) {
    View view{camera, reference.render(camera, settings), seenFrom(tracer, camera, interior.width, interior.height)};
    for (std::size_t i = 0; i < view.seen.size(); ++i) {
      if (!view.seen[i].counts) continue;
      for (std::size_t c = 0; c < 3; ++c) sum += view.truth.color.pixels[4 * i + c];
      count += 3;
    }
    interior.views.push_back(std::move(view));
  }
  const std::string stem = std::filesystem::path(path).stem().stem().string();
  if (interior.views.empty() || !(sum > 0.0)) {
    std::printf("%-20s no closed place to look from, or no light\n", stem.c_str());
    return;
  }
  interior.white = 5.0 * sum / static_cast<double>(count);
  if (!options.folder.empty()) {
    for (const View& view : interior.views) {
      savePicture(options.folder + "/" + stem + "-path-" + std::to_string(&view - interior.views.data()) + ".png",
                  view.truth.color, interior.white);
      const glm::dvec3 &at = view.camera.position, &towards = view.camera.target;
      std::printf("%-20s eye %zd at (%.7g, %.7g, %.7g) towards (%.7g, %.7g, %.7g)\n", stem.c_str(),
                  &view - interior.views.data(), at.x, at.y, at.z, towards.x, towards.y, towards.z);
    }
  }
  const PlacedScene placed = placedBy(options, path);
  int bounces = 1;
  for (const Probe& probe : placed.probes) bounces = std::max(bounces, probe.bounces);

  glm::dvec3 low(1e300), high(-1e300);
  for (const TracedObject& object : tracer.scene().objects) {
    for (const glm::vec3& p : object.positions) {
      low = glm::min(low, tracer.scene().anchorWorld + glm::dvec3(p));
      high = glm::max(high, tracer.scene().anchorWorld + glm::dvec3(p));
    }
  }
  Scene fitted = scene;
  FitWishes wishes;
  wishes.kind = ModelKind::Interior;
  fitModel(fitted, interior.loaded.models, wishes);
  struct Row {
    const char* name;
    std::vector<Probe> probes;
    bool alike;  ///< with the number of bounces of what was placed
  };
  std::vector<Row> rows = {{"bounds", {fittedProbe({low, high})}, true}, {"one fitted", fitted.probes, true}};
  rows.push_back({"its own", scene.probes, false});
  rows.push_back({"placed", placed.probes, false});
  for (Row& row : rows) {
    for (Probe& probe : row.probes) {
      probe.bounces = row.alike ? bounces : probe.bounces;
      probe.faceSize = std::min(probe.faceSize, options.faceSize);
      probe.samplesPerPixel = 1;
    }
    const std::string pictures =
        options.folder.empty() ? "" : options.folder + "/" + stem + "-" + std::string(row.name).substr(0, 3);
    shown.forget();  // nothing of the probes before, which may have the same names
    const Numbers n = measure(shown, interior, row.probes, pictures);
    std::printf("%-20s %-10s %6zu %8.4f %8.4f %7.3f %8.2f %% %8.3f", stem.c_str(), row.name, n.probes, n.all, n.glossy,
                n.light, 100.0 * n.unlit, n.seam);
    if (&row == &rows.back()) std::printf(" %7.1f %6.0f", placed.seconds, placed.mebibytes);
    std::printf("\n");
    std::fflush(stdout);
  }
  shown.forget();
}

void run(const CLI::App& program, const Options& options) {
  OffscreenScene shown(bench::smallWindowSettings(program));
  std::printf("%-20s %-10s %6s %8s %8s %7s %10s %8s %7s %6s\n", "interior", "probes", "number", "error", "glossy",
              "light", "unlit", "seam", "seconds", "MiB");
  for (const std::string& scene : options.scenes) judge(shown, options, scene);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Error of pictures against the path tracer, before and after `boxprobe place`", "placed_pictures");
  Options options;
  program.add_option("SCENE", options.scenes, "Scene files or bare models")->required();
  program.add_option("--program", options.program, "The program that places");
  program.add_option("--size", options.size, "Of the pictures")->capture_default_str();
  program.add_option("--eyes", options.eyes, "How many look at each interior")->capture_default_str();
  program.add_option("--rays", options.rays, "Of the path tracer, for each pixel")->capture_default_str();
  program.add_option("--face-size", options.faceSize, "Of captures at most, in texels")->capture_default_str();
  program.add_option("--seed", options.seed, "Of the eyes")->capture_default_str();
  program.add_option("--set", options.assignments, "Change a field of the scenes first (repeatable)")
      ->allow_extra_args(false);
  program.add_option("-o,--output", options.folder, "Write the pictures into this folder");
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
