// Emulated boards on lines: one that computes torques, one that stands in for the arm.
#pragma once

#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/boards/link/firmware.hpp>
#include <host_sim/plants/loop/loop.hpp>
#include <host_sim/plants/two_boards/faulty_line.hpp>

#include <functional>
#include <string>

namespace host_sim::two_boards {

/// An image that runs on an emulated board, and who speaks with it. Throws std::runtime_error with the board's words.
class BoardOnLine {
 public:
  BoardOnLine(const std::string& board, const std::string& app, const std::string& robot)
      : board_(read_board(board)),
        emulator_(board_, image_path(board_, app, robot)),
        line(emulator_.serial()),
        firmware(line) {}

  std::string console() const { return emulator_.console(); }

 private:
  Board board_;
  Emulator emulator_;

 public:
  FaultyLine line;
  Firmware firmware;
};

/// The controller's board, in lock-step.
class BoardController : public loop::Controller {
 public:
  explicit BoardController(BoardOnLine& board) : board_(board) {}
  link::Torque answer(const link::Measurement& measurement, const link::SetPoint& wanted) override {
    return board_.firmware.torque(measurement, wanted);
  }

 private:
  BoardOnLine& board_;
};

/// What encoders say, as a controller is told it.
link::Measurement measurement_of(const link::Encoders& encoders);
/// Joint values at rest, as float.
link::ArmCommand command_of(link::ArmAction action, const std::vector<double>& values);

/// The arm's board, in lock-step. Its positions are those of its encoders.
class BoardArm : public loop::Arm {
 public:
  using Tool = std::function<axial::Vec3<double>(const std::vector<double>&)>;

  /// Placed at rest at `start`; `slides`: which joints do.
  BoardArm(BoardOnLine& board, const SetPoint& start, std::vector<bool> slides, Tool tool);

  link::Measurement read() override { return measurement_of(seen_); }
  void run(const link::Torque& answer) override;
  loop::JointState state() const override;
  axial::Vec3<double> tool(const std::vector<double>& q) const override { return tool_(q); }
  /// Instructions of the dearest tick so far.
  std::uint32_t most() const { return most_; }
  /// Ticks that were answered with anything but ok.
  long told() const { return told_; }

 private:
  BoardOnLine& board_;
  std::vector<bool> slides_;
  Tool tool_;
  link::Encoders seen_;
  std::vector<double> turned_;  // rad or m, counted over all turns
  std::uint32_t most_ = 0;
  long told_ = 0;
};

}  // namespace host_sim::two_boards
