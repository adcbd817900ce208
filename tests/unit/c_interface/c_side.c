#include "c_side.h"

#define ASK(arm)                                                                                    \
  arm##_answers ask_##arm(const arm##_joints* q, const arm##_joints* qd, const arm##_joints* qdd) { \
    arm##_answers answers;                                                                          \
    arm##_state state = {{{0}}};                                                                    \
    answers.safe_status = arm##_feedforward(&state, q, qd, qdd, &answers.safe);                     \
    answers.status[0] = arm##_inverse_dynamics(q, qd, qdd, &answers.inverse);                       \
    answers.status[1] = arm##_gravity(q, &answers.gravity);                                         \
    answers.status[2] = arm##_forward_dynamics(q, qd, &answers.inverse, &answers.acceleration);     \
    answers.status[3] = arm##_mass_matrix(q, &answers.mass);                                        \
    answers.status[4] = arm##_tool_pose(q, &answers.tool);                                          \
    answers.status[5] = arm##_actuator_power(q, qd, qdd, &answers.power);                           \
    return answers;                                                                                 \
  }

ASK(arm)
ASK(fixed_arm)

#define ASK_DERIVATIVES(arm)                                                                                        \
  arm##_derivatives ask_##arm##_derivatives(const arm##_joints* q, const arm##_joints* qd, const arm##_joints* x) { \
    arm##_derivatives answers;                                                                                      \
    answers.inverse_status = arm##_inverse_dynamics_derivatives(q, qd, x, &answers.inverse);                        \
    answers.forward_status = arm##_forward_dynamics_derivatives(q, qd, x, &answers.forward);                        \
    return answers;                                                                                                 \
  }

ASK_DERIVATIVES(arm)
ASK_DERIVATIVES(double_arm)
ASK_DERIVATIVES(fixed_arm)

axial_status ask_derivative_formats(fixed_arm_derivative_formats* formats) {
  return fixed_arm_get_derivative_formats(formats);
}

const char* c_text(int code) { return axial_code_text(code); }
