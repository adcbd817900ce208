// Joint values in bounds, and what every kernel's run on bounds starts from.
#pragma once

#include <axial/fixed/bounds/links.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

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
