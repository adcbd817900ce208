// What a payload's mass and first moment add to the joints' momenta and drifts: four columns each, linear in them.
#pragma once

#include <axial/control/payload_formats.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Per unit of mass (kg) and of first moment (kg m, axes of the last link): the payload's row of one joint. In fixed
/// point words at the exponents of ColumnRounding.
template <class T>
struct PayloadRow {
  T of[4] = {};
};
/// Columns of a payload's momentum and of its drift dT/dq - g.
template <class S, class T>
struct PayloadColumns {
  PayloadRow<T> momentum[joint_count<S>] = {}, drift[joint_count<S>] = {};
};

// A payload of mass m and first moment h about the tool point has the momentum l = m v + w x h, n = h x v; along
// a motion (a, b) that is m b.v + h.(b x w + v x a). Its inertia about the tool point is left out.
template <class T, class Along, class Across, class R, class Round, class Store>
constexpr PayloadRow<T> payload_row(const Along& along, const Across& across, const R& rotation, const Round& rounded,
                                    const Store& store) {
  auto h = rounded(transpose_times(rotation, across));
  return {{store(along), store(h.x), store(h.y), store(h.z)}};
}

/// The columns at q and qd. Source: the Jacobian of the tool point; dT/dq_i of a momentum is the one along
/// v_i x J_i, v_i being the velocity of link i there; gravity's torque -g along J_i. In fixed point q and qd are inside
/// the declared limits.
template <class S, class T>
constexpr PayloadColumns<S, T> payload_columns(const Positions<robot_of<S>, T>& q,
                                               const Velocities<robot_of<S>, T>& qd) {
  constexpr int n = joint_count<S>;
  using F = ColumnRounding<S, T>;
  Inputs<S, T> in;
  if constexpr (scene_of<S>::template has<SineCosines>) in.turns = sine_cosines<S>(q);
  const auto columns = jacobian<S>(q, in);
  const auto last = forward_kinematics<S>(q, in).frames[n - 1].rotation;
  const Mat3 rotation{F::direction(last.x), F::direction(last.y), F::direction(last.z)};
  auto g = F::gravity();
  typename F::Turning w{}, wi{};
  typename F::Moving v{}, vi{};
  for (int i = 0; i < n; ++i) {
    w = F::turning(w + F::speed(qd, i) * F::direction(columns[i].angular));
    v = F::moving(v + F::speed(qd, i) * F::way(columns[i].linear));
  }
  PayloadColumns<S, T> all;
  for (int i = 0; i < n; ++i) {
    auto a = F::direction(columns[i].angular);
    auto b = F::way(columns[i].linear);
    wi = F::turning(wi + F::speed(qd, i) * a), vi = F::moving(vi + F::speed(qd, i) * b);
    auto da = F::turning(cross(wi, a));
    auto db = F::slope(cross(wi, b) + cross(vi, a));
    all.momentum[i] = payload_row<T>(F::momentum_along(dot(b, v)), F::momentum_across(cross(b, w) + cross(v, a)),
                                     rotation, F::momentum_across, F::store);
    all.drift[i] =
        payload_row<T>(F::drift_along(dot(db, v) + dot(b, g)),
                       F::drift_across(cross(db, w) + cross(v, da) + cross(g, a)), rotation, F::drift_across, F::store);
  }
  return all;
}

}  // namespace axial::detail

#include <axial/options/end.hpp>
