#!/usr/bin/env python3
"""Compares friction of a ring, a disc and a Hertz patch with the laws of simulators, and with a quadrature of its own.

    simulators.py            writes the tables of simulators.md beside it, and its figure
    simulators.py --check    exit code 1 if a table or the figure has drifted or Stemware and the quadrature differ

Needs numpy and the Python package `stemware`.
"""
import pathlib
import re
import sys

import numpy as np

from stemware import ring

import figures

page = pathlib.Path(__file__).resolve().parent / "simulators.md"
drawing = page.parent / "figures" / "simulators.svg"
tolerance = 1e-9  # of force, torque and stop ratio
R = 0.03
x, weight = np.polynomial.legendre.leggauss(12)


def nodes(a, b, n_cells):
    """Points and weights of Gauss's rule on cells that shrink by half towards both ends of (a, b)."""
    half = 0.5**np.arange(n_cells, 0, -1)
    edges = a + (b - a) * np.concatenate([[0], half, 1 - half[-2::-1], [1]])
    middle, h = (edges[1:] + edges[:-1]) / 2, np.diff(edges) / 2
    return (middle[:, None] + h[:, None] * x).ravel(), (h[:, None] * weight).ravel()


def on_ring(u, r):
    """Friction per load of a ring r that slides with v = 1 along x and spins with omega = u, by quadrature."""
    theta, w = nodes(-np.pi / 2, np.pi / 2, 24)  # the slip is least at -pi/2
    along, across = 1 - u * r[:, None] * np.sin(theta), u * r[:, None] * np.cos(theta)
    speed = np.hypot(along, across)
    speed[speed == 0] = 1
    return ((along / speed) @ w / np.pi, (r[:, None] * (across * np.cos(theta) - along * np.sin(theta)) / speed) @ w / np.pi)


# By name: pressure of Stemware, load per radius with the integral 1 (None: one ring), mean r, mean 1/r and mean r^2 for R = 1.
contacts = {
    "ring": (ring.RingStack.first_harmonic(normal_force=1.0, moment=(0, 0), radius=R), None, 1, 1, 1),
    "disc": (ring.Pressure.disc(R), lambda r: 2 * r, 2 / 3, 2, 1 / 2),
    "Hertz": (ring.Pressure.hertz(R), lambda r: 3 * r * np.sqrt(1 - r * r), 3 * np.pi / 16, 3 * np.pi / 4, 2 / 5),
}


def integrated(load, ratio):
    """(force, torque) over mu N and mu N R at omega R / v = ratio, by quadrature alone."""
    if load is None:
        return [float(value[0]) for value in on_ring(ratio, np.array([1.0]))]
    places = [nodes(a, b, 16) for a, b in ([(0, 1 / ratio), (1 / ratio, 1)] if ratio > 1 else [(0, 1)])]
    r, w = (np.concatenate(part) for part in zip(*places))
    return [float((value * load(r) * w).sum()) for value in on_ring(ratio, r)]


def stemware(pressure, ratio):
    T = ring.wrench(pressure, 1.0, ratio / R, mu=1.0)
    return -float(T.force_x), -float(T.torque) / R


def laws(arm, inverse, square):
    """The simulators' (force, torque) by the slip ratio: elliptic cone, Contensou-Pade of order 1."""
    return {"elliptic cone": lambda e: (1 / np.hypot(1, arm * e), arm * arm * e / np.hypot(1, arm * e)),
            "Padé": lambda e: (1 / (1 + 2 * e / inverse), arm * e / (e + 2 * arm / square))}


def stop(law, inertia):
    """v / omega R at the stop: d(omega R / v)/dt = 0, so t = e f I / m R^2; None if the sliding ends first."""
    excess = lambda e: law(e)[1] - inertia * e * law(e)[0]
    if abs(excess(1.0)) < 1e-12:
        return "any" if abs(excess(2.0)) < 1e-12 else 1.0
    a, b = 2.0, 1.0
    if excess(1e-3) * excess(1e3) > 0:
        return None
    while abs(b - a) > 1e-11 * b:  # secants
        a, b = b, b - excess(b) * (b - a) / (excess(b) - excess(a))
    return 1 / b


def as_text(value):
    return value if isinstance(value, str) else "0 (sliding ends first)" if value is None else f"{value:.4f}"


def tables():
    worst, friction, stops = 0.0, [], []
    for name, (pressure, load, arm, inverse, square) in contacts.items():
        for ratio in (0.5, 1.0, 2.0):
            exact, found = integrated(load, ratio), stemware(pressure, ratio)
            worst = max(worst, *(abs(a - b) for a, b in zip(exact, found)))
            rows = [found, *(law(ratio) for law in laws(arm, inverse, square).values())]
            friction.append(f"| {name} | {ratio:g} | " + " | ".join(f"{f:.4f}, {t:.4f}" for f, t in rows) + " |")
        exact = stop(lambda e: integrated(load, e), square)
        found = 1 / ring.slide(pressure, mu=0.3, mass=0.3, speed=1.0, omega=20.0)["final_slip_ratio"]
        worst = max(worst, abs(exact - found))
        row = [f"{arm:.4f}", f"{found:.10f}"] + [as_text(stop(law, square)) for law in laws(arm, inverse, square).values()]
        stops.append(f"| {name} | {square:g} | " + " | ".join(row) + " |")
    head = ["| contact | ωR/v | Stemware | elliptic cone | Padé, order 1 |", "|---|---|---|---|---|"]
    head_of_stops = ["| contact | I/mR² | arm/R | Stemware | elliptic cone | Padé, order 1 |", "|---|---|---|---|---|---|"]
    return worst, {"friction": head + friction, "stops": head_of_stops + stops}


def figure():
    """Torque over force at slip ratios from pure sliding to pure spin."""
    ratios, panels = np.tan(np.linspace(0, np.pi / 2, 41)[1:-1]), {}
    for name, (pressure, _, arm, inverse, square) in contacts.items():
        curves = {"Stemware": lambda e: stemware(pressure, e), **laws(arm, inverse, square)}
        panels[name] = {law: tuple(zip((1, 0), *(at(ratio) for ratio in ratios), (0, arm))) for law, at in curves.items()}
    return figures.laws(panels)


def main():
    worst, written = tables()
    text = page.read_text()
    for name, lines in written.items():
        text = re.sub(f"<!-- {name} -->.*?<!-- end -->", f"<!-- {name} -->\n" + "\n".join(lines) + "\n<!-- end -->", text, flags=re.S)
    print(f"Stemware and the quadrature differ by {worst:.1e} at most; accepted: {tolerance:.0e}")
    picture = figure()
    drifted = text != page.read_text() or not drawing.exists() or picture != drawing.read_text()
    if "--check" not in sys.argv:
        page.write_text(text)
        drawing.write_text(picture)
    elif drifted:
        print("docs/verification/simulators.md or its figure is not what simulators.py writes; run it and commit both")
    return worst > tolerance or ("--check" in sys.argv and drifted)


if __name__ == "__main__":
    sys.exit(main())
