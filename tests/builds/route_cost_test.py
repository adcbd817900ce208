#!/usr/bin/python3
"""What the choice of a route costs the compiler, by what does not depend on a machine's other work: memory, and the steps of each constant.

usage: route_cost_test.py COMPILER

Memory is the compiler's peak above that of the same source which only reads the robot's description.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import compiler

SOURCE = """#include <axial/axial.hpp>
#include <tests/builds/large_robots.hpp>
using Robot = robots::{robot};
static_assert(Robot::chain.size > 0);
{call}
"""
ROUTE = "static_assert(axial::forward_dynamics_route<{scene}> == axial::Route::{route});"
LOOPED = "axial::Scene<Robot, axial::Gravity, axial::RotorInertia, axial::Looped>"
# (robot, scene, route, most MiB): GCC 12 takes half of that or two thirds, Clang 14 nothing above what its headers take.
CASES = [("Humanoid", "Robot", "articulated_body", 30), ("Humanoid", LOOPED, "articulated_body", 30),
         ("Serial<36>", "Robot", "articulated_body", 15), ("Limbed<10, 5, true>", "Robot", "composite_body", 80)]
# Both compilers count what a constant takes and give up: GCC operations, from 2^25 on unless told otherwise, Clang steps, from 2^20 on.
LIMITS = {"g++": f"-fconstexpr-ops-limit={1 << 20}", "clang++": f"-fconstexpr-steps={1 << 18}"}


def compiled(command, path, *more):
    """(exit status, peak KiB, messages) of a compilation."""
    process = subprocess.Popen([*command, "-std=c++17", "-O2", *more, f"-I{compiler.INCLUDE}", f"-I{compiler.ROOT}", "-S", path, "-o", "/dev/null"],
                               stderr=subprocess.PIPE, text=True)
    messages = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    process.stderr.close()
    return process.returncode, used.ru_maxrss, messages


def main(name):
    command, limit = [name], LIMITS["clang++" if "clang" in name else "g++"]
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "route.cpp")

        def peak(text, *more):
            path.write_text(text, encoding="utf-8")
            status, kibibytes, messages = compiled(command, path, *more)
            if status:
                sys.exit(f"{text}\n{messages[:4000]}")
            return kibibytes / 1024

        for robot, scene, route, most in CASES:
            alone = peak(SOURCE.format(robot=robot, call=""))
            taken = peak(SOURCE.format(robot=robot, call=ROUTE.format(scene=scene, route=route)), limit) - alone
            print(f"{robot}, {scene}: {taken:.0f} MiB of {most}")
            if taken > most:
                failures.append(f"the route of {robot} costs {taken:.0f} MiB, more than {most}")
    if failures:
        sys.exit("\n".join(failures))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
