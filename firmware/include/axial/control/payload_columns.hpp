// What a payload's mass and first moment add to the joints' momenta and drifts: four columns each, linear in them;
// how they are rounded; the lag, weights and forgetting of the normal equations that are summed.
#pragma once

#include <axial/control/momentum_observer.hpp>
#include <axial/dynamics/kinematics.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Says what the estimator does not weigh under, and by which numbers not.
template <class Scene>
constexpr auto check_weighed() {
  static_assert(Scene::template has<Gravity> && !Scene::template has<RuntimeGravity>,
                "axial: a payload is weighed under the gravity that the chain declares; name Gravity in the scene");
}
template <class T>
constexpr auto check_weighing() {
  static_assert(!std::is_same_v<T, Fixed16>, "axial: the payload estimator takes Fixed32, float or double");
}

/// Gravity of a robot in world axes, m/s^2.
template <class S>
constexpr Vec3<double> world_gravity() {
  check_weighed<scene_of<S>>();
  constexpr const auto& chain = robot_of<S>::chain;
  const auto& r = chain.base.pose.rotation;
  const double x = chain.gravity.x, y = chain.gravity.y, z = chain.gravity.z;
  return {r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z};
}

/// Per unit of mass (kg) and of first moment (kg m, axes of the last link): the payload's row of one joint. In fixed
/// point words at the exponents of ColumnRounding.
template <class T>
struct PayloadRow {
  T of[4] = {};
};

/// How payload columns are read and rounded: as they are.
template <class S, class T>
struct ColumnRounding {
  using Number = T;  ///< of all vectors
  template <class Q>
  static constexpr const Q& direction(const Q& x) {
    return x;
  }
  template <class Q>
  static constexpr const Q& way(const Q& x) {
    return x;
  }
  static constexpr const T& speed(const Velocities<robot_of<S>, T>& qd, int i) { return qd[i]; }
  static constexpr Vec3<T> gravity() {
    constexpr Vec3<double> g = world_gravity<S>();
    using N = NumberTraits<T>;
    return {N::constant(g.x), N::constant(g.y), N::constant(g.z)};
  }
  using Turning = Vec3<T>;  ///< angular velocities
  using Moving = Vec3<T>;   ///< linear ones
  struct Same {
    template <class X>
    constexpr const X& operator()(const X& x) const {
      return x;
    }
  };
  static constexpr Same turning{}, moving{}, slope{}, momentum_along{}, momentum_across{}, drift_along{},
      drift_across{};
  static constexpr PayloadRow<T> row(const T& mass, const Vec3<T>& moment) {
    return {{mass, moment.x, moment.y, moment.z}};
  }
};

/// Columns of a payload's momentum and of its drift dT/dq - g.
template <class S, class T>
struct PayloadColumns {
  PayloadRow<T> momentum[joint_count<S>] = {}, drift[joint_count<S>] = {};
};

// A payload of mass m and first moment h about the tool point has the momentum l = m v + w x h, n = h x v; along
// a motion (a, b) that is m b.v + h.(b x w + v x a). Its inertia about the tool point is left out.
template <class F, class Along, class Across, class R, class Round>
constexpr auto payload_row(const F& format, const Along& along, const Across& across, const R& rotation,
                           const Round& rounded) {
  return format.row(along, rounded(transpose_times(rotation, across)));
}

/// Writes the columns at speeds qd, of the Jacobian's columns and the last link's rotation. Source: dT/dq_i of a
/// momentum is the one along v_i x J_i, v_i being the velocity of link i at the tool point; gravity's torque is the one
/// -g along J_i. F reads and rounds: numbers, words, or what bounds them.
template <class F, class Jacobian, class R, class Speeds, class All>
constexpr void write_payload_columns(const F& f, int n, const Jacobian& columns, const R& last, const Speeds& qd,
                                     All& all) {
  const Mat3 rotation{f.direction(last.x), f.direction(last.y), f.direction(last.z)};
  auto g = f.gravity();
  typename F::Turning w{}, wi{};
  typename F::Moving v{}, vi{};
  for (int i = 0; i < n; ++i) {
    w = f.turning(w + f.speed(qd, i) * f.direction(columns[i].angular));
    v = f.moving(v + f.speed(qd, i) * f.way(columns[i].linear));
  }
  for (int i = 0; i < n; ++i) {
    auto a = f.direction(columns[i].angular);
    auto b = f.way(columns[i].linear);
    wi = f.turning(wi + f.speed(qd, i) * a), vi = f.moving(vi + f.speed(qd, i) * b);
    auto da = f.turning(cross(wi, a));
    auto db = f.slope(cross(wi, b) + cross(vi, a));
    all.momentum[i] = payload_row(f, f.momentum_along(dot(b, v)), f.momentum_across(cross(b, w) + cross(v, a)),
                                  rotation, f.momentum_across);
    all.drift[i] = payload_row(f, f.drift_along(dot(db, v) + dot(b, g)),
                               f.drift_across(cross(db, w) + cross(v, da) + cross(g, a)), rotation, f.drift_across);
  }
}

