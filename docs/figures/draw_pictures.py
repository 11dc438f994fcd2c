#!/usr/bin/env python3
"""Draws the pictures of docs/studies.txt from the reports of its studies.

    draw_pictures.py RESULTS_FOLDER        the folder that tests/docs/numbers_test.py wrote, build/release/docs/results
"""
import pathlib
import sys

source = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(source / "tests/docs"))
import numbers_test  # noqa: E402

for line in numbers_test.lines_of(source)[1]:
    _, study, picture, file = line.split()
    (source / file).write_text(numbers_test.draw(pathlib.Path(sys.argv[1]).resolve(), study, picture))
