#!/usr/bin/env python3
"""Writes the pages of docs/verification and their figures from claims.json; numbers of Stemware come from `verify.py --json`.

    pages.py [RESULTS.json]           takes the numbers of RESULTS.json into claims.json and writes the pages
    pages.py --check [RESULTS.json]   exit code 1 if a page, a figure, a number or the name of a test has drifted
"""
import json
import math
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # leaves the source folder unchanged
import figures  # noqa: E402

here = pathlib.Path(__file__).resolve().parent
kinds = {
    "closed form": "a formula evaluated by the test, or an identity (a derivative against finite differences); no code of Stemware",
    "published": "numbers of a publication; no code of Stemware",
    "other code": "another program, CalculiX or numpy and scipy; no code of Stemware. If a program is named with its path, you can run it to get its numbers; "
                  "of the other programs, only the numbers are kept",
    "plain quadrature": "the defining integral, evaluated numerically; no code of Stemware",
    "other body": "Stemware's other body: the elasticity shares no code; contact driver, interface laws and extraction of the load are the same code, "
                  "so the comparison would not find an error in this code",
}


def shown(value, tolerance):
    """Returns the value as text with one digit beyond its tolerance."""
    if isinstance(value, str):
        return value
    if abs(value) < tolerance:
        return "0"
    return f"{value:.{min(12, max(2, math.ceil(math.log10(abs(value) / tolerance)) + 1))}g}"


def tolerance_of(check):
    if check["tolerance"] == "band":
        return check["band"]
    size, *relative = str(check["tolerance"]).split()
    return 0 if size == "equal" else float(size) * (abs(check["reference"]) if relative else 1)


def page(claim):
    lines = [f"# {claim['title']}", "", "<!-- This page is written by `docs/verification/pages.py` from `claims.json`. -->", "", "## The problem", ""]
    lines += [f"- {sentence}" for sentence in claim["problem"]]
    lines += ["", "## The reference", "", claim["reference"], "", "## The numbers", ""]
    lines += ["| settings | quantity | reference | kind | Stemware | accepted within |", "|---|---|---|---|---|---|"]
    for case in claim["cases"]:
        settings = "; ".join(entry.split("/", 1)[1].replace("=", " = ") for entry in case.get("set", [])) or case["study"]
        for check in case["checks"]:
            tolerance = tolerance_of(check)
            accepted = {"band": f"the stated band, {tolerance:.1e}", "equal": "equal"}.get(check["tolerance"], check["tolerance"])
            lines.append(f"| {settings} | `{check['quantity']}` | {shown(check['reference'], tolerance)} | {check['kind']} | "
                         f"{shown(check['stemware'], tolerance)} | {accepted} |")
            settings = ""
    if drawing := figure(claim):
        lines += ["", f"![{drawing[0]}](figures/{claim['name']}.svg)"]
    lines += ["", "Harmonics are divided by a₀. The other quantities are [keys](../summary.md) of `summary.json`, in SI units.", "", "*Tolerance.* " + claim["why"], "",
              f"    python3 /usr/share/stemware/verification/verify.py {claim['name']}"]
    if claim.get("tests"):
        lines += ["", "Tests: " + ", ".join(f"`{test}`" for test in claim["tests"]) + "."]
    return "\n".join(lines) + "\n"


def figure(claim):
    """Returns description and SVG text of a claim's figure; None without numbers to draw."""
    if claim["name"] == "annular_punch":
        return "Harmonics 2 to 6 of three widths, reference and Stemware with its band", figures.harmonics(claim)
    drawn = figures.deviations(claim, tolerance_of)
    return drawn and ("Differences from the references over the accepted differences", drawn)


def kinds_of(claim):
    found = {check["kind"] for case in claim.get("cases", []) for check in case["checks"]} | {claim.get("kind")}
    return [kind for kind in kinds if kind in found]


