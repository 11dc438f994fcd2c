"""stemware.Study and the program give the same digits and messages. Arguments: the program, the sources."""
import concurrent.futures
import doctest
import json
import os
import pickle
import resource
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import stemware
from stemware import ring

from interruption import is_stopped

program, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
cookbook = os.path.join(source, "docs/cookbooks/{}.prm").format


def stemware_run(*arguments):
    return subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def summary_of(verb, *arguments):
    """Document that the program writes, without the entries that depend on its folder."""
    with tempfile.TemporaryDirectory() as folder:
        done = stemware_run(verb, *arguments, "--threads", "1", "--quiet", "--output", folder + "/r")
        if done.returncode:
            raise AssertionError(done.stderr)
        with open(folder + "/r/summary.json", encoding="utf-8") as file:
            return without_folder(json.load(file))


def without_folder(document):
    return {key: value for key, value in document.items() if key not in ("files", "parameters")}


# A contact ten times cheaper than the default one.
few_lines = {"Contact/Azimuth lines": 64, "Contact/Harmonics": 8}


class SameDigits(unittest.TestCase):
    def test_quick_studies(self):  # random_test.py has many more
        for name in ("", "figure_3", "stribeck", "own_profile", "hand_speed"):
            with self.subTest(name or "default"):
                expected = summary_of("run", *([cookbook(name)] if name else []), "--quick")
                found = stemware.Study(cookbook(name) if name else "").run(quick=True)
                self.assertEqual(without_folder(found.document), expected)

    def test_a_whole_study_and_other_verbs(self):
        entries = {"Motion/Mass": "250 g", "Motion/Grip torque": "1 mN m"}
        sets = [word for key, value in entries.items() for word in ("--set", f"{key}={value}")]
        study = stemware.Study(entries=entries)
        result = study.run()
        self.assertEqual(without_folder(result.document), summary_of("run", *sets))
        self.assertEqual(without_folder(study.truncate().document), summary_of("truncate", *sets))
        self.assertEqual(without_folder(study.converge(levels=2).document), summary_of("converge", *sets, "--levels", "2"))
        table = result.table("budget")
        self.assertEqual(table.attrs["units"]["omega_terminal"], "rad/s")
        self.assertEqual(len(table), len(result.budget))
        self.assertIn("<table>", result._repr_html_())
        self.assertGreater(result.bands().loc["omega_terminal", "band"], 0)

    def test_a_case_equals_the_case_of_sweep(self):
        with tempfile.TemporaryDirectory() as folder:
            done = stemware_run("sweep", "--vary", "Motion/Mass=250,300 g", "--threads", "1", "--quiet", "--output", folder + "/s")
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(folder + "/s/summary.json", encoding="utf-8") as file:
                document = json.load(file)
            with open(folder + "/s/sweep.csv", encoding="utf-8") as file:
                rows = file.read()
        found = stemware.solve([{"Motion/Mass": "250 g"}, {"Motion/Mass": 0.3}])
        for omega in found["omega_terminal"]:
            self.assertIn(repr(float(omega))[:12], rows + json.dumps(document))
        for executor in (concurrent.futures.ThreadPoolExecutor(2), concurrent.futures.ProcessPoolExecutor(2)):
            with executor:
                other = stemware.solve([{"Motion/Mass": "250 g"}, {"Motion/Mass": 0.3}], executor=executor)
            self.assertTrue(found.equals(other))
        units = found.attrs["units"]
        self.assertEqual([units[key] for key in ("omega_terminal", "omega_first_harmonic", "normal_force", "mean_load", "ring_radius")],
                         ["rad/s", "rad/s", "N", "N/rad", "m"])
        numbers = [key for key in found if found[key].dtype.kind == "f"]
        self.assertEqual([key for key in numbers if not units[key]], [])
        chosen = stemware.solve([{}], quantities=["ring/omega_terminal", "load/moment_ratio"])
        self.assertEqual([chosen.attrs["units"][key] for key in ("ring/omega_terminal", "load/moment_ratio")], ["rad/s", "1"])

    def test_one_glass_as_file_text_and_preset(self):
        study = stemware.Study(glass="tumbler", table="oak")
        text = stemware.Study(text=study.prm())
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + "/glass.prm", "w", encoding="utf-8") as file:
                file.write(study.prm())
            of_file = stemware.Study(folder + "/glass.prm")
        self.assertEqual(text.prm(), study.prm())
        self.assertEqual(of_file.prm(), study.prm())
        self.assertEqual(pickle.loads(pickle.dumps(study)).prm(), study.prm())
        self.assertEqual(text.answer(), study.answer())


    solid = {"Motion/Tilt": "neglected", "Glass/Shape": "step", "Contact/Friction coupling": "none", "Load/Coupling": "one-way",
             "Table/Interface": "Winkler", "Table/Substrate": "rigid",
             "Contact/Body": "solid", "Contact/Degree": 1, "Contact/Azimuthal cells": 16, "Contact/Radial cells": 2,
             "Contact/Foot layers": 1}

    def test_a_solid_foot(self):  # a separate process, because it starts MPI
        code = f"import stemware, json\nprint(json.dumps(stemware.Study(entries={self.solid!r}).run(quick=True).document))"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        if "STEMWARE_SOLID" in done.stderr:
            self.skipTest("no solid feet")
        self.assertEqual(done.returncode, 0, done.stderr)
        sets = [word for key, value in self.solid.items() for word in ("--set", f"{key}={value}")]
        self.assertEqual(without_folder(json.loads(done.stdout)), summary_of("run", "--quick", *sets))

    def test_the_thread_counts_of_the_process_do_not_change(self):
        code = """
import ctypes, numpy, stemware
gomp, blas = ctypes.CDLL("libgomp.so.1"), ctypes.CDLL("libblas.so.3")
def counts():
    return gomp.omp_get_max_threads(), gomp.omp_get_max_active_levels(), blas.openblas_get_num_threads()
gomp.omp_set_num_threads(3)
gomp.omp_set_max_active_levels(2)
blas.openblas_set_num_threads(2)
before = counts()
stemware.Study().answer()
assert counts() == before, (before, counts())
"""
        subprocess.run([sys.executable, "-c", code], check=True)

    def test_several_ranks_are_refused(self):
        os.environ["OMPI_COMM_WORLD_SIZE"] = "2"
        try:
            with self.assertRaisesRegex(stemware.BadInput, "mpirun stemware run"):
                stemware.Study(entries=self.solid).answer()
        finally:
            del os.environ["OMPI_COMM_WORLD_SIZE"]


