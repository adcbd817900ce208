#!/usr/bin/python3
"""Measures every page, table and picture at one commit, part by part, or tells at which commit each page is.

usage: ./axial release --pages | --measure [--only REGEX]
"""
import argparse
import json
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STATE = ROOT / "build/release/state.json"
COMMIT = re.compile(r"(?<!Before: )[Cc]ommit `?([0-9a-f]{7,40}(?:-dirty)?)\b")
LINE_EVERY = 60  # seconds between lines of progress


def parts():
    """(command, seconds that it may take, pages)."""
    for line in (HERE / "parts.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            command, minutes, pages = (field.strip() for field in line.split("|"))
            yield command, 60 * int(minutes), pages.split()


def commit_now():
    return subprocess.run([ROOT / "host_sim/tools/system/commit.sh"], check=True, capture_output=True, text=True).stdout.strip()


def commits_of(page):
    return sorted(set(COMMIT.findall((ROOT / page).read_text(encoding="utf-8"))))


def show_pages():
    """Exit status 1 where the pages are not all at one commit."""
    pages = sorted({page for _, _, named in parts() for page in named})
    shown = {page: commits_of(page) for page in pages}
    for page, commits in shown.items():
        print(f"{page:40} {' '.join(commits) or '-'}")
    found = {commit for commits in shown.values() for commit in commits}
    print(f"{len(pages)} pages, {len(found)} commits")
    return 0 if len(found) == 1 else 1


def stop(process):
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def measure(command, seconds, log):
    """Seconds that it took, or None where it failed or was not ready in time."""
    begin = shown = time.monotonic()
    with log.open("w", encoding="utf-8") as out:
        process = subprocess.Popen(shlex.split(command), cwd=ROOT, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        while process.poll() is None:
            time.sleep(0.2)
            now = time.monotonic()
            if now - begin > seconds:
                stop(process)
                print(f"axial: {command}: not ready in {seconds // 60} min; its output is in {log}", file=sys.stderr)
                return None
            if now - shown > LINE_EVERY:
                shown = now
                print(f"axial: {command} ... {now - begin:.0f} s", flush=True)
    if process.returncode:
        print(f"axial: {command}: exit status {process.returncode}; its output is in {log}", file=sys.stderr)
        return None
    return time.monotonic() - begin


def measure_all(only):
    """Every part that this commit has not, in order; what is measured stays measured when it is stopped."""
    commit = commit_now()
    wanted = [part for part in parts() if re.search(only, part[0])]
    if wanted and commit.endswith("-dirty"):
        print("axial: sources differ from the commit; commit them first", file=sys.stderr)
        return 2
    STATE.parent.mkdir(parents=True, exist_ok=True)
    state = json.loads(STATE.read_text(encoding="utf-8")) if STATE.exists() else {}
    done = state.get(commit, {})
    failed = 0
    for at, (command, seconds, _) in enumerate(wanted, 1):
        if command in done:
            print(f"axial: {at} of {len(wanted)}: {command}: measured already, in {done[command]:.0f} s")
            continue
        print(f"axial: {at} of {len(wanted)}: {command}, at most {seconds // 60} min", flush=True)
        took = measure(command, seconds, STATE.parent / f"{at:02}.log")
        failed += took is None
        if took is not None:
            done[command] = took
            STATE.write_text(json.dumps({commit: done}, indent=1) + "\n", encoding="utf-8")
    print(f"axial: {len(wanted) - failed} of {len(wanted)} parts are measured at {commit}; ./axial release --pages shows the pages")
    return 1 if failed else 0


def main(arguments):
    parser = argparse.ArgumentParser(prog="./axial release", description=__doc__.split("\n")[0], allow_abbrev=False)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--pages", action="store_true")
    what.add_argument("--measure", action="store_true")
    parser.add_argument("--only", default="", metavar="REGEX")
    options = parser.parse_args(arguments)
    return show_pages() if options.pages else measure_all(options.only)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
