#include <gtest/gtest.h>
#include <axial/recursion/reflection.hpp>
#include <axial/scalar/counting.hpp>

using namespace axial;

namespace {

template <class J>
struct TestLink : Plain {
  using Scalar = double;
  static constexpr bool unrolled = true;
  J value{};
  J rotor() const { return value; }
};

const ArticulatedInertia inertia{Sym3<double>{3.0, 4.0, 2.5, 0.3, -0.4, 0.6},
                                 Mat3<Vec3<double>>{{0.1, -0.5, 0.7}, {0.9, 0.2, -0.3}, {0.4, -0.8, 0.15}},
                                 Sym3<double>{5.0, 6.0, 7.0, 0.2, 0.5, -0.1}};
const ForceVector<Vec3<double>, Vec3<double>> bias{{1.0, -2.0, 0.5}, {0.3, 0.8, -1.2}};
const MotionVector<Vec3<double>, Vec3<double>> zeta{{0.2, -0.1, 0.0}, {0.5, 0.4, -0.6}};

// Element (row, column) of the whole 6x6 matrix, rows angular first.
template <class I>
double element(const I& i, int row, int column) {
  const Sym3<double> a = i.angular, l = i.linear;
  const Mat3<Vec3<double>> c = i.coupling;
  const double A[3][3] = {{a.xx, a.xy, a.xz}, {a.xy, a.yy, a.yz}, {a.xz, a.yz, a.zz}};
  const double L[3][3] = {{l.xx, l.xy, l.xz}, {l.xy, l.yy, l.yz}, {l.xz, l.yz, l.zz}};
  const double C[3][3] = {{c.x.x, c.x.y, c.x.z}, {c.y.x, c.y.y, c.y.z}, {c.z.x, c.z.y, c.z.z}};
  if (row < 3) return column < 3 ? A[row][column] : C[row][column - 3];
  return column < 3 ? C[column][row - 3] : L[row - 3][column - 3];
}

// Every element against N = I - U U^T / D with D = I_ss + J, the textbook's form.
template <class Joint, class J>
void expect_textbook(Joint joint, int s, J rotor) {
  const double D = element(inertia, s, s) + static_cast<double>(rotor), tau = 1.7;
  const auto r = reflection(joint, TestLink<J>{{}, rotor}, inertia, bias, zeta, tau, 100.0);
  const double p[6] = {bias.moment.x, bias.moment.y, bias.moment.z, bias.force.x, bias.force.y, bias.force.z};
  const double z[6] = {zeta.angular.x, zeta.angular.y, zeta.angular.z, zeta.linear.x, zeta.linear.y, zeta.linear.z};
  const Vec3<double> moment = r.bias.moment, force = r.bias.force;
  const double passed[6] = {moment.x, moment.y, moment.z, force.x, force.y, force.z};
  const double u = tau - p[s];
  for (int i = 0; i < 6; ++i) {
    double sum = p[i] + element(inertia, i, s) * u / D;
    for (int j = 0; j < 6; ++j) {
      const double n = element(inertia, i, j) - element(inertia, i, s) * element(inertia, s, j) / D;
      EXPECT_NEAR(element(r.inertia, i, j), n, 1e-14) << i << ' ' << j;
      sum += n * z[j];
    }
    EXPECT_NEAR(passed[i], sum, 1e-14) << i;
  }
  EXPECT_NEAR(r.free, u / D, 1e-15);
  EXPECT_FALSE(r.singular);
}

}  // namespace

TEST(Reflection, EqualsTheTextbookWithoutARotor) {
  expect_textbook(Revolute{}, 2, Zero{});
  expect_textbook(Prismatic{}, 5, Zero{});
}

TEST(Reflection, EqualsTheTextbookWithARotor) {
  expect_textbook(Revolute{}, 2, 0.75);
  expect_textbook(Prismatic{}, 5, 0.75);
}

TEST(Reflection, RowOfTheJointIsZeroByTypeWithoutARotor) {
  const auto r = reflection(Revolute{}, TestLink<Zero>{}, inertia, bias, zeta, 1.7, 100.0);
  static_assert(is_zero_v<std::decay_t<decltype(r.inertia.angular.zz)>> &&
                is_zero_v<std::decay_t<decltype(r.inertia.angular.xz)>>);
  EXPECT_EQ(r.bias.moment.z, 1.7) << "the joint passes its effort on, exactly";
}

TEST(Reflection, LosesNoDigitsToASmallRotor) {
  const double J = 1e-12;
  const auto r = reflection(Revolute{}, TestLink<double>{{}, J}, inertia, bias, zeta, 1.7, 100.0);
  EXPECT_NEAR(r.inertia.angular.zz / J, 1.0, 1e-11);  // I_zz J / D; the difference I_zz - I_zz^2 / D has 3 digits here
}

TEST(Reflection, ReportsAJointThatIsLostInRounding) {
  auto flat = inertia;
  flat.angular.zz = 1e-17;
  const auto lost = reflection(Revolute{}, TestLink<Zero>{}, flat, bias, zeta, 1.7, 1.0);
  EXPECT_TRUE(lost.singular);
  flat.angular.zz = 0.0;
  const auto none = reflection(Revolute{}, TestLink<Zero>{}, flat, bias, zeta, 1.7, 1.0);
  EXPECT_TRUE(none.singular);
  EXPECT_EQ(none.free, 0.0) << "finite, and reported";
}

// [20M, 15A]; K = U (1/D) instead of U / D takes one reciprocal more, which u / D shares.
TEST(Reflection, CostsWhatThePaperSays) {
  static Trace trace;
  trace = Trace{};
  const auto v = [&] { return Counting(trace); };
  const auto vec = [&] { return Vec3<Counting>{v(), v(), v()}; };
  const auto sym = [&] { return Sym3<Counting>{v(), v(), v(), v(), v(), v()}; };
  const ArticulatedInertia i{sym(), Mat3<Vec3<Counting>>{vec(), vec(), vec()}, sym()};
  const ForceVector p{vec(), vec()};
  const MotionVector still{ZeroVec3{}, ZeroVec3{}};
  const auto r = reflection(Revolute{}, TestLink<Zero>{}, i, p, still, v(), v());
  for (const auto& x :
       {r.inertia.angular.xx, r.inertia.angular.yy, r.inertia.angular.xy, r.inertia.linear.xx, r.inertia.linear.yy,
        r.inertia.linear.zz, r.inertia.linear.xy, r.inertia.linear.xz, r.inertia.linear.yz})
    x.need();
  for (const auto& row : {r.inertia.coupling.x, r.inertia.coupling.y})
    row.x.need(), row.y.need(), row.z.need();
  EXPECT_EQ(trace.operations(), (Operations{20, 15, 1, 0}));
}
