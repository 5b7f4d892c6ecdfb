#include "filters/io/engines/export_names.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "filters/core/base/errors.h"

namespace boxprobe {

std::vector<std::string> exportStems(const std::vector<std::string>& probeNames) {
  std::vector<std::string> stems;
  std::map<std::string, std::string> taken;  // lower-case stem, and the probe that has it
  for (const std::string& name : probeNames) {
    std::string stem = name.empty() ? "_" : name;
    std::replace_if(
        stem.begin(), stem.end(),
        [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '-' && c != '_'); }, '_');
    std::string key = stem;
    std::transform(key.begin(), key.end(), key.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto [other, added] = taken.emplace(key, name);
    if (!added) {
      throw InputError("probes." + name + ": its file would be " + stem + ", as that of probe \"" + other->second +
                       "\" (case does not count); rename one of them");
    }
    stems.push_back(stem);
  }
  return stems;
}

}  // namespace boxprobe
