// Every public call with a status, asked of hostile numbers on the host: hostile_calls STATES.
#include <firmware/apps/hostile/run.hpp>

#include <cstdio>
#include <cstdlib>

AXIAL_HOSTED_IN_C

int main(int count, char** arguments) {
  const auto states = count > 1 ? static_cast<std::uint32_t>(std::atoi(arguments[1])) : 100000u;
  const auto asked = axial::apps::ask_all(states, [](const char* text) { std::fputs(text, stdout); });
  std::printf("%u calls, %u wrong\n", static_cast<unsigned>(asked.calls), static_cast<unsigned>(asked.wrong));
  return asked.wrong == 0 ? 0 : 1;
}
