#pragma once
/// Clocks, resets and pins of an RP2040 or an RP2350 out of reset, whose parts may be broken. `everything`: all blocks
/// of the part in reset.

#include "stores.hpp"

namespace axial::hal {

constexpr std::uint32_t rp_crystal_on = 0xFABAA0, rp_top_bit = 1u << 31;

template <std::uint32_t everything>
struct PlayedResets {
  bool works = true;
  Noted reset{"reset", everything};
  Noted done{"done", 0, [this](std::uint32_t) { return works ? everything & ~reset.written : 0u; }};
};

struct PlayedGenerator {
  Noted control;
  bool works = true;
  Noted selected{"selected", 0, [this](std::uint32_t) { return works ? 1u << control.written : 0u; }};
};

/// What both parts have of what clock::start asks for.
template <std::uint32_t everything>
struct PlayedClocks {
  bool crystal_works = true, pll_works = true;
  struct {
    Noted control{"crystal"}, start_up{"start up"}, status{"status"};
  } crystal;
  struct {
    Noted control{"pll"}, power{"power"}, feedback{"feedback"}, post_dividers{"post dividers"};
  } pll;
  struct {
    PlayedGenerator reference{{"reference"}}, system{{"system"}}, peripheral{{"peripheral"}};
  } clocks;
  PlayedResets<everything> resets;

  PlayedClocks() {
    crystal.status.answer = [this](std::uint32_t) {
      return crystal_works && crystal.control.written == rp_crystal_on ? rp_top_bit : 0u;
    };
    pll.control.answer = [this](std::uint32_t value) { return value | (pll_works ? rp_top_bit : 0u); };
  }
};

struct PlayedPort {
  Noted output_set{"set"}, output_clear{"clear"}, drive_set{"drive"};
};
struct PlayedBank {
  struct {
    Noted control;
  } pin[3]{{{"pin 0"}}, {{"pin 1"}}, {{"pin 2"}}};
};

}  // namespace axial::hal
