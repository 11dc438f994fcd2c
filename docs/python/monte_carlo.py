"""Uncertain inputs: terminal spin of a glass whose mass, centre of mass and friction are known with an error, and the share of
each error in the variance of the spin (Sobol indices).

    python3 docs/python/monte_carlo.py monte_carlo.svg [NUMBER OF STUDIES]
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pandas
from scipy.stats import norm, qmc

import stemware
from stemware import ring

known = {"Motion/Mass": (0.30, 0.005), "Motion/Centre of mass height": (0.08, 0.004), "Motion/Friction coefficient": (0.30, 0.03)}
labels = ["mass ± 5 g", "centre of mass ± 4 mm", "μ ± 0.03"]


def sample(n, seed):
    x = qmc.LatinHypercube(len(known), seed=seed).random(n)
    return pandas.DataFrame({key: norm.ppf(x[:, i], *known[key]) for i, key in enumerate(known)})


def shares(x, y):
    """Returns first-order Sobol indices Var E[y | x_i] / Var y, estimated from the covariance of y at neighbouring x_i."""
    z = {name: np.asarray(y)[np.argsort(np.asarray(x[name]))] for name in x}
    return np.array([(np.mean(one * np.roll(one, -1)) - one.mean()**2) / one.var() for one in z.values()])


def rigid(cases):
    return np.array([ring.answer(ring.SelfConsistentRing(motion=ring.Motion(
        mass=m, centre_of_mass_height=z, friction_coefficient=mu), radius=0.03), all=False).omega for m, z, mu in cases.to_numpy()])


n = int(sys.argv[2]) if len(sys.argv) > 2 else 128
found = stemware.solve(sample(n, 1))
solved = found[found.failure == ""]
omega = solved["omega_terminal"].astype(float)
print(f"{len(solved)} of {n} studies solved: {omega.mean():.3f} ± {omega.std():.3f} rad/s")
# Error of the indices of n studies: standard deviation of the indices of a rigid ring over ten samples of n cases.
error = np.std([shares(one, rigid(one)) for one in (sample(n, seed) for seed in range(2, 12))], axis=0)
elastic = shares(solved[list(known)], omega)
many = sample(4000, 12)
exact = shares(many, rigid(many))
for label, share, e, of_ring in zip(labels, elastic, error, exact):
    print(f"  {label:22s} share {share:5.2f} ± {e:.2f}, of the rigid ring {of_ring:5.2f}")

figure, (left, right) = plt.subplots(1, 2, figsize=(8.5, 3.1), layout="constrained")
left.hist(omega, 16, color="C0")
left.set(xlabel="terminal spin (rad/s)", ylabel="studies")
right.barh(labels, elastic, xerr=error, color="C0", capsize=3)
right.plot(exact, labels, "k|", ms=14, label="rigid ring, 4000 cases")
right.set(xlabel="share of the variance", xlim=(-0.1, 1))
right.invert_yaxis()
right.legend(fontsize=7)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "monte_carlo.svg")
