#!/usr/bin/python3
"""Has Gappa check what the library certifies of its fixed-point kernels, and Coq check Gappa.

usage: prove.py --scripts PROGRAM --work FOLDER [options]
  --scripts PROGRAM   prove_scripts, which records the kernels
  --work FOLDER       where scripts and certificates are written
  --subject NAME      one subject; default all
  --coq               let Coq check the certificates as well
  --json FILE         an array of objects: subject, result, ours, theirs, bound, accepted, words, words_accepted, coq, seconds
  --limit SECONDS     of one run of Gappa or Coq (default: 300); beyond them a subject is not accepted
Exits 1 where something is not accepted, but for what EXPECTED names.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import time

UNPROVED = re.compile(r"^  BND\((.+?)\),? ?(best: .*)?$", re.MULTILINE)
SPLIT = re.compile(r"( \$ \w+);$", re.MULTILINE)
REWRITING = re.compile(r"^Hypothesis (a\d+) : ((?:\(\w+ <> 0\)%R -> )?\w+ = \w+)\.$", re.MULTILINE)
# By ring alone, or with constants as fractions and whatever is divided by.
IDENTITY = r"Lemma \1 : \2. Proof. first [simpl; ring | intros; unfold Float1, float2R, Defs.F2R; cbn -[IZR]; field; assumption]. Qed."
# Reals are axioms of Coq's library; nothing else may be assumed.
AXIOMS = {"Classical_Prop.classic", "ClassicalDedekindReals.sig_forall_dec", "ClassicalDedekindReals.sig_not_dec", "FunctionalExtensionality.functional_extensionality_dep"}
# What Gappa is known not to prove, of a subject or of one of its results, and why: doc/measurements/prove.md.
EXPECTED = {("scara_inverse_dynamics", "words"), ("puma560_joint3_step", "words"), ("puma560_joint3_step moment across", "errors"),
            ("puma560_inverse_dynamics", "words"), ("puma560_inverse_dynamics", "errors")}
HERE = pathlib.Path(__file__).resolve().parent


def run(command, limit, **options):
    """Status, everything said, seconds; status None where the limit was reached."""
    begin = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False, **options)
        return done.returncode, done.stdout + done.stderr, time.monotonic() - begin
    except subprocess.TimeoutExpired:
        return None, "", time.monotonic() - begin


def goals(script):
    """The goals of a script."""
    text = script.read_text(encoding="utf-8")
    return text[text.index("->") :].split("}")[0].count(" in ") if "->" in text else 0


def check(script, limit):
    """Whether Gappa accepts a script, how many of its goals, seconds."""
    wanted = goals(script)
    if wanted == 0:
        return True, 0, 0, 0.0
    status, said, seconds = run(["gappa", "-Eno-auto-dichotomy", str(script)], limit)
    if status is None:
        return False, 0, wanted, seconds
    missing = len(UNPROVED.findall(said))
    return status == 0, wanted - max(missing, 0 if status == 0 else 1), wanted, seconds


def largest_errors(script, limit):
    """What Gappa finds by itself, one number per result; None where it finds nothing."""
    status, said, _ = run(["gappa", "-Eno-auto-dichotomy", str(script)], limit)
    if status != 0:
        return []
    found = []
    for line in said[said.index("Results:") :].splitlines()[1:]:
        ends = re.findall(r"\{(-?[\d.]+(?:e[+-]?\d+)?),", line) or re.findall(r"\[(-?[\d.]+), (-?[\d.]+)\]", line)[0]
        found.append(max(abs(float(end)) for end in ends))
    return found


def certificate(script, limit):
    """Whether Coq accepts a proof of Gappa's: of one that splits a range where Gappa chooses or, since its relative errors may leave
    what Coq's lemmas hold for, of one with splits of equal width."""
    text = script.read_text(encoding="utf-8")
    splits = ("", " in 32") if SPLIT.search(text) else ("",)
    return any(accepted_by_coq(script, SPLIT.sub(rf"\1{parts};", text), limit) for parts in splits)


def accepted_by_coq(script, text, limit):
    """Whether Coq accepts Gappa's proof of a text. What Gappa takes on trust, that a rewriting is an identity, becomes a lemma."""
    proof = script.with_name(re.sub(r"\W", "_", script.stem) + ".v")
    status, said, _ = run(["gappa", "-Eno-auto-dichotomy", "-Bcoq"], limit, input=text)
    if status != 0:
        return False
    text = REWRITING.sub(IDENTITY, said[said.index("Require") :])
    text = text[: text.index("End Generated_by_Gappa.") + len("End Generated_by_Gappa.")]
    last = re.findall(r"^Lemma (\w+) :", text, re.MULTILINE)[-1]
    proof.write_text("From Coq Require Import Reals.\n" + text + f"\nPrint Assumptions {last}.\n", encoding="utf-8")
    status, said, _ = run(["coqc", proof.name], limit, cwd=proof.parent)
    assumed = set(re.findall(r"^([\w.]+)\s*:", said, re.MULTILINE)) - {"Axioms"}
    return status == 0 and assumed <= AXIOMS


