// By what roles the arguments and results of algorithms change where something stands between joints and values.
#pragma once

#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Roles of an algorithm's arguments behind links and run-time inputs: role::None of what is no joint values.
template <class... Role>
struct Roles {};
/// A role: columns of a Jacobian, twists by rates.
struct TwistByRate {};

/// The links as a tree of joints, for execute(): there are specialisations where joint values are not theirs.
struct JointLinks {
  /// the links themselves
  template <class Links>
  AXIAL_INLINE static constexpr const Links& run(const Links& links) {
    return links;
  }
};
/// The links to which joint values belong, with rotor and friction of each.
struct Actuators : JointLinks {};

}  // namespace axial

#include <axial/options/end.hpp>
