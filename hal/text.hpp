#pragma once
/// Numbers as text without printf.

#include <cstdint>

namespace axial::hal {

struct HexText {
  char text[9];
};

/// Eight hexadecimal digits.
constexpr HexText hex(std::uint32_t value) {
  HexText out{};
  for (int i = 0; i < 8; ++i)
    out.text[i] = "0123456789abcdef"[(value >> (28 - 4 * i)) & 0xFu];
  return out;
}

struct DecimalText {
  char text[11];
};

constexpr DecimalText decimal(std::uint32_t value) {
  char reversed[10]{};
  int digits = 0;
  do {
    reversed[digits++] = static_cast<char>('0' + value % 10u);
    value /= 10u;
  } while (value != 0);
  DecimalText out{};
  for (int i = 0; i < digits; ++i)
    out.text[i] = reversed[digits - 1 - i];
  return out;
}

}  // namespace axial::hal
