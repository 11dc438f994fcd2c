"""stemware.ring against closed forms and elliptic integrals of scipy."""
import ast
import doctest
import os
import pickle
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np
from scipy.integrate import quad
from scipy.special import ellipe, ellipkm1

from stemware import ring

from interruption import is_stopped

N, mu, R, v = 3.0, 0.3, 0.03, 0.35


def elliptic(eps):
    """(1 + eps) E and (1 - eps) K of a ring at the slip ratio eps, without cancellation near eps = 1."""
    complement = ((1 - eps) / (1 + eps))**2
    return (1 + eps) * ellipe(1 - complement), 0.0 if complement == 0 else (1 - eps) * ellipkm1(complement)


def drag(eps):
    """Drag of a ring at the slip ratio eps, over mu N."""
    return sum(elliptic(eps)) / np.pi


def twist(eps):
    """Braking torque of a ring at the slip ratio eps, over mu N r."""
    if eps == 0:
        return 0.0
    E, K = elliptic(eps)
    return (E - K) / (np.pi * eps)


def integrals(p, inner, outer, omega, speed):
    """Force and torque over mu N of p(r) by adaptive quadrature; the variable is the root of the distance to either end."""
    ends = sorted({inner, outer} | ({speed / omega} if inner < speed / omega < outer else set()))
    pieces = []
    for a, b in zip(ends, ends[1:]):
        def at(t, f, a=a, b=b):
            r = a + (b - a) * np.sin(t)**2
            return f(r) * 2 * (b - a) * np.sin(t) * np.cos(t) * p(r) * r
        pieces.append([quad(at, 0, np.pi / 2, args=(f,), epsabs=0, epsrel=1e-13, limit=400)[0]
                       for f in (lambda r: 1.0, lambda r: drag(omega * r / speed), lambda r: r * twist(omega * r / speed))])
    whole, force, torque = np.sum(pieces, axis=0)
    return force / whole, torque / whole


