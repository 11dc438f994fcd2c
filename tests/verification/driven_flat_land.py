#!/usr/bin/env python3
"""Spin of a glass with a rigid, flat land on a mat while the hand accelerates: the constants of
OrbitSpeed.ErrorBandOfADrivenSpinContainsTheError. Plane quadrature of the friction over the land, whose pressure is linear in x and
y in balance with all moments, and the classical Runge-Kutta scheme. No code of Stemware.

    driven_flat_land.py
"""
import numpy as np

m, g, mu, offset, h, inertia, orbit = 0.3, 9.81, 0.3, -0.05, 0.03, 3e-4, 0.15
inner, outer = 0.028, 0.032  # radii of the land


def plane(n_radii, n_angles):
    """x, y and the area of each point of a quadrature over the land."""
    nodes, weights = np.polynomial.legendre.leggauss(n_radii)
    r = (inner + outer) / 2 + (outer - inner) / 2 * nodes
    angle = 2 * np.pi * (np.arange(n_angles) + 0.5) / n_angles
    area = np.outer((outer - inner) / 2 * weights * r, np.full(n_angles, 2 * np.pi / n_angles))
    return np.outer(r, np.cos(angle)).ravel(), np.outer(r, np.sin(angle)).ravel(), area.ravel()


def torque(v, dv, omega, points):
    """tau_z on the glass; the pressure is c (1, x, y)."""
    x, y, area = points
    slip_x, slip_y = v - omega * y, omega * x
    speed = np.hypot(slip_x, slip_y)
    shapes = np.array([np.ones_like(x), x, y])
    friction_x, friction_y = -mu * slip_x / speed * area, -mu * slip_y / speed * area
    tx, ty, tau = shapes @ friction_x, shapes @ friction_y, shapes @ (x * friction_y - y * friction_x)
    # N; M_N,x = int p y = offset m v^2 / r - h T_y; -M_N,y = int p x = offset m dv/dt - h T_x.
    matrix = np.array([shapes @ area, shapes @ (y * area) + h * ty, shapes @ (x * area) + h * tx])
    c = np.linalg.solve(matrix, [m * g, offset * m * v**2 / orbit, offset * m * dv])
    assert np.all(c @ shapes > 0), "the land lifts off"
    return c @ tau


def spin(v0, dv, end, n_steps, points):
    """omega at the time end, from rest."""
    omega, dt = 0.0, end / n_steps
    slope = lambda t, w: torque(v0 + dv * t, dv, w, points) / inertia
    for i in range(n_steps):
        t = i * dt
        k1 = slope(t, omega)
        k2 = slope(t + dt / 2, omega + dt / 2 * k1)
        k3 = slope(t + dt / 2, omega + dt / 2 * k2)
        k4 = slope(t + dt, omega + dt * k3)
        omega += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return omega


if __name__ == "__main__":
    for v0, v1, end in [(0.2, 0.35, 0.6), (0.35, 0.15, 0.8)]:
        coarse = spin(v0, (v1 - v0) / end, end, 400, plane(6, 64))
        fine = spin(v0, (v1 - v0) / end, end, 800, plane(10, 128))
        print(f"{v0} to {v1} m/s in {end} s: {fine:.9f} rad/s, halved steps and points change it by {fine - coarse:.1e}")
