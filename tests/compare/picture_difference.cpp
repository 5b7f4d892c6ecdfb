// Compares two recordings of the program: pictures by their values, JSON by its keys and numbers. One line a category,
// one line for each thing that is missing or differs too much, exit status 1 then. Knows files, not the program.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/compare/json_values.h"
#include "tests/compare/picture_values.h"

namespace {

using namespace boxprobe::compare;
namespace fs = std::filesystem;

constexpr double kDisplayLimit = 1.0;         // in 1/255
constexpr double kLinearLimit = 1.0 / 255.0;  // relative; also of numbers with fractions

/// Names relative to `folder` of the files that `wanted` takes, at any depth.
template <typename Wanted>
std::set<std::string> filesIn(const std::string& folder, Wanted wanted) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && wanted(entry.path().string())) {
      names.insert(fs::relative(entry.path(), folder).string());
    }
  }
  return names;
}

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

bool isJsonName(const std::string& path) {
  return fs::path(path).extension() == ".json";
}

std::size_t countAdded(const std::set<std::string>& before, const std::set<std::string>& after) {
  return static_cast<std::size_t>(
      std::count_if(after.begin(), after.end(), [&](const std::string& name) { return before.count(name) == 0; }));
}

bool comparePictures(const std::string& oldFolder, const std::string& newFolder, bool exact) {
  const auto before = filesIn(oldFolder, isPictureName), after = filesIn(newFolder, isPictureName);
  if (before.empty()) throw std::runtime_error(oldFolder + ": no pictures to compare");
  std::size_t compared = 0, identical = 0, missing = 0, beyond = 0;
  double display = 0.0, linear = 0.0;
  for (const std::string& name : before) {
    if (after.count(name) == 0) {
      std::printf("  missing: %s\n", name.c_str());
      ++missing;
      continue;
    }
    const PictureValues old = readPicture(inFolder(oldFolder, name));
    const PictureDifference found = difference(old, readPicture(inFolder(newFolder, name)));
    for (const std::string& part : found.missing) std::printf("  missing: %s: %s\n", name.c_str(), part.c_str());
    missing += found.missing.size();
    ++compared;
    identical += found.differing == 0 && found.missing.empty() ? 1 : 0;
    double& largest = old.display ? display : linear;
    largest = std::max(largest, found.largest);
    if (found.largest <= (exact ? 0.0 : old.display ? kDisplayLimit : kLinearLimit)) continue;
    std::printf("  differs: %s: %zu of %zu values, by at most %.6g%s\n", name.c_str(), found.differing, found.values,
                found.largest, old.display ? "/255" : " relative");
    ++beyond;
  }
  std::printf("%zu compared, %zu identical, %zu differing, %zu of them too much", compared, identical,
              compared - identical, beyond);
  std::printf("; largest difference %.6g/255 (display), %.3g relative (linear); %zu missing, %zu added\n", display,
              linear, missing, countAdded(before, after));
  return missing == 0 && beyond == 0;
}

/// Whole numbers count something and must be equal; others are results of arithmetic.
bool tooFar(double before, double after, bool exact) {
  if (before == after) return false;
  const bool whole = before == std::floor(before) && after == std::floor(after);
  const double size = std::max({std::abs(before), std::abs(after), 1e-6});
  return exact || whole || std::abs(before - after) / size > kLinearLimit;
}

bool compareJson(const std::string& oldFolder, const std::string& newFolder, bool exact) {
  const auto before = filesIn(oldFolder, isJsonName), after = filesIn(newFolder, isJsonName);
  if (before.empty()) throw std::runtime_error(oldFolder + ": no JSON to compare");
  std::size_t keys = 0, missing = 0, added = 0, numbers = 0, changed = 0, beyond = 0;
  for (const std::string& name : before) {
    if (after.count(name) == 0) {
      std::printf("  missing: %s\n", name.c_str());
      ++missing;
      continue;
    }
    const JsonValues old = readJson(inFolder(oldFolder, name)), fresh = readJson(inFolder(newFolder, name));
    keys += old.keys.size();
    for (const std::string& key : old.keys) {
      if (fresh.keys.count(key) != 0) continue;
      std::printf("  missing: %s: %s\n", name.c_str(), key.c_str());
      ++missing;
    }
    for (const std::string& key : fresh.keys) {
      if (old.keys.count(key) != 0) continue;
      std::printf("  added: %s: %s\n", name.c_str(), key.c_str());
      ++added;
    }
    for (const auto& [path, value] : old.numbers) {
      const auto found = fresh.numbers.find(path);
      if (changesByRun(path)) continue;
      if (found == fresh.numbers.end()) {
        std::printf("  missing: %s: the number %s\n", name.c_str(), path.c_str());
        ++missing;
        continue;
      }
      ++numbers;
      changed += value != found->second ? 1 : 0;
      if (!tooFar(value, found->second, exact)) continue;
      std::printf("  differs: %s: %s: %.9g, now %.9g\n", name.c_str(), path.c_str(), value, found->second);
      ++beyond;
    }
  }
  std::printf("%zu files, %zu keys: %zu missing, %zu added; %zu numbers: %zu differing, %zu of them too much\n",
              before.size(), keys, missing, added, numbers, changed, beyond);
  return missing == 0 && beyond == 0;
}

void printNumbers(const std::string& path) {
  for (const auto& [place, value] : readJson(path).numbers) std::printf("%s %.9g\n", place.c_str(), value);
}

/// One line each: the name of every element of the list `list` of a document.
void printNames(const std::string& path, const std::string& list) {
  for (const std::string& name : namesInJson(path, list)) std::printf("%s\n", name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::size_t count = arguments.size();
    const bool exact = count == 4 && arguments[3] == "--exact";
    const bool two = count == 3 || exact;
    if (two && arguments[0] == "pictures") return comparePictures(arguments[1], arguments[2], exact) ? 0 : 1;
    if (two && arguments[0] == "json") return compareJson(arguments[1], arguments[2], exact) ? 0 : 1;
    if (count == 2 && arguments[0] == "numbers") {
      printNumbers(arguments[1]);
      return 0;
    }
    if (count == 3 && arguments[0] == "names") {
      printNames(arguments[1], arguments[2]);
      return 0;
    }
    std::fputs(
        "usage: picture_difference pictures|json OLD_DIR NEW_DIR [--exact], numbers FILE.json, or names FILE.json "
        "LIST\n",
        stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "picture_difference: %s\n", error.what());
  }
  return 2;
}
