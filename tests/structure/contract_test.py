#!/usr/bin/python3
"""The contract of link views (firmware/include/axial/links/README.md) lists the members of tests/unit/links/minimal_view.hpp, and no other.

usage: contract_test.py ROOT
"""
import pathlib
import re
import sys

MEMBER = re.compile(r"^  (?:using (\w+) =|(?:static )?const(?:expr)? [^(=;]*?(\w+)(?: =|;)|(?:constexpr )?(?:auto|int|double|void|Plain|const Values&|Vec3<double>|Pose<.*>) (\w+)\()",
                    re.MULTILINE)
HIDDEN = {"i"}  # which link a view is of


def listed(page):
    """Names of the first column of the contract's tables."""
    rows = re.findall(r"^\| (`.*?`) \|", page[page.index("## The contract"):], re.MULTILINE)
    return {re.match(r"\w+", name).group() for row in rows for name in re.findall(r"`([^`]+)`", row)}


def written(views):
    """Members of the views."""
    views = views[views.index("struct MinimalLink "):]
    return {name for names in MEMBER.findall(views) for name in names if name} - HIDDEN


def main():
    root = pathlib.Path(sys.argv[1])
    page = listed((root / "firmware/include/axial/links/README.md").read_text())
    views = written((root / "tests/unit/links/minimal_view.hpp").read_text())
    if page != views:
        print("listed and not in the views:", sorted(page - views), "in the views and not listed:", sorted(views - page), file=sys.stderr)
    return 0 if page == views and len(page) > 30 else 1


if __name__ == "__main__":
    sys.exit(main())
