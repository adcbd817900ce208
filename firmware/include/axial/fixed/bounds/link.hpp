// A link of bounds: what a kernel sees of a robot when it computes how large its quantities get and how exact they are.
// `sum` is the only place that rounds: it notes what has to fit, or adds the rounding that its terms make.
#pragma once

#include <axial/fixed/balls/composite.hpp>
#include <axial/fixed/balls/spin.hpp>
#include <axial/fixed/bounds/account.hpp>
#include <axial/fixed/bounds/loads.hpp>
#include <axial/links/link_view.hpp>
#include <axial/recursion/loads.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// What a link keeps of a result: the result, for bounds have no form of their own.
template <class Link, class V>
constexpr const V& kept_by(const Link&, const V& v) {
  return v;
}

/// Link `index` of a robot in bounds.
template <class SceneType, int N>
class BoundedLink : public axial::detail::LinkAccess<BoundedLink<SceneType, N>, double> {
  using Access = axial::detail::LinkAccess<BoundedLink, double>;

 public:
  using Scene = SceneType;                       ///< what the links belong to
  using Scalar = Number;                         ///< in bounds
  static constexpr bool unrolled = false;        ///< one type serves all links
  static constexpr bool branches = true;         ///< the identity where there is no branch
  static constexpr bool adds_angles = true;      ///< binary angles are exact
  static constexpr bool ranged = true;           ///< results have formats
  static constexpr bool is_heard = true;         ///< what a root sends is not noted
  static constexpr bool has_axial_mass = false;  ///< words know none
  bool is_last;                                  ///< whether it bears payload and tip wrench

  /// Link `index` of the robot that the account is of, which the link refers to.
  constexpr BoundedLink(Account<N>* account, int index) : is_last(index + 1 == N), account_(account), index_(index) {}
  /// A constant of the link: a literal, or a word of its column.
  template <axial::detail::Member<double> M>
  constexpr Number get() const {
    const auto value = [this](const auto& c) {
      return M == &LinkConstants<double>::rotor && !loads().rotors ? 0.0 : c.*M;
    };
    return constant(M, value);
  }
  /// A constant of the link's branch: a literal, or a word of its column.
  template <axial::detail::BranchMember<double> M>
  constexpr Number branch() const {
    return constant(M, [](const auto& c) { return c.branch.*M; });
  }
  /// A constant of the link's drive: a literal, or a word of its column.
  template <axial::detail::DriveMember<double> M>
  constexpr Number drive() const {
    const double value = loads().friction ? mechanism().drives[index_].*M : 0.0;
    if (!shared()) return literal_of(value);
    const int exponent = axial::detail::fitting_exponent(mechanism().steps.viscous, rounding().capacity());
    return word_of({magnitude(value), value < 0.0 || value > 0.0 ? 0.5 * WordRounding::ulp(exponent) : 0.0}, exponent);
  }
  /// Nothing is known of a constant turn.
  ///@{
  template <axial::detail::Member<double>>
  constexpr AnyTurn beyond_45_degrees() const {
    return {};
  }
  template <axial::detail::BranchMember<double>>
  constexpr AnyTurn branch_beyond_45_degrees() const {
    return {};
  }
  ///@}
  /// A constant turn that is none by quarters is a binary angle to nearest.
  constexpr Angle with_offset(Angle q) const {
    const auto& c = constants();
    const bool by_quarters = c.sin_theta == 0.0 || c.cos_theta == 0.0;
    q.error += by_quarters ? 0.0 : 0.5 / axial::detail::bam_per_radian;
    return q;
  }
  /// Calls f with the kind of this joint.
  template <class F>
  constexpr auto on_joint(const F& f) const {
    return constants().prismatic ? f(Prismatic{}) : f(Revolute{});
  }
  /// Inertia of the link by itself.
  constexpr Body body() const {
    const auto h = this->first_moment();
    return {this->mass(), {h.x, h.y, h.z, {}}, {this->inertia(), {}}};
  }
  /// The joint's screw; a slide's travel is what its limits leave, not the sum of two bounds.
  constexpr auto z(const Position& q) const {
    auto screw = Access::z(q);
    if (constants().prismatic) {
      screw.shift.bound.size = mechanism().joints[index_].travel;
      note(quantity::Length{}, screw.shift.bound);
    }
    return screw;
  }

