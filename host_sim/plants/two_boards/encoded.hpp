// What goes to an arm on the link and what its encoders say.
#pragma once

#include <host_sim/plants/loop/loop.hpp>

#include <functional>
#include <vector>

namespace host_sim::two_boards {

namespace link = axial::hal::link;

/// The tool point of positions, m.
using Tool = std::function<axial::Vec3<double>(const std::vector<double>&)>;

/// What encoders say, as a controller is told it.
link::Measurement measurement_of(const link::Encoders& encoders);
/// Joint values at rest, as float.
link::ArmCommand command_of(link::ArmAction action, const std::vector<double>& values);

/// What an arm's encoders have counted, over all turns.
class Counted {
 public:
  /// `slides`: which joints do, or are drives that joints share.
  Counted(std::vector<double> start, std::vector<bool> slides, const link::Encoders& seen);
  void follow(const link::Encoders& seen);
  /// rad or m, and per second
  loop::JointState state() const;

 private:
  std::vector<double> turned_;
  std::vector<bool> slides_;
  link::Encoders seen_;
};

}  // namespace host_sim::two_boards
