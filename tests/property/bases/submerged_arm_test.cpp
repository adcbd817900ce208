// Underwater against closed forms written by hand, and what physics demands of energy and impulse.
#include <oracle/compare.hpp>
#include <random>

#include <property/support.hpp>
#include "free_motion.hpp"

namespace {

using namespace axial;

/// A planar arm in a vertical plane, links along x, gravity along -y; the same numbers in the closed form below.
struct Numbers {
  double m, l, i;     // kg, m to the centre of mass, kg m^2 about it
  double ax, ay, b;   // added mass along and across the link, added inertia
  double d, c;        // displaced mass, m to the centre of buoyancy
  double ly, qy, lr;  // drag across the link: linear, quadratic; linear drag of the turn
  double lx = 0.0, qx = 0.0;
};
constexpr Numbers upper{6.0, 0.3, 0.2, 0.4, 5.5, 0.15, 5.2, 0.27, 4.0, 30.0, 0.6};
constexpr Numbers fore{3.5, 0.25, 0.08, 0.3, 3.0, 0.07, 3.1, 0.22, 3.0, 25.0, 0.4, 1.5, 6.0};
constexpr double length = 0.55, g = 9.81;

constexpr Link wet(const Numbers& n, bool drag) {
  // Planar: of the inertia only what the plane sees.
  Link link = revolute().mass(n.m).com(n.l, 0, 0).inertia_com(0, 0, n.i).accept(as_published);
  link = link.added_mass(n.ax, n.ay, 0, 0, 0, n.b).buoyancy(n.d, n.c, 0, 0);
  return drag ? link.drag_linear(n.lx, n.ly, 0, 0, 0, n.lr).drag_quadratic(n.qx, n.qy, 0) : link;
}
struct Pendulum {
  static constexpr auto chain = axial::chain(gravity(0, -g, 0), wet(upper, true));
};
template <bool Drag>
struct Arm {
  static constexpr auto chain = axial::chain(gravity(0, -g, 0), wet(upper, Drag), wet(fore, Drag).a(length));
};
template <class R>
using Wet = Scene<R, Gravity, Underwater>;

double resisted(double linear, double quadratic, double u) { return linear * u + quadratic * std::fabs(u) * u; }

/// Lagrange's equations of T = 1/2 J1 w1^2 + 1/2 (P s^2 + Q c^2) w1^2 + K c w1 w2 + 1/2 J2 w2^2, w2 = qd1 + qd2, s and
/// c of q2: the elbow moves with length w1 (s, c) in the axes of the second link, whose water weighs ax along it and ay
/// across it. Drag by its power; buoyancy as a weight upwards. The form of G. Antonelli, "Underwater Robots", chapter
/// 2, for two links.
struct TwoLinkForm {
  double q1, q2, w1, w2, s, c;
  static constexpr double J1 = upper.m * upper.l * upper.l + upper.i + upper.ay * upper.c * upper.c + upper.b;
  static constexpr double J2 = fore.m * fore.l * fore.l + fore.i + fore.ay * fore.c * fore.c + fore.b;
  static constexpr double P = (fore.m + fore.ax) * length * length, Q = (fore.m + fore.ay) * length * length;
  static constexpr double K = (fore.m * fore.l + fore.ay * fore.c) * length;

  TwoLinkForm(double p1, double p2, double v1, double v2)
      : q1(p1), q2(p2), w1(v1), w2(v1 + v2), s(std::sin(p2)), c(std::cos(p2)) {}

