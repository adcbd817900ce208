"""Writes the tables of the host benchmark into a document, as tables.py does with the others.

usage: speed_tables.py DATA_FOLDER DOCUMENT.md

DATA_FOLDER holds bench-gcc.json, bench-clang.json, the same two of batches with AVX2 (-haswell) and bench-provenance.json.
"""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "plot"))
import speed  # noqa: E402
from tables import command, markdown  # noqa: E402


class Data:
    def __init__(self, folder):
        self.all = speed.load([folder / "bench-gcc.json", folder / "bench-clang.json"])
        self.avx2 = speed.load([folder / "bench-gcc-haswell.json", folder / "bench-clang-haswell.json"])
        self.speed = speed.against_others(self.all)
        self.speed_provenance = json.loads((folder / "bench-provenance.json").read_text(encoding="utf-8"))


def ratio(row):
    return f"{row['ratio']:.1f} ({row['ratio_low']:.1f} to {row['ratio_high']:.1f})"


def speed_provenance(data):
    p = data.speed_provenance
    return (f"Measured at commit `{p['commit']}` on one core of {p['processor']}.\n\n"
            f"- our kernels: {' and '.join(p['compilers'])}, `{p['flags']}`\n"
            f"- peers, as Debian built them: {', '.join(p['packages'])}\n")


def speed_ratios(data):
    """Double, robots against algorithms, a row a peer; the worse compiler."""
    worst = speed.worse_compiler(row for row in data.speed if row["scalar"] == "double" and not speed.is_serial(row))
    algorithms = [name for name in speed.ALGORITHMS if name not in speed.ROUTES and any(key[1] == name for key in worst)]
    pairs = speed.unique((key[0], key[3]) for key in worst if key[3] != "kdl_vereshchagin")
    rows = [[f"{robot}, {speed.PEERS[peer]}"] +
            [ratio(worst[robot, algorithm, "double", peer]) for algorithm in algorithms] for robot, peer in pairs]
    return markdown(["robot, peer"] + [speed.ALGORITHMS[name].lower() for name in algorithms], rows)


def speed_routes(data):
    """Double, the routes of forward dynamics against KDL's two; the worse compiler."""
    routes = ["forward_dynamics"] + speed.ROUTES
    worst = speed.worse_compiler(row for row in data.speed if row["scalar"] == "double" and not speed.is_serial(row)
                                 and row["algorithm"] in routes and row["peer"] != "dart")
    pairs = speed.unique((key[0], key[3]) for key in worst)
    rows = [[f"{robot}, {speed.PEERS[peer]}"] + [ratio(worst[robot, route, "double", peer]) for route in routes]
            for robot, peer in pairs]
    return markdown(["robot, peer", "default"] + [speed.ALGORITHMS[route] for route in speed.ROUTES], rows)


def speed_joints(data):
    """Serial chains: ratio to every peer, the worse compiler."""
    worst = speed.worse_compiler(row for row in data.speed if speed.is_serial(row))
    columns = speed.unique((row["algorithm"], row["peer"]) for row in worst.values())
    joints = sorted({(row["joints"], row["robot"]) for row in worst.values()})
    rows = [[str(count)] + [ratio(worst[robot, algorithm, "double", peer]) for algorithm, peer in columns]
            for count, robot in joints]
    titles = [f"{speed.ALGORITHMS[algorithm].lower()}, {speed.PEERS[peer]}" for algorithm, peer in columns]
    return markdown(["joints"] + titles, rows)


def speed_exponents(data):
    rows = [[f"{label}, {compiler}", f"{power:.2f}"] for (compiler, label), points in speed.curves(data.speed).items()
            if (power := speed.exponent(points)) is not None]
    return markdown(["forward dynamics of N joints, 8 to 64", "exponent of N"], rows)


def speed_everything(data):
    header = ["algorithm, robot, scalar, peer, compiler", "ratio", "95 % interval", "ns (noise)", "peer's ns (noise)"]
    rows = [[f"{row['algorithm']}, {row['robot']}, {row['scalar']}, {row['peer']}, {row['compiler']}",
             f"{row['ratio']:.2f}", f"{row['ratio_low']:.2f} to {row['ratio_high']:.2f}", f"{row['ns_noise']:.0f}",
             f"{row['peer_ns_noise']:.0f}"] for row in data.all]
    return markdown(header, rows)


def speed_batches(data):
    return batches(data.all)


def speed_batches_avx2(data):
    return batches(data.avx2)


def batches(rows):
    """Batches against one state at a time; every compiler."""
    rows = [row for row in rows if row["peer"] == speed.ONE_STATE]
    algorithms = speed.unique(row["algorithm"] for row in rows)
    cells = {(row["robot"], row["scalar"], row["compiler"], row["algorithm"]): ratio(row) for row in rows}
    return markdown(["robot, scalar, compiler"] + [speed.ALGORITHMS[name].lower() for name in algorithms],
                    [[", ".join(key)] + [cells[(*key, name)] for name in algorithms] for key in speed.unique(key[:3] for key in cells)])


def speed_derivatives(data):
    """Derivatives against what they are of: how many times its time; the worse compiler."""
    worst = speed.worse_compiler(row for row in data.all if row["peer"] in speed.OF_DERIVATIVES.values())
    times = lambda row: f"{1 / row['ratio']:.1f} ({1 / row['ratio_high']:.1f} to {1 / row['ratio_low']:.1f})"
    cells = {(robot, scalar, algorithm): times(row) for (robot, algorithm, scalar, _), row in worst.items()}
    return markdown(["robot, scalar"] + [f"{algorithm.replace('_', ' ')}, times {peer}" for algorithm, peer in speed.OF_DERIVATIVES.items()],
                    [[", ".join(key)] + [cells[(*key, algorithm)] for algorithm in speed.OF_DERIVATIVES]
                     for key in speed.unique(key[:2] for key in cells)])


TABLES = {"speed_provenance": speed_provenance, "speed_ratios": speed_ratios, "speed_routes": speed_routes, "speed_joints": speed_joints,
          "speed_exponents": speed_exponents, "speed_everything": speed_everything,
          "speed_batches": speed_batches, "speed_batches_avx2": speed_batches_avx2, "speed_derivatives": speed_derivatives}


if __name__ == "__main__":
    command(__doc__, TABLES, Data)
