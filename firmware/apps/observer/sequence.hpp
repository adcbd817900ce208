#pragma once
/// A momentum observer with its detector and a payload estimator over a fixed sequence of samples, hashed: the same
/// numbers on every board and host.

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <firmware/apps/fixed/golden.hpp>

namespace axial::apps::observer {

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.023, uncertainty = 0.08, release = 0.5;
  static constexpr int confirm = 2, calm = 20;
  static constexpr double deviation = 0.01, memory = 60.0, mass_deviation = 0.05, moment_deviation = 0.02;
};

/// Samples inside the declared limits, anywhere there: nothing of a motion's smoothness helps.
template <class S, class T>
class Samples {
 public:
  using Robot = robot_of<S>;
  Positions<Robot, T> q{};
  Velocities<Robot, T> qd{};
  EffortsOf<S, T> tau{};

  void next() {
    for (int i = 0; i < joint_count<S>; ++i) {
      const auto& limits = detail::LimitsFor<S, T>::joint(i);
      if constexpr (is_stored_v<T>) {
        const std::uint64_t share = static_cast<std::uint32_t>(random_.next());
        q[i].raw = static_cast<std::int32_t>(static_cast<std::uint32_t>(limits.min) +
                                             static_cast<std::uint32_t>(share * limits.span >> 32));
        qd[i].raw = random_.within(limits.speed.raw), tau[i].raw = random_.within(limits.effort.raw);
      } else {
        q[i] = limits.position_min + share() * (limits.position_max - limits.position_min);
        qd[i] = (share() - 0.5F) * limits.speed, tau[i] = (share() - 0.5F) * limits.effort;
      }
    }
  }

 private:
  float share() { return static_cast<float>(static_cast<std::uint32_t>(random_.next()) >> 8) / 16777216.0F; }
  fixed::Random random_;
};

/// What the sequence showed.
struct Report {
  std::uint64_t hash;
  std::uint32_t least, most;  ///< instructions of a sample, where the counter counts
  int refused, collisions;
};

inline constexpr int samples = 200;

template <class T>
std::int32_t bits(const T& x) {
  if constexpr (is_stored_v<T>)
    return x.raw;
  else
    return __builtin_bit_cast(std::int32_t, x);
}

/// Instructions of a piece of code, over all samples.
struct Cost {
  std::uint32_t least = ~0U, most = 0;
  void add(std::uint32_t cost) { least = cost < least ? cost : least, most = cost > most ? cost : most; }
};

/// `count(code)` runs code and says what it cost.
template <class S, class T, class Count>
Report report(Count count) {
  Samples<S, T> sample;
  ObserverState<S, T, Tuning> state;
  CollisionState contact;
  fixed::Hash hash;
  Cost cost;
  Report all{};
  for (int k = 0; k < samples; ++k) {
    sample.next();
    Status status;
    Collision found;
    auto code = [&] {
      status = observe(state, sample.q, sample.qd, sample.tau);
      found = detect(contact, state.residual);
    };
    cost.add(count(code));
    all.refused += status.ok() ? 0 : 1, all.collisions += found.detected ? 1 : 0;
    for (int i = 0; i < joint_count<S>; ++i)
      hash.add(bits(state.residual[i]));
    hash.add(found.joint);
  }
  all.hash = hash.value(), all.least = cost.least, all.most = cost.most;
  return all;
}

/// What weighing showed; the estimate after the last sample is one of a robot that moves by leaps.
struct WeighingReport {
  std::uint64_t hash = 0;
  Cost weigh, estimate;
  int ready = 0;  ///< estimates that are
};

inline void add(fixed::Hash& hash, float x) { hash.add(bits(x)); }
inline void add(fixed::Hash& hash, const Scaled& x) { hash.add(x.mantissa), hash.add(x.exponent); }
template <class X>
void add(fixed::Hash& hash, const PayloadEstimate<X>& found) {
  const auto body = found.body();
  for (const X& x : {found.mass, found.first_moment.x, found.first_moment.y, found.first_moment.z, found.variance[0],
                     found.variance[1], found.variance[2], found.variance[3], body.mass, body.com.x})
    add(hash, x);
}

/// `count(code)` runs code and says what it cost.
template <class S, class T, class Count>
WeighingReport weighing(Count count) {
  Samples<S, T> sample;
  ObserverState<S, T, Tuning> state;
  PayloadState<S, T> load;
  fixed::Hash hash;
  WeighingReport all;
  for (int k = 0; k < samples; ++k) {
    sample.next();
    static_cast<void>(observe(state, sample.q, sample.qd, sample.tau));
    auto weighs = [&] { static_cast<void>(update_payload<S, T, Tuning>(load, sample.q, sample.qd, state.residual)); };
    all.weigh.add(count(weighs));
    decltype(estimate<Tuning>(load)) found;
    auto estimates = [&] { found = estimate<Tuning>(load); };
    all.estimate.add(count(estimates));
    all.ready += found.status.ok() ? 1 : 0;
    for (const auto& row : load.lagged)
      for (const T& x : row.of)
        hash.add(bits(x));
    add(hash, found);
    if constexpr (is_stored_v<T>) {
      const auto words = payload_words<S>(found);
      hash.add(words.mass.raw), hash.add(words.body.com.x.raw), hash.add(static_cast<int>(words.status.code));
    }
  }
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::observer
