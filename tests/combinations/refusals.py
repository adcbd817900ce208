"""What is not offered: when, for which algorithms, and the sentence that the compiler then says first.

The table of doc/guides/not_offered.md is made of this list, and check.py holds the library to it: what is on it must not compile, with
its sentence as the first error; whatever is not on it must compile.
"""
import dataclasses
import typing

from factors import DEFAULT, is_fixed, is_model

DYNAMICS = ("InverseDynamics", "Gravity", "Bias", "JointTorque", "MassMatrix", "ForwardDynamics", "Kinematics", "Separation",
            "BaseWrench", "Momentum", "Integrators")
CONTROL = ("Feedforward", "TwoRate", "Observer", "PayloadEstimator", "ErrorBound", "Cost", "ClosedForm")
ALGORITHMS = DYNAMICS + CONTROL
FORWARD = ("ForwardDynamics", "Integrators", "Cost")
SEPARATED = ("Separation", "TwoRate")
MOMENTA = ("Momentum", "Observer")


@dataclasses.dataclass(frozen=True)
class Refusal:
    """`example` differs from the defaults; the sentence's end, behind the colon or semicolon, says what to do instead."""
    what: str  # for the table
    sentence: str
    when: typing.Callable
    example: dict
    algorithms: tuple = ALGORITHMS


def _also(c, name):
    return name in c.get("also", ())


def _spins(c):
    return _also(c, "RotorDynamics") and c["rotor"] == "RotorInertia"


def _moves(c):
    return c["base"] != "fixed"


def _floats(c):
    return c["base"].startswith("FloatingBase")


def _massless(c):
    return c["inertia"].startswith("massless")


def _has_rotor(c, i):
    return c["rotor"] == "RotorInertia" and (c["drive"] == "rotors" or c["drive"] == "first rotor" and i == 0)


def _inertia_about_axis(c, i):
    """Whether link i alone resists its joint."""
    last = len(c["joints"]) - 1
    nothing = {"massless first": 0, "massless second": 1, "massless last": last}.get(c["inertia"], -1)
    return i != nothing or _has_rotor(c, i)


def _all_resist(c):
    return all(_inertia_about_axis(c, i) for i in range(len(c["joints"])))


def _children(c):
    parents = {i: i - 1 for i in range(len(c["joints"]))}
    if c["tree"].startswith("two children") and 2 in parents:
        parents[2] = 0
    if c["tree"] == "two roots" and 1 in parents:
        parents[1] = -1
    return {i: [j for j, p in parents.items() if p == i] for i in parents}


def _some_joint_moves_nothing(c):
    """A tip without mass, rotor or payload."""
    children, last = _children(c), len(c["joints"]) - 1
    return any(not _inertia_about_axis(c, i) and not children[i] and not (c["payload"] != "none" and i == last)
               for i in children)


def _is_scara(c):
    return c["joints"] == "RRP"


