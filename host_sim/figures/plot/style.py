"""What every picture of the project shares: colours, type, files that do not change unless the data does."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Okabe and Ito's palette: told apart with any colour vision.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#5B5B5B", "#8C564B"]
INK = "#24292f"
FAINT = "#d0d7de"


def use():
    plt.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 10, "axes.titlesize": 11, "axes.titleweight": "bold",
        "axes.titlelocation": "left", "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK,
        "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False,
        "axes.grid": True, "grid.color": FAINT, "grid.linewidth": 0.6, "axes.axisbelow": True,
        "lines.linewidth": 1.6, "legend.frameon": False, "legend.fontsize": 9,
        "figure.facecolor": "white",
    })


WIDEST = 1400  # pixels


def save(figure, stem, says=None):
    """Writes <stem>.png, without a date inside; `says` is the picture's sentence, above everything."""
    if says is not None:
        figure.suptitle(says, x=0.01, y=1.0, ha="left", va="bottom", fontsize=12.5, fontweight="bold")
    width = figure.get_tightbbox().width + 0.2
    dpi = min(120, (WIDEST - 1) / width)
    figure.savefig(stem + ".png", dpi=dpi, bbox_inches="tight", pad_inches=0.1, metadata={"Software": None})
    plt.close(figure)
