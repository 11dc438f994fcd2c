#!/usr/bin/env python3
"""Effects that the model leaves out: change of the terminal spin of a rigid foot (docs/limits.md). No code of Stemware.

The foot has the crown and the land of the default study and stands on its mat, p = k (d0 + d1 x + d2 y - g(r))_+ with
g = (r - R)^2 / (2 crown). In the slip frame (x along the motion, orbit counter-clockwise)

    t = -mu(p) p A v_rel / |v_rel|,                     v_rel = (v - omega y, omega x), A: 1, or the tensor of a grain
    sum p = N = m g + F_z,                                                F_z: vertical force of the hand, downwards
    M_N = -dz m k x a' + (z_CM + dz) k x T + e x (m g) + (m g z_CM + F_z (z_CM + dz)) (d2, -d1),
    a' = a_CM - g_plane,  a_CM = (0, v^2 / rho) - omega^2 e,              g_plane: gravity along a table out of level
    I domega/dt = tau_z + d1 M_Nx + d2 M_Ny - m (e x a_CM)_z,             e: centre of mass beside the axis
                                                                          k x (x, y) = (-y, x), e x (m g) = m g (e_y, -e_x)

A grain and a slope are fixed to the table: in the slip frame they turn at -v / rho. The centre of mass is fixed to the glass
and turns at omega - v / rho. With them the spin is periodic after a long time: `mean` is its mean, `swing` half of its range.

    left_out_effects.py            prints the sizes (three seconds; numpy and scipy)
    left_out_effects.py --check    compares the spin without any effect with rigid_foot.json, moments and torques at rest
                                   with closed forms, a long run with one without a grid, and coarser sizes with `SIZES`
"""
import json
import pathlib
import sys

import numpy as np
from numpy.polynomial import chebyshev
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, root
from scipy.special import roots_gegenbauer, roots_legendre

MASS, INERTIA, G, MU, V, RHO, R, LAND, CROWN, K, Z_CM, DZ = 0.30, 3e-4, 9.81, 0.3, 0.35, 0.15, 0.03, 0.004, 0.003, 1e10, 0.08, -0.05
ARM = Z_CM + DZ  # height of the hand above the table

# Change of the mean spin and swing, in per cent of the terminal spin, as printed by this script.
SIZES = {
    ("falling", 0.05): (-3.35, None),
    ("falling", 0.1): (-6.70, None),
    ("falling", 0.2): (-13.44, None),
    ("falling", 1 / 3): (-22.45, None),
    ("push", -0.09): (8.66, None),
    ("push", -0.03): (2.74, None),
    ("push", 0.03): (-2.60, None),
    ("push", 0.09): (-7.44, None),
    ("grain", 0.05): (0.06, 6.43),
    ("grain", 0.1): (0.25, 12.86),
    ("grain", 0.2): (0.96, 25.67),
    ("slope", np.radians(0.1)): (-0.00, 1.58),
    ("slope", np.radians(0.3)): (-0.03, 4.74),
    ("slope", np.radians(1)): (-0.28, 15.78),
    ("beside", 3e-4): (-0.05, 3.79),
}


