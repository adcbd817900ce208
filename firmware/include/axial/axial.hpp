// axial: rigid-body dynamics for microcontrollers. The umbrella header of float and double; fixed.hpp has fixed point.
#pragma once
#include <axial/scalar/language.hpp>

// First and one by one, so that few lines of includes stand before what the compiler says of a description or a scene.
#include <axial/robot/chain.hpp>
#include <axial/robot/classical.hpp>
#include <axial/scene/scene.hpp>

#include <axial/scene/joints.hpp>

#include <axial/scene/refused_calls.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/control/feedforward.hpp>

#include <axial/control/gravity_compensation.hpp>

#include <axial/version.hpp>

#include <axial/base/water.hpp>
#include <axial/closed_form/scara.hpp>
#include <axial/control/collision.hpp>
#include <axial/control/current_limit.hpp>
#include <axial/control/fall_back.hpp>
#include <axial/control/position_command.hpp>
#include <axial/control/tracking.hpp>
#include <axial/control/two_rate.hpp>
#include <axial/derivatives/forward_dynamics_along.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_along.hpp>
#include <axial/derivatives/torque_rates.hpp>
#include <axial/derivatives/torque_regressor.hpp>
#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/check_finite.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/elastic/elastic_feedforward.hpp>
#include <axial/links/model.hpp>
#include <axial/scene/consistency.hpp>
#include <axial/scene/runtime_tool.hpp>
#include <axial/scene/status_text.hpp>
#include <axial/separation/separated_torque.hpp>
#include <axial/separation/separation.hpp>
#include <axial/tool/task_space_inertia.hpp>
#include <axial/tool/tool_motion.hpp>
#include <axial/tool/tool_slopes.hpp>
#include <axial/transmissions/rotor_dynamics.hpp>
#include <axial/transmissions/shared_drives.hpp>

// Last, behind what they include; each from here: what stands between it and the user is a line more of its messages.
#include <axial/calls/registry.hpp>

#include <axial/calls/arguments.hpp>

#include <axial/calls/on_arrays.hpp>