class ClosedForms(unittest.TestCase):
    bodies = {
        "ring": (ring.Pressure.ring(R), 1, 2 / np.pi, 2 / np.pi),
        "disc": (ring.Pressure.disc(R), 2 / 3, 8 / (3 * np.pi), 8 / (9 * np.pi)),
        "annulus": (ring.Pressure.annulus(0.7 * R, R), 2 / 3 * (1 - 0.7**3) / (1 - 0.7**2), None, None),
        "Hertz": (ring.Pressure.hertz(R), 3 * np.pi / 16, None, None),
        "disc as a function": (ring.Pressure(np.ones_like, 0, R), 2 / 3, 8 / (3 * np.pi), 8 / (9 * np.pi)),
        "disc as a number": (ring.Pressure(lambda r: 2.0, 0, R), 2 / 3, 8 / (3 * np.pi), 8 / (9 * np.pi)),
        "Hertz as a function": (ring.Pressure(lambda r: np.sqrt(1 - (r / R)**2), 0, R), 3 * np.pi / 16, None, None),
    }
    shapes = {"annulus": (lambda r: 1.0, 0.7 * R), "Hertz": (lambda r: np.sqrt(max(0, R * R - r * r)), 0)}

    def test_pure_spin_rest_and_equal_speeds(self):
        for name, (body, arm, force, torque) in self.bodies.items():
            with self.subTest(name):
                spin = ring.wrench(body, 0.0, 5.0, mu=mu, normal_force=N)
                self.assertLess(abs(-spin.torque / (mu * N * R * arm) - 1), 1e-12)
                self.assertLess(abs(spin.force_x), 1e-13)
                rest = ring.wrench(body, v, 0.0, mu=mu, normal_force=N)
                self.assertLess(abs(-rest.force_x / (mu * N) - 1), 1e-13)
                self.assertEqual(rest.torque, 0)
                equal = ring.wrench(body, v, v / R, mu=mu, normal_force=N)
                if force is None:
                    p, inner = self.shapes[name.split()[0]]
                    force, torque = integrals(p, inner, R, v / R, v)
                    torque /= R
                self.assertLess(abs(-equal.force_x / (mu * N * force) - 1), 1e-12)
                self.assertLess(abs(-equal.torque / (mu * N * R * torque) - 1), 1e-12)

    def test_any_slip_against_elliptic_integrals(self):
        p = lambda r: 1 + (r / R)**2
        body = ring.Pressure(p, 0.4 * R, R)
        for eps in (0.3, 1.2, 1.9, 5.0):
            got = ring.wrench(body, v, eps * v / R, mu=mu, normal_force=N)
            force, torque = integrals(p, 0.4 * R, R, eps * v / R, v)
            self.assertLess(abs(-got.force_x / (mu * N * force) - 1), 1e-12)
            self.assertLess(abs(-got.torque / (mu * N * torque) - 1), 1e-12)

    def test_a_first_harmonic_at_rest(self):
        load = ring.RingStack.first_harmonic(normal_force=N, moment=(0.02, 0.01), radius=R)
        self.assertLess(abs(ring.wrench(load, v, 0.0, mu=mu).torque / (mu * 0.02) - 1), 1e-14)

    def test_a_stack_converges_to_the_annulus_within_its_stated_error(self):
        exact = ring.wrench(ring.Pressure.annulus(0.7 * R, R), v, np.linspace(-30, 30, 200), mu=mu, normal_force=N).torque
        theta = np.arange(32) * 2 * np.pi / 32
        torques = []
        for n in (11, 21):
            r = np.linspace(0.7 * R, R, n)
            p = np.full((n, 32), N / (np.pi * R**2 * (1 - 0.49)))
            stack = ring.stack_from_pressure(r, theta, p, n_max=2)
            torques.append(ring.wrench(stack, v, np.linspace(-30, 30, 200), mu=mu).torque)
        errors = [np.abs(torque - exact).max() / (mu * N * R) for torque in torques]
        self.assertLess(errors[1], 3e-4)
        self.assertGreater(np.abs(torques[1] - torques[0]).max() / (mu * N * R), errors[1])


def moving_friction(load, velocity, omega, point, n=4096):
    """Force and torque about a point by the trapezoidal rule over the azimuth of each ring."""
    theta = np.arange(n) * 2 * np.pi / n
    force, torque = np.zeros(2), 0.0
    for radius, a, b in zip(load.radii, load.a, load.b):
        k = np.arange(a.size)[:, None]
        density = a @ np.cos(k * theta) + b @ np.sin(k * theta)
        where = radius * np.array([np.cos(theta), np.sin(theta)]) - np.array(point)[:, None]
        slip = np.array(velocity)[:, None] + omega * np.array([-where[1], where[0]])
        pull = -density * slip / np.hypot(*slip) * 2 * np.pi / n
        force += pull.sum(axis=1)
        torque += (where[0] * pull[1] - where[1] * pull[0]).sum()
    return force, torque


