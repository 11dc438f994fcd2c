"""The ring model: normal loads on concentric rings, their friction over numpy arrays, limit surfaces, and the terminal spin
of a glass.

SI units. Slip frame: x along the direction of travel, y to its left, z up. Spins and angles are positive counter-clockwise,
seen from above. The rim speed is |omega| R, the slip ratio omega R / v. A value that is not allowed raises BadInput. A load or
a spin that does not exist raises NoBalance or a class derived from it: Tipping, NoTerminalSpin, BalanceLost.

>>> disc = Pressure.disc(0.03)
>>> round(float(-wrench(disc, 0.0, 5.0, mu=0.3, normal_force=3.0).torque) / (0.3 * 3.0 * 0.03), 12)   # 2/3 mu N R
0.666666666667
"""
import functools
from collections import namedtuple

import numpy as np

from . import _ring
from ._ring import (BadInput, BalanceLost, FrictionLaw, Motion, NoBalance, NoTerminalSpin, Pressure,  # noqa: F401
                    RingStack, Stribeck, Tipping)

Wrench = namedtuple("Wrench", "force_x force_y torque")
Answer = namedtuple("Answer", "omega stable held torque_slope time_constant torque_at_rest spin_scale all")


RingStack.__reduce__ = lambda self: (RingStack, (self.radii, self.a, self.b, self.tilt))
RingStack.__repr__ = lambda self: f"RingStack({self.radii.size} rings, {self.normal_force:.6g} N)"
Motion.replace = lambda self, **values: Motion(**{**self.as_dict(), **values})
Motion.__reduce__ = lambda self: (functools.partial(Motion, **self.as_dict()), ())
Motion.__repr__ = lambda self: f"Motion(**{self.as_dict()})"
Pressure.hertz = staticmethod(lambda radius: Pressure(lambda r: np.sqrt(np.maximum(0, (radius - r) * (radius + r))), 0, radius))


class SelfConsistentRing(_ring.SelfConsistentRing):
    """Rigid ring whose load, friction and hand force balance at every spin.

    closure: moments in the balance: "paper" (centripetal part of the hand force), "hand" (whole hand force), "full" (friction
    too). radius [m]. The load has the harmonics 0 and 1: exact for a linear support in full contact.
    """

    def __init__(self, *, motion, closure="full", radius=0.03):
        super().__init__(motion, closure, radius)
        self.motion, self.radius = motion, radius


def coulomb(mu):
    """Returns Coulomb's law: the coefficient mu at every slip speed."""
    return Stribeck(static=mu, kinetic=mu, decay_speed=1.0)


def _columns(rows):
    return {name: np.ascontiguousarray(rows[name]) for name in rows.dtype.names}


def _broadcast(*arrays):
    return [np.array(one, float, order="C") for one in np.broadcast_arrays(*arrays)]  # ascontiguousarray makes 0-d 1-d


def kernels(rim_speed, speed, n_max):
    """Returns the friction kernels P_n, K_n, U_n of eps = rim_speed / speed for n = 0...n_max, arrays (..., n_max + 1).

    P_n(eps) = int_0^{2 pi} sqrt(1 + eps^2 - 2 eps cos psi) cos(n psi) dpsi; K_n = -P_n' belongs to the torque, U_n = P_n + eps
    K_n to the force against the travel. rim_speed, speed >= 0 [m/s]: arrays that broadcast, not both zero.

    >>> P, K, U = kernels(0.0, 1.0, 2)
    >>> [round(float(u / (2 * np.pi)), 12) + 0.0 for u in U]
    [1.0, 0.0, 0.0]
    """
    rim_speed, speed = _broadcast(rim_speed, speed)
    return np.moveaxis(_ring.kernels(rim_speed, speed, n_max).reshape(*speed.shape, n_max + 1, 3), -1, 0)


