// Joints that share drives as Lagrange's equations of all joints with their couplings as constraints, multipliers and
// all, in 113 bits; and the robots that tests hold to them.
#pragma once

#include <oracle/floating_base.hpp>
#include <oracle/rotors.hpp>
#include <robots/robots.hpp>
#include <utility>

#include <property/support.hpp>

namespace constrained {

using namespace axial;
using oracle::convert;
using oracle::Matrix;
using oracle::quad;
using oracle::Vector;

/// q = G u + q0 written by hand, and which link each drive's rotor and friction stand at.
struct Couplings {
  Matrix<quad> g;
  Vector<quad> q0;
  std::vector<int> owner;
};
inline Couplings couplings(int joints, const std::vector<int>& owner, const std::vector<std::vector<double>>& rows) {
  Couplings c{Matrix<quad>(joints, int(owner.size())), Vector<quad>(std::size_t(joints), quad(0)), owner};
  for (int i = 0; i < joints; ++i)
    for (int k = 0; k < int(owner.size()); ++k)
      c.g(i, k) = quad(rows[std::size_t(i)][std::size_t(k)]);
  return c;
}

/// A tree whose joints follow each other: a belt with a ratio that no float holds, offsets, a slide that follows a
/// turn.
struct Followers {
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(axial::gravity(1.0, -2.0, -9.0), axial::tool(0.1, 0.05, 0.2),
      revolute().mass(4).com(0.1, 0.02, 0.05).inertia_com(0.2, 0.25, 0.3, 0.01, 0.0, 0.02)
          .rotor_inertia(5e-4, 20).viscous(0.5).coulomb(0.25),
      revolute().alpha_deg(-90).a(0.2).mass(2).com(0.1, 0, 0.01).inertia_com(0.05, 0.06, 0.07).mimic(0, -0.3, 0.25)
          .spring(3.0, 0.125),
      prismatic().alpha(0.7).d(0.1).mass(1.5).com(0.02, 0.1, 0).inertia_com(0.02, 0.03, 0.04).mimic(1, 0.125, -0.5),
      revolute().parent(0).alpha_deg(90).a(0.3).mass(1).com(0.1, 0.01, 0.05).inertia_com(0.01, 0.01, 0.005)
          .rotor_inertia(1e-4, 40).viscous(0.125).driven_by(0, 0.75).driven_by(3, 2.0).driven_by(4, -1.0),
      revolute().alpha(-1.3).mass(0.5).com(0.05, 0, 0.02).inertia_com(0.002, 0.003, 0.002).rotor_inertia(1e-4, 15));
  // clang-format on
};

template <class R>
Couplings by_hand();
template <>
inline Couplings by_hand<robots::ScaraQuill>() {
  auto c = couplings(4, {0, 1, 2, 3}, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}});
  c.g(2, 2) = quad(0.020) / (4 * oracle::right_angle<quad>());
  c.g(2, 3) = -c.g(2, 2);
  return c;
}
template <>
inline Couplings by_hand<robots::Palletiser>() {
  return couplings(10, {0, 1, 2, 9},
                   {{1, 0, 0, 0},
                    {0, 1, 0, 0},
                    {0, 0, 1, 0},
                    {0, 1, -1, 0},
                    {0, -1, 1, 0},
                    {0, 1, 0, 0},
                    {0, -1, 0, 0},
                    {0, 0, 1, 0},
                    {0, 0, -1, 0},
                    {0, 0, 0, 1}});
}
template <>
inline Couplings by_hand<robots::WristArm>() {
  return couplings(5, {0, 1, 2, 3, 4},
                   {{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 1, 0, 0}, {0, 0, 0, 0.5, 0.5}, {0, 0, 0, 0.5, -0.5}});
}
template <>
inline Couplings by_hand<robots::Gripper>() {
  return couplings(3, {0, 1}, {{1, 0}, {0, 1}, {0, 1}});
}
template <>
inline Couplings by_hand<Followers>() {
  auto c = couplings(5, {0, 3, 4}, {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0.75, 2, -1}, {0, 0, 1}});
  c.g(1, 0) = quad(-0.3), c.q0[1] = quad(0.25);
  c.g(2, 0) = quad(0.125) * quad(-0.3), c.q0[2] = quad(0.125) * quad(0.25) - quad(0.5);
  return c;
}

/// x of A x = b by Gauss' elimination with pivots of rows: A has no definite sign.
inline Vector<quad> solve_any(Matrix<quad> A, Vector<quad> b) {
  const int n = A.rows();
  const auto at = [](int i) { return std::size_t(i); };
  for (int j = 0; j < n; ++j) {
    int best = j;
    for (int i = j; i < n; ++i)
      if (oracle::abs(A(i, j)) > oracle::abs(A(best, j))) best = i;
    for (int k = 0; k < n; ++k)
      std::swap(A(j, k), A(best, k));
    std::swap(b[at(j)], b[at(best)]);
    for (int i = j + 1; i < n; ++i) {
      const quad l = A(i, j) / A(j, j);
      for (int k = j; k < n; ++k)
        A(i, k) -= l * A(j, k);
      b[at(i)] -= l * b[at(j)];
    }
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k)
      b[at(i)] -= A(i, k) * b[at(k)];
    b[at(i)] /= A(i, i);
  }
  return b;
}

