// A robot's chain: gravity, links, base and tool, checked while it compiles.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/robot/malformed.hpp>  // first: few lines of includes before what the compiler quotes of it

#include <axial/robot/base_body.hpp>
#include <axial/robot/chain_parameters.hpp>
#include <axial/robot/couplings.hpp>
#include <axial/robot/description_checks.hpp>
#include <axial/robot/drive_coordinates.hpp>

#include <utility>

#include <axial/options/begin.hpp>

namespace axial {

/// Part of a chain: axial::accept(axial::as_published) keeps numbers of all its links that no robot should have, as
/// their source gives them (doc/guides/description_rules.md).
struct Acceptance {};
constexpr Acceptance accept(AsPublished) { return {}; }  ///< as_published

namespace detail {

/// What of a description breaks which rule.
struct Broken {
  static constexpr int robot = -1, base_body = -2;  // else the index of a link

  int where = robot;
  Problem problem = Problem::none;
};

template <class Indices>
struct StopTable;
template <int... I>
struct StopTable<std::integer_sequence<int, I...>> {
  /// The function that stops the compiler, or none.
  static constexpr malformed::Stop of(const Broken& broken) {
    if (broken.problem == Problem::none) return nullptr;
    const auto row = static_cast<int>(broken.problem);
    if (broken.where == Broken::robot) return malformed::stops<malformed::robot>[row];
    if (broken.where == Broken::base_body) return malformed::stops<malformed::base_body>[row];
    const malformed::Stop* const links[] = {malformed::stops<malformed::link_index<I>>...};
    return links[broken.where][row];
  }
};
template <int N>
using Stops = StopTable<std::make_integer_sequence<int, N>>;

constexpr Problem pose_problem(const FixedPose& pose) {
  if (!finite(pose.rotation, 9) || !finite(pose.position, 3)) return Problem::base_or_tool_is_not_finite;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      double dot = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k)
        dot += pose.rotation[3 * i + k] * pose.rotation[3 * j + k];
      if (dot > 1e-6 || dot < -1e-6) return Problem::base_or_tool_is_no_rotation;
    }
  return Problem::none;
}

template <class T>
inline constexpr bool is_link = std::is_same_v<T, Link>;
template <class T>
inline constexpr bool is_foreign_link = std::is_base_of_v<LinkBuilder<T>, T> && !is_link<T>;
template <class... Parts>
inline constexpr bool accepts = (false || ... || std::is_same_v<Parts, Acceptance>);

/// Takes the parts of a chain one by one and remembers the first rule that is broken.
template <int N>
struct ChainBuilder {
  bool accepted = false;  ///< the whole robot, as published
  Chain<N> chain = [] {
    Chain<N> none{};
    none.says_gravity = false;
    return none;
  }();
  int next = 0;
  Broken broken{};
  unsigned once = 0;  ///< a bit for each kind of part, in the order of Problem's "twice"

  constexpr void note(int where, Problem problem) {
    if (broken.problem == Problem::none && problem != Problem::none) broken = {where, problem};
  }
  /// Notes what is wrong with a part that is no link: what cannot be accepted first.
  constexpr void note_part(Problem structural, Problem twice, Problem doubtful = Problem::none) {
    const unsigned bit = 1U << (static_cast<unsigned>(twice) - static_cast<unsigned>(Problem::gravity_is_given_twice));
    note(Broken::robot, structural);
    if (!accepted && (once & bit) != 0) note(Broken::robot, twice);
    if (!accepted) note(Broken::robot, doubtful);
    once |= bit;
  }