def stack_from_pressure(r, theta, p, n_max=16, weights=None):
    """Returns the RingStack of a pressure p[i, k] [Pa] at radii r[i] [m] and angles theta[k] [rad], the angles evenly spaced
    from 0 over one turn.

    n_max: highest harmonic of the stack. weights [m]: quadrature weights of the radii, by default those of the trapezoidal
    rule. The torque has a kink where |omega| r_i = v: 21 rings instead of an annulus give an error of up to 2e-4 mu N R. The
    difference from a stack of every second ring, stack_from_pressure(r[::2], theta, p[::2]), estimates that error. For an
    axisymmetric pressure use Pressure, which has no such error.
    """
    r, theta, p = np.asarray(r, float), np.asarray(theta, float), np.asarray(p, float)
    even = np.arange(theta.size) * 2 * np.pi / max(theta.size, 1)
    if p.shape != (r.size, theta.size) or 2 * n_max >= theta.size or np.abs(theta - even).max() > 1e-6:
        raise BadInput(f"the pressure has the shape {p.shape} for {r.size} radii and {theta.size} angles; give (radii, angles), "
                       f"with more than {2 * n_max} angles evenly spaced from 0 over one turn for {n_max} harmonics")
    if weights is None:
        if r.size < 2 or (np.diff(r) <= 0).any():
            raise BadInput("the radii do not increase; give at least two in ascending order, or their weights")
        weights = np.convolve(np.diff(r), [0.5, 0.5])
    c = np.fft.rfft(p, axis=1)[:, :n_max + 1] * (r * weights)[:, None]
    a, b = 2 * c.real / theta.size, -2 * c.imag / theta.size
    a[:, 0], b[:, 0] = a[:, 0] / 2, 0
    return RingStack(radii=r, a=a, b=b)


def stack_from_csv(file, n_max=16):
    """Returns the RingStack of a CSV file with the columns r [m], theta [rad] and p [Pa], named in its first line like those of
    the program's footprint.csv: one row for each pair of radius and angle, in any order; see stack_from_pressure()."""
    table = np.genfromtxt(file, delimiter=",", names=True)
    table.dtype.names = [name.partition("_")[0].replace("pressure", "p") for name in table.dtype.names]
    if not {"r", "theta", "p"} <= set(table.dtype.names or ()):
        raise BadInput(f"{file} has the columns {', '.join(table.dtype.names or ())}; name them r, theta and p")
    (r, i), (theta, k) = (np.unique(table[name], return_inverse=True) for name in ("r", "theta"))
    if table.size != r.size * theta.size or np.unique(i * theta.size + k).size != table.size:
        raise BadInput(f"{file} has {table.size} rows for {r.size} radii and {theta.size} angles; give one row for each pair")
    p = np.empty((r.size, theta.size))
    p[i, k] = table["p"]
    return stack_from_pressure(r, theta, p, n_max)


def _friction(friction, *slip):
    return Wrench(*np.moveaxis(friction.wrench(*_broadcast(*slip)), -1, 0))


def wrench(load, speed, omega, mu=None, law=None, normal_force=1.0, direction=0.0):
    """Returns the friction of the table on the load: Wrench(force_x, force_y, torque) [N, N, N m], the torque about the load's
    centre.

    load: a RingStack, with mu or a law; a Pressure, with mu and normal_force [N]; or a SelfConsistentRing, whose motion gives
    speed and friction coefficient (only omega is used). speed >= 0 [m/s] and omega [rad/s]: arrays that broadcast, not both
    zero. direction [rad]: of the velocity in the frame of a RingStack; the force has components in that frame.
    """
    if isinstance(load, SelfConsistentRing):
        return _friction(_ring.Friction(load), 0.0, 0.0, omega)
    if mu is None and law is None:
        raise BadInput("the friction is not given; give mu or, for a RingStack, a law")
    if isinstance(load, Pressure):
        if law is not None:
            raise BadInput("a Pressure takes mu; give a RingStack for a law")
        return _friction(_ring.Friction(load, mu * normal_force), speed, 0.0, omega)
    friction = _ring.Friction(load, coulomb(mu) if law is None else law)
    return _friction(friction, speed * np.cos(direction), speed * np.sin(direction), omega)