/// Joints q and drives u as free coordinates, q - G u - q0 = 0 between them with a multiplier a joint.
class Constrained {
 public:
  template <class R>
  static Constrained of(const oracle::Load<quad>& load = {}) {
    return of<R>(by_hand<R>(), load);
  }
  template <class R>
  static Constrained of(const Couplings& couplings, const oracle::Load<quad>& load = {}) {
    Constrained c;
    c.chain_ = oracle::of_robot<quad, R>();
    c.drives_ = c.chain_.links;
    for (auto& link : c.chain_.links)
      link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = quad(0);
    c.couplings_ = couplings;
    c.load_ = load;
    return c;
  }
  /// The drives' rotors are bodies of their own behind the links, about the axes given: as many joints more, each of
  /// which turns gear times as fast as the drive of its link, or not at all.
  template <class R>
  static Constrained with_rotors(Couplings couplings, const Vector<oracle::RotorAxis<quad>>& axes,
                                 oracle::Load<quad> load = {}) {
    const auto chain = oracle::of_robot<quad, R>();
    const int n = chain.size(), m = int(couplings.owner.size());
    Matrix<quad> g(2 * n, m);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k) {
        g(i, k) = couplings.g(i, k);
        if (couplings.owner[std::size_t(k)] == i) g(n + i, k) = chain[i].gear;
      }
    couplings.g = g, couplings.q0.resize(std::size_t(2 * n), quad(0));
    if (!load.links.empty()) load.links.resize(std::size_t(2 * n));
    auto c = of<R>(couplings, load);
    c.chain_ = oracle::RotorChain<quad>(chain, axes).bodies();
    for (auto& link : c.chain_.links)
      link.viscous = link.coulomb_forward = link.coulomb_backward = quad(0);
    for (auto& link : c.drives_)
      link.rotor_inertia = quad(0);
    return c;
  }
  /// On a free body, whose degrees of freedom are six more joints and drives before the others: those of
  /// floating.whole().
  template <class R>
  static Constrained afloat(const Couplings& couplings, const oracle::FloatingChain<quad>& floating) {
    const int n = int(couplings.q0.size()), m = int(couplings.owner.size());
    Couplings all{Matrix<quad>(n + 6, m + 6), Vector<quad>(6, quad(0)), {0, 1, 2, 3, 4, 5}};
    for (int i = 0; i < 6; ++i)
      all.g(i, i) = 1;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        all.g(i + 6, k + 6) = couplings.g(i, k);
    all.q0.insert(all.q0.end(), couplings.q0.begin(), couplings.q0.end());
    for (const int owner : couplings.owner)
      all.owner.push_back(owner + 6);
    auto c = of<R>(all);
    c.chain_ = floating.whole(), c.drives_ = c.chain_.links;
    for (auto& link : c.chain_.links)
      link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = quad(0);
    return c;
  }
  int joints() const { return chain_.size(); }
  int drives() const { return int(couplings_.owner.size()); }
  const std::vector<int>& owner() const { return couplings_.owner; }
  const oracle::Chain<quad>& chain() const { return chain_; }
  const Matrix<quad>& g() const { return couplings_.g; }
  Vector<quad> positions(const Vector<quad>& u) const {
    Vector<quad> q = couplings_.g * u;
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += couplings_.q0[i];
    return q;
  }

  /// Accelerations of the drives under efforts of theirs.
  Vector<quad> forward(const Vector<quad>& u, const Vector<quad>& ud, const Vector<quad>& tau) const {
    const int n = joints(), m = drives();
    Matrix<quad> A = equations(u);  // of qdd, lambda, udd
    Vector<quad> b = forces(u, ud);
    for (int k = 0; k < m; ++k)
      A(n + k, 2 * n + k) = rotor(k), b[std::size_t(n + k)] += tau[std::size_t(k)];
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        A(n + m + i, 2 * n + k) = -g()(i, k);
    return tail(solve_any(A, b));
  }
  /// Efforts of the drives that give them accelerations.
  Vector<quad> inverse(const Vector<quad>& u, const Vector<quad>& ud, const Vector<quad>& udd) const {
    const int n = joints(), m = drives();
    Matrix<quad> A = equations(u);  // of qdd, lambda, tau
    Vector<quad> b = forces(u, ud);
    for (int k = 0; k < m; ++k)
      A(n + k, 2 * n + k) = quad(-1), b[std::size_t(n + k)] -= rotor(k) * udd[std::size_t(k)];
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        b[std::size_t(n + m + i)] += g()(i, k) * udd[std::size_t(k)];
    return tail(solve_any(A, b));
  }
  Matrix<quad> mass(const Vector<quad>& u) const {
    const int m = drives();
    const Vector<quad> rest(std::size_t(m), quad(0));
    const auto held = inverse(u, rest, rest);
    Matrix<quad> M(m, m);
    for (int k = 0; k < m; ++k) {
      auto one = rest;
      one[std::size_t(k)] = 1;
      const auto column = inverse(u, rest, one);
      for (int i = 0; i < m; ++i)
        M(i, k) = column[std::size_t(i)] - held[std::size_t(i)];
    }
    return M;
  }

 private:
  const oracle::Link<quad>& drive(int k) const { return drives_[std::size_t(couplings_.owner[std::size_t(k)])]; }
  quad rotor(int k) const { return drive(k).gear * drive(k).gear * drive(k).rotor_inertia; }
  quad friction(int k, quad ud) const {
    if (!load_.friction) return 0;
    return drive(k).viscous * ud + (ud > 0 ? drive(k).coulomb_forward : ud < 0 ? drive(k).coulomb_backward : quad(0));
  }
  /// The columns that both problems share: M qdd - lambda; G^T lambda; qdd.
  Matrix<quad> equations(const Vector<quad>& u) const {
    const int n = joints(), m = drives();
    Matrix<quad> A(2 * n + m, 2 * n + m);
    const auto M = oracle::mass_matrix(chain_, positions(u));
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j)
        A(i, j) = M(i, j);
      A(i, n + i) = -1, A(n + m + i, i) = 1;
      for (int k = 0; k < m; ++k)
        A(n + k, n + i) = g()(i, k);
    }
    return A;
  }
  Vector<quad> forces(const Vector<quad>& u, const Vector<quad>& ud) const {
    const int n = joints(), m = drives();
    oracle::Load<quad> of_joints = load_;
    of_joints.friction = false;
    const auto c =
        oracle::inverse_dynamics(chain_, positions(u), g() * ud, Vector<quad>(std::size_t(n), quad(0)), of_joints);
    Vector<quad> b(std::size_t(2 * n + m), quad(0));
    for (int i = 0; i < n; ++i)
      b[std::size_t(i)] = -c[std::size_t(i)];
    for (int k = 0; k < m; ++k)
      b[std::size_t(n + k)] = -friction(k, ud[std::size_t(k)]);
    return b;
  }
  Vector<quad> tail(const Vector<quad>& x) const { return Vector<quad>(x.end() - drives(), x.end()); }

  oracle::Chain<quad> chain_;
  std::vector<oracle::Link<quad>> drives_;
  Couplings couplings_;
  oracle::Load<quad> load_;
};

