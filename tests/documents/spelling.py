#!/usr/bin/python3
"""Words of all pages, by Debian's hunspell in British English, and by words.txt, which has the names and terms that it does not know.

usage: spelling.py ROOT [--write]     --write: words.txt anew, of what is on the pages; read what it adds before committing it
Ends with 1 and the words where one is known to neither, or where words.txt has one that no page uses.
"""
import pathlib
import re
import shutil
import subprocess
import sys

NOT_PROSE = re.compile(r"^```.*?^```|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->|https?://\S+|\S*[./_]\w\S*", re.MULTILINE | re.DOTALL)
WORD = re.compile(r"[A-Za-z]+(?:['’][a-z]+)?")
POSSESSIVE = re.compile(r"['’]s$")
NO_WORD = re.compile(r"^.{1,2}$|.[A-Z]")  # symbols, abbreviations, names of code
DICTIONARY = "en_GB"
SKIPPED = 77  # as ctest reads it


def pages(root):
    names = subprocess.run(["git", "-C", root, "ls-files", "*.md"], check=True, capture_output=True, text=True).stdout.splitlines()
    return [root / name for name in names if (root / name).is_file()]


def words_of(page):
    text = NOT_PROSE.sub(" ", page.read_text(encoding="utf-8"))
    return {word for word in (POSSESSIVE.sub("", found) for found in WORD.findall(text)) if not NO_WORD.search(word)}


def unknown(words):
    said = subprocess.run(["hunspell", "-d", DICTIONARY, "-l"], input="\n".join(sorted(words)), check=True, capture_output=True, text=True)
    return set(said.stdout.split())


def main(root, *options):
    root, known_file = pathlib.Path(root).resolve(), pathlib.Path(__file__).with_name("words.txt")
    if shutil.which("hunspell") is None:
        print("no hunspell: apt-get install hunspell hunspell-en-gb")
        return SKIPPED
    where = {}
    for page in pages(root):
        for word in words_of(page):
            where.setdefault(word, page.relative_to(root))
    found = unknown(where)
    if "--write" in options:
        known_file.write_text("".join(f"{word}\n" for word in sorted(found, key=lambda word: (word.lower(), word))), encoding="utf-8")
        return 0
    known = set(known_file.read_text(encoding="utf-8").split())
    wrong = [f"{where[word]}: '{word}' is no word" for word in sorted(found - known)] + [f"words.txt: no page uses '{word}'" for word in sorted(known - found)]
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
