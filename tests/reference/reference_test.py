#!/usr/bin/python3
"""reference_test.py REFERENCE: its --check finds every kind of name without a comment, and a malformed comment, and nothing else."""
import json
import pathlib
import subprocess
import sys
import tempfile

HEADER = """// A header.
#pragma once
namespace axial {
struct bare_tag {};
struct documented_tag {};  ///< one
/// One comment for two.
struct Box {
  int documented_a{}, documented_b{};  ///< both
  int bare_c{}, bare_d{};
  template <class T>
  T bare_grown(T x) const { return x; }
  enum class BareKind { one, two };

 private:
  int hidden_{};
};
template <class T>
Box(T) -> Box<T>;
int bare_sum(int a, int b);
template <class T>
using BareSame = T;
inline constexpr int bare_limit = 3;
/// Of several.
///@{
int documented_first();
AXIAL_INLINE int documented_second();
///@}
namespace detail {
struct Inner { int internal_x; };
struct InternalTag {};
int internal_sum();
}  // namespace detail
}  // namespace axial
#define BARE_MACRO 1
"""
BARE = {"bare_tag", "bare_c", "bare_d", "bare_grown", "BareKind", "bare_sum", "BareSame", "bare_limit", "BARE_MACRO"}
GOOD = "// A header.\n#pragma once\nnamespace axial {\n/// A sum, m.\nint sum(int a);\n}  // namespace axial\n"
MALFORMED = GOOD.replace("A sum, m.", "A sum of Box<s>.")


def check(header):
    """Status, findings and messages of the check over a folder with one header."""
    with tempfile.TemporaryDirectory() as folder:
        include = pathlib.Path(folder, "include/axial/scalar")
        include.mkdir(parents=True)
        (include / "header.hpp").write_text(header)
        found = pathlib.Path(folder, "found.json")
        done = subprocess.run(["/usr/bin/python3", "-E", "-B", sys.argv[1], "--check", "--json", found, pathlib.Path(folder, "include")],
                              capture_output=True, text=True, check=False)
        return done.returncode, json.loads(found.read_text()) if found.exists() else None, done.stderr


def expect(claim, holds, shown):
    if not holds:
        sys.exit(f"{claim}: {shown}")


def main():
    status, found, messages = check(HEADER)
    names = {word for each in found or [] for word in BARE if word in (each["name"] or "")}
    expect("names without a comment are found", status == 1 and names == BARE, (status, BARE - names, messages))
    expect("nothing else is found", len(found) == len(BARE), found)
    expect("the messages name the lines", "header.hpp:9:" in messages, messages)
    status, found, messages = check(GOOD)
    expect("a documented header passes", status == 0 and found == [] and not messages, (status, found, messages))
    status, found, messages = check(MALFORMED)
    expect("a malformed comment is found", status == 1 and len(found) == 1 and not found[0]["name"], (status, found, messages))


main()
