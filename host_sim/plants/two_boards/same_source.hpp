// The arm of a board's image on this host, in double by four steps a tick: what a robot's Mechanics add included.
#pragma once

#include <firmware/apps/plant/arm.hpp>
#include <host_sim/plants/loop/loop.hpp>
#include <host_sim/plants/two_boards/board_arm.hpp>

#include <utility>

namespace host_sim::two_boards {

template <class R>
class SameSourceArm : public loop::Arm {
 public:
  SameSourceArm(const SetPoint& start, BoardArm::Tool tool) : tool_(std::move(tool)) {
    arm_.choose(link::Mode::lock_step, 1000);
    arm_.command(command_of(link::ArmAction::place, start.q));
  }
  link::Measurement read() override {
    link::Encoders seen{};
    arm_.store(seen);
    return measurement_of(seen);
  }
  void run(const link::Torque& answer) override {
    arm_.pass(1), arm_.load(answer), arm_.compute(), arm_.settle(answer);
  }
  loop::JointState state() const override {
    const auto& x = arm_.state();
    constexpr int n = R::chain.size;
    return {{x.q.values, x.q.values + n}, {x.qd.values, x.qd.values + n}};
  }
  axial::Vec3<double> tool(const std::vector<double>& q) const override { return tool_(q); }

 private:
  axial::apps::plant::Arm<R, double, 4> arm_;
  BoardArm::Tool tool_;
};

}  // namespace host_sim::two_boards