REFUSALS = (
    # Scenes, whatever is asked of them
    Refusal("a feature twice", "axial: a Scene names a feature twice; name each feature once",
            lambda c: _also(c, "RotorInertia"), {"also": ("RotorInertia",)}),
    Refusal("`Gravity` beside `RuntimeGravity`",
            "axial: a Scene names both Gravity and RuntimeGravity; keep Gravity for the robot's declared vector, or "
            "RuntimeGravity for the input in.gravity",
            lambda c: _also(c, "RuntimeGravity"), {"also": ("RuntimeGravity",)}),
    Refusal("`FullParameters` beside `BaseParameters`",
            "axial: a Scene names both FullParameters and BaseParameters; keep one, or none for each algorithm's default",
            lambda c: _also(c, "FullParameters"), {"parameters": "BaseParameters", "also": ("FullParameters",)}),
    Refusal("`FloatingBase` beside `BaseMotion`",
            "axial: a Scene names both FloatingBase and BaseMotion; keep FloatingBase for a base that is free, or BaseMotion "
            "for one that moves as it is told",
            lambda c: _also(c, "BaseMotion"), {"base": "FloatingBase", "gravity": "none", "also": ("BaseMotion",)}),
    Refusal("`FloatingBase` beside `Gravity`",
            "axial: a Scene names Gravity for a floating base, in whose frame gravity turns; name RuntimeGravity and give "
            "in.gravity in axes of frame 0, or neither in free space",
            lambda c: _floats(c) and c["gravity"] == "Gravity", {"base": "FloatingBase"}),
    Refusal("`BaseWrench` without `FloatingBase`",
            "axial: a Scene names BaseWrench for a base that is not free; add FloatingBase or take BaseWrench out",
            lambda c: _also(c, "BaseWrench"), {"also": ("BaseWrench",)}),
    Refusal("`VelocityThroughWater` without `Underwater`",
            "axial: a Scene names VelocityThroughWater but no water; add Underwater",
            lambda c: _also(c, "VelocityThroughWater"), {"also": ("VelocityThroughWater",)}),
    Refusal("`Underwater` on a base that moves, without `VelocityThroughWater`",
            "axial: an underwater base that moves goes through the water; add VelocityThroughWater and give "
            "in.velocity_through_water in axes of frame 0",
            lambda c: c["water"] == "Underwater" and _moves(c), {"water": "Underwater", "base": "BaseMotion"}),
    Refusal("`FloatingBase` beside `SplitArticulatedBody` or `CompositeBody`",
            "axial: forward dynamics of a floating base is that of ArticulatedBody; take SplitArticulatedBody or "
            "CompositeBody out",
            lambda c: _floats(c) and c["route"] in ("SplitArticulatedBody", "CompositeBody"),
            {"base": "FloatingBase", "gravity": "none", "route": "CompositeBody"}),
    Refusal("`RotorDynamics` without `RotorInertia`",
            "axial: a Scene names RotorDynamics, the coupling of rotors to their carriers, without what they are on their own "
            "joints; add RotorInertia",
            lambda c: _also(c, "RotorDynamics") and c["rotor"] == "none", {"rotor": "none", "also": ("RotorDynamics",)}),
    Refusal("`RotorDynamics` beside `FloatingBase`, `ArticulatedBody` or `SplitArticulatedBody`",
            "axial: forward dynamics with RotorDynamics is that of CompositeBody on a base that does not float; take FloatingBase, "
            "ArticulatedBody and SplitArticulatedBody out",
            lambda c: _spins(c) and (_floats(c) or c["route"] in ("ArticulatedBody", "SplitArticulatedBody")),
            {"route": "ArticulatedBody", "also": ("RotorDynamics",)}),
    Refusal("two forms of forward dynamics",
            "axial: a Scene names more than one form of forward dynamics; keep one of ArticulatedBody, SplitArticulatedBody "
            "and CompositeBody, or none to let the compiler choose",
            lambda c: _also(c, "CompositeBody"), {"route": "ArticulatedBody", "also": ("CompositeBody",)}),
    Refusal("`FloatingBase` without `base_body()`",
            "axial: FloatingBase needs the inertia of the body that floats; add axial::base_body().mass(kg).com(x, y, "
            "z).inertia_com(...) to the robot's chain",
            lambda c: _floats(c) and c.get("bare"), {"base": "FloatingBase", "gravity": "none", "bare": True}, FORWARD[:1]),
    # Fixed point
    Refusal("a run-time `Model` in fixed point",
            "axial: a run-time Model has no formats for fixed point, which follow from a robot's type; describe the robot as a "
            "type, or compute in float",
            lambda c: is_fixed(c) and is_model(c), {"number": "fixed32", "form": "Model"}, DYNAMICS[:-1]),
    Refusal("a base that moves, in fixed point",
            "axial: fixed point needs a base at rest, for nothing declares how it moves; compute this scene in float",
            lambda c: is_fixed(c) and _moves(c), {"number": "fixed32", "base": "BaseMotion"}),
    Refusal("`Underwater` in fixed point", "axial: fixed point has no water; compute this scene in float",
            lambda c: is_fixed(c) and c["water"] != "none", {"number": "fixed32", "water": "Underwater"}),
    Refusal("`ExternalWrenches` in fixed point",
            "axial: fixed point has no ExternalWrenches; name TipWrench, or compute this scene in float",
            lambda c: is_fixed(c) and "ExternalWrenches" in c["wrench"], {"number": "fixed32", "wrench": "ExternalWrenches"}),
    Refusal("`RotorDynamics` in fixed point",
            "axial: fixed point has no rotors as bodies; take RotorDynamics out of the scene, or compute in float",
            lambda c: is_fixed(c) and _spins(c), {"number": "fixed32", "also": ("RotorDynamics",)}),
    Refusal("`JointSprings` in fixed point", "axial: fixed point has no JointSprings; compute them in float",
            lambda c: is_fixed(c) and c["springs"] != "none", {"number": "fixed32", "springs": "JointSprings"}),
    Refusal("`CompositeBody` in fixed point",
            "axial: forward dynamics in fixed point is that of articulated bodies; take CompositeBody out",
            lambda c: is_fixed(c) and c["route"] == "CompositeBody", {"number": "fixed32", "route": "CompositeBody"}),
    Refusal("`Payload` in fixed point without `payload_limit`",
            "axial: fixed point leaves room for the declared payload; add axial::payload_limit(mass, com_reach, inertia) to "
            "the robot's chain",
            lambda c: is_fixed(c) and c["payload"] != "none" and c.get("bare"),
            {"number": "fixed32", "payload": "Payload", "bare": True}),
    Refusal("`TipWrench` in fixed point without `tip_wrench_limit`",
            "axial: fixed point leaves room for the declared tip wrench; add axial::tip_wrench_limit(force, moment) to the "
            "robot's chain",
            lambda c: is_fixed(c) and "TipWrench" in c["wrench"] and c.get("bare"),
            {"number": "fixed32", "wrench": "TipWrench", "bare": True}),
    Refusal("fixed point without declared limits",
            "axial: fixed point takes its formats from the declared limits; give every link a speed_limit()",
            lambda c: is_fixed(c) and c.get("unlimited"), {"number": "fixed32", "unlimited": True}),
    Refusal("`stribeck()` in fixed point, where the scene names `Friction`",
            "axial: fixed point has viscous and Coulomb friction, not stribeck(); compute this scene in float",
            lambda c: is_fixed(c) and "stribeck" in c["friction"], {"number": "fixed32", "friction": "Friction stribeck"}),
    Refusal("`smooth_speed()` in fixed point, where the scene names `Friction`",
            "axial: fixed point has no smooth_speed(); compute this scene in float",
            lambda c: is_fixed(c) and "smooth" in c["friction"] and "stribeck" not in c["friction"],
            {"number": "fixed32", "friction": "Friction smooth"}),
    Refusal("`Looped` forward dynamics and separation in fixed point",
            "axial: forward dynamics and separation in fixed point need a format per link, which the looped form "
            "has not; take Looped out (AXIAL_MULTIPLY_BY_CALL makes them smaller on a Cortex-M0)",
            lambda c: is_fixed(c) and c["form"] == "Looped", {"number": "fixed32", "form": "Looped"},
            ("ForwardDynamics", "ForwardErrorBound") + SEPARATED),
    Refusal("forward dynamics in fixed point of a robot with a link that does not resist its own joint",
            "axial: forward dynamics in fixed point takes its formats from what each link resists by itself; give every link "
            "an inertia about its joint's axis (a slide: a mass), or rotor_inertia() and name RotorInertia; or compute this "
            "scene in float",
            lambda c: is_fixed(c) and not _all_resist(c) and not _some_joint_moves_nothing(c),
            {"number": "fixed32", "inertia": "massless first", "rotor": "none"}, ("ForwardDynamics", "ForwardErrorBound")),
    Refusal("forward dynamics in fixed point with `BaseParameters`",
            "axial: forward dynamics in fixed point takes its formats from each link's own parameters, which BaseParameters "
            "regroups; take BaseParameters out of the scene",
            lambda c: is_fixed(c) and c["parameters"] == "BaseParameters",
            {"number": "fixed32", "parameters": "BaseParameters"}, ("ForwardDynamics", "ForwardErrorBound")),
    Refusal("separation with `TipWrench` in fixed point",
            "axial: separate() in fixed point has no wrenches; take TipWrench out of the scene",
            lambda c: is_fixed(c) and c["wrench"] == "TipWrench", {"number": "fixed32", "wrench": "TipWrench"}, SEPARATED),
    Refusal("`base_wrench` in fixed point",
            "axial: base_wrench() has no formats in fixed point; compute it in float",
            is_fixed, {"number": "fixed32"}, ("BaseWrench",)),
    Refusal("the momentum observer in 16 bits", "axial: the momentum observer takes Fixed32, float or double",
            lambda c: c["number"] == "fixed16", {"number": "fixed16"}, ("Observer",)),
    Refusal("the payload estimator in 16 bits", "axial: the payload estimator takes Fixed32, float or double",
            lambda c: c["number"] == "fixed16" and c["gravity"] == "Gravity", {"number": "fixed16"}, ("PayloadEstimator",)),
    Refusal("integrators in fixed point without their header",
            "axial: integrators move float and double; in fixed point add #include <axial/fixed/simulation/integrators.hpp>",
            is_fixed, {"number": "fixed32"}, ("Integrators",)),
    # Algorithms
    Refusal("separation on a base that moves",
            "axial: a base that turns adds terms which are linear in the joint rates, and separate() has no place for them; "
            "take BaseMotion or FloatingBase out of the scene, or use inverse_dynamics",
            lambda c: _moves(c) and not is_fixed(c), {"base": "BaseMotion"}, SEPARATED),
    Refusal("separation `Underwater`",
            "axial: drag and added mass have no place in the terms of separate(); take Underwater out of the scene, or use "
            "inverse_dynamics, bias_torque and mass_matrix",
            lambda c: c["water"] != "none" and not _moves(c) and not is_fixed(c), {"water": "Underwater"}, SEPARATED),
    Refusal("momenta and the observer on a base that moves, or `Underwater`",
            "axial: momenta are those of a robot on a fixed base in air; take BaseMotion, FloatingBase and Underwater out of "
            "this scene",
            lambda c: (_moves(c) or c["water"] != "none") and not is_fixed(c), {"base": "BaseMotion"}, MOMENTA),
    Refusal("separation with `RotorDynamics`",
            "axial: separate() has no rotors as bodies; take RotorDynamics out of the scene, or use inverse_dynamics, bias_torque "
            "and mass_matrix", lambda c: _spins(c) and not is_fixed(c), {"also": ("RotorDynamics",)}, SEPARATED),
    Refusal("momenta and the observer with `RotorDynamics`",
            "axial: momenta have no rotors as bodies; take RotorDynamics out of this scene",
            lambda c: _spins(c) and not is_fixed(c), {"also": ("RotorDynamics",)}, MOMENTA),
    Refusal("`base_wrench` with `RotorDynamics`",
            "axial: base_wrench has no rotors as bodies; take RotorDynamics out of the scene",
            lambda c: _spins(c) and not is_fixed(c), {"also": ("RotorDynamics",)}, ("BaseWrench",)),
    Refusal("integrators with `RotorDynamics`",
            "axial: integrators have no rotors as bodies; take RotorDynamics out of the scene, or integrate forward_dynamics",
            lambda c: _spins(c) and not is_fixed(c), {"also": ("RotorDynamics",)}, ("Integrators",)),
    Refusal("`base_wrench` with `BaseParameters`",
            "axial: base_wrench needs every link's own parameters, which BaseParameters regroups; take BaseParameters out of "
            "the scene",
            lambda c: c["parameters"] == "BaseParameters" and not is_model(c) and not is_fixed(c),
            {"parameters": "BaseParameters"}, ("BaseWrench",)),
    Refusal("forward dynamics of a joint that nothing resists",
            "axial: forward dynamics needs every joint to move some mass, inertia or rotor; give the links outboard of each "
            "joint a mass, an inertia about the joint axis, or rotor_inertia()",
            lambda c: _some_joint_moves_nothing(c) and not is_model(c),
            {"inertia": "massless last", "rotor": "none"}, FORWARD),
    Refusal("integrators of a `FloatingBase`",
            "axial: integrators move joints; integrate a floating base as doc/guides/moving_base.md shows",
            lambda c: _floats(c) and not is_fixed(c), {"base": "FloatingBase", "gravity": "none"}, ("Integrators",)),
    Refusal("the payload estimator without `Gravity`",
            "axial: a payload is weighed under the gravity that the chain declares; name Gravity in the scene",
            lambda c: c["gravity"] != "Gravity", {"gravity": "none"}, ("PayloadEstimator",)),
    Refusal("`Payload` without `payload_limit` in `feedforward`, the observer and the two-rate feed-forward",
            "axial: a run-time payload is checked against the robot's declared maximum; add axial::payload_limit(mass, "
            "com_reach, inertia) to its chain",
            lambda c: c["payload"] != "none" and c.get("bare") and not is_fixed(c),
            {"payload": "Payload", "bare": True}, ("Feedforward", "TwoRate", "Observer")),
    Refusal("the closed form of a robot that is not RRP",
            "axial: closed_form::scara needs three joints: revolute, revolute, prismatic (RRP)",
            lambda c: not _is_scara(c), {}, ("ClosedForm",)),
)


