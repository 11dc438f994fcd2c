"""The Coulomb ring: loads, friction over numpy arrays, limit surfaces, the terminal spin, free sliding.

SI units. Slip frame: x along the direction of travel, y to its left, z up; spins and angles counter-clockwise. A bad value
raises BadInput, physics without an answer NoBalance or a class derived from it (Tipping, NoTerminalSpin, BalanceLost).

>>> disc = Pressure.disc(0.03)
>>> round(float(-wrench(disc, 0.0, 5.0, mu=0.3, normal_force=3.0).torque) / (0.3 * 3.0 * 0.03), 12)   # 2/3 mu N R
0.666666666667
"""
from collections import namedtuple

import numpy as np

from . import _ring
from ._ring import (BadInput, BalanceLost, FrictionLaw, Motion, NoBalance, NoTerminalSpin, Pressure,  # noqa: F401
                    RingStack, SelfConsistentRing, Stribeck, Tipping)

Wrench = namedtuple("Wrench", "force_x force_y torque")
Answer = namedtuple("Answer", "omega stable held torque_slope time_constant torque_at_rest spin_scale all")


RingStack.__reduce__ = lambda self: (_stack, (self.radii, self.a, self.b, self.tilt))
Pressure.hertz = staticmethod(lambda radius: Pressure(lambda r: np.sqrt(np.maximum(0, (radius - r) * (radius + r))), 0, radius))


def _stack(radii, a, b, tilt):
    return RingStack(radii=radii, a=a, b=b, tilt=tilt)


def coulomb(mu):
    """Law with the same coefficient at every slip speed."""
    return Stribeck(static=mu, kinetic=mu, decay_speed=1.0)


def _columns(rows):
    return {name: np.ascontiguousarray(rows[name]) for name in rows.dtype.names}


def _broadcast(*arrays):
    return [np.array(one, float, order="C") for one in np.broadcast_arrays(*arrays)]  # ascontiguousarray makes 0-d 1-d


def kernels(rim_speed, speed, n_max):
    """P_n, K_n, U_n at eps = rim_speed / speed, n = 0...n_max: three arrays (..., n_max + 1).

    >>> P, K, U = kernels(0.0, 1.0, 2)
    >>> [round(float(u / (2 * np.pi)), 12) + 0.0 for u in U]
    [1.0, 0.0, 0.0]
    """
    rim_speed, speed = _broadcast(rim_speed, speed)
    return np.moveaxis(_ring.kernels(rim_speed, speed, n_max).reshape(*speed.shape, n_max + 1, 3), -1, 0)


def stack_from_pressure(r, theta, p, n_max=16, weights=None):
    """RingStack of a pressure p[i, k] [Pa] at radii r[i] [m] and angles theta[k] [rad], evenly spaced over a turn from 0.

    weights [m]: of the radii, trapezoids unless given. The rings show one by one where |omega| r_i = v: an annulus of 21
    rings has a torque that is wrong by up to 2e-4 mu N R. The stack of every second ring, stack_from_pressure(r[::2], theta,
    p[::2]), tells the size of that error. For a pressure that is the same all round use Pressure, which is exact.
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
    """RingStack of a table with the columns r [m], theta [rad] and p [Pa] (a header names them): a full grid, in any order."""
    table = np.genfromtxt(file, delimiter=",", names=True)
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
    """Friction (T_x, T_y, tau_z) [N, N, N m] of the table about the load's centre, arrays that broadcast.

    load: RingStack (with mu or a law; it may travel in a direction [rad] of its frame), Pressure (with mu and normal_force
    [N]) or SelfConsistentRing (which has its own motion: of the arguments only omega counts). speed >= 0 [m/s], omega [rad/s].
    """
    if isinstance(load, SelfConsistentRing):
        return Wrench(*np.moveaxis(load.wrench(np.asarray(omega, float)), -1, 0))
    if mu is None and law is None:
        raise BadInput("the friction is not given; give mu or, for a RingStack, a law")
    if isinstance(load, Pressure):
        if law is not None:
            raise BadInput("a Pressure takes mu; give a RingStack for a law")
        return _friction(_ring.Friction(load, mu, normal_force, 1.0, 1.0, 0.0), speed, 0.0, omega)
    friction = _ring.Friction(load, coulomb(mu) if law is None else law)
    return _friction(friction, speed * np.cos(direction), speed * np.sin(direction), omega)


class LimitSurface:
    """Friction in all slips of one direction, for mu N = 1: see limit_surface().

    angle (n,): of the slip, v = cos(angle), omega R = sin(angle); force, across (n,): along and across the slip's direction,
    over mu N; torque (n,): about the reference point, over mu N times arm; arm [m]: torque of pure spin over mu N; R = radius.
    """

    def __init__(self, angle, force, across, torque, arm, radius, pressure):
        self.angle, self.force, self.across, self.torque = angle, force, across, torque
        self.arm, self.radius, self._pressure = arm, radius, pressure

    def _slip(self):
        at_end = np.abs(np.abs(self.angle) - np.pi / 2) < 1e-12
        return np.where(at_end, 0, np.cos(self.angle)), np.sin(self.angle)

    def ellipsoid(self):
        """(force, torque) on f^2 + t^2 = 1 that dissipates most in the same slips: the elliptic cone that MuJoCo, Drake's
        limit surfaces and most planners take, at one normal force."""
        v, u = self._slip()
        u = self.arm / self.radius * u
        return v / np.hypot(v, u), u / np.hypot(v, u)

    def pade(self, order=1):
        """(force, torque) by Contensou-Pade forms of a Pressure, with the exact slopes at pure spin and pure sliding.

        order 1: f = v / (v + p u), t = u / (u + q v), u = |omega| R (Zhuravlev 1998; Hertz: p = 8 / (3 pi), q = 15 pi / 16).
        order 2: f = (v^2 + b c v u) / (v^2 + b c v u + b u^2) and t likewise, with the exact curvature at the other end too.
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
        """How far wrenches (force, torque) lie beyond the surface, as a share of the way to it from zero (negative: inside)."""
        way = np.arctan2(self.torque, self.force)
        order = np.argsort(way)
        return np.hypot(force, torque) / np.interp(np.arctan2(torque, force), way[order],
                                                   np.hypot(self.force, self.torque)[order]) - 1


