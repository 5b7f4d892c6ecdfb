#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>

#include "filters/core/base/errors.h"

namespace boxprobe {
namespace {

TEST(Errors, ExceptionsOfTheLanguageAreSaidInWords) {
  EXPECT_EQ(messageOf(InputError("a.glb: damaged")), "a.glb: damaged");
  EXPECT_EQ(messageOf(std::runtime_error("x")), "x");
  EXPECT_EQ(messageOf(std::bad_alloc()), kOutOfMemory);
  EXPECT_EQ(messageOf(std::bad_array_new_length()), kOutOfMemory);
  const std::system_error thread(std::make_error_code(std::errc::resource_unavailable_try_again));
  EXPECT_NE(messageOf(thread).find("ulimit"), std::string::npos);
}

TEST(Errors, MemoryThatDoesNotSufficeNamesTheFile) {
  EXPECT_EQ(withMemoryFor("a.glb", [] { return 7; }), 7);
  try {
    withMemoryFor("b.glb", [] { withMemoryFor("a.glb", [] { throw std::bad_alloc(); }); });
    FAIL() << "nothing thrown";
  } catch (const WorkError& error) {
    EXPECT_EQ(std::string(error.what()), std::string("a.glb: ") + kOutOfMemory) << "the inner file";
  }
  const auto failing = [](std::errc code) {
    return [code] { withMemoryFor("c.glb", [code] { throw std::system_error(std::make_error_code(code)); }); };
  };
  try {
    failing(std::errc::resource_unavailable_try_again)();
    FAIL() << "nothing thrown";
  } catch (const WorkError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("c.glb: the system gives no more threads", 0), 0u) << error.what();
  }
  EXPECT_THROW(failing(std::errc::io_error)(), std::system_error);
  EXPECT_THROW(withMemoryFor("a.glb", [] { throw InputError("a.glb: damaged"); }), InputError);
}

}  // namespace
}  // namespace boxprobe
