"""Effect of each harmonic on tau_z against plain quadrature of the program's own load: no kernels, numpy only."""
import os
import unittest

import numpy as np

import stemware

soft_cork = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../../docs/cookbooks/soft_cork.prm")


def torque(load, n, omega, mu, speed):
    """tau_z [N m] of the load of summary.json truncated after the harmonic n, by the midpoint rule."""
    theta = (np.arange(20000) + 0.5) * 2 * np.pi / 20000
    total = 0.0
    for r, ring in zip(load["radii"], load["rings"]):
        orders = np.arange(min(n + 1, len(ring["a"])))[:, None]
        density = np.array(ring["a"])[orders[:, 0]] @ np.cos(orders * theta) + np.array(ring["b"])[
            orders[:, 0]
        ] @ np.sin(orders * theta)
        slip_x, slip_y = speed - omega * r * np.sin(theta), omega * r * np.cos(theta)
        lever = np.cos(theta) * slip_y - np.sin(theta) * slip_x
        total -= mu * r * np.mean(density * lever / np.hypot(slip_x, slip_y)) * 2 * np.pi
    return total


class EffectOfHarmonics(unittest.TestCase):
    def compare(self, summary, load, omega, state, mu=0.3, speed=0.35):
        at_rest = abs(torque(summary["load"], 1, 0.0, mu, speed))
        first, whole = (torque(load, n, omega, mu, speed) for n in (1, 1000))
        orders = [row["harmonics"] for row in summary["truncation"]]
        self.assertEqual(orders[:5], [1, 2, 3, 4, 6])
        for row in summary["truncation"]:
            cut = torque(load, row["harmonics"], omega, mu, speed)
            # 1e-10 of the torque at rest: rounding of 20000 terms and of the printed load.
            self.assertAlmostEqual(row["torque_change"][state], cut - first, delta=1e-10 * at_rest)
            self.assertAlmostEqual(row["torque_rest"][state], whole - cut, delta=1e-10 * at_rest)
            self.assertAlmostEqual(
                row["torque_change"][state + "_relative"], (cut - first) / at_rest, delta=1e-9
            )
        self.assertGreater(abs(whole - first), 1e-3 * at_rest)

    def test_at_the_terminal_spin(self):
        summary = stemware.Study().run(quick=True).document
        self.compare(summary, summary["load_at_terminal"], summary["ring"]["omega_terminal"], "terminal")

    def test_at_half_the_terminal_spin(self):  # one-way, so that the load at rest is the load at every spin
        summary = stemware.Study(entries={"Load/Coupling": "one-way"}).run(quick=True).document
        self.compare(summary, summary["load"], summary["ring"]["omega_terminal"] / 2, "half")

    def test_the_largest_over_all_spins(self):  # one-way; 1e-10 of the torque at rest: as above
        study = stemware.Study(entries={"Load/Coupling": "one-way"})
        summary = study.run(quick=True).document
        load, found = summary["load"], summary["truncation"][-1]["torque_change"]

        def change(omega):
            return torque(load, 1000, omega, 0.3, 0.35) - torque(load, 1, omega, 0.3, 0.35)

        rounding = 1e-10 * abs(torque(load, 1, 0.0, 0.3, 0.35))
        self.assertAlmostEqual(found["largest"], change(found["largest_at"]), delta=rounding)
        for omega in np.linspace(0, summary["ring"]["omega_terminal"], 12):
            self.assertLess(abs(change(omega)), abs(found["largest"]) + rounding)
        self.assertAlmostEqual(study.answer()["torque_change_largest"], found["largest"], delta=rounding)

    def test_the_largest_of_run_and_of_a_case_agree(self):  # 1e-6: tolerance of the interpolated load
        study = stemware.Study(soft_cork)
        run, case = study.run(quick=True).document, study.answer()
        at_rest = abs(run["ring"]["tau_at_rest"])
        largest = run["truncation"][-1]["torque_change"]["largest"]
        self.assertAlmostEqual(case["torque_change_largest"], largest, delta=1e-6 * at_rest)
        self.assertGreater(abs(largest), 1e-3 * at_rest)


def ring_torque(spin, centre=0.08, mu=0.3, hand=0.03, mass=0.3, radius=0.03, speed=0.35, orbit=0.15):
    """tau_z [N m] of a rigid ring with a first harmonic in full balance: midpoint rule, moments by fixed-point iteration."""
    theta, normal = 2 * np.pi * (np.arange(720) + 0.5) / 720, 9.81 * mass
    x, y = np.cos(theta), np.sin(theta)
    u, w = speed - spin * radius * y, spin * radius * x
    tx, ty = -mu * normal, 0.0
    for _ in range(100):
        moment_x = (hand - centre) * mass * speed**2 / orbit - hand * ty
        share = mu * (normal + 2 / radius * (moment_x * y - hand * tx * x)) / 720 / np.hypot(u, w)
        tx, ty = -np.sum(share * u), -np.sum(share * w)
    return -radius * np.sum(share * (x * w - y * u))


def ring_spin(grip=0.0, **changed):
    """Zero of tau_z + grip for a clockwise spin [rad/s], by bisection."""
    fast, slow = -8.0, -1e-3
    for _ in range(50):
        middle = (fast + slow) / 2
        fast, slow = (fast, middle) if ring_torque(middle, **changed) + grip < 0 else (middle, slow)
    return slow


class EffectOfInputs(unittest.TestCase):
    def test_on_the_rigid_ring(self):
        found = {row["name"]: row["difference"] for row in stemware.Study().run().document["inputs"]}
        expected = {
            "1 cm more height of the centre of mass": ring_spin(centre=0.09) - ring_spin(),
            "0.05 more friction": ring_spin(mu=0.35) - ring_spin(),
            "1.4 mN m more grip": ring_spin(grip=1.4e-3) - ring_spin(),
        }
        self.assertEqual(found.keys(), expected.keys())
        for name, difference in expected.items():  # 1e-8 rad/s: the search for the terminal spin stops at 1e-9 of it
            self.assertAlmostEqual(found[name], difference, delta=1e-8, msg=name)


if __name__ == "__main__":
    unittest.main()