  double m11() const { return J1 + P * s * s + Q * c * c + 2 * K * c + J2; }
  double m12() const { return K * c + J2; }
  double slope() const { return 2 * (P - Q) * s * c - 2 * K * s; }  // of M11 with q2
  double energy() const {
    const double kinetic = 0.5 * (J1 + P * s * s + Q * c * c) * w1 * w1 + K * c * w1 * w2 + 0.5 * J2 * w2 * w2;
    return kinetic + g * (((upper.m * upper.l - upper.d * upper.c) + (fore.m - fore.d) * length) * std::sin(q1) +
                          (fore.m * fore.l - fore.d * fore.c) * std::sin(q1 + q2));
  }
  oracle::Vector<double> drag() const {
    const double along = resisted(fore.lx, fore.qx, length * w1 * s);
    const double across = resisted(fore.ly, fore.qy, length * w1 * c + fore.c * w2);
    const double first = upper.c * resisted(upper.ly, upper.qy, upper.c * w1) + upper.lr * w1, turn = fore.lr * w2;
    return {first + along * length * s + across * (length * c + fore.c) + turn, across * fore.c + turn};
  }
  oracle::Vector<double> torque(double a1, double a2) const {
    const double v2 = w2 - w1, tip = g * (fore.m * fore.l - fore.d * fore.c) * std::cos(q1 + q2);
    const double root = g * ((upper.m * upper.l - upper.d * upper.c) + (fore.m - fore.d) * length) * std::cos(q1);
    const auto d = drag();
    return {m11() * a1 + m12() * a2 + slope() * w1 * v2 - K * s * v2 * v2 + root + tip + d[0],
            m12() * a1 + J2 * a2 - 0.5 * slope() * w1 * w1 + tip + d[1]};
  }
};

template <class R>
Joints<R, double> pair(double a, double b) {
  return {a, b};
}

}  // namespace

TEST(SubmergedArm, OneLinkEqualsItsClosedForm) {
  std::mt19937 engine(61);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  for (int k = 0; k < 100; ++k) {
    const double q = any(engine), w = any(engine), a = any(engine);
    const double expected = TwoLinkForm::J1 * a + upper.c * resisted(upper.ly, upper.qy, upper.c * w) + upper.lr * w +
                            g * (upper.m * upper.l - upper.d * upper.c) * std::cos(q);
    const Joints<Pendulum, double> jq{q}, jw{w}, ja{a};
    EXPECT_NEAR(inverse_dynamics<Wet<Pendulum>>(jq, jw, ja)[0], expected, 1e-13 * 50.0);
  }
}

TEST(SubmergedArm, TwoLinksEqualTheirClosedForm) {
  std::mt19937 engine(62);
  std::uniform_real_distribution<double> any(-3.0, 3.0);
  using R = Arm<true>;
  for (int k = 0; k < 200; ++k) {
    const double q1 = any(engine), q2 = any(engine), v1 = any(engine), v2 = any(engine);
    const double a1 = any(engine), a2 = any(engine);
    const TwoLinkForm form(q1, q2, v1, v2);
    const auto q = pair<R>(q1, q2), qd = pair<R>(v1, v2), qdd = pair<R>(a1, a2);
    const auto tau = inverse_dynamics<Wet<R>>(q, qd, qdd);
    EXPECT_LE(oracle::relative_error(property::vector(tau), form.torque(a1, a2)), 1e-13);
    EXPECT_LE(oracle::relative_error(property::vector(bias_torque<Wet<R>>(q, qd)), form.torque(0, 0)), 1e-13);
    EXPECT_LE(
        oracle::relative_error(property::vector(gravity_torque<Wet<R>>(q)), TwoLinkForm(q1, q2, 0, 0).torque(0, 0)),
        1e-13);
    EXPECT_LE(
        oracle::relative_error(property::vector(forward_dynamics<Wet<R>>(q, qd, tau)), oracle::Vector<double>{a1, a2}),
        1e-12);
    const auto M = mass_matrix<Wet<R>>(q);
    EXPECT_NEAR(M(0, 0), form.m11(), 1e-13 * form.m11());
    EXPECT_NEAR(M(1, 0), form.m12(), 1e-13 * form.m11());
    EXPECT_NEAR(M(1, 1), TwoLinkForm::J2, 1e-13 * form.m11());
    const auto drag = form.drag();
    EXPECT_GE(drag[0] * v1 + drag[1] * v2, 0.0) << "drag takes power";
  }
}

namespace {

template <class R>
struct Swing {
  Joints<R, double> q{0.3, -0.8}, qd{1.0, -0.5};

