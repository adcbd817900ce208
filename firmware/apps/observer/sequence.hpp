#pragma once
/// A momentum observer with its detector over a fixed sequence of samples, hashed: the same number on every board and
/// host.

#include <axial/axial.hpp>
#include <firmware/apps/fixed/golden.hpp>

namespace axial::apps::observer {

struct Tuning {
  static constexpr double period = 1e-3, gain = 200.0;
  static constexpr double fraction = 0.023, uncertainty = 0.08, release = 0.5;
  static constexpr int confirm = 2, calm = 20;
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
      const auto& limits = detail::limits_for<S, T>().joints[i];
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

/// `count(code)` runs code and says what it cost.
template <class S, class T, class Count>
Report report(Count count) {
  Samples<S, T> sample;
  ObserverState<S, T, Tuning> state;
  CollisionState contact;
  fixed::Hash hash;
  Report all{0, ~0U, 0, 0, 0};
  for (int k = 0; k < samples; ++k) {
    sample.next();
    Status status;
    Collision found;
    auto code = [&] {
      status = observe(state, sample.q, sample.qd, sample.tau);
      found = detect(contact, state.residual);
    };
    const std::uint32_t cost = count(code);
    all.least = cost < all.least ? cost : all.least, all.most = cost > all.most ? cost : all.most;
    all.refused += status.ok() ? 0 : 1, all.collisions += found.detected ? 1 : 0;
    for (int i = 0; i < joint_count<S>; ++i)
      hash.add(bits(state.residual[i]));
    hash.add(found.joint);
  }
  all.hash = hash.value();
  return all;
}

}  // namespace axial::apps::observer