class LimitSurface(unittest.TestCase):
    stack = ring.RingStack(radii=[0.028, 0.03], a=[[0.25, 0.05, 0.02], [0.2, -0.04, 0.01]], b=[[0, 0.06, 0.01], [0, 0.03, 0]])

    def test_about_any_point_in_any_direction(self):
        for point, direction in (((0.004, -0.003), 0.7), ((0.0, 0.005), -2.0), ((0.0, 0.0), 1.0)):
            s = ring.limit_surface(self.stack, n=13, about=point, direction=direction)
            along = np.array([np.cos(direction), np.sin(direction)])
            for i in (2, 4, 6, 8, 10):
                force, torque = moving_friction(self.stack, np.cos(s.angle[i]) * along,
                                                np.sin(s.angle[i]) / self.stack.radius, point)
                self.assertAlmostEqual(-force @ along / self.stack.normal_force, s.force[i], delta=1e-9)
                self.assertAlmostEqual(-torque / self.stack.normal_force / s.arm, s.torque[i], delta=1e-9)
                self.assertAlmostEqual(-(along[0] * force[1] - along[1] * force[0]) / self.stack.normal_force, s.across[i], delta=1e-9)

    def test_directions_differ_and_the_centre_of_pressure_slides_without_torque(self):
        load = ring.RingStack.first_harmonic(normal_force=1.0, moment=(0.35 * R, 0.1 * R), radius=R)
        s = ring.limit_surface(load, n=3, about="centre of pressure")
        self.assertLess(abs(s.torque[1]), 1e-14)
        other = ring.limit_surface(load, direction=np.pi / 2)
        self.assertGreater(np.abs(other.force - ring.limit_surface(load).force).max(), 0.05)

    def test_slip_is_normal_to_the_limit_surface(self):
        for s in (ring.limit_surface(ring.Pressure.disc(R), n=4001), ring.limit_surface(self.stack, n=4001, direction=0.4, about=(0.002, 0.001))):
            rate = np.cos(s.angle) * np.gradient(s.force, s.angle) + np.sin(s.angle) * s.arm / s.radius * np.gradient(s.torque, s.angle)
            self.assertLess(np.abs(rate[5:-5]).max(), 1e-3)  # torques are singular like x ln x

    def test_pade_has_the_published_coefficients_of_hertz(self):
        s = ring.limit_surface(ring.Pressure.hertz(R))
        v_, u = np.cos(s.angle[1:-1]), np.abs(np.sin(s.angle[1:-1]))
        force, torque = (one[1:-1] for one in s.pade(order=1))
        np.testing.assert_allclose(force, v_ / (v_ + 8 / (3 * np.pi) * u), rtol=1e-10)
        np.testing.assert_allclose(np.abs(torque), u / (u + 15 * np.pi / 16 * v_), rtol=1e-10)
        for order, bound in ((1, 0.5), (2, 0.25)):
            force, torque = s.pade(order)
            self.assertLess(np.hypot(force - s.force, torque - s.torque).max(), bound)
        e = 1e-4  # order 2: the error is O(e^3) at pure sliding
        for x in (e, 2 * e):
            one = ring.wrench(ring.Pressure.hertz(R), 1.0, x / R, mu=1.0, normal_force=1.0)
            self.assertLess(abs(-one.force_x - (1 - x * x / 10)), x**3)

    def test_ellipsoid_and_excess(self):
        s = ring.limit_surface(ring.Pressure.disc(R))
        excess = s.excess(*s.ellipsoid())
        self.assertGreater(excess.min(), -1e-6)
        self.assertAlmostEqual(excess.max(), 0.07, delta=0.002)
        self.assertLess(np.abs(s.excess(s.force, s.torque)).max(), 1e-12)


def of_points(x, y, force, velocity, omega, point):
    """Force and torque about a moving point, of contact points with the given normal forces and mu = 1."""
    arm_x, arm_y = x - point[0], y - point[1]
    slip = np.array([velocity[0] - omega * arm_y, velocity[1] + omega * arm_x])
    pull = -force * slip / np.hypot(*slip)
    return pull.sum(axis=1), (arm_x * pull[1] - arm_y * pull[0]).sum()


