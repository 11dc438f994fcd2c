"""Grid convergence: terminal spin over the refinement levels of each numerical parameter, observed orders and bands.

    python3 docs/python/refinement.py refinement.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

import stemware

result = stemware.Study(table="mat").converge(levels=3)
band = result.bands().loc["omega_terminal"]
print(f"terminal spin {band['value']:.6f} ± {band['band']:.1e} rad/s")
figure, ax = plt.subplots(figsize=(6, 3.4), layout="constrained")
for axis in result.refinement.values():
    spins = axis["figures"]["omega_terminal"]
    order = "no order" if spins["order"] is None else f"order {spins['order']:.1f}"
    print(f"  {axis['name']:22s} {spins['values'][axis['own_level']]:.7f} ± {spins['bands'][axis['own_level']]:.1e} ({order})")
    ax.semilogy(range(len(spins["values"])), [max(b, 1e-10) for b in spins["bands"]], "o-", ms=4, label=axis["name"])
ax.set(xlabel="level, from coarse to fine", ylabel="band (rad/s)", xticks=range(4))
ax.legend(fontsize=8)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "refinement.svg")