class TerminalSpin(unittest.TestCase):
    def test_friction_lean_and_grip_add_up_to_zero(self):
        """Only the moment balance full has a tilt and so a lean torque. Reference: friction by quadrature over the rings."""
        theta = np.arange(1024) * 2 * np.pi / 1024
        for closure in ("paper", "hand", "full"):
            with self.subTest(closure):
                grip = 2e-4
                result = stemware.Study(entries={"Motion/Closure": closure, "Motion/Grip torque": grip,
                                                 "Motion/Centre of mass height": 0.07, **few_lines}).run(quick=True)
                load, omega, torque = result.load_at_terminal, result.omega, 0.0
                for r, one in zip(load["radii"], load["rings"]):
                    n = np.arange(len(one["a"]))[:, None]
                    density = one["a"] @ np.cos(n * theta) + one["b"] @ np.sin(n * theta)
                    slip_x, slip_y = 0.35 - omega * r * np.sin(theta), omega * r * np.cos(theta)
                    torque += 0.3 * r * (density * (np.sin(theta) * slip_x - np.cos(theta) * slip_y)
                                         / np.hypot(slip_x, slip_y)).mean() * 2 * np.pi
                lean = result["ring/lean_torque_at_terminal"]
                self.assertEqual(lean != 0, closure == "full")
                self.assertAlmostEqual(torque + lean - grip * np.sign(omega), 0, delta=1e-10)


