"""The main job in fixed point: what the float image says to bad requests, the torques of the Cortex-M4F bit by bit, one count
for every request, inside its budgets, and no float arithmetic.

fixed_test.py BOARD; or fixed_test.py --update-budgets, which writes fixed_budgets.json, 2 % above what is measured now.
"""

import json
import math
import pathlib
import random
import sys

import emulator
import harness
import link
from symbols_test import FORBIDDEN, SOFT_FLOAT, SOFT_DOUBLE, defined, offenders

sys.path.insert(0, str(emulator.ROOT / "host_sim/boards/size"))
import image  # noqa: E402

REFERENCE = "stm32f405"
SEED = 20241001
STATES = 200
BOARDS = ("stm32f405", "stm32f100", "nrf51", "rv32_virt")
BUDGETS = pathlib.Path(__file__).parent / "fixed_budgets.json"

# What the robots declare (robots/*.hpp): middle and half of the positions, speed, acceleration.
LIMITS = {
    "scara": [(0.0, 2.5, 4.0, 20.0), (0.0, 2.6, 5.0, 30.0), (0.125, 0.125, 1.0, 10.0)],
    "puma560": [(0.0, 2.79, 1.4, 6.0), (-1.57, 2.35, 1.2, 6.0), (1.57, 2.35, 2.1, 10.0), (0.52, 2.44, 3.9, 25.0),
                (0.0, 1.74, 4.2, 25.0), (0.0, 4.6, 3.9, 25.0)],
}
# A motion of the Panda inside its limits for which joint 1 needs 1.3 times its effort.
HARD = ([-0.8, -0.8, 2.4, -0.8, -2.4, 1.2, -1.4], [-2, -2, -2, -2, 2, -2, -2], [-15, 7, -10, 12, -15, -20, 20])


def states(robot):
    """Seeded set-points inside the limits, corners of speed and acceleration among them."""
    dice = random.Random(SEED)
    for number in range(STATES):
        share = (lambda: dice.choice((-1.0, 1.0))) if number % 4 == 0 else (lambda: dice.uniform(-1, 1))
        limits = LIMITS[robot]
        yield link.set_point([middle + half * dice.uniform(-0.999, 0.999) for middle, half, _, _ in limits],
                             [speed * share() for _, _, speed, _ in limits],
                             [acceleration * share() for _, _, _, acceleration in limits])


def answers(board, image_name, robot):
    """Every answer, and the stack that it all took."""
    with emulator.Emulator(board, f"{image_name}-{robot}") as firmware:
        told = [firmware.ask(number, state) for number, state in enumerate(states(robot), 1)]
        return told, firmware.stats()["stack_bytes"]


def cost(board, robot, told, stack):
    flash = image.Image(emulator.image(board, "feedforward-fixed-" + robot)).flash
    return {"instructions": told[0]["count"], "flash_bytes": flash, "stack_bytes": stack}


def update_budgets():
    budgets = {}
    for board in BOARDS:
        for robot in LIMITS:
            found = cost(board, robot, *answers(board, "feedforward-fixed", robot))
            budgets[f"{board}/{robot}"] = {name: math.ceil(1.02 * value) + 8 * (name == "stack_bytes") for name, value in found.items()}
    BUDGETS.write_text(json.dumps(budgets, indent=1) + "\n", encoding="utf-8")


