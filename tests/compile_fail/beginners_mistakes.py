"""Mistakes that beginners make in calls: a row has a name, what stands at the top of the program, what stands in a function, and a part of the
sentence that the compiler says, in floating point and in fixed point; None where that number has no such mistake.
"""

import collections

Mistake = collections.namedtuple("Mistake", "name declared code float fixed")

# What every program begins with: a robot of two joints with every limit, another one of three, a scene and values of each role.
PROLOGUE = """#include <axial/{umbrella}.hpp>
#define JOINT axial::revolute().a(0.4).mass(2.0).com(0.2, 0, 0).inertia_com(0.01, 0.02, 0.02)
#define LIMITED JOINT.speed_limit(3.0).acceleration_limit(20.0).effort_limit(60.0)
#define GRAVITY axial::gravity(0.0, -9.81, 0.0)
struct Arm {{ static constexpr auto chain = axial::chain(GRAVITY, LIMITED, LIMITED, axial::payload_limit(2.0, 0.2, 0.1)); }};
struct Longer {{ static constexpr auto chain = axial::chain(GRAVITY, LIMITED, LIMITED, LIMITED); }};
using T = {number};
using Loaded = axial::Scene<Arm, axial::Gravity, axial::RotorInertia, axial::Payload>;
using Rubbing = axial::Scene<Arm, axial::Gravity, axial::Friction>;
extern axial::Positions<Arm, T> q;
extern axial::Velocities<Arm, T> qd;
extern axial::Accelerations<Arm, T> qdd;
extern axial::EffortsOf<Arm, T> tau;
extern axial::Positions<Longer, T> longer;
"""

TAKES = "axial: no such call: "


def both(name, code, sentence, declared=""):
    return Mistake(name, declared, code, sentence, sentence)


def call(name, code, signature, declared=""):
    """A call whose arguments fit no function of that name."""
    return both(name, code, TAKES + signature, declared)


def in_float(name, code, sentence, declared=""):
    return Mistake(name, declared, code, sentence, None)


def in_fixed(name, code, sentence, declared=""):
    return Mistake(name, declared, code, None, sentence)