def prove_part(part, folder, options):
    """The rows of one recorded program."""
    base = {kind: folder / f"{part['part']}.{kind}.g" for kind in ("errors", "words", "ask")}
    errors, _, _, seconds = check(base["errors"], options.limit)
    words, fit, wanted, more = check(base["words"], options.limit)
    found = [] if part["split"] or not errors else largest_errors(base["ask"], options.limit)
    coq = None
    if options.coq and errors:
        coq = certificate(base["errors"], options.limit) and (not words or wanted == 0 or certificate(base["words"], options.limit))
    print(f"axial: {part['part']}: {'accepted' if errors else 'NOT accepted'}, {fit} of {wanted} words, {seconds + more:.1f} s"
          + ("" if coq is None else f", Coq {'accepts' if coq else 'REFUSES'}"), flush=True)
    return [{"subject": part["subject"], "part": part["part"], "result": r["name"], "ours": r["ours"], "bound": r["bound"],
             "theirs": (found[i] if i < len(found) else r["bound"]) if errors else None, "accepted": errors,
             "words": wanted, "words_accepted": fit, "coq": coq, "seconds": round(seconds + more, 2)}
            for i, r in enumerate(part["results"])]


def unexpected(row):
    """What makes the run fail."""
    failed = []
    if not row["accepted"]:
        failed.append("errors")
    if row["words_accepted"] < row["words"]:
        failed.append("words")
    if row["coq"] is False:
        failed.append("coq")
    named = (row["subject"], f"{row['subject']} {row['result']}")
    return [kind for kind in failed if EXPECTED.isdisjoint((name, kind) for name in named)]


def approximations(folder, limit):
    """The minimax polynomials against sine and cosine, by Coq's Interval."""
    (folder / "approximation.v").write_text((HERE / "approximation.v").read_text(encoding="utf-8"), encoding="utf-8")
    status, _, seconds = run(["coqc", "approximation.v"], limit, cwd=folder)
    print(f"axial: polynomials of sine and cosine: Coq {'accepts' if status == 0 else 'REFUSES'}, {seconds:.1f} s", flush=True)
    return status == 0


def joined(rows):
    """One row per result: the arcs of sine and cosine are one, with the largest of them."""
    merged = {}
    for row in rows:
        key = (row["subject"], row["result"])
        old = merged.setdefault(key, dict(row))
        if old is not row:
            old["accepted"] &= row["accepted"]
            old["theirs"] = None if None in (old["theirs"], row["theirs"]) else max(old["theirs"], row["theirs"])
            if old["part"] != row["part"]:
                old["words"] += row["words"]
                old["words_accepted"] += row["words_accepted"]
                old["seconds"] = round(old["seconds"] + row["seconds"], 2)
                old["coq"] = None if row["coq"] is None else bool(old["coq"]) and row["coq"]
    return [{key: value for key, value in row.items() if key != "part"} for row in merged.values()]


def table(rows):
    """The rows as text."""
    shown = [["subject", "result", "ours", "theirs", "Gappa", "words", "Coq"]]
    for r in rows:
        shown.append([r["subject"], r["result"], f"{r['ours']:.3g}", "" if r["theirs"] is None else f"{r['theirs']:.3g}",
                      "accepts" if r["accepted"] else "-", f"{r['words_accepted']} of {r['words']}",
                      "" if r["coq"] is None else "accepts" if r["coq"] else "REFUSES"])
    widths = [max(len(row[i]) for row in shown) for i in range(len(shown[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in shown)


def options_of(arguments):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1], allow_abbrev=False)
    for name in ("--scripts", "--work"):
        parser.add_argument(name, required=True)
    parser.add_argument("--subject", default="")
    parser.add_argument("--coq", action="store_true")
    parser.add_argument("--json")
    parser.add_argument("--limit", type=float, default=300.0)
    return parser.parse_args(arguments)


def main():
    options = options_of(sys.argv[1:])
    folder = pathlib.Path(options.work)
    folder.mkdir(parents=True, exist_ok=True)
    if subprocess.run([options.scripts, "--output", str(folder)] + (["--subject", options.subject] if options.subject else []), check=False).returncode:
        return 1
    parts = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        rows = [row for part in pool.map(lambda p: prove_part(p, folder, options), parts) for row in part]
    polynomials = approximations(folder, options.limit) if options.coq and any(p["split"] for p in parts) else True
    failures = [(row["part"], kind) for row in rows for kind in unexpected(row)]
    rows = joined(rows)
    print(table(rows))
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=2) + "\n", encoding="utf-8")
    for part, kind in sorted(set(failures)):
        print(f"axial: {part}: {kind} not accepted", file=sys.stderr)
    return 0 if polynomials and not failures else 1


if __name__ == "__main__":
    sys.exit(main())
