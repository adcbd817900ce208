#include <axial/control/payload_estimator.hpp>
#include <host_sim/collide/arm.hpp>
#include <host_sim/collide/payload.hpp>
#include <host_sim/collide/robot.hpp>
#include <robots/puma560.hpp>

namespace host_sim::collide {
namespace {

struct Tuning {
  static constexpr double period = collide::period, gain = 50.0;
  static constexpr double deviation = 0.01, memory = 60.0, mass_deviation = 0.05, moment_deviation = 0.02;
};

// The observer's lag is in what it is compared with, too: any gain does.
template <class Known, class Moving, class KnownScene, class MovingScene>
PayloadRow weighed(double seconds, double mass, const axial::Vec3<double>& com, unsigned seed) {
  Arm<Known, Moving, KnownScene, MovingScene> arm(seed, 0.4);
  axial::ObserverState<KnownScene, float, Tuning> observer;
  axial::PayloadState<KnownScene, float> load;
  axial::Inputs<MovingScene, double> in;
  in.payload = {mass, com, {0.002 * mass, 0.002 * mass, 0.002 * mass, 0.0, 0.0, 0.0}};
  PayloadRow row;
  row.robot = Known::name, row.seconds = seconds, row.mass = mass;
  for (long k = 0, ticks = std::lround(seconds / period); k < ticks; ++k) {
    const auto& m = arm.measure();
    axial::Joints<Known, float> q{}, qd{}, tau{};
    for (int i = 0; i < Known::chain.size; ++i)
      q[i] = float(m.q[i]), qd[i] = float(m.qd[i]), tau[i] = float(m.tau[i]);
    if (!axial::observe(observer, q, qd, tau).ok() ||
        !axial::update_payload<KnownScene, float, Tuning>(load, q, qd, observer.residual).ok())
      ++row.refused, observer.ready = load.ready = false;
    if (row.ready == 0.0 && axial::estimate<Tuning>(load).status.ok()) row.ready = static_cast<double>(k) * period;
    arm.move({}, in);
  }
  const auto found = axial::estimate<Tuning>(load);
  row.sure = found.status.ok();
  const auto& h = found.first_moment;
  const double x = double(h.x) - mass * com.x, y = double(h.y) - mass * com.y, z = double(h.z) - mass * com.z;
  row.mass_error = double(found.mass) - mass, row.moment_error = std::sqrt(x * x + y * y + z * z);
  row.mass_deviation = std::sqrt(double(found.variance[0]));
  return row;
}

struct MovingPuma : robots::Puma560 {
  static constexpr auto chain = [] {
    auto c = robots::Puma560::chain;
    for (int i = 0; i < c.size; ++i)
      c.links[i].mass *= i % 2 == 0 ? 1.01 : 0.99;
    return c;
  }();
};

}  // namespace

std::vector<PayloadRow> weigh(double seconds, unsigned seed) {
  using axial::Friction, axial::Gravity, axial::Payload, axial::RotorInertia, axial::Scene;
  using robots::Puma560;
  std::vector<PayloadRow> rows;
  for (const double mass : {0.5, 1.0, 2.0, 3.0})
    rows.push_back(weighed<Known, Moving, Scene<Known, Gravity, Friction>, Scene<Moving, Gravity, Friction, Payload>>(
        seconds, mass, {0.05, -0.03, 0.15}, seed));
  for (const double mass : {0.5, 1.0, 2.0})
    rows.push_back(weighed<Puma560, MovingPuma, Scene<Puma560, Gravity, RotorInertia>,
                           Scene<MovingPuma, Gravity, RotorInertia, Payload>>(seconds, mass, {0.05, -0.03, 0.1}, seed));
  return rows;
}

}  // namespace host_sim::collide
