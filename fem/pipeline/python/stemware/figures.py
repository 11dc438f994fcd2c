"""Figures for papers and notebooks by matplotlib: each function draws a Result, a Fit or a LimitSurface into axes and returns them."""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from .ring import LimitSurface


def _axes(ax, **kind):
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt
    return plt.subplots(subplot_kw=kind)[1]


def pressure(result: Any, ax: Any = None, cmap: str = "viridis") -> Any:
    """Draws the pressure p(r, theta) of the contact at rest, unrolled along the rim."""
    ax, p = _axes(ax), result.curves["pressure"]
    theta = p["theta"].reshape(-1, *[1] * (p["r"].ndim - 1))  # one angle per row of the grid
    dots = ax.scatter(np.degrees(np.broadcast_to(theta, p["r"].shape)), 1e3 * p["r"], c=p["p"] / 1e3, s=9, cmap=cmap)
    ax.figure.colorbar(dots, ax=ax, label="pressure (kPa)")
    ax.set(xlabel="θ from the direction of travel (°)", ylabel="r (mm)", xlim=(0, 360), xticks=range(0, 361, 90))
    return ax


def load(result: Any, ax: Any = None, **style: Any) -> Any:
    """Draws the load λ(θ) of the contact at rest, and the sum of its harmonics."""
    ax, theta = _axes(ax), np.linspace(0, 2 * np.pi, 721)
    ax.plot(np.degrees(theta), result.load().at(theta), **{"color": "C0", "label": "harmonics", **style})
    if result.curves["load"]["theta"].size:
        ax.plot(np.degrees(result.curves["load"]["theta"]), result.curves["load"]["density"], "k.", ms=2, label="contact")
    ax.axhline(0, color="0.7", lw=0.8)
    ax.set(xlabel="θ from the direction of travel (°)", ylabel="λ (N/rad)", xlim=(0, 360), xticks=range(0, 361, 90))
    return ax


def torque(result: Any, ax: Any = None, **style: Any) -> Any:
    """Draws the total torque on the glass over its spin; a circle marks the terminal spin."""
    ax, curve = _axes(ax), result.curves["torque"]
    ax.plot(curve["omega"], 1e3 * curve["sum"], **style)
    ax.axhline(0, color="0.7", lw=0.8)
    if result.omega is not None:
        ax.plot(result.omega, 0, "ko", mfc="none")
    ax.set(xlabel="spin (rad/s)", ylabel="torque (mN m)")
    return ax


def spin_up(result: Any, ax: Any = None, **style: Any) -> Any:
    """Draws the spin-up ω(t) from rest, and the spin-up of the paper's model for the same glass."""
    ax, up = _axes(ax), result.curves["spin_up"]
    ax.plot(up["time"], up["omega"], **{"label": "elastic foot", **style})
    ax.plot(up["time"], up["paper"], color="0.6", label="the paper's model")
    ax.set(xlabel="time (s)", ylabel="spin (rad/s)")
    return ax


def budget(result: Any, ax: Any = None, at_least: float = 1e-3) -> Any:
    """Draws the budget as a waterfall from the paper's spin to the spin of the study; omits steps below at_least [rad/s]."""
    ax = _axes(ax)
    rows = [row for row in result["budget"] if row["omega_terminal"] is not None
            and (row["difference"] is None or abs(row["difference"]) >= at_least)]
    for i, row in enumerate(rows):
        step = row["omega_terminal"] if i == 0 else row["difference"]
        ax.barh(i, step, left=row["omega_terminal"] - step, color="0.7" if i == 0 else "C0" if step < 0 else "C3")
    ax.set_yticks(range(len(rows)), [f"{row['name']} {row['harmonics'] or ''}".strip() for row in rows], fontsize=8)
    ax.invert_yaxis()
    ends = sorted(row["omega_terminal"] for row in rows)
    margin = 0.3 * (ends[-1] - ends[0])
    ax.set(xlabel="terminal spin (rad/s)", xlim=(ends[0] - margin, ends[-1] + margin))
    return ax


def limit_surface(surface: LimitSurface, ax: Any = None, pade: bool = True) -> Any:
    """Draws a limit surface with the ellipsoid and, for a Pressure, the Pade forms."""
    ax = _axes(ax)
    ax.plot(surface.force, surface.torque, "k", lw=2, label="exact")
    ax.plot(*surface.ellipsoid(), "C0--", lw=1, label="ellipsoid")
    if pade and surface._pressure is not None:
        with warnings.catch_warnings():  # the figure shows the misfit that pade() warns of
            warnings.simplefilter("ignore")
            for order, style in ((1, "C1-."), (2, "C3:")):
                ax.plot(*surface.pade(order), style, lw=1.2, label=f"Padé, order {order}")
    ax.set(xlabel="force / μN", ylabel="torque / torque of pure spin", aspect="equal")
    return ax


def fit(found: Any, axes: Any = None) -> Any:
    """Draws points and curves of a Fit into the first of two axes, the residuals over sigma into the second."""
    if axes is None:
        import matplotlib.pyplot as plt
        axes = plt.subplots(2, sharex=True, gridspec_kw={"height_ratios": (3, 1)})[1]
    for r, run in enumerate(found.runs):
        axes[0].plot(run["time"], run["measured"], f"C{r}.", run["time"], run["fitted"], f"C{r}", ms=3)
        axes[1].plot(run["time"], run["residuals"] / run["sigma"], f"C{r}.", ms=3)
    axes[0].set(ylabel="spin (rad/s), or yaw angle (rad)")
    axes[1].set(xlabel="time (s)", ylabel="residual / σ")
    return axes
