// Headers that the importer wrote while this was built: they compile, and hold bit for bit what was imported.
#include <host_sim/robots/description/header.hpp>
#include <host_sim/robots/import/importer.hpp>

#include <coupled_arm.hpp>
#include <kr5_sixx.hpp>
#include <made_up_arm.hpp>
#include <made_up_walker.hpp>
#include <stanford_arm.hpp>
#include <two_armed.hpp>

#include <gtest/gtest.h>

#include <cstring>

namespace {

using description::Description;

bool same(const void* left, const void* right, std::size_t size) { return std::memcmp(left, right, size) == 0; }

void expect_same(const axial::LinkParameters& read, const axial::LinkParameters& written) {
  EXPECT_EQ(read.type, written.type);
  EXPECT_TRUE(same(&read.alpha, &written.alpha, sizeof read.alpha));
  EXPECT_TRUE(same(&read.theta, &written.theta, sizeof read.theta));
  EXPECT_TRUE(same(&read.gamma, &written.gamma, sizeof read.gamma));
  EXPECT_EQ(read.a, written.a);
  EXPECT_EQ(read.d, written.d);
  EXPECT_EQ(read.b, written.b);
  EXPECT_EQ(read.mass, written.mass);
  EXPECT_TRUE(std::equal(read.com, read.com + 3, written.com));
  EXPECT_TRUE(std::equal(read.inertia_com, read.inertia_com + 6, written.inertia_com));
  EXPECT_EQ(read.rotor_inertia, written.rotor_inertia);
  EXPECT_EQ(read.spring_stiffness, written.spring_stiffness);
  EXPECT_EQ(read.spring_rest, written.spring_rest);
  EXPECT_EQ(read.viscous, written.viscous);
  EXPECT_EQ(read.coulomb_backward, written.coulomb_backward);
  EXPECT_EQ(read.position_min, written.position_min);
  EXPECT_EQ(read.position_max, written.position_max);
  EXPECT_EQ(read.speed_limit, written.speed_limit);
  EXPECT_EQ(read.acceleration_limit, written.acceleration_limit);
  EXPECT_EQ(read.effort_limit, written.effort_limit);
  EXPECT_TRUE(read.drives.count == written.drives.count && read.drives.follows == written.drives.follows);
  EXPECT_TRUE(read.drives.complete == written.drives.complete && read.drives.offset == written.drives.offset);
  EXPECT_TRUE(same(read.drives.of, written.drives.of, sizeof read.drives.of));
  EXPECT_TRUE(same(read.drives.ratio, written.drives.ratio, sizeof read.drives.ratio));
  EXPECT_EQ(read.drive_min, written.drive_min);
  EXPECT_EQ(read.drive_max, written.drive_max);
  EXPECT_EQ(read.drive_speed_limit, written.drive_speed_limit);
  EXPECT_EQ(read.drive_acceleration_limit, written.drive_acceleration_limit);
}

template <class Robot>
void expect_header_of(const std::string& file) {
  const auto read = importer::import_file(file, {}).imported.robot;
  const auto written = description::from_robot<Robot>();
  ASSERT_EQ(read.size(), written.size());
  for (int i = 0; i < read.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(read.parent(i), written.parent(i));
    expect_same(read.links[k].parameters, written.links[k].parameters);
  }
  EXPECT_TRUE(same(&read.base, &written.base, sizeof read.base));
  EXPECT_TRUE(same(&read.tool, &written.tool, sizeof read.tool));
  EXPECT_TRUE(same(&read.gravity, &written.gravity, sizeof read.gravity));
  ASSERT_EQ(read.base_body.has_value(), written.base_body.has_value());
  if (read.base_body) expect_same(*read.base_body, *written.base_body);
}

TEST(Headers, HoldBitForBitWhatWasImported) {
  expect_header_of<robots::Kr5Sixx>(AXIAL_ROOT "/tests/data/descriptions/kr5_sixx_r650.urdf");
  expect_header_of<robots::StanfordArm>(AXIAL_ROOT "/tests/data/descriptions/stanford.json");
  expect_header_of<robots::CoupledArm>(AXIAL_ROOT "/tests/import/coupled_arm.urdf");
  expect_header_of<robots::TwoArmed>(AXIAL_ROOT "/tests/import/two_armed.urdf");
  expect_header_of<robots::MadeUpArm>(AXIAL_ROOT "/tests/import/mjcf/arm.xml");
  expect_header_of<robots::MadeUpWalker>(AXIAL_ROOT "/tests/import/mjcf/floating.xml");
}

TEST(Headers, AreTheSameTwice) {
  const std::string file = AXIAL_ROOT "/tests/import/two_armed.urdf";
  const auto once = importer::import_file(file, {}), again = importer::import_file(file, {});
  EXPECT_EQ(description::header(once.imported.robot, once.figures.lines()),
            description::header(again.imported.robot, again.figures.lines()));
}

}  // namespace
