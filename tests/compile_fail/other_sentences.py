"""Sentences that no combination and no beginner's mistake is about: a row has a part of the sentence, headers, what stands at the top of
the program, and what stands in a function. q, qd, qdd, tau are in float; those of fixed point have a W behind.
"""

import collections

Other = collections.namedtuple("Other", "sentence headers declared code")

PROLOGUE = """#include <axial/axial.hpp>
#include <axial/fixed.hpp>
{includes}using namespace axial;
using W = Fixed32;
#define JOINT revolute().a(0.4).mass(2.0).com(0.2, 0, 0).inertia_com(0.01, 0.02, 0.02)
#define LIMITED JOINT.speed_limit(3.0).acceleration_limit(20.0).effort_limit(60.0)
struct Arm {{ static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), LIMITED, LIMITED); }};
struct Longer {{ static constexpr auto chain = axial::chain(gravity(0, -9.81, 0), LIMITED, LIMITED, LIMITED); }};
struct Tuning {{
  static constexpr double period = 1e-3, gain = 100.0, fraction = 0.1, uncertainty = 1.0, release = 0.5;
  static constexpr double deviation = 0.01, memory = 1.0, mass_deviation = 1.0, moment_deviation = 1.0;
  static constexpr int confirm = 1, calm = 3;
}};
Positions<Arm, float> q;
Velocities<Arm, float> qd;
Accelerations<Arm, float> qdd;
EffortsOf<Arm, float> tau;
Positions<Arm, W> qW;
Velocities<Arm, W> qdW;
Accelerations<Arm, W> qddW;
EffortsOf<Arm, W> tauW;
Positions<Longer, float> longer;
"""
SWIMMER = "using Swimmer = Scene<Arm, Gravity, Underwater>;\n"
COUPLED = "using Coupled = Scene<Arm, Gravity, RotorInertia, RotorDynamics>;\n"


def scara(sentence, gravity, links):
    return Other(sentence, (), f"struct Scara {{ static constexpr auto chain = axial::chain(gravity({gravity}), {links}); }};\n"
                 "Positions<Scara, float> at;\n", "auto r = closed_form::scara<Scara>(at);")


def observed(sentence, tuning):
    return Other(sentence, (), f"struct Bad : Tuning {{ static constexpr {tuning}; }};\nObserverState<Arm, float, Bad> state;\n",
                 "auto r = observe<Arm, float, Bad>(state, q, qd, tau);")


TURN, SLIDE = "revolute().a(0.2).mass(1)", "prismatic().mass(1)"
ALL = [
    scara("closed_form::scara needs a serial chain", "0, 0, -9.81", f"{TURN}, {TURN}, {SLIDE}.parent(0)"),
    scara("closed_form::scara needs parallel axes", "0, 0, -9.81", f"{TURN}, {TURN}.alpha_deg(90), {SLIDE}"),
    scara("closed_form::scara needs theta_deg(0)", "0, 0, -9.81", f"{TURN}, {TURN}, {SLIDE}.theta_deg(90)"),
    scara("closed_form::scara needs gravity along the axes", "0, -9.81, 0", f"{TURN}, {TURN}, {SLIDE}"),
    Other("a detector's fraction and uncertainty are not negative", (), "struct Bad : Tuning { static constexpr double fraction = -1.0; };\n"
          "ObserverState<Arm, float, Bad> state;\nCollisionState collision;\n", "auto r = detect(collision, state.residual);"),
    observed("an observer's period is positive", "double period = 0.0"),
    observed("an observer's gain is positive", "double gain = 0.0"),
    Other("a load changes where the scene names Payload", (), "ObserverState<Arm, float, Tuning> state;\nInputs<Arm, float> in;\n",
          "auto r = change_load<Arm, float, Tuning>(state, q, qd, in);"),
    Other("deviation and memory are positive", ("control/payload_estimator",), "struct Bad : Tuning { static constexpr double memory = 0.0; };\n"
          "PayloadState<Arm, float> state;\nObserverState<Arm, float, Bad> observer;\n",
          "auto r = update_payload<Arm, float, Bad>(state, q, qd, observer.residual);"),
    Other("current_limits() takes one rating per joint", ("control/current_limit",), "DriveRating ratings[3];\n",
          "auto r = current_limits<Arm, float>(ratings, 1e-3);"),
    Other("current limits are in float or double", ("control/current_limit",), "DriveRating ratings[2];\n",
          "auto r = current_limits<Arm, W>(ratings, 1e-3);"),
    Other("check_finite takes joint values of one robot together", (), "", "auto r = check_finite(q, qd, longer);"),
    Other("derivatives have no water", ("derivatives/inverse_dynamics_derivatives",), SWIMMER,
          "auto r = inverse_dynamics_derivatives<Swimmer>(q, qd, qdd);"),
    Other("derivatives have no rotors as bodies", ("derivatives/inverse_dynamics_derivatives",), COUPLED,
          "auto r = inverse_dynamics_derivatives<Coupled>(q, qd, qdd);"),
    Other("derivatives along a direction have no formats in fixed point", ("derivatives/inverse_dynamics_along",),
          "MotionDirection<Arm, W> direction;\n", "auto r = inverse_dynamics_along<Arm>(qW, qdW, qddW, direction);"),
    Other("the robot has no such link; links are counted from 0", (), "", "auto r = jacobian<Arm, 5>(q);"),
    Other("torque rates have no water", ("derivatives/torque_rates",), SWIMMER, "auto r = torque_rates<Swimmer>(q, qd, qdd, q);"),
    Other("a regressor has no water", ("derivatives/torque_regressor",), SWIMMER, "auto r = torque_regressor<Swimmer>(q, qd, qdd);"),
    Other("a regressor has no rotors as bodies", ("derivatives/torque_regressor",), COUPLED, "auto r = torque_regressor<Coupled>(q, qd, qdd);"),
    Other("a regressor has no formats in fixed point", ("derivatives/torque_regressor",), "", "auto r = torque_regressor<Arm>(qW, qdW, qddW);"),
    Other("ElasticState holds float or double", ("elastic/elastic_feedforward", "elastic/elastic_damping"), "", "constexpr auto size = sizeof(ElasticState<Arm, W>);"),
    Other("answers are certified in Fixed32", ("fixed/dynamics/certified_forward_dynamics",), "", "auto r = certified_forward_dynamics<Arm>(q, qd, tau);"),
    Other("an encoder has two counts a turn at least", ("fixed/control/encoder",), "", "RotaryEncoder<1> encoder;"),
    Other("an encoder's direction is 1 or -1", ("fixed/control/encoder",), "", "RotaryEncoder<4096, 0, 2> encoder;"),
    Other("an encoder has one count a metre at least", ("fixed/control/encoder",), "", "LinearEncoder<0> encoder;"),
    Other("a batch holds floats or doubles", ("batch",), "", "Batch<int, 4> lanes;"),
    Other("a batch has 2, 4, 8, ... lanes", ("batch",), "", "Batch<float, 3> lanes;"),
]
