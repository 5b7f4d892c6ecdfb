// The result of one subject on one input, and the definition of a subject.
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

/// The unit of an error. Relative: to the exact value. Levels: of the chain.
enum Measure { kUlp, kBoxSizes, kRelative, kLevels, kMeasures };

struct Trial {
  static constexpr double kNotMeasured = -1.0;
  bool finite = true;         ///< all results are finite
  bool lookupsUsable = true;  ///< lookups have a direction, and levels within the chain
  std::array<double, kMeasures> error{kNotMeasured, kNotMeasured, kNotMeasured, kNotMeasured};
  bool broken = false;    ///< an error exceeds its bound, or one of the above is false
  bool wrong = false;     ///< a visible error: 1 % of the box or of the value, 0.1 level, NaN
  double severity = 0.0;  ///< the largest ratio of an error to its bound; determines the worst input

  /// A NaN error counts as infinite. `held` false: reported, but not checked against the bound.
  void measure(Measure what, double value, double bound, bool held);
  void require(bool finiteResult, bool usable = true);
};

/// Intermediate values in order, for the replay of a single input. Optional.
class TrialLog {
 public:
  struct Line {
    std::string name, value, exact;  ///< `exact` may be empty
  };
  void add(const std::string& name, double value);
  void add(const std::string& name, const glm::vec3& value);
  void add(const std::string& name, double value, long double exact);
  void add(const std::string& name, const glm::vec3& value, const std::array<long double, 3>& exact);
  const std::vector<Line>& lines() const { return lines_; }

 private:
  std::vector<Line> lines_;
};

/// An item under test: a technique, a term of techniques, or a published form.
struct StressSubject {
  std::string id;  ///< `box+hdrp`, `term:jacobian`, `published:box-select`
  std::vector<const ParameterRow*> parameters;
  std::function<Trial(const StressInput&, const StressClass&, TrialLog*)> run;  ///< thread-safe
  const char* counterpart = nullptr;   ///< of a published form: the id of the program's equivalent
  double mostBoxSizes = 0.0;           ///< bound of the hit's error for 99.99 % of the inputs of a class; 0: none
  std::optional<Technique> technique;  ///< of subjects that are techniques
};

}  // namespace boxprobe::stress
