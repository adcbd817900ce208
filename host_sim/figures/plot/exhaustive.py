"""Error of sine, cosine and reciprocal over all arguments: the envelope of equal parts of their ranges.

usage: exhaustive.py ENVELOPES.json STEM
Writes STEM.png.
"""
import json
import sys

import matplotlib.pyplot as plt

import style

AXES = {"sine": ("turns", 1e9, "error, 1e-9"), "cosine": ("turns", 1e9, "error, 1e-9"),
        "reciprocal": ("d / 2^31", 1.0, "error, units of the mantissa")}


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    with open(sys.argv[1], encoding="utf-8") as file:
        envelopes = json.load(file)
    style.use()
    figure, axes = plt.subplots(1, len(envelopes), figsize=(10, 3.2), constrained_layout=True)
    for axis, each, colour in zip(axes, envelopes, style.COLOURS):
        label, scale, error = AXES[each["subject"]]
        n = len(each["upper"])
        x = [(i + 0.5) / n for i in range(n)]
        axis.fill_between(x, [scale * v for v in each["lower"]], [scale * v for v in each["upper"]], color=colour,
                          linewidth=0)
        for bound in (each["bound"], -each["bound"]):
            axis.axhline(scale * bound, color=style.INK, linewidth=0.8, linestyle="--")
        axis.set(title=each["subject"], xlabel=label, ylabel=error, xlim=(0, 1))
    style.save(figure, sys.argv[2], "Largest errors over all arguments")
    return 0


if __name__ == "__main__":
    sys.exit(main())
