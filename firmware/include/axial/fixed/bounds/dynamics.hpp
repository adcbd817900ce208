// Sizes, formats and errors of inverse dynamics, of the joints' momenta and what changes them, and of the mass matrix
// by composite bodies: their own kernels, run on bounds.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/fixed/bounds/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace bounds {

/// The base at rest.
///@{
template <class S, int N>
constexpr BoundedVector no_motion(const BoundedLinks<S, N>&) {
  return {};
}
template <class S, int N, class Input>
constexpr BoundedVector base_angular_velocity(const BoundedLinks<S, N>&, const Input&) {
  return {};
}
template <class S, int N, class Input>
constexpr BoundedVector base_angular_acceleration(const BoundedLinks<S, N>&, const Input&) {
  return {};
}
///@}

/// Friction at any speed: viscous, and the larger dry effort of both directions, a literal in the effort's format.
template <class S, int N>
constexpr NumberSum friction_effort(const BoundedLink<S, N>& link, const Number& qd) {
  const Number forward = link.template drive<&DriveConstants<double>::coulomb_forward>();
  const Number backward = link.template drive<&DriveConstants<double>::coulomb_backward>();
  const double dry = forward.bound.size > backward.bound.size ? forward.bound.size : backward.bound.size;
  return link.template drive<&DriveConstants<double>::viscous>() * qd + literal_of(dry);
}

namespace detail {

// One run of the kernel.
template <int N>
constexpr void run(Account<N>& account) {
  Row<ForceVector<BoundedVector, BoundedVector>, N> borne{};
  with_loads(account, [&borne](const auto& start) {
    rnea::propagate_inward(start.links, start.in, start.at.q, start.screws(), start.at.qd, start.at.qdd,
                           [&](int i, const auto& force, const auto&) { borne[i] = force; });
  });
  for (int i = 0; i < N; ++i) {
    LinkRange& range = account.ranges.range[i];
    range.moment = borne[i].moment.bound.whole, range.force = borne[i].force.bound.whole;
  }
}

}  // namespace detail

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

/// Rows of a mass matrix in bounds: the largest error of the entries up to the diagonal, each in its exponent.
template <int N, class Exponent>
struct MatrixRows {
  const WordRounding& rounding;  ///< of the arithmetic
  const Exponent& exponent;      ///< of entry (i, j)
  Row<double, N> error{};        ///< of row i

  /// Sets an entry, as the kernel does.
  constexpr void set(int i, int j, const Number& value) {
    const double own = value.bound.error + rounding.move(value.exponent, exponent(i, j));
    if (own > error[i]) error[i] = own;
  }
};

namespace detail {

template <int N, class Rows>
constexpr void set_rows(Account<N>& account, Rows& rows) {
  with_loads(account, [&rows](const auto& start) { crba::entries(start.links, start.in, start.screws(), rows); });
}

// The looped form keeps a joint's unit force, a column of its composite body, in the formats of forces, and adds masses
// that are words.
template <int N>
constexpr void note_unit_forces(Account<N>& account) {
  const auto widen = [](double& widest, double size) { widest = size > widest ? size : widest; };
  const Mechanism<N>& m = account.mechanism;
  double carried[N] = {};
  for (int i = N; i-- > 0;) {
    carried[i] += magnitude(m.links[i].mass) + (i + 1 == N ? m.loads.payload_mass : 0.0);
    if (m.parent(i) >= 0) carried[m.parent(i)] += carried[i];
    const LinkRange& own = account.ranges.range[i];
    const bool slides = m.links[i].prismatic;
    LinkSizes& widest = account.widest[i];
    widen(widest.of(quantity::Moment{}), (slides ? own.first_moment : own.rotational_inertia).size);
    widen(widest.of(quantity::Force{}), slides ? carried[i] : own.first_moment.size);
    widen(widest.of(quantity::JointInertia{}), slides ? carried[i] : 0.0);
    if (account.rounding.tabled) widen(widest.of(quantity::Mass{}), carried[i]);
  }
}

template <int N>
constexpr void run_bodies(Account<N>& account) {
  const auto none = [](int, int) { return 0; };
  MatrixRows<N, decltype(none)> ignored{account.rounding, none};
  set_rows(account, ignored);
  if (account.sizing) note_unit_forces(account);
}

}  // namespace detail

/// Errors of the rows of the matrix whose entries have the exponents `exponent(i, j)`, in the formats of `ranges`.
template <int N, class Exponent>
constexpr Row<double, N> mass_matrix_errors(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges,
                                            const Exponent& exponent) {
  auto account = account_in_formats(m, r, ranges);
  MatrixRows<N, Exponent> all{r, exponent};
  detail::set_rows(account, all);
  return all.error;
}

}  // namespace bounds

/// Ranges and errors of inverse dynamics in the formats that `ranges` say: of a robot whose joint values are off.
template <int N>
constexpr Ranges<N> newton_euler_errors(const Mechanism<N>& m, const WordRounding& r, const Ranges<N>& ranges) {
  auto account = bounds::account_in_formats(m, r, ranges);
  bounds::detail::run(account);
  return account.ranges;
}

/// Ranges, formats and errors of inverse dynamics (and of its bias and gravity parts): its own kernel, run on bounds.
template <int N>
constexpr Ranges<N> newton_euler_ranges(const Mechanism<N>& mechanism, const WordRounding& rounding,
                                        Wanted wanted = Wanted::errors) {
  return bounds::detail::ranges_by(mechanism, rounding, wanted, bounds::detail::run<N>);
}

/// Ranges of momenta, and what the kinetic energy's slope along each joint can be.
template <int N>
struct MomentumRanges : Ranges<N> {
  Ball slope[N] = {};  ///< dT/dq, N m or N
};

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

/// Ranges and formats of the mass matrix by composite bodies: joint_inertia of joint i is the diagonal's.
template <int N>
constexpr Ranges<N> composite_body_ranges(const Mechanism<N>& m, const WordRounding& r,
                                          Wanted wanted = Wanted::errors) {
  return bounds::detail::ranges_by(m, r, wanted, bounds::detail::run_bodies<N>);
}

}  // namespace axial

#include <axial/options/end.hpp>
