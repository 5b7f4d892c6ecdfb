#include "filters/io/files/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

enum SlotState { kFree, kTaken, kLive };

/// A signal handler may run between any two instructions: the name is complete before its state says so.
struct NameSlot {
  std::atomic<int> state{kFree};
  char name[PATH_MAX] = {};
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
  std::remove(name_.c_str());
  release();
}

void TemporaryName::release() {
  if (slot_ >= 0) nameSlots[slot_].state.store(kFree);
  slot_ = -1;
  name_.clear();
}

TemporaryFile::TemporaryFile(const std::string& folder, const std::string& start)
    : folder_(folder), name_(randomName(folder, start)) {
  descriptor_ = ::open(name_.name().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor_ >= 0) return;
  const int reason = errno;
  name_.release();  // it is not ours
  throw WorkError("cannot write into " + folder + ": " + std::strerror(reason));
}

TemporaryFile::~TemporaryFile() {
  ::close(descriptor_);
}

void TemporaryFile::write(const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = ::write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      throw WorkError("cannot write into " + folder_ + ": " + std::strerror(errno) +
                      "; is there room for temporary files?");
    }
    written += static_cast<std::size_t>(count);
  }
}

void removeTemporaryFiles() noexcept {
  for (NameSlot& slot : nameSlots) {
    if (slot.state.load() == kLive) ::unlink(slot.name);
  }
  for (NameSlot& slot : nameSlots) {
    if (slot.state.load() == kLive) ::rmdir(slot.name);
  }
}

}  // namespace boxprobe
