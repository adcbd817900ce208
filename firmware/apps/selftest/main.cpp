/// Tests on the target, with a verdict through semihosting. The instruments come first: if they fail, nothing else
/// runs.

#include "verdict.hpp"

namespace {

void group(axial::apps::Checks& checks, const char* name, void (*run)(axial::apps::Checks&)) {
  axial::hal::Board::print(name);
  axial::hal::Board::print("\n");
  run(checks);
}

}  // namespace

int main() {
  using namespace axial::apps;
  Board::start();
  Checks checks;
  if (Board::emulated()) {
    group(checks, "instruments", check_instruments);
  } else {
    Board::print("instruments: on silicon costs are not known in advance; left out\n");
  }
  if (checks.failed() == 0) {
    group(checks, "arithmetic", check_arithmetic);
    group(checks, "integers", check_integers);
    group(checks, "memory", check_memory);
    group(checks, "link", check_link);
  }
  give_verdict(checks);
}
