"""The bits of fixed point on this host: hashes of golden_bits.json.

golden_test.py PROGRAM...         runs the built parts of golden_bits
golden_test.py --compile COMPILER compiles golden_bits.cpp first
golden_test.py --update PROGRAM... writes golden_bits.json anew, after a change of formats; the commit says why
"""

import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
GOLDEN = HERE / "golden_bits.json"


def hashes(text):
    """{"<kernel>,<robot>,<arithmetic>": hash} of the lines of firmware/apps/fixed."""
    if not text.endswith("end\n"):
        raise ValueError("the run is not whole: " + text[-300:])
    rows = (line.split(",") for line in text.splitlines() if line.startswith("fixed,"))
    return {",".join(row[1:4]): row[4] for row in rows}


def run(*programs):
    """Of all parts together."""
    return {name: value for program in programs
            for name, value in hashes(subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout).items()}


def compiled(compiler):
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "golden_bits"
        subprocess.run([compiler, "-std=c++17", "-O2", f"-I{ROOT}/firmware/include", f"-I{ROOT}",
                        str(HERE / "golden_bits.cpp"), "-o", str(program)], check=True)
        return run(str(program))


def main(arguments):
    if not arguments or arguments[-1] in ("--compile", "--update"):
        sys.exit(__doc__)
    found = compiled(arguments[1]) if arguments[0] == "--compile" else run(*(each for each in arguments if each != "--update"))
    if arguments[0] == "--update":
        GOLDEN.write_text(json.dumps(found, indent=2) + "\n")
        return
    wanted = json.loads(GOLDEN.read_text())
    differ = sorted(name for name in wanted.keys() | found.keys() if wanted.get(name) != found.get(name))
    if differ:
        sys.exit("other bits: " + ", ".join(differ))
    print(f"{len(found)} kernels, the same bits")


if __name__ == "__main__":
    main(sys.argv[1:])