def index(claims):
    run, tested = [c for c in claims if c.get("cases")], [c for c in claims if not c.get("cases")]
    n_checks = sum(len(case["checks"]) for c in run for case in c["cases"])
    lines = ["# What are Stemware's numbers checked against?", "",
             f"Each of the {len(claims)} claims below has one or more references. [Five kinds](#kinds-of-references) of references differ in the code that they share with Stemware. "
             f"You can run the studies of {len(run)} claims; {n_checks} numbers are compared with their references:", "",
             "    python3 /usr/share/stemware/verification/verify.py --quick", "",
             "`verify.py` prints each number, its reference, the accepted difference and `pass` or `FAIL`. "
             "`--quick` runs only the studies marked in the column *quick*. "
             "Studies, references (`claims.json`) and `verify.py` are in `share/stemware/verification`.", "",
             "| claim | kind of reference | numbers | quick |", "|---|---|---|---|"]
    for c in run:
        lines.append(f"| [{c['title']}]({c['name']}.md) | {', '.join(kinds_of(c))} | {sum(len(case['checks']) for case in c['cases'])} "
                     f"| {'yes' if c.get('quick') else ''} |")
    lines += ["", "[CB-glass](benchmark.md) is a benchmark for other codes.", "",
              "Filon's receding contact (an elastic layer on a base without bond) is not compared, "
              "because the layers of Stemware are bonded to their base.", "", "The claims below are checked by the tests of the source, not by a study:", "", "| claim | kind of reference | test |", "|---|---|---|"]
    lines += [f"| {c['title']}{': ' + c['agreement'] if 'agreement' in c else ''} | {c['kind']} | {', '.join(f'`{test}`' for test in c['tests'])} |"
              for c in tested]
    lines += ["", "## Kinds of references", "", "A claim with references of several kinds is counted in the row of each of these kinds:", "", "| kind | reference | claims |", "|---|---|---|"]
    lines += [f"| {kind} | {meaning} | {sum(kind in kinds_of(c) for c in claims)} |" for kind, meaning in kinds.items()]
    lines += ["", "Numbers that only protect against unintended changes are not listed.", ""]
    return "\n".join(lines)


def benchmark():
    """Returns the text of benchmark.md with the targets of tests/verification/cb_glass.json."""
    states = json.loads((here.parent.parent / "tests" / "verification" / "cb_glass.json").read_text())["states"]
    rows = [(f"{name}{n}/a₀", [f"{x[f'{name[0]}_over_a0'][n]:.6f}" for x in states], "2e-4")
            for n in range(1, 7) for name in ("a" if n % 2 == 0 else "b",)]
    rows += [("share of loaded azimuths", [f"{x['share_of_azimuths']:.4f}" for x in states], "0.005"),
             ("largest pressure (Pa)", [f"{x['peak_pressure']:.6g}" for x in states], "0.5 %"),
             ("torque at ω = 0 (N m)", [f"{x['tau_at_rest']:.6g}" for x in states], "exact"),
             ("terminal spin (rad/s)", [f"{x['terminal_spin']:.4f}" for x in states], "5e-4")]
    table = ["| quantity | " + " | ".join(f"m = {x['moment_ratio']}" for x in states) + " | band |", "|---" * 5 + "|"]
    table += [f"| {name} | {' | '.join(values)} | {band} |" for name, values, band in rows]
    text = (here / "benchmark.md").read_text()
    return re.sub(r"<!-- targets -->.*?<!-- end -->", "<!-- targets -->\n" + "\n".join(table) + "\n<!-- end -->", text, flags=re.S)


def missing_tests(claims):
    text = "\n".join(file.read_text() for file in (here.parent.parent / "tests").rglob("*_test.cc"))
    defined = {".".join(pair) for pair in re.findall(r"TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", text)}
    return [test for c in claims for test in c.get("tests", []) if test not in defined]


def main():
    arguments = sys.argv[1:]
    only_check = "--check" in arguments
    files = [argument for argument in arguments if argument != "--check"]
    source = here / "claims.json"
    claims = json.loads(source.read_text())["claims"]
    checks = {(c["name"], i, check["quantity"]): check for c in claims for i, case in enumerate(c.get("cases", [])) for check in case["checks"]}
    troubles = [f"claims.json: {key[0]} has a reference of no known kind" for key, check in checks.items() if check["kind"] not in kinds]
    troubles += [f"claims.json: there is no test {test}" for test in missing_tests(claims)]
    for result in json.loads(pathlib.Path(files[0]).read_text()) if files else []:
        check = checks[result["claim"], result["case"], result["quantity"]]
        if not only_check:
            check["stemware"] = result["value"]
            if check["tolerance"] == "band":
                check["band"] = result["tolerance"]
        elif isinstance(result["value"], str) or abs(result["value"] - check["stemware"]) > tolerance_of(check) / 2:
            if result["value"] != check["stemware"]:
                troubles.append(f"{result['claim']}: {result['quantity']} is {result['value']} now, {check['stemware']} on the page")
    if not only_check:
        source.write_text(json.dumps({"claims": claims}, indent=1) + "\n")
    pages = {"index.md": index(claims), "benchmark.md": benchmark(), **{f"{c['name']}.md": page(c) for c in claims if c.get("cases")}}
    pages |= {f"figures/{c['name']}.svg": figure(c)[1] for c in claims if c.get("cases") and figure(c)}
    for name, text in pages.items():
        if not only_check:
            (here / name).write_text(text)
        elif not (here / name).exists() or (here / name).read_text() != text:
            troubles.append(f"docs/verification/{name} is not what pages.py writes; run it and commit the file")
    print("\n".join(troubles) or f"{len(pages)} pages and figures agree with claims.json.")
    return len(troubles) > 0


if __name__ == "__main__":
    sys.exit(main())
