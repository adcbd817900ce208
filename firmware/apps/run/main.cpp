/// Prints time, position and torque of a smooth motion of one robot; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include "../number_systems.hpp"
#include "decimal.hpp"
#include "motion.hpp"
#include "scene.hpp"

namespace {

using namespace axial;
using apps::Robot;
using hal::Board;
using Number = AXIAL_NUMBER;
using Scene = apps::run::SceneOf<Robot, is_stored_v<Number>>;

void print(double value) {
  Board::print(",");
  Board::print(apps::run::decimal(value).text);
}

template <class Efforts>
double value(const Efforts& tau, int i) {
  if constexpr (is_stored_v<Number>)
    return static_cast<double>(tau[i].raw) * detail::power_of_two(-Efforts::exponent(i));
  else
    return static_cast<double>(tau[i]);
}

[[gnu::noinline]] auto torque(const Joints<Robot, double>& q, const Joints<Robot, double>& qd,
                              const Joints<Robot, double>& qdd) {
  return inverse_dynamics<Scene>(apps::nearest_positions<Robot, Number>(q),
                                 apps::nearest<Velocities<Robot, Number>>(qd),
                                 apps::nearest<Accelerations<Robot, Number>>(qdd));
}

void print_sample(double time) {
  Joints<Robot, double> q{}, qd{}, qdd{};
  for (int i = 0; i < joint_count<Robot>; ++i) {
    const auto motion = apps::run::motion<Robot>(i, time);
    q[i] = motion.q, qd[i] = motion.qd, qdd[i] = motion.qdd;
  }
  const auto tau = torque(q, qd, qdd);
  Board::print("torque");
  print(time);
  for (int i = 0; i < joint_count<Robot>; ++i)
    print(q[i]);
  for (int i = 0; i < joint_count<Robot>; ++i)
    print(value(tau, i));
  Board::print("\n");
}

}  // namespace

int main() {
  Board::start();
  for (const char* text : {"robot,", Robot::name, ",", Board::name, "\n"})
    Board::print(text);
  for (int k = 0; k < apps::run::samples; ++k)
    print_sample(k * apps::run::step_s);
  Board::print("end\n");
  Board::exit(0);
}
