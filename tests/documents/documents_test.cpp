// The README.md files hold together: links lead somewhere, nothing stands twice, examples are the ones that are
// compiled, every block of code says what it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/cli/program.h"
#include "tests/documents/readme_files.h"

namespace boxprobe::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::IsEmpty;

const std::string kProject = BOXPROBE_SOURCE_DIR;

const std::vector<Readme>& readmes() {
  static const std::vector<Readme> all = readReadmes(kProject);
  return all;
}

const Readme* readmeAt(const fs::path& path) {
  for (const Readme& readme : readmes()) {
    if (fs::path(kProject) / readme.path == path) return &readme;
  }
  return nullptr;
}

TEST(Documents, TheFirstOneIsShort) {
  ASSERT_NE(readmeAt(fs::path(kProject) / "README.md"), nullptr);
  EXPECT_LE(fs::file_size(fs::path(kProject) / "README.md"), 7000u);
}

TEST(Documents, LinksAndPicturesAreThere) {
  int checked = 0;
  for (const Readme& readme : readmes()) {
    for (const Link& link : links(readme)) {
      if (link.target.find("://") != std::string::npos) continue;
      const std::size_t hash = link.target.find('#');
      const std::string file = link.target.substr(0, hash);
      const fs::path from = fs::path(kProject) / readme.path;
      const fs::path target = file.empty() ? from : (from.parent_path() / file).lexically_normal();
      EXPECT_TRUE(fs::exists(target)) << link.place.text() << ": " << link.target;
      ++checked;
      if (hash == std::string::npos) continue;
      const Readme* document = readmeAt(target);
      ASSERT_NE(document, nullptr) << link.place.text() << ": " << link.target << " is no README.md";
      EXPECT_THAT(anchors(*document), Contains(link.target.substr(hash + 1))) << link.place.text();
    }
  }
  EXPECT_GT(checked, 40);
}

TEST(Documents, EveryDocumentIsReachedFromTheFirst) {
  std::vector<std::string> reached = {"README.md"};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Readme* readme = readmeAt(fs::path(kProject) / reached[i]);
    if (readme == nullptr) continue;
    for (const Link& link : links(*readme)) {
      const fs::path folder = (fs::path(kProject) / readme->path).parent_path();
      const fs::path target = (folder / link.target.substr(0, link.target.find('#'))).lexically_normal();
      const std::string path = target.lexically_relative(kProject).string();
      if (std::find(reached.begin(), reached.end(), path) == reached.end()) reached.push_back(path);
    }
  }
  for (const Readme& readme : readmes()) {
    EXPECT_EQ(std::count(reached.begin(), reached.end(), readme.path), 1) << readme.path << ": link it from another";
  }
}

TEST(Documents, FilesNamedInSentencesAreThere) {
  static const std::regex path("(app|filters|shaders|tests|data)/[A-Za-z0-9_./-]+");
  for (const Readme& readme : readmes()) {
    for (const CodeSpan& span : codeSpans(readme)) {
      // In its own section a technique is added that is not there.
      if (!std::regex_match(span.text, path) || span.text.find("evaluation_halved") != std::string::npos) continue;
      EXPECT_TRUE(fs::exists(fs::path(kProject) / span.text)) << span.place.text() << ": " << span.text;
    }
  }
}

TEST(Documents, NothingIsSaidTwice) {
  constexpr std::size_t kShort = 60;  // headers of tables, and the like
  std::map<std::string, Place> seen;
  for (const Readme& readme : readmes()) {
    for (const Paragraph& paragraph : paragraphs(readme)) {
      if (paragraph.text().size() < kShort) continue;
      const auto [first, added] = seen.emplace(paragraph.text(), paragraph.place);
      EXPECT_TRUE(added) << paragraph.place.text() << " repeats " << first->second.text();
    }
  }
}

TEST(Documents, BlocksSayWhatTheyAre) {
  for (const Readme& readme : readmes()) {
    for (const CodeBlock& block : codeBlocks(readme)) {
      EXPECT_THAT(block.language, AnyOf("sh", "text", "json", "cpp", "glsl"))
          << block.place.text() << ": begin it with ```sh (commands), ```text, ```json, ```cpp or ```glsl";
      if (block.language == "sh") continue;
      for (const std::string& line : block.lines) {
        EXPECT_FALSE(std::regex_search(line, std::regex("^ *(\\./run|boxprobe|build/release|cmake|ctest) ")))
            << block.place.text() << ": commands belong in ```sh: " << line;
      }
    }
  }
}

/// What is shown as a program is one of tests/examples, whole, which tests run. tests/added_technique and
/// tests/added_field follow the rest.
TEST(Documents, CodeIsCompiled) {
  std::map<std::string, int> shown;
  for (const auto& entry : fs::directory_iterator(kProject + "/tests/examples")) {
    if (entry.path().extension() == ".cpp") shown[readFile(entry.path().string())] = 0;
  }
  for (const Readme& readme : readmes()) {
    for (const CodeBlock& block : codeBlocks(readme)) {
      if (block.language != "cpp" && block.language != "glsl") continue;
      if (readme.path == "shaders/technique/README.md" || readme.path == "data/scenes/README.md") continue;
      std::string text;
      for (const std::string& line : block.lines) text += line + '\n';
      EXPECT_EQ(shown.count(text), 1u) << block.place.text() << ": equal to no file of tests/examples";
      ++shown[text];
    }
  }
  for (const auto& [text, times] : shown) EXPECT_EQ(times, 1) << "in no README.md, or in two:\n" << text;
}

TEST(Documents, JsonIsJson) {
  for (const Readme& readme : readmes()) {
    for (const CodeBlock& block : codeBlocks(readme)) {
      if (block.language != "json") continue;
      std::string text;
      for (const std::string& line : block.lines) text += line + '\n';
      EXPECT_TRUE(nlohmann::json::accept(text)) << block.place.text() << ":\n" << text;
    }
  }
}

/// A `span` over two lines would hide from the tests what it holds.
TEST(Documents, SpansOfCodeEndOnTheirLine) {
  for (const Readme& readme : readmes()) {
    for (const Paragraph& paragraph : paragraphs(readme)) {
      for (std::size_t i = 0; i < paragraph.lines.size(); ++i) {
        EXPECT_EQ(std::count(paragraph.lines[i].begin(), paragraph.lines[i].end(), '`') % 2, 0)
            << paragraph.place.file << ":" << paragraph.place.line + static_cast<int>(i);
      }
    }
  }
}

TEST(Documents, AreFound) {
  EXPECT_THAT(readmes(), ::testing::SizeIs(::testing::Ge(10u)));
  for (const Readme& readme : readmes()) EXPECT_THAT(readme.lines, Not(IsEmpty())) << readme.path;
}

}  // namespace
}  // namespace boxprobe::test
