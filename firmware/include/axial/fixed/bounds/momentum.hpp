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
template <int N>
constexpr MomentumBounds<N> carry(Account<N>& moving, const Row<Number, N>& holding) {
  MomentumBounds<N> all;
  with_loads(moving, [&](const auto& start) {
    momentum::carry(start.links, start.in, start.screws(), start.at.qd, holding, all);
  });
  return all;
}
template <int N>
constexpr Row<Number, N> hold(Account<N>& account) {
  Row<Number, N> effort{};
  with_loads(account, [&effort](const auto& start) {
    momentum::hold(start.links, start.in, start.at.q, start.screws(), start.at.qd, effort);
  });
  return effort;
}

}  // namespace detail

/// Bounds of the drifts, at `exponents`, of momenta and efforts in the formats that their ranges say.
template <int N>
constexpr Row<Ball, N> drift_bounds(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& motion,
                                    const Ranges<N>& momenta, const int (&exponents)[N]) {
  auto rest = account_in_formats(m, r, motion), carried = account_in_formats(m, r, momenta);
  const MomentumBounds<N> all = detail::carry(carried, detail::hold(rest));
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
  bounds::MomentumBounds<N> all;
  const auto run = [&all](bounds::Account<N>& account) { all = bounds::detail::carry(account, {}); };
  MomentumRanges<N> result{bounds::detail::ranges_by(mechanism, rounding, wanted, run), {}};
  for (int i = 0; i < N; ++i)
    result.range[i].joint_effort = all.momentum[i].bound, result.slope[i] = all.drift[i].bound;
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
