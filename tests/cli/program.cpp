// See program.h.
#include "tests/cli/program.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace boxprobe::test {

namespace fs = std::filesystem;

namespace {

fs::path newFolder() {
  std::string name = (fs::temp_directory_path() / "boxprobe-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
  return name;
}

/// In the child: never returns.
[[noreturn]] void become(const std::vector<std::string>& arguments, DisplayKind display, const fs::path& folder) {
  signal(SIGHUP, SIG_DFL);  // nohup hands down that it is ignored
  if (display == DisplayKind::Unset) unsetenv("DISPLAY");
  if (display == DisplayKind::Unreachable) setenv("DISPLAY", ":9876", 1);
  const auto redirect = [&](const char* name, int target) {
    const int file = open((folder / name).c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    if (file < 0 || dup2(file, target) < 0) _exit(126);
  };
  // Beside other tests that run: no preferences, no changes that a window offers to recover.
  for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) setenv(place, folder.c_str(), 1);
  if (const char* config = std::getenv("BOXPROBE_TEST_CONFIG_HOME")) setenv("XDG_CONFIG_HOME", config, 1);
  setenv("BOXPROBE_PROGRESS", "lines", 1);
  redirect("out", STDOUT_FILENO);
  redirect("err", STDERR_FILENO);
  std::string program = BOXPROBE_PROGRAM;
  std::vector<std::string> copies = arguments;
  std::vector<char*> argv = {program.data()};
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

/// True once `holds` does; false if `program` ended first, or never seems to do either.
template <typename Condition>
bool waitUntil(const RunningProgram& program, const Condition& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  while (!holds()) {
    if (program.ended() || std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

constexpr const char* kProgress = "progress ";  // and how many percent

}  // namespace

std::vector<std::string> Outcome::errLines() const {
  std::vector<std::string> lines;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, DisplayKind display) : folder_(newFolder()) {
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot fork");
  if (pid_ == 0) become(arguments, display, folder_);
}

RunningProgram::~RunningProgram() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

bool RunningProgram::handles(int signal) const {
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) != 0) continue;
    const unsigned long long caught = std::stoull(line.substr(7), nullptr, 16);
    if ((caught >> (signal - 1)) & 1) return true;
  }
  return false;
}

bool RunningProgram::waitUntilHandling(int signal) const {
  return waitUntil(*this, [&] { return handles(signal); });
}

bool RunningProgram::waitForProgress(int percent) const {
  return waitUntil(*this, [&] {
    const std::string err = readFile((folder_ / "err").string());
    const std::size_t last = err.rfind(kProgress);
    return last != std::string::npos && std::atoi(err.c_str() + last + std::strlen(kProgress)) >= percent;
  });
}

bool RunningProgram::ended() const {
  siginfo_t info = {};
  return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
}

bool RunningProgram::sendAtWork(int signal) const {
  kill(pid_, SIGSTOP);
  siginfo_t info = {};
  if (waitid(P_PID, static_cast<id_t>(pid_), &info, WSTOPPED | WEXITED | WNOWAIT) != 0) return false;
  const bool atWork = info.si_code == CLD_STOPPED && handles(signal);
  if (atWork) kill(pid_, signal);
  kill(pid_, SIGCONT);
  return atWork;
}

Outcome RunningProgram::finish() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  Outcome outcome;
  outcome.exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = readFile((folder_ / "out").string());
  std::istringstream said(readFile((folder_ / "err").string()));
  for (std::string line; std::getline(said, line);) {
    if (line.rfind(kProgress, 0) == 0) continue;
    outcome.err += line;
    if (!said.eof()) outcome.err += '\n';
  }
  return outcome;
}

Outcome runProgram(const std::vector<std::string>& arguments, DisplayKind display) {
  return RunningProgram(arguments, display).finish();
}

TemporaryFolder::TemporaryFolder() : folder_(newFolder()) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string TemporaryFolder::path(const std::string& name) const {
  return (folder_ / name).string();
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
  return path(name);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string triangleGltf(const std::string& imageUri) {
  const std::string texture = imageUri.empty() ? "" : R"(, "baseColorTexture": {"index": 0})";
  const std::string image =
      imageUri.empty() ? "" : R"(, "textures": [{"source": 0}], "images": [{"uri": ")" + imageUri + R"("}])";
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "triangle", "mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0, "material": 0}]}],
    "materials": [{"name": "paint", "pbrMetallicRoughness": {"metallicFactor": 0)" +
         texture +
         R"(}}],
    "buffers": [{"byteLength": 44, "uri": "data:application/octet-stream;base64,)"
         R"(AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 6, "target": 34963},
                    {"buffer": 0, "byteOffset": 8, "byteLength": 36, "target": 34962}],
    "accessors": [{"bufferView": 0, "componentType": 5123, "count": 3, "type": "SCALAR", "max": [2], "min": [0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3", "max": [1, 1, 0], "min": [0, 0, 0]}])" +
         image + "}";
}

std::string demoScene(const std::string& name) {
  return std::string(BOXPROBE_DATA_DIR) + "/scenes/" + name + ".boxprobe.json";
}

}  // namespace boxprobe::test
