// `boxprobe report`: one HTML file by itself, whose numbers are those of bench --whole and of the pictures in it, and
// an exit status for build servers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Outcome report(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "report");
  return runProgram(arguments);
}

/// Bytes of base64 (RFC 4648).
std::string decoded(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255u);
  }
  return bytes;
}

/// Light as sRGB shows it (IEC 61966-2-1).
double encoded(double light) {
  const double v = std::min(std::max(light, 0.0), 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

/// The pictures in a page, in order.
std::vector<ImageRgba8> picturesIn(const std::string& html, const TemporaryFolder& folder) {
  std::vector<ImageRgba8> pictures;
  const std::string mark = "data:image/png;base64,";
  for (std::size_t at = 0; (at = html.find(mark, at)) != std::string::npos; ++at) {
    pictures.push_back(loadImage8(folder.write("picture.png", decoded(html.substr(at + mark.size())))));
  }
  return pictures;
}

TEST(Report, IsOneFileThatShowsWhatRenderDrawsAndWhatBenchMeasures) {
  const TemporaryFolder folder;
  const std::string page = folder.path("report.html"), drawn = folder.path("drawn.exr"), bench = folder.path("bench");
  const std::vector<std::string> same = {"--camera", "main",       "--size", "64x36",
                                         "--set",    "exposure=1", "--set",  "tone=none"};
  std::vector<std::string> arguments = {demoScene("room"), "-o", page, "--rays", "512", "--json", "--quiet"};
  arguments.insert(arguments.end(), same.begin(), same.end());
  const Outcome outcome = report(arguments);
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  const json measured = json::parse(outcome.out);
  ASSERT_EQ(measured["rows"].size(), 1u);
  EXPECT_EQ(measured["passed"], true);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"report.html"});

  const Outcome whole = runProgram(
      {"bench", demoScene("room"), "--whole", "--camera", "main", "--size", "64x36", "-o", bench, "--json", "--quiet"});
  ASSERT_EQ(whole.exitStatus, 0) << whole.err;
  EXPECT_EQ(measured["rows"][0]["parts"], json::parse(whole.out)["rows"][0]["parts"]);

  const std::string html = readFile(page);
  const double error = measured["rows"][0]["parts"][0]["relativeRmse"];
  char number[32];
  std::snprintf(number, sizeof number, "Relative RMSE %.3f", error);
  EXPECT_THAT(html, AllOf(HasSubstr(number), HasSubstr("fits: mean error"), HasSubstr("Capture origin"),
                          HasSubstr("boxprobe report "), HasSubstr("512 paths per pixel")));
  const std::size_t policy = html.find("http-equiv=\"Content-Security-Policy\"");
  ASSERT_NE(policy, std::string::npos);
  EXPECT_THAT(std::string(html).erase(policy, 4),
              AllOf(Not(HasSubstr("http")), Not(HasSubstr("<link")), Not(HasSubstr("@import"))));

  const std::vector<ImageRgba8> pictures = picturesIn(html, folder);
  ASSERT_EQ(pictures.size(), 3u) << "drawn, traced, error map";
  std::vector<std::string> render = {"render", demoScene("room"), "-o", drawn, "--samples", "16", "--quiet"};
  render.insert(render.end(), same.begin(), same.end());
  ASSERT_EQ(runProgram(render).exitStatus, 0);
  const ImageRgbaF expected = loadHdrImage(drawn);
  double off = 0.0, differs = 0.0;
  std::array<double, 2> map{}, mapped{};  // where both pictures are alike, and where they differ
  for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    off = std::max(off, std::abs(pictures[0].pixels[i] - 255.0 * encoded(expected.pixels[i])));
    differs += std::abs(pictures[0].pixels[i] - pictures[1].pixels[i]);
  }
  for (std::size_t i = 0; i + 3 < expected.pixels.size(); i += 4) {
    int most = 0, bright = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      most = std::max(most, std::abs(pictures[0].pixels[c] - pictures[1].pixels[c]));
      bright += pictures[2].pixels[c];
    }
    if (most > 2 && most < 60) continue;
    map[most > 2 ? 1 : 0] += bright;
    mapped[most > 2 ? 1 : 0] += 1.0;
  }
  const auto bytes = static_cast<double>(expected.pixels.size());
  EXPECT_LT(off, 1.01);
  EXPECT_GT(differs / bytes, 1.0);
  ASSERT_GT(mapped[0], 10.0);
  ASSERT_GT(mapped[1], 10.0);
  EXPECT_GT(map[1] / mapped[1], 3.0 * map[0] / mapped[0]) << "the error map is bright where the pictures differ";
}

