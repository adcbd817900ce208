#include <host_sim/plants/two_boards/board_arm.hpp>

#include <algorithm>
#include <utility>

namespace host_sim::two_boards {

BoardArm::BoardArm(BoardOnLine& board, const SetPoint& start, std::vector<bool> slides, Tool tool)
    : board_(board),
      tool_(std::move(tool)),
      seen_(board_.firmware.command(command_of(link::ArmAction::place, start.q))),
      counted_(start.q, std::move(slides), seen_) {}

void BoardArm::run(const link::Torque& answer) {
  seen_ = board_.firmware.move(answer);
  counted_.follow(seen_);
  most_ = std::max(most_, seen_.count);
  told_ += seen_.status != static_cast<std::uint8_t>(link::TorqueStatus::ok) ? 1 : 0;
}

}  // namespace host_sim::two_boards
