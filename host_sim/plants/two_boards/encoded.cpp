#include <host_sim/plants/two_boards/encoded.hpp>

#include <firmware/apps/tracking/encoders.hpp>

#include <algorithm>
#include <utility>

namespace host_sim::two_boards {

namespace {
constexpr double rad_a_count = 6.283185307179586477 / 4294967296.0, metre_a_count = 1.0 / axial::apps::slide_counts;
}

link::Measurement measurement_of(const link::Encoders& encoders) {
  return {encoders.joints, encoders.position, static_cast<std::uint8_t>(link::FeedForward::full)};
}

link::ArmCommand command_of(link::ArmAction action, const std::vector<double>& values) {
  link::ArmCommand command{values.size(), {}, static_cast<std::uint8_t>(action)};
  std::transform(values.begin(), values.end(), command.values.begin(), [](double x) { return static_cast<float>(x); });
  return command;
}

Counted::Counted(std::vector<double> start, std::vector<bool> slides, const link::Encoders& seen)
    : turned_(std::move(start)), slides_(std::move(slides)), seen_(seen) {}

void Counted::follow(const link::Encoders& seen) {
  for (std::size_t i = 0; i < turned_.size(); ++i) {
    const auto counts = static_cast<std::int32_t>(static_cast<std::uint32_t>(seen.position[i]) -
                                                  static_cast<std::uint32_t>(seen_.position[i]));
    turned_[i] = slides_[i] ? seen.position[i] * metre_a_count : turned_[i] + counts * rad_a_count;
  }
  seen_ = seen;
}

loop::JointState Counted::state() const {
  loop::JointState state{turned_, {}};
  for (std::size_t i = 0; i < turned_.size(); ++i)
    state.qd.push_back(static_cast<double>(seen_.speed[i]));
  return state;
}

}  // namespace host_sim::two_boards