  /// Rounding of the arithmetic.
  constexpr const WordRounding& rounding() const { return account_->rounding; }
  /// Exponent of a quantity of this link.
  template <class Quantity>
  constexpr int exponent(Quantity quantity) const {
    return account_->ranges.format[index_].of(quantity);
  }
  /// Rounds a sum into the format of a quantity.
  template <class Quantity, class First, class... Terms>
  constexpr auto sum(Quantity quantity, const First& first, const Terms&... terms) const {
    if constexpr (detail::is_vector<First>) {
      VectorSum sum = vector_of(first);
      (detail::accumulate(sum, vector_of(terms)), ...);
      return rounded(quantity, sum);
    } else {
      NumberSum sum = term_of(first);
      (detail::accumulate(sum, term_of(terms)), ...);
      return rounded(quantity, sum);
    }
  }
  /// Notes a bound that a quantity has to have `room` times as much room for; of lengths the description says more.
  template <class Quantity>
  constexpr void note(Quantity quantity, const Ball& bound, double room = room_for<Quantity>) const {
    if (!noting_ || account_->quiet) return;
    if constexpr (!std::is_same_v<Quantity, quantity::Length>) widen(quantity, room * bound.size);
    account_->ranges.range[index_].of(quantity) = bound;
  }
  /// Has room for a sum of words that is larger than what is kept of it.
  template <class Quantity>
  constexpr void leave_room(Quantity quantity, double size) const {
    if (noting_ && !account_->quiet) widen(quantity, size);
  }
  /// Calls f without noting sizes: another way bounds them better.
  template <class F>
  constexpr void while_quiet(const F& f) const {
    account_->quiet = true, f(), account_->quiet = false;
  }
  /// Two bodies as one: where an entry is a literal and a word, the literal is rounded.
  constexpr Body add(const Body& own, const Body& load) const {
    using namespace quantity;
    const auto whole = [&](auto q, const Number& a, const Number& b) {
      Number both = sum(q, a, b);
      both.constant = a.constant;
      return both;
    };
    const FirstMoment f;
    const RotationalInertia j;
    const auto &h = own.first_moment, &g = load.first_moment;
    const auto &a = own.inertia.of, &b = load.inertia.of;
    return {sum(Mass{}, own.mass, load.mass),
            {whole(f, h.x, g.x), whole(f, h.y, g.y), whole(f, h.z, g.z), h.loose + g.loose},
            {{whole(j, a.xx, b.xx), whole(j, a.yy, b.yy), whole(j, a.zz, b.zz), whole(j, a.xy, b.xy),
              whole(j, a.xz, b.xz), whole(j, a.yz, b.yz)},
             own.inertia.loose + load.inertia.loose}};
  }
  /// A link's own body in the formats of the link: literals to nearest, its norm that of the matrix' rows.
  constexpr CompositeBody formatted(const Body& body) const {
    using namespace quantity;
    const ConstantVector& h = body.first_moment;
    const ConstantInertia& j = body.inertia;
    const double length = detail::hypotenuse(h.side(), h.height());
    const Ball moment = Ball{length, 0.0} + h.unknown();
    BoundedVector first{{moment, moment, moment}, h.x.exponent, h.x.is_literal, &rounding()};
    const double step =
        j.of.xx.is_literal && !account_->sizing ? 0.5 * WordRounding::ulp(exponent(RotationalInertia{})) : 0.0;
    const Ball inertia{j.norm() + j.loose.size, j.error() + 3.0 * step};
    const Ball axis{j.of.zz.bound.size + j.loose.size, j.of.zz.bound.error + j.loose.error + step};
    note(RotationalInertia{}, inertia);
    return {body.mass, sum(FirstMoment{}, first), word_of(inertia, exponent(RotationalInertia{})), axis};
  }
  /// A composite body in the formats of the link.
  constexpr CompositeBody formatted(const CompositeBody& body) const {
    using namespace quantity;
    const int to = exponent(RotationalInertia{});
    Ball inertia = body.inertia.bound, axis = body.axis;
    const double step = account_->sizing ? 0.0 : rounding().move(body.inertia.exponent, to);
    inertia.error += 3.0 * step, axis.error += step;
    note(RotationalInertia{}, inertia);
    return {whole_mass(body.mass), sum(FirstMoment{}, body.first_moment), word_of(inertia, to), axis};
  }
  /// A force less another.
  template <class F, class G>
  constexpr auto subtract(const F& force, const G& other) const {
    return ForceVector{sum(quantity::Moment{}, force.moment, -other.moment),
                       sum(quantity::Force{}, force.force, -other.force)};
  }
  /// Rounding in the formats of the link that carries this one. What a root sends nobody reads; a loop computes it.
  constexpr BoundedLink outer() const {
    const int parent = mechanism().parent(index_);
    BoundedLink link(account_, parent < 0 ? index_ : parent);
    link.noting_ = parent >= 0 || rounding().tabled;
    return link;
  }
  /// Results are bounds already; what the looped form moves into other formats is rounded.
  ///@{
  template <class V>
  constexpr decltype(auto) shape(const V& v) const {
    return kept_by(*this, v);
  }
  static constexpr ForceVector<BoundedVector, BoundedVector> shape(const ForceVector<ZeroVec3, ZeroVec3>&) {
    return {};
  }
  /// The looped form keeps forces in the format of forces, whatever column of an inertia they come from.
  constexpr ForceVector<BoundedVector, BoundedVector> shape(
      const ForceVector<BoundedVector, BoundedVector>& force) const {
    if (!shared()) return force;
    return {sum(quantity::Moment{}, force.moment), sum(quantity::Force{}, force.force)};
  }
  ///@}

