// See fit_measure.h.
#include "app/lessons/fit_measure.h"

#include <algorithm>
#include <cstdlib>

#include "filters/fit/fit_probe.h"

namespace boxprobe {

namespace {

std::vector<std::string> partsOf(const std::string& pointer) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin < pointer.size() && pointer[begin] == '/') {
    const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
    parts.push_back(pointer.substr(begin + 1, end - begin - 1));
    begin = end;
  }
  return parts;
}

/// "0", "1", ...; anything else is beyond every list.
std::size_t indexOf(const std::string& part) {
  const bool digits = !part.empty() && part.size() < 6 && part.find_first_not_of("0123456789") == std::string::npos;
  return digits ? static_cast<std::size_t>(std::atoi(part.c_str())) : static_cast<std::size_t>(-1);
}

std::optional<double> ofErrors(const LookupErrors& errors, const std::string& name) {
  if (name == "meanDegrees") return errors.meanDegrees;
  if (name == "p95Degrees") return errors.p95Degrees;
  return std::nullopt;
}

std::optional<double> ofFace(const BoxFit& fit, const std::string& face, const std::string& name) {
  for (int i = 0; i < kFaces; ++i) {
    if (face != faceName(i)) continue;
    const FaceFit& found = fit.faces[static_cast<std::size_t>(i)];
    if (name == "gainDegrees") return found.gainDegrees;
    if (name == "sensitivity") return found.sensitivity;
    if (name == "free") return found.free ? 1.0 : 0.0;
  }
  return std::nullopt;
}

/// `parts`: below the probe.
std::optional<double> numberOf(const BoxFit& fit, const std::vector<std::string>& parts) {
  if (parts.size() == 2 && parts[0] == "before") return ofErrors(fit.before, parts[1]);
  if (parts.size() == 2 && parts[0] == "after") return ofErrors(fit.after, parts[1]);
  if (parts.size() != 3) return std::nullopt;
  if (parts[0] == "faces") return ofFace(fit, parts[1], parts[2]);
  const std::size_t axis = indexOf(parts[2]);
  if (parts[0] != "box" || axis > 2) return std::nullopt;
  const auto at = static_cast<glm::length_t>(axis);
  if (parts[1] == "min") return fit.probe.box.min[at];
  if (parts[1] == "max") return fit.probe.box.max[at];
  return std::nullopt;
}

}  // namespace

std::optional<double> fitNumber(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                                const std::string& pointer, const std::function<bool()>& goOn) {
  std::vector<std::string> parts = partsOf(pointer);
  if (parts.size() < 4 || parts[0] != "probes") return std::nullopt;
  const std::size_t probe = indexOf(parts[1]);
  if (probe >= scene.probes.size()) return std::nullopt;
  parts.erase(parts.begin(), parts.begin() + 2);
  const auto fit = ProbeFitter(scene, models).fit(scene.probes[probe], {}, [&](double) { return !goOn || goOn(); });
  return fit ? numberOf(*fit, parts) : std::nullopt;
}

}  // namespace boxprobe
