// Races on purpose, so that a test can ask whether ThreadSanitizer still tells them with what is suppressed in
// tests/tsan.supp: in a parallel loop, and in a thread. Argument: loop or thread.
#include <tbb/parallel_for.h>

#include <cstdio>
#include <string>
#include <thread>

namespace {

int deliberateCount = 0;

}  // namespace

int main(int argc, char** argv) {
  const std::string where = argc > 1 ? argv[1] : "loop";
  if (where == "loop") {
    tbb::parallel_for(0, 1000, [](int) { ++deliberateCount; });
  } else {
    std::thread other([] { ++deliberateCount; });
    ++deliberateCount;
    other.join();
  }
  std::printf("%d\n", deliberateCount);
  return 0;
}
