"""Draws contacts: the external effort of each joint, the observer's residual, the threshold, and when a collision is reported.

usage: collide.py COLLIDE.csv   (writes COLLIDE.png beside it)
"""

import csv
import sys

import matplotlib.pyplot as plt

import style

JOINTS = [1, 2, 4, 5]  # of arm and wrist; a contact every 1.5 s, on the joints in turn
CLOSE = (0.49, 0.53)  # s about the first contact, on joint 1


def main(table):
    with open(table, encoding="utf-8", newline="") as text:
        samples = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(text)]
    style.use()
    figure, panels = plt.subplots(len(JOINTS) + 1, 1, figsize=(9, 10.5))
    near = [s for s in samples if CLOSE[0] <= s["time"] <= CLOSE[1]]
    draw(panels[0], near, 1, marker=".")
    panels[0].set_title("5 % of joint 1's effort limit: dashed what acts, line the residual, red while reported")
    for panel, joint in zip(panels[1:], JOINTS):
        draw(panel, samples[::5], joint)
    panels[-1].set_xlabel("time, s")
    figure.tight_layout()
    style.save(figure, table.removesuffix(".csv"), "A momentum observer sees contacts of a simulated Panda")


def draw(panel, samples, joint, marker=None):
    time = [s["time"] for s in samples]
    threshold = samples[0][f"threshold{joint}"]
    panel.plot(time, [s[f"residual{joint}"] for s in samples], color=style.COLOURS[0], linewidth=0.9, marker=marker)
    panel.plot(time, [s[f"external{joint}"] for s in samples], color=style.INK, linewidth=1.0, linestyle="--")
    for side in (threshold, -threshold):
        panel.axhline(side, color=style.COLOURS[4], linewidth=0.9)
    low, high = panel.get_ylim()
    panel.fill_between(time, low, high, where=[s["detected"] > 0.5 for s in samples], color=style.COLOURS[1], alpha=0.15,
                       step="post", linewidth=0)
    panel.set_ylim(low, high)
    panel.set_ylabel(f"joint {joint}, N m")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
