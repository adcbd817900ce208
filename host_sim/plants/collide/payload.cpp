#include <axial/control/payload_estimator.hpp>
#include <host_sim/plants/collide/arm.hpp>
#include <host_sim/plants/collide/payload.hpp>
#include <host_sim/plants/collide/robot.hpp>
#include <robots/puma560.hpp>

namespace host_sim::collide {
namespace {

struct Tuning {
  static constexpr double period = collide::period, gain = 50.0;
  static constexpr double deviation = 0.01, memory = 60.0, mass_deviation = 0.05, moment_deviation = 0.02;
};

// One arm's estimator. The observer's lag is in what it is compared with, too: any gain does.
template <class Known, class KnownScene>
class Scales {
 public:
  Scales(double seconds, const axial::PayloadBody<double>& load) : given_(load) {
    row_.robot = Known::name, row_.seconds = seconds, row_.mass = load.mass;
  }
  void see(const Measured<Known>& m, long tick) {
    axial::Joints<Known, float> q{}, qd{}, tau{};
    for (int i = 0; i < Known::chain.size; ++i)
      q[i] = float(m.q[i]), qd[i] = float(m.qd[i]), tau[i] = float(m.tau[i]);
    if (!axial::observe(observer_, q, qd, tau).ok() ||
        !axial::update_payload<KnownScene, float, Tuning>(load_, q, qd, observer_.residual).ok())
      ++row_.refused, observer_.ready = load_.ready = false;
    if (row_.ready == 0.0 && axial::estimate<Tuning>(load_).status.ok())
      row_.ready = static_cast<double>(tick) * period;
  }
  PayloadRow row() {
    const auto found = axial::estimate<Tuning>(load_);
    row_.sure = found.status.ok();
    const auto& h = found.first_moment;
    const auto& com = given_.com;
    const double mass = given_.mass;
    const double x = double(h.x) - mass * com.x, y = double(h.y) - mass * com.y, z = double(h.z) - mass * com.z;
    row_.mass_error = double(found.mass) - mass, row_.moment_error = std::sqrt(x * x + y * y + z * z);
    row_.mass_deviation = std::sqrt(double(found.variance[0]));
    return row_;
  }

 private:
  axial::PayloadBody<double> given_;
  axial::ObserverState<KnownScene, float, Tuning> observer_;
  axial::PayloadState<KnownScene, float> load_;
  PayloadRow row_;
};

axial::PayloadBody<double> body(double mass, const axial::Vec3<double>& com) {
  return {mass, com, {0.002 * mass, 0.002 * mass, 0.002 * mass, 0.0, 0.0, 0.0}};
}

// Two payloads on two arms of one motion, at once.
template <class Known, class Moving, class KnownScene, class MovingScene>
void weigh_both(std::vector<PayloadRow>& rows, double seconds, const double (&masses)[2],
                const axial::Vec3<double>& com, unsigned seed) {
  using Mover = Arm<Known, Moving, KnownScene, MovingScene>;
  const axial::PayloadBody<double> loads[] = {body(masses[0], com), body(masses[1], com)};
  Mover arms[] = {Mover(seed, 0.4), Mover(seed, 0.4)};
  Scales<Known, KnownScene> scales[] = {{seconds, loads[0]}, {seconds, loads[1]}};
  typename Mover::Inputs in[2];
  for (int k = 0; k < 2; ++k)
    in[k].payload = loads[k];
  for (long tick = 0, ticks = std::lround(seconds / period); tick < ticks; ++tick) {
    for (int k = 0; k < 2; ++k)
      scales[k].see(arms[k].measure(), tick);
    Mover::move_both(arms, {{}, {}}, in);
  }
  for (auto& each : scales)
    rows.push_back(each.row());
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
  const auto panda = [&](const double(&masses)[2]) {
    weigh_both<Known, Moving, Scene<Known, Gravity, Friction>, Scene<Moving, Gravity, Friction, Payload>>(
        rows, seconds, masses, {0.05, -0.03, 0.15}, seed);
  };
  const auto puma = [&](const double(&masses)[2]) {
    weigh_both<Puma560, MovingPuma, Scene<Puma560, Gravity, RotorInertia>,
               Scene<MovingPuma, Gravity, RotorInertia, Payload>>(rows, seconds, masses, {0.05, -0.03, 0.1}, seed);
  };
  panda({0.5, 1.0}), panda({2.0, 3.0});
  puma({0.5, 1.0}), puma({2.0, 2.0});
  rows.pop_back();  // the odd one's lane
  return rows;
}

}  // namespace host_sim::collide
