#!/usr/bin/env python3
"""Runs the studies of docs/studies.txt and compares the numbers in README.md and docs/ with their results.

    numbers_test.py STEMWARE SOURCE_FOLDER RESULTS_FOLDER

A row of docs/numbers.csv: a page; a text that occurs once in the page, with {} for the number and {*} for any other number; a
study; a Python expression of the keys of its summary.json; a printf format. An element of a list has its index or its name. In
an expression, case("Mass=0.3, Orbit speed=0.25") is the row of sweep.csv with these values, study("paper") another study.

A line "draw STUDY PICTURE FILE" of docs/studies.txt: the picture of the study's report shows the data of the file
(docs/figures/draw_pictures.py draws the files).
"""
import concurrent.futures
import csv
import json
import math
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import types

NUMBER = r"[−+]?\d[\d.]*(?:e[−+]?\d+)?"


class Rows(list):
    """List whose elements are found by index, "name" or "step"."""

    def __getitem__(self, key):
        if isinstance(key, str):
            return next(row for row in self if key in (getattr(row, "name", None), getattr(row, "step", None)))
        return super().__getitem__(key)


def keys_of(pairs):
    return types.SimpleNamespace(**{key: Rows(value) if isinstance(value, list) else value for key, value in pairs})


def same(cell, wanted):
    try:
        return math.isclose(float(cell), float(wanted), rel_tol=1e-9)
    except ValueError:
        return cell == wanted


def sweep_case(table, conditions):
    """Returns the row of sweep.csv with the values "Entry=value, Entry=value"; entry names omit the unit of the column."""
    with open(table, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    entries = {heading.split(" (")[0].rsplit("/", 1)[-1]: heading for heading in rows[0]}
    for condition in conditions.split(", "):
        entry, value = condition.split("=")
        rows = [row for row in rows if same(row[entries[entry]], value)]
    if len(rows) != 1:
        raise LookupError(f"{len(rows)} rows of {table} have {conditions}")
    return types.SimpleNamespace(**{name: float(rows[0][heading]) for name, heading in entries.items()
                                    if re.fullmatch(r"[-+.\de]+", rows[0][heading])})


class Results:
    def __init__(self, folder):
        self.folder, self.known = folder, {}

    def study(self, name):
        if name not in self.known:
            text = (self.folder / name / "summary.json").read_text()
            summary = json.loads(text, object_pairs_hook=keys_of)
            summary.case = lambda conditions: sweep_case(self.folder / name / "sweep.csv", conditions)
            self.known[name] = summary
        return self.known[name]

    def value(self, study, expression):
        names = vars(self.study(study)) if study else {}
        return float(eval(expression, {"study": self.study, **names}))


def shows(shown, expected, value):
    """True if @p shown is the value rounded to the printed digits; a tie may round either way on another processor."""
    if shown == expected:
        return True
    digits, _, exponent = shown.replace("−", "-").partition("e")
    last = 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))
    return len(shown) == len(expected) and abs(float(f"{digits}e{exponent or 0}") - value) <= 0.55 * last


def pattern(text):
    marks = {"{}": f"({NUMBER})", "{*}": NUMBER}
    return "".join(marks.get(part, re.escape(part)) for part in re.split(r"(\{\*?\})", text))


def run(program, source, folder, name, command):
    shutil.rmtree(folder / name, ignore_errors=True)  # a sweep of another build of the program cannot be continued
    done = subprocess.run([program, *shlex.split(command)[1:], "--quiet", "--output", folder / name], cwd=source,
                          capture_output=True, text=True)
    return [] if done.returncode == 0 else [f"{name} ended with {done.returncode}: {done.stderr.strip()}"]


def wrong_numbers(source, results):
    pages, troubles = {}, []
    with open(source / "docs/numbers.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        page = pages.setdefault(row["page"], " ".join((source / row["page"]).read_text().split()))
        found = re.findall(pattern(row["text"]), page)
        where = f"{row['page']}, \"{row['text']}\""
        if len(found) != 1:
            troubles.append(f"{where} stands {len(found)} times in the page")
            continue
        value = results.value(row["study"], row["expression"])
        expected = (row["format"] % value).replace("-", "−")
        if not shows(found[0], expected, value):
            troubles.append(f"{where} has {found[0]}; {row['study']} gives {expected} ({row['expression']})")
    return rows, troubles


def heights(svg):
    """Heights of the marks of a picture [px]: end points of lines, circles, bars. Widths depend on the fonts of the machine."""
    marks = re.findall(r'[ML]-?[0-9.]+[ ,](-?[0-9.]+)|V(-?[0-9.]+)|(?:cy|height)="([0-9.]+)"', svg)
    return [float(number) for mark in marks for number in mark if number]


def draw(folder, study, picture):
    """Returns the SVG of a picture in a study's report, drawn by Chromium."""
    profile = folder / f"chromium-{study}-{picture}"
    done = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom", f"--user-data-dir={profile}",
                           f"file://{(folder / study / 'report.html').resolve()}#svg={picture}"], capture_output=True, text=True)
    shutil.rmtree(profile, ignore_errors=True)
    svg = re.search(r"<svg .*</svg>", done.stdout, re.DOTALL)
    if not svg:
        raise RuntimeError(f"Chromium does not draw {picture} of {study}: {done.stderr[-500:]}")
    return svg[0] + "\n"


def wrong_picture(source, folder, line):
    _, study, picture, file = line.split()
    before, now = heights((source / file).read_text()), heights(draw(folder, study, picture))
    tolerance = 0.5  # px of some 220 px between the frame's lower and upper side
    same_data = before and len(before) == len(now) and all(abs(a - b) <= tolerance for a, b in zip(before, now))
    return [] if same_data else [f"{file} shows other data than the report of {study}"]


def lines_of(source):
    lines = (source / "docs/studies.txt").read_text().splitlines()
    return ({line.split(":")[0]: line.split(":", 1)[1].strip() for line in lines if re.match(r"\w+: *stemware ", line)},
            [line for line in lines if line.startswith("draw ")])


def main(program, source, folder):
    source, folder = pathlib.Path(source).resolve(), pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    commands, pictures = lines_of(source)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        troubles = sum(pool.map(lambda study: run(program, source, folder, *study), commands.items()), [])
        if not troubles:
            rows, troubles = wrong_numbers(source, Results(folder))
            troubles += sum(pool.map(lambda line: wrong_picture(source, folder, line), pictures), [])
            print(f"{len(rows)} numbers, {len(pictures)} pictures, {len(troubles)} wrong")
    print("\n".join(troubles))
    return 1 if troubles else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