class Fixed(harness.BoardTest):
    recorded = {}

    def run_robot(self, robot, board=None):
        key = board or self.board, robot
        if key not in self.recorded:
            self.recorded[key] = answers(key[0], "feedforward-fixed", robot)
        return self.recorded[key]

    def test_hello_and_one_torque_of_every_robot(self):
        for robot, joints in harness.ROBOTS.items():
            with self.subTest(robot), emulator.Emulator(self.board, "feedforward-fixed-" + robot) as firmware:
                self.assertEqual((firmware.hello["robot"], firmware.hello["joints"]), (robot, joints))
                q = HARD[0] if robot == "panda" else [0.1] * joints
                first = firmware.ask(1, link.set_point(q, [0] * joints, [0] * joints))
                self.assertEqual(first["status"], link.OK)
                self.assertTrue(any(first["tau"]))

    def test_torques_are_those_of_the_float_image(self):
        for robot in LIMITS:
            with self.subTest(robot):
                fixed, floats = self.run_robot(robot)[0], answers(self.board, "feedforward", robot)[0]
                most = [max(abs(answer["tau"][joint]) for answer in floats) for joint in range(len(LIMITS[robot]))]
                for one, other in zip(fixed, floats):
                    self.assertEqual((one["status"], one["joint"]), (other["status"], other["joint"]))
                    for a, b, scale in zip(one["tau"], other["tau"], most):
                        self.assertLessEqual(abs(a - b), 2e-6 * scale, "float itself errs by 5e-7")
                self.assertGreater(sum(answer["status"] == link.OK for answer in fixed), STATES / 2)

    def test_same_bits_as_the_cortex_m4f(self):
        for robot in LIMITS:
            wanted, found = self.run_robot(robot, REFERENCE)[0], self.run_robot(robot)[0]
            self.assertEqual([answer["tau"] for answer in found], [answer["tau"] for answer in wanted], robot)

    def test_one_count_for_every_request(self):
        for robot in LIMITS:
            self.assertEqual(len({answer["count"] for answer in self.run_robot(robot)[0]}), 1, robot)

    def test_an_effort_beyond_its_limit_is_clamped_and_costs_the_same(self):
        with emulator.Emulator(self.board, "feedforward-fixed-panda") as firmware:
            gentle = firmware.ask(1, link.set_point(HARD[0], [0] * 7, [0] * 7))
            hard = firmware.ask(2, link.set_point(*HARD))
            other = firmware.ask(3, link.set_point(HARD[0], HARD[1], [-x for x in HARD[2]]))
        self.assertEqual((gentle["status"], hard["status"], hard["joint"]), (link.OK, link.EFFORT_LIMITED, 1))
        self.assertEqual(abs(hard["tau"][1]), 87.0)
        self.assertEqual(gentle["count"], hard["count"])
        self.assertEqual(gentle["count"], other["count"])

    def test_budgets(self):
        budgets = json.loads(BUDGETS.read_text(encoding="utf-8"))
        for robot in LIMITS:
            found, budget = cost(self.board, robot, *self.run_robot(robot)), budgets[f"{self.board}/{robot}"]
            self.assertEqual(found.keys(), budget.keys())
            for name, most in budget.items():
                self.assertLessEqual(found[name], most, f"{robot}: {name}")
                self.assertGreater(found[name], 0.5 * most, f"{robot}: {name}: the budget is of this image")

    def test_bad_requests_repeat_the_last_safe_torque(self):
        at_rest = link.set_point([0.1] * 3, [0] * 3, [0] * 3)
        bad = [
            ([0.1, math.nan, 0.1], [0] * 3, [0] * 3, link.NOT_FINITE, 1),
            ([0.1] * 3, [0, 0, math.inf], [0] * 3, link.NOT_FINITE, 2),
            ([0.1] * 3, [0] * 3, [-math.inf, 0, 0], link.NOT_FINITE, 0),
            ([0.1] * 3, [0, 0, 1e6], [0] * 3, link.OUTSIDE_LIMITS, 2),
            ([0.1] * 3, [0, -5.00001, 0], [0] * 3, link.OUTSIDE_LIMITS, 1),
            ([0.1] * 3, [0] * 3, [3e38, 0, 0], link.OUTSIDE_LIMITS, 0),
            ([0.1, 2.6001, 0.1], [0] * 3, [0] * 3, link.OUTSIDE_LIMITS, 1),
            ([0.1 + 2 * math.pi, 0.1, 0.1], [0] * 3, [0] * 3, link.OUTSIDE_LIMITS, 0),  # a turn further: not where it says
            ([0.1, 0.1, -1e-6], [0] * 3, [0] * 3, link.OUTSIDE_LIMITS, 2),
        ]
        with emulator.Emulator(self.board, "feedforward-fixed-scara") as firmware:
            safe = firmware.ask(1, at_rest)
            self.assertEqual(safe["status"], link.OK)
            self.assertAlmostEqual(safe["tau"][2], -1.25 * 9.8125, places=5)
            for number, (q, qd, qdd, status, joint) in enumerate(bad, 2):
                told = firmware.ask(number, link.set_point(q, qd, qdd))
                self.assertEqual((told["tau"], told["status"], told["joint"]), (safe["tau"], status, joint), (q, qd, qdd))
            self.assertEqual(firmware.stats()["refused"], len(bad))
            again = firmware.ask(len(bad) + 2, at_rest)
            self.assertEqual((again["tau"], again["status"]), (safe["tau"], link.OK))

    def test_nothing_of_float_is_linked(self):
        for robot in harness.ROBOTS:
            symbols = defined(emulator.image(self.board, "feedforward-fixed-" + robot))
            for pattern in (SOFT_FLOAT, SOFT_DOUBLE, *FORBIDDEN.values()):
                with self.subTest(robot=robot, pattern=pattern):
                    self.assertEqual(offenders(symbols, pattern), [])


if __name__ == "__main__":
    update_budgets() if sys.argv[1:] == ["--update-budgets"] else harness.main()
