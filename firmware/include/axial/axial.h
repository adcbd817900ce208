/** \file
 * The plain C interface of a robot: C99, no name mangling, nothing allocated, state in the caller's hands.
 * A header declares it:        AXIAL_C_DECLARE(my_arm, 6, float);                in C and in C++
 * one C++ source defines it:   AXIAL_C_EXPORT(my_arm, robots::MyArm, float)      <axial/c_interface/export.hpp>
 * doc/guides/embedding.md has both files whole. */
#ifndef AXIAL_AXIAL_H
#define AXIAL_AXIAL_H

#include <axial/version.h>
#include <stdint.h>

/** Before every function that a header declares: it has C's name in C++ too. */
#ifdef __cplusplus
#define AXIAL_C_FUNCTION extern "C"
#else
#define AXIAL_C_FUNCTION extern
#endif

/** What a call says besides its numbers: axial::Status::Code (scene/status.hpp), and the one that only C can earn. */
typedef enum {
  AXIAL_OK = 0,
  AXIAL_NEAR_SINGULAR = 1,
  AXIAL_NOT_FINITE = 2,
  AXIAL_POSITION_LIMIT = 3,
  AXIAL_SPEED_LIMIT = 4,
  AXIAL_ACCELERATION_LIMIT = 5,
  AXIAL_EFFORT_LIMIT = 6,
  AXIAL_PAYLOAD_LIMIT = 7,
  AXIAL_NOT_READY = 8,
  AXIAL_SATURATED = 9,
  AXIAL_RESCALED = 10,
  AXIAL_INPUT_LIMIT = 11,
  AXIAL_ANGLE_RANGE = 12,
  AXIAL_INACCURATE = 13,
  AXIAL_EFFORT_RATE = 14,
  AXIAL_COMMAND_LIMIT = 15,
  AXIAL_CURRENT_LIMIT = 16,
  AXIAL_NULL_ARGUMENT = 32
} axial_code;

/** `code` is an axial_code (an int, whatever size a compiler gives its enums); `joint` is counted from 0 at the base,
 * -1 for none. */
typedef struct {
  int code;  /**< an axial_code */
  int joint; /**< what it is about: from 0 at the base, -1 for none */
} axial_status;

/** A sentence's worth of text for an axial_code; never a null pointer. */
static inline const char* axial_code_text(int code) {
  switch (code) {
    case AXIAL_OK:
      return "ok";
    case AXIAL_NEAR_SINGULAR:
      return "near singular: the joint's inertia is lost in rounding";
    case AXIAL_NOT_FINITE:
      return "an input or a result is NaN or infinite";
    case AXIAL_POSITION_LIMIT:
      return "position outside the declared limits";
    case AXIAL_SPEED_LIMIT:
      return "speed outside the declared limit";
    case AXIAL_ACCELERATION_LIMIT:
      return "acceleration outside the declared limit";
    case AXIAL_EFFORT_LIMIT:
      return "effort clamped to the declared limit";
    case AXIAL_PAYLOAD_LIMIT:
      return "payload beyond the declared maximum";
    case AXIAL_NOT_READY:
      return "asked before the first good refresh";
    case AXIAL_SATURATED:
      return "efforts drive the joint beyond the range of its formats";
    case AXIAL_RESCALED:
      return "efforts beyond the declared ones: right, but less exact";
    case AXIAL_INPUT_LIMIT:
      return "a run-time input is beyond the declared limit";
    case AXIAL_ANGLE_RANGE:
      return "an angle of so many turns that its sine is not exact";
    case AXIAL_INACCURATE:
      return "the inertia matrix is too ill-conditioned for the documented error";
    case AXIAL_EFFORT_RATE:
      return "change of effort limited to the declared step";
    case AXIAL_COMMAND_LIMIT:
      return "position command limited to the joint's range or to the largest offset";
    case AXIAL_CURRENT_LIMIT:
      return "effort limited to the current that the winding's heat allows";
    case AXIAL_NULL_ARGUMENT:
      return "an argument is a null pointer";
    default:
      return "unknown status code";
  }
}
/** The text of a status' code; the joint is the caller's to print. */
static inline const char* axial_status_text(axial_status of) { return axial_code_text(of.code); }

/** Numbers by name: what an element of an array is. */
/**@{*/
#define AXIAL_C_NUMBER_float float
#define AXIAL_C_NUMBER_double double
#define AXIAL_C_NUMBER_fixed32 int32_t
/**@}*/

