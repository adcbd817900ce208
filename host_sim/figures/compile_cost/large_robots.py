"""What forward dynamics of robots with many joints costs whoever compiles it: chains and trees, the choice of a route alone, every form.

usage: large_robots.py [--build NAME[,NAME...]] [--robot NAME[,NAME...]] [--form NAME[,NAME...]] [--runs N] [--output FOLDER]

Writes compile_time.json and compile_time_provenance.json. Numbers are float. The robots are robots/torso.hpp and those of
tests/builds/large_robots.hpp; `sturdy` trees are solved by elimination, for which the compiler looks at more configurations than for others.
"""

import argparse
import itertools
import pathlib
import sys
import tempfile

import compile_cost

HEADERS = """#include <axial/axial.hpp>
#include <robots/torso.hpp>
#include <tests/builds/large_robots.hpp>
"""
# name: (type, joints, chain or tree)
ROBOTS = {
    "serial6": ("robots::Serial<6>", 6, "chain"),
    "serial12": ("robots::Serial<12>", 12, "chain"),
    "serial24": ("robots::Serial<24>", 24, "chain"),
    "serial36": ("robots::Serial<36>", 36, "chain"),
    "torso": ("robots::Torso", 12, "tree"),
    "humanoid": ("robots::Humanoid", 29, "tree"),
    "sturdy30": ("robots::Limbed<6, 5, true>", 30, "tree, sturdy"),
    "sturdy50": ("robots::Limbed<10, 5, true>", 50, "tree, sturdy"),
}
SCENE = "axial::Scene<{type}, axial::Gravity, axial::RotorInertia, axial::Friction{features}>"
KERNEL = """
using Robot = {type};
using Scene = {scene};
auto kernel(const axial::Positions<Robot, float>& q, const axial::Velocities<Robot, float>& qd, const axial::Efforts<Robot, float>& tau) {{
  return axial::forward_dynamics<Scene>(q, qd, tau);
}}
"""
ROUTE = """
static_assert(axial::forward_dynamics_route<{scene}> != axial::Route::split_articulated_body);
"""
# form: (features, what is compiled)
FORMS = {
    "headers": ("", ""),
    "route": ("", ROUTE),
    "route_looped": (", axial::Looped", ROUTE),
    "default": ("", KERNEL),
    "articulated": (", axial::ArticulatedBody", KERNEL),
    "looped": (", axial::Looped", KERNEL),
    "looped_articulated": (", axial::Looped, axial::ArticulatedBody", KERNEL),
}
BUILDS = ("host-gcc-O2", "host-clang-O2")
CHOICES = {"build": BUILDS, "robot": ROBOTS, "form": FORMS}


def source(robot, form):
    features, text = FORMS[form]
    robot_type = ROBOTS[robot][0]
    return HEADERS + text.format(type=robot_type, scene=SCENE.format(type=robot_type, features=features))


def measure(build, robot, form, runs, folder):
    path = folder / "kernel.cpp"
    path.write_text(source(robot, form), encoding="utf-8")
    seconds, memory = zip(*(compile_cost.compiled(build, path, folder / "kernel.o") for _ in range(runs)))
    _, joints, shape = ROBOTS[robot]
    return {"build": build, "robot": robot, "joints": joints, "shape": shape, "form": form, "runs": runs,
            "seconds": round(min(seconds), 2), "memory_MB": round(min(memory) * 1024 / 1e6)}


def is_told(robot, form):
    """Headers are the same for all; of sturdy trees the route is what matters."""
    if form == "headers":
        return robot == "humanoid"
    return not robot.startswith("sturdy") or form.startswith("route")


def chosen(options):
    names = [known if getattr(options, choice) is None else getattr(options, choice).split(",") for choice, known in CHOICES.items()]
    for (choice, known), wanted in zip(CHOICES.items(), names):
        for name in wanted:
            if name not in known:
                sys.exit(f"axial: unknown {choice} '{name}'; there are: {', '.join(known)}")
    return [(build, robot, form) for build, robot, form in itertools.product(*names) if is_told(robot, form)]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    for choice in CHOICES:
        parser.add_argument("--" + choice)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--output", default=compile_cost.ROOT / "output/compile_cost", type=pathlib.Path)
    options = parser.parse_args()
    cases, rows = chosen(options), []
    progress = compile_cost.Progress(len(cases))
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            rows.append(measure(*case, options.runs, pathlib.Path(folder)))
            progress.step()
    for row in rows:
        print(f"{row['build']:14} {row['robot']:9} {row['form']:19} {row['seconds']:7.2f} s {row['memory_MB']:5} MB")
    options.output.mkdir(parents=True, exist_ok=True)
    compile_cost.write_json(options.output / "compile_time.json", rows)
    compile_cost.write_json(options.output / "compile_time_provenance.json", compile_cost.provenance(BUILDS))


if __name__ == "__main__":
    main()
