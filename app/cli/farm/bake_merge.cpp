#include "app/cli/farm/bake_merge.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "filters/io/files/atomic_file.h"

namespace boxprobe {

namespace fs = std::filesystem;

namespace {

struct Copy {
  std::string from, to;
  BakeRow* row = nullptr;  ///< null: of the sky
};

std::string makerText(const BakeMaker& maker) {
  return maker.program + " on " + (maker.renderer.empty() ? "an unnamed renderer" : maker.renderer);
}

/// All files that a bake consists of have the first one's maker.
class OneMaker {
 public:
  explicit OneMaker(bool mixed) : mixed_(mixed) {}
  void add(const BakeFolder& folder, const std::string& key) {
    const BakeMaker& maker = folder.maker(key);
    if (!first_) first_ = {folder.file(key), maker};
    if (mixed_ || maker == first_->second) return;
    throw InputError(folder.file(key) + ": baked by " + makerText(maker) + ", but " + first_->first + " by " +
                     makerText(first_->second) + "; bake all by one of them, or say --mixed");
  }

 private:
  bool mixed_;
  std::optional<std::pair<std::string, BakeMaker>> first_;
};

/// Of a probe that no folder has: a file of its name shows something else, and that is worth more than "missing".
void refuseOtherState(const std::string& name, const std::vector<BakeFolder>& sources) {
  for (const BakeFolder& source : sources) {
    const std::string path = (fs::path(source.path()) / BakeFolder::fileName(name)).string();
    std::error_code none;
    if (fs::exists(path, none)) {
      throw InputError(path + ": shows another state of the scene or was made by another version; bake it again");
    }
  }
}

std::vector<BakeFolder> foldersOf(const std::vector<std::string>& paths) {
  std::vector<BakeFolder> folders;
  for (const std::string& path : paths) {
    std::error_code none;
    if (!fs::is_directory(path, none)) throw InputError("--merge " + path + ": is no folder");
    folders.emplace_back(path);
  }
  return folders;
}

std::optional<Copy> copyOfSky(const std::string& folder, const std::vector<BakeFolder>& sources) {
  const std::string name = BakeFolder::fileName("");
  const fs::path to = fs::path(folder) / name;
  std::error_code none;
  if (fs::exists(to, none)) return {};
  for (const BakeFolder& source : sources) {
    const fs::path from = fs::path(source.path()) / name;
    if (fs::exists(from, none) && bakedProbeDamage(from.string()).empty()) return Copy{from.string(), to.string()};
  }
  return {};
}

/// Of probes that are done: nobody needs them any more.
int removeEarlierBounces(const std::string& folder, const std::vector<BakeRow>& rows) {
  int removed = 0;
  for (const BakeRow& row : rows) {
    for (int bounce = 1; bounce < row.bounces; ++bounce) {
      const fs::path file = fs::path(folder) / BakeFolder::fileName(row.name, bounce);
      std::error_code none;
      if (bakedProbeMark(file.string())) removed += fs::remove(file, none) ? 1 : 0;
    }
  }
  return removed;
}

}  // namespace

void requireMaker(const std::vector<BakeRow>& rows, const BakeFolder& folder, const BakeMaker& maker) {
  for (const BakeRow& row : rows) {
    if (row.state != "done" || folder.maker(row.key) == maker) continue;
    throw InputError(folder.file(row.key) + ": baked by " + makerText(folder.maker(row.key)) + ", and this is " +
                     makerText(maker) + "; bake all by one of them (in another folder), or say --mixed");
  }
}

BakeMerge mergeBaked(std::vector<BakeRow>& rows, const std::string& folder, const std::vector<std::string>& sources,
                     bool mixed) {
  const std::vector<BakeFolder> folders = foldersOf(sources);
  const BakeFolder target(folder);
  OneMaker maker(mixed);
  std::vector<Copy> copies;
  for (BakeRow& row : rows) {
    if (row.state == "done") {
      maker.add(target, row.key);
      continue;
    }
    const auto source = std::find_if(folders.begin(), folders.end(),
                                     [&](const BakeFolder& each) { return !row.key.empty() && each.has(row.key); });
    if (source == folders.end()) {
      refuseOtherState(row.name, folders);
      continue;
    }
    maker.add(*source, row.key);
    copies.push_back({source->file(row.key), (fs::path(folder) / BakeFolder::fileName(row.name)).string(), &row});
  }
  if (const auto sky = copyOfSky(folder, folders)) copies.push_back(*sky);

  BakeMerge result;
  for (const Copy& copy : copies) {
    writeAtomically(copy.to, [&](const std::string& temporary) {
      fs::copy_file(copy.from, temporary, fs::copy_options::overwrite_existing);
    });
    result.written.push_back(copy.to);
    if (copy.row == nullptr) continue;
    copy.row->state = "done";
    copy.row->made = copy.row->bounces;
  }
  const bool complete = std::all_of(rows.begin(), rows.end(), [](const BakeRow& row) { return row.state == "done"; });
  if (complete) result.removed = removeEarlierBounces(folder, rows);
  return result;
}

}  // namespace boxprobe
