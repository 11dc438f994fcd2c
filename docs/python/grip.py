"""Effect of the torque of the fingers: terminal spin of the elastic glass and of a rigid ring, and spin-up of the rigid ring.

    python3 docs/python/grip.py grip.svg
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import stemware
from stemware import ring

grip = np.linspace(0, 4e-3, 9)
glass = stemware.solve([{"Motion/Grip torque": g} for g in grip])
rigid = ring.SelfConsistentRing(motion=ring.Motion(), closure="full", radius=0.03)
of_ring = np.array([ring.answer(rigid, grip_torque=g, all=False).omega for g in grip])
rest = abs(glass["tau_at_rest"][0])
print(f"the elastic glass is held from {1e3 * rest:.3f} mN m on, the torque of friction on the glass at rest")
for g, of_glass, rigid_one in zip(grip, glass["omega_terminal"], of_ring):
    print(f"  {1e3 * g:.1f} mN m: {of_glass:7.4f} rad/s, the rigid ring {rigid_one:7.4f} rad/s")
straight = glass["omega_terminal"][0] * np.clip(1 - grip / rest, 0, None)
far = np.abs(glass["omega_terminal"].astype(float) - straight).max()
print(f"a straight line from the free spin to zero is off by at most {far:.2f} rad/s")

figure, (left, right) = plt.subplots(1, 2, figsize=(8.5, 3.2), layout="constrained")
left.plot([0, 1e3 * rest, 4], [glass["omega_terminal"][0], 0, 0], "0.7", lw=1, label="straight line")
left.plot(1e3 * grip, of_ring, "C1x", ms=6, label="rigid ring")
left.plot(1e3 * grip, glass["omega_terminal"], "C0o", ms=5, mfc="none", label="elastic glass")
left.set(xlabel="torque of the fingers (mN m)", ylabel="terminal spin (rad/s)")
left.legend(fontsize=8)
times = np.linspace(0, 2, 201)
for torque in (0.0, 1e-3, 2e-3, 3e-3):
    up = ring.spin_up(rigid, times, grip_torque=torque)
    right.plot(up["time"], up["omega"], label=f"{1e3 * torque:.0f} mN m")
right.set(xlabel="time (s)", ylabel="spin of the rigid ring (rad/s)")
right.legend(fontsize=8)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "grip.svg")
