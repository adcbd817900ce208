#pragma once
/// Numbers as text, without printf.

#include <cstdint>

namespace axial::hal {

template <int size>
struct Text {
  char text[size + 1];
};

/// Eight hexadecimal digits.
constexpr Text<8> hex(std::uint32_t value) {
  Text<8> out{};
  for (int i = 0; i < 8; ++i)
    out.text[i] = "0123456789abcdef"[(value >> (28 - 4 * i)) & 0xFu];
  return out;
}

constexpr Text<10> decimal(std::uint32_t value) {
  char reversed[10]{};
  int digits = 0;
  do {
    reversed[digits++] = static_cast<char>('0' + value % 10u);
    value /= 10u;
  } while (value != 0);
  Text<10> out{};
  for (int i = 0; i < digits; ++i)
    out.text[i] = reversed[digits - 1 - i];
  return out;
}

}  // namespace axial::hal
