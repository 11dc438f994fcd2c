"""Random studies in Python and in the program give the same numbers to the last bit and the same messages. Arguments: the
program, the writer of random studies, their number."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

import stemware

program, writer, number = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3]


def by_program(file):
    """Document of the program, or its message, and its exit code."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "run", file, "--quick", "--quiet", "--threads", "1", "--output", folder + "/r"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode:
            return done.stderr.splitlines()[-1].replace("stemware: ", "", 1), done.returncode
        with open(folder + "/r/summary.json", encoding="utf-8") as summary:
            return {key: value for key, value in json.load(summary).items() if key != "files"}, 0


def by_python(file):
    try:
        document = stemware.Study(file).run(quick=True).document
        return {key: value for key, value in document.items() if key != "files"}, 0
    except (stemware.BadInput, stemware.NoBalance) as failure:
        return str(failure), 1 if isinstance(failure, (stemware.BadInput, stemware.Tipping)) else 2


class RandomStudies(unittest.TestCase):
    def test_all(self):
        failed = 0
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([writer, number, "45", folder], check=True)
            for i in range(1, int(number) + 1):
                with self.subTest(i):
                    expected = by_program(f"{folder}/{i}.prm")
                    self.assertEqual(by_python(f"{folder}/{i}.prm"), expected)
                    failed += expected[1] != 0
        print(f"{number} random studies, {failed} of them without an answer")
        self.assertLess(failed, 0.1 * int(number))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