class Foot:
    """The foot in balance under the effects given by keyword.

    falling: s of mu = c p^-s, with the drag of mu = 0.3 at rest; push: F_z / (m g), downwards; grain: A has the eigenvalues
    1 + grain in the direction `angle` and 1 - grain across; slope: of the table [rad], downhill in the direction `angle`;
    beside: distance of the centre of mass from the axis [m], in the direction `angle`.
    """

    def __init__(self, falling=0.0, push=0.0, grain=0.0, slope=0.0, beside=0.0, n_theta=96, n_r=12):
        self.falling, self.push, self.grain, self.slope, self.beside = falling, push, grain, slope, beside
        theta = 2 * np.pi * np.arange(n_theta) / n_theta
        self.cos, self.sin = np.cos(theta)[:, None], np.sin(theta)[:, None]
        # Across the contact, the pressure is a parabola that vanishes at both ends; p^(1 - s) is integrated with the
        # weight (1 - x^2)^(1 - s).
        x, w = roots_legendre(n_r)
        self.pressure_rule = x[None, :], w[None, :] * 2 * np.pi / n_theta
        x, w = roots_gegenbauer(n_r, 1.5 - falling)
        self.friction_rule = x[None, :], w[None, :] * 2 * np.pi / n_theta
        self.coefficient = MU
        self.depth = (MASS * G / (2 * np.pi * R * K * 4 / 3 * np.sqrt(2 * CROWN))) ** (2 / 3)
        self.state = np.array([1.0, 0.0, 0.0])  # d0, R d1, R d2 in units of depth
        if falling:  # the same drag at rest: the coefficient is linear in it
            for _ in range(20):
                drag = -self.resultants(self.solve(0.0, 0.0), 0.0, 0.0)[3]
                self.coefficient *= MU * MASS * G / drag

    def resultants(self, d, omega, angle):
        """N, M_Nx, M_Ny, T_x, T_y, tau_z."""
        slope = d[1] * self.cos + d[2] * self.sin
        centre = R + CROWN * slope  # the pressure is K (half^2 - (r - centre)^2) / (2 CROWN)
        half = np.sqrt(np.maximum((CROWN * slope) ** 2 + 2 * CROWN * (d[0] + R * slope), 0))
        if np.max(half) > LAND / 2:
            raise RuntimeError("the contact is wider than the land")
        x, weight = self.pressure_rule
        r = centre + half * x
        force = weight * half * r * K * half**2 * (1 - x * x) / (2 * CROWN)
        normal = force.sum(), (force * r * self.sin).sum(), -(force * r * self.cos).sum()
        x, weight = self.friction_rule
        r = centre + half * x
        slip_x, slip_y = V - omega * r * self.sin, omega * r * self.cos
        slip = np.hypot(slip_x, slip_y)
        share = weight * half * r * (K * half**2 / (2 * CROWN)) ** (1 - self.falling) * self.coefficient
        share = share / slip
        along, across = self.grain * np.cos(2 * angle), self.grain * np.sin(2 * angle)
        t_x = -share * (slip_x * (1 + along) + slip_y * across)
        t_y = -share * (slip_y * (1 - along) + slip_x * across)
        return *normal, t_x.sum(), t_y.sum(), (r * (self.cos * t_y - self.sin * t_x)).sum()

    def acceleration(self, omega, angle):
        return -omega**2 * self.beside * np.cos(angle), V**2 / RHO - omega**2 * self.beside * np.sin(angle)

    def solve(self, omega, angle):
        """(d0, d1, d2) in balance."""
        weight, push = MASS * G, MASS * G * self.push
        a_x, a_y = self.acceleration(omega, angle)
        a_x -= G * self.slope * np.cos(angle)
        a_y -= G * self.slope * np.sin(angle)
        e_x, e_y = self.beside * np.cos(angle), self.beside * np.sin(angle)
        lean = weight * Z_CM + push * ARM

        def residual(state):
            d = self.depth * state / np.array([1, R, R])
            n, m_x, m_y, t_x, t_y, _ = self.resultants(d, omega, angle)
            return [(n - weight - push) / weight,
                    (m_x - DZ * MASS * a_y + ARM * t_y - weight * e_y - lean * d[2]) / (weight * R),
                    (m_y + DZ * MASS * a_x - ARM * t_x + weight * e_x + lean * d[1]) / (weight * R)]

        found = root(residual, self.state, tol=1e-13)
        if np.max(np.abs(residual(found.x))) > 1e-11:
            raise RuntimeError(f"no balance at {omega} rad/s: {found.message}")
        self.state = found.x
        return self.depth * found.x / np.array([1, R, R])

    def torque(self, omega, angle=0.0):
        d = self.solve(omega, angle)
        _, m_x, m_y, _, _, tau = self.resultants(d, omega, angle)
        a_x, a_y = self.acceleration(omega, angle)
        return tau + d[1] * m_x + d[2] * m_y - MASS * self.beside * (np.cos(angle) * a_y - np.sin(angle) * a_x)

    def terminal_spin(self):
        return brentq(self.torque, -2.0, -6.0, xtol=1e-12)

    def domega_dt(self, omega, angle):
        return self.torque(omega, angle) / INERTIA

    def grid_of_rates(self, centre, n_angles=16, n_spins=9, width=0.35):
        """domega/dt through its values on a grid: trigonometric in the angle, a polynomial in the spin near `centre`."""
        nodes = np.cos(np.pi * (np.arange(n_spins) + 0.5) / n_spins)
        angles = 2 * np.pi * np.arange(n_angles) / n_angles
        values = np.array([[self.domega_dt(centre * (1 + width * x), a) for a in angles] for x in nodes])
        values = np.fft.rfft(values, axis=1) / n_angles * np.r_[1, np.full(n_angles // 2 - 1, 2), 1]
        polynomials = chebyshev.chebfit(nodes, values, n_spins - 1)
        orders = 1j * np.arange(n_angles // 2 + 1)
        return lambda omega, angle: np.sum(
            np.real(chebyshev.chebval((omega / centre - 1) / width, polynomials) * np.exp(orders * angle)))

    def long_run(self, centre, rates=None, accuracy=1e-7):
        """Mean and half of the range of the periodic spin [rad/s]."""
        rates = rates or self.grid_of_rates(centre)
        glass_turns = 1.0 if self.beside else 0.0

        def derivatives(_, y):  # spin, angle of the effect in the slip frame, yaw angle
            return [rates(y[0], y[1]), glass_turns * y[0] - V / RHO, y[0]]

        y, before = np.array([centre, 0.0, 0.0]), None
        while True:  # one iteration per period
            def whole_turn(_, z, end=y[1] - 2 * np.pi):
                return z[1] - end
            whole_turn.terminal = True
            turn = solve_ivp(derivatives, (0, 60), y, events=whole_turn, rtol=accuracy, atol=accuracy, dense_output=True)
            end, last = turn.t_events[0][0], turn.y_events[0][0]
            mean = (last[2] - y[2]) / end
            if before is not None and abs(mean - before) < 10 * accuracy * abs(mean):
                return mean, np.ptp(turn.sol(np.linspace(0, end, 500))[0]) / 2
            y, before = last, mean


def size(effect, value, **resolution):
    """[change of the mean, swing or None] in per cent of the terminal spin without the effect."""
    omega = Foot(**resolution).terminal_spin()
    foot = Foot(**{effect: value}, **resolution)
    mean, swing = (foot.terminal_spin(), None) if effect in ("falling", "push") else foot.long_run(omega)
    return [100 * (mean / omega - 1), swing and 100 * swing / abs(omega)]


def check():
    """Makes the comparisons of --check; a failure raises AssertionError."""
    def agree(found, right, tolerance, what):
        assert abs(found - right) <= tolerance, f"{what}: {found} instead of {right} within {tolerance}"

    rows = json.loads((pathlib.Path(__file__).parent / "rigid_foot.json").read_text())["closure_full"]
    right = next(row for row in rows if (row["k"], row["crown"], row["z_cm"], row["tilt"], row["grip"]) == (K, CROWN, Z_CM, True, 0))
    foot = Foot()
    omega = foot.terminal_spin()
    agree(omega, right["omega"], 1e-11, "terminal spin without an effect")
    # Without spin, every point slides along x: tau_z = mu M_Nx for any load.
    for effects, moment in (({}, DZ * MASS * V**2 / RHO), ({"push": 0.09}, DZ * MASS * V**2 / RHO)):
        foot = Foot(**effects)
        d = foot.solve(0.0, 0.0)
        m_x, tau = (foot.resultants(d, 0.0, 0.0)[i] for i in (1, 5))
        agree(tau, MU * m_x, 1e-15, f"torque at rest with {effects}")
        lean = MASS * G * (Z_CM + effects.get("push", 0.0) * ARM)
        agree(m_x - lean * d[2], moment, 1e-12, f"moment at rest with {effects}")
    foot = Foot(beside=3e-4)
    d = foot.solve(0.0, np.pi / 2)
    agree(foot.resultants(d, 0.0, np.pi / 2)[1] - MASS * G * Z_CM * d[2], DZ * MASS * V**2 / RHO + MASS * G * 3e-4, 1e-12,
          "moment at rest of a centre of mass at the inside")
    # Long run that solves the balance at each step, without a grid.
    foot = Foot(slope=np.radians(0.3), n_theta=48, n_r=8)
    for found, right in zip(foot.long_run(omega), foot.long_run(omega, foot.domega_dt, 1e-6)):
        agree(found, right, 1e-5, "long run on a slope")
    for effect, value in (("falling", 1 / 3), ("push", 0.09), ("grain", 0.1), ("beside", 3e-4)):
        for found, right in zip(size(effect, value, n_theta=64, n_r=8), SIZES[effect, value]):
            if right is not None:
                agree(found, right, 0.006, f"{effect} {value:.4g}, per cent")


def main():
    if sys.argv[1:] == ["--check"]:
        return check()
    for effect, value in SIZES:
        change, swing = size(effect, value)
        print(f"{effect:>8} {value:.4g}: mean {change:+.2f} %" + (f", swing {swing:.2f} %" if swing else ""))
    for falling in (0.05, 1 / 3):
        print(f"   s = {falling:.3g}: torque at rest {1e3 * Foot(falling=falling).torque(0.0):.3f} mN m")
    print(f"   constant mu: {1e3 * Foot().torque(0.0):.3f} mN m")


if __name__ == "__main__":
    main()
