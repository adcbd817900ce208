#pragma once
/// Fixed point over a fixed sequence of states, hashed: the same number on every board, host and compiler.

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>

#include <cstdint>
#include <new>

namespace axial::apps::fixed {

/// FNV-1a (Fowler, Noll, Vo) over bytes, the least significant first.
class Hash {
 public:
  constexpr void add(std::int32_t word) {
    for (int byte = 0; byte < 4; ++byte)
      value_ = (value_ ^ (static_cast<std::uint32_t>(word) >> (8 * byte) & 0xffU)) * 0x100000001b3U;
  }
  constexpr std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// Marsaglia's xorshift32, integers only.
class Random {
 public:
  constexpr std::int32_t next() {
    state_ ^= state_ << 13, state_ ^= state_ >> 17, state_ ^= state_ << 5;
    return static_cast<std::int32_t>(state_);
  }
  /// In [-limit, limit).
  constexpr std::int32_t within(std::int32_t limit) { return integer::multiply_high(next(), limit) * 2; }

 private:
  std::uint32_t state_ = 0x20240920;
};

/// Whose values a scene's are: the robot's joints, or the drives that they share.
template <class S>
using ValuesOf = typename scene_of<S>::Robot;

/// The limits of one role as raw words.
template <class S>
struct RawLimits {
  std::int32_t of[ValuesOf<S>::chain.size];
};
template <class S, class Values, class Get>
constexpr RawLimits<S> raw_limits(Get get) {
  RawLimits<S> limits{};
  for (int i = 0; i < ValuesOf<S>::chain.size; ++i)
    limits.of[i] =
        static_cast<std::int32_t>(get(ValuesOf<S>::chain.links[i]) * detail::power_of_two(Values::exponent(i)));
  return limits;
}

/// What a kernel is called with.
template <class S, class T>
struct Call {
  using R = robot_of<S>;
  Positions<R, T> q{};
  Velocities<R, T> qd{};
  Accelerations<R, T> qdd{};
  EffortsOf<S, T> tau{};
};

/// The next state: every fourth one holds each number at a limit or at 0, angles at eighths of a turn.
template <class S, class T>
constexpr Call<S, T> next_call(Random& random, int index) {
  using C = Call<S, T>;
  using Word = typename T::Word;
  constexpr auto slide =
      raw_limits<S, decltype(C::q)>([](const auto& p) { return p.position_max < 100.0 ? p.position_max : 0.0; });
  constexpr auto speed = raw_limits<S, decltype(C::qd)>([](const auto& p) { return p.speed_limit; });
  constexpr auto pull = raw_limits<S, decltype(C::qdd)>([](const auto& p) { return p.acceleration_limit; });
  constexpr auto effort = raw_limits<S, decltype(C::tau)>([](const auto& p) { return p.effort_limit; });
  const bool corner = index % 4 == 3;
  const auto draw = [&](std::int32_t limit) {
    const std::int32_t any = random.within(limit), side = random.next() >> 30;
    return static_cast<Word>(!corner ? any : side == 0 ? 0 : side < 0 ? -limit : limit);
  };
  C call{};
  for (int i = 0; i < ValuesOf<S>::chain.size; ++i) {
    const bool turns = ValuesOf<S>::chain.links[i].type == JointType::revolute;
    const std::int32_t angle = random.next(), depth = random.next();
    const auto eighth = static_cast<std::int32_t>(static_cast<std::uint32_t>(angle) & 0xe0000000U);
    const std::int32_t shift = static_cast<std::int32_t>(static_cast<std::uint32_t>(depth) >> 1);
    call.q[i].raw = !turns ? integer::multiply_high(shift, slide.of[i]) * 2 : corner ? eighth : angle;
    call.qd[i].raw = draw(speed.of[i]), call.qdd[i].raw = draw(pull.of[i]), call.tau[i].raw = draw(effort.of[i]);
  }
  return call;
}

// The kernels, by name.
struct InverseDynamics {
  static constexpr const char* name = "inverse_dynamics";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return inverse_dynamics<S>(c.q, c.qd, c.qdd);
  }
};
struct ForwardDynamics {
  static constexpr const char* name = "forward_dynamics";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return forward_dynamics<S>(c.q, c.qd, c.tau);
  }
};
struct CertifiedForwardDynamics {
  static constexpr const char* name = "certified_forward_dynamics";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return certified_forward_dynamics<S, T>(c.q, c.qd, c.tau);
  }
};
struct ClosedForm {
  static constexpr const char* name = "closed_form";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return closed_form::scara_torque<S>(c.q, c.qd, c.qdd);
  }
};

