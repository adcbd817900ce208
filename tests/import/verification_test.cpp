// What the importer's verification compares, number by number: each that is wrong is seen by the figure that is there
// for it, and each figure alone makes an import not good.
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"
#include "broken.hpp"

#include <gtest/gtest.h>

namespace {

using axial::LinkParameters;
using importer::EngineFigures;
using importer::Figures;

// Its first body is centred on its joint, where a centre that is off changes hardly any inertia.
const std::string centred_arm = broken::changed(
    arms::urdf, {"<origin xyz=\"0.1 0.02 0\" rpy=\"0.1 0.2 0.3\"/>", "<origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>", ""});

/// What the comparison says where the robot that was read is changed.
template <class Change>
Figures figures_with(const Change& change) {
  static const auto read = importer::import_text(centred_arm, "arm", {}).imported;
  auto imported = read;
  const auto reference =
      importer::reference_of(centred_arm, {}, imported.changes, {0.0, 0.0, -9.81}, {"shoulder", "elbow"}, "tool0");
  change(imported.robot);
  return importer::verify(imported, reference, 1, 3);
}

TEST(Verification, SeesEachNumberOfABody) {
  ASSERT_TRUE(figures_with([](auto&) {}).good());
  const auto off = [](auto field, int link, int k) {
    return figures_with(
               [&](auto& robot) { (robot.links[static_cast<std::size_t>(link)].parameters.*field)[k] += 1e-8; })
        .body;
  };
  for (int link = 0; link < 2; ++link) {
    const auto heavier = [link](auto& robot) {
      robot.links[static_cast<std::size_t>(link)].parameters.mass *= 1.0 + 1e-8;
    };
    EXPECT_GT(figures_with(heavier).body, 0.9e-8);
    for (int k = 0; k < 3; ++k)
      EXPECT_GT(off(&LinkParameters::com, link, k), 0.9e-8) << link << ' ' << k;
    for (int k = 0; k < 6; ++k)
      EXPECT_GT(off(&LinkParameters::inertia_com, link, k), 1e-9) << link << ' ' << k;
  }
}

// Along each axis, and by less than what KDL takes for a vector.
TEST(Verification, SeesEachPartOfAPlaceAndOfGravity) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(figures_with([k](auto& robot) { robot.tool.position[k] += 1e-8; }).pose, 0.9e-8) << k;
    const auto gravity = figures_with([k](auto& robot) {
      (k == 0 ? robot.gravity.x : k == 1 ? robot.gravity.y : robot.gravity.z) += 1e-8;
    });
    EXPECT_GT(gravity.body, 0.9e-9) << k;
  }
}

TEST(Verification, SeesEachLimitAndEachFriction) {
  for (const auto field : {&LinkParameters::position_min, &LinkParameters::position_max, &LinkParameters::speed_limit,
                           &LinkParameters::effort_limit, &LinkParameters::viscous, &LinkParameters::coulomb_forward,
                           &LinkParameters::coulomb_backward}) {
    const auto figures = figures_with([&](auto& robot) { robot.links[0].parameters.*field *= 1.0 + 1e-9; });
    EXPECT_NEAR(figures.limits, 1e-9, 1e-11);
    EXPECT_FALSE(figures.good());
  }
  const auto no_friction = figures_with([](auto& robot) { robot.links[0].parameters.viscous = 0.0; });
  EXPECT_EQ(no_friction.limits, 1.0);
}

template <class Of>
void expect_each_counts(const Of& good, std::initializer_list<std::pair<double Of::*, double>> bounds) {
  ASSERT_TRUE(good.good());
  for (const auto& [figure, bound] : bounds) {
    Of of = good;
    of.*figure = bound;
    EXPECT_TRUE(of.good());
    of.*figure = 1.001 * bound;
    EXPECT_FALSE(of.good());
  }
}

TEST(Verification, IsGoodWhereEachFigureIs) {
  Figures figures;
  figures.changed_angle_bound = 1e-5;
  expect_each_counts(figures, {{&Figures::pose, importer::pose_bound},
                               {&Figures::torque, importer::torque_bound},
                               {&Figures::mass_matrix, importer::torque_bound},
                               {&Figures::body, importer::body_bound},
                               {&Figures::limits, importer::limits_bound},
                               {&Figures::changed_angle, 1e-5},
                               {&Figures::changed_length, importer::changed_length_bound}});
  EngineFigures asked;
  asked.engine = "one";
  expect_each_counts(asked, {{&EngineFigures::pose, asked.bound},
                             {&EngineFigures::torque, asked.bound},
                             {&EngineFigures::mass_matrix, asked.bound},
                             {&EngineFigures::body, asked.bound},
                             {&EngineFigures::joint, asked.bound}});
  figures.engine = asked;
  figures.engine.joint = 1.0;
  EXPECT_FALSE(figures.good());
}

}  // namespace