 private:
  Account<N>* account_;
  int index_;
  bool noting_ = true;
  constexpr const Mechanism<N>& mechanism() const { return account_->mechanism; }
  constexpr const LoadRange& loads() const { return mechanism().loads; }
  constexpr bool shared() const { return mechanism().steps.shared; }
  constexpr const TreeLinkConstants<double>& constants() const { return mechanism().links[index_]; }
  template <class Quantity>
  constexpr void widen(Quantity quantity, double size) const {
    double& widest = account_->widest[index_].of(quantity);
    if (size > widest) widest = size;
  }
  // The mass stays a literal; with a payload it is the sum of one and a word.
  constexpr Number whole_mass(const Number& mass) const {
    if (mass.is_literal) return mass;
    NumberSum whole = term_of(mass);
    whole.terms.add_literal();
    return rounded(quantity::Mass{}, whole);
  }
  // A table holds words, but where all its links have the same 0, 1 or -1.
  template <class Member, class Value>
  constexpr Number constant(Member member, const Value& value) const {
    const double own = value(constants());
    if (!shared() || account_->is_common(value)) return literal_of(own);
    const auto columns = axial::detail::column_exponents(mechanism(), rounding(), mechanism().steps.format);
    const int exponent = columns.of(member);
    const bool rounds = own < 0.0 || own > 0.0;
    return {{magnitude(own), rounds ? 0.5 * WordRounding::ulp(exponent) : 0.0}, own, exponent, false};
  }
  template <class Quantity>
  constexpr BoundedVector rounded(Quantity quantity, const VectorSum& sum) const {
    const int to = exponent(quantity);
    SplitBall bound = axial::detail::tightened(sum.bound);
    if (!account_->sizing)
      bound = detail::with_rounding(bound, detail::root2 * sum.across.rounding(to, rounding()),
                                    sum.along.rounding(to, rounding()));
    note(quantity, bound.whole);
    return {bound, to, false, &rounding()};
  }
  template <class Quantity>
  constexpr Number rounded(Quantity quantity, const NumberSum& sum) const {
    const int to = exponent(quantity);
    Ball bound = sum.bound;
    if (!account_->sizing) bound.error += sum.terms.rounding(to, rounding());
    note(quantity, bound, 1.0);
    return word_of(bound, to);
  }
};

}  // namespace axial::bounds

#include <axial/options/end.hpp>