struct InverseDerivatives {
  static constexpr const char* name = "inverse_dynamics_derivatives";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return inverse_dynamics_derivatives<S>(c.q, c.qd, c.qdd);
  }
};
struct ForwardDerivatives {
  static constexpr const char* name = "certified_forward_dynamics_derivatives";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return certified_forward_dynamics_derivatives<S>(c.q, c.qd, c.tau);
  }
};

struct SeparatedTorque {
  static constexpr const char* name = "separated_torque";
  template <class S, class T>
  static constexpr auto run(const Call<S, T>& c) {
    return torque(separate<S>(c.q), c.qd, c.qdd);
  }
};

/// Every word of a result.
///@{
template <class Values>
constexpr void add_words(Hash& hash, const Values& result) {
  for (const auto& value : result.values)
    hash.add(value.raw);
}
template <class S, class T>
constexpr void add_words(Hash& hash, const CertifiedDynamics<S, T>& result) {
  add_words(hash, static_cast<const axial::ForwardDynamics<S, T>&>(result));
  add_words(hash, result.bound);
  hash.add(static_cast<std::int32_t>(result.status.code)), hash.add(result.status.joint);
}
template <class S, class T>
constexpr void add_words(Hash& hash, const InverseDynamicsDerivatives<S, T>& result) {
  add_words(hash, result.tau), add_words(hash, result.M);
  add_words(hash, result.dtau_dq), add_words(hash, result.dtau_dqd);
}
template <class S, class T>
constexpr void add_words(Hash& hash, const ForwardDynamicsDerivatives<S, T>& result) {
  add_words(hash, result.qdd), add_words(hash, result.M_inverse);
  add_words(hash, result.dqdd_dq), add_words(hash, result.dqdd_dqd);
}
template <class S, class T>
constexpr void add_words(Hash& hash, const CertifiedDerivatives<S, T>& result) {
  add_words(hash, static_cast<const ForwardDynamicsDerivatives<S, T>&>(result)), add_words(hash, result.bound);
  hash.add(static_cast<std::int32_t>(result.qdd.status.code)), hash.add(result.qdd.status.joint);
}
///@}

/// What one kernel showed.
struct Golden {
  const char* kernel;
  const char* arithmetic;
  std::uint64_t hash;
  std::uint32_t least, most;  ///< instructions, where the counter counts
};

inline constexpr int golden_states = 256;

/// `count(code)` runs code and says what it cost.
template <class Kernel, class S, class T, class Count>
Golden golden(const char* arithmetic, Count count) {
  Random random;
  Hash hash;
  std::uint32_t least = ~0U, most = 0;
  for (int k = 0; k < golden_states; ++k) {
    const auto call = next_call<S, T>(random, k);
    using Result = decltype(Kernel::run(call));
    alignas(Result) unsigned char bytes[sizeof(Result)];  // where the kernel puts it, once on a small stack
    Result* result = nullptr;
    auto code = [&] { result = ::new (static_cast<void*>(bytes)) Result(Kernel::run(call)); };
    const std::uint32_t cost = count(code);
    least = cost < least ? cost : least, most = cost > most ? cost : most;
    add_words(hash, *result);
  }
  return {Kernel::name, arithmetic, hash.value(), least, most};
}

constexpr int golden_motions = 16, golden_steps = 64;