class SameSentences(unittest.TestCase):
    def test_refusals_equal_the_refusals_of_the_program(self):
        for entries, code in (
            ({"Motion/Mass": "30 cm"}, 1), ({"Motion/Mas": "1"}, 1), ({"Motion/Mass": "-1"}, 1), ({"Motion/Closure": "open"}, 1),
            ({"Table/Kind": "mat"}, 1), ({"Load/Source": "given", "Load/Moment ratio": "2.5"}, 1),
            ({"Motion/Centre of mass height": "0.5", "Motion/Force offset": "0.4"}, None), ({"Contact/Rings": "1.5"}, 1),
            ({"Load/Source": "file", "Load/File": "missing.csv"}, 1), ({"Table/Interface": "rigid"}, 1), ({"Motion/Orbit speed": "35"}, None),
        ):
            with self.subTest(entries):
                done = stemware_run("run", "--quick", "--output", tempfile.mkdtemp() + "/r",
                                    *[word for key, value in entries.items() for word in ("--set", f"{key}={value}")])
                if code is not None:
                    self.assertEqual(done.returncode, code, done.stderr)
                self.assertNotEqual(done.returncode, 0)
                with self.assertRaises((stemware.BadInput, stemware.NoBalance)) as caught:
                    stemware.Study(entries=entries).run(quick=True)
                self.assertEqual(done.stderr.splitlines()[-1].replace("stemware: ", "", 1).replace("--set: ", "", 1), str(caught.exception))
                self.assertEqual(isinstance(caught.exception, (stemware.BadInput, stemware.Tipping)), done.returncode == 1)

    def test_a_file_that_is_missing(self):
        done = stemware_run("run", "missing.prm")
        with self.assertRaises(stemware.BadInput) as caught:
            stemware.Study("missing.prm")
        self.assertEqual(done.stderr.strip(), f"stemware: {caught.exception}")

    def test_entries_are_refused_one_by_one_and_together(self):
        study = stemware.Study()
        with self.assertRaises(stemware.BadInput):
            study["Motion/Mass"] = "30 cm"
        with self.assertRaises(stemware.BadInput):
            study["Motion/Mass"] = True
        study["Load/Source"] = "file"
        with self.assertRaises(stemware.BadInput):
            study.check()
        with self.assertRaises(stemware.BadInput):
            stemware.Study("a.prm", text="# b")
        with self.assertRaisesRegex(ring.BadInput, "is empty"):
            stemware.Study(text="")

    def test_a_failed_case_gives_a_row(self):
        found = stemware.solve([{"Motion/Mass": "30 cm"}, {}])
        self.assertIn("length", found["failure"][0])
        self.assertEqual(found["failure"][1], "")

    def test_exceptions_of_a_listener_propagate(self):
        def listener(what, done, every):
            raise LookupError(what)
        with self.assertRaises(LookupError):
            stemware.Study().run(progress=listener)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.heard = []
        cls.result = stemware.Study().run(quick=True, progress=lambda *what: cls.heard.append(what))

    def test_progress(self):
        self.assertIn(("ring", 1, 1), self.heard)

    def test_curves_belong_to_the_answer(self):
        torque = self.result.curves["torque"]
        at = np.interp(self.result.omega, torque["omega"], torque["sum"])
        self.assertLess(abs(at), 1e-3 * np.abs(torque["sum"]).max())
        self.assertAlmostEqual(self.result.curves["spin_up"]["omega"][0], 0)

    def test_the_frozen_load_has_the_torque_of_the_study(self):
        load = self.result.load()
        motion = ring.Motion(**{key: self.result[f"parameters/Motion/{name}"] for key, name in (
            ("mass", "Mass"), ("yaw_inertia", "Yaw inertia"), ("orbit_speed", "Orbit speed"), ("friction_coefficient", "Friction coefficient"))})
        torque = self.result.curves["torque"]
        rest = np.interp(0, torque["omega"], torque["sum"])
        self.assertAlmostEqual(ring.answer(load, motion).torque_at_rest / rest, 1, delta=1e-6)
        terminal = ring.wrench(self.result.load("terminal"), motion.orbit_speed, self.result.omega, mu=motion.friction_coefficient).torque
        self.assertLess(abs(float(terminal) + self.result.load("terminal").lean_torque), 1e-9)

    def test_the_pressure_on_its_grid_carries_the_weight(self):
        p = self.result.curves["pressure"]
        self.assertEqual(p["p"].shape, (p["theta"].size, p["r"].shape[1]))
        widths = np.trapz(p["p"] * p["r"], p["r"], axis=1)
        force = widths.mean() * 2 * np.pi
        self.assertAlmostEqual(force / 2.943, 1, delta=0.01)
        moment = (np.trapz(p["p"] * p["r"]**2, p["r"], axis=1) * np.sin(p["theta"])).mean() * 2 * np.pi
        self.assertAlmostEqual(moment / self.result.load().moment[0], 1, delta=0.02)

    def test_texts_contain_the_numbers(self):
        self.assertIn("-3.59", repr(self.result))
        self.assertNotIn("e-16", self.result._repr_html_())
        with self.assertRaisesRegex(stemware.BadInput, "without quick"):
            self.result.bands()

    def test_folder_and_page(self):
        with tempfile.TemporaryDirectory() as folder:
            self.result.save(folder + "/results")
            found = stemware.read(folder + "/results")
            self.assertEqual(without_folder(found.document), without_folder(self.result.document))
            for at in ("rest", "terminal"):
                self.assertAlmostEqual(found.load(at).lean_torque / self.result["ring/lean_torque_at_" + at], 1, delta=1e-12)
            self.result.page(folder + "/page.html")
            with open(folder + "/page.html", encoding="utf-8") as file:
                self.assertIn("</html>", file.read())

    def test_figures(self):
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        from stemware import figures
        for draw in (figures.pressure, figures.load, figures.torque, figures.spin_up):
            self.assertTrue(draw(self.result).has_data())
        self.assertTrue(figures.limit_surface(ring.limit_surface(ring.Pressure.disc(0.03))).has_data())
        plt.close("all")

    def test_examples_of_the_docstrings(self):
        from stemware import study
        self.assertEqual(doctest.testmod(study).failed, 0)

    def test_presets(self):
        self.assertEqual(set(stemware.presets()["kind"]), {"glass", "table"})
        self.assertIn("Motion/Mass", stemware.Study().entries().index)


