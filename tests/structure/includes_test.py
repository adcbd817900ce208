#!/usr/bin/python3
"""What a float inverse_dynamics asks the compiler to read: few headers, and none of the plug-in.

usage: includes_test.py COMPILER ROOT
"""
import pathlib
import subprocess
import sys

MOST_HEADERS, MOST_LINES = 45, 4500


def main():
    compiler, root = sys.argv[1], pathlib.Path(sys.argv[2])
    source = "#include <axial/dynamics/inverse_dynamics.hpp>\n"
    rule = subprocess.run([compiler, "-std=c++17", "-M", "-x", "c++", f"-I{root}/firmware/include", "-"], input=source,
                          capture_output=True, text=True, check=True).stdout
    headers = sorted({word for word in rule.split() if "/include/axial/" in word})
    lines = sum(len(pathlib.Path(header).read_text().splitlines()) for header in headers)
    plugged_in = [header for header in headers if "/axial/fixed" in header]
    print(f"{len(headers)} headers, {lines} lines")
    return 1 if not headers or len(headers) > MOST_HEADERS or lines > MOST_LINES or plugged_in else 0


if __name__ == "__main__":
    sys.exit(main())
