// The links of a robot in bounds, as kernels walk over them.
#pragma once

#include <axial/fixed/balls/pose.hpp>
#include <axial/fixed/bounds/link.hpp>
#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A motion in bounds.
using BoundedMotion = MotionVector<BoundedVector, BoundedVector>;

/// The links of a robot in bounds.
template <class SceneType, int N>
class BoundedLinks {
 public:
  using Scene = SceneType;                 ///< what the links belong to
  using Scalar = Number;                   ///< in bounds
  using Dense = Number;                    ///< what passes keep
  static constexpr bool unrolled = false;  ///< a loop walks over them
  static constexpr int capacity = N;       ///< number of links

  /// Links that note in `account` what a kernel finds out.
  constexpr explicit BoundedLinks(Account<N>& account) : account_(&account) {}
  static constexpr int size() { return N; }      ///< number of links
  static constexpr int last() { return N - 1; }  ///< index of the last link
  /// Link i as kernels see it.
  constexpr auto link(int i) const { return BoundedLink<Scene, N>(account_, i); }
  /// Index of the link that carries joint i, negative for the base.
  constexpr int parent_index(int i) const { return account_->mechanism.parent(i); }
  /// Results are bounds: efforts and momenta as their links rounded them.
  template <class Values>
  static constexpr void write(Values& values, int i, const Number& x) {
    values[i] = x;
  }
  /// Differences wait for who knows their exponent.
  static constexpr void write_difference(Row<NumberSum, N>& values, int i, const NumberSum& x, const Number& y) {
    values[i] = x + y;
  }
  /// A column of the Jacobian as it is stored: linear motion at the exponent of lengths, a slide's direction too.
  ///@{
  constexpr BoundedMotion stored(const MotionVector<BoundedVector, VectorSum>& column) const {
    return {column.angular, link(0).sum(quantity::Length{}, column.linear)};
  }
  constexpr BoundedMotion stored(const MotionVector<ZeroVec3, BoundedVector>& column) const {
    const BoundedVector direction = link(0).sum(quantity::Length{}, column.linear);
    return {{}, direction};
  }
  ///@}
  /// Frame 0 in the world.
  constexpr auto base_pose() const { return constant_pose(account_->mechanism.loads.base_offset, account_->rounding); }
  /// Acceleration of the base that stands for gravity: constants of the model, in a table words; a run-time input has
  /// the exponent of its declared size.
  constexpr BoundedVector base_acceleration() const {
    const LoadRange& l = account_->mechanism.loads;
    const WordRounding& r = account_->rounding;
    BoundedVector g{detail::split({l.gravity_across, 0.0}, {l.gravity_along, 0.0}), 0, true, &r};
    if (l.gravity_given) {
      g.exponent = detail::input_exponent(l.gravity_along, r), g.is_literal = false;
    } else if (account_->mechanism.steps.shared) {
      g.exponent = account_->mechanism.base_format().linear_acceleration, g.is_literal = false;
      const double step = account_->sizing ? 0.0 : 0.5 * WordRounding::ulp(g.exponent);
      g.bound = detail::with_rounding(g.bound, l.gravity_across > 0.0 ? detail::root2 * step : 0.0,
                                      l.gravity_along > 0.0 ? step : 0.0);
    }
    return g;
  }

 private:
  Account<N>* account_;
};

}  // namespace axial::bounds

#include <axial/options/end.hpp>