class LimitSurface:
    """Limit surface for one direction of travel, in arrays (n,): see limit_surface().

    angle [rad]: slip with v = cos(angle), omega R = sin(angle). force, across: friction against the direction of travel and
    perpendicular to it, over mu N. torque: against the spin, about the reference point, over mu N arm. arm [m]: torque of pure
    spin over mu N. radius [m]: R.
    """

    def __init__(self, angle, force, across, torque, arm, radius, pressure):
        self.angle, self.force, self.across, self.torque = angle, force, across, torque
        self.arm, self.radius, self._pressure = arm, radius, pressure

    def _slip(self):
        at_end = np.abs(np.abs(self.angle) - np.pi / 2) < 1e-12
        return np.where(at_end, 0, np.cos(self.angle)), np.sin(self.angle)

    def ellipsoid(self):
        """Returns (force, torque) of the ellipsoid f^2 + t^2 = 1 in the same slips, by maximum dissipation. The ellipsoid is
        the section of MuJoCo's elliptic cone at one normal force; Drake and most planners of pushing use it too."""
        v, u = self._slip()
        u = self.arm / self.radius * u
        return v / np.hypot(v, u), u / np.hypot(v, u)

    def pade(self, order=1):
        """Returns (force, torque) of the Contensou-Pade form for a Pressure, with its exact slopes at pure spin and at pure
        sliding.

        order 1: f = v / (v + p u), t = u / (u + q v), u = |omega| R (Zhuravlev 1998; Hertz: p = 8 / (3 pi), q = 15 pi / 16).
        order 2: f = (v^2 + b c v u) / (v^2 + b c v u + b u^2), t likewise; exact curvatures at pure sliding (f) and spin (t).
        """
        if self._pressure is None:
            raise BadInput("Pade forms are those of a load that is the same all round; give a Pressure")
        v, u = self._slip()
        sign, u = np.sign(u), np.abs(u)
        inverse, square = (self._pressure.mean_power(n) for n in (-1, 2))
        slope_f, slope_t = inverse * self.radius / 2, square / (2 * self.radius * self.arm)
        if order == 1:
            return v / (v + u / slope_f), sign * u / (u + v / slope_t)
        b, d = square / (4 * self.radius**2), inverse * self.radius**2 / (4 * self.arm)
        f, t = v * v + b * slope_f * v * u, u * u + d * slope_t * v * u
        return f / (f + b * u * u), sign * t / (t + d * v * v)

    def excess(self, force, torque):
        """Returns the relative distance of points (force, torque) beyond the surface, on the ray from 0; negative inside."""
        way = np.arctan2(self.torque, self.force)
        order = np.argsort(way)
        return np.hypot(force, torque) / np.interp(np.arctan2(torque, force), way[order],
                                                   np.hypot(self.force, self.torque)[order]) - 1


def limit_surface(load, n=361, about="axis", direction=0.0):
    """Returns the LimitSurface of a RingStack or Pressure: n slips from pure clockwise to pure counter-clockwise spin.

    about: reference point of velocity and torque: "axis", "centre of pressure" or (x, y) [m]. direction [rad]: of the point's
    velocity in the load's frame. A load with a first harmonic has a different curve for each direction.

    >>> s = limit_surface(Pressure.hertz(0.03))
    >>> round(s.arm / 0.03 * 16 / (3 * np.pi), 9), round(float(s.force[180]), 12)
    (1.0, 1.0)
    """
    if not isinstance(load, (RingStack, Pressure)):
        raise BadInput(f"the load is {load!r}; give a Pressure or a RingStack, for instance SelfConsistentRing.load(omega)")
    radius, angle = load.radius, np.linspace(-np.pi / 2, np.pi / 2, n)
    v = np.where(np.abs(np.abs(angle) - np.pi / 2) < 1e-12, 0, np.cos(angle))
    omega = np.sin(angle) / radius
    if isinstance(load, Pressure):
        if isinstance(about, str) is False and np.hypot(*about) > 0:
            raise BadInput("a Pressure has its centre of pressure on the axis; give a RingStack for another point")
        T, arm = wrench(load, v, omega, mu=1.0), -float(wrench(load, 0.0, 1.0, mu=1.0).torque)
        return LimitSurface(angle, -T.force_x, -T.force_y, -T.torque / arm, arm, radius, load)
    moment, N = load.moment, load.normal_force
    points = {"axis": (0.0, 0.0), "centre of pressure": (-moment[1] / N, moment[0] / N)}
    if isinstance(about, str) and about not in points:
        raise BadInput(f"the reference point is \"{about}\"; give axis, centre of pressure or (x, y)")
    x, y = points[about] if isinstance(about, str) else about
    c, s = np.cos(direction), np.sin(direction)

    def at(v, omega):  # the centre moves with the point's velocity and omega times the way from the point to it
        v_x, v_y = c * v + omega * y, s * v - omega * x
        T = _friction(_ring.Friction(load, coulomb(1.0)), v_x, v_y, omega)
        torque = T.torque - (x * T.force_y - y * T.force_x)
        return -(c * T.force_x + s * T.force_y) / N, -(c * T.force_y - s * T.force_x) / N, -torque / N

    arm = float(at(0.0, 1.0)[2])
    force, across, torque = at(v, omega)
    return LimitSurface(angle, force, across, torque / arm, arm, radius, None)


