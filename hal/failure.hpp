#pragma once
/// What happens when nothing can be trusted any more, in this order: drives off, reason noted, restart.

#include <hal/fault_report.hpp>

namespace axial::hal {

/// `Board` gives enable_drives(on), describe(report) and restart(); `kept` is where the next start looks for a report.
/// The drives come first: whatever else is broken, storing or printing the report included, they are off by then.
template <class Board>
void give_up(const FaultReport& report, FaultReport& kept) {
  Board::enable_drives(false);
  kept = report;
  seal(kept, FaultReport::fresh);
  Board::describe(report);
  Board::restart();
}

}  // namespace axial::hal
