"""stemware.fit against synthetic runs of another integrator, and the recipes of docs/measure.md. Arguments: the sources, and the
number of runs for the coverage of the intervals."""
import os
import re
import sys
import tempfile
import unittest
import warnings

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

import stemware

source, n_runs = os.path.abspath(sys.argv[1]), int(sys.argv[2])
friction, grip, height = "Motion/Friction coefficient", "Motion/Grip torque", "Motion/Force offset"


class Truth:
    """Rigid ring with a first harmonic, moment balance full: Coulomb friction by the midpoint rule round the ring, moments by fixed-point
    iteration, spin-up by scipy."""
    mass, inertia, centre, radius, gravity, speed, orbit = 0.3, 3e-4, 0.08, 0.03, 9.81, 0.35, 0.15

    def __init__(self, mu=0.3, grip=2e-4, offset=-0.05):
        self.mu, self.grip, self.offset = mu, grip, offset
        spins = np.linspace(-8, 0.5, 120)
        torque = CubicSpline(spins, [self.torque(one) for one in spins])
        held = abs(torque(0)) <= grip

        def rate(_, state):
            free = torque(state[1])
            return state[1], 0 if held else (free - grip * np.sign(state[1] or free)) / self.inertia
        self.motion = solve_ivp(rate, (0, 6), (0, 0), rtol=1e-10, atol=1e-12, dense_output=True, max_step=0.02).sol

    def torque(self, spin):
        theta = 2 * np.pi * (np.arange(180) + 0.5) / 180
        x, y, normal = np.cos(theta), np.sin(theta), self.mass * self.gravity
        u, w = self.speed - spin * self.radius * y, spin * self.radius * x
        tx, ty = -self.mu * normal, 0.0
        for _ in range(200):
            mx = self.offset * (self.mass * self.speed**2 / self.orbit - ty) - self.centre * ty
            my = (self.offset + self.centre) * tx
            share = self.mu * (normal + 2 / self.radius * (mx * y - my * x)) / 180 / np.hypot(u, w)
            before, (tx, ty) = (tx, ty), (-np.sum(share * u), -np.sum(share * w))
            if abs(before[0] - tx) + abs(before[1] - ty) < 1e-14:
                return -self.radius * np.sum(share * (x * w - y * u))
        raise ArithmeticError("no balance")

    def at(self, time):
        """Spin and yaw angle; sliding starts at time 0."""
        angle, spin = self.motion(np.clip(time, 0, 6))
        return np.where(time > 0, spin, 0), np.where(time > 0, angle, 0)


def study(**entries):
    return stemware.Study(entries={"Load/Source": "first harmonic", friction: 0.27, grip: 5e-4, **entries})


