#!/usr/bin/python3
"""Every sentence of the library ("axial: ...") is reached by a program that does not compile: a source here, a mistake of
beginners_mistakes.py or of other_sentences.py, a refusal of tests/combinations/refusals.py. What is reached by none is listed, with the reason.

usage: sentences_test.py [--list]
"""

import pathlib
import re
import sys

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/combinations"))
import beginners_mistakes as mistakes  # noqa: E402
import other_sentences as others  # noqa: E402
import refusals  # noqa: E402

HERE = pathlib.Path(__file__).parent
LEAST_PART = 15  # letters by which a part of a sentence is told from those of others
# The beginning of each sentence that no program reaches yet, by reason.
UNREACHED = {
    "a part that is put together of several": (
        "axial: no such call: <Robot>",),
    "needs a compiler's option or another library": (
        "axial: without optimisation Clang makes kernels", "axial: an Eigen map needs a plain struct", "axial: an Eigen map needs the alignment"),
    "a robot of one's own that nothing else needs": (
        "axial: declared efforts and what forward dynamics makes of them", "axial: an answer of up to 8 joints", "axial: a rotor turns on a link",
        "axial: derivatives of forward dynamics in fixed point are those of up to 8", "axial: a drive's unit moves its joint by many turns",
        "axial: forward dynamics of joints that share drives on a floating base",
        "axial: in fixed point joints that share drives are solved by composite bodies",
        "axial: joints that share drives have no formats of this recursion", "axial: this function does not know joints that share drives"),
    "a tuning, or words, of one call": (
        "axial: a controlled stop takes Fixed32", "axial: wanted() is of a fall-back", "axial: products with a Jacobian have no formats",
        "axial: a factor of a conversion is out of proportion", "axial: give Velocities<Robot, Fixed32>",
        "axial: in fixed point a payload estimator's memory", "axial: payload words are of Fixed32"),
}


def sentences():
    """Literals that begin with "axial: ", put together, with the header of each."""
    found = {}
    for header in sorted((ROOT / "firmware/include").rglob("*.hpp")):
        code = re.sub(r"\\\n", "\n", re.sub(r"//.*", "", header.read_text(encoding="utf-8")))
        for literal in re.finditer(r'"axial: (?:[^"\\]|\\.)*"(?:\s*(?:\w+\s*)?"(?:[^"\\]|\\.)*")*', code):
            found.setdefault("".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literal.group())), header.relative_to(ROOT))
    return found


def parts():
    """What programs that do not compile are said to show."""
    expected = [re.sub(r"^// expect: ", "", path.read_text(encoding="utf-8").splitlines()[0]) for path in HERE.glob("*.cpp")]
    expected += [r.sentence for r in refusals.REFUSALS]
    expected += [other.sentence for other in others.ALL]
    return expected + [text for m in mistakes.ALL for text in (m.float, m.fixed) if text]


def is_reached(sentence, expected):
    return any(part in sentence or part.startswith(sentence) for part in expected if len(part) >= LEAST_PART)


def main():
    expected, listed = parts(), [begin for group in UNREACHED.values() for begin in group]
    missing = {s: of for s, of in sentences().items() if not is_reached(s, expected)}
    wrong = [f"{of}: {s}" for s, of in missing.items() if not any(s.startswith(begin) for begin in listed)]
    wrong += [f"listed as unreached, but reached or gone: {begin}" for begin in listed if not any(s.startswith(begin) for s in missing)]
    print("\n".join(wrong) or f"{len(sentences())} sentences, {len(missing)} unreached")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