def _ask(load, motion, grip_torque, all=False, times=()):
    """Returns _ring.answer() for the arguments of answer()."""
    def at(omega):
        found = load(omega)
        if not isinstance(found, RingStack):
            raise BadInput(f"the load at {omega} rad/s is {found!r}; give a function that returns a RingStack")
        return found
    if not isinstance(load, (RingStack, SelfConsistentRing)) and not callable(load):
        raise BadInput(f"the load is {load!r}; give a RingStack, a SelfConsistentRing or a function of omega")
    motion = motion or getattr(load, "motion", None)
    if motion is None:
        raise BadInput("the load does not say how the glass moves; give a Motion")
    return _ring.answer(at if callable(load) else load, motion, grip_torque, all, times)


def answer(load, motion=None, grip_torque=0.0, all=True):
    """Returns the terminal spin that the glass reaches from rest.

    load: a RingStack, the same at every spin; a SelfConsistentRing, which has its own motion; or a function of omega [rad/s]
    that returns a RingStack. The lean torque of a RingStack is included. grip_torque [N m]: of the fingers, against the spin.

    Answer: omega [rad/s]; stable, held (True if the fingers stop the glass); torque_slope, d torque / d omega [N m s];
    time_constant [s]; torque_at_rest [N m], without the grip; spin_scale, v / R [rad/s]; all: a list of dicts of all balances
    within 1.5 v / R of rest, empty with all=False, which is faster. Raises NoTerminalSpin, Tipping, BalanceLost (last_spin).

    >>> paper = SelfConsistentRing(motion=Motion(), closure="paper", radius=0.03)
    >>> round(answer(paper).omega, 9)
    -3.120558702
    """
    spin, spins, at_rest, scale, _ = _ask(load, motion, grip_torque, all)
    [spin], spins = ([dict(zip(some.dtype.names, one)) for one in some.tolist()] for some in (spin, spins))
    return Answer(**spin, torque_at_rest=at_rest, spin_scale=scale, all=spins)


def spin_up(load, times, motion=None, grip_torque=0.0):
    """Returns the spin-up from rest at equally spaced times [s], a dict of arrays time, yaw_angle [rad] and omega [rad/s]; NaN
    after the glass has tipped. The other arguments are those of answer()."""
    return _columns(_ask(load, motion, grip_torque, times=times)[-1])


def yaw_motion(torque, *, yaw_inertia, times, initial_spin=0.0, accuracy=1e-9, spin_scale):
    """Integrates yaw_inertia d omega/dt = torque(time, yaw_angle, omega) [N m]; returns a dict of arrays time, yaw_angle [rad]
    and omega [rad/s] at the increasing times [s].

    yaw_inertia [kg m^2]. accuracy: of the angle in rad, and of omega relative to spin_scale [rad/s], for instance v / R.
    """
    return _columns(_ring.yaw_motion(torque, yaw_inertia, times, initial_spin, accuracy, spin_scale))
