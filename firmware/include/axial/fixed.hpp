// Fixed point: the plug-in. With it Fixed32 and Fixed16 are numbers of every algorithm.
#pragma once

// What refuses arguments, each from here: a compiler names the headers on the way before the sentence.
#include <axial/dynamics/plain_arrays.hpp>

#include <axial/dynamics/role_checks.hpp>

#include <axial/control/plain_arrays.hpp>

#include <axial/control/role_checks.hpp>

#include <axial/axial.hpp>

#include <axial/fixed/closed_form/scara.hpp>
#include <axial/fixed/control/border.hpp>
#include <axial/fixed/control/collision.hpp>
#include <axial/fixed/control/encoder.hpp>
#include <axial/fixed/control/fall_back.hpp>
#include <axial/fixed/control/observer_error.hpp>
#include <axial/fixed/control/payload_border.hpp>
#include <axial/fixed/control/payload_error.hpp>
#include <axial/fixed/control/payload_words.hpp>
#include <axial/fixed/control/tool_border.hpp>
#include <axial/fixed/control/tracking.hpp>
#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>
#include <axial/fixed/dynamics/derivative_error.hpp>
#include <axial/fixed/dynamics/derivatives.hpp>
#include <axial/fixed/dynamics/forward_derivatives.hpp>
#include <axial/fixed/dynamics/forward_dynamics.hpp>
#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/dynamics/kinematics.hpp>
#include <axial/fixed/dynamics/mass_matrix.hpp>
#include <axial/fixed/dynamics/momentum.hpp>
#include <axial/fixed/dynamics/separated_error.hpp>
#include <axial/fixed/dynamics/separated_torque.hpp>
#include <axial/fixed/dynamics/tool_motion.hpp>
#include <axial/fixed/error_bound.hpp>
#include <axial/fixed/limits/position_check.hpp>
