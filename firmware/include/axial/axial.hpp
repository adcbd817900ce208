// axial: rigid-body dynamics for microcontrollers. The umbrella header of float and double; fixed.hpp has fixed point.
#pragma once

// First and one by one, so that few lines of includes stand before what the compiler says of a description or a scene.
#include <axial/robot/chain.hpp>
#include <axial/robot/classical.hpp>
#include <axial/scene/scene.hpp>

#include <axial/scene/joints.hpp>

#include <axial/closed_form/scara.hpp>
#include <axial/control/collision.hpp>
#include <axial/control/current_limit.hpp>
#include <axial/control/fall_back.hpp>
#include <axial/control/feedforward.hpp>
#include <axial/control/gravity_compensation.hpp>
#include <axial/control/position_command.hpp>
#include <axial/control/tracking.hpp>
#include <axial/control/two_rate.hpp>
#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/check_finite.hpp>
#include <axial/dynamics/elastic_feedforward.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/forward_dynamics_along.hpp>
#include <axial/dynamics/forward_dynamics_derivatives.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics_along.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/rotor_dynamics.hpp>
#include <axial/dynamics/separated_torque.hpp>
#include <axial/dynamics/separation.hpp>
#include <axial/dynamics/shared_drives.hpp>
#include <axial/dynamics/task_space_inertia.hpp>
#include <axial/dynamics/tool_motion.hpp>
#include <axial/dynamics/tool_slopes.hpp>
#include <axial/dynamics/torque_rates.hpp>
#include <axial/dynamics/torque_regressor.hpp>
#include <axial/links/model.hpp>
#include <axial/scene/consistency.hpp>
#include <axial/scene/mounted_payload.hpp>
#include <axial/scene/status_text.hpp>

// Last, behind what they include.
#include <axial/dynamics/plain_arrays.hpp>
#include <axial/dynamics/role_checks.hpp>

#include <axial/control/plain_arrays.hpp>
#include <axial/control/role_checks.hpp>

// Behind plain_arrays.hpp: what stands between it and the user is a line more of each of its messages.
#include <axial/dynamics/derivatives_on_arrays.hpp>
#include <axial/dynamics/models_on_arrays.hpp>

// Behind all of them.
#include <axial/dynamics/braces.hpp>

#include <axial/control/braces.hpp>