def refusals_of(c, algorithm=None):
    """The refusals that fit a combination; without an algorithm, those of the scene as a whole."""
    return [r for r in REFUSALS
            if r.when(c) and (algorithm in r.algorithms if algorithm else r.algorithms == ALGORITHMS)]


def is_refused(c):
    """Whether a scene as a whole is refused: by the compiler, or by Model::add(), which answers false to a branch."""
    return (bool(refusals_of(c)) or is_fixed(c) and is_model(c) or
            c["form"] == "Model, Unbranched" and c["tree"] != "serial")


def _fits_closed_form(c):
    return (c["joints"] == "RRP" and c["twist"] in ("none", "half turn") and c["tree"] == "serial" and
            c["inertia"] in ("rods", "points", "principal") and c["theta"] in ("none", "half turn") and
            c.get("world_gravity", "").startswith("0, 0"))


def is_asked(c, algorithm):
    """Whether the question makes sense: a run-time model has kernels alone, and no number but fixed point has formats."""
    if is_model(c) and algorithm in CONTROL:
        return False
    if algorithm == "Cost" and is_fixed(c):
        return False
    return is_fixed(c) or algorithm not in ("ErrorBound", "ForwardErrorBound")


def offered(c):
    """The algorithms that a combination offers."""
    names = []
    for algorithm in ALGORITHMS:
        if not is_asked(c, algorithm) or algorithm == "ClosedForm" and not _fits_closed_form(c):
            continue
        if not refusals_of(c, algorithm):
            names.append(algorithm)
    if is_fixed(c) and not refusals_of(c, "ForwardErrorBound") and not _some_joint_moves_nothing(c):
        names.append("ForwardErrorBound")
    return names


# Seeds of the array: what a pairwise array seldom meets, because several things must come together.
SCARA = {**DEFAULT, "joints": "RRP", "twist": "none", "inertia": "rods", "world_gravity": "0, 0, -9.81"}
SEEDS = tuple({**SCARA, "number": number, "twist": twist}
              for number, twist in (("float", "none"), ("double", "half turn"), ("fixed32", "half turn"), ("fixed16", "none")))
