"""What a combination is made of: factors and their values, and the C++ that each value stands for.

The first value of every factor is its default: a combination of defaults alone is always offered.
"""

FACTORS = {
    "number": ("float", "double", "fixed32", "fixed16"),
    "rounding": ("nearest", "RoundDown"),
    "product": ("exact", "HighWord"),
    "checks": ("none", "RangeCheck"),
    "form": ("unrolled", "Looped", "Model", "Model, Unbranched"),
    "parameters": ("default", "BaseParameters", "FullParameters"),
    "route": ("default", "ArticulatedBody", "SplitArticulatedBody", "CompositeBody"),
    "gravity": ("Gravity", "none", "RuntimeGravity"),
    "base": ("fixed", "BaseMotion", "FloatingBase", "FloatingBase, BaseWrench"),
    "water": ("none", "Underwater", "Underwater, VelocityThroughWater"),
    "rotor": ("RotorInertia", "none"),
    "friction": ("none", "Friction", "Friction stribeck", "Friction smooth", "Friction stribeck smooth"),
    "springs": ("none", "JointSprings"),
    "wrench": ("none", "TipWrench", "ExternalWrenches", "TipWrench, ExternalWrenches"),
    "payload": ("none", "Payload"),
    "turns": ("none", "SineCosines"),
    "joints": ("RPR", "R", "P", "PP", "RR", "RRP", "PRP", "RPPR"),
    "twist": ("right", "none", "half turn", "one oblique", "oblique", "right and oblique"),
    "theta": ("none", "right", "half turn", "general"),
    "tree": ("serial", "branched base", "two children", "two children, right branches", "two roots"),
    "lengths": ("general", "none"),
    "inertia": ("general", "principal", "rods", "points", "massless first", "massless last", "massless second"),
    "drive": ("rotors", "none", "first rotor"),
    "pose": ("none", "general"),
}
DEFAULT = {factor: values[0] for factor, values in FACTORS.items()}

NUMBERS = {"float": "float", "double": "double", "fixed32": "axial::Fixed32", "fixed16": "axial::Fixed16"}
TWISTS = {
    "none": (), "right": ("_deg(90)", "_deg(-90)"), "half turn": ("_deg(180)", "_deg(0)"),
    "one oblique": ("_deg(0)", "(0.4)", "_deg(0)", "_deg(0)"), "oblique": ("(0.5)", "(0.4)", "(-1.1)", "(2.0)"),
    "right and oblique": ("_deg(90)", "(0.5)", "_deg(-90)", "(0.3)"),
}
THETAS = {"none": (), "right": ("_deg(90)", "_deg(-90)"), "half turn": ("_deg(180)",), "general": ("(0.3)", "(-0.7)")}
POSE = "axial::FixedPose{{0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1}, {0.125, -0.25, 0.5}}"


def is_fixed(c):
    return c["number"].startswith("fixed")


def is_model(c):
    return c["form"].startswith("Model")


def features(c):
    """Tags that a scene names, in the order of the factors."""
    names = []
    for factor in ("rounding", "product", "checks", "parameters", "route", "gravity", "base", "water", "rotor", "springs",
                   "wrench", "payload", "turns"):
        if c[factor] not in ("none", "default", "nearest", "exact", "fixed"):
            names += c[factor].split(", ")
    if c["friction"] != "none":
        names.append("Friction")
    if c["form"] != "unrolled":
        names += [part for part in c["form"].split(", ") if part != "Model"]
    return names + list(c.get("also", ()))


def _cycle(values, i):
    return values[i % len(values)] if values else None


def _tree(c, i):
    """Where link i stands on its parent."""
    kind = c["tree"]
    if kind == "branched base":
        return ".branch(-0.3, 0.125)" if i == 0 else ""
    if kind.startswith("two children") and i == 2:
        return ".parent(0)" + (".branch_deg(90, 0.25)" if "right" in kind else ".branch(0.7, 0.1875)")
    if kind == "two roots" and i == 1:
        return ".parent(axial::LinkParameters::base).branch(0.7, 0.1875)"
    return ""


