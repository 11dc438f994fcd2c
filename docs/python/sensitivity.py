"""Tornado diagram: effect on the spin of each entry at its two bounds, others unchanged, largest effect on top.

    python3 docs/python/sensitivity.py sensitivity.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import stemware

bounds = {
    "Motion/Mass": ("290 g", "310 g"),
    "Motion/Centre of mass height": ("75 mm", "85 mm"),
    "Motion/Friction coefficient": (0.27, 0.33),
    "Motion/Orbit speed": ("33 cm/s", "37 cm/s"),
    "Motion/Orbit radius": ("14 cm", "16 cm"),
    "Motion/Grip torque": (0, "0.5 mN m"),
    "Glass/Contact radius": ("29 mm", "31 mm"),
    "Glass/Crown radius": ("2 mm", "4 mm"),
    "Table/Foundation modulus": ("5 GPa/m", "20 GPa/m"),
}
found = stemware.solve([{}] + [{path: value} for path, pair in bounds.items() for value in pair])
assert not found["failure"].any(), found["failure"].max()
omega = found["omega_terminal"].astype(float)
bars = sorted(zip(bounds.items(), omega[1::2], omega[2::2]), key=lambda bar: abs(bar[1] - bar[2]))
print(f"terminal spin {omega[0]:.4f} rad/s")
for (path, pair), low, high in reversed(bars):
    print(f"  {path:30s} {str(pair[0]):>8s} {low - omega[0]:+.4f}, {str(pair[1]):>8s} {high - omega[0]:+.4f} rad/s")

figure, ax = plt.subplots(figsize=(7, 3.6), layout="constrained")
for i, (_, low, high) in enumerate(bars):
    ax.barh(i, low - omega[0], left=omega[0], color="C0", label="lower bound" if i == 0 else None)
    ax.barh(i, high - omega[0], left=omega[0], color="C1", label="upper bound" if i == 0 else None)
ax.axvline(omega[0], color="k", lw=0.8)
ax.set_yticks(range(len(bars)), [f"{path.partition('/')[2]}, {pair[0]} to {pair[1]}" for (path, pair), *_ in bars], fontsize=8)
ax.set(xlabel="terminal spin (rad/s)")
ax.legend(fontsize=8, loc="lower right")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "sensitivity.svg")
