// Numbers as boards print them, beside those of the C library.
#include <firmware/apps/run/decimal.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace axial::apps::run {
namespace {

TEST(Decimal, IsWhatPrintfMakesOfIt) {
  for (const double magnitude : {0.0, 1e-9, 4e-10, 0.25, 0.5, 0.999999999, 1.0, 1.5, 9.0, 10.0, 12345.678901234, 8.9e9})
    for (const double value : {magnitude, -magnitude}) {
      char text[40];
      std::snprintf(text, sizeof text, "%.9f", value == 0.0 ? 0.0 : value);
      EXPECT_EQ(decimal(value).text, std::string(text)) << value;
    }
}

TEST(Decimal, SaysWhatIsOutOfRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {9e9, -9e9, infinity, -infinity, std::nan("")})
    EXPECT_STREQ(decimal(value).text, "out of range");
}

}  // namespace
}  // namespace axial::apps::run
