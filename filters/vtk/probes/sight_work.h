// Tracing of what probes see of their lamps (filters/core/geometry/lamp_sight.h), beside everything else: in a thread
// of its own, again only for what has changed. Called by ProbeLight; OpenGL is not.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/geometry/lamp_sight.h"

namespace boxprobe {

class SightWork {
 public:
  using Models = std::vector<std::shared_ptr<const Model>>;

  SightWork() = default;
  ~SightWork();
  SightWork(const SightWork&) = delete;
  SightWork& operator=(const SightWork&) = delete;

  /// What may be wanted from now on: tasks, nothing for probes that need none; one without lamps and light sources asks
  /// for lines() alone. `lines` traces; null: nothing is. What is known already is kept. want() follows.
  void ask(std::vector<std::optional<SightTask>> tasks, const Scene& scene, const Models& models,
           const SightLinesMaker& lines);
  /// Which of the tasks are to be known; of the others nothing is traced. What runs goes on.
  void want(const std::vector<bool>& tasks);
  /// Memory of all that is wanted, with the texture that holds it as well: of what is not traced yet as much as it may
  /// take.
  std::size_t bytes() const;
  /// While a box is dragged nothing is begun.
  void hold(bool held) { held_ = held; }
  /// Is something wanted that is not known?
  bool pending() const { return !held_ && open_; }
  /// Begins what is asked for, or waits a little for it. True: more is known than before. Throws WorkError, after which
  /// it counts as known.
  bool proceed(std::chrono::milliseconds wait);
  struct Made {
    std::shared_ptr<const ProbeSight> sight;
    bool ofCapture = false;
  };
  /// Of the last proceed() that returned true: what was traced.
  const std::vector<Made>& made() const { return made_; }
  /// Of a task: what is seen, or what was seen of the same lamps before the box or the scene was changed; null: not
  /// known yet.
  std::shared_ptr<const ProbeSight> of(std::size_t task) const;
  /// Through the scene that was asked for last; null: not known yet, or nothing is to be traced.
  const std::shared_ptr<const SightLines>& lines() const { return lines_; }
  /// What runs ends soon; nothing begins before it has.
  void cancel();

 private:
  // What rays can meet: two that are equal need one tracer.
  struct Surroundings {
    Models models;
    std::vector<ModelFile> files;
    std::map<std::string, ObjectOverride> objects;
    std::map<std::string, bool> shining;  ///< of materials whose emission is another than the file's
    bool operator==(const Surroundings& o) const {
      return models == o.models && files == o.files && objects == o.objects && shining == o.shining;
    }
  };
  // What rays say of the surfaces that they meet depends on these overrides, by material: base colour and emission.
  using Looks = std::map<std::string, std::pair<std::optional<glm::vec3>, std::optional<glm::vec3>>>;
  static Looks looksOf(const Scene& scene);
  struct Known {
    std::optional<SightTask> task;
    std::shared_ptr<const ProbeSight> sight;
    bool current = false;  ///< of the task and the surroundings that are asked for
    bool wanted = false;
    bool open() const { return wanted && !current; }
  };
  struct Done {
    std::shared_ptr<const SightLines> lines;
    std::vector<std::shared_ptr<const ProbeSight>> sights;  ///< null: not asked
  };

  void start();
  bool anyOpen() const;
  bool anyWanted() const;
  SightSettings settings() const;

  std::vector<Known> known_;  ///< of each task
  Surroundings surroundings_;
  Looks looks_;
  bool otherLooks_ = false;             ///< lines_ says what surfaces looked like before
  std::shared_ptr<const Scene> scene_;  ///< null once there are lines of it, or nothing to trace
  SightLinesMaker maker_;
  std::shared_ptr<const SightLines> lines_;  ///< of the surroundings; null: not built yet
  bool held_ = false, open_ = false;
  std::vector<Made> made_;
  std::future<Done> running_;
  std::vector<bool> traced_;  ///< the tasks that it is at
  std::shared_ptr<std::atomic<bool>> cancelled_;
  std::vector<std::future<Done>> ending_;  ///< cancelled ones, which nobody waits for while there is something to draw
};

}  // namespace boxprobe
