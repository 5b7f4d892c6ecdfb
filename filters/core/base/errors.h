// The one exception family of the program. Whatever reads, writes or validates throws it; main catches it and prints
// what() as a single line. Mathematical functions never throw.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "filters/core/base/export.h"

namespace boxprobe {

/// Base: `what()` is one line that names the file, the place in it and what to do.
class BOXPROBE_EXPORT Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  virtual int exitStatus() const { return 1; }
};

/// The work itself failed (disk full, shader refused by the driver). Exit status 1.
class BOXPROBE_EXPORT WorkError : public Error {
 public:
  using Error::Error;
};

/// Bad usage or bad input. Exit status 2.
class BOXPROBE_EXPORT InputError : public Error {
 public:
  using Error::Error;
  int exitStatus() const override { return 2; }
};

/// One line for any exception: what() of an Error, and words where the library that threw has none for people, as
/// std::bad_alloc has.
BOXPROBE_EXPORT std::string messageOf(const std::exception& error);

/// What messageOf() says of std::bad_alloc.
constexpr const char* kOutOfMemory = "out of memory; close other programs, or use smaller models and pictures";

/// What `work` returns. Where memory or threads do not suffice, the WorkError names what they were for: a file.
template <typename Work>
auto withMemoryFor(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw WorkError(file + ": " + kOutOfMemory);
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    throw WorkError(file + ": " + messageOf(error));
  }
}

}  // namespace boxprobe
