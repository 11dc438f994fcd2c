"""Effect of each harmonic on tau_z against plain quadrature of the program's own load: no kernels, numpy only."""
import unittest

import numpy as np

import stemware


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


if __name__ == "__main__":
    unittest.main()
