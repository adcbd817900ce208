// Derivatives by values of drives that joints share, held to differences of constraints with multipliers in 113 bits.
#pragma once

#include "constrained.hpp"

namespace constrained {

template <class M>
Matrix<quad> entries(const M& matrix, int n) {
  Matrix<quad> all(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      all(i, j) = quad(matrix(i, j));
  return all;
}
/// d f / d x column by column: exact to some 20 digits.
template <class F>
Matrix<quad> slopes(const Vector<quad>& x, const F& f) {
  const quad h = quad(1) / quad(1LL << 36);
  const int n = int(x.size());
  Matrix<quad> all(n, n);
  for (int j = 0; j < n; ++j) {
    auto above = x, below = x;
    above[std::size_t(j)] += h, below[std::size_t(j)] -= h;
    const auto high = f(above), low = f(below);
    for (int i = 0; i < n; ++i)
      all(i, j) = (high[std::size_t(i)] - low[std::size_t(i)]) / (h + h);
  }
  return all;
}
/// Largest difference over the largest entry.
inline double block_error(const Matrix<quad>& exact, const Matrix<quad>& found) {
  const auto values = oracle::elements(exact);
  return error_in(values, oracle::largest(values), oracle::elements(found));
}

/// A state of drives in both arithmetics, away from rest.
template <class S, class T>
struct At {
  At(const Vector<double>& u_, const Vector<double>& ud_, const Vector<double>& udd_)
      : u(property::joints<S, T>(u_)),
        ud(property::joints<S, T>(ud_)),
        udd(property::joints<S, T>(udd_)),
        exact_u(convert<quad>(property::vector(u, int(u_.size())))),
        exact_ud(convert<quad>(property::vector(ud, int(u_.size())))),
        exact_udd(convert<quad>(property::vector(udd, int(u_.size())))) {}
  Joints<S, T> u, ud, udd;
  Vector<quad> exact_u, exact_ud, exact_udd;
};

template <class T, class S, class D>
void expect_inverse(const Constrained& exact, const At<S, T>& at, const D& d) {
  const int n = exact.drives();
  const auto efforts = exact.inverse(at.exact_u, at.exact_ud, at.exact_udd);
  EXPECT_LE(error_in(efforts, oracle::largest(efforts), convert<quad>(property::vector(d.tau, n))), tolerance<T>);
  EXPECT_LE(block_error(exact.mass(at.exact_u), entries(d.M, n)), tolerance<T>);
  const auto by_u = slopes(at.exact_u, [&](const auto& u) { return exact.inverse(u, at.exact_ud, at.exact_udd); });
  const auto by_ud = slopes(at.exact_ud, [&](const auto& ud) { return exact.inverse(at.exact_u, ud, at.exact_udd); });
  EXPECT_LE(block_error(by_u, entries(d.dtau_dq, n)), tolerance<T>);
  EXPECT_LE(block_error(by_ud, entries(d.dtau_dqd, n)), tolerance<T>);
}
template <class T, class S, class D>
void expect_forward(const Constrained& exact, const At<S, T>& at, const Joints<S, T>& tau, const D& d) {
  const int n = exact.drives();
  const auto efforts = convert<quad>(property::vector(tau, n));
  const auto of = [&](const auto& u, const auto& ud, const auto& t) { return exact.forward(u, ud, t); };
  const auto answer = of(at.exact_u, at.exact_ud, efforts);
  const auto by_u = slopes(at.exact_u, [&](const auto& u) { return of(u, at.exact_ud, efforts); });
  const auto by_ud = slopes(at.exact_ud, [&](const auto& ud) { return of(at.exact_u, ud, efforts); });
  const auto by_tau = slopes(efforts, [&](const auto& t) { return of(at.exact_u, at.exact_ud, t); });
  EXPECT_TRUE(d.qdd.status.ok());
  EXPECT_LE(error_in(answer, oracle::largest(answer), convert<quad>(property::vector<S, T>(d.qdd, n))), tolerance<T>);
  EXPECT_LE(block_error(by_tau, entries(d.M_inverse, n)), tolerance<T>);
  EXPECT_LE(block_error(by_u, entries(d.dqdd_dq, n)), tolerance<T>);
  EXPECT_LE(block_error(by_ud, entries(d.dqdd_dqd, n)), tolerance<T>);
}
/// Products with a direction, against the matrices' entries that stand beside them.
template <class T, class S, class I, class F, class AlongI, class AlongF>
void expect_along(int n, const MotionDirection<S, T>& by, const I& inverse, const AlongI& along, const F& forward,
                  const AlongF& forward_along) {
  Vector<quad> dtau(std::size_t(n), quad(0)), dudd = dtau;
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l) {
      dtau[std::size_t(k)] += quad(inverse.dtau_dq(k, l)) * quad(by.dq[l]) +
                              quad(inverse.dtau_dqd(k, l)) * quad(by.dqd[l]) + quad(inverse.M(k, l)) * quad(by.dqdd[l]);
      dudd[std::size_t(k)] += quad(forward.dqdd_dq(k, l)) * quad(by.dq[l]) +
                              quad(forward.dqdd_dqd(k, l)) * quad(by.dqd[l]) +
                              quad(forward.M_inverse(k, l)) * quad(by.dqdd[l]);
    }
  EXPECT_TRUE(forward_along.qdd.status.ok());
  EXPECT_LE(error_in(dtau, oracle::largest(dtau), convert<quad>(property::vector(along.dtau, n))), 4 * tolerance<T>);
  EXPECT_LE(error_in(dudd, oracle::largest(dudd), convert<quad>(property::vector(forward_along.dqdd, n))),
            4 * tolerance<T>);
}

template <class R, class T, class... Features>
void expect_slopes(const oracle::Load<quad>& load, unsigned seed, int states) {
  using S = Scene<R, Features...>;
  const auto exact = Constrained::of<R>(load);
  ASSERT_EQ(exact.drives(), joint_count<S>);
  oracle::RandomChains random(seed);
  const auto in = inputs<S, T>();
  for (int state = 0; state < states; ++state) {
    SCOPED_TRACE(state);
    const auto x = motion<R>(random, exact.owner());
    const At<R, T> at(x.u, x.ud, x.udd);
    const auto inverse = inverse_dynamics_derivatives<S>(at.u, at.ud, at.udd, in);
    expect_inverse(exact, at, inverse);
    const Joints<R, T> tau = inverse.tau;
    const auto forward = forward_dynamics_derivatives<S>(at.u, at.ud, tau, in);
    expect_forward(exact, at, tau, forward);
    const int n = exact.drives();
    const auto any = [&](double size) { return property::joints<R, T>(random.vector(n, size)); };
    const MotionDirection<R, T> by{any(1.0), any(2.0), any(4.0)};
    expect_along(n, by, inverse, inverse_dynamics_along<S>(at.u, at.ud, at.udd, by, in), forward,
                 forward_dynamics_along<S>(at.u, at.ud, tau, {by.dq, by.dqd, by.dqdd}, in));
  }
}
template <class R, class T>
void expect_plain(unsigned seed, int states = 10) {
  expect_slopes<R, T, Gravity, RotorInertia>({}, seed, states);
}

}  // namespace constrained
