"""Runs the examples of docs/python, and compares what pages say that they print. Given: the sources, names to be run (all)."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

source = os.path.abspath(sys.argv[1])
names = sys.argv[2:]
pages = ["docs/python.md", "docs/cookbooks/slide.md"]
arguments = {"monte_carlo": ["24"]}  # studies


class Examples(unittest.TestCase):
    def test_all(self):
        folder = os.path.join(source, "docs/python")
        shown = {}
        for page in pages:
            with open(os.path.join(source, page), encoding="utf-8") as file:
                for name, block in re.findall(r"`docs/python/(\w+)\.py` prints\n\n((?:    .*\n)+)", file.read()):
                    shown.setdefault(name, []).extend((page, line[4:]) for line in block.splitlines())
        for name in sorted(name[:-3] for name in os.listdir(folder) if name.endswith(".py")):
            if names and name not in names:
                continue
            with self.subTest(name), tempfile.TemporaryDirectory() as results:
                picture = os.path.join(results, "picture.svg")
                done = subprocess.run([sys.executable, os.path.join(folder, name + ".py"), picture, *arguments.get(name, [])],
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=results)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertGreater(os.path.getsize(picture), 1000)
                for page, line in shown.get(name, []):
                    self.assertIn(line, done.stdout.splitlines(), f"{page} shows another line than docs/python/{name}.py prints")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
