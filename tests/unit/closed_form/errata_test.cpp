// The paper's equations for the SCARA as printed and as they must read: what each misprint leads to. The recursion here
// is the paper's own, (50) to (57), in the plane of the arm; it shares nothing with the library, which is compared with
// it.
#include <gtest/gtest.h>
#include <axial/closed_form/scara.hpp>
#include <axial/robot/chain.hpp>

#include <cmath>

namespace {

constexpr double m1 = 4.0, m2 = 2.5, m3 = 1.25, a1 = 0.375, a2 = 0.3125, g = 9.81;
constexpr double k = m3 + m2 / 2;

struct Rods {
  static constexpr auto chain =
      axial::chain(axial::gravity(0, 0, -g),
                   axial::revolute().mass(m1).com(a1 / 2, 0, 0).inertia_com(0, m1* a1* a1 / 12, m1* a1* a1 / 12),
                   axial::revolute().a(a1).mass(m2).com(a2 / 2, 0, 0).inertia_com(0, m2* a2* a2 / 12, m2* a2* a2 / 12),
                   axial::prismatic().a(a2).alpha_deg(180).mass(m3).com(0, 0, -0.1).inertia_com(0.01, 0.01, 0));
};

/// Which equations are taken as printed.
struct Printed {
  bool moment_balance = false;  ///< (53): + Pc x f of the next link
  bool third_centre = false;    ///< (45): centripetal terms of link 3 halved
  bool first_rod = false;       ///< (47): d3 for the length of link 1
};

struct Plane {
  double x, y;
};
Plane operator+(Plane u, Plane v) { return {u.x + v.x, u.y + v.y}; }
Plane operator*(double s, Plane v) { return {s * v.x, s * v.y}; }
double cross(Plane u, Plane v) { return u.x * v.y - u.y * v.x; }
Plane along(double length, double angle) { return {length * std::cos(angle), length * std::sin(angle)}; }
/// Acceleration of the far end of an arm; `w2` its squared angular velocity.
Plane of_end(Plane arm, double dw, double w2) { return Plane{-dw * arm.y, dw * arm.x} + (-w2) * arm; }

struct Torque {
  double first, second;
};
struct State {
  double q2, q3, qd1, qd2, qdd1, qdd2;
};

/// n = n_next + (P + Pc) x f -+ Pc x f_next + I dw, Pc = -P / 2 for a rod.
double moment(double next, Plane P, Plane f, Plane f_next, double inertia_dw, const Printed& printed) {
  const double carried = cross(-0.5 * P, f_next);
  return next + cross(0.5 * P, f) + (printed.moment_balance ? carried : -carried) + inertia_dw;
}

Torque torque(const State& s, const Printed& printed = {}) {
  const Plane P1 = along(a1, 0.0), P2 = along(a2, s.q2);
  const double w2 = s.qd1 + s.qd2, dw2 = s.qdd1 + s.qdd2, square1 = s.qd1 * s.qd1, square2 = w2 * w2;
  const Plane end1 = of_end(P1, s.qdd1, square1);
  const Plane centre1 = 0.5 * end1, centre2 = end1 + 0.5 * of_end(P2, dw2, square2);
  const Plane centre3 = end1 + of_end(P2, dw2, printed.third_centre ? 0.5 * square2 : square2);
  const Plane f3 = m3 * centre3, f2 = f3 + m2 * centre2, f1 = f2 + m1 * centre1;
  const double length1 = printed.first_rod ? s.q3 : a1;
  const double n2 = moment(0.0, P2, f2, f3, m2 * a2 * a2 / 12 * dw2, printed);
  return {moment(n2, P1, f1, f2, m1 * length1 * length1 / 12 * s.qdd1, printed), n2};
}

double A11(double q2, double q3 = 0.0, const Printed& p = {}) { return torque({q2, q3, 0, 0, 1, 0}, p).first; }
double A12(double q2, const Printed& p = {}) { return torque({q2, 0, 0, 0, 0, 1}, p).first; }
double A21(double q2, const Printed& p = {}) { return torque({q2, 0, 0, 0, 1, 0}, p).second; }
double A22(double q2, const Printed& p = {}) { return torque({q2, 0, 0, 0, 0, 1}, p).second; }
double b112(double q2, const Printed& p = {}) {
  return torque({q2, 0, 1, 1, 0, 0}, p).first - torque({q2, 0, 1, 0, 0, 0}, p).first -
         torque({q2, 0, 0, 1, 0, 0}, p).first;
}

/// (82) as printed, and as it must read.
double printed_a11(double q2) {
  return (m1 / 3 + m2 + m3) * a1 * a1 + (m2 + m3) * a1 * a2 * std::cos(q2) + (m2 / 3 + m3) * a2 * a2;
}
double mended_a11(double q2) {
  return (m1 / 3 + m2 + m3) * a1 * a1 + 2 * k * a1 * a2 * std::cos(q2) + (m2 / 3 + m3) * a2 * a2;
}
/// (85), printed right.
double printed_b112(double q2) { return -2 * k * a1 * a2 * std::sin(q2); }

constexpr double angles[] = {-2.5, -1.25, 0.3, 1.0, 2.75};
double derivative(double (*f)(double), double at) { return (f(at + 1e-5) - f(at - 1e-5)) / 2e-5; }

}  // namespace

