// The arm of a board's image on this host, in double by four steps a tick: what a robot's Mechanics add included.
#pragma once

#include <firmware/apps/plant/arm.hpp>
#include <host_sim/plants/loop/loop.hpp>
#include <host_sim/plants/two_boards/encoded.hpp>

#include <stdexcept>
#include <utility>
#include <vector>

namespace host_sim::two_boards {

/// Of R's joints which slide, or are drives that joints share: their encoders count numbers.
template <class R>
std::vector<bool> slides_of() {
  std::vector<bool> all;
  for (int i = 0; i < axial::joint_count<R>; ++i)
    all.push_back(axial::scene_of<R>::Robot::chain.links[i].type == axial::JointType::prismatic);
  return all;
}

template <class R>
class SameSourceArm : public loop::Arm {
 public:
  SameSourceArm(const SetPoint& start, Tool tool)
      : tool_(std::move(tool)), counted_(start.q, slides_of<R>(), placed(start)) {}
  link::Measurement read() override { return measurement_of(seen()); }
  void run(const link::Torque& answer) override {
    arm_.pass(1), arm_.load(answer), arm_.compute(), arm_.settle(answer);
    counted_.follow(seen());
  }
  void carry(const link::ArmLoad& load) {
    if (!arm_.carry(load)) throw std::runtime_error("the arm on this host does not take such a load");
  }
  loop::JointState state() const override { return counted_.state(); }
  axial::Vec3<double> tool(const std::vector<double>& q) const override { return tool_(q); }

 private:
  link::Encoders placed(const SetPoint& start) {
    arm_.choose(link::Mode::lock_step, 1000);
    arm_.command(command_of(link::ArmAction::place, start.q));
    return seen();
  }
  link::Encoders seen() const {
    link::Encoders seen{};
    arm_.store(seen);
    return seen;
  }

  axial::apps::plant::Arm<R, double, 4> arm_;
  Tool tool_;
  Counted counted_;
};

}  // namespace host_sim::two_boards