def limit_surface(load, n=361, about="axis", direction=0.0):
    """LimitSurface of a RingStack or Pressure, from pure clockwise to pure counter-clockwise spin.

    about: reference point of velocity and torque, "axis", "centre of pressure" or (x, y) [m]; direction [rad]: of its
    velocity in the load's frame. A load with a first harmonic has another curve in each direction.

    >>> s = limit_surface(Pressure.hertz(0.03))
    >>> round(s.arm / 0.03 * 16 / (3 * np.pi), 9), round(float(s.force[180]), 12)
    (1.0, 1.0)
    """
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
    """What _ring.answer() finds about a load of answer()."""
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
    asked = _ring.AskedLoad(at if callable(load) else load)
    return _ring.answer(asked, motion, grip_torque, all, times)


def answer(load, motion=None, grip_torque=0.0, all=True):
    """The spin reached from rest, Answer(omega, ...), and in its field all every balance within 1.5 v/R of rest (dicts).

    load: RingStack (frozen: it does not react to the spin; its lean torque counts), SelfConsistentRing (has its motion) or a
    function of omega [rad/s] that returns a RingStack. Options: grip_torque [N m] of the fingers, all=False (quicker).
    Raises NoTerminalSpin, Tipping, BalanceLost (with last_spin).

    >>> paper = SelfConsistentRing(motion=Motion(), closure="paper", radius=0.03)
    >>> round(answer(paper).omega, 9)
    -3.120558702
    """
    spin, spins, at_rest, scale, _ = _ask(load, motion, grip_torque, all)
    [spin], spins = ([dict(zip(some.dtype.names, one)) for one in some.tolist()] for some in (spin, spins))
    return Answer(**spin, torque_at_rest=at_rest, spin_scale=scale, all=spins)


def spin_up(load, times, motion=None, grip_torque=0.0):
    """omega(t) from rest at times [s] under what answer() takes: dict of arrays time, yaw_angle, omega; NaN beyond a fall."""
    return _columns(_ask(load, motion, grip_torque, times=times)[-1])


def yaw_motion(torque, *, yaw_inertia, times, initial_spin=0.0, accuracy=1e-9, spin_scale):
    """time, yaw_angle, omega: dict of arrays at the times [s] from I d omega/dt = torque(time, yaw_angle, omega)."""
    return _columns(_ring.yaw_motion(torque, yaw_inertia, times, initial_spin, accuracy, spin_scale))


def slide(body, *, mu, mass, speed, omega, yaw_inertia=None, gravity=9.81, centre_of_mass_height=0.0, accuracy=1e-12):
    """Free sliding of a Pressure or RingStack from speed >= 0 and omega to the stop: dict of arrays time, x, y, yaw, speed,
    heading, omega, friction_loss, distance, and final_slip_ratio, the limit of omega R / v.

    yaw_inertia: mass spread like the weight unless given. A RingStack is held level: its load does not follow the friction.

    >>> round(1 / slide(Pressure.disc(0.03), mu=0.3, mass=0.3, speed=1.0, omega=20.0)["final_slip_ratio"], 10)
    0.6530017892
    """
    is_pressure = isinstance(body, Pressure)
    inertia = yaw_inertia or mass * (body.mean_power(2) if is_pressure else body.radius**2)
    if is_pressure:
        friction = _ring.Friction(body, mu, mass, inertia, gravity, centre_of_mass_height)
    else:
        scale = mass * gravity / body.normal_force
        friction = _ring.Friction(RingStack(radii=body.radii, a=body.a * scale, b=body.b * scale), coulomb(mu))
    states, final_slip_ratio = friction.slide(mass, inertia, body.radius, speed, omega, accuracy)
    return {**_columns(states), "final_slip_ratio": final_slip_ratio}
