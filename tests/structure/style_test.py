#!/usr/bin/python3
"""Sources are formatted, and clang-tidy has nothing to say of the library's headers. Exits 77 where the tool is not installed.

usage: style_test.py format|tidy ROOT
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
ENDS = ("*.hpp", "*.cpp", "*.h")
# Not alone: what opens and closes a header's own options, what needs Eigen, and what is Arm's assembly.
NOT_ALONE = ("options/", "eigen.hpp", "integer_calls.hpp")


def listed(root, *patterns):
    found = subprocess.run(["git", "-C", root, "ls-files", *patterns], check=True, capture_output=True, text=True).stdout.split()
    return [name for name in found if (root / name).is_file() and not name.startswith("tests/data/")]


def format_of(root):
    return ["clang-format", "--dry-run", "-Werror", *(root / name for name in listed(root, *ENDS))]


def tidy_of(root, folder):
    include = pathlib.PurePosixPath("firmware/include")
    headers = [name for name in listed(root, f"{include}/*.hpp") if not any(part in name for part in NOT_ALONE)]
    source = pathlib.Path(folder) / "headers.cpp"
    source.write_text("".join(f"#include <{pathlib.PurePosixPath(name).relative_to(include)}>\n" for name in headers), encoding="utf-8")
    return ["clang-tidy", f"--config-file={root}/.clang-tidy", "--quiet", "--warnings-as-errors=*", source, "--", "-std=c++17", f"-I{root / include}"]


def main():
    what, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    if shutil.which(f"clang-{what}") is None:
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(format_of(root) if what == "format" else tidy_of(root, folder), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout + done.stderr)
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
