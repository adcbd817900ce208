"""Sentences that no combination and no beginner's mistake is about: a row has a part of the sentence, headers, what stands at the top of
the program, and what stands in a function. q, qd, qdd, tau are in float; those of fixed point have a W behind.
"""

import collections

Other = collections.namedtuple("Other", "sentence headers declared code times", defaults=[1])  # times: how often it is said

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
  static constexpr int confirm = 1, calm = 3, most_counts = 100, direction = 1;
  static constexpr double effort_a_count = 0.1;
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


def scara(sentence, *broken):
    """Each robot (gravity, links) breaks one condition."""
    structs = "".join(f"struct Scara{k} {{ static constexpr auto chain = axial::chain(gravity({gravity}), {', '.join(links)}); }};\n"
                      for k, (gravity, links) in enumerate(broken))
    code = "\n  ".join(f"{{ Positions<Scara{k}, float> at; auto r = closed_form::scara<Scara{k}>(at); }}" for k in range(len(broken)))
    return Other("closed_form::scara needs " + sentence, (), structs, code, len(broken))


def changed(*more):
    """A SCARA, its links in turn with one of these behind them; empty: as it is."""
    for link, each_more in enumerate(more):
        if each_more:
            yield DOWN, [row + (each_more if k == link else "") for k, row in enumerate((TURN, TURN, SLIDE))]


OBSERVED = "ObserverState<Arm, float, Bad> state; auto r = observe<Arm, float, Bad>(state, q, qd, tau);"


def each(sentence, broken, code, headers=()):
    """One sentence of several conditions, each broken alone: by a Tuning, which code names Bad."""
    structs = "".join(f"struct Bad{k} : Tuning {{ static constexpr {member}; }};\n" for k, member in enumerate(broken))
    return Other(sentence, headers, structs, "\n  ".join(f"{{ {code.replace('Bad', f'Bad{k}')} }}" for k in range(len(broken))), len(broken))


DOWN, TURN, SLIDE = "0, 0, -9.81", "revolute().a(0.2).mass(1)", "prismatic().mass(1)"
ALL = [
    scara("three joints: revolute, revolute, prismatic (RRP)", (DOWN, (SLIDE, TURN, SLIDE)), (DOWN, (TURN, SLIDE, SLIDE)), (DOWN, (TURN, TURN, TURN)),
          (DOWN, (TURN, TURN)), (DOWN, (TURN, TURN, SLIDE, TURN))),
    scara("a serial chain", *changed("", ".parent(-1)", ".parent(0)")),
    scara("parallel axes", *changed(*[".alpha_deg(90)"] * 3)),
    scara("centres of mass on the links' x axes", *changed(*[".com(0, 0.1, 0)"] * 3)),
    scara("theta_deg(0)", *changed("", "", ".theta_deg(90)")),
    scara("gravity along the axes", ("0, -9.81, 0", (TURN, TURN, SLIDE)), ("-9.81, 0, 0", (TURN, TURN, SLIDE))),
    each("a detector's fraction and uncertainty are not negative", ("double fraction = -0.1", "double uncertainty = -0.1", "double release = 0.0",
         "double release = 1.1", "int confirm = 0", "int calm = 0"),
         "ObserverState<Arm, float, Bad> state; CollisionState collision; auto r = detect(collision, state.residual);"),
    each("an observer's period is positive", ("double period = 0.0", "double period = 1e6"), OBSERVED),
    each("an observer's gain is positive", ("double gain = 0.0", "double gain = 1e9"), OBSERVED),
    each("a controlled stop needs a period in (0, 1) s and", ("double period = 0.0", "double period = 1.0", "double deceleration[2] = {0.0, 5.0}",
         "double deceleration[2] = {5.0, 20.5}"), "FallBack<Arm, float, Bad> stop;", ("control/fall_back",)),
    each("a drive's counts are positive", ("double effort_a_count = 0.0", "int most_counts = 0"), "auto r = current_command<Bad, EffortsOf<Arm, W>, 0>(tauW[0]);",
         ("fixed/control/encoder",)),
    Other("position_command() takes float or double", ("control/position_command",), "PositionCommandState<Arm, W> state;\nPositionLoop<Arm, W> loop;\n",
          "auto r = position_command<Arm, W>(state, loop, qW, tauW);"),
    Other("a load changes where the scene names Payload", (), "ObserverState<Arm, float, Tuning> state;\nInputs<Arm, float> in;\n",
          "auto r = change_load<Arm, float, Tuning>(state, q, qd, in);"),
    each("deviation and memory are positive", ("double deviation = 0.0", "double memory = 0.0"), "PayloadState<Arm, float> state; "
         "ObserverState<Arm, float, Bad> observer; auto r = update_payload<Arm, float, Bad>(state, q, qd, observer.residual);",
         ("control/payload_estimator",)),
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
