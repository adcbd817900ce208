// Sizes, formats and errors of inverse dynamics: its own kernel, run on bounds.
#pragma once

#include <axial/dynamics/inverse_dynamics.hpp>
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

}  // namespace axial

#include <axial/options/end.hpp>
