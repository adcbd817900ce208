// The formats of a scene's quantities, link by link: how a fixed-point link rounds.
#pragma once

#include <axial/fixed/bounds/derivatives.hpp>
#include <axial/fixed/bounds/kinematics.hpp>
#include <axial/fixed/bounds/separation.hpp>
#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/fixed/words/divide.hpp>
#include <axial/links/links.hpp>
#include <axial/scene/features.hpp>
#include <axial/spatial/articulated_inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// The arithmetic of a scene over words of a type.
template <class Scene, class Word>
using ArithmeticOf =
    Arithmetic<Word, !Scene::template has<RoundDown>, Scene::template has<HighWord>, Scene::template has<RangeCheck>>;

/// A scene's robot with its loads, and the formats of its joints' efforts, or of what stands for them.
template <class Scene, class Parameters, class Word, class Role = role::Effort>
constexpr auto loaded_mechanism() {
  using Robot = typename Scene::Robot;
  auto all = mechanism_of<Scene, Parameters>;
  for (int i = 0; i < Robot::chain.size; ++i)
    all.joints[i].effort_format = exponents_of<Scene, Word, Role>.of[i];
  return all;
}

/// What stands for the efforts of a recursion.
template <class Recursion>
using EffortRole =
    std::conditional_t<std::is_same_v<Recursion, recursion::MotionEfforts>, role::MotionEffort,
                       std::conditional_t<std::is_same_v<Recursion, recursion::Momenta>, role::Momentum, role::Effort>>;

template <class Scene, class Parameters, class S, class Recursion>
constexpr auto analysed(Wanted wanted) {
  using namespace recursion;
  using Word = typename S::Word;
  const WordRounding r = rounding_in<Scene, S>();
  if constexpr (std::is_same_v<Recursion, Kinematics>) {
    return kinematics_ranges(mechanism_of<Scene, Parameters>, r, wanted);
  } else {
    const auto m = loaded_mechanism<Scene, Parameters, Word, EffortRole<Recursion>>();
    if constexpr (std::is_same_v<Recursion, CompositeBodies>)
      return composite_body_ranges(m, r, wanted);
    else if constexpr (std::is_same_v<Recursion, ArticulatedBodies>)
      return articulated_ranges(m, r);
    else if constexpr (std::is_same_v<Recursion, ArticulatedBodiesAtRest>)
      return articulated_at_rest_ranges(m, r, usual_drive_of<Scene, Word>, wanted);
    else if constexpr (std::is_same_v<Recursion, Separation>)
      return separation_ranges_of(m, r);
    else if constexpr (std::is_same_v<Recursion, Momenta>)
      return momentum_ranges(m, r, wanted);
    else if constexpr (std::is_same_v<Recursion, Derivatives>)
      return derivative_ranges(m, r, wanted);
    else
      return newton_euler_ranges(m, r, wanted);
  }
}

/// Ranges of a scene's recursion in an arithmetic.
template <class Scene, class Parameters, class S, class Recursion, Wanted wanted = Wanted::errors>
inline constexpr auto ranges_of = analysed<Scene, Parameters, S, Recursion>(wanted);

template <class T>
inline constexpr bool is_vec3_v = false;
template <class X, class Y, class Z>
inline constexpr bool is_vec3_v<Vec3<X, Y, Z>> = true;

/// Doublings of a drive that is halved so often at first: back to itself, and more where it is small.
constexpr int doublings_after(int halvings) { return smaller(halvings + 8, 40); }

