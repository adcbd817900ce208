"""Writes the tables of doc/measurements/separation.md, as tables.py does with the others.

usage: separation_tables.py DATA_FOLDER DOCUMENT.md
"""

import pathlib
import sys

from tables import fill, grouped, load, markdown

METHODS = {"newton_euler": "Newton-Euler", "separation": "separation", "closed_form": "closed form"}
UNITS = {"operations": "operations", "stm32f405": "Cortex-M4F", "nrf51": "Cortex-M0"}


def number(value):
    return "" if value is None else grouped(value)


def cost(row, unit):
    """Once per q + for each torque."""
    once, each = row[f"{unit}_once"], row[f"{unit}_each"]
    return "" if each is None else f"{number(once)} + {number(each)}" if once else number(each)


def separation_methods(data):
    header = ["robot, way"] + list(UNITS.values()) + [f"break even, {name}" for name in UNITS.values()] + \
        ["error, float", "error, double"]
    rows = []
    for row in data["methods"]:
        even = [number(row.get(f"{unit}_break_even")) for unit in UNITS]
        errors = [f"{row[name]:.1e}" if name in row else "" for name in ("error_float", "error_double")]
        rows.append([f"{row['robot']}, {METHODS[row['method']]}"] + [cost(row, unit) for unit in UNITS] + even + errors)
    return markdown(header, rows)


def separation_rates(data):
    header = ["robot", "ms between refreshes", "largest error", "RMS error", "largest error, ahead", "instructions per tick",
              "full rate"]
    return markdown(header, [[row["robot"], str(row["ticks"]), f"{row['error']:.1e}", f"{row['error_rms']:.1e}",
                              f"{row['error_ahead']:.1e}", number(row["stm32f405_per_tick"]),
                              number(row["stm32f405_full_rate"])] for row in data["two_rate"]])


def main(folder, document):
    data = load(pathlib.Path(folder) / "separation.json")
    provenance = load(pathlib.Path(folder) / "separation_provenance.json")
    tables = {"separation_methods": separation_methods(data), "separation_rates": separation_rates(data),
              "separation_provenance": f"Measured at commit `{provenance['commit']}`; compilers and flags as in doc/measurements/size.md.\n"}
    fill(document, tables.__getitem__)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