/// Motions of as many steps from as many states, by efforts at random: words, what rounding left, statuses. Costs are
/// of a step: the most that one took, and so much less as steps of one length differ. A core that shifts 64 bits by
/// branches takes another count for another length, which is a constant.
template <class Method, class S, class T, class Count>
Golden golden_motion(const char* kernel, Count count) {
  constexpr FixedStep steps[golden_motions] = {1e-3 / 1,  1e-3 / 2,  1e-3 / 3,  1e-3 / 4,  1e-3 / 5,  1e-3 / 6,
                                               1e-3 / 7,  1e-3 / 8,  1e-3 / 9,  1e-3 / 10, 1e-3 / 11, 1e-3 / 12,
                                               1e-3 / 13, 1e-3 / 14, 1e-3 / 15, 1e-3 / 16};
  Random random;
  Hash hash;
  std::uint32_t spread = 0, highest = 0;
  for (int k = 0; k < golden_motions; ++k) {
    std::uint32_t least = ~0U, most = 0;
    auto call = next_call<S, T>(random, k);
    Motion<S, T> x;
    x.q = call.q;
    for (int i = 0; i < S::Robot::chain.size; ++i)
      x.qd[i].raw = static_cast<typename T::Word>(call.qd[i].raw / 4);
    for (int step = 0; step < golden_steps; ++step) {
      if (step % 8 == 0) call = next_call<S, T>(random, k);
      Status status;
      auto code = [&] { status = advance<Method>(x, steps[k], Held<S, T>{call.tau, {}}); };
      const std::uint32_t cost = count(code);
      least = cost < least ? cost : least, most = cost > most ? cost : most;
      hash.add(static_cast<std::int32_t>(status.code)), hash.add(status.joint);
    }
    add_words(hash, x.q), add_words(hash, x.qd);
    for (int i = 0; i < S::Robot::chain.size; ++i)
      hash.add(x.q_rest[i]), hash.add(x.qd_rest[i]);
    hash.add(static_cast<std::int32_t>(x.steps));
    spread = most - least > spread ? most - least : spread, highest = most > highest ? most : highest;
  }
  return {kernel, "32_nearest", hash.value(), highest - spread, highest};
}

/// All kernels of a robot, each given to `put`.
template <class R, class Count, class Put>
void all_golden(Count count, Put put) {
  using Exact = Scene<R, Gravity, RotorInertia>;
  using Down = Scene<R, Gravity, RotorInertia, RoundDown>;
  using High = Scene<R, Gravity, RotorInertia, HighWord>;
  put(golden<InverseDynamics, Exact, Fixed32>("32_nearest", count));
  put(golden<InverseDynamics, Down, Fixed32>("32_down", count));
  put(golden<InverseDynamics, High, Fixed32>("32_high_word", count));
  put(golden<InverseDynamics, Exact, Fixed16>("16_nearest", count));
  put(golden<ForwardDynamics, Exact, Fixed32>("32_nearest", count));
  if constexpr (R::chain.size == 3) {
    put(golden<ForwardDynamics, High, Fixed32>("32_high_word", count));
    put(golden<ClosedForm, Exact, Fixed32>("32_nearest", count));
    put(golden<ClosedForm, High, Fixed32>("32_high_word", count));
    put(golden<ClosedForm, Exact, Fixed16>("16_nearest", count));
  }
}

/// Derivatives of a robot, and certified accelerations of a small one, likewise: an image of their own, which not every
/// board has room for.
template <class R, class Count, class Put>
void all_golden_derivatives(Count count, Put put) {
  using Exact = Scene<R, Gravity, RotorInertia>;
  put(golden<InverseDerivatives, Exact, Fixed32>("32_nearest", count));
  if constexpr (R::chain.size == 3) put(golden<CertifiedForwardDynamics, Exact, Fixed32>("32_nearest", count));
  put(golden<ForwardDerivatives, Exact, Fixed32>("32_nearest", count));
}

/// Derivatives of a robot by one step for all links likewise.
template <class R, class Count, class Put>
void all_golden_looped(Count count, Put put) {
  using S = Scene<R, Gravity, RotorInertia, Looped>;
  put(golden<InverseDerivatives, S, Fixed32>("32_looped", count));
  put(golden<ForwardDerivatives, S, Fixed32>("32_looped", count));
}

/// Dynamics of a robot whose joints share drives likewise.
template <class R, class Count, class Put>
void all_golden_drives(Count count, Put put) {
  using S = Scene<R, Gravity, RotorInertia, Friction>;
  put(golden<InverseDynamics, S, Fixed32>("32_nearest", count));
  put(golden<ForwardDynamics, S, Fixed32>("32_nearest", count));
  put(golden<CertifiedForwardDynamics, S, Fixed32>("32_nearest", count));
  put(golden<SeparatedTorque, S, Fixed32>("32_nearest", count));
  put(golden<InverseDerivatives, S, Fixed32>("32_nearest", count));
}

/// Integrators of a robot likewise.
template <class R, class Count, class Put>
void all_golden_motions(Count count, Put put) {
  using S = Scene<R, Gravity, RotorInertia>;
  put(golden_motion<RungeKutta4, S, Fixed32>("runge_kutta_4", count));
  put(golden_motion<SemiImplicitEuler, S, Fixed32>("semi_implicit", count));
}

}  // namespace axial::apps::fixed
