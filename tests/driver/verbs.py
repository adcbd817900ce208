#!/usr/bin/python3
"""The verbs of ./axial in their shortest forms, as verbs.txt lists them.

usage: verbs.py run NAME HOST_BUILD     runs a line; exits 77 where a package that it needs is not installed
       verbs.py complete                every verb has a line, and every compiler that a verb names
       verbs.py pages                   every command that a page shows has options that its verb takes
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "tests/driver/verbs.txt"
BUILT = ("host", "board", "copy", ".ci/run")
SKIPPED = 77
SHOWN = re.compile(r"(?:^|[\s`(])\./axial ([a-z][^`\n)|;]*)")
PLACEHOLDER = re.compile(r"^[A-Z_]+$|\.\.\.|^\[|^\$|^<")


class Wrong(Exception):
    pass


def lines():
    """{name: (needs, commands, expects)}"""
    cells = [[cell.strip() for cell in line.split("|")] for line in TABLE.read_text(encoding="utf-8").splitlines()
             if line.strip() and not line.startswith("#")]
    return {name: (needs.split(), commands, expects) for name, needs, commands, expects in cells}


def verbs():
    return sorted(path.stem for path in (ROOT / "cmake/driver/verbs").glob("*.sh"))


def verb_of(name, known):
    """The verb that a line's name begins with."""
    return max((verb for verb in known if name == verb or name.startswith(verb + "-")), key=len, default=None)


def installed(package):
    done = subprocess.run(["dpkg-query", "-W", "-f=${db:Status-Status}", package], capture_output=True, text=True, check=False)
    return done.stdout == "installed"


def copy_of_tree(folder):
    """What git knows of, as it is now."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], check=True, capture_output=True).stdout
    subprocess.run(["cp", "--parents", "-t", folder, *(name for name in listed.decode().split("\0") if name and (ROOT / name).is_file())],
                   check=True, cwd=ROOT)
    return pathlib.Path(folder)


def command_line(text, tree, places):
    words = [word.format(**places) for word in shlex.split(text)]
    return [words[0][1:], *words[1:]] if words[0].startswith("!") else [tree / "axial", *words]


def run_commands(commands, tree, places):
    """All that they print. The host's programs are those of this build."""
    environment = {**os.environ, "AXIAL_HOST_PRESET": pathlib.Path(places["host"]).name, "AXIAL_GALLERY": places["out"]}  # or it shows what it measured before
    printed = ""
    for text in commands.split(" ; "):
        done = subprocess.run(command_line(text.strip(), tree, places), cwd=tree, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        printed += done.stdout
        if done.returncode != 0:
            raise Wrong(f"{text}: ends with {done.returncode}\n{done.stdout[-4000:]}")
    return printed


def check_expected(expects, printed, tree, places):
    wanted = expects.format(**places)
    path = tree / wanted
    if wanted == "-":
        return
    if "/" in wanted and not (path.is_file() and path.stat().st_size > 0):
        raise Wrong(f"there is no {wanted}\n{printed[-4000:]}")
    if "/" not in wanted and wanted not in printed:
        raise Wrong(f"does not say '{wanted}' but\n{printed[-4000:]}")


def run(name, host):
    needs, commands, expects = lines()[name]
    missing = [package for package in needs if package not in BUILT and not installed(package)]
    if missing:
        print(f"skipped: {' '.join(missing)} is not installed; the verb installs it")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="axial-verb-") as folder, tempfile.TemporaryDirectory(prefix="axial-tree-") as copy:
        tree = copy_of_tree(copy) if "copy" in needs else ROOT
        if name == "clean":
            for made in ("build", "output"):
                (tree / made).mkdir()
        places = {"out": folder, "host": host}
        check_expected(expects, run_commands(commands, tree, places), tree, places)
        if name == "clean" and any((tree / made).exists() for made in ("build", "output")):
            raise Wrong("build/ and output/ are still there")
    return 0


def help_of(*arguments):
    return subprocess.run([ROOT / "axial", *arguments], check=True, capture_output=True, text=True).stdout


