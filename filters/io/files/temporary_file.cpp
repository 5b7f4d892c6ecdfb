#include "filters/io/files/temporary_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

constexpr int kLongestName = 4096;

enum SlotState { kFree, kTaken, kLive };

/// A signal handler may run between any two instructions: the name is complete before its state says so.
struct NameSlot {
  std::atomic<int> state{kFree};
  char name[kLongestName] = {};
};

NameSlot nameSlots[96];

/// -1 if all slots are taken or the name is too long: that file stays behind if a signal ends the process.
int keepName(const std::string& name) {
  constexpr int kSlots = sizeof nameSlots / sizeof nameSlots[0];
  if (name.size() >= sizeof nameSlots[0].name) return -1;
  for (int i = 0; i < kSlots; ++i) {
    int expected = kFree;
    if (!nameSlots[i].state.compare_exchange_strong(expected, kTaken)) continue;
    std::memcpy(nameSlots[i].name, name.c_str(), name.size() + 1);
    nameSlots[i].state.store(kLive);
    return i;
  }
  return -1;
}

std::string randomName(const std::string& folder, const std::string& start) {
  static thread_local std::mt19937_64 random{std::random_device{}()};
  return (std::filesystem::path(folder) / (start + std::to_string(random()))).string();
}

}  // namespace

TemporaryName::TemporaryName(std::string name) : name_(std::move(name)), slot_(keepName(name_)) {}

TemporaryName::~TemporaryName() {
  if (name_.empty()) return;
  if (!removeFile(name_.c_str())) removeEmptyFolder(name_.c_str());
  release();
}

void TemporaryName::release() {
  if (slot_ >= 0) nameSlots[slot_].state.store(kFree);
  slot_ = -1;
  name_.clear();
}

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& start)
    : folder_(folder), name_(randomName(folder, start)), file_(name_.name(), Access::UserAlone) {
  if (file_.isOpen()) return;
  const int reason = errno;
  name_.release();  // it is not ours
  throw WorkError("cannot write into " + folder + ": " + std::strerror(reason));
}

void TemporaryFile::write(const std::string& text) {
  if (file_.write(text.data(), text.size())) return;
  throw WorkError("cannot write into " + folder_ + ": " + std::strerror(errno) +
                  "; is there room for temporary files?");
}

void removeTemporaryFiles() noexcept {
  for (NameSlot& slot : nameSlots) {
    if (slot.state.load() == kLive) removeFile(slot.name);
  }
  for (NameSlot& slot : nameSlots) {
    if (slot.state.load() == kLive) removeEmptyFolder(slot.name);
  }
}

}  // namespace boxprobe
