// Lines, frames and bodies by hand.
#include <host_sim/robots/import/bodies.hpp>
#include <host_sim/robots/import/geometry.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace importer;

constexpr double tolerance = 1e-17;

void expect_at(const Vector& v, Real x, Real y, Real z) {
  EXPECT_NEAR(static_cast<double>(v[0] - x), 0.0, tolerance);
  EXPECT_NEAR(static_cast<double>(v[1] - y), 0.0, tolerance);
  EXPECT_NEAR(static_cast<double>(v[2] - z), 0.0, tolerance);
}

const Line z_axis{};

TEST(CommonNormal, OfSkewLinesHasItsFeetWhereTheyAreNearest) {
  const Line across{Vector(5, 3, 2), Vector::UnitX()};  // along x, 3 m beside the z axis, 2 m up
  const auto n = common_normal(z_axis, across, Vector::Zero(), Vector::UnitY());
  expect_at(n.first_foot, 0, 0, 2);
  expect_at(n.second_foot, 0, 3, 2);
  expect_at(n.direction, 0, 1, 0);
  expect_at(common_normal(z_axis, across, Vector::Zero(), -Vector::UnitY()).direction, 0, -1, 0);
}

TEST(CommonNormal, OfObliqueLinesIsAcrossBoth) {
  const Line oblique{Vector(1, 4, 7), Vector(0.6L, 0.48L, 0.64L)};
  const auto n = common_normal(z_axis, oblique, Vector::Zero(), Vector::UnitX());
  EXPECT_NEAR(static_cast<double>(n.direction.norm()), 1.0, tolerance);
  EXPECT_NEAR(static_cast<double>(n.direction.dot(z_axis.direction)), 0.0, tolerance);
  EXPECT_NEAR(static_cast<double>(n.direction.dot(oblique.direction)), 0.0, tolerance);
  const Vector way = n.second_foot - n.first_foot;
  EXPECT_NEAR(static_cast<double>(way.cross(n.direction).norm()), 0.0, 4 * tolerance) << "the feet lie on the normal";
  EXPECT_NEAR(static_cast<double>((n.second_foot - oblique.point).cross(oblique.direction).norm()), 0.0, 4 * tolerance);
}

TEST(CommonNormal, OfParallelLinesStandsAtThePreferredFoot) {
  const Line beside{Vector(0, 3, 9), Vector::UnitZ()};
  const auto n = common_normal(z_axis, beside, Vector(0, 0, 4), Vector::UnitX());
  expect_at(n.first_foot, 0, 0, 4);
  expect_at(n.second_foot, 0, 3, 4);
  expect_at(n.direction, 0, 1, 0);
  expect_at(common_normal(z_axis, beside, Vector(0, 0, 4), -Vector::UnitY()).direction, 0, -1, 0);
}

TEST(CommonNormal, OfOneLineWithItselfIsThePreferredDirection) {
  const Line same{Vector(0, 0, 9), -Vector::UnitZ()};
  const auto n = common_normal(z_axis, same, Vector(0, 0, 4), Vector::UnitX());
  expect_at(n.first_foot, 0, 0, 4);
  expect_at(n.second_foot, 0, 0, 4);
  expect_at(n.direction, 1, 0, 0);
}

TEST(CommonNormal, TakesLinesForParallelUpTo1em13) {
  const auto tilted = [](Real angle) { return Line{Vector(0, 3, 9), Vector(angle, 0, 1).normalized()}; };
  expect_at(common_normal(z_axis, tilted(0.9e-13L), Vector(0, 0, 4), Vector::UnitY()).first_foot, 0, 0, 4);
  const Real foot = common_normal(z_axis, tilted(1.1e-13L), Vector(0, 0, 4), Vector::UnitY()).first_foot[2];
  EXPECT_NEAR(static_cast<double>(foot), 9.0, 1e-3) << "where they are nearest";
}

