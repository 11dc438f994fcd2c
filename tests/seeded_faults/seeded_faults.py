#!/usr/bin/env python3
"""Builds Stemware with one small fault at a time and runs the tests that must catch it.

    seeded_faults.py --check                       every fault of faults.txt, random.txt and stiff_motion.txt fits the source; builds nothing
    seeded_faults.py --random SEED N               draws N faults by operators (random.txt: --random 48 100); --folder: where
    seeded_faults.py --run [FILE] [--first N] [--last N] [--folder ring_model] [--build FOLDER]
                                               [--without-solid] [--jobs N]

--run copies the source to FOLDER (default: a temporary one) and configures it there, once, file by file instead of unity, so
that a fault costs one compilation and a link. Each test program must pass before a fault is in place. With a fault in place
the test program of the fault's folder is built and runs the named test; if this test passes, all its tests without `long`
run up to the first failure. Rows: caught by a test, not built (the compiler refuses the fault), SURVIVED; a program that
takes three times as long as without a fault, and a minute more, has failed. 200 faults take about a night on two cores;
--folder ring_model needs neither deal.II nor MPI. Exit code 1: a fault survived or does not fit.
"""
import argparse
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).resolve().parent
source = here.parent.parent
operators = [(r"\+\+", "--"), (r"--", "++"), (r"<=", "<"), (r"(?<=\s)<(?=\s)", "<="), (r"(?<=\s)\+(?=\s)", "-"),
             (r"(?<=\s)-(?=\s)", "+"), (r"std::sin\(", "std::cos("), (r"std::cos\(", "std::sin("), (r"\[n\]", "[n - 1]"),
             (r"\[i\]", "[i + 1]"), (r"(?<=\s)\*(?=\s)", "+"), (r"\b2\.(?=\s)", "3."), (r"&&", "||"), (r">=", ">")]


def read(file):
    faults = []
    for line in (here / file).read_text().splitlines():
        if line and not line.startswith("#"):
            faults.append([text.replace("\\n", "\n") for text in line.split("\t")])
    return faults


def with_fault(fault):
    """The text of the fault's file with the fault; a text that does not stand there once is an error."""
    text = (source / fault[0]).read_text()
    if text.count(fault[2]) != 1:
        raise ValueError(f"{fault[0]}: \"{fault[2]}\" stands {text.count(fault[2])} times; mend the list of faults")
    return text.replace(fault[2], fault[3])


def draw(seed, count, below):
    """Random faults, as lines of a list: an operator on a drawn line that has it and stands once in its file."""
    numbers = random.Random(seed)
    files = sorted(str(f.relative_to(source)) for folder in ("ring_model", "fem/contact") for f in (source / folder).rglob("*.cc"))
    files = [file for file in files if file.startswith(below)]
    found = set()
    while len(found) < count:
        file = numbers.choice(files)
        lines = (source / file).read_text().splitlines()
        line = numbers.choice(lines)
        pattern, new = numbers.choice(operators)
        places = list(re.finditer(pattern, line))
        if not places or lines.count(line) != 1 or line.lstrip().startswith(("//", "#", "*", "/*")) or '"' in line:
            continue
        place = numbers.choice(places)
        changed = line[:place.start()] + new + line[place.end():]
        if (source / file).read_text().count(line) == 1 and "\t" not in line:
            found.add("\t".join((file, "-", line, changed)))
    return sorted(found)


