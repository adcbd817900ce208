// One joint's step of inverse dynamics: recorded over words and over real numbers, and run on bounds, by the kernel's
// own functions.
#pragma once

#include <host_sim/figures/prove/arm.hpp>

#include <axial/fixed/bounds/dynamics.hpp>

namespace prove {

/// What a step takes from its neighbours: its parent's motion, and the force that its child sends it.
template <class Motion, class Force>
struct Neighbours {
  Motion parent{};
  Force on_parent{};
};
template <class Motion, class Force>
Neighbours(Motion, Force) -> Neighbours<Motion, Force>;

/// What a step yields: the link's motion, the force that its parent bears, the joint's effort.
template <class Motion, class Force, class Effort>
struct Stepped {
  Motion motion{};
  Force on_parent{};
  Effort effort{};
};
template <class Motion, class Force, class Effort>
Stepped(Motion, Force, Effort) -> Stepped<Motion, Force, Effort>;

/// The outward and the inward step of joint i, as rnea::link_motions and rnea::propagate_inward take them.
template <class Links, class Screws, class I, class Around, class Q, class V, class A>
auto step(const Links& links, const Screws& screws, I i, const Around& around, const Q& q, const V& qd, const A& qdd) {
  using namespace axial;
  const auto link = links.link(i);
  const auto motion = link.shape(rnea::move(Revolute{}, link, screws[i], around.parent, qd[i], qdd[i]));
  const auto own = link.shape(rnea::newton_euler(link, link.body(), link.inertia_differences(), motion));
  const auto force = own + around.on_parent;
  return Stepped{motion, rnea::force_on_parent(links, screws, i, force),
                 rnea::joint_effort(links, i, force, q, qd, qdd)};
}

/// The force that joint I's link and all outboard of it send to its parent, by the whole kernel.
template <int I, class Links, class In, class Screws, class Motions>
auto sent_by(const Links& links, const In& in, const Screws& screws, const Motions& motions) {
  using namespace axial;
  constexpr Index<I> i;
  const auto own = rnea::own_force(links, in, motions, immersions(links, in, screws, NoMotion{}), i);
  if constexpr (I + 1 < Links::capacity)
    return rnea::force_on_parent(links, screws, i, own + sent_by<I + 1>(links, in, screws, motions));
  else
    return rnea::force_on_parent(links, screws, i, own);
}

/// What joint J's step takes in the whole kernel's run.
template <int J, class Links, class In, class Screws, class V, class A>
auto neighbours(const Links& links, const In& in, const Screws& screws, const V& qd, const A& qdd) {
  const auto motions = axial::rnea::link_motions(links, in, screws, qd, qdd);
  return Neighbours{motions[axial::Index<J - 1>{}], sent_by<J + 1>(links, in, screws, motions)};
}

/// What Gappa is asked for, in terms of our bound of the same step. Ours knows that a turn keeps a norm; intervals know
/// components, whose box has longer diagonals.
inline constexpr double boxes = 1.1;

namespace step_bounds {

using namespace axial::bounds;

inline axial::SplitBall exact(axial::SplitBall v) {
  v.across.error = v.along.error = v.whole.error = 0.0;
  return v;
}
inline BoundedVector exact(BoundedVector v) {
  v.bound = exact(v.bound);
  return v;
}
/// Of a spin the entries themselves are exact.
inline Spin exact(Spin u) {
  u.w = exact(u.w), u.dw = exact(u.dw), u.axis = exact(u.axis), u.entry = 0.0, u.axis_apart = false;
  return u;
}

/// What joint J's step takes, as large as the whole kernel's bounds say and without an error, and what it makes of it.
template <class Robot, int J>
auto run() {
  using namespace axial;
  using Scene = scene_of<Robot>;
  using Parameters = axial::detail::with_rotors<Scene, BaseParameters>;
  constexpr int n = Robot::chain.size;
  const auto& mechanism = mechanism_of<Scene, Parameters>;
  WordRounding rounding = rounding_in<Scene, axial::detail::ArithmeticOf<Scene, std::int32_t>>();
  rounding.turn_error = sine_bound;
  Account<n> account{mechanism, rounding, false, false,
                     axial::detail::ranges_for<Scene, std::int32_t, BaseParameters, recursion::NewtonEuler>};
  const BoundedLinks<BoundedScene<false, false>, n> links(account);
  const auto in = axial::bounds::detail::given_loads(mechanism.loads, rounding);
  const axial::bounds::detail::JointBounds<n> at(mechanism, rounding);
  const auto screws = joint_screws(links, in, at.q);
  auto around = neighbours<J>(links, in, screws, at.qd, at.qdd);
  around.parent.w = exact(around.parent.w), around.parent.dw = exact(around.parent.dw);
  around.parent.a = exact(around.parent.a), around.parent.u = exact(around.parent.u);
  around.on_parent.moment = exact(around.on_parent.moment), around.on_parent.force = exact(around.on_parent.force);
  return std::pair{around, step(links, screws, Index<J>{}, around, at.q, at.qd, at.qdd)};
}

}  // namespace step_bounds

/// A word of a neighbour becomes an input that reaches `most`, and the real number the variable of that name.
template <int E, class S>
void give(Statement& s, const std::string& name, axial::Fx<E, S>& word, Real& real, double most) {
  const std::int32_t here = word.raw.value();
  word.raw = {here, add_input(s, name, here, -most, most, E)};
  real = Real::variable(name);
}
template <class V, class R>
void give(Statement& s, const std::string& name, V& words, R& reals, double across, double along) {
  give(s, name + "x", words.x, reals.x, across), give(s, name + "y", words.y, reals.y, across);
  give(s, name + "z", words.z, reals.z, along);
}
template <class V, class R>
void give(Statement& s, const std::string& name, V& words, R& reals, const axial::SplitBall& size) {
  give(s, name, words, reals, size.across.largest(), size.along.largest());
}
template <class V, class R>
void give(Statement& s, const std::string& name, V& words, R& reals, const axial::bounds::Spin& u) {
  const auto most = axial::bounds::detail::entry_sizes(u);
  give(s, name + "x", words.x, reals.x, most.plane, u.axis.across.largest());
  give(s, name + "y", words.y, reals.y, most.plane, u.axis.across.largest());
  give(s, name + "z", words.z, reals.z, most.mixed, u.axis.along.largest());
}

/// Results with the bounds to prove of their differences.
///@{
template <int E, class S>
void expect(Statement& s, const std::string& name, const axial::Fx<E, S>& word, const Real& real, double bound) {
  const int node = word.raw.settled();
  s.known[node] = E;
  s.results.push_back({name, node, real.term(), bound});
}
template <class V, class R>
void expect(Statement& s, const std::string& name, const V& words, const R& reals, const axial::SplitBall& bound) {
  expect(s, name + " across", words.x, reals.x, bound.across.error);
  expect(s, name + " across", words.y, reals.y, bound.across.error);
  expect(s, name + " along", words.z, reals.z, bound.along.error);
}
///@}

/// Links over a number, joint values and screws, as the kernel has them.
template <class Robot, class T, class Q, class V, class A>
auto run_of(const Q& q, const V& qd, const A& qdd) {
  const auto links = axial::links_of<Robot, T, axial::BaseParameters>();
  return std::tuple{links, axial::joint_screws(links, axial::Inputs<Robot, T>{}, links.read(q)), links.read(q),
                    links.read(qd), links.read(qdd)};
}

/// The statement about joint J's step: its neighbours' words are inputs, taken as they are, with the formats and sizes
/// that the whole kernel has there.
template <class Robot, int J>
Statement step_statement() {
  using Word = axial::Stored<Int32>;
  const axial::Index<J> joint;
  const auto around = [](const auto& run) {
    const auto& [links, screws, q, qd, qdd] = run;
    return neighbours<J>(links, axial::Inputs<Robot, Word>{}, screws, qd, qdd);
  };
  const auto stepped = [&](const auto& run, const auto& given) {
    const auto& [links, screws, q, qd, qdd] = run;
    return step(links, screws, joint, given, q, qd, qdd);
  };
  Statement whole;  // in which the neighbours' words of a state are found
  Program::activate(&whole.program), Formula::activate(&whole.formula);
  const ArmState<Robot> there = state_of<Robot>(whole);
  auto words = around(run_of<Robot, Word>(there.q, there.qd, there.qdd));
  auto reals = around(run_of<Robot, Real>(there.real_q, there.real_qd, there.real_qdd));

  Statement s;
  Program::activate(&s.program), Formula::activate(&s.formula);
  const ArmState<Robot> state = state_of<Robot>(s);
  const auto run = run_of<Robot, Word>(state.q, state.qd, state.qdd);
  const auto exact_run = run_of<Robot, Real>(state.real_q, state.real_qd, state.real_qdd);
  const auto [given, bounds] = step_bounds::run<Robot, J>();
  give(s, "w", words.parent.w, reals.parent.w, given.parent.w.bound);
  give(s, "dw", words.parent.dw, reals.parent.dw, given.parent.dw.bound);
  give(s, "acc", words.parent.a, reals.parent.a, given.parent.a.bound);
  give(s, "u", words.parent.u, reals.parent.u, given.parent.u);
  give(s, "n", words.on_parent.moment, reals.on_parent.moment, given.on_parent.moment.bound);
  give(s, "f", words.on_parent.force, reals.on_parent.force, given.on_parent.force.bound);
  const auto result = stepped(run, words);
  const auto exact = stepped(exact_run, reals);
  add_turns(s);
  expect(s, "velocity", result.motion.w, exact.motion.w, bounds.motion.w.bound);
  expect(s, "turning", result.motion.dw, exact.motion.dw, bounds.motion.dw.bound);
  expect(s, "acceleration", result.motion.a, exact.motion.a, bounds.motion.a.bound);
  expect(s, "effort", result.effort, exact.effort, bounds.effort.bound.error);
  expect(s, "moment", result.on_parent.moment, exact.on_parent.moment, bounds.on_parent.moment.bound);
  expect(s, "force", result.on_parent.force, exact.on_parent.force, bounds.on_parent.force.bound);
  return s;
}

}  // namespace prove
