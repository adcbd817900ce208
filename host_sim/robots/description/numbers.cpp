#include <host_sim/robots/description/numbers.hpp>

#include <charconv>

namespace description {

std::string number(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value + 0.0);
  return {text, end.ptr};
}

std::string number(double value, int digits) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value + 0.0, std::chars_format::general, digits);
  return {text, end.ptr};
}

}  // namespace description
