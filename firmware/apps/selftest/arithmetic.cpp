/// Float as IEEE 754 has it: the images are compared with the host bit by bit.

#include <cstring>
#include <limits>

#include "check.hpp"

namespace axial::apps {
namespace {

/// Keeps the compiler from computing ahead.
float opaque(float value) {
  asm volatile("" : "+r"(value));
  return value;
}

std::uint32_t bits(float value) {
  std::uint32_t out = 0;
  std::memcpy(&out, &value, sizeof out);
  return out;
}

}  // namespace

void check_arithmetic(Checks& check) {
  const float third = opaque(1.0f) / opaque(3.0f);
  check.equal(bits(third), 0x3EAAAAAB, "1/3 is rounded to nearest");
  check.equal(bits(opaque(0x1.000002p0f) * opaque(0x1.000002p0f)), 0x3F800002, "a product is rounded to nearest, even");
  const float smallest = opaque(std::numeric_limits<float>::denorm_min());
  check.equal(bits(smallest + smallest), 2, "subnormal numbers are kept");
  const float square = opaque(0x1.000002p0f);
  // What is left of the product by rounding is 2^-46, which a fused operation keeps.
  constexpr std::uint32_t left = AXIAL_CONTRACTED ? 0x28800000 : 0;
  check.equal(bits(square * square - opaque(0x1.000004p0f)), left,
              AXIAL_CONTRACTED ? "a product and a sum are fused" : "a product is rounded before it is added");
  check.that(!(opaque(std::numeric_limits<float>::quiet_NaN()) <= 0.0f), "NaN compares as NaN");
}

}  // namespace axial::apps
