/// The one C++ source of the arm.

#include "arm.h"

#include <axial/c_interface/export.hpp>
#include <axial/fixed/c_interface/fixed_calls.hpp>
#include <robots/scara.hpp>

AXIAL_C_EXPORT(arm, robots::Scara, float)
AXIAL_C_EXPORT(fixed_arm, robots::Scara, fixed32)
