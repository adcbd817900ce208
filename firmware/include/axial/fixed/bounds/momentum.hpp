// Sizes, formats and errors of the joints' momenta and of what changes them: the momentum kernel, run on bounds.
#pragma once

#include <axial/dynamics/momentum.hpp>
#include <axial/fixed/bounds/newton_euler.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Ranges of momenta, and what the kinetic energy's slope along each joint can be.
template <int N>
struct MomentumRanges : Ranges<N> {
  Ball slope[N] = {};  ///< dT/dq, N m or N
};

namespace bounds {

/// What the momentum kernel writes, in bounds.
template <int N>
struct MomentumBounds {
  Row<Number, N> momentum{};  ///< N m s or N s
  Row<NumberSum, N> drift{};  ///< N m or N, before its one rounding
};

namespace detail {

// One run of the kernel: momenta in the formats of `moving`, what holds the robot in those of `holding`.
template <class Scene, int N>
constexpr MomentumBounds<N> carry(Account<N>& moving, const Row<Number, N>& holding) {
  const BoundedLinks<Scene, N> links(moving);
  const GivenLoads in = given_loads(moving.mechanism.loads, moving.rounding);
  const JointBounds<N> at(moving.mechanism, moving.rounding);
  MomentumBounds<N> all;
  momentum::carry(links, in, joint_screws(links, in, at.q), at.qd, holding, all);
  return all;
}
template <class Scene, int N>
constexpr Row<Number, N> hold(Account<N>& account) {
  const BoundedLinks<Scene, N> links(account);
  const GivenLoads in = given_loads(account.mechanism.loads, account.rounding);
  const JointBounds<N> at(account.mechanism, account.rounding);
  Row<Number, N> effort{};
  momentum::hold(links, in, at.q, joint_screws(links, in, at.q), at.qd, effort);
  return effort;
}

template <int N>
constexpr MomentumRanges<N> momenta(const Mechanism<N>& m, const WordRounding& r, Wanted wanted) {
  Account<N> account{m, r};
  note_description(account);
  const auto run = [&account] {
    return with_loads(account.mechanism.loads, [&account](auto scene) { return carry<decltype(scene)>(account, {}); });
  };
  MomentumBounds<N> all = run();
  account.choose_formats();
  if (wanted == Wanted::errors) all = run();
  MomentumRanges<N> result{account.ranges, {}};
  for (int i = 0; i < N; ++i)
    result.range[i].joint_effort = all.momentum[i].bound, result.slope[i] = all.drift[i].bound;
  return result;
}

}  // namespace detail

/// Bounds of the drifts, at `exponents`, of momenta and efforts in the formats that their ranges say.
template <int N>
constexpr Row<Ball, N> drift_bounds(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& motion,
                                    const Ranges<N>& momenta, const int (&exponents)[N]) {
  const auto in_formats = [&m, &r](const Ranges<N>& ranges) {
    return r.tabled ? axial::detail::sharing(m, r, ranges) : m;
  };
  const Mechanism<N> at_rest = in_formats(motion), moving = in_formats(momenta);
  Account<N> rest{at_rest, r, false, false, motion}, carried{moving, r, false, false, momenta};
  const MomentumBounds<N> all = detail::with_loads(m.loads, [&](auto scene) {
    return detail::carry<decltype(scene)>(carried, detail::hold<decltype(scene)>(rest));
  });
  Row<Ball, N> bounds;
  for (int i = 0; i < N; ++i) {
    bounds[i] = all.drift[i].bound;
    bounds[i].error += all.drift[i].terms.rounding(exponents[i], r);
  }
  return bounds;
}

}  // namespace bounds

/// Ranges, formats and errors of momenta, under the names of Newton-Euler's quantities: velocities as accelerations,
/// momenta as forces and efforts.
template <int N>
constexpr MomentumRanges<N> momentum_ranges(const Mechanism<N>& mechanism, const WordRounding& rounding,
                                            Wanted wanted = Wanted::errors) {
  return detail::ranges_by(mechanism, rounding, wanted, [&rounding](const Mechanism<N>& m, Wanted of) {
    return bounds::detail::momenta(m, rounding, of);
  });
}

}  // namespace axial

#include <axial/options/end.hpp>
