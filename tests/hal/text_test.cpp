#include <hal/text.hpp>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

TEST(Text, WritesHexadecimal) {
  EXPECT_STREQ(hex(0).text, "00000000");
  EXPECT_STREQ(hex(0xDEADBEEF).text, "deadbeef");
}

TEST(Text, WritesDecimal) {
  EXPECT_STREQ(decimal(0).text, "0");
  EXPECT_STREQ(decimal(70).text, "70");
  EXPECT_STREQ(decimal(4294967295u).text, "4294967295");
}

}  // namespace
}  // namespace axial::hal
