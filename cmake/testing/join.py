"""Some sources of a test program as one: what they include is read once, what they share is instantiated once.

usage: join.py OUTPUT SOURCE...
Each keeps its names in a namespace of its own, after its file. A source that includes or defines behind its first line of code can not be joined.
"""
import pathlib
import re
import sys

INCLUDES = re.compile(r"^#include .*\n", re.MULTILINE)
OTHERS = re.compile(r"^[ \t]*#[ \t]*(?!include)\w+.*$", re.MULTILINE)
OURS = re.compile(r"^namespace axial((?:::\w+)*) \{", re.MULTILINE)
CODE = re.compile(r"^(?!//|#include |\s*$).+$", re.MULTILINE)


def refusal(text):
    """Why a source can not be joined, or nothing."""
    first = CODE.search(text)
    if OTHERS.search(text):
        return "it has directives besides #include"
    if first and INCLUDES.search(text, first.start()):
        return "it includes behind its first line of code"
    return ""


def body(source, text):
    """Without its includes, line for line."""
    text = INCLUDES.sub("\n", text)
    room = "of_" + re.sub(r"\W", "_", source.stem)
    if OURS.search(text):
        text = OURS.sub(rf"namespace axial\1::{room} {{", text)
        return f'#line 1 "{source}"\n{text}'
    return f'namespace {room} {{\n#line 1 "{source}"\n{text}}}  // namespace {room}\n'


def joined(sources):
    includes, bodies = {}, []
    for source in sources:
        text = source.read_text(encoding="utf-8")
        why = refusal(text)
        if why:
            sys.exit(f"{source}: can not be joined with others: {why}")
        includes.update(dict.fromkeys(INCLUDES.findall(text)))
        bodies.append(body(source, text))
    return "".join(includes) + "".join(bodies)


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(joined([pathlib.Path(each) for each in sys.argv[2:]]), encoding="utf-8")