TEST(Errata, TheMendedRecursionIsTheClosedForm) {
  for (const double q2 : angles) {
    const auto s = axial::closed_form::scara<Rods>(axial::Joints<Rods, double>{0.7, q2, 0.1});
    EXPECT_NEAR(s.A[0][0], A11(q2), 1e-15);
    EXPECT_NEAR(s.A[0][1], A12(q2), 1e-15);
    EXPECT_NEAR(s.A[1][1], A22(q2), 1e-15);
    EXPECT_NEAR(s.B[0][0], b112(q2), 1e-14);
    EXPECT_NEAR(mended_a11(q2), A11(q2), 1e-15);
    EXPECT_NEAR(s.A[2][2], m3, 1e-15);  // (64) and (92) print an acceleration or d3 beside it
    EXPECT_NEAR(s.G[2], -m3 * g, 1e-15);
  }
}

// Christoffel: with A12 = A12(q2), the coefficient of qd1 qd2 in the first row is dA11/dq2.
TEST(Errata, ThePrintedA11ContradictsThePrintedB112) {
  for (const double q2 : angles) {
    EXPECT_NEAR(derivative(mended_a11, q2), printed_b112(q2), 1e-9);
    EXPECT_GT(std::fabs(derivative(printed_a11, q2) - printed_b112(q2)), 0.05 * std::fabs(std::sin(q2)));
  }
}

TEST(Errata, ThePrintedA11IsIndefiniteForUnitRods) {
  const double printed = (1.0 / 3 + 2) + 2 + 4.0 / 3, mended = (1.0 / 3 + 2) + 3 + 4.0 / 3;  // m = a = 1, theta2 = 0
  const double a12 = 4.0 / 3 + 1.5, a22 = 4.0 / 3;
  EXPECT_NEAR(printed * a22 - a12 * a12, -17.0 / 36, 1e-14);
  EXPECT_NEAR(mended * a22 - a12 * a12, 31.0 / 36, 1e-14);
}

TEST(Errata, ThePrintedMomentBalanceMakesAUnsymmetric) {
  const Printed equation_53{true, false, false};
  for (const double q2 : angles) {
    EXPECT_NEAR(A12(q2), A21(q2), 1e-15);
    EXPECT_GT(std::fabs(A12(q2, equation_53) - A21(q2, equation_53)), 1e-3);
  }
}

TEST(Errata, ThePrintedThirdCentreDoesNotGiveThePrintedB112) {
  const Printed equation_45{false, true, false};
  for (const double q2 : angles) {
    EXPECT_NEAR(b112(q2), printed_b112(q2), 1e-14);
    EXPECT_NEAR(b112(q2, equation_45), -(m2 + m3) * a1 * a2 * std::sin(q2), 1e-14);
  }
}

TEST(Errata, ThePrintedFirstRodMakesA11DependOnTheSlide) {
  const Printed equation_47{false, false, true};
  EXPECT_EQ(A11(0.3, 0.1), A11(0.3, 0.2));
  EXPECT_GT(A11(0.3, 0.2, equation_47), A11(0.3, 0.1, equation_47));
}
