// The screw operators against dense 6x6 matrices, and their costs against Table II of McMillan and Orin 1995.
#include <gtest/gtest.h>
#include <array>
#include <axial/scalar/counting.hpp>
#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/congruence.hpp>
#include <cmath>

using namespace axial;

namespace {

using Matrix6 = std::array<std::array<double, 6>, 6>;
using Vector6 = std::array<double, 6>;
using Sym = Sym3<double>;
using Mat = Mat3<Vec3<double>>;

constexpr double tolerance = 64 * std::numeric_limits<double>::epsilon();  // a dozen roundings of numbers below 4

const Vec3<double> u{0.7, -1.3, 0.4}, v{-0.2, 0.9, 1.1};
const Sym s{0.9, 1.4, 1.1, 0.2, -0.3, 0.15}, t{2.1, 1.9, 2.4, -0.1, 0.25, 0.3};
const Mat m{{0.1, -0.6, 0.3}, {0.5, 0.2, -0.4}, {-0.7, 0.8, 0.15}};

// X of a frame at p with axes R (columns of the rotation in the parent's axes): v_child = X v_parent.
Matrix6 motion_transform(const double (&R)[3][3], const double (&p)[3]) {
  const double P[3][3] = {{0, -p[2], p[1]}, {p[2], 0, -p[0]}, {-p[1], p[0], 0}};
  Matrix6 X{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      X[i][j] = X[i + 3][j + 3] = R[j][i];
      for (int k = 0; k < 3; ++k)
        X[i + 3][j] -= R[k][i] * P[k][j];
    }
  return X;
}
Matrix6 z_transform(double angle, double d) {
  const double c = std::cos(angle), s_ = std::sin(angle);
  return motion_transform({{c, -s_, 0}, {s_, c, 0}, {0, 0, 1}}, {0, 0, d});
}
Matrix6 x_transform(double angle, double a) {
  const double c = std::cos(angle), s_ = std::sin(angle);
  return motion_transform({{1, 0, 0}, {0, c, -s_}, {0, s_, c}}, {a, 0, 0});
}

Vector6 times(const Matrix6& A, const Vector6& x, bool transposed = false) {
  Vector6 y{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      y[i] += (transposed ? A[j][i] : A[i][j]) * x[j];
  return y;
}
Matrix6 congruence(const Matrix6& X, const Matrix6& N) {
  Matrix6 result{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 6; ++k)
        for (int l = 0; l < 6; ++l)
          result[i][j] += X[k][i] * N[k][l] * X[l][j];
  return result;
}

Vector6 vector(const Vec3<double>& a, const Vec3<double>& b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }
template <class A, class B, class C>
Matrix6 matrix(const ArticulatedInertia<A, B, C>& inertia) {
  const Sym a = inertia.angular, l = inertia.linear;
  const Mat c = inertia.coupling;
  return {{{a.xx, a.xy, a.xz, c.x.x, c.x.y, c.x.z},
           {a.xy, a.yy, a.yz, c.y.x, c.y.y, c.y.z},
           {a.xz, a.yz, a.zz, c.z.x, c.z.y, c.z.z},
           {c.x.x, c.y.x, c.z.x, l.xx, l.xy, l.xz},
           {c.x.y, c.y.y, c.z.y, l.xy, l.yy, l.yz},
           {c.x.z, c.y.z, c.z.z, l.xz, l.yz, l.zz}}};
}

void expect_equal(const Vector6& a, const Vector6& b) {
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
}
void expect_equal(const Matrix6& a, const Matrix6& b) {
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << ' ' << j;
}

// Each claim for both screws: f(screw, its dense transform).
template <class F>
void for_both_screws(const F& f) {
  for (double angle : {0.6, -2.1}) {
    const double c = std::cos(angle), s_ = std::sin(angle);
    f(z_screw(c, s_, 0.35), z_transform(angle, 0.35));
    f(x_screw(c, s_, -0.45), x_transform(angle, -0.45));
  }
}

}  // namespace

TEST(Screw, CarriesMotionsToTheChild) {
  for_both_screws([](auto screw, const Matrix6& X) {
    const auto moved = to_child(screw, MotionVector{u, v});
    expect_equal(vector(moved.angular, moved.linear), times(X, vector(u, v)));
  });
}

TEST(Screw, CarriesForcesToTheParent) {
  for_both_screws([](auto screw, const Matrix6& X) {
    const auto carried = to_parent(screw, ForceVector{u, v});
    expect_equal(vector(carried.moment, carried.force), times(X, vector(u, v), true));
  });
}

TEST(Screw, ShiftedMotionsOnlyTranslate) {
  for_both_screws([](auto screw, const Matrix6& X) {
    Vector6 expected = times(X, vector(u, {0, 0, 0}));
    const auto linear = to_child(screw, cross_shift(screw, u));
    expect_equal(Vector6{expected[3], expected[4], expected[5]}, Vector6{linear.x, linear.y, linear.z});
  });
}

TEST(Congruence, OfASymmetricMatrixEqualsTheDenseOne) {
  for_both_screws([](auto screw, const Matrix6& X) {
    const ArticulatedInertia n{s, m, t};
    expect_equal(matrix(to_parent(screw, n)), congruence(X, matrix(n)));
  });
}

TEST(Congruence, OfReflectedInertiasEqualsTheDenseOne) {
  const Zero o{};
  const Vec3<Zero> none{};
  const ArticulatedInertia revolute{Sym3{0.9, 1.4, o, 0.2, o, o}, Mat3{m.x, m.y, none}, t};
  const ArticulatedInertia prismatic{s, Mat3{Vec3{0.1, 0.2, o}, Vec3{0.3, -0.4, o}, Vec3{0.5, 0.6, o}},
                                     Sym3{2.0, 3.0, o, 0.5, o, o}};
  for_both_screws([&](auto screw, const Matrix6& X) {
    expect_equal(matrix(to_parent(screw, revolute)), congruence(X, matrix(revolute)));
    expect_equal(matrix(to_parent(screw, prismatic)), congruence(X, matrix(prismatic)));
  });
}

TEST(Congruence, OfARigidBodyEqualsTheDenseOne) {
  for_both_screws([](auto screw, const Matrix6& X) {
    const RigidInertia body{1.7, u, s};
    expect_equal(matrix(articulated(to_parent(screw, body))), congruence(X, matrix(articulated(body))));
  });
}

TEST(Congruence, OfThreeByThreeMatricesIsARotation) {
  for_both_screws([](auto screw, const Matrix6&) {
    auto turn = screw;
    turn.shift = 0.0;
    const ArticulatedInertia n{s, m, t};
    const auto whole = to_parent(turn, n);
    const auto general = to_parent(screw, m);
    const auto symmetric = to_parent(screw, s);
    expect_equal(matrix(whole), matrix(ArticulatedInertia{symmetric, general, to_parent(screw, t)}));
  });
}

// A rotor of 2^-40 kg m^2 that is reflected beside inertias of 1 must come through a quarter turn unharmed.
TEST(Congruence, KeepsSmallElementsThroughAQuarterTurn) {
  const double small = std::ldexp(1.0, -40);
  const ArticulatedInertia n{Sym{small, 1.4, 1.1, 0.0, 0.0, 0.0},
                             Mat{{small, 0.0, 0.0}, {0.0, 0.7, 0.0}, {0.0, 0.0, 0.3}}, t};
  for (const double cos : {0.0, 1e-9}) {
    const auto turned_by_value = to_parent(z_screw(cos, 1.0, 0.0), n);
    EXPECT_NEAR(turned_by_value.angular.yy / small, 1.0, 1e-5) << cos;
    EXPECT_NEAR(turned_by_value.coupling.y.y / small, 1.0, 1e-5) << cos;
  }
  const auto turned_by_type =
      to_parent(x_screw(Zero{}, MinusOne{}, Zero{}), ArticulatedInertia{Sym{1.0, small, 1.4, 0, 0, 0}, m, t});
  EXPECT_EQ(turned_by_type.angular.zz, small);
}

TEST(Screw, IdentityCostsNothingAndChangesNothing) {
  const auto identity = x_screw(One{}, Zero{}, Zero{});
  static_assert(decltype(identity)::is_identity);
  static_assert(
      std::is_same_v<decltype(to_parent(identity, ArticulatedInertia{s, m, t})), ArticulatedInertia<Sym, Mat, Sym>>);
  EXPECT_EQ(to_parent(identity, u).y, u.y);
}

TEST(BranchScrew, IsItsTwoScrewsOneAfterTheOther) {
  const BranchScrew branch{z_screw(std::cos(0.6), std::sin(0.6), 0.35), x_screw(std::cos(-2.1), std::sin(-2.1), -0.45)};
  const Matrix6 Z = z_transform(0.6, 0.35), X = x_transform(-2.1, -0.45);
  const auto moved = to_child(branch, MotionVector{u, v});
  expect_equal(vector(moved.angular, moved.linear), times(X, times(Z, vector(u, v))));
  const auto carried = to_parent(branch, ForceVector{u, v});
  expect_equal(vector(carried.moment, carried.force), times(Z, times(X, vector(u, v), true), true));
  const ArticulatedInertia n{s, m, t};
  expect_equal(matrix(to_parent(branch, n)), congruence(Z, congruence(X, matrix(n))));
  const RigidInertia body{1.7, u, s};
  expect_equal(matrix(articulated(to_parent(branch, body))), congruence(Z, congruence(X, matrix(articulated(body)))));
  const auto p = translation(branch);
  EXPECT_NEAR(p.x, -0.45 * std::cos(0.6), tolerance);
  EXPECT_NEAR(p.y, -0.45 * std::sin(0.6), tolerance);
  EXPECT_NEAR(p.z, 0.35, tolerance);
}

// Table II: operand -> operations of both screws, trigonometric products included, against ours.
namespace {

class Costs {
 public:
  Counting run() { return Counting(trace); }
  Counting constant() { return Counting::constant(next_ += 0.37); }
  Vec3<Counting> vec() { return {run(), run(), run()}; }
  Sym3<Counting> sym() { return {run(), run(), run(), run(), run(), run()}; }
  Mat3<Vec3<Counting>> mat() { return {vec(), vec(), vec()}; }
  auto revolute() { return z_screw(run(), run(), constant()); }
  // Constant turns are known to be below or beyond 45 degrees.
  auto prismatic() { return z_screw(constant(), constant(), run()).with_turn(std::false_type{}); }
  auto branch() { return z_screw(constant(), constant(), constant()).with_turn(std::false_type{}); }
  auto twist() { return x_screw(constant(), constant(), constant()).with_turn(std::true_type{}); }

