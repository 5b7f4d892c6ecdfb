#include "filters/io/cube/cube_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

struct Scheme {
  std::array<const char*, 6> faces;
  bool openExr;
  bool needsSeparator;  ///< too short to end a word: "sphinx" is no -X face
};
constexpr std::array<Scheme, 4> kSchemes = {{
    {{"posx", "negx", "posy", "negy", "posz", "negz"}, false, false},
    {{"px", "nx", "py", "ny", "pz", "nz"}, false, true},
    {{"right", "left", "top", "bottom", "front", "back"}, false, true},
    {{"+x", "-x", "+y", "-y", "+z", "-z"}, true, false},
}};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// `word` with the capitalization of `example`: "left" becomes "Left" for "Right".
std::string inCaseOf(std::string word, const std::string& example) {
  for (std::size_t i = 0; i < word.size() && !example.empty(); ++i) {
    const auto model = static_cast<unsigned char>(example[std::min(i, example.size() - 1)]);
    if (std::isupper(model)) word[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[i])));
  }
  return word;
}

bool endsWith(const std::string& stem, const std::string& face) {
  if (stem.size() < face.size()) return false;
  const std::size_t start = stem.size() - face.size();
  return std::equal(face.begin(), face.end(), stem.begin() + static_cast<std::ptrdiff_t>(start),
                    [](char a, char b) { return a == lower(b); });
}

bool allExist(const SixNames& names) {
  std::error_code ignored;
  return std::all_of(names.paths.begin(), names.paths.end(),
                     [&](const std::string& path) { return std::filesystem::is_regular_file(path, ignored); });
}

SixNames compose(const std::string& before, const Scheme& scheme, const std::string& example,
                 const std::string& after) {
  SixNames names;
  names.openExr = scheme.openExr;
  for (std::size_t i = 0; i < 6; ++i) names.paths[i] = before + inCaseOf(scheme.faces[i], example) + after;
  return names;
}

struct Pattern {
  std::string before, after;
  bool exrenvmap = false;  ///< a bare %
};
std::optional<Pattern> splitPattern(const std::string& path) {
  const std::size_t at = path.find('%');
  if (at == std::string::npos) return std::nullopt;
  const bool withLetter = at + 1 < path.size() && path[at + 1] == 's';
  return Pattern{path.substr(0, at), path.substr(at + (withLetter ? 2 : 1)), !withLetter};
}

}  // namespace

std::optional<SixNames> findSixNames(const std::string& path) {
  if (const auto pattern = splitPattern(path)) {
    for (const Scheme& scheme : kSchemes) {
      for (const char* example : {"a", "A", "Aa", "aaaA"}) {
        const SixNames names = compose(pattern->before, scheme, example, pattern->after);
        if (allExist(names)) return names;
      }
    }
    return std::nullopt;
  }
  const std::filesystem::path file(path);
  const std::string stem = file.stem().string(), extension = file.extension().string();
  for (const Scheme& scheme : kSchemes) {
    for (const std::string face : scheme.faces) {
      if (!endsWith(stem, face)) continue;
      const std::string before = stem.substr(0, stem.size() - face.size());
      const bool inWord = !before.empty() && std::isalnum(static_cast<unsigned char>(before.back()));
      if (scheme.needsSeparator && inWord) continue;
      const SixNames names =
          compose((file.parent_path() / before).string(), scheme, stem.substr(before.size()), extension);
      if (allExist(names)) return names;
    }
  }
  return std::nullopt;
}

SixNames sixNamesToWrite(const std::string& pattern) {
  const auto split = splitPattern(pattern);
  if (!split) throw InputError(pattern + ": six files need a %s where the face goes, as in room_%s.exr");
  return compose(split->before, kSchemes[split->exrenvmap ? 3 : 1], split->exrenvmap ? "A" : "a", split->after);
}

}  // namespace boxprobe