TEST(AngleAbout, TurnsOneVectorIntoTheOther) {
  EXPECT_NEAR(static_cast<double>(angle_about(Vector::UnitZ(), Vector::UnitX(), Vector::UnitY())), M_PI / 2, 1e-15);
  EXPECT_NEAR(static_cast<double>(angle_about(-Vector::UnitZ(), Vector::UnitX(), Vector::UnitY())), -M_PI / 2, 1e-15);
  EXPECT_NEAR(static_cast<double>(angle_about(Vector::UnitZ(), Vector::UnitX(), -Vector::UnitX())), M_PI, 1e-15);
  EXPECT_EQ(static_cast<double>(angle_about(Vector::UnitZ(), Vector::UnitX(), Vector::UnitX())), 0.0);
}

TEST(Frame, IsRightHanded) {
  const Pose p = frame(Vector(1, 2, 3), Vector::UnitY(), Vector::UnitZ());
  expect_at(p.rotation.col(0), 0, 1, 0);
  expect_at(p.rotation.col(1), -1, 0, 0);
  expect_at(p.rotation.col(2), 0, 0, 1);
  expect_at(p.position, 1, 2, 3);
  const Pose home = p * p.inverse();
  expect_at(home.position, 0, 0, 0);
  expect_at(home.rotation * Vector(1, 2, 3), 1, 2, 3);
}

TEST(Rounded, IsZeroBelow1em14) {
  EXPECT_EQ(rounded(Real(0.9e-14L)), 0.0);
  EXPECT_EQ(rounded(Real(-0.9e-14L)), 0.0);
  EXPECT_EQ(rounded(Real(1.3e-14L)), 1.3e-14);
  EXPECT_EQ(rounded(Real(-1.23456789012e-3L)), -1.23456789012e-3);
}

TEST(Orthonormal, MendsWhatFewDigitsLeft) {
  const double rows[9] = {0.0, -1.001, 0.0, 0.999, 0.01, 0.0, 0.0, 0.0, 1.0};
  const Matrix r = orthonormal(rows);
  EXPECT_NEAR(static_cast<double>((r * r.transpose() - Matrix::Identity()).norm()), 0.0, 1e-18);
  expect_at(r.col(0), 0, 1, 0);
  expect_at(r.col(2), 0, 0, 1);
}

Body ball(Real mass, const Vector& at, Real inertia) { return {mass, at, inertia * Matrix::Identity()}; }

TEST(Merged, IsTheParallelAxisTheorem) {
  const Body two = merged({ball(1, Vector(0, 0, 0), 0.5L), ball(3, Vector(4, 0, 0), 0.25L)});
  EXPECT_EQ(static_cast<double>(two.mass), 4.0);
  expect_at(two.com, 3, 0, 0);
  const Real way = 1 * 9 + 3 * 1;  // squares of distances from the common centre
  expect_at(two.inertia.diagonal(), 0.75L, 0.75L + way, 0.75L + way);
  const Body bent = merged({ball(1, Vector(-1, -1, 0), 0), ball(1, Vector(1, 1, 0), 0)});
  expect_at(bent.inertia.diagonal(), 2, 2, 4);
  EXPECT_EQ(static_cast<double>(bent.inertia(0, 1)), -2.0) << "products are tensor entries";
}

TEST(Merged, OfMasslessBodiesKeepsTheirInertia) {
  const Body none = merged({ball(0, Vector(1, 0, 0), 0.5L), ball(0, Vector(0, 1, 0), 0.25L)});
  expect_at(none.com, 0, 0, 0);
  expect_at(none.inertia.diagonal(), 0.75L, 0.75L, 0.75L);
}

TEST(BodyOf, TurnsTheTensorWithTheBody) {
  SourceLink link;
  EXPECT_EQ(static_cast<double>(body_of(link, {}).mass), 0.0) << "it has none";
  link.has_inertial = true, link.mass = 2.0;
  const double tensor[] = {1.0, 2.0, 3.0, 0.25, 0.0, 0.0};
  std::copy(tensor, tensor + 6, link.inertia.begin());
  link.inertial.position = {1.0, 0.0, 0.0};
  const Pose cycle = frame(Vector(0, 0, 5), Vector::UnitY(), Vector::UnitX());  // x becomes y, y z, and z x
  const Body body = body_of(link, cycle);
  expect_at(body.com, 0, 1, 5);
  expect_at(body.inertia.diagonal(), 3, 1, 2);
  EXPECT_EQ(static_cast<double>(body.inertia(1, 2)), 0.25);
}

}  // namespace
