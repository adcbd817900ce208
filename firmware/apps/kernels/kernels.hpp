#pragma once
/// The measured kernels by name: those that probes measure too (../size), compiled in sources of their own
/// (objects.cmake). Each takes a size::Argument and leaves its result there.

#include <robot.hpp>

#include <string_view>

#include <axial/axial.hpp>

#include "../size/argument.hpp"

// In float, and in double where the image has room.
#define AXIAL_KERNEL(algorithm)                       \
  extern "C" void bare_##algorithm##_unrolled(void*); \
  extern "C" void bare_##algorithm##_unrolled_double(void*);
AXIAL_KERNEL(inverse_dynamics)
AXIAL_KERNEL(torque_by_separation)
AXIAL_KERNEL(bias)
AXIAL_KERNEL(gravity)
AXIAL_KERNEL(mass_matrix)
AXIAL_KERNEL(forward_dynamics)
AXIAL_KERNEL(forward_kinematics)
AXIAL_KERNEL(jacobian)
AXIAL_KERNEL(closed_form)
AXIAL_KERNEL(forward_dynamics_articulated_body)
AXIAL_KERNEL(forward_dynamics_split_articulated_body)
AXIAL_KERNEL(forward_dynamics_composite_body)
#undef AXIAL_KERNEL

namespace axial::apps::kernels {

template <class T>
using Argument = size::Argument<Robot, T>;

/// `values` numbers at the start of its result are what README.md documents.
struct Kernel {
  const char* name;
  void (*code)(void* argument);
  int values;
};

/// The kernels in T, each from its code in float and in double.
template <class T>
class Kernels {
 public:
  /// The torque, whose result is what forward dynamics is given.
  static constexpr Kernel torque() {
    return of("inverse_dynamics", bare_inverse_dynamics_unrolled, bare_inverse_dynamics_unrolled_double, n);
  }

  /// Calls visit(kernel) for every other one.
  template <class Visit>
  static void for_each(Visit visit) {
    visit(of("separation", bare_torque_by_separation_unrolled, bare_torque_by_separation_unrolled_double, n));
    visit(of("bias", bare_bias_unrolled, bare_bias_unrolled_double, n));
    visit(of("gravity", bare_gravity_unrolled, bare_gravity_unrolled_double, n));
    visit(of("mass_matrix", bare_mass_matrix_unrolled, bare_mass_matrix_unrolled_double, n * (n + 1) / 2));
    visit(of("forward_dynamics", bare_forward_dynamics_unrolled, bare_forward_dynamics_unrolled_double, n));
    visit(of("forward_kinematics", bare_forward_kinematics_unrolled, bare_forward_kinematics_unrolled_double, 12));
    visit(of("jacobian", bare_jacobian_unrolled, bare_jacobian_unrolled_double, 6 * n));
    if constexpr (has_closed_form)
      visit(of("closed_form", bare_closed_form_unrolled, bare_closed_form_unrolled_double, n));
  }

  /// The routes of forward dynamics that it does not take by itself, in float: it has its row.
  template <class Visit>
  static void for_each_other_route(Visit visit) {
    if constexpr (!is_route<ArticulatedBody>)
      visit(Kernel{"articulated_body", bare_forward_dynamics_articulated_body_unrolled, n});
    if constexpr (!is_route<SplitArticulatedBody>)
      visit(Kernel{"split_articulated_body", bare_forward_dynamics_split_articulated_body_unrolled, n});
    if constexpr (!is_route<CompositeBody>)
      visit(Kernel{"composite_body", bare_forward_dynamics_composite_body_unrolled, n});
  }

 private:
  using Code = void (*)(void*);
  static constexpr int n = joint_count<Robot>;
  static constexpr bool has_closed_form = std::string_view(Robot::name) == "scara";
  template <class Route>
  static constexpr bool is_route = forward_dynamics_route<Scene<Robot, Route>> == forward_dynamics_route<Robot>;

  static constexpr Kernel of(const char* name, Code in_float, Code in_double, int values) {
    return {name, sizeof(T) == sizeof(float) ? in_float : in_double, values};
  }
};

}  // namespace axial::apps::kernels