/// A wrench on every link and on the tip, as the oracle and as scenes take them; all numbers are floats.
///@{
inline oracle::Load<quad> load_on_links(int links) {
  oracle::Load<quad> load;
  load.tip = {{quad(3), quad(-2), quad(5)}, {quad(0.5), quad(-0.25), quad(0.75)}};
  for (int i = 0; i < links; ++i)
    load.links.push_back({{quad(2), quad(i), quad(-1.5)}, {quad(0.5) * i, quad(-1), quad(0.25)}});
  return load;
}
template <class S, class T>
Inputs<S, T> inputs(int links = link_count<S>) {
  Inputs<S, T> in{};
  if constexpr (S::template has<TipWrench>) in.tip_wrench = {{T(0.5), T(-0.25), T(0.75)}, {T(3), T(-2), T(5)}};
  if constexpr (S::template has<ExternalWrenches>)
    for (int i = 0; i < links; ++i)
      in.wrenches[i] = {{T(0.5 * i), T(-1), T(0.25)}, {T(2), T(i), T(-1.5)}};
  return in;
}
///@}

template <class T>
constexpr double tolerance = std::is_same_v<T, double> ? 1e-12 : 5e-6;

struct Motion {
  Vector<double> u, ud, udd;
};
/// As fast as the drives may: a nut turns a thousand times as fast as an arm.
template <class R>
Motion motion(oracle::RandomChains& random, const std::vector<int>& owner) {
  const auto within = [&](double limit, double otherwise) {
    const double size = limit < 1e6 ? limit : otherwise;
    return random.uniform(-size, size);
  };
  Motion x;
  for (const int i : owner) {
    const LinkParameters& link = R::chain.links[i];
    x.u.push_back(random.uniform(-2, 2));
    x.ud.push_back(within(link.drive_speed_limit, 3));
    x.udd.push_back(within(link.drive_acceleration_limit, 10));
  }
  return x;
}
/// Largest error in units of the largest effort of the motion, of which a part may nearly vanish.
inline double error_in(const Vector<quad>& exact, double size, const Vector<quad>& found) {
  double worst = 0.0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    worst = std::fmax(worst, double(oracle::abs(exact[k] - found[k])));
  return worst / size;
}

}  // namespace constrained
