// What a recording shows: errors of every joint, cost, memory; and whether that is good enough.
#pragma once

#include <host_sim/boards/demo/recording.hpp>
#include <host_sim/boards/emulator/board.hpp>
#include <host_sim/tools/analysis/error_statistics.hpp>
#include <host_sim/tools/analysis/image_size.hpp>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace host_sim {

struct Summary {
  Robot robot;
  Board board;
  std::vector<ErrorStatistics> joints;
  std::vector<double> scales;  ///< what each joint's errors are relative to: joint_scales() of the largest torques
  std::string number;          ///< float or fixed32
  std::vector<double> bounds;  ///< what each joint's errors may be, N m or N
  Range counts;
  ImageSize image;
  link::Hello hello{};
  std::uint32_t stack = 0;  ///< bytes, deepest use over the run
  std::size_t set_points = 0;
  double duration = 0.0;  ///< s of motion
};

/// `number` is float or fixed32.
Summary summarise(const Recording& recording, const Robot& robot, const Board& board, const std::string& image,
                  const std::string& number);

/// An error of a joint, relative to its scale; 0 when all torques are 0.
double relative(const Summary& summary, std::size_t joint, double error);

bool within_bound(const Summary& summary);

/// The text that `./axial demo` prints.
std::string describe(const Summary& summary);

/// One object per joint, with the fields that every machine-readable `demo` has.
nlohmann::json to_json(const Summary& summary);

}  // namespace host_sim