class AnyLoad(unittest.TestCase):
    def test_a_pressure_in_any_direction_about_any_point(self):
        # A disc of 1e6 points by the midpoint rule.
        r, theta = R * np.sqrt((np.arange(1000)[:, None] + 0.5) / 1000), 2 * np.pi * (np.arange(1000) + 0.5) / 1000
        x, y = (r * np.cos(theta)).ravel(), (r * np.sin(theta)).ravel()
        for omega, direction, point in ((0.1, np.pi / 2, (0, 0)), (-9.0, 0.7, (0.01, -0.004)), (20.0, -2.0, (0, 0.05))):
            got = ring.wrench(ring.Pressure.disc(R), v, omega, mu=mu, normal_force=N, direction=direction, about=point)
            force, torque = of_points(x, y, mu * N / x.size, v * np.array([np.cos(direction), np.sin(direction)]), omega, point)
            np.testing.assert_allclose([got.force_x, got.force_y], force, atol=2e-6 * mu * N)
            self.assertAlmostEqual(float(got.torque), torque, delta=2e-6 * mu * N * R)

    def test_a_stack_about_a_point(self):
        got = ring.wrench(LimitSurface.stack, v, 6.0, mu=mu, direction=0.4, about=(0.004, -0.003))
        force, torque = moving_friction(LimitSurface.stack, (v * np.cos(0.4), v * np.sin(0.4)), 6.0, (0.004, -0.003))
        np.testing.assert_allclose([got.force_x, got.force_y, got.torque], mu * np.array([*force, torque]), rtol=1e-9)

    def test_patches(self):
        x, y, force = np.array([0.03, -0.02, 0.0, 0.01]), np.array([0.0, 0.02, -0.04, 0.01]), np.array([1.0, 2.0, 0.5, 0.0])
        patch = ring.Patch(x, y, force)
        for point in ((0.0, 0.0), (0.01, 0.02)):
            expected = of_points(x, y, force, (0.1, -0.2), 3.0, point)
            got = ring.wrench(patch, np.hypot(0.1, 0.2), 3.0, mu=1.0, direction=np.arctan2(-0.2, 0.1), about=point)
            np.testing.assert_allclose([got.force_x, got.force_y, got.torque], [*expected[0], expected[1]], rtol=1e-13)
        self.assertEqual(float(ring.wrench(ring.Patch(0.0, 0.0, 2.0), 0.0, 1.0, mu=mu).torque), 0)  # a point that only rotates
        theta = np.arange(2000) * 2 * np.pi / 2000
        circle, thin = ring.Patch(R * np.cos(theta), R * np.sin(theta), N / 2000), ring.Pressure.ring(R)
        self.assertAlmostEqual(circle.radius / R, 1, delta=1e-12)
        one, other = ring.limit_surface(circle, n=9), ring.limit_surface(thin, n=9)
        np.testing.assert_allclose(one.force[1:-1], other.force[1:-1], atol=1e-3)  # one point is at rest
        np.testing.assert_allclose(one.torque[1:-1], other.torque[1:-1], atol=1e-3)
        # Plank that rotates about its end: mu N L / 2.
        plank = ring.Patch(0.2 * (np.arange(1000) + 0.5) / 1000, 0.0, N / 1000)
        self.assertAlmostEqual(float(-ring.wrench(plank, 0.0, 1.0, mu=mu, about=(0, 0)).torque) / (mu * N * 0.1), 1, delta=1e-12)
        self.assertAlmostEqual(ring.limit_surface(plank, about="centre of pressure").arm, 0.05, delta=1e-12)

    def test_formulas_outside_their_range_warn(self):
        for surface, form, warns in (
            (ring.limit_surface(ring.Pressure.disc(R)), lambda s: s.ellipsoid(), False),
            (ring.limit_surface(ring.Pressure.ring(R)), lambda s: s.ellipsoid(), False),
            (ring.limit_surface(ring.RingStack.first_harmonic(normal_force=N, moment=(0.3 * N * R, 0), radius=R)), lambda s: s.ellipsoid(), True),
            (ring.limit_surface(ring.Pressure.hertz(R)), lambda s: s.pade(1), False),
            (ring.limit_surface(ring.Pressure.ring(R)), lambda s: s.pade(1), True),
        ):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                curve = form(surface)
            self.assertEqual([one.category for one in caught], [UserWarning] * warns)
            self.assertEqual(curve.force.shape, surface.force.shape)


