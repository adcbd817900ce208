// Motions by the library's integrators, by name.
#pragma once

#include <host_sim/plants/simulation/plant.hpp>

#include <cstdint>

namespace host_sim::simulation {

enum class Method { semi_implicit, rk4, linearly_implicit };
constexpr Method methods[] = {Method::semi_implicit, Method::rk4, Method::linearly_implicit};
/// As it stands in data: semi_implicit_euler, rk4, linearly_implicit_euler.
const char* name(Method method);
/// Evaluations of forward dynamics a step.
int evaluations(Method method);

template <class T>
using Motion = axial::Motion<Model, T>;
using DrivenMotion = axial::Motion<DrivenModel, double>;  ///< of drives that joints share
template <class T>
using CompensatedMotion = axial::CompensatedMotion<Model, T>;

/// Joint values in T.
template <class T>
Values<T> narrowed(const Values<double>& from) {
  Values<T> to{};
  for (int i = 0; i < Values<T>::size; ++i)
    to[i] = static_cast<T>(from[i]);
  return to;
}

/// What acts on a motion X: as axial::advance asks it, with the stiffness.
template <class X, class M = typename X::Subject, class T = typename X::Scalar>
using DriveOf = std::function<void(const axial::Instant<M, T>&, axial::Joints<M, T>&, axial::Inputs<M, T>&,
                                   axial::DriveStiffness<M, T>&)>;
template <class T>
using Drive = DriveOf<Motion<T>>;

/// One step; X is Motion or CompensatedMotion of float or double, or DrivenMotion.
template <class X>
axial::Status step(Method method, const typename X::Subject& model, X& x, typename X::Scalar h,
                   const DriveOf<X>& drive);

/// `steps` steps; `watch` sees every state.
template <class X, class Watch>
void run(Method method, const typename X::Subject& model, X& x, typename X::Scalar h, long steps,
         const DriveOf<X>& drive, const Watch& watch) {
  for (long k = 0; k < steps; ++k) {
    step(method, model, x, h, drive);
    watch(x);
  }
}

/// Positions and velocities in double, with what rounding left of the sums.
template <class T>
Motion<double> exact_state(const Motion<T>& x);
template <class T>
Motion<double> exact_state(const CompensatedMotion<T>& x);

/// The step limit for the springs and dampers of a model and, where given, of what drives it: axial::step_limit.
///@{
double step_limit(Method method, const Model& model, const Values<double>& q, const Stiffness<double>& drive = {});
double step_limit(Method method, const DrivenModel& model, const axial::Joints<DrivenModel, double>& u,
                  const axial::DriveStiffness<DrivenModel, double>& drive = {});
///@}

}  // namespace host_sim::simulation
