#include <axial/control/collision.hpp>
#include <axial/fixed.hpp>
#include <host_sim/plants/collide/arm.hpp>
#include <host_sim/plants/collide/collide.hpp>
#include <host_sim/plants/collide/robot.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <stdexcept>

namespace host_sim::collide {
namespace {

using KnownScene = axial::Scene<Known, axial::Gravity, axial::Friction>;
using MovingScene = axial::Scene<Moving, axial::Gravity, axial::Friction>;
using Panda = Arm<Known, Moving, KnownScene, MovingScene>;
using Values = Panda::Values;
constexpr int joints = Panda::joints;

// Thresholds of 2.08 N m (arm) and 0.36 N m (wrist).
struct Tuning {
  static constexpr double period = collide::period, gain = 200.0;
  static constexpr double fraction = 0.023, uncertainty = 0.08, release = 0.5;
  static constexpr int confirm = 2, calm = 20;
};

constexpr double step = 0.05;                                          // of the joint's effort limit
constexpr long spacing = 1500, lasts = 200, fades = 200, first = 500;  // ticks

template <class T>
class Sensor {
 public:
  axial::Status sample(const Measured<Known>& m) {
    if constexpr (axial::is_stored_v<T>) {
      return axial::observe(state_, axial::to_fixed<axial::Positions<Known, T>>(m.q).values,
                            axial::to_fixed<axial::Velocities<Known, T>>(m.qd).values,
                            axial::to_fixed<axial::EffortsOf<KnownScene, T>>(m.tau).values);
    } else {
      axial::Joints<Known, T> q{}, qd{}, tau{};
      for (int i = 0; i < joints; ++i)
        q[i] = T(m.q[i]), qd[i] = T(m.qd[i]), tau[i] = T(m.tau[i]);
      return axial::observe(state_, q, qd, tau);
    }
  }
  bool collision() { return axial::detect(detector_, state_.residual).detected; }
  double residual(int i) const { return real(state_.residual[i], i); }
  static double threshold(int i) { return real(axial::collision_thresholds_of<KnownScene, T, Tuning>.enter[i], i); }

 private:
  static double real(const T& x, int i) {
    if constexpr (axial::is_stored_v<T>)
      return x.raw * axial::detail::power_of_two(-axial::Residuals<KnownScene, T, Tuning>::exponent(i));
    else
      return static_cast<void>(i), static_cast<double>(x);
  }

  axial::ObserverState<KnownScene, T, Tuning> state_{};
  axial::CollisionState detector_{};
};

// A contact every 1.5 s on the joints in turn, forwards and backwards.
struct Contact {
  long number = -1, age = 0;  // ticks since it began
  explicit Contact(long tick) {
    if (tick >= first) number = (tick - first) / spacing, age = (tick - first) % spacing;
  }
  bool on() const { return number >= 0 && age < lasts; }
  bool echoes() const { return number >= 0 && age < lasts + fades; }
  Values external() const {
    Values x{};
    const int joint = static_cast<int>(number % joints);
    if (on()) x[joint] = (number / joints % 2 == 0 ? step : -step) * Known::chain.links[joint].effort_limit;
    return x;
  }
};

template <class T>
void see_quiet(Row& row, Sensor<T>& sensor, const Measured<Known>& measured, bool& before) {
  row.refused += sensor.sample(measured).ok() ? 0 : 1;
  const bool now = sensor.collision();
  row.false_alarms += now && !before ? 1 : 0, before = now;
  for (int i = 0; i < joints; ++i)
    note_size(row.headroom, sensor.residual(i) / Sensor<T>::threshold(i));
}

template <class T>
Instant instant(const Sensor<T>& sensor, const Values& external, long tick, bool detected) {
  Instant now;
  now.time = static_cast<double>(tick) * period, now.detected = detected;
  for (int i = 0; i < joints; ++i)
    now.external[i] = external[i], now.residual[i] = sensor.residual(i), now.threshold[i] = Sensor<T>::threshold(i);
  return now;
}

template <class T>
struct Touched {
  Sensor<T> sensor{};
  bool before = false, found = false, now = false;

  void see(Row& row, const Measured<Known>& measured, const Contact& contact) {
    row.refused += sensor.sample(measured).ok() ? 0 : 1;
    now = sensor.collision();
    if (contact.number >= 0 && contact.age == 0) ++row.contacts, found = false;
    row.false_alarms += now && !before && (!contact.echoes() || contact.age == 0) ? 1 : 0, before = now;
    if (contact.on() && contact.age > 0 && now && !found)
      found = true, row.delays.push_back(static_cast<double>(contact.age) * period);
    if (contact.number >= 0 && contact.age == lasts && !found) ++row.missed;
  }
};

// Two arms at once, one of which nothing touches.
template <class T>
Row both(const std::string& scalar, double seconds, unsigned seed, const Watch& watch) {
  Row row;
  row.scalar = scalar, row.seconds = seconds;
  Panda arms[] = {Panda(seed), Panda(seed + 1)};
  Sensor<T> quiet;
  Touched<T> touched;
  bool before = false;
  for (long k = 0, ticks = std::lround(seconds / period); k < ticks; ++k) {
    const Contact contact(k);
    see_quiet(row, quiet, arms[0].measure(), before);
    touched.see(row, arms[1].measure(), contact);
    const Values external[] = {{}, contact.external()};
    if (watch) watch(instant(touched.sensor, external[1], k, touched.now));
    Panda::move_both(arms, external);
  }
  return row;
}

}  // namespace

double Row::longest() const { return delays.empty() ? 0.0 : *std::max_element(delays.begin(), delays.end()); }
double Row::median() const {
  if (delays.empty()) return 0.0;
  std::vector<double> sorted = delays;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

Row run(const std::string& scalar, double seconds, unsigned seed, const Watch& watch) {
  if (scalar == "float") return both<float>(scalar, seconds, seed, watch);
  if (scalar == "fixed32") return both<axial::Fixed32>(scalar, seconds, seed, watch);
  throw std::invalid_argument("unknown number system '" + scalar + "'; there are: float fixed32");
}

}  // namespace host_sim::collide