/// Rounding of link I, in its own formats: see Plain for what kernels say to it. `Table` holds the ranges.
template <class S, class Table, int I>
struct FormatRounding {
  static constexpr bool ranged = true;
  /// What a root sends nobody reads, and its formats have no room for it.
  static constexpr bool is_heard = Table::parent(I) >= 0;
  static constexpr const LinkFormat& format = Table::value.format[I];
  template <class Quantity, class... Terms>
  AXIAL_INLINE static constexpr auto sum(Quantity, const Terms&... terms) {
    constexpr int exponent = Table::value.format[I].of(Quantity{});
    if constexpr ((is_vec3_v<Terms> || ...))
      return Vec3{rounded_sum<exponent, S>(terms.x...), rounded_sum<exponent, S>(terms.y...),
                  rounded_sum<exponent, S>(terms.z...)};
    else
      return rounded_sum<exponent, S>(terms...);
  }
  template <class Quantity, class Inverse, class X>
  AXIAL_INLINE static constexpr auto quotient(Quantity quantity, const Inverse& inverse, const X& x) {
    if constexpr (is_vec3_v<X>)
      return Vec3{quotient(quantity, inverse, x.x), quotient(quantity, inverse, x.y), quotient(quantity, inverse, x.z)};
    else if constexpr (is_zero_v<X>)
      return Zero{};
    else if constexpr (is_structural_v<X>)
      return quotient(quantity, inverse, Literal<bits_of(static_cast<double>(X::value)), S>{});
    else
      return axial::quotient<Table::value.format[I].of(Quantity{})>(inverse, x);
  }
  /// A sum held within its format; `lost` says that it would not have fitted.
  template <class Quantity, class... Terms>
  AXIAL_INLINE static constexpr auto limited(Quantity, bool& lost, const Terms&... terms) {
    constexpr int exponent = Table::value.format[I].of(Quantity{});
    return saturated<exponent>(lost, lazy_sum(terms...));
  }
  static constexpr bool usually_resisted = Table::value.halvings > 0;  ///< whether less than `resisting` is possible
  /// What a joint feels, at least as much as formats are made for; `lost` says that it feels less.
  template <int E>
  AXIAL_INLINE static constexpr Fx<E, S> resisting(bool& lost, const Fx<E, S>& d) {
    constexpr Fx<E, S> least{static_cast<typename S::Word>(Table::value.range[I].least * power_of_two(E))};
    lost = d < least;
    return select(lost, least, d);
  }
  /// Drive u of a joint, 0 where its share u^2 / D of qdd^T M qdd is beyond what the formats are made for.
  /// `magnified` says how often u is doubled.
  template <int E, int F, class M>
  AXIAL_INLINE static constexpr Fx<F, S> gated_drive(bool& lost, const Fx<E, S>& d, const Fx<F, S>& u, M magnified) {
    std::int32_t v = u.raw;
    if constexpr (!is_zero_v<M>) v = v >> within_word(magnified);
    const bool beyond = S::bits == 32 ? is_less(by_upper_words(d.raw, share<E, F, 2>()), by_upper_words(v, v) >> 2)
                                      : is_less(std::int64_t{d.raw} * share<E, F, 0>(), std::int64_t{v} * v);
    lost = lost | beyond;
    return select(beyond, Fx<F, S>{}, u);
  }
  template <class M, class H, class J, class M2, class H2, class J2>
  AXIAL_INLINE static constexpr auto add(const RigidInertia<M, H, J>& a, const RigidInertia<M2, H2, J2>& b) {
    const quantity::RotationalInertia q;
    const auto& i = a.inertia;
    const auto& j = b.inertia;
    return RigidInertia{sum(quantity::Mass{}, a.mass, b.mass),
                        sum(quantity::FirstMoment{}, a.first_moment, b.first_moment),
                        Sym3{sum(q, i.xx, j.xx), sum(q, i.yy, j.yy), sum(q, i.zz, j.zz), sum(q, i.xy, j.xy),
                             sum(q, i.xz, j.xz), sum(q, i.yz, j.yz)}};
  }
  template <class N, class F, class N2, class F2>
  AXIAL_INLINE static constexpr auto subtract(const ForceVector<N, F>& force, const ForceVector<N2, F2>& other) {
    return ForceVector{sum(quantity::Moment{}, force.moment, -other.moment),
                       sum(quantity::Force{}, force.force, -other.force)};
  }
  /// The mass stays what it is: a literal, or with a payload a number; a link's and the payload's together are rounded.
  template <class M, class H, class J>
  AXIAL_INLINE static constexpr auto formatted(const RigidInertia<M, H, J>& body) {
    return RigidInertia{whole_mass(body.mass), sum(quantity::FirstMoment{}, body.first_moment),
                        symmetric(quantity::RotationalInertia{}, body.inertia)};
  }
  template <class A, class C, class L>
  AXIAL_INLINE static constexpr auto formatted(const ArticulatedInertia<A, C, L>& body) {
    const quantity::FirstMoment coupling;
    return ArticulatedInertia{
        symmetric(quantity::RotationalInertia{}, body.angular),
        Mat3{sum(coupling, body.coupling.x), sum(coupling, body.coupling.y), sum(coupling, body.coupling.z)},
        symmetric(quantity::Mass{}, body.linear)};
  }
  /// Rounding in the formats of the link that carries this one.
  AXIAL_INLINE static constexpr auto outer() {
    constexpr int parent = Table::parent(I);
    return FormatRounding<S, Table, (parent < 0 ? I : parent)>{};
  }

