/* A control loop in C99: a request a tick, its torque in float and in fixed point, printed word by word. */

#include <string.h>

#include "arm.h"
#include "board.h"

enum { joints = 3, rows = 16 };

/* What the loop remembers: the last safe torques. */
static arm_state state = {{{0}}};
static fixed_arm_state fixed_state = {{{0}}};

/* From rest with constant accelerations; the last request is too fast for the second joint. */
static void request(uint32_t row, arm_joints* q, arm_joints* qd, arm_joints* qdd) {
  static const float acceleration[3] = {2.0F, -3.0F, 0.5F};
  const float t = 0.03125F * (float)row;
  int i;
  for (i = 0; i < joints; ++i) {
    qdd->of[i] = acceleration[i];
    qd->of[i] = acceleration[i] * t;
    q->of[i] = 0.5F * acceleration[i] * t * t;
  }
  if (row == rows - 1) qd->of[1] = 8.0F;
}

static void print_word(uint32_t word) {
  board_print(",");
  board_print_hex(word);
}
static void print_status(axial_status status) {
  print_word((uint32_t)status.code);
  print_word((uint32_t)status.joint);
}

static axial_status print_float(const arm_joints* q, const arm_joints* qd, const arm_joints* qdd) {
  arm_joints tau;
  const axial_status status = arm_feedforward(&state, q, qd, qdd, &tau);
  int i;
  for (i = 0; i < joints; ++i) {
    uint32_t word;
    memcpy(&word, &tau.of[i], sizeof word);
    print_word(word);
  }
  print_status(status);
  return status;
}

static void print_fixed(const arm_joints* q, const arm_joints* qd, const arm_joints* qdd) {
  fixed_arm_real real_q, real_qd, real_qdd;
  fixed_arm_joints fixed_q, fixed_qd, fixed_qdd, tau;
  axial_status status;
  int i;
  for (i = 0; i < joints; ++i) {
    real_q.of[i] = q->of[i];
    real_qd.of[i] = qd->of[i];
    real_qdd.of[i] = qdd->of[i];
  }
  status = fixed_arm_to_fixed(&real_q, &real_qd, &real_qdd, &fixed_q, &fixed_qd, &fixed_qdd);
  fixed_arm_feedforward(&fixed_state, &fixed_q, &fixed_qd, &fixed_qdd, &tau);
  for (i = 0; i < joints; ++i)
    print_word((uint32_t)tau.of[i]);
  print_status(status);
}

static void tick(uint32_t row) {
  arm_joints q, qd, qdd;
  axial_status status;
  request(row, &q, &qd, &qdd);
  board_print("c");
  print_word(row);
  status = print_float(&q, &qd, &qdd);
  print_fixed(&q, &qd, &qdd);
  board_print("\n");
  print_reference(row, &q, &qd, &qdd);
  if (status.code != AXIAL_OK) {
    board_print("refused: ");
    board_print(axial_status_text(status));
    board_print("\n");
  }
}

static void print_effort_exponents(void) {
  fixed_arm_formats formats;
  int i;
  fixed_arm_get_formats(&formats);
  board_print("exponents");
  for (i = 0; i < joints; ++i)
    print_word((uint32_t)formats.effort[i]);
  board_print("\n");
}

int main(void) {
  uint32_t row;
  board_start(1000);
  print_effort_exponents();
  for (row = 0; row < rows; ++row) {
    board_wait_for_tick();
    tick(row);
  }
  board_print("end\n");
  board_exit(0);
  return 0;
}