/** What only fixed point has: formats, and the border to real numbers. */
/**@{*/
#define AXIAL_C_DECLARE_MORE_float(prefix, joints)
#define AXIAL_C_DECLARE_MORE_double(prefix, joints)
#define AXIAL_C_DECLARE_MORE_fixed32(prefix, joints)                                                         \
  typedef struct {                                                                                           \
    float of[joints];                                                                                        \
  } prefix##_real;                                                                                           \
  typedef struct {                                                                                           \
    int8_t revolute[joints], position[joints], velocity[joints], acceleration[joints], effort[joints],       \
        free_acceleration[joints], mass_matrix[joints][joints], rotation, length, power[joints];             \
  } prefix##_formats;                                                                                        \
  AXIAL_C_FUNCTION axial_status prefix##_get_formats(prefix##_formats* formats);                             \
  AXIAL_C_FUNCTION axial_status prefix##_to_fixed(const prefix##_real* real_q, const prefix##_real* real_qd, \
                                                  const prefix##_real* real_qdd, prefix##_joints* q,         \
                                                  prefix##_joints* qd, prefix##_joints* qdd);                \
  AXIAL_C_FUNCTION axial_status prefix##_efforts_to_real(const prefix##_joints* tau, prefix##_real* real_tau);
/**@}*/

/** The C functions of every robot, a line each: ROW(prefix, with, name in C, the library's, order of joint values,
 * result's type and name). */
/**@{*/
#define AXIAL_C_ALGORITHMS(ROW, prefix, with)                                \
  ROW(prefix, with, inverse_dynamics, inverse_dynamics, motion, joints, tau) \
  ROW(prefix, with, actuator_power, actuator_power, motion, joints, power)   \
  ROW(prefix, with, gravity, gravity_torque, position, joints, tau)          \
  ROW(prefix, with, forward_dynamics, forward_dynamics, driven, joints, qdd) \
  ROW(prefix, with, mass_matrix, mass_matrix, position, matrix, m)           \
  ROW(prefix, with, tool_pose, forward_kinematics, position, pose, pose)
#define AXIAL_C_TAKEN_position(prefix) const prefix##_joints* q
#define AXIAL_C_TAKEN_state(prefix) AXIAL_C_TAKEN_position(prefix), const prefix##_joints* qd
#define AXIAL_C_TAKEN_motion(prefix) AXIAL_C_TAKEN_state(prefix), const prefix##_joints* qdd
#define AXIAL_C_TAKEN_driven(prefix) AXIAL_C_TAKEN_state(prefix), const prefix##_joints* tau
#define AXIAL_C_TAKEN_highest(prefix) AXIAL_C_TAKEN_motion(prefix), const prefix##_joints *q3, const prefix##_joints *q4
/* NOLINTBEGIN(bugprone-macro-parentheses): a parameter's name */
#define AXIAL_C_DECLARED(prefix, with, name, algorithm, order, type, result) \
  AXIAL_C_FUNCTION axial_status prefix##_##name(AXIAL_C_TAKEN_##order(prefix), prefix##_##type* result);
/* NOLINTEND(bugprone-macro-parentheses) */
/**@}*/

/** Declares the types and functions of a robot with so many joints; `number` is float, double or fixed32.
 * q in rad or m, qd and qdd its derivatives, tau in N m or N; M(i, j) in kg m^2, kg m, kg; the tool's pose in the
 * world. fixed32: raw words; value = raw 2^-exponent with the exponents of `<prefix>_formats`, revolute positions
 * (where `revolute` is 1) are raw 2 pi / 2^32 rad. Every function gives AXIAL_NULL_ARGUMENT for a null pointer, and
 * refuses (result untouched) what is not finite, asked or answered, and angles of so many turns that sines are not
 * exact; in fixed32 what is outside the declared limits.
 * `<prefix>_feedforward` is the one for a control loop: limits checked, efforts clamped, the last safe torque where a
 * request is refused; start its state with {0}. Called as a declaration, with a semicolon. */
#define AXIAL_C_DECLARE(prefix, joints, number)                                                                 \
  typedef struct {                                                                                              \
    AXIAL_C_NUMBER_##number of[joints];                                                                         \
  } prefix##_joints;                                                                                            \
  typedef struct {                                                                                              \
    prefix##_joints last_safe;                                                                                  \
  } prefix##_state;                                                                                             \
  typedef struct {                                                                                              \
    AXIAL_C_NUMBER_##number of[joints][joints];                                                                 \
  } prefix##_matrix;                                                                                            \
  typedef struct {                                                                                              \
    AXIAL_C_NUMBER_##number rotation[3][3];                                                                     \
    AXIAL_C_NUMBER_##number position[3];                                                                        \
  } prefix##_pose;                                                                                              \
  AXIAL_C_DECLARE_MORE_##number(prefix, joints) AXIAL_C_ALGORITHMS(AXIAL_C_DECLARED, prefix, )                  \
      AXIAL_C_FUNCTION axial_status prefix##_feedforward(prefix##_state* state, const prefix##_joints* q,       \
                                                         const prefix##_joints* qd, const prefix##_joints* qdd, \
                                                         prefix##_joints* tau)

