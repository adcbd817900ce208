#include <hal/failure.hpp>

#include <string>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

/// Writes down what it is asked for, and whether the report stood already.
struct Played {
  inline static std::string calls;
  inline static FaultReport kept{};

  static void note(const char* call) { calls += std::string(call) + (sound(kept) ? " (reported)\n" : "\n"); }
  static void enable_drives(bool on) { note(on ? "drives on" : "drives off"); }
  static void describe(const FaultReport&) { note("describe"); }
  static void restart() { note("restart"); }
};

TEST(Failure, TurnsTheDrivesOffBeforeAnythingElse) {
  FaultReport report{};
  report.cause = ResetCause::fault;
  report.program_counter = 0x1234;
  give_up<Played>(report, Played::kept);
  EXPECT_EQ(Played::calls, "drives off\ndescribe (reported)\nrestart (reported)\n");
  EXPECT_EQ(Played::kept.mark, FaultReport::fresh);
  EXPECT_EQ(Played::kept.cause, ResetCause::fault);
  EXPECT_EQ(Played::kept.program_counter, 0x1234u);
}

}  // namespace
}  // namespace axial::hal
