"""How ./axial identify and ./axial excite end: what they refuse is one line on standard error."""

import sys


def run(name, job):
    """The exit status of a job: 1 where it is refused or a file cannot be read or written."""
    try:
        job()
    except (ValueError, OSError) as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 1
    return 0