/** Declares the derivatives of a robot behind its AXIAL_C_DECLARE:
 * `<prefix>_inverse_dynamics_derivatives` gives efforts, mass matrix M = d tau / d qdd, d tau_i / d q_j and
 * d tau_i / d qd_j in of[i][j]; `<prefix>_forward_dynamics_derivatives` accelerations, M^-1 = d qdd / d tau,
 * d qdd_i / d q_j and d qdd_i / d qd_j at given efforts. Both refuse what the other functions do, result untouched;
 * AXIAL_NEAR_SINGULAR and AXIAL_INACCURATE come with a result; in fixed32 also AXIAL_RESCALED,
 * AXIAL_ACCELERATION_LIMIT (dqdd_dq is 0 then) and AXIAL_SATURATED (what does not fit is 0). Raw words there: see
 * AXIAL_C_DECLARE_DERIVATIVE_FORMATS. AXIAL_C_EXPORT_DERIVATIVES(my_arm, robots::MyArm, float) of
 * <axial/c_interface/derivatives.hpp> defines them. Called as a declaration, with a semicolon. */
#define AXIAL_C_DECLARE_DERIVATIVES(prefix)                                            \
  typedef struct {                                                                     \
    prefix##_joints tau;                                                               \
    prefix##_matrix mass_matrix, dtau_dq, dtau_dqd;                                    \
  } prefix##_inverse_derivatives;                                                      \
  typedef struct {                                                                     \
    prefix##_joints qdd;                                                               \
    prefix##_matrix inverse_mass_matrix, dqdd_dq, dqdd_dqd;                            \
  } prefix##_forward_derivatives;                                                      \
  AXIAL_C_FUNCTION axial_status prefix##_inverse_dynamics_derivatives(                 \
      const prefix##_joints* q, const prefix##_joints* qd, const prefix##_joints* qdd, \
      prefix##_inverse_derivatives* result);                                           \
  AXIAL_C_FUNCTION axial_status prefix##_forward_dynamics_derivatives(                 \
      const prefix##_joints* q, const prefix##_joints* qd, const prefix##_joints* tau, \
      prefix##_forward_derivatives* result)

/** Declares the feed-forward of a robot whose joints are elastic, behind its AXIAL_C_DECLARE (float or double):
 * `<prefix>_elastic_feedforward` gives torque tau_m, position theta and velocity thetad of every motor, behind the
 * gear, and what the transmission carries, tau_l, for a motion of the links with derivatives up to the fourth: q3 and
 * q4 in rad/s^3 and rad/s^4, or m. It refuses what is not finite, result untouched. AXIAL_C_EXPORT_ELASTIC(my_arm,
 * robots::MyArm, float) of <axial/c_interface/elastic.hpp> defines it. Called as a declaration, with a semicolon. */
#define AXIAL_C_DECLARE_ELASTIC(prefix)                                                                             \
  typedef struct {                                                                                                  \
    prefix##_joints tau_m, theta, thetad, tau_l;                                                                    \
  } prefix##_elastic;                                                                                               \
  AXIAL_C_FUNCTION axial_status prefix##_elastic_feedforward(const prefix##_joints* q, const prefix##_joints* qd,   \
                                                             const prefix##_joints* qdd, const prefix##_joints* q3, \
                                                             const prefix##_joints* q4, prefix##_elastic* result)

/** Declares the formats of a robot's derivatives in fixed32, behind AXIAL_C_DECLARE_DERIVATIVES: each entry is raw
 * 2^-exponent with the exponent at its place; efforts and accelerations are those of `<prefix>_formats`.
 * AXIAL_C_EXPORT_DERIVATIVE_FORMATS(my_arm, robots::MyArm) of <axial/fixed/c_interface/derivative_formats.hpp> defines
 * the function. Called as a declaration, with a semicolon. */
#define AXIAL_C_DECLARE_DERIVATIVE_FORMATS(prefix)                                          \
  typedef struct {                                                                          \
    prefix##_matrix mass_matrix, dtau_dq, dtau_dqd, inverse_mass_matrix, dqdd_dq, dqdd_dqd; \
  } prefix##_derivative_formats;                                                            \
  AXIAL_C_FUNCTION axial_status prefix##_get_derivative_formats(prefix##_derivative_formats* formats)

#endif /* AXIAL_AXIAL_H */
