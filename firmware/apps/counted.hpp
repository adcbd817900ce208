#pragma once
/// What images that count their own code print: a line of name, robot, hash and numbers.

#include <cstdint>

#include <board.hpp>
#include <robot.hpp>

#include <hal/text.hpp>

namespace axial::apps {

/// Instructions that a piece of code takes here.
struct Counter {
  template <class Code>
  [[gnu::noinline]] std::uint32_t operator()(Code& code) const {
    return hal::Board::count(code);
  }
};

/// 64 bits in hexadecimal.
inline void print_hash(std::uint64_t hash) {
  for (const int shift : {32, 0})
    hal::Board::print(hal::hex(static_cast<std::uint32_t>(hash >> shift)).text);
}
/// The line's beginning: its name, the robot's, a hash.
inline void print_line(const char* name, std::uint64_t hash) {
  for (const char* text : {name, ",", Robot::name, ","})
    hal::Board::print(text);
  print_hash(hash);
}
/// A number behind a comma.
inline void print_number(std::uint32_t number) { hal::Board::print(","), hal::Board::print(hal::decimal(number).text); }

}  // namespace axial::apps