class Motions(unittest.TestCase):
    def test_a_glass_that_tips_has_no_spin(self):
        # |M| > N R: -dz m v^2 / rho plus the moment of the friction tip the glass.
        tall = ring.Motion(force_offset=0.03)
        with self.assertRaises(ring.Tipping):
            ring.answer(ring.SelfConsistentRing(motion=tall, closure="full"))
        for ratio, tips in ((1.99, False), (2.01, True)):
            load = ring.RingStack.first_harmonic(normal_force=tall.normal_force, moment=(ratio * tall.normal_force * R / 2, 0), radius=R)
            if tips:
                self.assertRaises(ring.NoBalance, ring.answer, load, tall)
            else:
                self.assertGreater(ring.answer(load, tall).omega, 0)

    def test_fingers_that_hold_the_glass_for_a_while(self):
        # tau = A cos(nu t) - c omega: after it stops, the glass stays at rest while A |cos(nu t)| < grip.
        found = ring.yaw_motion(lambda t, psi, w: 4e-3 * np.cos(4.6 * t) - 1.2e-3 * w, yaw_inertia=1e-9, times=[0.1, 0.341, 0.45],
                                spin_scale=3.0, grip_torque=2.5e-3)
        self.assertAlmostEqual(found["omega"][0], (4e-3 * np.cos(0.46) - 2.5e-3) / 1.2e-3, delta=1e-5)
        self.assertEqual(found["omega"][1], 0)
        self.assertAlmostEqual(found["omega"][2], (4e-3 * np.cos(4.6 * 0.45) + 2.5e-3) / 1.2e-3 if np.cos(4.6 * 0.45) < -0.625 else 0, delta=1e-5)

    def test_terminal_spins(self):
        body = ring.SelfConsistentRing(motion=ring.Motion(), closure="paper", radius=R)
        found = ring.answer(body)
        self.assertLess(abs(found.omega / -3.1205587015258573 - 1), 1e-12)  # ring_cases.json
        self.assertTrue(any(abs(one["omega"] - found.omega) < 1e-9 and one["stable"] for one in found.all))
        self.assertTrue(ring.answer(body, grip_torque=0.1).held)
        up = ring.spin_up(body, [0, 100])
        self.assertAlmostEqual(up["omega"][-1], found.omega, delta=1e-7)
        m = ring.Motion()
        own = ring.yaw_motion(lambda t, psi, w: -1e-4 * (w - 2), yaw_inertia=m.yaw_inertia, times=np.array([0, 3.0]), spin_scale=10.0)
        self.assertAlmostEqual(own["omega"][-1], 2 * (1 - np.exp(-1)), delta=1e-7)

    def test_the_lean_follows_from_the_load(self):
        load = ring.RingStack(radii=[R], a=[[0.47, 0]], b=[[0, 0.1]], tilt=(0.01, 0.02))
        self.assertAlmostEqual(load.lean_torque, -0.01 * load.moment[0] - 0.02 * load.moment[1], delta=1e-16)
        motion = ring.Motion()
        self.assertAlmostEqual(ring.answer(load, motion).torque_at_rest, mu * load.moment[0] + load.lean_torque, delta=1e-15)
        self.assertAlmostEqual(load.rotated(0.3).lean_torque, load.lean_torque, delta=1e-16)

    def test_laws(self):
        load = ring.RingStack.first_harmonic(normal_force=N, moment=(0.02, 0), radius=R)

        class Constant(ring.FrictionLaw):
            def coefficient(self, slip_speed):
                return mu
        for law in (ring.coulomb(mu), Constant(), ring.Stribeck(static=mu, kinetic=mu, decay_speed=0.1)):
            np.testing.assert_allclose(ring.wrench(load, v, [1.0, -5.0], law=law), ring.wrench(load, v, [1.0, -5.0], mu=mu), rtol=1e-10, atol=1e-13)


