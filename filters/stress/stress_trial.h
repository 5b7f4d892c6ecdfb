// What one input showed of one subject, and what a subject is. Filled in by the subjects, gathered by stress_tally.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filters/math/technique/technique_table.h"
#include "filters/stress/stress_classes.h"
#include "filters/stress/stress_input.h"

namespace boxprobe::stress {

/// How far off a result is, by what is measured. Relative: to the exact value. Level: in levels of the chain.
enum Measure { kUlp, kBoxSizes, kRelative, kLevels, kMeasures };

struct Trial {
  static constexpr double kNotMeasured = -1.0;
  bool finite = true;         ///< every result is a number
  bool lookupsUsable = true;  ///< lookups have a direction, and levels within the chain
  std::array<double, kMeasures> error{kNotMeasured, kNotMeasured, kNotMeasured, kNotMeasured};
  bool broken = false;    ///< the promise is: an error above its bound, or one of the above
  bool wrong = false;     ///< so far off that it shows: 1 % of the box or of the value, 0.1 level, NaN
  double severity = 0.0;  ///< largest error over its bound; the worst input is the one with the most

  /// An error that is NaN counts as infinite. `held` false: it is reported, but breaks nothing.
  void measure(Measure what, double value, double bound, bool held);
  void require(bool finiteResult, bool usable = true);
};

/// Intermediate values, in order, for the replay of a single input. Subjects write to it if there is one.
class TrialLog {
 public:
  struct Line {
    std::string name, value, exact;  ///< `exact` empty if there is none
  };
  void add(const std::string& name, double value);
  void add(const std::string& name, const glm::vec3& value);
  void add(const std::string& name, double value, long double exact);
  void add(const std::string& name, const glm::vec3& value, const std::array<long double, 3>& exact);
  const std::vector<Line>& lines() const { return lines_; }

 private:
  std::vector<Line> lines_;
};

/// Something that is put to the test: a technique, a term that techniques are made of, or a form published elsewhere.
struct StressSubject {
  std::string id;  ///< `box+hdrp`, `term:jacobian`, `published:box-select`
  std::vector<const ParameterRow*> parameters;
  std::function<Trial(const StressInput&, const StressClass&, TrialLog*)> run;  ///< from any thread
  const char* counterpart = nullptr;   ///< of a published form: the own subject that does the same
  double mostBoxSizes = 0.0;           ///< bound of the hit's error for 99.99 % of the inputs of a class; 0: none
  std::optional<Technique> technique;  ///< of the first kind
};

}  // namespace boxprobe::stress
