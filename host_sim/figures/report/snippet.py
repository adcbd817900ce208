"""The lines of code that select a kernel. Its scene is the very type that the probe of the same names measures."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "boards/size"))
import routes  # noqa: E402

NUMBERS = {"float": ("float", ()), "double": ("double", ()), "fixed32": ("axial::Fixed32", ()),
           "fixed32_down": ("axial::Fixed32", ("RoundDown",)), "fixed32_high": ("axial::Fixed32", ("HighWord",)),
           "fixed16": ("axial::Fixed16", ())}
SCENES = {"bare": (), "sine_cosines": ("SineCosines",), "full_parameters": ("FullParameters",), "base_parameters": ("BaseParameters",), "elastic": ("ElasticJoints",)}
ELASTIC = "axial::apps::Elastic<{}, 12>"  # firmware/apps/elastic/elastic_robot.hpp
CALLS = {"inverse_dynamics": "auto tau = axial::inverse_dynamics<Scene>(q, qd, qdd{in})",
         "closed_form": "auto tau = axial::closed_form::scara_torque<Scene>(q, qd, qdd)",
         "torque_by_separation": "auto tau = axial::torque(axial::separate<Scene>(q{in}), qd, qdd)",
         "gravity": "auto tau = axial::gravity_torque<Scene>(q{in})",
         "bias": "auto tau = axial::bias_torque<Scene>(q, qd{in})",
         "mass_matrix": "auto M = axial::mass_matrix<Scene>(q{in})",
         "forward_dynamics": "auto qdd = axial::forward_dynamics<Scene>(q, qd, tau{in})",
         "inverse_dynamics_derivatives": "auto d = axial::inverse_dynamics_derivatives<Scene>(q, qd, qdd{in})",
         "forward_dynamics_derivatives": "auto f = axial::forward_dynamics_derivatives<Scene>(q, qd, tau{in})",
         "feedforward": "auto safe = axial::feedforward<Scene>(state, q, qd, qdd{in})",
         "elastic_feedforward": "auto motors = axial::elastic_feedforward<Scene>(q, qd, qdd, q3, q4)",
         "forward_kinematics": "auto poses = axial::forward_kinematics<Scene>(q)",
         "jacobian": "auto J = axial::jacobian<Scene>(q)"}


def robot_type(robot):
    return "robots::" + "".join(part.capitalize() for part in robot.split("_"))


def type_of(row):
    return row.get("type") or robot_type(row["robot"])


def scene_robot(row):
    """The robot that the scene names: behind springs it is another."""
    return ELASTIC.format(type_of(row)) if row["scene"] == "elastic" else type_of(row)


def included(row):
    return f'"{row["header"]}"' if row.get("header") else f"<robots/{row['robot']}.hpp>"


def tag_of(algorithm):
    """The route's type."""
    return routes.TAGS.get(routes.route_of(algorithm))


def scene(row):
    """`row`: robot, scene, algorithm, form, scalar, as matrix.txt names them."""
    tags = ["Gravity", "RotorInertia", *SCENES[row["scene"]], *NUMBERS[row["scalar"]][1]]
    tags += ["Looped"] if row["form"] == "compact" else []
    tags += [tag_of(row["algorithm"])] if tag_of(row["algorithm"]) else []
    return f"axial::Scene<{scene_robot(row)}, {', '.join('axial::' + tag for tag in tags)}>"


def call(row):
    return "const " + CALLS[routes.job_of(row["algorithm"])].format(**{"in": ", in" if row["scene"] == "sine_cosines" else ""}) + ";"


def lines(row):
    """What a user pastes."""
    return [f"using Scene = {scene(row)};", call(row) + f"  // in {NUMBERS[row['scalar']][0]}"]


def check(row):
    """Code around the lines: it compiles when they do, and when Scene is what the probe measures."""
    number = NUMBERS[row["scalar"]][0]
    using, calling = lines(row)
    tags = ", axial::Looped" if row["form"] == "compact" else ""
    measured = f"Numbers::scene<axial::apps::size::scenes::{row['scene']}, {type_of(row)}{tags}>"
    if tag_of(row["algorithm"]):
        measured = f"axial::apps::size::Tagged<{measured}, axial::{tag_of(row['algorithm'])}>::type"
    return f"""{using}

void chosen() {{
  using T = {number};
  using Robot = axial::robot_of<Scene>;
  [[maybe_unused]] axial::Positions<Robot, T> q{{}};
  [[maybe_unused]] axial::Velocities<Robot, T> qd{{}};
  [[maybe_unused]] {"axial::EffortsOf<Scene, T> tau" if "tau" in calling.partition("(")[2] else "axial::Accelerations<Robot, T> qdd"}{{}};
  {"axial::FeedforwardState<Scene, T> state{};" if "state" in calling else ""}
  {"axial::Joints<Robot, T> q3{}, q4{};" if "q3" in calling else ""}
  [[maybe_unused]] axial::Inputs<Scene, T> in{{}};
  {calling}
  static_cast<void>({calling.split()[2]});
}}

using Numbers = axial::apps::number_systems::as_{row['scalar']};
static_assert(std::is_same_v<Numbers::Number, {number}>);
static_assert(std::is_same_v<Scene, {measured}>);
"""


def program(rows):
    """A source with the checks of several rows."""
    robots = "".join(f"#include <robots/{robot}.hpp>\n" for robot in sorted({row["robot"] for row in rows}))
    checks = "".join(f"namespace row_{i} {{\n{check(row)}}}\n\n" for i, row in enumerate(rows))
    return (f"#include <axial/axial.hpp>\n#include <firmware/apps/number_systems.hpp>\n#include <firmware/apps/size/algorithms.hpp>\n"
            f"{robots}\n{checks}")