TEST(Report, SharesMakeThePageOfOneProcess) {
  const TemporaryFolder folder;
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        demoScene("room"), "-o", folder.path("page.html"), "--camera", "main", "--size", "64x36", "--rays", "8"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments);
  };
  ASSERT_EQ(run({"--quiet"}).exitStatus, 0);
  std::string whole = readFile(folder.path("page.html"));
  // 36 rows are three bands, and the room has one probe; the third share, killed, has kept nothing.
  EXPECT_THAT(run({"--shard", "1/3"}).out, HasSubstr("share 1 of 3: 2 result(s) kept"));
  EXPECT_THAT(run({"--shard", "2/3"}).out, HasSubstr("share 2 of 3: 1 result(s) kept"));
  EXPECT_THAT(run({"--shard", "2/3"}).out, HasSubstr("share 2 of 3: 0 result(s) kept"));
  EXPECT_EQ(readFile(folder.path("page.html")), whole) << "shares write no page";
  const Outcome merged = run({"--merge", "--quiet"});
  ASSERT_EQ(merged.exitStatus, 0) << merged.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{"page.html"});
  // Seconds are of the process that captured.
  const std::size_t from = whole.find(" faces captured and filtered") + 28, to = whole.find(" of CPU time", from) + 12;
  ASSERT_LT(to - from, 24u);
  EXPECT_EQ(readFile(folder.path("page.html")), whole.erase(from, to - from));
}

TEST(Report, FailsAboveALimitWithTheFileWritten) {
  const TemporaryFolder folder;
  const std::string page = folder.path("report.htm");
  const auto with = [&](const char* limit) {
    return report({demoScene("room"), "-o", page, "--camera", "B", "--camera", "A", "--size", "32x18", "--rays", "16",
                   "--fail-above", limit});
  };
  const Outcome above = with("0.3");  // A is off by .8, B by .2
  EXPECT_EQ(above.exitStatus, 1);
  EXPECT_THAT(above.err, AllOf(HasSubstr("above --fail-above 0.3: room/A 0."), Not(HasSubstr("room/B"))));
  EXPECT_THAT(readFile(page), HasSubstr("Failed: the error of 1 of 2 cameras is above 0.3."));
  const Outcome below = with("5");
  EXPECT_EQ(below.exitStatus, 0) << below.err;
  EXPECT_THAT(readFile(page), HasSubstr("Passed: no camera's error is above 5."));
}

TEST(Report, SaysWhereNoiseHidesTheError) {
  const TemporaryFolder folder;
  const std::string page = folder.path("report.html");
  const Outcome outcome =
      report({demoScene("building"), "-o", page, "--camera", "main", "--size", "160x90", "--rays", "8"});
  EXPECT_EQ(outcome.exitStatus, 0);
  EXPECT_THAT(outcome.err, HasSubstr("building, camera main: the traced picture's noise is larger than the error"));
  EXPECT_THAT(readFile(page), HasSubstr("the noise hides the error"));
}

TEST(Report, NamesFromFilesAreTextAndNoMarkup) {
  const TemporaryFolder folder;
  const std::string page = folder.path("report.html");
  const Outcome outcome = report({demoScene("room"), "-o", page, "--quiet", "--size", "8x8", "--rays", "8", "--set",
                                  R"(probes.room.name="<img src=x onerror=alert(1)>&\"'")", "--camera", "main"});
  ASSERT_EQ(outcome.exitStatus, 0) << outcome.err;
  EXPECT_THAT(readFile(page),
              AllOf(Not(HasSubstr("<img src=x")), HasSubstr("&lt;img src=x onerror=alert(1)&gt;&amp;")));
}

TEST(Report, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string page = folder.path("report.html");
  const auto refused = [&](const std::vector<std::string>& arguments, const char* text) {
    std::vector<std::string> all = {"report"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = runProgram(all, DisplayKind::Unset);
    EXPECT_EQ(outcome.exitStatus, 2) << text;
    EXPECT_EQ(outcome.errLines().size(), 1u) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(text));
    EXPECT_TRUE(folder.names().empty()) << text;
  };
  refused({demoScene("room")}, "--output is required");
  refused({"-o", page}, "SCENE is required");
  refused({demoScene("room"), "-o", folder.path("report.pdf")}, "report.pdf");
  refused({demoScene("room"), "-o", "/nowhere/report.html"}, "/nowhere");
  refused({demoScene("room"), "no-such.boxprobe.json", "-o", page}, "no-such.boxprobe.json: no such file");
  refused({demoScene("room"), "-o", page, "--camera", "attic"}, "--camera attic: no camera of that name");
  refused({demoScene("room"), "-o", page, "--technique", "magic"}, "--technique magic: no such technique");
  refused({demoScene("room"), "-o", page, "--size", "0x9"}, "--size 0x9");
  refused({demoScene("room"), "-o", page, "--rays", "7"}, "--rays");
  for (const char* limit : {"nan", "-1", "0,2", "inf", "low", ""}) {
    refused({demoScene("room"), "-o", page, "--fail-above", limit}, "--fail-above");
  }
}

}  // namespace
}  // namespace boxprobe::test
