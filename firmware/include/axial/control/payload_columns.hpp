// What a payload's mass and first moment add to the joints' momenta and drifts: four columns each, linear in them.
#pragma once

#include <axial/control/payload_formats.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

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

}  // namespace axial::detail

#include <axial/options/end.hpp>
