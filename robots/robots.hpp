// All robots of this folder, their names, and a walk over them that compiles on a microcontroller too.
#pragma once

#include <robots/gripper.hpp>
#include <robots/indy7.hpp>
#include <robots/palletiser.hpp>
#include <robots/panda.hpp>
#include <robots/panda_slow.hpp>
#include <robots/planar2r.hpp>
#include <robots/puma560.hpp>
#include <robots/roarm_m2.hpp>
#include <robots/scara.hpp>
#include <robots/scara_quill.hpp>
#include <robots/scara_rrpr.hpp>
#include <robots/torso.hpp>
#include <robots/two_arm.hpp>
#include <robots/wrist_arm.hpp>

namespace robots {

/// A robot as a value, for generic lambdas: the type is member `Robot` of decltype(robot).
template <class R>
struct Named {
  using Robot = R;                              ///< its type
  static constexpr const char* name = R::name;  ///< on the command line, in files and in JSON
};

/// Name of a robot on the command line, in file names and in JSON.
template <class R>
inline constexpr const char* name = R::name;

/// Robots as a list of types.
template <class... Rs>
struct List {
  static constexpr int size = sizeof...(Rs);  ///< number of robots

  /// Calls visit(Named<R>{}) for every robot, in order.
  template <class Visit>
  static constexpr void for_each(Visit&& visit) {
    (static_cast<void>(visit(Named<Rs>{})), ...);
  }
};

/// The serial arms: what the demo, the tables and the peers of the library know.
using All = List<Scara, ScaraRrpr, Puma560, Panda, Planar2r>;
/// Robots with branches.
using Trees = List<TwoArm, Torso>;
/// Serial arms on which others published bounds of fixed-point errors, at the limits of that comparison.
using Published = List<Indy7, RoarmM2, PandaSlow>;

/// Robots whose joints share drives.
using SharedDrives = List<ScaraQuill, Palletiser, WristArm, Gripper>;

/// Calls visit(Named<R>{}) for every robot of All, in order.
template <class Visit>
constexpr void for_each(Visit&& visit) {
  All::for_each(visit);
}

/// Whether two texts are equal.
constexpr bool same_name(const char* left, const char* right) {
  while (*left != '\0' && *left == *right)
    ++left, ++right;
  return *left == *right;
}

/// Calls visit(Named<R>{}) for the robot called `wanted`; false if there is none.
template <class Visit>
constexpr bool visit_named(const char* wanted, Visit&& visit) {
  bool found = false;
  for_each([&](auto robot) {
    if (!same_name(robot.name, wanted)) return;
    found = true;
    visit(robot);
  });
  return found;
}

}  // namespace robots
