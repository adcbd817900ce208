#include "elastic_c_side.h"

#define ASK_MOTORS(arm)                                                                                    \
  arm##_motors ask_##arm##_motors(const arm##_motion* x) {                                                 \
    arm##_motors answers;                                                                                  \
    answers.status =                                                                                       \
        arm##_elastic_feedforward(&x->of[0], &x->of[1], &x->of[2], &x->of[3], &x->of[4], &answers.motors); \
    return answers;                                                                                        \
  }

ASK_MOTORS(elastic_arm)
ASK_MOTORS(double_elastic_arm)
