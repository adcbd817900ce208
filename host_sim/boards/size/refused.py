"""What a build of a user's kernels says: which of them the library does not offer for joints that share drives, for so many, or for a
joint that moves no mass, which is named.

usage: refused.py LOG     prints the compiler's sentences; exits with 1 where anything else failed too
"""

import pathlib
import re
import sys

SENTENCE = re.compile(r"(?:static assertion failed: |error: static_assert failed.* \"|region `)([^\n\"]*)")
ABOUT = re.compile("share drives|of up to 8 joints|every joint to move some mass")
FULL = re.compile(r"region `(\w+)' overflowed by (\d+) bytes")
# recursion/composite_scale.hpp: compilers print the condition that failed.
JOINT = re.compile(r"every_joint_moves_mass_but<(\d+)>")
SOURCE = re.compile(r"([\w.+-]+)\.cpp\.obj?\b")


def failures(log):
    """(what could not be built, what was said of it) of each failed step of ninja's log."""
    for text in log.split("\nFAILED: ")[1:]:
        first, _, rest = text.partition("\n")
        yield first, re.split(r"\n\[\d+/\d+\] |\nninja: ", rest)[0]


def sentences(said):
    """The library's sentences in what a compiler says, with the joint that moves no mass."""
    joint = JOINT.search(said)
    named = f" (joint {joint[1]}, counted from 0 at the base, moves none)" if joint else ""
    return [sentence + (named if "every joint to move some mass" in sentence else "") for sentence in SENTENCE.findall(said)]


def reason(log, images, source):
    """Why a kernel of that source has no image, or none to be set against: the library's sentence or the linker's; None where the log has none."""
    names = "|".join([re.escape(source) + r"\.cpp\.obj?", *(re.escape(image) + r"\.elf" for image in images)])
    for target, said in failures("\n" + log):
        if re.search(rf"\b({names})(?!\S)", target):
            full = FULL.search(said)
            return f"it and what measures it do not fit: {full[1]} overflows by {full[2]} bytes" if full else next(iter(sentences(said)), "it does not compile")
    return None


def refused(log):
    """{source: the library's first sentence about the robot's joints}, and whether nothing else failed."""
    sources, only = {}, True
    for target, said in failures("\n" + log):
        about = [sentence for sentence in sentences(said) if ABOUT.search(sentence)]
        source = SOURCE.search(target)
        if about and source:
            sources[source[1]] = min(about, key=lambda sentence: ("this function" in sentence, sentence))
        else:
            only = False
    return sources, only


def main():
    log = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8", errors="replace")
    sources, only = refused(log)
    said = sentences(log) if not only else sources.values()
    for sentence in sorted(set(said))[:5]:
        print(sentence)
    sys.exit(0 if only else 1)


if __name__ == "__main__":
    main()