template <class S, class T>
constexpr PayloadColumns<S, T> payload_columns(const Positions<robot_of<S>, T>& q,
                                               const Velocities<robot_of<S>, T>& qd);

/// Columns of drives that joints share: G^T times those of the joints.
template <class S, class T>
constexpr PayloadColumns<S, T> payload_columns_of_drives(const Positions<robot_of<S>, T>& u,
                                                         const Velocities<robot_of<S>, T>& ud) {
  using Links = decltype(links_of<S, T>());
  using JointScene = typename Links::JointScene;
  const auto joints = payload_columns<JointScene, T>(Links::positions(u), Links::rates(ud));
  PayloadColumns<S, T> all;
  const auto map = [](auto k, const auto& from, auto& to) {
    for (int c = 0; c < 4; ++c)
      to[k].of[c] = Links::template column_part<decltype(k)::value>([&](int i) { return from[i].of[c]; });
  };
  Links::each_drive([&](auto k) { map(k, joints.momentum, all.momentum), map(k, joints.drift, all.drift); });
  return all;
}

/// The columns at q and qd, about the tool point. In fixed point q and qd are inside the declared limits.
template <class S, class T>
constexpr PayloadColumns<S, T> payload_columns(const Positions<robot_of<S>, T>& q,
                                               const Velocities<robot_of<S>, T>& qd) {
  if constexpr (shares_drives_in<typename scene_of<S>::Robot>) {
    return payload_columns_of_drives<S, T>(q, qd);
  } else {
    constexpr int n = joint_count<S>;
    Inputs<S, T> in;
    if constexpr (scene_of<S>::template has<SineCosines>) in.turns = sine_cosines<S>(q);
    PayloadColumns<S, T> all;
    write_payload_columns(ColumnRounding<S, T>{}, n, jacobian<S>(q, in),
                          forward_kinematics<S>(q, in).frames[n - 1].rotation, qd, all);
    return all;
  }
}

/// What a residual may be wrong by, N m or N.
template <class S, class Tuning>
constexpr double residual_deviation(int joint) {
  const double most = scene_of<S>::Robot::chain.links[joint].effort_limit;
  return Tuning::deviation * (is_bounded(most) ? most : 1.0);
}
/// Information in samples that the lag makes alike, as a share of that in as many without it.
template <class Tuning>
constexpr double sample_share() {
  return residual_share<Tuning>() / (2.0 - residual_share<Tuning>());
}

/// Lag, weights and forgetting of an estimator: floating point.
template <class S, class T, class Tuning>
struct PayloadSums {
  using Number = T;    ///< of estimates
  using Residual = T;  ///< of a joint
  struct Weights {
    T of[joint_count<S>] = {};
  };
  static constexpr Weights weights = [] {
    Weights all;
    constexpr double share = residual_share<Tuning>();
    for (int i = 0; i < joint_count<S>; ++i) {
      const double deviation = residual_deviation<S, Tuning>(i);
      all.of[i] = NumberTraits<T>::constant(share / ((2.0 - share) * deviation * deviation));
    }
    return all;
  }();
  /// Sum of the squares of a sample's numbers, made infinite where a sum of such samples could exceed a quarter of T's
  /// range: it weighs no more than so many of them, however many there were.
  struct Squares {
    static constexpr double samples = Tuning::memory / Tuning::period + 2.0;
    static constexpr T room = [] {
      T heaviest = T(1);
      for (const T& weight : weights.of)
        heaviest = weight > heaviest ? weight : heaviest;
      return T(4) * NumberTraits<T>::constant(samples) * heaviest;
    }();
    T sum = T(0);
    constexpr void add(const T& x) { sum += x * x; }
    constexpr T scaled() const { return room * sum; }
  };
  static constexpr T lagged(int, const T& r, const T& p, const T& p_last, const T& d, const T& d_last) {
    return next_residual<Tuning>(r, p, p_last, T(Zero{}), d, d_last);
  }
  static constexpr void forget(T& sum) {
    constexpr T kept = NumberTraits<T>::constant(Tuning::memory / (Tuning::memory + Tuning::period));
    sum *= kept;
  }
  static constexpr void add(T (&information)[4][4], T (&moment)[4], bool used, int joint, const PayloadRow<T>& y,
                            const T& r) {
    const T weight = select(used, weights.of[joint], T(Zero{}));
    for (int i = 0; i < 4; ++i) {
      const T scaled = weight * y.of[i];
      moment[i] -= scaled * r;
      for (int j = 0; j <= i; ++j)
        information[i][j] += scaled * y.of[j];
    }
  }
  static constexpr T chosen(bool first, const T& a, const T& b) { return select(first, a, b); }
  static constexpr const T& information(const T& sum, int, int) { return sum; }
  static constexpr const T& moment(const T& sum, int) { return sum; }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