  constexpr void add(const Acceptance&) {}
  /// screw_spline(), differential() or drive_ratios().
  template <class Transmission>
  constexpr void add(const Transmission& transmission) {
    if (!couple(transmission, chain.links, next)) note(Broken::robot, Problem::transmission_is_misplaced);
  }
  constexpr void add(const Link& link) {
    note(next, link_problem(link.parameters(), link.given(), next, accepted));
    chain.links[next++] = link.parameters();
  }
  constexpr void add(const GravityVector& g) {
    const bool sound = finite(g.x) && finite(g.y) && finite(g.z);
    note_part(sound ? Problem::none : Problem::gravity_is_not_finite, Problem::gravity_is_given_twice);
    chain.gravity = g, chain.says_gravity = true;
  }
  constexpr void add(const Base& base) {
    note_part(pose_problem(base.pose), Problem::base_is_given_twice,
              is_far(base.pose.position) ? Problem::base_is_beyond_100_m : Problem::none);
    chain.base = base;
  }
  constexpr void add(const Tool& tool) {
    note_part(pose_problem(tool.pose), Problem::tool_is_given_twice,
              is_far(tool.pose.position) ? Problem::tool_is_beyond_100_m : Problem::none);
    chain.tool = tool;
  }
  constexpr void add(const PayloadLimit& limit) {
    const double values[] = {limit.mass, limit.com_reach, limit.inertia};
    note_part(not_negative(values, 3) ? Problem::none : Problem::payload_limit_is_negative_or_not_finite,
              Problem::payload_limit_is_given_twice,
              is_far(limit.com_reach) ? Problem::payload_limit_reach_is_beyond_100_m : Problem::none);
    chain.payload_limit = limit;
  }
  constexpr void add(const TipWrenchLimit& limit) {
    const double values[] = {limit.force, limit.moment};
    note_part(not_negative(values, 2) ? Problem::none : Problem::tip_wrench_limit_is_negative_or_not_finite,
              Problem::tip_wrench_limit_is_given_twice);
    chain.tip_wrench_limit = limit;
  }
  constexpr void add(const ToolLimit& limit) {
    note_part(not_negative(&limit.reach, 1) ? Problem::none : Problem::tool_limit_is_negative_or_not_finite,
              Problem::tool_limit_is_given_twice,
              is_far(limit.reach) ? Problem::tool_limit_is_beyond_100_m : Problem::none);
    chain.tool_limit = limit;
  }
  constexpr void add(const BaseBody& body) {
    note_part(Problem::none, Problem::base_body_is_given_twice);
    note(Broken::base_body,
         link_problem(body.parameters(), body.given(), 0, accepted, (std::numeric_limits<double>::max)()));
    chain.base_body = body.parameters();
    chain.has_base_body = true;
  }
  /// Checks the drives when all parts are there.
  constexpr void check_drives() {
    if (!chain.shares_drives()) return;
    for (int i = 0; i < N; ++i) {
      const Problem problem = drive_numbers_problem(chain.links[i]);
      note(i, problem);
      if (problem != Problem::none) return;
    }
    const auto g = drive_matrix_of(chain.links);
    for (int i = 0; i < N; ++i)
      note(i, shared_drives_problem(g, chain.links[i], i));
    if (!g.moves_all()) note(Broken::robot, Problem::drives_do_not_move_the_joints_independently);
  }
};

}  // namespace detail

/// Builds a robot from links (from the base outwards) and, in any order, gravity(), base(), base_body(),
/// tool(), payload_limit(), tip_wrench_limit(), tool_limit() and accept(as_published). Transmissions stand behind their
/// links: screw_spline(), differential(), drive_ratios() (couplings.hpp).
/// A description that cannot be right (not finite, negative mass, limits upside down, no link, an inertia that no body
/// has, degrees for radians, millimetres for metres, a quantity given twice, ...) does not compile: the message names
/// link, quantity and remedy. doc/guides/description_rules.md has the rules.
template <class... Parts>
constexpr auto chain(const Parts&... parts) {
  constexpr int count = (0 + ... + static_cast<int>(detail::is_link<Parts>));
  static_assert(!(false || ... || detail::is_foreign_link<Parts>),
                "axial: a link of chain() is revolute() or prismatic(), in MDH frames; classical links make a "
                "classical_chain()");
  static_assert(count > 0, "axial: a chain needs at least one link; add axial::revolute() or axial::prismatic()");
  detail::ChainBuilder<(count > 0 ? count : 1)> builder{detail::accepts<Parts...>};
  (builder.add(parts), ...);
  builder.check_drives();
  const auto stop = detail::Stops<count>::of(builder.broken);
  if (stop != nullptr) stop();  // here, not further down: no trace of calls stands before the compiler's message
  return builder.chain;
}

namespace detail {
/// As many links that have every limit.
template <class Chain>
constexpr Chain with_every_limit(Chain sound) {
  for (LinkParameters& p : sound.links)
    p.mass = p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = p.speed_limit = p.acceleration_limit = 1.0,
    p.position_min = -1.0, p.position_max = p.effort_limit = 1.0;
  sound.payload_limit = {1.0, 1.0, 1.0, true}, sound.tip_wrench_limit = {1.0, 1.0, true};
  sound.tool_limit = {1.0, true}, sound.says_gravity = true;
  return sound;
}
/// What kernels compute with where chain() has stopped the compiler, so that nothing more is said.
template <class R>
struct StandIn {
  static constexpr auto chain = with_every_limit(std::decay_t<decltype(R::chain)>{});
};
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
