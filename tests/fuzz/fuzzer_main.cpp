// libFuzzer's entry: BOXPROBE_FUZZ_TARGET is the function of parse_target.h that this program feeds. libFuzzer brings
// main(); an exception that leaves the target ends the process, which is how it notices.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/parse_target.h"

// Readers allocate often: four frames say who did, and are had in half the time of thirty. ASAN_OPTIONS comes after
// this.
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=4:quarantine_size_mb=32";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  boxprobe::fuzz::BOXPROBE_FUZZ_TARGET(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