class Manners(unittest.TestCase):
    def test_memory_does_not_grow(self):
        def resident():
            with open("/proc/self/status") as file:
                return next(int(line.split()[1]) for line in file if line.startswith("VmRSS")) / 1024
        study = stemware.Study(entries=few_lines)
        for _ in range(3):
            study.run(quick=True)
        begin = resident()
        for _ in range(20):
            study.run(quick=True)
        print(f"memory: {begin:.0f} MB after 3 runs, {resident():.0f} MB after 23")
        self.assertLess(resident(), begin + 10)

    def test_memory_of_different_feet_is_bounded(self):
        code = ("import stemware\nstemware.limit_cache(1)\ndef resident():\n"
                "    return next(int(line.split()[1]) for line in open('/proc/self/status') if line.startswith('VmRSS')) / 1024\n"
                f"for i in range(61):\n    stemware.Study(entries={{'Motion/Mass': 0.2 + i / 500, **{few_lines!r}}}).answer()\n"
                "    if i % 60 == 0: print(resident())\n")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        if "STEMWARE_SOLID" in done.stderr:
            self.skipTest("no solid feet")
        self.assertEqual(done.returncode, 0, done.stderr)
        first, last = (float(line) for line in done.stdout.split())
        print(f"memory: {first:.0f} MB after the first answer, {last:.0f} MB after 60 more, each with a foot of its own")
        self.assertLess(last, first + 10)

    def test_a_warm_start_takes_fewer_steps_to_the_same_answer(self):
        start, cold, warm = stemware.Start(), [], []
        for mass in (0.28, 0.29, 0.3):
            study = stemware.Study(entries={"Motion/Mass": mass})
            cold.append(study.answer())
            warm.append(study.answer(start=start))
        self.assertEqual(cold[0], warm[0])
        for one, other in zip(cold[1:], warm[1:]):
            self.assertAlmostEqual(one["omega_terminal"], other["omega_terminal"], delta=1e-11)
            self.assertLess(other["contact_iterations"], one["contact_iterations"])

    def test_a_warm_start_of_a_whole_run_has_the_same_answer(self):
        start = stemware.Start()
        stemware.Study(entries={"Motion/Mass": 0.29, **few_lines}).answer(start=start)
        study = stemware.Study(entries=few_lines)
        cold, warm = study.run(), study.run(start=start)
        self.assertLess(warm["contact/iterations"], cold["contact/iterations"])
        self.assertAlmostEqual(warm.omega, cold.omega, delta=1e-11)
        self.assertAlmostEqual(warm["load/moment_ratio"], cold["load/moment_ratio"], delta=1e-11)
        for one, other in zip(cold.budget, warm.budget):
            self.assertAlmostEqual(one["omega_terminal"], other["omega_terminal"], delta=1e-10)
        bands = [result.bands().loc["omega_terminal", "band"] for result in (cold, warm)]
        self.assertAlmostEqual(bands[1] / bands[0], 1, delta=1e-3)

    def test_interruption(self):
        slow = {"Table/Interface": "hard", "Table/Substrate": "elastic", "Contact/Refinements": 2, "Contact/Harmonics": 64}
        for entries, loop in (({}, "while True: study.run()"), ({}, "while True: study.run(threads=2)"), (slow, "study.answer()")):
            setup = f"import stemware\nstemware.Study().answer()\nstudy = stemware.Study(entries={entries!r})"
            for wait in (1, 3):
                self.assertTrue(is_stopped(setup, loop, wait), (loop, wait))

    def test_the_package_shows_its_names(self):
        import pydoc
        text = pydoc.plain(pydoc.render_doc(stemware))
        for name in ("Study", "solve", "read"):
            self.assertIn(name, dir(stemware))
            self.assertIn(name, text)
        self.assertRegex(stemware.__version__, r"^\d+\.\d+\.\d+")
        study = stemware.Study()
        self.assertIn("Motion/Mass", list(study))
        self.assertEqual(study.keys(), list(study.entries().index))
        with self.assertRaisesRegex(TypeError, "one Start in each process"):
            pickle.dumps(stemware.Start())

    def test_nothing_is_printed_and_no_mpi(self):
        code = ("import ctypes, re, stemware\nstemware.Study().run(quick=True)\nmaps = open('/proc/self/maps').read()\n"
                "assert 'libdeal' in maps\nmpi = ctypes.CDLL(re.search(r'/\\S*/libmpi\\.so\\S*', maps)[0])\n"
                "flag = ctypes.c_int()\nmpi.MPI_Initialized(ctypes.byref(flag))\nassert not flag.value\n")
        done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
