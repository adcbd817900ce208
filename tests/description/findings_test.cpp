// Every finding: the last value that is none, and the first that is.
#include <host_sim/robots/description/findings.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace {

using axial::LinkParameters;
using description::Description;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = description::largest_number;

LinkParameters sound() {
  LinkParameters p;
  p.mass = 1.0, p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = 1.0;
  return p;
}

Description arm(const LinkParameters& p) {
  Description robot;
  robot.links = {{"one", "first", sound()}, {"two", "second", p}};
  return robot;
}

/// What is found in the second of two links, the first of which is sound.
std::string found(const std::function<void(LinkParameters&)>& change, bool errors = true) {
  LinkParameters p = sound();
  change(p);
  const Description robot = arm(p);
  const auto all = description::findings(robot);
  for (const auto& finding : all)
    EXPECT_TRUE(finding.link.empty() || finding.link == "two") << finding.text();
  return description::lines(all, errors);
}

void expect_refused_beyond(double LinkParameters::*field, double good, double bad, const std::string& words) {
  EXPECT_EQ(found([&](auto& p) { p.*field = good; }), "") << words << ' ' << good;
  EXPECT_NE(found([&](auto& p) { p.*field = bad; }).find(words), std::string::npos) << words << ' ' << bad;
}
double above(double x) { return std::nextafter(x, inf); }
double below(double x) { return std::nextafter(x, -inf); }

TEST(Findings, OfASoundArmAreNone) { EXPECT_TRUE(description::findings(arm(sound())).empty()); }

TEST(Findings, LengthsAreMetresBelowABillion) {
  for (auto field : {&LinkParameters::a, &LinkParameters::d, &LinkParameters::b})
    for (const double sign : {1.0, -1.0}) {
      expect_refused_beyond(field, sign * huge, sign * above(huge), "give metres");
      expect_refused_beyond(field, 0.0, nan, "give metres");
      const auto warned = [&](double x) { return found([&](auto& p) { p.*field = x; }, false); };
      EXPECT_EQ(warned(sign * 20.0), "");
      EXPECT_NE(warned(sign * above(20.0)).find("millimetres"), std::string::npos);
    }
}

TEST(Findings, AnglesAreFinite) {
  for (auto field : {&LinkParameters::alpha, &LinkParameters::theta, &LinkParameters::gamma}) {
    EXPECT_EQ(found([&](auto& p) { (p.*field).radians = huge; }), "");
    EXPECT_NE(found([&](auto& p) { (p.*field).radians = inf; }).find("an angle"), std::string::npos);
  }
}

TEST(Findings, DrivesHaveRotorsGearsAndSprings) {
  expect_refused_beyond(&LinkParameters::rotor_inertia, 0.0, -1e-300, "rotor inertia");
  expect_refused_beyond(&LinkParameters::rotor_inertia, huge, above(huge), "rotor inertia");
  expect_refused_beyond(&LinkParameters::gear, -huge, below(-huge), "gear");
  const auto geared = [](double gear) { return found([&](auto& p) { p.rotor_inertia = 1e-4, p.gear = gear; }); };
  EXPECT_EQ(geared(-0.01), "");
  EXPECT_NE(geared(0.0).find("gear ratio is 0"), std::string::npos);
  expect_refused_beyond(&LinkParameters::spring_stiffness, 1.0, nan, "spring");
  expect_refused_beyond(&LinkParameters::spring_rest, -1.0, -inf, "spring");
}

TEST(Findings, FrictionTakesEnergyOut) {
  expect_refused_beyond(&LinkParameters::viscous, 0.0, -1e-300, "viscous");
  expect_refused_beyond(&LinkParameters::viscous, huge, inf, "viscous");
  expect_refused_beyond(&LinkParameters::coulomb_forward, 0.0, -1e-300, "Coulomb");
  expect_refused_beyond(&LinkParameters::coulomb_backward, 0.0, 1e-300, "Coulomb");
  expect_refused_beyond(&LinkParameters::coulomb_forward, 1.0, nan, "Coulomb");
  expect_refused_beyond(&LinkParameters::coulomb_backward, -1.0, -inf, "Coulomb");
}

TEST(Findings, BreakawayIsNotBelowCoulombInEitherDirection) {
  const auto with = [](double forward, double backward, double breakaway, double speed) {
    return found([&](auto& p) {
      p.coulomb_forward = forward, p.coulomb_backward = backward;
      p.static_friction = breakaway, p.stribeck_speed = speed;
    });
  };
  EXPECT_EQ(with(2, -1, 2, 1), "");
  EXPECT_EQ(with(2, -1, 0, 0), "") << "none is declared";
  EXPECT_NE(with(2, -1, 1.5, 1).find("static friction"), std::string::npos);
  EXPECT_NE(with(1, -2, 1.5, 1).find("static friction"), std::string::npos);
  EXPECT_NE(with(1, -1, inf, 1).find("static friction"), std::string::npos);
  EXPECT_EQ(with(1, -1, 2, 1e-9), "");
  EXPECT_NE(with(1, -1, 2, below(1e-9)).find("Stribeck speed"), std::string::npos);
  EXPECT_NE(with(1, -1, 2, nan).find("Stribeck speed"), std::string::npos);
}

