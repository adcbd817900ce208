"""Writes the C++ blocks of a document to <page>-1.inc, <page>-2.inc, ... usage: extract.py DOCUMENT FOLDER

--check PAGES... -- SOURCES...: every block of every page is included by a source, or the missing ones are named."""
import pathlib
import re
import sys

# Whole files are shown_files.py's.
BLOCK = re.compile(r'(?<! -->\n)^```cpp\n(.*?)^```', re.MULTILINE | re.DOTALL)


def blocks(page):
    """The name that a source includes, and the text, of every C++ block."""
    texts = BLOCK.findall(page.read_text())
    return {f'{page.stem.lower()}-{number}.inc': text for number, text in enumerate(texts, 1)}


def extract(page, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in blocks(page).items():
        (folder / name).write_text(text)


def not_included(pages, sources):
    included = set(re.findall(r'#include "([\w.-]+\.inc)"', ''.join(source.read_text() for source in sources)))
    return [f'{page}: {name} is compiled by no source of tests/documents'
            for page in pages for name in blocks(page) if name not in included]


def main(arguments):
    if arguments[0] != '--check':
        extract(pathlib.Path(arguments[0]), pathlib.Path(arguments[1]))
        return 0
    middle = arguments.index('--')
    missing = not_included([pathlib.Path(a) for a in arguments[1:middle]], [pathlib.Path(a) for a in arguments[middle + 1:]])
    print('\n'.join(missing) or 'every block is compiled')
    return 1 if missing else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
