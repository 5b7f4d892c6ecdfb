// What a page of ours lets in: the hash by published values, the policy by pages that are made here. Whether a browser
// takes it so, tests/outside/page asks.
#include "app/web/page_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/web/base64.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string hex(const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += "0123456789abcdef"[value >> 4];
    text += "0123456789abcdef"[value & 15];
  }
  return text;
}

TEST(PagePolicy, TheHashIsThePublishedOne) {  // FIPS 180-4's own examples
  EXPECT_EQ(hex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hex(sha256(std::string(1000000, 'a'))), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

std::string hashOf(const std::string& text) {
  return "'sha256-" + base64(sha256(text)) + "'";
}

TEST(PagePolicy, LetsInWhatStandsInThePage) {
  const std::string head = "<html><head><meta charset=\"utf-8\">";
  const std::string rest =
      "<style>\nb{}</style></head><body><script type=\"application/json\">[1]</script>"
      "<script>\none();</script><script>two();</script></body></html>";
  const std::string page = withPolicy(head + rest, {"", "", "img-src data:; "});
  EXPECT_EQ(page, head + "\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src " +
                      hashOf("\none();") + " " + hashOf("two();") + "; style-src-elem " + hashOf("\nb{}") +
                      "; img-src data:; base-uri 'none'; form-action 'none'\">" + rest);
  EXPECT_THAT(page, Not(HasSubstr(hashOf("[1]"))));
}

TEST(PagePolicy, WhatLiesBesideItIsNamed) {
  const std::string page = withPolicy("<meta charset=\"utf-8\"><p>", {" 'self'", "", "connect-src 'self'; "});
  EXPECT_EQ(page,
            "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
            "script-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'\"><p>");
}

}  // namespace
}  // namespace boxprobe
