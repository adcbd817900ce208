// The links of a robot in bounds, as kernels walk over them, with poses and joint values. Of a pose, rows of a rotation
// are vectors in a link's frame, positions in the world are known by their norms.
#pragma once

#include <axial/fixed/balls/vector.hpp>
#include <axial/fixed/bounds/link.hpp>
#include <axial/recursion/passes.hpp>
#include <axial/spatial/pose.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A rotation by its rows.
using Rotation = Mat3<BoundedVector, BoundedVector, BoundedVector>;
/// A pose in the world.
using BoundedPose = Pose<Rotation, BoundedVector>;

namespace detail {
// A direction in the world of which each component is one of three rows' components, each off by `error` at most.
constexpr BoundedVector direction(const Rotation& r, double x, double y, double z) {
  const Ball any{1.0, hypotenuse(hypotenuse(x, y), z)};
  const bool literal = r.x.is_literal && r.y.is_literal && r.z.is_literal;
  return {{any, any, any}, r.x.exponent, literal, r.x.rounding};
}
constexpr BoundedVector anywhere(const Ball& norm, int exponent, const WordRounding* rounding) {
  return {{norm, norm, norm}, exponent, false, rounding};
}
}  // namespace detail

/// A constant pose of the model: directions and a point that are literals.
constexpr BoundedPose constant_pose(double offset, const WordRounding& r) {
  const SplitBall unit{{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  const BoundedVector row{unit, r.bits - 2, true, &r};
  BoundedVector position = detail::anywhere({offset, 0.0}, 0, &r);
  position.is_literal = true;
  return {{row, row, row}, position};
}

/// A run-time pose: words, taken for what they say; its origin within `reach` (m), in the format of that.
constexpr BoundedPose given_pose(double reach, int exponent, const WordRounding& r) {
  BoundedPose pose = constant_pose(reach, r);
  for (BoundedVector* v : {&pose.rotation.x, &pose.rotation.y, &pose.rotation.z, &pose.position})
    v->is_literal = false;
  pose.position.exponent = exponent;
  return pose;
}

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

/// Inertia differences of a loaded link: exact differences of its words.
template <class Scene, int N>
constexpr Vec3<Number> loaded_differences(const BoundedLink<Scene, N>& link, const Body& body) {
  if constexpr (!Scene::template has<Payload>) return link.inertia_differences();
  const auto& j = body.inertia.of;
  if (j.xx.is_literal) return link.inertia_differences();
  return {j.zz, j.xx, j.yy};  // words of one exponent, which is all that their products are told by
}

namespace detail {

// Joint values as the kernel reads them: words at the exponents of the declared limits, looped at the coarsest.
template <int N>
class JointBounds {
 public:
  constexpr JointBounds(const Mechanism<N>& m, const WordRounding& r) : r_(r), shared_(m.steps.shared) {
    double speed = 0.0, acceleration = 0.0;
    for (const JointRange& j : m.joints)
      speed = axial::detail::larger(speed, j.speed), acceleration = axial::detail::larger(acceleration, j.acceleration);
    for (int i = 0; i < N; ++i) {
      const JointRange& j = m.joints[i];
      q[i] = {position(m.steps, j.travel), {&r, j.position_error}};
      q[i].length.bound.error += j.position_error;
      qd[i] = read(j.speed, speed), qd[i].bound.error += j.speed_error;
      qdd[i] = read(j.acceleration, acceleration), qdd[i].bound.error += j.acceleration_error;
    }
  }
  Row<Position, N> q{};
  Row<Number, N> qd{}, qdd{};

 private:
  const WordRounding& r_;
  bool shared_;

  constexpr Number read(double size, double largest) const {
    const int own = input_exponent(size, r_), all = input_exponent(largest, r_);
    return shared_ ? word_of({size, r_.move(own, all)}, all) : word_of({size, 0.0}, own);
  }
  // A position has 32 bits in any word; a shorter one is cut off, a shared format moves it.
  constexpr Number position(const SharedSteps& steps, double travel) const {
    const int own = input_exponent(travel, r_);
    if (shared_) return word_of({travel, r_.store(steps.format.length)}, steps.format.length);
    return word_of({travel, r_.bits < 32 ? WordRounding::ulp(own) : 0.0}, own);
  }
};

// What the description alone says of formats: the room for a shift, and for a body with its payload.
template <int N>
constexpr void note_description(Account<N>& account) {
  const Mechanism<N>& m = account.mechanism;
  for (int i = 0; i < N; ++i) {
    const auto& c = m.links[i];
    const double travel = m.joints[i].travel,
                 moment = axial::detail::length_of(c.hx, c.hy, c.hz) + m.loads.payload_moment;
    LinkSizes& widest = account.widest[i];
    widest.of(quantity::Length{}) = travel > 0.0 ? travel : 1.0;
    widest.of(quantity::Mass{}) = magnitude(c.mass) + m.loads.payload_mass;
    widest.of(quantity::FirstMoment{}) = 2.0 * moment;
    widest.of(quantity::RotationalInertia{}) = 2.0 * (axial::detail::norm_of(c) + m.loads.payload_inertia);
  }
}

// Ranges of what `run` runs on an account: once for sizes, which give formats, and again for errors in them. Of each
// link apart, or, where constants come from a table, of links that share their formats.
template <int N, class Run>
constexpr Ranges<N> ranges_by(const Mechanism<N>& m, const WordRounding& r, Wanted wanted, const Run& run) {
  const auto found = [&](const Mechanism<N>& of, Wanted part) {
    Account<N> account{of, r};
    note_description(account);
    run(account);
    account.choose_formats();
    if (part == Wanted::errors) run(account);
    return account.ranges;
  };
  return found(r.tabled ? axial::detail::sharing(m, r, found(m, Wanted::formats)) : m, wanted);
}

// What a kernel of a scene starts from: links that note in `account`, the loads and the joint values there.
template <class Scene, int N>
struct KernelStart {
  BoundedLinks<Scene, N> links;
  GivenLoads in;
  JointBounds<N> at;
  constexpr explicit KernelStart(Account<N>& account)
      : links(account),
        in(given_loads(account.mechanism.loads, account.rounding)),
        at(account.mechanism, account.rounding) {}
  constexpr auto screws() const { return joint_screws(links, in, at.q); }
};

// Calls f with what a kernel of the scene starts from whose loads there are.
template <int N, class F>
constexpr auto with_loads(Account<N>& account, const F& f) {
  const LoadRange& l = account.mechanism.loads;
  const bool payload = l.payload_mass > 0.0, wrench = l.tip_force > 0.0 || l.tip_moment > 0.0;
  if (payload && wrench) return f(KernelStart<BoundedScene<true, true>, N>(account));
  if (payload) return f(KernelStart<BoundedScene<true, false>, N>(account));
  if (wrench) return f(KernelStart<BoundedScene<false, true>, N>(account));
  return f(KernelStart<BoundedScene<false, false>, N>(account));
}

}  // namespace detail
}  // namespace axial::bounds

#include <axial/options/end.hpp>
