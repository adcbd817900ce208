/* The feed-forward of elastic joints, called from C99. */
#ifndef ELASTIC_C_SIDE_H
#define ELASTIC_C_SIDE_H

#include <axial/axial.h>

AXIAL_C_DECLARE(elastic_arm, 3, float);
AXIAL_C_DECLARE_ELASTIC(elastic_arm);
AXIAL_C_DECLARE(double_elastic_arm, 3, double);
AXIAL_C_DECLARE_ELASTIC(double_elastic_arm);

/** A motion's positions and their four derivatives, and what the motors do for it. */
#define MOTORS_OF(arm)    \
  typedef struct {        \
    arm##_joints of[5];   \
  } arm##_motion;         \
  typedef struct {        \
    arm##_elastic motors; \
    axial_status status;  \
  } arm##_motors;         \
  AXIAL_C_FUNCTION arm##_motors ask_##arm##_motors(const arm##_motion* motion)

MOTORS_OF(elastic_arm);
MOTORS_OF(double_elastic_arm);

#endif
