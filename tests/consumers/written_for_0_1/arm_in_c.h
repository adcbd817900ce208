/* The arm for C. */
#ifndef ARM_IN_C_H
#define ARM_IN_C_H
#include <axial/axial.h>

AXIAL_C_DECLARE(arm, 3, float);
AXIAL_C_DECLARE(fixed_arm, 3, fixed32);

#endif
