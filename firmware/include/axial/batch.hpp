// Several states at once, on a host: batches of floats and doubles as numbers of the library.
#pragma once

#include <axial/axial.hpp>
#include <axial/control/batch_checks.hpp>
#include <axial/dynamics/batch_check_finite.hpp>
#include <axial/links/batch_soundness.hpp>
#include <axial/scene/batch_joints.hpp>