class Manners(unittest.TestCase):
    def test_refusals(self):
        for wrong, kind, words in (
            (lambda: ring.Motion(mass=-1), ring.BadInput, "mass"),
            (lambda: ring.Pressure(lambda r: -r, 0, R), ring.BadInput, "not negative"),
            (lambda: ring.Pressure(lambda r: 0 * r, 0, R), ring.BadInput, "positive somewhere"),
            (lambda: ring.Pressure.annulus(R, R), ring.BadInput, "increase"),
            (lambda: ring.wrench(ring.Pressure.disc(R), v, 1), ring.BadInput, "give mu"),
            (lambda: ring.wrench(ring.Pressure.disc(R), v, 1, mu=mu), ring.BadInput, "normal_force"),
            (lambda: ring.wrench(LimitSurface.stack, v, 1, mu=mu, normal_force=N), ring.BadInput, "its own normal force"),
            (lambda: ring.wrench(LimitSurface.stack, -v, 1, mu=mu), ring.BadInput, "negative"),
            (lambda: ring.wrench(LimitSurface.stack, v, 1, mu=-mu), ring.BadInput, ">= 0"),
            (lambda: ring.wrench(ring.SelfConsistentRing(motion=ring.Motion()), 1.0, 1), ring.BadInput, "own motion"),
            (lambda: ring.wrench(ring.SelfConsistentRing(motion=ring.Motion()), 0.0, 1, direction=1.0), ring.BadInput, "direction"),
            (lambda: ring.wrench(LimitSurface.stack, v, 1j, mu=mu), ring.BadInput, "complex"),
            (lambda: ring.wrench(LimitSurface.stack, v, np.array(["2026-01-01"], "datetime64[D]"), mu=mu), ring.BadInput, "datetime64"),
            (lambda: ring.Patch([0, 1], 0, [-1, 2]), ring.BadInput, "pulls"),
            (lambda: ring.Pressure.disc("wide"), ring.BadInput, "Pressure.disc got (str)"),
            (lambda: ring.RingStack(1, 2, 3), ring.BadInput, "RingStack got"),
            (lambda: ring.Stribeck(static="high", kinetic=0.2, decay_speed=0.1), ring.BadInput, "Stribeck"),
            (lambda: ring.SelfConsistentRing(motion=3), ring.BadInput, "SelfConsistentRing got"),
            (lambda: ring.kernels(1.0, 1.0, 2.5), ring.BadInput, "integer"),
            (lambda: ring.answer(LimitSurface.stack, 3), ring.BadInput, "give a Motion"),
            (lambda: ring.answer(LimitSurface.stack, ring.Motion(), grip_torque=[1]), ring.BadInput, "grip torque"),
            (lambda: ring.SelfConsistentRing(motion=ring.Motion(), closure="open"), ring.BadInput, "paper, hand or full"),
            (lambda: ring.limit_surface(LimitSurface.stack, about="rim"), ring.BadInput, "centre of pressure"),
            (lambda: ring.limit_surface(LimitSurface.stack).pade(), ring.BadInput, "Pressure"),
            (lambda: ring.limit_surface(ring.SelfConsistentRing(motion=ring.Motion())), ring.BadInput, "load(omega)"),
            (lambda: ring.Motion(mass="250 g"), ValueError, "250 g"),
            (lambda: ring.Motion(mas=0.3), TypeError, "as_dict"),
            (lambda: ring.answer(lambda w: 1.0, ring.Motion()), ring.BadInput, "returns a RingStack"),
            (lambda: ring.answer(LimitSurface.stack), ring.BadInput, "give a Motion"),
        ):
            with self.assertRaises(kind) as caught:
                wrong()
            self.assertIn(words, str(caught.exception))
        self.assertTrue(issubclass(ring.BadInput, ValueError) and issubclass(ring.Tipping, ring.NoBalance))

    def test_exceptions_of_a_function_propagate(self):
        with self.assertRaises(ZeroDivisionError):
            ring.answer(lambda w: 1 / 0, ring.Motion())

    def test_shapes(self):
        self.assertEqual(ring.wrench(LimitSurface.stack, v, np.zeros((3, 1)) + np.ones(4), mu=mu).torque.shape, (3, 4))
        self.assertEqual(ring.wrench(ring.Pressure.disc(R), v, 1.0, mu=mu, normal_force=N).torque.shape, ())
        self.assertEqual(ring.kernels(np.ones((2, 3)), 1.0, 4)[1].shape, (2, 3, 5))

    def test_shapes_and_types_of_arrays_are_kept(self):
        load, disc = LimitSurface.stack, ring.Pressure.disc(R)
        masked = ring.wrench(load, v, np.ma.masked_array([1.0, 2.0, 3.0], [False, True, False]), mu=mu).torque
        np.testing.assert_array_equal(np.isnan(masked), [False, True, False])
        np.testing.assert_allclose(masked[::2], ring.wrench(load, v, [1.0, 3.0], mu=mu).torque, rtol=1e-15)
        self.assertTrue(np.isnan(ring.kernels(np.nan, 1.0, 2)).all())
        found = ring.wrench(disc, v, [1.0, 9.0], mu=[[0.1], [0.3]], normal_force=[2.0, 5.0])
        for i, one in enumerate((0.1, 0.3)):
            for k, (omega, force) in enumerate(((1.0, 2.0), (9.0, 5.0))):
                alone = ring.wrench(disc, v, omega, mu=one, normal_force=force)
                np.testing.assert_allclose([part[i, k] for part in found], alone, rtol=1e-14, atol=1e-18)
        p = np.ma.masked_array(np.ones((3, 64)), np.eye(3, 64, dtype=bool))
        self.assertRaises(ring.BadInput, ring.stack_from_pressure, np.linspace(0.02, 0.03, 3), np.arange(64) * 2 * np.pi / 64, p)

    def test_a_pressure_of_one_radius_at_a_time(self):
        one = ring.Pressure(lambda r: 2.0 if r < R else 0.0, 0, R)  # a function of scalars only
        self.assertAlmostEqual(one.mean_power(2) / (R * R / 2), 1, delta=1e-13)
        with self.assertRaises(ZeroDivisionError):
            ring.Pressure(lambda r: 1 / 0, 0, R)

    def test_texts_contain_the_numbers(self):
        for one, words in ((LimitSurface.stack, "2 rings"), (ring.Pressure.disc(R), "0.03"), (ring.Patch([0, 1], 0, 1), "2 points"),
                           (ring.limit_surface(ring.Pressure.disc(R)), "arm = 0.02 m"), (ring.coulomb(0.3), "0.3"),
                           (ring.SelfConsistentRing(motion=ring.Motion(), closure="hand"), "hand")):
            self.assertIn(words, repr(one))

    def test_liquid(self):
        """A filled glass equals an empty one of the same mass with the liquid's centre of mass at its metacentre."""
        glass = dict(liquid_mass=0.15, liquid_density=1000.0, bowl_radius=0.03, bowl_height=0.09)
        filled = ring.Motion(mass=0.15, centre_of_mass_height=0.08, **glass)
        h = 0.15 / (1000 * np.pi * 0.03**2)
        slope = 0.35**2 / 0.15 / 9.81
        metacentre = 0.09 + h / 2 + 0.03**2 / (4 * h) * (1 + slope**2 / 2)
        z = (0.08 + metacentre) / 2
        empty = ring.Motion(mass=0.3, centre_of_mass_height=z, force_offset=0.03 - z)
        spins = [ring.answer(ring.SelfConsistentRing(motion=m)).omega for m in (filled, empty)]
        self.assertAlmostEqual(spins[0] / spins[1], 1, delta=1e-12)
        self.assertEqual(filled.replace(liquid_mass=0.1).bowl_radius, 0.03)
        self.assertRaises(ring.BadInput, filled.replace, bowl_depth=0.05)

    def test_pickles(self):
        one = pickle.loads(pickle.dumps(LimitSurface.stack))
        np.testing.assert_array_equal(one.a, LimitSurface.stack.a)
        self.assertEqual(pickle.loads(pickle.dumps(ring.Motion(mass=0.2))).mass, 0.2)
        body = ring.SelfConsistentRing(motion=ring.Motion(mass=0.2), closure="hand", radius=0.025)
        for one in (ring.Pressure.hertz(R), ring.Pressure.annulus(0.01, R), ring.Pressure(np.ones_like, 0, R), ring.coulomb(0.2), body,
                    ring.Patch([0, 1], 0, 1), ring.limit_surface(ring.Pressure.disc(R), n=3)):
            self.assertEqual(repr(pickle.loads(pickle.dumps(one))), repr(one))
        self.assertEqual(ring.answer(pickle.loads(pickle.dumps(body))), ring.answer(body))

    def test_a_table(self):
        r, theta = np.linspace(0.02, 0.03, 5), np.arange(64) * 2 * np.pi / 64
        p = 1e3 * (1 + 0.3 * np.cos(theta) + 0.1 * np.sin(2 * theta)) * np.ones((5, 1))
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("r,theta,p\n" + "".join(f"{a!r},{b!r},{float(p[i, k])!r}\n" for i, a in enumerate(r.tolist()) for k, b in enumerate(theta.tolist())))
            file.flush()
            load = ring.stack_from_csv(file.name, n_max=4)
        np.testing.assert_allclose(load.a, ring.stack_from_pressure(r, theta, p, n_max=4).a, rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(load.a[:, 1] / load.a[:, 0], 0.3, rtol=1e-12)
        np.testing.assert_allclose(load.b[:, 2] / load.a[:, 0], 0.1, rtol=1e-12)
        self.assertAlmostEqual(load.normal_force, 1e3 * np.pi * (0.03**2 - 0.02**2), delta=1e-3)

    def test_examples_of_the_docstrings(self):
        self.assertEqual(doctest.testmod(ring).failed, 0)

    def test_the_stubs_name_the_classes_members_and_arguments_of_the_module(self):
        with open(os.path.join(os.path.dirname(ring.__file__), "_ring.pyi"), encoding="utf-8") as file:
            stubs = {one.name: one for one in ast.parse(file.read()).body if isinstance(one, ast.ClassDef)}
        classes = {name: one for name, one in vars(ring._ring).items() if isinstance(one, type) and name != "Friction"}
        self.assertEqual(set(stubs), set(classes))
        for name, stub in stubs.items():
            functions = {one.name: one.args for one in stub.body if isinstance(one, ast.FunctionDef)}
            members = {one.target.id for one in stub.body if isinstance(one, ast.AnnAssign)} | set(functions)
            if issubclass(classes[name], Exception):
                self.assertEqual([base.id for base in stub.bases], [classes[name].__base__.__name__])
                continue
            self.assertEqual({key for key in members if key[0] != "_"}, {key for key in vars(classes[name]) if key[0] != "_"}, name)
            for key, arguments in functions.items():
                given = re.findall(r"(\w+): ", (getattr(classes[name], key).__doc__ or "").partition("\n")[0])
                expected = [one.arg for one in arguments.args + arguments.kwonlyargs]
                self.assertTrue(not given or [one for one in given if one != "self"] == [one for one in expected if one != "self"],
                                (name, key, given, expected))

    def test_interruption(self):
        self.assertTrue(is_stopped(
            "import numpy as np\nfrom stemware import ring\n"
            "load = ring.RingStack.first_harmonic(normal_force=1, moment=(0.01, 0), radius=0.03)",
            "while True: ring.wrench(load, 0.35, np.linspace(-1, 1, 2_000_000), mu=0.3)", 1.5))

    def test_import_loads_no_finite_elements(self):
        code = "import stemware\nassert 'deal' not in open('/proc/self/maps').read()\n"
        subprocess.run([sys.executable, "-c", code], check=True)


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "1"
    unittest.main()
