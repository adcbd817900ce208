// The SCARA's closed form in fixed point: its formats and errors by running it on bounds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/closed_form/scara.hpp>
#include <axial/fixed/bounds/separation.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial::closed_form {
namespace detail {

/// How the closed form rounds on bounds. The first link has the formats of what is common, each its effort's.
class ScaraBounds : public bounds::BoundedLink<bounds::BoundedScene<false, false>, 3> {
  using Link = bounds::BoundedLink<bounds::BoundedScene<false, false>, 3>;

 public:
  /// Notes what it finds out in `account`.
  constexpr explicit ScaraBounds(bounds::Account<3>& account) : Link(&account, 0), account_(&account) {}
  /// A sine or cosine of a sum of angles: two terms of a unit vector, off by no more than its length; one is exact.
  ///@{
  constexpr bounds::Number turn(const bounds::NumberSum& x, const bounds::NumberSum& y) const {
    const int unit = rounding().bits - 2;
    const bounds::NumberSum both = x + y;
    return bounds::word_of({1.0, both.bound.error + both.terms.rounding(unit, rounding())}, unit);
  }
  static constexpr bounds::Number turn(const bounds::Number& x, Zero) { return x; }
  static constexpr bounds::Number turn(Zero, const bounds::Number& x) { return x; }
  ///@}
  /// tau[i] = x, rounded into the format of the effort.
  template <class I, class X>
  constexpr void write(Row<bounds::Number, 3>& tau, I i, const X& x) const {
    tau[i] = Link(account_, i).sum(quantity::JointEffort{}, x);
  }

 private:
  bounds::Account<3>* account_;
};

template <class S>
using BoundedScara = ScaraTerms<S, ScaraBounds>;

/// Ranges of the torque of a scene's robot `m`: one "link" holds what is common, the errors of efforts are a joint's.
template <class S>
constexpr Ranges<3> scara_ranges(const Mechanism<3>& m, const WordRounding& r) {
  bounds::Account<3> account{m, r};
  const bounds::detail::JointBounds<3> at(m, r);
  const auto run = [&] {
    Row<bounds::Number, 3> tau{};
    torque_into(BoundedScara<S>{ScaraBounds(account)}, at.q[1].angle, at.qd, at.qdd, tau);
  };
  run(), account.choose_formats(), run();
  return account.ranges;
}

/// Bounds of its separated terms in the formats of `ranges`, stored at `formats`.
template <class S>
constexpr bounds::SeparatedBounds<3> scara_terms(const Mechanism<3>& m, const WordRounding& r, const Ranges<3>& ranges,
                                                 const bounds::SeparatedFormats<3>& formats) {
  using Links = bounds::BoundedLinks<bounds::BoundedScene<false, false>, 3>;
  auto account = bounds::account_in_formats(m, r, ranges);
  const Links links(account);
  bounds::SeparatedBounds<3> all;
  separate_into(BoundedScara<S>{ScaraBounds(account)}, bounds::Angle{&r},
                bounds::CollectedBounds<Links, 3>{links, formats, all});
  return all;
}

/// Formats of a scene's closed form in arithmetic A.
template <class S, class A>
struct ScaraTable {
  static constexpr Ranges<3> value = scara_ranges<S>(
      axial::detail::loaded_mechanism<scene_of<S>, FullParameters, typename A::Word>(), rounding_of<A>());
  static constexpr int parent(int) { return -1; }
};

/// How the closed form rounds in its formats.
template <class S, class Word>
struct ScaraRounding<S, Stored<Word>>
    : axial::detail::FormatRounding<axial::detail::ArithmeticOf<scene_of<S>, Word>,
                                    ScaraTable<S, axial::detail::ArithmeticOf<scene_of<S>, Word>>, 0>,
      FixedValues<scene_of<S>, axial::detail::ArithmeticOf<scene_of<S>, Word>> {
  using Scalar = axial::detail::ArithmeticOf<scene_of<S>, Word>;
  /// A sine or cosine of a sum of angles.
  template <class X, class Y>
  AXIAL_INLINE static constexpr auto turn(const X& x, const Y& y) {
    return turned(x + y);
  }
};

}  // namespace detail
}  // namespace axial::closed_form

#include <axial/options/end.hpp>