def compilers_of(verb):
    """Values of its options that name a compiler."""
    words = re.findall(r"^ +--(?:compiler|build) ([\w|.-]+)", help_of(verb, "--help", "--all"), re.MULTILINE)
    return [word for values in words for word in values.removesuffix("...").split("|") if re.search(r"gcc|clang|cortex_m4f-O2", word)]


def unreadable_options(verb):
    """Lines whose values would be read with words of their text: one blank is between them where two belong."""
    for line in help_of(verb, "--help", "--all").splitlines():
        option = re.match(r"^ {2,}(-[^ ].*?)(?: {2,}|$)", line)
        if option and any(not re.search(r"[A-Z|]", word) for word in option[1].replace(",", " ").split() if not word.startswith("-")):
            yield f"{verb} --help: {line.strip()}: two blanks belong between an option and its text"


def named_in_readme():
    return set(re.findall(r"\./axial ([a-z]+(?:-[a-z]+)*)", (ROOT / "README.md").read_text(encoding="utf-8")))


def last_verb_of(commands):
    """Programs may look at what it made."""
    return next((each for each in reversed(commands.split(" ; ")) if not each.startswith("!")), "")


def complete():
    known, table = verbs(), lines()
    covered = {name: verb_of(name, known) for name in table}
    for name, verb in covered.items():
        if verb is None:
            yield f"verbs.txt: {name} is no verb"
        elif not last_verb_of(table[name][1]).startswith(verb) and ".ci/run" not in table[name][0]:
            yield f"verbs.txt: {name} does not run {verb}"
    for verb in sorted({*known, *named_in_readme()} - {"help"}):
        if verb not in covered.values():
            yield f"the verb {verb} is run by no line of verbs.txt"
            continue
        commands = " ".join(table[name][1] for name, its in covered.items() if its == verb)
        for compiler in compilers_of(verb):
            if not re.search(rf"[ ,]{re.escape(compiler)}(?:[ ,]|$)", commands):
                yield f"verbs.txt: {verb} is not run with {compiler}"
    for verb in known:
        yield from unreadable_options(verb)
    if "axial test" not in (ROOT / ".ci/run").read_text(encoding="utf-8"):
        yield ".ci/run does not run ./axial test"


def pages():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "*.md"], check=True, capture_output=True, text=True).stdout.split()
    return [ROOT / name for name in listed if (ROOT / name).is_file()]


def shown_commands(text):
    """Commands as a reader would type them: up to a comment, without the words of prose behind a verb."""
    for match in SHOWN.finditer(text):
        words = match[1].split("#")[0].strip().rstrip(".,:").split()
        if len(words) > 1 and not words[1].startswith("-") and not re.search(r"[./]|^[A-Z]", words[1]) and words[0] != "help":
            words = words[:1]
        yield words


def parses(words):
    """What ./axial says against a command; empty where it takes it."""
    if words[0] == "help" or any(PLACEHOLDER.search(word) for word in words):
        words = words[:1]
    if words == ["help"]:
        return ""
    done = subprocess.run([ROOT / "axial", "--parse", *words], capture_output=True, text=True, check=False)
    return done.stderr.strip() if done.returncode != 0 else ""


def stale_commands():
    count = 0
    for page in pages():
        for words in shown_commands(page.read_text(encoding="utf-8")):
            count += 1
            said = "" if "--help" in words else parses(words)
            if said:
                yield f"{page.relative_to(ROOT)}: ./axial {' '.join(words)}: {said}"
    if count < 50:
        yield f"only {count} commands were found in the pages"


def report(problems):
    found = list(problems)
    print(*found, sep="\n")
    return 1 if found else 0


def main():
    action = sys.argv[1]
    try:
        return run(*sys.argv[2:]) if action == "run" else report({"complete": complete, "pages": stale_commands}[action]())
    except Wrong as wrong:
        print(wrong)
        return 1


if __name__ == "__main__":
    sys.exit(main())