class Build:
    def __init__(self, folder, options):
        self.source, self.build, self.jobs, self.limits = folder / "source", folder / "build", options.jobs, {}
        if not self.source.exists():
            subprocess.run(["git", "clone", "--quiet", "--shared", str(source), str(self.source)], check=True)
        if not (self.build / "build.ninja").exists():
            chosen = ["-D", "CMAKE_BUILD_TYPE=Release", "-D", "STEMWARE_UNITY=OFF", "-D", "CMAKE_CXX_FLAGS=-O1"]
            chosen += ["-D", "STEMWARE_FEM=OFF"] if options.folder.startswith("ring_model") else []
            chosen += ["-D", "STEMWARE_SOLID=OFF"] if options.without_solid else []
            subprocess.run(["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, *chosen], check=True, stdout=subprocess.DEVNULL)

    def programs(self, file):
        return ["ring_tests"] if file.startswith("ring_model/") else ["revolution_tests", "fem_tests", "verification_tests"]

    def make(self, program):
        return subprocess.run(["ninja", "-C", self.build, f"-j{self.jobs}", program], capture_output=True).returncode == 0

    def failure(self, program, test, limit):
        """The first test of the program that fails, "" if all pass; with "-" each that is not long runs."""
        long = [line.split()[0] for line in (source / "tests" / "costs.txt").read_text().splitlines() if line.endswith(" long")]
        chosen = f"{test}:*/{test}*" if test != "-" else "*-" + ":".join(name if "." in name else name + ".*" for name in long)
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        path = next(p for p in self.build.rglob(program) if p.is_file())
        try:
            done = subprocess.run([path, f"--gtest_filter={chosen}", "--gtest_brief=1", "--gtest_fail_fast"], capture_output=True,
                                  text=True, errors="replace", env=environment, timeout=limit)
        except subprocess.TimeoutExpired:
            return f"more than {limit:.0f} s"
        failed = re.search(r"FAILED  \] (\S+?),? ", done.stdout)
        return "" if done.returncode == 0 else failed[1] if failed else "the program ended"

    def check(self, program):
        """Builds the program without a fault: all tests must pass, and a fault may take three times as long."""
        begin = time.monotonic()
        if not self.make(program):
            raise RuntimeError(f"{program} cannot be built without a fault")
        built = time.monotonic()
        failed = self.failure(program, "-", 7200)
        if failed:
            raise RuntimeError(f"{failed} of {program} fails without a fault")
        self.limits[program] = 60 + 3 * (time.monotonic() - built)
        print(f"{program} without a fault: built in {built - begin:.0f} s, passes in {time.monotonic() - built:.0f} s", flush=True)

    def outcome(self, fault):
        target, programs = self.source / fault[0], self.programs(fault[0])
        for program in programs:
            if program not in self.limits:
                self.check(program)
        original = target.read_text()
        try:
            target.write_text(with_fault(fault))
            for test in dict.fromkeys((fault[1], "-")):
                for program in programs:
                    if not self.make(program):
                        return "not built"
                    failed = self.failure(program, test, self.limits[program])
                    if failed:
                        return f"caught by {failed}"
            return "SURVIVED"
        finally:
            target.write_text(original)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--random", nargs=2, type=int, metavar=("SEED", "N"))
    parser.add_argument("--run", nargs="?", const="faults.txt", metavar="FILE")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--last", type=int, default=10**6)
    parser.add_argument("--folder", default="", help="only faults of files below it")
    parser.add_argument("--build", type=pathlib.Path, help="folder of source and build, kept")
    parser.add_argument("--without-solid", action="store_true", help="builds and runs no test of the solid body")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of one build")
    options = parser.parse_args()
    if options.random:
        print("\n".join(draw(*options.random, options.folder)))
        return 0
    if options.check:
        troubles = []
        lists = [file for file in ("faults.txt", "random.txt", "stiff_motion.txt") if (here / file).exists()]
        faults = [fault for file in lists for fault in read(file)]
        tests = {".".join(pair) for file in (source / "tests").rglob("*_test.cc")
                 for pair in re.findall(r"TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", file.read_text())}
        for fault in faults:
            try:
                with_fault(fault)
            except (OSError, ValueError) as error:
                troubles.append(str(error))
            if fault[1] != "-" and fault[1] not in tests:
                troubles.append(f"{fault[0]}: there is no test {fault[1]}")
        print("\n".join(troubles) or f"{len(faults)} faults fit the source.")
        return len(troubles) > 0
    if not options.run:
        parser.error("say --check, --random or --run")
    survivors = 0
    with tempfile.TemporaryDirectory() as temporary:
        build = None
        for number, fault in enumerate(read(options.run), 1):
            if options.first <= number <= options.last and fault[0].startswith(options.folder):
                build = build or Build((options.build or pathlib.Path(temporary)).resolve(), options)
                outcome = build.outcome(fault)
                survivors += outcome == "SURVIVED"
                print(f"{number:4} {outcome:50} {fault[0]}: {fault[2].strip()!r} -> {fault[3].strip()!r}", flush=True)
    print(f"{survivors} survived.")
    return survivors > 0


if __name__ == "__main__":
    sys.exit(main())
