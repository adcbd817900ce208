#pragma once
/// Checks on the target: a few lines instead of a framework that would not fit.

#include <cstdint>

#include <board.hpp>

#include <hal/text.hpp>

namespace axial::apps {

/// Prints what fails and counts it.
class Checks {
 public:
  void that(bool holds, const char* claim) {
    ++made_;
    if (holds) return;
    ++failed_;
    say("FAILED ", claim);
  }

  void equal(std::uint32_t value, std::uint32_t expected, const char* claim) {
    that(value == expected, claim);
    if (value == expected) return;
    say("  expected ", hal::decimal(expected).text);
    say("  found    ", hal::decimal(value).text);
  }

  std::uint32_t made() const { return made_; }
  std::uint32_t failed() const { return failed_; }

 private:
  static void say(const char* head, const char* text) {
    hal::Board::print(head);
    hal::Board::print(text);
    hal::Board::print("\n");
  }

  std::uint32_t made_ = 0, failed_ = 0;
};

void check_instruments(Checks&);
void check_arithmetic(Checks&);
void check_integers(Checks&);
void check_memory(Checks&);
void check_link(Checks&);

}  // namespace axial::apps
