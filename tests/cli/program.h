// Starts the real program from a test and collects what it did. For tests/cli and tests/documents.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace boxprobe::test {

struct Outcome {
  int exitStatus = -1;  ///< 128 + the signal's number if one ended it
  std::string out;
  std::string err;

  std::vector<std::string> errLines() const;
};

enum class DisplayKind { Inherited, Unset, Unreachable };

/// Runs `boxprobe ARGUMENTS...` to its end.
Outcome runProgram(const std::vector<std::string>& arguments, DisplayKind display = DisplayKind::Inherited);

/// The program while it runs, for sending it signals. Its preferences and its kept changes are in a folder of its own.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& arguments, DisplayKind display = DisplayKind::Inherited);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Waits until the program handles `signal` itself; false if it ended or ten minutes passed first.
  bool waitUntilHandling(int signal) const;
  /// Waits until the program says that this share of its work is done; false if it ended or ten minutes passed first.
  /// Not with --quiet.
  bool waitForProgress(int percent) const;
  /// True once it has ended, before finish() as well.
  bool ended() const;
  /// Sends `signal` while the program stands still and handles it: the handler is the first of it that runs then.
  /// False, and nothing is sent, if it has ended or is past its work.
  bool sendAtWork(int signal) const;
  /// Waits for the end. What it said of its progress is left out of `err`.
  Outcome finish();

 private:
  bool handles(int signal) const;
  pid_t pid_ = -1;
  std::filesystem::path folder_;  ///< holds its stdout and stderr
};

/// A new empty folder, removed with all it holds at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const;
  std::string write(const std::string& name, const std::string& text) const;  ///< returns path(name)
  std::vector<std::string> names() const;  ///< of everything in it, hidden files too, sorted

 private:
  std::filesystem::path folder_;
};

std::string readFile(const std::string& path);

/// A glTF file of one triangle, node "triangle", material "paint"; `imageUri` (if any) is its base colour texture.
std::string triangleGltf(const std::string& imageUri = "");

/// data/scenes/NAME.boxprobe.json
std::string demoScene(const std::string& name);

}  // namespace boxprobe::test
