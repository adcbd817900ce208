"""The frame of a study of verdicts (accusations.py, verdicts.py): arms, logs of each without a mistake and with one, how many are
judged wrongly.
"""

import argparse
import json
import pathlib
import shutil

import numpy as np

import drawn_logs

LOGS = 3  # of each arm, without a mistake and with one


class Logs:
    """The logs of one arm, made when asked for: who inherits has `engine`, which ends with it, and row(k, guilty)."""

    def __init__(self, folder, number, seed=1):
        self.seed, self.folder, self.number, self.name = seed, pathlib.Path(folder), number, drawn_logs.ARMS[number]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.engine.__exit__()

    def rows(self, logs=LOGS):
        return [self.row(k, guilty) for guilty in (False, True) for k in range(logs)]

    def random(self, k, guilty):
        return np.random.default_rng([self.seed, self.number, k, int(guilty)])

    def kind(self, k, kinds):
        """Of the k-th mistake: every one as often, of other arms each time."""
        return kinds[(LOGS * self.number + k) % len(kinds)]


def wrong(row):
    """An accusation that is false, or a mistake that the log can tell and that is not named."""
    return row["outcome"] == "false" or row["tellable"] and row["outcome"] != "named"


def run(name, description, logs_of, text, data, arguments):
    """The command line. logs_of(program, folder, number, seed): the Logs of an arm; text(row): a line; data: the file's name under doc/data."""
    parser = argparse.ArgumentParser(prog=name, description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("--program", "--output"):
        parser.add_argument(option, required=True)
    parser.add_argument("--documents")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--arms", default=",".join(drawn_logs.ARMS))
    options = parser.parse_args(arguments)
    folder, rows = pathlib.Path(options.output), []
    folder.mkdir(parents=True, exist_ok=True)
    for arm in options.arms.split(","):
        with logs_of(options.program, folder, drawn_logs.ARMS.index(arm), options.seed) as logs:
            rows += logs.rows()
        print(*map(text, rows[-2 * LOGS:]), sep="\n", flush=True)
        (folder / data).write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    print(f"{sum(map(wrong, rows))} of {len(rows)} verdicts are wrong")
    if options.documents:
        shutil.copy(folder / data, pathlib.Path(options.documents) / "data")
