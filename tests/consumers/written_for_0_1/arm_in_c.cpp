// The arm for C: its definition.
#include "arm_in_c.h"

#include <axial/c_interface/export.hpp>
#include <axial/fixed/c_interface/fixed_calls.hpp>

#include "arm.hpp"

AXIAL_C_EXPORT(arm, Arm, float)
AXIAL_C_EXPORT(fixed_arm, Arm, fixed32)