  Swing moved(const Swing& rate, double h) const {
    Swing x = *this;
    for (int i = 0; i < 2; ++i)
      x.q[i] += h * rate.q[i], x.qd[i] += h * rate.qd[i];
    return x;
  }
  Swing rate() const {
    Swing d;
    const Joints<R, double> limp{};
    d.q = qd, d.qd = forward_dynamics<Wet<R>>(q, qd, limp);
    return d;
  }
  Swing rk4(double h) const {
    const Swing a = rate(), b = moved(a, h / 2).rate(), c = moved(b, h / 2).rate(), d = moved(c, h).rate();
    return moved(a, h / 6).moved(b, h / 3).moved(c, h / 3).moved(d, h / 6);
  }
  double energy() const { return TwoLinkForm(q[0], q[1], qd[0], qd[1]).energy(); }
};

}  // namespace

TEST(SubmergedArm, WithoutDragKeepsItsEnergy) {
  Swing<Arm<false>> x;
  const double start = x.energy();
  double drift = 0.0;
  for (int k = 0; k < 20000; ++k) {
    x = x.rk4(5e-4);
    drift = std::fmax(drift, std::fabs(x.energy() - start));
  }
  std::printf("energy %.1e of its start in 10 s\n", drift / std::fabs(start));
  EXPECT_LE(drift, 1e-9 * std::fabs(start));
}

TEST(SubmergedArm, WithDragLosesEnergyUntilItHangs) {
  Swing<Arm<true>> x;
  double last = x.energy();
  for (int k = 0; k < 400; ++k) {
    for (int i = 0; i < 50; ++i)
      x = x.rk4(1e-3);
    EXPECT_LE(x.energy(), last + 1e-12) << "after " << 0.05 * k << " s";
    last = x.energy();
  }
  EXPECT_LT(std::fabs(x.qd[0]), 1e-2);
}

namespace {

/// A body with its centres at the origin, and a flywheel without mass that stands still.
struct Torpedo {
  static constexpr double m = 40.0, ix = 0.5, iy = 6.0, iz = 6.4, ax = 2.0, ay = 35.0, az = 28.0, bx = 0.1, by = 4.0,
                          bz = 5.0;
  static constexpr auto chain =
      axial::chain(base_body().mass(m).inertia_com(ix, iy, iz).added_mass(ax, ay, az, bx, by, bz).buoyancy(m, 0, 0, 0),
                   revolute().rotor_inertia(1.0));
};

}  // namespace

// G. Kirchhoff 1869; H. Lamb, Hydrodynamics, art. 124: d/dt dT/dv + w x dT/dv = 0, d/dt dT/dw + w x dT/dw + v x dT/dv =
// 0 in axes of the body.
TEST(SubmergedBody, EqualsKirchhoff) {
  using S = Scene<Torpedo, FloatingBase, RuntimeGravity, Underwater, VelocityThroughWater, RotorInertia>;
  std::mt19937 engine(63);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  using B = Torpedo;
  for (int k = 0; k < 100; ++k) {
    const oracle::Vec3<double> v{any(engine), any(engine), any(engine)}, w{any(engine), any(engine), any(engine)};
    const oracle::Vec3<double> p{(B::m + B::ax) * v.x, (B::m + B::ay) * v.y, (B::m + B::az) * v.z};
    const oracle::Vec3<double> h{(B::ix + B::bx) * w.x, (B::iy + B::by) * w.y, (B::iz + B::bz) * w.z};
    const auto dp = cross(p, w), dh = cross(h, w) + cross(p, v), turning = cross(w, v);
    Inputs<S, double> in;
    in.gravity = {1.0, 2.0, -9.0};  // neutrally buoyant at its centre of mass: gravity is not felt
    in.base_motion.angular_velocity = property::to_axial(w);
    in.velocity_through_water = property::to_axial(v);
    const Joints<B, double> still{};
    const auto a = forward_dynamics<S>(still, still, still, in).base_acceleration;
    EXPECT_NEAR(a.linear.x, dp.x / (B::m + B::ax) + turning.x, 1e-12);
    EXPECT_NEAR(a.linear.y, dp.y / (B::m + B::ay) + turning.y, 1e-12);
    EXPECT_NEAR(a.linear.z, dp.z / (B::m + B::az) + turning.z, 1e-12);
    EXPECT_NEAR(a.angular.x, dh.x / (B::ix + B::bx), 1e-10);
    EXPECT_NEAR(a.angular.y, dh.y / (B::iy + B::by), 1e-12);
    EXPECT_NEAR(a.angular.z, dh.z / (B::iz + B::bz), 1e-12);
  }
}
