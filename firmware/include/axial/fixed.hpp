// Fixed point: the plug-in. With it Fixed32 and Fixed16 are numbers of every algorithm.
#pragma once
#include <axial/scalar/language.hpp>

// What refuses arguments, each from here: a compiler names the headers on the way before the sentence.
#include <axial/robot/chain.hpp>
#include <axial/scene/scene.hpp>

#include <axial/scene/joints.hpp>

#include <axial/scene/refused_calls.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/separation/separation.hpp>

#include <axial/control/feedforward.hpp>

#include <axial/control/gravity_compensation.hpp>

#include <axial/fixed/formats/joint_formats.hpp>

#include <axial/fixed/formats/input_formats.hpp>

#include <axial/calls/registry.hpp>

#include <axial/calls/arguments.hpp>

#include <axial/calls/on_arrays.hpp>

#include <axial/axial.hpp>

#include <axial/fixed/closed_form/scara.hpp>
#include <axial/fixed/control/border.hpp>
#include <axial/fixed/control/encoder.hpp>
#include <axial/fixed/control/fall_back.hpp>
#include <axial/fixed/control/momentum_observer.hpp>
#include <axial/fixed/control/observer_error.hpp>
#include <axial/fixed/control/payload_error.hpp>
#include <axial/fixed/control/payload_estimator.hpp>
#include <axial/fixed/control/tool_border.hpp>
#include <axial/fixed/control/tracking.hpp>
#include <axial/fixed/derivatives/derivative_error.hpp>
#include <axial/fixed/derivatives/derivatives.hpp>
#include <axial/fixed/derivatives/forward_derivatives.hpp>
#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>
#include <axial/fixed/dynamics/forward_dynamics.hpp>
#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/dynamics/kinematics.hpp>
#include <axial/fixed/dynamics/mass_matrix.hpp>
#include <axial/fixed/dynamics/momentum.hpp>
#include <axial/fixed/error_bound.hpp>
#include <axial/fixed/limits/state_check.hpp>
#include <axial/fixed/separation/separated_error.hpp>
#include <axial/fixed/separation/separated_torque.hpp>
#include <axial/fixed/tool/tool_motion.hpp>