def _body(c, i, count):
    kind = c["inertia"]
    if kind == "massless first" and i == 0 or kind == "massless second" and i == 1 or (
            kind == "massless last" and i == count - 1):
        return ""
    if kind == "rods":
        return ".mass(1.5).com(0.25, 0, 0).inertia_com(0.0005, 0.03, 0.03)"
    if kind == "points":
        return ".mass(1.5).com(0.25, 0, 0.0625)"
    if kind == "principal":
        return ".mass(2).com(0.125, 0, 0.0625).inertia_com(0.02, 0.018, 0.015)"
    return (f".mass({2 - 0.25 * i}).com({0.125 - 0.0625 * i}, 0.0625, -0.03125)"
            ".inertia_com(0.02, 0.018, 0.015, 0.002, -0.003, 0.001)")


def _link(c, i, kind, count):
    text = f"axial::{'revolute' if kind == 'R' else 'prismatic'}(){_tree(c, i)}"
    twist, theta = _cycle(TWISTS[c["twist"]], i), _cycle(THETAS[c["theta"]], i)
    text += f".alpha{twist}" if twist else ""
    text += f".theta{theta}" if theta else ""
    if c["lengths"] == "general":
        text += f".a({0.25 - 0.0625 * i}).d({0.125 + 0.0625 * i})"
    text += _body(c, i, count)
    if c["drive"] == "rotors" or c["drive"] == "first rotor" and i == 0:
        text += f".rotor_inertia(0.0002, {80 - 10 * i})"
    if c["friction"] != "none" or c.get("declares_friction"):
        text += ".viscous(0.375)" + (".coulomb(1.25, -0.75)" if i % 2 == 0 else ".coulomb(0.5)")
        text += ".stribeck(2.0, 0.25)" if "stribeck" in c["friction"] else ""
        text += ".smooth_speed(0.875)" if "smooth" in c["friction"] else ""
    if c["springs"] != "none":
        text += ".spring(12.0, 0.25)"
    if "Underwater" in c["water"]:
        text += (".added_mass(2, 1.5, 1, 0.02, 0.03, 0.01).buoyancy(1.5, 0.0625, 0.03125, 0)"
                 ".drag_linear(3, 4, 5, 0.1, 0.2, 0.3).drag_quadratic(30, 40, 50, 1, 2, 3)")
    if not c.get("unlimited"):
        reach = "2.5" if kind == "R" else "0.75"
        text += f".position_limits(-{reach}, {reach}).speed_limit(1.5).acceleration_limit(4).effort_limit(400)"
    return text


def robot(c):
    """The robot's type, named Robot."""
    tilt = c.get("world_gravity", "1.5, -2.25, -9.5")
    parts = [f"axial::gravity({tilt})"]
    if not c.get("bare"):
        parts += ["axial::payload_limit(1, 0.125, 0.0078125)", "axial::tip_wrench_limit(8, 2)",
                  "axial::base_body().mass(20).com(0, 0, -0.1).inertia_com(1, 1.25, 1.5)"]
    if c["pose"] != "none":
        parts += [f"axial::base({POSE})", f"axial::tool({POSE})"]
    parts += [_link(c, i, kind, len(c["joints"])) for i, kind in enumerate(c["joints"])]
    return "struct Robot {\n  static constexpr auto chain = axial::chain(\n      " + ",\n      ".join(parts) + ");\n};\n"


def subject(c):
    tags = "".join(f", axial::{name}" for name in features(c))
    if is_model(c):
        return f"axial::Model<{len(c['joints'])}{tags}>"
    return f"axial::Scene<Robot{tags}>"


def source(c, algorithms):
    """A program that runs the algorithms for a combination."""
    runs = "".join(f'  combinations::run<combinations::{name}>(at, "{name}");\n' for name in algorithms)
    return f"""#include <tests/combinations/algorithms.hpp>
{robot(c)}struct Combination {{
  using Robot = ::Robot;
  using Subject = {subject(c)};
  using Number = {NUMBERS[c["number"]]};
}};
int main() {{
  combinations::At<Combination> at;
{runs}  return at.failures > 0;
}}
"""


def text(c):
    """What differs from the defaults, for people."""
    differing = [f"{factor}={value}" for factor, value in c.items() if DEFAULT.get(factor) != value]
    return "; ".join(differing) or "defaults"
