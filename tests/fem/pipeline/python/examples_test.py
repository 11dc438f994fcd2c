"""Runs the examples of docs/python and compares their output with the pages. Arguments: sources, names of examples (all)."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

source = os.path.abspath(sys.argv[1])
names = sys.argv[2:]
pages = ["docs/python.md"]
arguments = {"monte_carlo": ["24"]}  # studies


def run(name, *arguments, launcher=(sys.executable,)):
    """Lines that an example prints. Checks that it draws its picture and prints no warning."""
    with tempfile.TemporaryDirectory() as results:
        picture = os.path.join(results, "picture.svg")
        done = subprocess.run([*launcher, os.path.join(source, "docs/python", name + ".py"), picture, *arguments],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=results, timeout=600)
        assert done.returncode == 0 and done.stderr == "", (name, arguments, done.returncode, done.stderr)
        assert os.path.getsize(picture) > 1000
        return done.stdout.splitlines()


class Examples(unittest.TestCase):
    def test_all(self):
        shown = {}
        for page in pages:
            with open(os.path.join(source, page), encoding="utf-8") as file:
                for name, block in re.findall(r"`docs/python/(\w+)\.py` prints\n\n((?:    .*\n)+)", file.read()):
                    shown.setdefault(name, []).extend((page, line[4:]) for line in block.splitlines())
        for name in sorted(name[:-3] for name in os.listdir(os.path.join(source, "docs/python")) if name.endswith(".py")):
            if names and name not in names:
                continue
            with self.subTest(name):
                printed = run(name, *arguments.get(name, []))
                for page, line in shown.get(name, []):
                    self.assertIn(line, printed, f"{page} shows another line than docs/python/{name}.py prints")


@unittest.skipIf(names, "no studies without the finite elements")
class Executors(unittest.TestCase):
    """Each engine for many studies gives the same numbers and messages as one process."""

    @classmethod
    def setUpClass(cls):
        cls.alone = run("executors")

    def test_threads_and_processes(self):
        for kind in ("threads", "processes"):
            self.assertEqual(run("executors", kind), self.alone)

    def test_dask(self):
        self.assertEqual(run("executors", "dask"), self.alone)

    def test_mpi(self):
        ranks = (os.path.join(source, "tests/mpirun"), "-n", "3", sys.executable, "-m", "mpi4py.futures")
        self.assertEqual(run("executors", "mpi", launcher=ranks), self.alone)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