TEST(Findings, ASmoothSpeedIsNoneOrLargeEnough) {
  expect_refused_beyond(&LinkParameters::smooth_speed, 0.0, below(1e-9), "smooth_speed");
  expect_refused_beyond(&LinkParameters::smooth_speed, 1e-9, -1.0, "smooth_speed");
}

TEST(Findings, LimitsLeaveRoom) {
  const auto between = [](double low, double high) {
    return found([&](auto& p) { p.position_min = low, p.position_max = high; });
  };
  EXPECT_EQ(between(-1, 1), "");
  EXPECT_NE(between(1, 1).find("upside down"), std::string::npos);
  EXPECT_NE(between(nan, 1).find("upside down"), std::string::npos);
  expect_refused_beyond(&LinkParameters::speed_limit, 1e-300, 0.0, "speed limit");
  expect_refused_beyond(&LinkParameters::acceleration_limit, 1e-300, 0.0, "acceleration limit");
  expect_refused_beyond(&LinkParameters::effort_limit, 1e-300, nan, "effort limit");
}

TEST(Findings, DrivesThatJointsShareAreThereAndMoveThem) {
  const auto with = [](const std::function<void(LinkParameters&)>& change) {
    return found([&](auto& p) { p.drives.name(0, 0.5), change(p); });
  };
  EXPECT_EQ(with([](auto&) {}), "") << "a drive of the first joint, and its own";
  for (const double ratio : {0.0, nan})
    EXPECT_NE(with([=](auto& p) { p.drives.ratio[0] = ratio; }).find("a ratio that is 0 or not finite"),
              std::string::npos);
  EXPECT_EQ(with([](auto& p) { p.drive_min = -1, p.drive_max = 1; }), "");
  EXPECT_NE(with([](auto& p) { p.drive_min = 1, p.drive_max = -1; }).find("limits upside down"), std::string::npos);
  EXPECT_NE(with([](auto& p) { p.drives.of[0] = -1; }).find("what is not there"), std::string::npos);
  EXPECT_EQ(with([](auto& p) { p.drives.follows = true; }), "") << "no drive of its own, and no limit either";
  for (auto field : {&LinkParameters::effort_limit, &LinkParameters::rotor_inertia, &LinkParameters::viscous})
    EXPECT_NE(with([=](auto& p) { p.drives.follows = true, p.*field = 0.25; }).find("has no drive of its own"),
              std::string::npos);
}

TEST(Findings, DrivesThatJointsShareMoveThemIndependently) {
  const auto with = [](double ratio) {  // both joints are moved by both drives
    LinkParameters first = sound(), second = sound();
    for (auto* p : {&first, &second})
      p->drives.complete = true, p->drives.name(0, 1.0), p->drives.name(1, p == &first ? 1.0 : ratio);
    Description robot = arm(second);
    robot.links[0].parameters = first;
    return description::lines(description::findings(robot), true);
  };
  EXPECT_EQ(with(-1.0), "") << "a differential";
  EXPECT_NE(with(1.0).find("independently of each other"), std::string::npos);
}

TEST(Findings, BodiesHaveMassAndPlaceAndInertia) {
  expect_refused_beyond(&LinkParameters::mass, huge, above(huge), "mass");
  expect_refused_beyond(&LinkParameters::mass, 1.0, -1e-300, "negative");
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(found([&](auto& p) { p.com[k] = -huge; }), "");
    EXPECT_NE(found([&](auto& p) { p.com[k] = nan; }).find("centre of mass"), std::string::npos) << k;
  }
  for (int k = 0; k < 6; ++k)
    EXPECT_NE(found([&](auto& p) { p.inertia_com[k] = inf; }).find("inertia"), std::string::npos) << k;
}

