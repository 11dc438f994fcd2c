"""Command line, page and Python give the same digits, messages, presets and units. Arguments: the program, the solver of the
page."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import stemware

program, page = (os.path.abspath(one) for one in sys.argv[1:3])

STUDIES = ({}, {"Motion/Friction coefficient": "0.2"}, {"Motion/Orbit speed": "25 cm/s"}, {"Motion/Force offset": "-30 mm"},
           {"Motion/Mass": "200 g", "Motion/Closure": "hand"}, {"Motion/Orbit sense": "clockwise"}, {"Motion/Tilt": "neglected"},
           {"Motion/Grip torque": "1 mN m"}, {"Motion/Friction law": "Stribeck"}, {"Load/Coupling": "one-way", "Contact/Rings": "3"})
REFUSED = ({"Motion/Mass": "30 cm"}, {"Motion/Mas": "1"}, {"Motion/Mass": "-1"}, {"Motion/Closure": "open"}, {"Contact/Rings": "1.5"},
           {"Motion/Friction coefficient": "-0.1"}, {"Load/Moment ratio": "many"}, {"Motion/Orbit sense": "left"},
           {"Motion/Centre of mass height": "0.2", "Motion/Force offset": "0.15"}, {"Motion/Orbit speed": "2.5"},
           {"Motion/Centre of mass height": "0.5", "Motion/Mass": "3"})


def words(entries, *before):
    return [word for key, value in entries.items() for word in (*before, f"{key}={value}")]


def output(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def by_program(entries):
    with tempfile.TemporaryDirectory() as folder:
        return output(program, "run", "--quick", "--quiet", "--json", "--threads", "1", "--output", folder + "/r", *words(entries, "--set"))


def by_page(entries):
    return json.loads(output(page, *words(entries)).stdout)


class Faces(unittest.TestCase):
    def test_digits(self):
        for entries in STUDIES:
            with self.subTest(entries):
                done = by_program(entries)
                self.assertEqual(done.returncode, 0, done.stderr)
                shown = json.loads(done.stdout)
                python = stemware.Study(entries=entries).run(quick=True)
                self.assertEqual((python.omega, python["ring/tau_at_rest"]), (shown["omega_terminal"], shown["tau_at_rest"]))
                answer = by_page(entries)
                self.assertEqual((answer.get("error"), answer.get("fit")), (None, "same"))
                # A cold start of the page gives the contacts of the program; only the search steps differ.
                ring = answer["document"]["summary"]["ring"]
                self.assertLess(abs(ring["omega_terminal"] - python.omega), 1e-10)
                self.assertLess(abs(ring["tau_at_rest"] - python["ring/tau_at_rest"]), 1e-13)

    def test_messages_are_equal(self):
        for entries in REFUSED:
            with self.subTest(entries):
                done = by_program(entries)
                self.assertNotEqual(done.returncode, 0)
                sentence = re.sub("^(stemware|--set): ", "", re.sub("^stemware: ", "", done.stderr.splitlines()[-1]))
                with self.assertRaises((stemware.BadInput, stemware.NoBalance)) as caught:
                    stemware.Study(entries=entries).run(quick=True)
                self.assertEqual(str(caught.exception), sentence)
                # The program first prints its warnings on values unusual for a glass.
                self.assertRegex(sentence.rstrip("."), re.escape(by_page(entries)["error"].rstrip(".")) + "$")

    def test_presets(self):
        presets = stemware.presets()
        help_text = output(program, "new", "--help").stdout
        for kind, title in (("glass", "Glasses"), ("table", "Tables")):
            listed = re.findall(r"^  (\S+(?: \S+)*)  ", help_text.split(title + ":\n")[1].split("\n\n")[0], re.M)
            self.assertEqual(list(presets["name"][presets["kind"] == kind]), listed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