def fitted(*arguments, **named):
    """Fits and checks that the issued warnings equal the warnings of the result."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = stemware.fit(*arguments, **named)
    assert [str(one.message) for one in caught] == found.warnings, (caught, found.warnings)
    return found


def film(seed, noise=0.05, **truth):
    """150 samples of the spin; the glass starts to slide at 0.2 s."""
    time = np.linspace(0, 1.5, 150)
    return time, Truth(**truth).at(time - 0.2)[0] + np.random.default_rng(seed).normal(0, noise, time.size)


class Intervals(unittest.TestCase):
    def test_intervals_have_the_stated_coverage(self):
        random, missed = np.random.default_rng(20261128), []
        for k in range(n_runs):
            truth = Truth(random.uniform(0.2, 0.35), random.uniform(2e-4, 1e-3))
            time = np.sort(random.uniform(0, 1, int(random.uniform(60, 300)))) * random.uniform(0.9, 1.6)
            spin, angle = truth.at(time - random.uniform(0.05, 0.3))
            noise = random.uniform(0.02, 0.1)
            if k % 2:
                run = {"angle": angle + random.normal(0, 0.2 * noise, time.size)}
            else:
                run = {"omega": spin + random.normal(0, 0.01) + random.normal(0, noise, time.size)}
            sigma = (0.2 * noise if k % 2 else noise) if k % 3 else None
            found = fitted(study(), time + 1.7e9, free=[friction, grip], sigma=sigma, **run)
            for path, value in ((friction, truth.mu), (grip, truth.grip)):
                missed.append(abs(found.values[path] - value) / found.standard_errors[path])
        share = {level: np.mean(np.array(missed) < reach) for level, reach in ((0.68, 0.9945), (0.95, 1.96))}
        print(f"{n_runs} runs, {len(missed)} truths: {100 * share[0.68]:.0f} % in 68 %, {100 * share[0.95]:.0f} % in 95 %")
        # The two parameters of a run count once: the correlation of their errors is 0.99.
        margin = 3 * np.sqrt(0.68 * 0.32 / n_runs) if n_runs < 60 else 0
        self.assertTrue(0.55 - margin <= share[0.68] <= 0.80 + margin, share)
        self.assertTrue(0.88 - margin <= share[0.95], share)


class Fits(unittest.TestCase):
    def test_parameters_are_recovered_without_noise(self):
        truth, time = Truth(mu=0.3, grip=2e-4), np.linspace(0, 1.2, 120)
        spin, angle = truth.at(time - 0.1)
        for run in ({"omega": spin + 0.02}, {"angle": angle - 3}):
            found = fitted(study(), time, free=[friction, grip], sigma=1e-3, zero=(0, 0.1) if "omega" in run else None, **run)
            self.assertAlmostEqual(found.values[friction], 0.3, delta=1e-5)
            self.assertAlmostEqual(found.values[grip], 2e-4, delta=2e-7)
            self.assertAlmostEqual(found.values["start"], 0.1, delta=1e-5)
            self.assertAlmostEqual(found.values["zero"], 0.02 if "omega" in run else -3, delta=1e-5)
            self.assertEqual(found.study[friction], found.values[friction])
            self.assertLess(found.reduced_chi2, 1e-3)

    def test_known_parameters_are_held_or_widen_the_interval(self):
        time, spin = film(1)
        held = fitted(study(), time, spin, [friction], start=0.2, zero=0.0)
        self.assertEqual(held.names, [friction])
        known = fitted(study(), time, spin, {friction: None, height: (-0.05, 1e-3)}, start=0.2, zero=0)
        loose = fitted(study(), time, spin, {friction: None, height: (-0.05, 2e-3)}, start=0.2, zero=0)
        self.assertLess(held.standard_errors[friction], known.standard_errors[friction])
        self.assertLess(known.standard_errors[friction], loose.standard_errors[friction])

    def test_two_hands_separate_friction_and_grip(self):
        (time, low), (_, high) = film(2), film(3, offset=-0.02)
        alone = fitted(study(), time, low, [friction, grip], zero=0, start=0.2)
        self.assertGreater(alone.correlation[0, 1], 0.98)
        self.assertRegex(alone.warnings[0], f"{friction} and {grip} are known together only")
        both = fitted([study(), study(**{height: -0.02})], [time, time], [low, high], [friction, grip], zero=0, start=0.2)
        self.assertLess(both.standard_errors[grip], alone.standard_errors[grip] / 2)
        self.assertEqual(len(both.runs), 2)
        self.assertIn("start of run 2", fitted([study()] * 2, [time, time], [low, low], [friction]).names)

    def test_a_stated_sigma_is_used_and_larger_noise_warns(self):
        time, spin = film(4)
        for sigma, chi in ((0.05, 1), (0.025, 4)):
            self.assertAlmostEqual(fitted(study(), time, spin, [friction], sigma=sigma).reduced_chi2, chi, delta=0.35 * chi)

    def test_missing_values_are_skipped(self):
        time, spin = film(5)
        gaps = np.insert(spin, 50, np.nan)
        found = fitted(study(), np.insert(time, 50, time[50] - 1e-3), gaps, [friction])
        self.assertEqual(found.values, fitted(study(), time, np.ma.masked_invalid(spin), [friction]).values)

    def test_the_plot_has_curves_and_residuals(self):
        import matplotlib
        matplotlib.use("svg")
        upper, lower = fitted(study(), *film(6), [friction]).plot()
        self.assertEqual([len(axes.lines) for axes in (upper, lower)], [2, 1])


class Warnings(unittest.TestCase):
    """A model that misses the data gives a warning; a good run gives none."""

    def words(self, time, spin, **named):
        return "\n".join(fitted(study(), time, spin, [friction], **named).warnings)

    def test_a_good_run(self):
        self.assertEqual(self.words(*film(7)), "")

    def test_degrees_for_radians(self):
        time, spin = film(8)
        self.assertIn("omega = numpy.radians(omega)", self.words(time, np.degrees(spin)))
        self.assertIn("over a tenth of the largest value", self.words(time, np.degrees(spin)))
        angle = np.degrees(Truth().at(time - 0.2)[1])
        self.assertIn("angle = numpy.radians(angle)", self.words(time, None, angle=angle))

    def test_outliers(self):
        time, spin = film(9)
        spin[[40, 90, 91]] += (3, -2, 2.5)
        self.assertIn("points beyond 5 sigma: [40, 90, 91];", self.words(time, spin))

    def test_a_drift(self):
        time, spin = film(10)
        self.assertIn("the residuals have a trend", self.words(time, spin + 0.5 * time))

    def test_the_other_way(self):
        time, spin = film(11)
        self.assertIn("turns the other way", self.words(time, -spin))


class Refusals(unittest.TestCase):
    def test_each_warning_names_a_remedy(self):
        time, spin = film(12)
        angle = Truth().at(time - 0.2)[1]
        slow = np.linspace(0, 20, 40)
        for cure, run in (("the clock began anew: fit one recording, time[75:]", (np.tile(time[:75], 2), spin)),
                          ("numpy.unique(time", (np.repeat(time[::2], 2), spin)),
                          ("time = 1e-9 * time for nanoseconds", (1e9 * time, spin)),
                          ("angle = numpy.unwrap(angle)", (time, None, (3 * angle + np.pi) % (2 * np.pi))),
                          ("angle = numpy.unwrap(numpy.radians(angle))", (time, None, np.degrees(3 * angle) % 360)),
                          ("count turns on", (slow, None, np.radians((214 * slow / slow[1] + 180) % 360 - 180))),
                          ("measure at least 5", (time[:4], spin[:4])),
                          ("two columns of the same length", (time, spin[1:])),
                          ("give omega or angle", (time, spin, angle))):
            with self.subTest(cure):
                with self.assertRaises(stemware.BadInput) as caught:
                    stemware.fit(study(), *run[:2], [friction], angle=(run + (None,))[2])
                self.assertIn(cure, str(caught.exception))
        for words, named in (("see study.entries()", {"free": ["Motion/Friktion"]}), ("no entry is free", {"free": []}),
                             ("leave it out of free", {"free": ["Glass/Young modulus"]}),
                             ("no value", {"free": [friction], "start": "soon"})):
            with self.subTest(words), self.assertRaisesRegex(stemware.BadInput, re.escape(words)):
                stemware.fit(study(), time, spin, **named)


class SpinUp(unittest.TestCase):
    def test_curve_of_another_integrator(self):
        time = np.linspace(0, 2, 41)
        given = stemware.Study(entries={"Load/Source": "first harmonic", grip: 2e-4})
        for found, true in zip(given.spin_up(time), Truth().at(time)):
            self.assertLess(np.max(np.abs(found - true)), 1e-7)

    def test_curve_of_run(self):
        given = stemware.Study(entries={"Motion/Grip torque": 3e-4})
        curve = given.run(quick=True).curves["spin_up"]
        for found, key in zip(given.spin_up(curve["time"]), ("omega", "yaw_angle")):
            self.assertLess(np.max(np.abs(found - curve[key])), 1e-7)
        with self.assertRaisesRegex(stemware.BadInput, "rise from 0"):
            given.spin_up([0, 0.2, 0.1])


class Measure(unittest.TestCase):
    """The recipes of docs/measure.md find the friction of the glass from files in each program's format."""

    def test_recipes(self):
        truth, random = Truth(), np.random.default_rng(3)
        time = np.linspace(0, 3, 301)
        spin, angle = truth.at(time - 0.5)
        spin, angle = spin + random.normal(0, 0.03, time.size), angle + random.normal(0, 0.01, time.size)
        comma = lambda *row: ";".join(f"{one:.6g}" for one in row).replace(".", ",")
        wrapped = (np.degrees(angle) + 180) % 360 - 180
        files = {
            "phyphox.csv": ['"Time (s)";"Gyroscope x (rad/s)";"Gyroscope y (rad/s)";"Gyroscope z (rad/s)";"Absolute (rad/s)"',
                            *(comma(t, 0.01, -0.02, w, abs(w)) for t, w in zip(time, spin))],
            "tracker.txt": ["dot\t\t", "t\tx\tθr", "0.000E0\t1.0E-1\t",
                            *(f"{t:.6E}\t9.9E-2\t{a:.4f}" for t, a in zip(time[1:], wrapped[1:]))],
            "vernier.csv": ["Latest: Time (s),Latest: Angular Velocity (rad/s)", *(f"{t:.4f},{w:.5f}" for t, w in zip(time, spin))],
            "capstone.csv": ['"Time (s) Run #1";"Angle (rad) Run #1"', *(comma(t, a) for t, a in zip(time, angle))],
            "sensor_logger.csv": ["time,seconds_elapsed,z,y,x",
                                  *(f"{1767620467000000000 + int(1e9 * t)},{t},{w},0.01,0.02" for t, w in zip(time, spin))]}
        with open(os.path.join(source, "docs/measure.md"), encoding="utf-8") as page:
            blocks = re.findall(r"```python\n(.*?)```", page.read(), re.S)
        self.assertEqual(len(blocks), 5)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for name, lines in files.items():
                    with open(name, "w", encoding="utf-8") as file:
                        file.write("\n".join([*lines, ""]))
                with open("my_glass.prm", "w", encoding="utf-8") as file:
                    file.write(study().prm())
                for block in blocks:
                    names = {}
                    with self.subTest(block), warnings.catch_warnings():
                        warnings.simplefilter("ignore")
                        import matplotlib
                        matplotlib.use("svg")
                        exec("\n".join((blocks[0], block)), names)  # the first block has the imports
                        found = names["found"]
                        self.assertAlmostEqual(found.values[friction], 0.3, delta=max(4 * found.standard_errors[friction], 0.003))
            finally:
                os.chdir(before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
