/* The SCARA for C, in float and in fixed point. */
#ifndef ARM_H
#define ARM_H

#include <axial/axial.h>

AXIAL_C_DECLARE(arm, 3, float);
AXIAL_C_DECLARE(fixed_arm, 3, fixed32);

#endif
