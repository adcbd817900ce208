/* Every function of the interface, called from C99. */
#ifndef C_SIDE_H
#define C_SIDE_H

#include <firmware/apps/c_interface/arm.h>

#define ANSWERS_OF(arm)                                       \
  typedef struct {                                            \
    arm##_joints safe, inverse, gravity, acceleration, power; \
    arm##_matrix mass;                                        \
    arm##_pose tool;                                          \
    axial_status safe_status, status[6];                      \
  } arm##_answers;                                            \
  AXIAL_C_FUNCTION arm##_answers ask_##arm(const arm##_joints* q, const arm##_joints* qd, const arm##_joints* qdd)

ANSWERS_OF(arm);
ANSWERS_OF(fixed_arm);

AXIAL_C_DECLARE_DERIVATIVES(arm);
AXIAL_C_DECLARE(double_arm, 3, double);
AXIAL_C_DECLARE_DERIVATIVES(double_arm);
AXIAL_C_DECLARE_DERIVATIVES(fixed_arm);
AXIAL_C_DECLARE_DERIVATIVE_FORMATS(fixed_arm);

#define DERIVATIVES_OF(arm)                                                                                 \
  typedef struct {                                                                                          \
    arm##_inverse_derivatives inverse;                                                                      \
    arm##_forward_derivatives forward;                                                                      \
    axial_status inverse_status, forward_status;                                                            \
  } arm##_derivatives;                                                                                      \
  AXIAL_C_FUNCTION arm##_derivatives ask_##arm##_derivatives(const arm##_joints* q, const arm##_joints* qd, \
                                                             const arm##_joints* x)

/** x: accelerations to the one, efforts to the other. */
DERIVATIVES_OF(arm);
DERIVATIVES_OF(double_arm);
DERIVATIVES_OF(fixed_arm);

/** Formats as C asks for them. */
AXIAL_C_FUNCTION axial_status ask_derivative_formats(fixed_arm_derivative_formats* formats);

/** The text of each code from 0 on, as C's own copy of the function gives it. */
AXIAL_C_FUNCTION const char* c_text(int code);

#endif