MOTION, STATE, DRIVEN, POSITION = "(q, qd, qdd)", "(q, qd)", "(q, qd, tau)", "(q)"
NO_CHAIN = "struct Bare { double mass; };\n"
NOT_A_ROBOT = "axial: a robot is a struct with static constexpr auto chain = axial::chain(...)"
ONE_EACH = "axial: joint values hold one number for each joint"
ARRAYS = "axial: joint values are axial::Joints, or arrays with one number for each joint"
MIXED_UP = "axial: positions, velocities and accelerations are mixed up"
ALL = [
    # Something forgotten.
    call("qdd forgotten", "auto r = axial::inverse_dynamics<Arm>(q, qd);", "inverse_dynamics<Robot>" + MOTION),
    call("robot forgotten", "auto r = axial::inverse_dynamics(q, qd, qdd);", "inverse_dynamics<Robot>" + MOTION),
    call("torque forgotten", "auto r = axial::forward_dynamics<Arm>(q, qd);", "forward_dynamics<Robot>" + DRIVEN),
    call("position forgotten", "auto r = axial::mass_matrix<Arm>();", "mass_matrix<Robot>" + POSITION),
    call("speeds forgotten", "auto r = axial::bias_torque<Arm>(q);", "bias_torque<Robot>" + STATE),
    call("state forgotten", "auto r = axial::feedforward<Arm>(q, qd, qdd);", "feedforward<Robot>(state, q, qd, qdd)"),
    call("qdd of a loop forgotten", "axial::FeedforwardState<Arm, T> state; auto r = axial::feedforward<Arm>(state, q, qd);",
         "feedforward<Robot>(state, q, qd, qdd)"),
    call("qdd of a regressor forgotten", "axial::Joints<Arm, float> a; auto r = axial::torque_regressor<Arm>(a, a);",
         "torque_regressor<Robot>" + MOTION),
    call("qdd of derivatives forgotten", "auto r = axial::inverse_dynamics_derivatives<Arm>(q, qd);",
         "inverse_dynamics_derivatives<Robot>" + MOTION),
    call("gains of a loop forgotten", "axial::SafeLoopState<Arm, T> state; auto r = axial::track<Arm>(state, axial::Request<Arm, T>{}, "
         "axial::MeasuredMotion<Arm, T>{});", "track<Robot>(state, desired, measured, gains)"),
    call("torque of an observer forgotten", "axial::ObserverState<Arm, T, Tuning> state; auto r = axial::observe<Arm>(state, q, qd);",
         "observe<Robot>(state, q, qd, tau)", "struct Tuning { static constexpr double period = 1e-3, gain = 200.0; };\n"),
    in_fixed("include of fixed point forgotten", "axial::Positions<Arm, T> p;", "axial: fixed point is a plug-in: add #include <axial/fixed.hpp>"),
    both("gravity of the robot forgotten", "axial::Positions<Weightless, T> p; auto r = axial::gravity_torque<Weightless>(p);",
         "axial: the chain does not say which way gravity pulls",
         "struct Weightless { static constexpr auto chain = axial::chain(LIMITED, LIMITED); };\n"),
    both("gravity of a guided arm forgotten", "axial::SafeLoopState<Weightless, T> state; axial::Positions<Weightless, T> p; "
         "auto r = axial::compensate_gravity<Weightless>(state, p);", "axial: the chain does not say which way gravity pulls",
         "struct Weightless { static constexpr auto chain = axial::chain(LIMITED, LIMITED); };\n"),
    both("payload not in the scene", "axial::Inputs<Arm, T> in; in.payload.mass = {};", "add_the_feature_axial_Payload_to_the_scene"),
    both("a struct without chain", "axial::Positions<Bare, T> p; axial::Velocities<Bare, T> v; axial::Accelerations<Bare, T> a; "
         "auto r = axial::inverse_dynamics<Bare>(p, v, a);", NOT_A_ROBOT, NO_CHAIN),
    both("a scene of a struct without chain", "axial::Inputs<axial::Scene<Bare, axial::Gravity>, T> in;", NOT_A_ROBOT, NO_CHAIN),
    both("a loop's state of a struct without chain", "axial::FeedforwardState<Bare, T> state;", NOT_A_ROBOT, NO_CHAIN),
    both("a number for the robot", "axial::Positions<int, T> p;", NOT_A_ROBOT),
    both("a chain that is no chain", "axial::Positions<Odd, T> p;", NOT_A_ROBOT, "struct Odd { static constexpr int chain = 3; };\n"),
    # Another type's.
    in_float("double among float", "axial::Joints<Arm, double> d; auto r = axial::inverse_dynamics<Arm>(q, d, qdd);",
             TAKES + "inverse_dynamics<Robot>" + MOTION),
    in_fixed("float among fixed point", "axial::Joints<Arm, float> f; auto r = axial::inverse_dynamics<Arm>(q, f, qdd);",
             TAKES + "inverse_dynamics<Robot>" + MOTION),
    in_float("a state of double for a loop of float", "axial::FeedforwardState<Arm, double> state; "
             "auto r = axial::feedforward<Arm>(state, q, qd, qdd);", TAKES + "feedforward<Robot>(state, q, qd, qdd)"),
    call("a state of another scene", "axial::FeedforwardState<Arm, T> state; auto r = axial::feedforward<Loaded>(state, q, qd, qdd);",
         "feedforward<Robot>(state, q, qd, qdd)"),
    call("a guided arm's state of another scene", "axial::SafeLoopState<Rubbing, T> state; auto r = axial::compensate_gravity<Arm>(state, q);",
         "compensate_gravity<Robot>(state, q)"),
    call("inputs of another scene", "axial::Inputs<Loaded, T> in; auto r = axial::inverse_dynamics<Rubbing>(q, qd, qdd, in);",
         "inverse_dynamics<Robot>" + MOTION),
    call("a payload instead of inputs", "axial::PayloadBody<T> load; auto r = axial::gravity_torque<Loaded>(q, load);",
         "gravity_torque<Robot>" + POSITION),
    call("another robot's values", "auto r = axial::inverse_dynamics<Arm>(longer, qd, qdd);", "inverse_dynamics<Robot>" + MOTION),
    Mistake("another robot named", "", "auto r = axial::forward_dynamics<Longer>(q, qd, tau);", TAKES + "forward_dynamics<Robot>" + DRIVEN,
            "axial: these efforts are in the formats of another scene"),
    call("another robot's position for a pose", "auto r = axial::forward_kinematics<Arm>(longer);", "forward_kinematics<Robot>" + POSITION),
    call("another robot's position for a Jacobian", "auto r = axial::jacobian<Arm>(longer);", "jacobian<Robot>" + POSITION),
    in_fixed("efforts of another scene", "axial::EffortsOf<Rubbing, T> e; auto r = axial::forward_dynamics<Arm>(q, qd, e);",
             "axial: these efforts are in the formats of another scene"),
    call("a matrix for a vector", "auto r = axial::forward_dynamics<Arm>(q, qd, axial::MassMatrix<Arm, T>{});",
         "forward_dynamics<Robot>" + DRIVEN),
    call("a null pointer", "auto r = axial::mass_matrix<Arm>(nullptr);", "mass_matrix<Robot>" + POSITION),
    # The wrong order, or count.
    Mistake("velocity before position", "", "axial::JointVelocities<Arm, T> v; auto r = axial::inverse_dynamics<Arm>(v, q, qdd);",
            MIXED_UP, MIXED_UP),
    call("state last", "axial::FeedforwardState<Arm, T> state; auto r = axial::feedforward<Arm>(q, qd, qdd, state);",
         "feedforward<Robot>(state, q, qd, qdd)"),
    in_float("one value for two joints", "axial::Joints<Arm, T> p{0.1F};", ONE_EACH),
    in_float("three values for two joints", "axial::Joints<Arm, T> p{0.1F, 0.2F, 0.3F};", ONE_EACH),
    in_float("two values for three joints, with a role", "axial::JointPositions<Longer> p{0.1F, 0.2F};", ONE_EACH),
    in_fixed("one word for two joints", "axial::Positions<Arm, T> p{T{1}};", ONE_EACH),
    in_float("braces with too few numbers", "auto r = axial::inverse_dynamics<Arm>({0.1F}, {0.2F, 0.3F}, {0.0F, 0.0F});",
             "axial: braces hold one number for each joint"),
    both("an array with too few numbers", "float a[1] = {}; auto r = axial::gravity_torque<Arm>(a);", ARRAYS),
    both("a pointer", "const float* p = nullptr; auto r = axial::gravity_torque<Arm>(p);", ARRAYS),
    both("an array of int", "int a[2] = {}; auto r = axial::gravity_torque<Arm>(a);", ARRAYS),
    both("numbers one by one", "auto r = axial::gravity_torque<Arm>(0.1F, 0.2F);", ARRAYS),
    in_float("joint values of int", "axial::Joints<Arm, int> p; auto r = axial::gravity_torque<Arm>(p);", TAKES + "gravity_torque<Robot>"),
    both("a joint that is not there", "auto r = axial::joint_torque<Arm, 2>(q, qd, qdd);", "axial: the robot has no such joint"),
    # Fixed point without what its formats follow from.
    in_fixed("a speed limit forgotten", "axial::Positions<Part, T> p; axial::Velocities<Part, T> v; axial::Accelerations<Part, T> a; "
             "auto r = axial::inverse_dynamics<Part>(p, v, a);", "speed_limit",
             "struct Part { static constexpr auto chain = axial::chain(GRAVITY, LIMITED, JOINT.acceleration_limit(20.0)); };\n"),
    in_fixed("all limits forgotten", "axial::Positions<Part, T> p; axial::Velocities<Part, T> v; axial::EffortsOf<Part, T> e; "
             "auto r = axial::forward_dynamics<Part>(p, v, e);", "speed_limit",
             "struct Part { static constexpr auto chain = axial::chain(GRAVITY, LIMITED, JOINT); };\n"),
    in_fixed("a payload's limit forgotten", "axial::Inputs<Scene, T> in;", "axial::payload_limit(mass, com_reach, inertia)",
             "using Scene = axial::Scene<Longer, axial::Gravity, axial::Payload>;\n"),
    # What is answered thrown away, or not what it is taken for.
    both("a status thrown away", "axial::FeedforwardState<Arm, T> state; axial::feedforward<Arm>(state, q, qd, qdd);", "nodiscard"),
]
