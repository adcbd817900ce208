#pragma once
/// Asks all calls; a line of text for each that answered wrongly, or never.

#include <hal/text.hpp>

#include "calls.hpp"

namespace axial::apps {

/// Defines this program's C functions: in one source, in the global namespace.
#define AXIAL_HOSTED_IN_C                            \
  AXIAL_C_EXPORT(hosted, axial::apps::Hosted, float) \
  AXIAL_C_EXPORT_DERIVATIVES(hosted, axial::apps::Hosted, float)

/// How often a call answered wrongly in so many states; `print` takes pieces of text.
template <class Print>
std::uint32_t ask(const Call& call, const char* numbers, std::uint32_t states, const Print& print) {
  Draw draw;
  std::uint32_t right = 0, wrong = 0;
  for (std::uint32_t k = 0; k < states; ++k) {
    draw.next();
    const Verdict verdict = call.run(draw);
    right += verdict == Verdict::right, wrong += verdict == Verdict::wrong;
  }
  const bool tests_nothing = right < states / 8;
  if (wrong != 0 || tests_nothing) {
    for (const char* text : {call.name, " in ", numbers, ": ok and wrong "})
      print(text);
    print(hal::decimal(wrong).text), print(", right "), print(hal::decimal(right).text), print("\n");
  }
  return wrong + tests_nothing;
}

/// How many calls there were, and how many of them answered wrongly.
struct Asked {
  std::uint32_t calls = 0, wrong = 0;
};
template <class Print>
Asked ask_all(std::uint32_t states, const Print& print) {
  Asked all;
  const auto each = [&](const auto& calls, const char* numbers) {
    for (const Call& call : calls)
      ++all.calls, all.wrong += ask(call, numbers, states, print) != 0;
  };
  each(hostile_calls<float>, "float");
  each(hostile_calls<double>, "double");
  each(hostile_calls_from_c, "float");
  return all;
}

}  // namespace axial::apps
