#!/usr/bin/python3
"""What a user has to know stands on the page where a user looks for it: facts.txt has it line by line. usage: facts.py ROOT

A line without an indent names a page. Each line below it is one fact: what it is | words of the page that say so.
Line breaks, emphasis, backquotes and targets of links do not count, and ` ... ` stands for up to 200 characters.
The words occur once on their page, so that no sentence goes, and none comes twice, unnoticed.
"""
import collections
import pathlib
import re
import sys
import tempfile
import unittest

FEWEST_FACTS, FEWEST_WORDS, WIDEST_GAP = 200, 2, 200
WITHOUT_FACTS = {"README.md"}  # the index of the guides: links alone
LINK = re.compile(r"\[([^\]]*)\]\([^)\s]*\)")
Fact = collections.namedtuple("Fact", "line page what words")


def plain(text):
    return " ".join(re.sub("[`*]", "", LINK.sub(r"\1", text)).split())


def places(words, text):
    """How often the words stand in a plain text."""
    return len(re.findall(f".{{0,{WIDEST_GAP}}}?".join(map(re.escape, plain(words).split(" ... "))), text))


def facts_of(listing):
    page = ""
    for number, line in enumerate(listing.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            if line.startswith(" "):
                what, _, words = line.strip().partition(" | ")
                yield Fact(number, page, what.strip(), words.strip())
            else:
                page = line.strip()


def is_malformed(fact):
    pieces = f" {fact.words} ".split(" ... ")
    return not (fact.page and all(map(str.strip, pieces)) and len(" ".join(pieces).split()) >= FEWEST_WORDS)


def twice(facts):
    for name in ("what", "words"):
        seen = set()
        for fact in facts:
            key = fact.page, plain(getattr(fact, name)).casefold()
            if key in seen:
                yield f"facts.txt:{fact.line}: listed twice: {getattr(fact, name)}"
            seen.add(key)


def on_pages(root, facts):
    texts = {name: plain((root / name).read_text(encoding="utf-8")) for name in {fact.page for fact in facts} if (root / name).is_file()}
    for fact in facts:
        if fact.page not in texts:
            yield f"facts.txt:{fact.line}: there is no page {fact.page}"
        elif (count := places(fact.words, texts[fact.page])) != 1:
            yield f"{fact.page}: {fact.what} (facts.txt:{fact.line}: " + (f"its words stand there {count} times)" if count else f"'{fact.words}' is not there)")


def problems(root, listing):
    facts = list(facts_of(listing))
    yield from (f"facts.txt:{fact.line}: not 'fact | words of the page' below a page: {fact.what}" for fact in facts if is_malformed(fact))
    yield from twice(facts)
    yield from on_pages(root, [fact for fact in facts if not is_malformed(fact)])
    told = {fact.page for fact in facts}
    guides = {str(page.relative_to(root)) for page in (root / "doc/guides").glob("*.md") if page.name not in WITHOUT_FACTS}
    yield from (f"{page}: facts.txt has no fact of it" for page in sorted(guides - told))


class Facts(unittest.TestCase):
    def test_stand_on_their_pages(self):
        root, listing = pathlib.Path(ROOT).resolve(), pathlib.Path(__file__).with_name("facts.txt").read_text(encoding="utf-8")
        found = list(problems(root, listing))
        if found:
            self.fail("\n".join([f"{len(found)} facts are amiss:", *found]))
        self.assertGreaterEqual(len(list(facts_of(listing))), FEWEST_FACTS)


class Checker(unittest.TestCase):
    PAGE = "# Drives\n\nA torque of `0` is **no\n  torque** ([why](why.md)). Never NaN.\n"

    def found(self, listing, page=PAGE, name="drives.md"):
        with tempfile.TemporaryDirectory() as folder:
            guides = pathlib.Path(folder) / "doc/guides"
            guides.mkdir(parents=True)
            (guides / "README.md").write_text("- [Drives](drives.md)\n", encoding="utf-8")
            (guides / name).write_text(page, encoding="utf-8")
            return list(problems(pathlib.Path(folder), listing))

    def test_reads_over_line_breaks_and_marks(self):
        self.assertEqual(self.found("doc/guides/drives.md\n# said\n  0 is off | torque of 0 is no torque (why)\n\n  a gap | A torque ... Never NaN\n"), [])

    def test_names_page_and_fact_that_is_gone(self):
        listing = "doc/guides/drives.md\n  0 is off | of 0 is no torque\n  never NaN | Never NaN.\n"
        self.assertEqual(self.found(listing, self.PAGE.replace(" Never NaN.", "")), ["doc/guides/drives.md: never NaN (facts.txt:3: 'Never NaN.' is not there)"])

    def test_a_gap_is_no_page(self):
        self.assertIn("is not there", self.found("doc/guides/drives.md\n  far | A torque ... Never\n", "A torque" + " x" * 101 + " Never NaN")[0])

    def test_refuses_words_that_stand_twice(self):
        self.assertIn("stand there 2 times", self.found("doc/guides/drives.md\n  NaN | Never NaN\n", self.PAGE * 2)[0])

    def test_refuses_lines_that_are_no_fact(self):
        for line in ("0 is off", "0 is off | ", "0 is off | torque", "0 is off | ... no torque", "0 is off | no torque ...", "| no torque"):
            self.assertIn("not 'fact | words of the page'", self.found(f"doc/guides/drives.md\n  {line}\n")[0], line)
        self.assertIn("not 'fact | words", self.found("  0 is off | no torque\n")[0])

    def test_refuses_a_fact_that_is_listed_twice(self):
        for again in ("0 is  OFF | Never NaN", "nothing | is no torque"):
            self.assertEqual(len(self.found(f"doc/guides/drives.md\n  0 is off | is no torque\n  {again}\n")), 1, again)

    def test_names_pages_that_are_not_there_and_guides_without_a_fact(self):
        found = self.found("doc/guides/other.md\n  0 is off | is no torque\n")
        self.assertEqual(found, ["facts.txt:2: there is no page doc/guides/other.md", "doc/guides/drives.md: facts.txt has no fact of it"])


if __name__ == "__main__":
    ROOT = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
