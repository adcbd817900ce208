/* The main job in C99. */
#include "arm_in_c.h"

int main(void) {
  arm_state state = {{{0}}};
  arm_joints q = {{0.3F, -0.5F, 0.1F}}, qd = {{1.0F, 0.5F, 0.2F}}, qdd = {{2.0F, 0.0F, 1.0F}}, tau, acc;
  arm_matrix m;
  fixed_arm_formats formats;
  axial_status status = arm_feedforward(&state, &q, &qd, &qdd, &tau);
  int right = status.code == AXIAL_OK && axial_status_text(status)[0] != 0;
  right = right && arm_forward_dynamics(&q, &qd, &tau, &acc).code == AXIAL_OK && acc.of[0] > 1.99F && acc.of[0] < 2.01F;
  arm_mass_matrix(&q, &m);
  fixed_arm_get_formats(&formats);
  qd.of[0] = 9.0F;
  status = arm_feedforward(&state, &q, &qd, &qdd, &tau);
  return right && status.code == AXIAL_SPEED_LIMIT && status.joint == 0 && m.of[0][1] == m.of[1][0] &&
                 AXIAL_VERSION_NUMBER >= 100
             ? 0
             : 1;
}
