#pragma once
/// The measured kernels by name: those that probes measure too (../size), compiled in sources of their own
/// (objects.cmake). Each takes a size::Argument and leaves its result there.

#include <robot.hpp>

#include <string_view>

#include <axial/axial.hpp>

#include "../size/argument.hpp"

namespace axial::apps::kernels {

template <class T>
using Argument = size::Argument<Robot, T>;

/// The code of a kernel in T. In double only where the image has room.
namespace code {
#define AXIAL_KERNEL(algorithm)                              \
  extern "C" void bare_##algorithm##_unrolled(void*);        \
  extern "C" void bare_##algorithm##_unrolled_double(void*); \
  template <class T>                                         \
  constexpr auto algorithm() {                               \
    if constexpr (sizeof(T) == sizeof(float))                \
      return bare_##algorithm##_unrolled;                    \
    else                                                     \
      return bare_##algorithm##_unrolled_double;             \
  }
AXIAL_KERNEL(inverse_dynamics)
AXIAL_KERNEL(torque_by_separation)
AXIAL_KERNEL(bias)
AXIAL_KERNEL(gravity)
AXIAL_KERNEL(mass_matrix)
AXIAL_KERNEL(forward_dynamics)
AXIAL_KERNEL(forward_kinematics)
AXIAL_KERNEL(jacobian)
AXIAL_KERNEL(closed_form)
AXIAL_KERNEL(inverse_dynamics_derivatives)
AXIAL_KERNEL(forward_dynamics_derivatives)
AXIAL_KERNEL(inverse_dynamics_along)
AXIAL_KERNEL(forward_dynamics_along)
AXIAL_KERNEL(torque_regressor)
AXIAL_KERNEL(forward_dynamics_articulated_body)
AXIAL_KERNEL(forward_dynamics_split_articulated_body)
AXIAL_KERNEL(forward_dynamics_composite_body)
#undef AXIAL_KERNEL
}  // namespace code

/// `values` numbers at the start of its result are what README.md documents.
struct Kernel {
  const char* name;
  void (*code)(void* argument);
  int values;
};

/// The kernels in T.
template <class T>
class Kernels {
 public:
  /// The torque, whose result is what forward dynamics is given.
  static constexpr Kernel torque() { return Kernel{"inverse_dynamics", code::inverse_dynamics<T>(), n}; }

  /// Calls visit(kernel) for every other one.
  template <class Visit>
  static void for_each(Visit visit) {
    visit(Kernel{"separation", code::torque_by_separation<T>(), n});
    visit(Kernel{"bias", code::bias<T>(), n});
    visit(Kernel{"gravity", code::gravity<T>(), n});
    visit(Kernel{"mass_matrix", code::mass_matrix<T>(), n * (n + 1) / 2});
    visit(Kernel{"forward_dynamics", code::forward_dynamics<T>(), n});
    visit(Kernel{"forward_kinematics", code::forward_kinematics<T>(), 12});
    visit(Kernel{"jacobian", code::jacobian<T>(), 6 * n});
    if constexpr (has_closed_form) visit(Kernel{"closed_form", code::closed_form<T>(), n});
#ifdef AXIAL_DERIVATIVES
    visit(Kernel{"inverse_dynamics_derivatives", code::inverse_dynamics_derivatives<T>(), n * (5 * n + 3) / 2});
    visit(Kernel{"forward_dynamics_derivatives", code::forward_dynamics_derivatives<T>(), n * (5 * n + 3) / 2});
#endif
  }

  /// Those without a row, in float: what a direction or a parameter changes, and the routes of forward dynamics that it
  /// does not take by itself.
  template <class Visit>
  static void for_each_without_row(Visit visit) {
#ifdef AXIAL_DERIVATIVES
    visit(Kernel{"inverse_dynamics_along", code::inverse_dynamics_along<float>(), 2 * n});
    visit(Kernel{"forward_dynamics_along", code::forward_dynamics_along<float>(), n});
    visit(Kernel{"torque_regressor", code::torque_regressor<float>(), 10 * n});
#endif
    if constexpr (!is_route<ArticulatedBody>)
      visit(Kernel{"articulated_body", code::forward_dynamics_articulated_body<float>(), n});
    if constexpr (!is_route<SplitArticulatedBody>)
      visit(Kernel{"split_articulated_body", code::forward_dynamics_split_articulated_body<float>(), n});
    if constexpr (!is_route<CompositeBody>)
      visit(Kernel{"composite_body", code::forward_dynamics_composite_body<float>(), n});
  }

 private:
  static constexpr int n = joint_count<Robot>;
  static constexpr bool has_closed_form = std::string_view(Robot::name) == "scara";
  template <class Route>
  static constexpr bool is_route = forward_dynamics_route<Scene<Robot, Route>> == forward_dynamics_route<Robot>;
};

}  // namespace axial::apps::kernels
