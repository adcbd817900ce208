#pragma once
/// A number as text with nine decimals, without printf.

#include <cstdint>

namespace axial::apps::run {

struct Decimal {
  char text[24];
};

/// Nearest to value; "out of range" where |value| is 9e9 or more, or NaN.
constexpr Decimal decimal(double value) {
  constexpr std::uint32_t billion = 1000000000u;
  if (!(value > -9e9 && value < 9e9)) return {"out of range"};
  const bool negative = value < 0.0;
  auto rest = static_cast<std::uint64_t>((negative ? -value : value) * billion + 0.5);
  Decimal reversed{}, out{};
  int length = 0;
  for (int digits = 0; digits < 10 || rest != 0; ++digits) {
    if (digits == 9) reversed.text[length++] = '.';
    reversed.text[length++] = static_cast<char>('0' + rest % 10u);
    rest /= 10u;
  }
  if (negative) reversed.text[length++] = '-';
  for (int i = 0; i < length; ++i)
    out.text[i] = reversed.text[length - 1 - i];
  return out;
}

}  // namespace axial::apps::run
