// What a scene can name. What it does not name adds no instruction, no byte and no argument.
#pragma once

#include <axial/spatial/inertia.hpp>
#include <axial/spatial/spatial_vector.hpp>

namespace axial {

/// A load rigidly fixed to the last link, known at run time: mass (kg), centre of mass (m, last link's frame) and
/// inertia about that centre (kg m^2, axes of the last link's frame).
template <class T>
struct PayloadBody {
  T mass{};
  Vec3<T> com{};
  Sym3<T> inertia_com{};
};

/// Gravity as the robot declares it.
struct Gravity {
  template <class T>
  struct Input {};
};

/// gear^2 J of each drive on its own joint.
struct RotorInertia {
  template <class T>
  struct Input {};
};

/// Viscous and Coulomb friction as the links declare it, on the joint side; Coulomb friction is 0 at rest.
struct Friction {
  template <class T>
  struct Input {};
};

/// Force that the environment exerts on the last link: axes and origin of its frame, run-time input `tip_wrench`.
struct TipWrench {
  template <class T>
  struct Input {
    ForceVector<Vec3<T>, Vec3<T>> tip_wrench{};
  };
};

/// A run-time load on the last link, input `payload`.
struct Payload {
  template <class T>
  struct Input {
    PayloadBody<T> payload{};
  };
};

/// Loops over a table of links instead of unrolling: small code for small flash, and for long chains.
struct Looped {
  template <class T>
  struct Input {};
};

/// Inertial parameters regrouped at compile time (base_parameters.hpp): the default of inverse dynamics, its gravity
/// and bias parts, and the mass matrix. Naming it makes forward dynamics use them too: cheaper, but links become
/// differences of large numbers, so only short, well-conditioned arms stay exact.
struct BaseParameters {
  template <class T>
  struct Input {};
};

/// Every link's own inertial parameters, for all algorithms: the default of forward dynamics.
struct FullParameters {
  template <class T>
  struct Input {};
};

/// Forward dynamics by the articulated-body algorithm of McMillan and Orin 1995: exact whatever the conditioning.
struct ArticulatedBody {
  template <class T>
  struct Input {};
};

/// Forward dynamics by the bias torque and an articulated-body pass of the structure at rest: loses less in narrow
/// number systems where speeds and gravity are moderate.
struct SplitArticulatedBody {
  template <class T>
  struct Input {};
};

/// Forward dynamics by the bias torque, composite bodies and an elimination that follows the tree: the cheapest for
/// short, well-conditioned arms.
struct CompositeBody {
  template <class T>
  struct Input {};
};

}  // namespace axial
