/// The integer primitives' part of the self-test alone, for builds that choose other ones.

#include "verdict.hpp"

int main() {
  using namespace axial::apps;
  Board::start();
  Checks checks;
  check_integers(checks);
  give_verdict(checks);
}