TEST(Findings, InertiaIsThatOfABodyInAnyAxes) {
  const auto warned = [](double xx, double yy, double zz, double xy, double xz, double yz) {
    return found(
        [&](auto& p) {
          const double all[] = {xx, yy, zz, xy, xz, yz};
          std::copy(all, all + 6, p.inertia_com);
        },
        false);
  };
  EXPECT_EQ(warned(1, 1, 2, 0, 0, 0), "") << "a plate is the limit";
  EXPECT_EQ(warned(0, 1, 1, 0, 0, 0), "") << "and so is a rod";
  EXPECT_EQ(warned(0.5, 1, 1.5, 0, 0, 0), "");
  EXPECT_NE(warned(0.5, 1, 1.50001, 0, 0, 0).find("triangle"), std::string::npos) << "the two smaller ones count";
  for (const double bend : {2.00001, 3.0}) {
    EXPECT_NE(warned(1, 1, bend, 0, 0, 0).find("triangle"), std::string::npos);
    EXPECT_NE(warned(1, bend, 1, 0, 0, 0).find("triangle"), std::string::npos);
    EXPECT_NE(warned(bend, 1, 1, 0, 0, 0).find("triangle"), std::string::npos);
  }
  // Turned by 45 degrees about each axis: moments 0.5, 1.5 and 1 are a body's, -0.1, 2.1 and 1 are not.
  EXPECT_EQ(warned(1, 1, 1, 0.5, 0, 0) + warned(1, 1, 1, 0, 0.5, 0) + warned(1, 1, 1, 0, 0, 0.5), "");
  EXPECT_NE(warned(1, 1, 1, 1.1, 0, 0).find("positive definite"), std::string::npos);
  EXPECT_NE(warned(1, 1, 1, 0, -1.1, 0).find("positive definite"), std::string::npos);
  EXPECT_NE(warned(1, 1, 1, 0, 0, 1.1).find("positive definite"), std::string::npos);
}

TEST(Findings, ABodyIsWholeOrNone) {
  const auto warned = [](double mass, double inertia) {
    return found([&](auto& p) { p.mass = mass, p.inertia_com[0] = p.inertia_com[1] = p.inertia_com[2] = inertia; },
                 false);
  };
  EXPECT_NE(warned(1, 0).find("point mass"), std::string::npos);
  EXPECT_NE(warned(0, 1).find("a mass of 0 kg"), std::string::npos);
  EXPECT_NE(warned(0, 0).find("neither mass nor inertia"), std::string::npos);
}

TEST(Findings, AJointThatNothingResistsIsNamed) {
  const auto unresisted = [](const Description& robot) {
    std::string names;
    for (const auto& finding : description::findings(robot))
      if (finding.what.find("moves nothing") != std::string::npos) names += finding.link + " ";
    return names;
  };
  LinkParameters empty, point, turned;
  point.mass = 1.0, turned.rotor_inertia = 1e-6;
  EXPECT_EQ(unresisted(arm(empty)), "two ");
  EXPECT_EQ(unresisted(arm(point)) + unresisted(arm(turned)), "");
  Description robot = arm(sound());
  robot.links[0].parameters = empty;
  EXPECT_EQ(unresisted(robot), "") << "what it carries resists";
  robot.links[1].parameters.parent = LinkParameters::base;
  EXPECT_EQ(unresisted(robot), "one ") << "the other does not hang on it";
}

TEST(Findings, OfTheWholeRobotNameNoLink) {
  const auto errors = [](const Description& robot) { return description::lines(description::findings(robot), true); };
  EXPECT_NE(errors({}).find("no joint"), std::string::npos);
  Description robot;
  for (int i = 0; i < description::most_links; ++i)
    robot.links.push_back({"l", "j", sound()});
  EXPECT_EQ(errors(robot), "");
  robot.links.push_back({"l", "j", sound()});
  EXPECT_NE(errors(robot).find("65 joints"), std::string::npos);
  for (auto axis : {&axial::GravityVector::x, &axial::GravityVector::y, &axial::GravityVector::z}) {
    Description tilted = arm(sound());
    tilted.gravity.*axis = nan;
    EXPECT_NE(errors(tilted).find("gravity"), std::string::npos);
  }
  for (const int parent : {1, 2, -3}) {
    Description tree = arm(sound());
    tree.links[1].parameters.parent = parent;
    EXPECT_NE(errors(tree).find("does not stand before it"), std::string::npos) << parent;
  }
}

TEST(Findings, ErrorsAreThrownAndWarningsReturned) {
  LinkParameters p = sound();
  p.a = 30.0;
  EXPECT_EQ(description::check(arm(p)).size(), 1U);
  p.viscous = -1.0, p.speed_limit = 0.0;
  try {
    description::check(arm(p));
    FAIL() << "it is refused";
  } catch (const description::Refused& refused) {
    const std::string text = refused.what();
    EXPECT_NE(text.find("viscous"), std::string::npos);
    EXPECT_NE(text.find("\nlink 'two': joint 'second': speed limit is 0; give"), std::string::npos) << text;
    EXPECT_EQ(text.find("30 m"), std::string::npos);
  }
}

}  // namespace
