"""A board that was just ported: its instruments are sound, and its serial port carries requests and torques.

usage: ported_board.py BOARD (with tests/target on PYTHONPATH)
"""

import sys

import emulator
import link

# At rest the SCARA's slide carries its 1.25 kg at 9.8125 m/s^2, pointing down.
AT_REST, SLIDE = link.set_point([0.1] * 3, [0] * 3, [0] * 3), -1.25 * 9.8125


def main():
    board = sys.argv[1]
    code, text = emulator.run(board, "selftest")
    print(text)
    if code != 0 or " checks, 0 failed" not in text:
        return f"the self-test ends with {code}"
    with emulator.Emulator(board, "feedforward-scara") as firmware:
        if firmware.hello["board"] != board:
            return f"the firmware says it is {firmware.hello['board']}"
        for number in range(1, 50):
            answer = firmware.ask(number, AT_REST)
            if answer["status"] != link.OK or abs(answer["tau"][2] - SLIDE) > 1e-5:
                return f"request {number}: {answer}"
    return 0


if __name__ == "__main__":
    sys.exit(main())
