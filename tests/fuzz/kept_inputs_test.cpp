// Every input that once was a finding, and the corpus the fuzzers start from, through the same functions without any
// fuzzer: what was repaired stays so, in every build. Each input must be over within seconds, sanitized or not.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/parse_target.h"

namespace boxprobe {
namespace {

namespace fs = std::filesystem;

struct Kind {
  const char* name;
  void (*parse)(const std::string&);
};

class KeptInputs : public ::testing::TestWithParam<Kind> {
 protected:
  void parseAll(const char* folder, std::size_t atLeast) {
    const fs::path path = fs::path(BOXPROBE_SOURCE_DIR) / "tests/fuzz" / folder / GetParam().name;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(path)) {
      SCOPED_TRACE(entry.path().filename().string());
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      EXPECT_NO_THROW(GetParam().parse(bytes));
      ++count;
    }
    EXPECT_GE(count, atLeast) << path;
  }
};

TEST_P(KeptInputs, FindingsStayRepaired) {
  parseAll("regressions", 1);
}
TEST_P(KeptInputs, TheCorpusIsReadOrRefused) {
  parseAll("corpus", 4);
}

INSTANTIATE_TEST_SUITE_P(Readers, KeptInputs,
                         ::testing::Values(Kind{"scene", &fuzz::parseSceneText}, Kind{"cube", &fuzz::parseCubeFile},
                                           Kind{"engine", &fuzz::parseEngineText}, Kind{"model", &fuzz::parseModelFile},
                                           Kind{"lesson", &fuzz::parseLessonText}, Kind{"obj", &fuzz::parseObjFile},
                                           Kind{"ply", &fuzz::parsePlyFile}, Kind{"stl", &fuzz::parseStlFile},
                                           Kind{"vtp", &fuzz::parseVtpFile}),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace boxprobe
