"""Programs as a user writes them: a robot, values and one algorithm's calls, straight from a function that is no template."""

import factors

INCLUDES = "".join(f"#include <axial/{name}.hpp>\n" for name in (
    "axial", "control/payload_estimator", "cost", "fixed", "simulation/step_limit"))
TUNING = """struct Tuning {
  static constexpr double period = 1e-3, gain = 100.0, fraction = 0.1, uncertainty = 1.0, release = 0.5;
  static constexpr double deviation = 0.01, memory = 1.0, mass_deviation = 1.0, moment_deviation = 1.0;
  static constexpr int confirm = 1, calm = 3;
};
"""
# In a call `NAME(` is axial::NAME of the scene, or of the run-time model; S is the scene's type, T the number's.
CALLS = {
    "InverseDynamics": ("inverse_dynamics(q, qd, qdd, in)",),
    "Gravity": ("gravity_torque(q, in)",),
    "Bias": ("bias_torque(q, qd, in)",),
    "JointTorque": ("joint_torque<1>(q, qd, qdd, in)", "gravity_torque<1>(q, in)"),
    "MassMatrix": ("mass_matrix(q, in)",),
    "ForwardDynamics": ("forward_dynamics(q, qd, tau, in)",),
    "Kinematics": ("forward_kinematics(q, in)", "jacobian(q, in)", "jacobian<1>(q, in)"),
    "Separation": ("separate(q, in)", "separate_A(q, in)", "separate_B(q, in)", "separate_C(q, in)", "separate_G(q, in)"),
    "BaseWrench": ("base_wrench(q, qd, qdd, in)",),
    "Momentum": ("momentum_terms(q, qd, in)",),
}
CONTROL = {
    "Separation": "[[maybe_unused]] const auto torque = axial::torque(r0, qd, qdd);",
    "Integrators": "axial::Motion<S, T> x;\n"
                   "  const auto drive = [](const axial::Instant<S, T>&, axial::EffortsOf<S, T>&, axial::Inputs<S, T>&) {};\n"
                   "  [[maybe_unused]] const auto r0 = axial::advance<axial::RungeKutta4>(x, T{}, drive);\n"
                   "  [[maybe_unused]] const auto r1 = axial::advance<axial::LinearlyImplicitEuler>(x, T{}, drive);\n"
                   "  [[maybe_unused]] const auto r2 = axial::step_limit<axial::RungeKutta4, S>(q, in);",
    "Feedforward": "axial::FeedforwardState<S, T> state;\n  [[maybe_unused]] const auto r = axial::feedforward<S, T>(state, q, qd, qdd, in);",
    "TwoRate": "axial::TwoRateState<S, T> state;\n  [[maybe_unused]] const auto r0 = axial::refresh<S, T>(state, q, in);\n"
               "  [[maybe_unused]] const auto r1 = axial::two_rate_feedforward(state, qd, qdd);",
    "Observer": "axial::ObserverState<S, T, Tuning> state;\n  [[maybe_unused]] const auto r = axial::observe<S, T, Tuning>(state, q, qd, tau, in);",
    "PayloadEstimator": "axial::PayloadState<S, T> state;\n  axial::ObserverState<S, T, Tuning> observer;\n"
                        "  [[maybe_unused]] const auto r = axial::update_payload<S, T, Tuning>(state, q, qd, observer.residual);",
    "ErrorBound": "[[maybe_unused]] constexpr auto r = axial::error_bound<S, T>(axial::algorithm::inverse_dynamics);",
    "ForwardErrorBound": "[[maybe_unused]] constexpr auto r = axial::error_bound<S, T>(axial::algorithm::forward_dynamics);",
    "Cost": "[[maybe_unused]] constexpr auto r0 = axial::cost<S>(axial::algorithm::inverse_dynamics);\n"
            "  [[maybe_unused]] constexpr auto r1 = axial::cost<S>(axial::algorithm::forward_dynamics);",
    "ClosedForm": "[[maybe_unused]] const auto r0 = axial::closed_form::scara_torque<Robot>(q, qd, qdd);\n"
                  "  [[maybe_unused]] const auto r1 = axial::closed_form::scara<Robot>(q);",
}


def _call(call, model):
    name, arguments = call.split("(", 1)
    name, joint = (name.rstrip(">").split("<") + [""])[:2]
    if model:
        return f"axial::{name}(model, {joint + ', ' if joint else ''}{arguments}"
    return f"axial::{name}<S{', ' + joint if joint else ''}>({arguments}"


def source(c, algorithm):
    """A program that calls an algorithm for a combination."""
    model = factors.is_model(c)
    calls = [call for call in CALLS.get(algorithm, ()) if not (model and call.startswith("separate_"))]
    lines = [f"[[maybe_unused]] const auto r{i} = {_call(call, model)};" for i, call in enumerate(calls)]
    more = CONTROL.get(algorithm, "")
    if model:
        more = more.replace("torque(", "torque(model, ").replace("advance<axial::RungeKutta4>(", "advance<axial::RungeKutta4>(model, ")
        more = more.replace("Euler>(", "Euler>(model, ").replace("RungeKutta4, S>(", "RungeKutta4>(model, ")
    lines += [more] if more else []
    text = "\n  ".join(lines)
    values = "".join(f"axial::{kind}<{of}, T> {name};\n" for kind, of, name in (
        ("Positions", "Owner", "q"), ("Velocities", "Owner", "qd"), ("Accelerations", "Owner", "qdd"), ("EffortsOf", "S", "tau"),
        ("Inputs", "S", "in")))
    return f"""{INCLUDES}{factors.robot(c)}using S = {factors.subject(c)};
using T = {factors.NUMBERS[c["number"]]};
using Owner = {"S" if model else "Robot"};
{TUNING}{values}{"S model;" if model else ""}
void run() {{
  {text}
}}
"""
