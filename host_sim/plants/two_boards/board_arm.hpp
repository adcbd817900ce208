// Boards on lines: one that computes torques, one that stands in for the arm.
#pragma once

#include <host_sim/boards/emulator/qemu.hpp>
#include <host_sim/boards/link/firmware.hpp>
#include <host_sim/boards/link/serial_port.hpp>
#include <host_sim/plants/loop/loop.hpp>
#include <host_sim/plants/two_boards/encoded.hpp>
#include <host_sim/plants/two_boards/faulty_line.hpp>

#include <functional>
#include <memory>
#include <string>

namespace host_sim::two_boards {

/// An image that runs on a board, and who speaks with it: in its emulator, or at a serial port of this machine, on
/// which it has to be already. Throws std::runtime_error with the board's words.
class BoardOnLine {
 public:
  BoardOnLine(const std::string& board, const std::string& app, const std::string& robot, const std::string& port = "")
      : emulator_(port.empty() ? emulated(read_board(board), app, robot) : nullptr),
        port_(port.empty() ? nullptr : std::make_unique<SerialPort>(port)),
        line(port.empty() ? emulator_->serial() : *port_),
        firmware(line, port.empty() ? Firmware::Runs::from_now : Firmware::Runs::already) {}

  std::string console() const { return emulator_ ? emulator_->console() : ""; }

 private:
  static std::unique_ptr<Emulator> emulated(const Board& board, const std::string& app, const std::string& robot) {
    return std::make_unique<Emulator>(board, image_path(board, app, robot));
  }

  std::unique_ptr<Emulator> emulator_;
  std::unique_ptr<SerialPort> port_;

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

/// The arm's board, in lock-step. Its positions are those of its encoders.
class BoardArm : public loop::Arm {
 public:
  /// Placed at rest at `start`; `slides`: as Counted has them.
  BoardArm(BoardOnLine& board, const SetPoint& start, std::vector<bool> slides, Tool tool);

  link::Measurement read() override { return measurement_of(seen_); }
  void run(const link::Torque& answer) override;
  void carry(const link::ArmLoad& load) { seen_ = board_.firmware.carry(load); }
  loop::JointState state() const override { return counted_.state(); }
  axial::Vec3<double> tool(const std::vector<double>& q) const override { return tool_(q); }
  /// Instructions of the dearest tick so far.
  std::uint32_t most() const { return most_; }
  /// Ticks that were answered with anything but ok.
  long told() const { return told_; }

 private:
  BoardOnLine& board_;
  Tool tool_;
  link::Encoders seen_;
  Counted counted_;
  std::uint32_t most_ = 0;
  long told_ = 0;
};

}  // namespace host_sim::two_boards