  Trace trace;

 private:
  double next_ = 0.0;
};

void need(const Counting& x) { x.need(); }
template <class A, class B, class C>
void need(const Vec3<A, B, C>& x) {
  need(x.x), need(x.y), need(x.z);
}
template <class A, class B, class C>
void need(const Mat3<A, B, C>& x) {
  need(x.x), need(x.y), need(x.z);
}
template <class A, class B, class C, class D, class E, class F>
void need(const Sym3<A, B, C, D, E, F>& x) {
  need(Vec3{x.xx, x.yy, x.zz}), need(Vec3{x.xy, x.xz, x.yz});
}
template <class A, class B>
void need(const ForceVector<A, B>& x) {
  need(x.moment), need(x.force);
}
template <class A, class B, class C>
void need(const ArticulatedInertia<A, B, C>& x) {
  need(x.angular), need(x.coupling), need(x.linear);
}
template <class A, class B, class C>
void need(const RigidInertia<A, B, C>& x) {
  need(x.first_moment), need(x.inertia);
}

template <class Make>
Operations cost(const Make& make) {
  static Costs costs;
  costs = Costs{};
  need(make(costs));
  return costs.trace.operations();
}

void expect_at_most(const Operations& ours, int mul, int add) {
  EXPECT_LE(ours.mul + ours.div, mul);
  EXPECT_LE(ours.add, add);
}

template <class Operand>
auto through_revolute(Operand operand) {
  return [=](Costs& c) { return to_parent(c.twist(), to_parent(c.revolute(), operand(c))); };
}

}  // namespace

TEST(TableII, CartesianVector) {
  expect_at_most(cost(through_revolute([](Costs& c) { return c.vec(); })), 8, 4);
}
TEST(TableII, SpatialVector) {
  expect_at_most(cost(through_revolute([](Costs& c) { return ForceVector{c.vec(), c.vec()}; })), 20, 12);
}
TEST(TableII, GeneralMatrix) {
  expect_at_most(cost(through_revolute([](Costs& c) { return c.mat(); })), 26, 24);
}
TEST(TableII, SymmetricMatrix) {
  expect_at_most(cost(through_revolute([](Costs& c) { return c.sym(); })), 18, 17);
}
TEST(TableII, SymmetricSixBySix) {
  const auto ours = cost(through_revolute([](Costs& c) { return ArticulatedInertia{c.sym(), c.mat(), c.sym()}; }));
  EXPECT_EQ(ours, (Operations{79, 83, 0, 0}));  // the paper: 86M 89A
}
TEST(TableII, RigidBody) {
  const auto ours = cost(through_revolute([](Costs& c) { return RigidInertia{c.constant(), c.vec(), c.sym()}; }));
  EXPECT_EQ(ours, (Operations{32, 33, 0, 0}));  // the paper: 32M 35A
}
TEST(TableII, ReflectedInertiaOfARevoluteJoint) {
  const auto ours = cost(through_revolute([](Costs& c) {
    const Zero o{};
    return ArticulatedInertia{Sym3{c.run(), c.run(), o, c.run(), o, o}, Mat3{c.vec(), c.vec(), ZeroVec3{}}, c.sym()};
  }));
  EXPECT_EQ(ours, (Operations{63, 65, 0, 0}));  // the paper: 70M 71A
}
TEST(TableII, ReflectedInertiaOfAPrismaticJoint) {
  const auto ours = cost([](Costs& c) {
    const Zero o{};
    const auto row = [&] { return Vec3{c.run(), c.run(), o}; };
    const ArticulatedInertia n{c.sym(), Mat3{row(), row(), row()}, Sym3{c.run(), c.run(), o, c.run(), o, o}};
    return to_parent(c.twist(), to_parent(c.prismatic(), n));
  });
  EXPECT_EQ(ours, (Operations{60, 62, 0, 0}));  // the paper: 68M 68A
}

// The constant z-screw of a branch. The paper's [32M, 37A] is the z-screw of its Table I with step A off-line, so for
// an inertia with a zero row; behind an x-screw no row is zero any more, and Table II gives a full one 42M 43A a screw.
TEST(TableII, BranchOfAReflectedInertia) {
  const auto ours = cost([](Costs& c) {
    const Zero o{};
    return to_parent(c.branch(), ArticulatedInertia{Sym3{c.run(), c.run(), o, c.run(), o, o},
                                                    Mat3{c.vec(), c.vec(), ZeroVec3{}}, c.sym()});
  });
  EXPECT_EQ(ours, (Operations{28, 34, 0, 0}));  // the paper: 32M 37A
}
TEST(TableII, BranchBehindAnXScrew) {
  const auto ours = cost([](Costs& c) { return to_parent(c.branch(), ArticulatedInertia{c.sym(), c.mat(), c.sym()}); });
  EXPECT_EQ(ours, (Operations{38, 40, 0, 0}));  // the paper: 42M 43A
}
TEST(TableII, JointAndBranchTogetherStayBelowThePaper) {
  const auto ours = cost([](Costs& c) {
    const Zero o{};
    const ArticulatedInertia n{Sym3{c.run(), c.run(), o, c.run(), o, o}, Mat3{c.vec(), c.vec(), ZeroVec3{}}, c.sym()};
    return to_parent(BranchScrew{c.branch(), c.twist()}, to_parent(c.revolute(), n));
  });
  EXPECT_EQ(ours, (Operations{101, 105, 0, 0}));
  expect_at_most(ours, 70 + 32, 71 + 37);
}
