"""What a run of many tests ends with: each failed test's name and the last lines that it printed, from ctest's JUnit files.

usage: failed_tests.py BUILD...
Of each build's folder results.xml; where it is not there, the build failed before its tests.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree

LINES = 12  # of a test's output
WIDTH = 240  # of a line


def end_of(output):
    lines = [line.rstrip() for line in output.splitlines() if line.strip()]
    return ["    " + line[:WIDTH] for line in lines[-LINES:]]


def is_failure(case):
    skipped = case.find("skipped")
    unfound = skipped is not None and not skipped.get("message", "").startswith(("SKIP_", "Disabled"))
    return case.get("status") == "fail" or unfound


def failures(build):
    """The failed tests of one build, each as the lines to print."""
    path = os.path.join(build, "results.xml")
    if not os.path.exists(path):
        return [["the build in " + build + ", so that none of its tests were run"]]
    cases = filter(is_failure, ElementTree.parse(path).getroot().iter("testcase"))
    return [["%s (after %.0f s)" % (case.get("name"), float(case.get("time")))] + end_of(case.findtext("system-out") or "") for case in cases]


def main(builds):
    for build in builds:
        for name, *output in failures(build):
            print("\n".join(["axial: failed: " + name] + output))


if __name__ == "__main__":
    main(sys.argv[1:])
