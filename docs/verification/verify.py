#!/usr/bin/env python3
"""Runs the studies of claims.json with the installed program and compares their numbers with references.

    verify.py [--quick] [--program STEMWARE] [--json FILE] [CLAIM ...]

A check passes if |value - reference| <= tolerance. The tolerance is a number in claims.json (relative if it ends in "relative"),
or the error band that the program prints. `--quick` runs the claims that take seconds. Exit code 1: a check failed.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).resolve().parent


def claims():
    return json.loads((here / "claims.json").read_text())["claims"]


def quantity(summary, path):
    """Returns a value of summary.json by its keys; "a2" is the harmonic a2 of the load over a0."""
    if path[0] in "ab" and path[1:].isdigit():
        return summary["load"][path[0]][int(path[1:])] / summary["load"]["a"][0]
    for key in path.split("/"):
        summary = summary[int(key) if isinstance(summary, list) else key]
    return summary


def band(summary, path):
    return summary["error_bands"][path.rsplit("/", 1)[-1]]["band"]


def allowed(check, summary):
    if check["tolerance"] == "band":
        return band(summary, check["quantity"])
    size, *relative = str(check["tolerance"]).split()
    return float(size) * (abs(check["reference"]) if relative else 1)


def run(program, case, folder):
    """Solves a case of a claim by `stemware run` and returns its summary.json."""
    command = [program, "run", str(here / case["study"]), "--quiet", "--threads", "1", "--output", str(folder)]
    if all(check["tolerance"] != "band" for check in case["checks"]):
        command.append("--quick")
    for entry in case.get("set", []):
        command += ["--set", entry]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0 or not (folder / "summary.json").exists():
        raise RuntimeError(f"{' '.join(command)} ended with {done.returncode}: {done.stderr.strip()}")
    return json.loads((folder / "summary.json").read_text())


def checked(program, claim, folder):
    """Yields (number, case, check, value, tolerance, passed) for every check of a claim."""
    for number, case in enumerate(claim["cases"]):
        summary = run(program, case, folder / f"{claim['name']}_{number}")
        for check in case["checks"]:
            value = quantity(summary, check["quantity"])
            if isinstance(check["reference"], str):
                yield number, case, check, value, "equal", value == check["reference"]
            else:
                tolerance = allowed(check, summary)
                is_near = isinstance(value, (int, float)) and abs(value - check["reference"]) <= tolerance
                yield number, case, check, value, tolerance, is_near


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("claims", nargs="*", metavar="CLAIM", help="names in claims.json; default: all")
    parser.add_argument("--quick", action="store_true", help="only the claims that take seconds")
    parser.add_argument("--program", default="stemware", help="default: stemware, on the path")
    parser.add_argument("--json", metavar="FILE", help="writes the values to FILE")
    options = parser.parse_args()
    chosen = [claim for claim in claims() if claim.get("cases") and (not options.claims or claim["name"] in options.claims)]
    unknown = set(options.claims) - {claim["name"] for claim in chosen}
    if unknown:
        parser.error(f"{', '.join(sorted(unknown))}: no such claim; there are {', '.join(c['name'] for c in claims() if c.get('cases'))}.")
    if options.quick:
        chosen = [claim for claim in chosen if claim.get("quick")]
    if not shutil.which(options.program):
        parser.error(f"the program {options.program} is not found; give its path with --program.")
    if options.json:  # fails before the studies run if the file cannot be written
        try:
            pathlib.Path(options.json).write_text("")
        except OSError as error:
            parser.error(f"{options.json} cannot be written ({error.strerror}); give --json another file.")
    started, n_checks, n_failed, values = time.time(), 0, 0, []
    with tempfile.TemporaryDirectory() as folder:
        for claim in chosen:
            print(f"{claim['title']} ({claim['name']})")
            try:
                for number, case, check, value, tolerance, passed in checked(options.program, claim, pathlib.Path(folder)):
                    n_checks += 1
                    n_failed += not passed
                    values.append({"claim": claim["name"], "case": number, "quantity": check["quantity"], "value": value,
                                   "tolerance": tolerance, "passed": passed})
                    shown = [f"{x:.9g}" if isinstance(x, (int, float)) else str(x) for x in (value, check["reference"])]
                    accepted = tolerance if isinstance(tolerance, str) else f"within {tolerance:.1e}"
                    print(f"  {'pass' if passed else 'FAIL'}  {check['quantity']:24} {shown[0]:>15}  {check['kind']} {shown[1]}, {accepted}"
                          f"{'  ' + '; '.join(case['set']) if case.get('set') else ''}", flush=True)
            except (OSError, RuntimeError, KeyError, TypeError, ValueError) as error:
                n_checks, n_failed = n_checks + 1, n_failed + 1
                print(f"  FAIL  {error}", flush=True)
            if options.json:
                pathlib.Path(options.json).write_text(json.dumps(values, indent=1) + "\n")
    print(f"{n_checks - n_failed} of {n_checks} checks of {len(chosen)} claims pass, {time.time() - started:.0f} s")
    return n_failed > 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit("verify.py was interrupted; the checks above stand.")