 private:
  template <class M>
  AXIAL_INLINE static constexpr auto whole_mass(const M& mass) {
    if constexpr (is_structural_v<M> || is_fx_v<M> || is_literal_v<M>)
      return mass;
    else
      return sum(quantity::Mass{}, mass);
  }
  // u^2 <= D share: the share at the exponent that u^2 has beyond D's, less some bits.
  template <int E, int F, int less>
  AXIAL_INLINE static constexpr std::int32_t share() {
    constexpr int scale = 2 * (F - Table::value.halvings) - E - less;
    constexpr double raw = Table::value.range[I].share * power_of_two(scale) * 0.999;
    constexpr double most = 2147483647.0;
    return static_cast<std::int32_t>(raw < most ? raw : most);
  }
  // Doublings as a shift of a word.
  AXIAL_INLINE static constexpr int within_word(int doublings) {
    if constexpr (doublings_after(Table::value.halvings) > 31) return select(is_less(doublings, 31), doublings, 31);
    return doublings;
  }
  AXIAL_INLINE static constexpr std::int64_t by_upper_words(std::int32_t a, std::int32_t b) {
    return integer::multiply_high(a, b);
  }
  template <class Quantity, class M>
  AXIAL_INLINE static constexpr auto symmetric(Quantity, const M& m) {
    constexpr int e = Table::value.format[I].of(Quantity{});
    return Sym3{rounded_sum<e, S>(m.xx), rounded_sum<e, S>(m.yy), rounded_sum<e, S>(m.zz),
                rounded_sum<e, S>(m.xy), rounded_sum<e, S>(m.xz), rounded_sum<e, S>(m.yz)};
  }
};

/// How the links of a scene round: a template for StaticLinks.
template <class Scene, class Parameters, class S, class Recursion>
struct Formats {
  struct Table {
    static constexpr const auto& value = ranges_of<Scene, Parameters, S, Recursion, Wanted::formats>;
    static constexpr int parent(int i) { return Scene::Robot::chain.parent(i); }
  };
  template <int I>
  using Of = FormatRounding<S, Table, I>;
  /// Whether forward dynamics solves twice in formats that hold whatever efforts can do.
  static constexpr bool second_solve() {
    return second_solve_pays(mechanism_of<Scene, Parameters>, rounding_of<S>(), Table::value);
  }
  /// Halvings of a drive that forward dynamics solves for first, before any that the drive itself needs.
  static constexpr int halvings() { return Table::value.halvings; }
  /// Halvings besides those that declared efforts need, with the bias of a declared motion: errors are proved with them
  /// (certify_forward).
  static constexpr int usual_halvings() {
    int all = 0;
    for (double reach = 1.0; reach < excess_of<Scene, typename S::Word>; reach *= 2.0)
      ++all;
    return all;
  }
  /// What drives joint I at most without halvings, as a raw value at an exponent.
  template <int I>
  static constexpr std::int64_t drive_limit(int exponent) {
    return static_cast<std::int64_t>(Table::value.range[I].drive * power_of_two(exponent));
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
