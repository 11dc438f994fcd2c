"""The ring model: normal loads on concentric rings, their friction over numpy arrays, limit surfaces, and the terminal spin
of a glass.

SI units. Slip frame: x along the direction of travel, y to its left, z up. Spins and angles are positive counter-clockwise,
seen from above. The rim speed is |omega| R, the slip ratio omega R / v. A value that is not allowed raises BadInput. A load or
a spin that does not exist raises NoBalance or a class derived from it: Tipping, NoTerminalSpin, BalanceLost.

>>> disc = Pressure.disc(0.03)
>>> round(float(-wrench(disc, 0.0, 5.0, mu=0.3, normal_force=3.0).torque) / (0.3 * 3.0 * 0.03), 12)   # 2/3 mu N R
0.666666666667
"""
from __future__ import annotations

import functools
import numbers
import os
import warnings
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from . import _ring
from ._ring import (BadInput, BalanceLost, FrictionLaw, Motion, NoBalance, NoTerminalSpin, Pressure,  # noqa: F401
                    RingStack, Tipping)

ArrayLike = Any  # numbers, sequences of them, arrays, masked arrays, columns of tables
Point = Union[str, Tuple[float, float]]


class Wrench(NamedTuple):
    """Friction of the table on a load: forces [N] and torque [N m]."""
    force_x: np.ndarray
    force_y: np.ndarray
    torque: np.ndarray


class Answer(NamedTuple):
    """Terminal spin that a glass reaches from rest, and all zeros of the torque: see answer()."""
    omega: float
    stable: bool
    held: bool
    torque_slope: float
    time_constant: float
    torque_at_rest: float
    spin_scale: float
    all: List[Dict[str, Any]]


class Curve(NamedTuple):
    """Approximation of a limit surface in the same slips: force over mu N, torque over mu N arm."""
    force: np.ndarray
    torque: np.ndarray


def _readable(function, name, skipped=1):
    """Returns the function with one-sentence errors instead of pybind11's signatures; `skipped` arguments (self) are not counted."""
    @functools.wraps(function)
    def call(*given, **named):
        try:
            return function(*given, **named)
        except TypeError as failure:
            if "incompatible" not in str(failure):
                raise
        kinds = [type(one).__name__ for one in given[skipped:]] + [f"{key}={type(one).__name__}" for key, one in named.items()]
        raise BadInput(f"{name} got ({', '.join(kinds)}), which it does not take; help(stemware.ring.{name}) has its arguments")
    return call


for _kind in (Motion, RingStack, Pressure, _ring.SelfConsistentRing, _ring.Stribeck):
    for _key, _member in list(vars(_kind).items()):
        if isinstance(_member, staticmethod):
            setattr(_kind, _key, staticmethod(_readable(_member.__func__, f"{_kind.__name__}.{_key}", 0)))
        elif _key == "__init__" or callable(_member) and _key[0] != "_":
            setattr(_kind, _key, _readable(_member, _kind.__name__ + ("" if _key == "__init__" else "." + _key)))


RingStack.__reduce__ = lambda self: (RingStack, (self.radii, self.a, self.b, self.tilt))
RingStack.__repr__ = lambda self: f"RingStack({self.radii.size} rings, {self.normal_force:.6g} N)"
Motion.replace = lambda self, **values: Motion(**{**self.as_dict(), **values})
Motion.__reduce__ = lambda self: (functools.partial(Motion, **self.as_dict()), ())
Motion.__repr__ = lambda self: f"Motion(**{self.as_dict()})"
_pressure = Pressure.__init__


def _init_pressure(self, p: Callable[[Any], Any], inner: float, outer: float) -> None:
    def at(radii):
        try:
            values = np.asarray(p(radii), float)
        except (TypeError, ValueError):  # p takes one radius at a time
            values = np.empty(0)
        return values if values.shape == radii.shape else np.array([float(p(one)) for one in radii.tolist()])
    _pressure(self, at, inner, outer)
    self._made = "", (p, inner, outer)


def _hertz(radius: float) -> Pressure:
    """Returns the pressure of a Hertzian contact."""
    return Pressure(lambda r: np.sqrt(np.maximum(0, (radius - r) * (radius + r))), 0, radius)


def _kept(name, make):
    """Returns the factory `make` of a Pressure, which then stores its arguments for pickle and repr."""
    @functools.wraps(make)
    def made(*given, **named):
        one = make(*given, **named)
        one._made = name, (*given, *named.values())
        return one
    return staticmethod(made)


def _made_again(name, given):
    return (getattr(Pressure, name) if name else Pressure)(*given)


Pressure.__init__ = _init_pressure
for _name, _make in (("ring", Pressure.ring), ("annulus", Pressure.annulus), ("disc", Pressure.disc), ("hertz", _hertz)):
    setattr(Pressure, _name, _kept(_name, _make))
Pressure.__reduce__ = lambda self: (_made_again, self._made)
Pressure.__repr__ = lambda self: f"{'.'.join(filter(None, ('Pressure', self._made[0])))}({', '.join(map(repr, self._made[1]))})"


class Stribeck(_ring.Stribeck):
    __doc__ = _ring.Stribeck.__doc__

    def __init__(self, *, static: float, kinetic: float, decay_speed: float, viscous: float = 0.0, decay_exponent: float = 2.0):
        self._given = dict(static=static, kinetic=kinetic, decay_speed=decay_speed, viscous=viscous, decay_exponent=decay_exponent)
        super().__init__(**self._given)

    def __reduce__(self):
        return functools.partial(Stribeck, **self._given), ()

    def __repr__(self):
        return f"Stribeck({', '.join(f'{key}={value!r}' for key, value in self._given.items())})"


class SelfConsistentRing(_ring.SelfConsistentRing):
    """Rigid ring whose load, friction and hand force balance at every spin.

    closure: moments in the balance: "paper" (centripetal part of the hand force), "hand" (whole hand force), "full" (friction
    too). radius [m]. The load has the harmonics 0 and 1: exact for a linear support in full contact.
    """

    def __init__(self, *, motion: Motion, closure: str = "full", radius: float = 0.03):
        super().__init__(motion, closure, radius)
        self.motion, self.closure, self.radius = motion, closure, radius

    def __reduce__(self):
        return functools.partial(SelfConsistentRing, motion=self.motion, closure=self.closure, radius=self.radius), ()

    def __repr__(self):
        return f"SelfConsistentRing(motion={self.motion!r}, closure={self.closure!r}, radius={self.radius!r})"


class Patch:
    """Normal forces [N] at the points (x, y) [m]: feet of a tripod, or the cells of a pressure image or a rectangle.

    x, y, force: arrays that broadcast. The friction is the sum over the points; a point at rest has none. radius [m]: R of a
    LimitSurface, the root mean square distance from the centre of pressure. moment: (M_x, M_y) about the origin [N m].

    >>> tripod = Patch(0.1 * np.cos([0, 2, 4]), 0.1 * np.sin([0, 2, 4]), 1.0)
    >>> round(float(-wrench(tripod, 0.0, 1.0, mu=0.5).torque), 12)   # mu N 0.1 m
    0.15
    """

    def __init__(self, x: ArrayLike, y: ArrayLike, force: ArrayLike):
        self.x, self.y, self.force = (one.ravel() for one in _broadcast(x, y, force))
        if not (np.isfinite([self.x, self.y, self.force]).all() and (self.force >= 0).all() and self.force.sum() > 0):
            raise BadInput("a point or a force of the patch is not finite or a force pulls; give finite points with forces >= 0 N, "
                           "at least one > 0")
        self.normal_force = float(self.force.sum())
        self.moment = np.array([self.force @ self.y, -self.force @ self.x])
        x_c, y_c = -self.moment[1] / self.normal_force, self.moment[0] / self.normal_force
        self.radius = float(np.sqrt(self.force @ ((self.x - x_c)**2 + (self.y - y_c)**2) / self.normal_force))

    def __repr__(self):
        return f"Patch({self.x.size} points, {self.normal_force:.6g} N)"

    def _friction(self, v_x, v_y, omega):
        out = np.zeros((*v_x.shape, 3))
        for x, y, force in zip(self.x, self.y, self.force):  # a loop saves memory: arrays of slips may be long
            slip_x, slip_y = v_x - omega * y, v_y + omega * x
            speed = np.hypot(slip_x, slip_y)
            share = np.divide(force, speed, out=np.zeros_like(speed), where=speed > 0)
            for i, part in enumerate((-slip_x, -slip_y, y * slip_x - x * slip_y)):
                out[..., i] += share * part
        return out


def coulomb(mu: float) -> Stribeck:
    """Returns Coulomb's law: the coefficient mu at every slip speed."""
    return Stribeck(static=mu, kinetic=mu, decay_speed=1.0)


def _columns(rows):
    return {name: np.ascontiguousarray(rows[name]) for name in rows.dtype.names}


def _array(values):
    """Returns an array of floats. Masked values become NaN; complex numbers, dates and texts are refused."""
    given = np.ma.asarray(values) if np.ma.isMaskedArray(values) else np.asarray(values)
    if given.dtype == object and all(isinstance(one, numbers.Real) or one is np.ma.masked for one in given.flat):
        given = given.astype(float)
    if given.dtype.kind not in "biuf":
        raise BadInput(f"an array has the type {given.dtype}; give real numbers in SI units")
    return np.ma.filled(given.astype(float), np.nan)


def _broadcast(*arrays):
    # np.ascontiguousarray would change the shape () of a number to (1,).
    return [np.array(one, order="C") for one in np.broadcast_arrays(*map(_array, arrays))]


def _of_numbers(n, function, *arrays):
    """Returns function(*arrays), (..., n), and NaN where an argument is NaN."""
    arrays = _broadcast(*arrays)
    known = ~np.isnan(arrays).any(axis=0)
    if known.all():
        return function(*arrays)
    out = np.full((*known.shape, n), np.nan)
    out[known] = function(*(one[known] for one in arrays))
    return out


def kernels(rim_speed: ArrayLike, speed: ArrayLike, n_max: int) -> np.ndarray:
    """Returns the friction kernels P_n, K_n, U_n of eps = rim_speed / speed for n = 0...n_max, arrays (..., n_max + 1).

    P_n(eps) = int_0^{2 pi} sqrt(1 + eps^2 - 2 eps cos psi) cos(n psi) dpsi; K_n = -P_n' belongs to the torque, U_n = P_n + eps
    K_n to the force against the travel. rim_speed, speed >= 0 [m/s]: arrays that broadcast, not both zero.

    >>> P, K, U = kernels(0.0, 1.0, 2)
    >>> [round(float(u / (2 * np.pi)), 12) + 0.0 for u in U]
    [1.0, 0.0, 0.0]
    """
    if not isinstance(n_max, numbers.Integral) or n_max < 0:
        raise BadInput(f"the highest harmonic is {n_max!r}; give an integer of 0 or more")
    n = int(n_max) + 1
    found = _of_numbers(3 * n, lambda *slip: _ring.kernels(*slip, n - 1), rim_speed, speed)
    return np.moveaxis(found.reshape(*found.shape[:-1], n, 3), -1, 0)


def stack_from_pressure(r: ArrayLike, theta: ArrayLike, p: ArrayLike, n_max: int = 16,
                        weights: Optional[ArrayLike] = None) -> RingStack:
    """Returns the RingStack of a pressure p[i, k] [Pa] at radii r[i] [m] and angles theta[k] [rad], the angles evenly spaced
    from 0 over one turn.

    n_max: highest harmonic of the stack. weights [m]: quadrature weights of the radii, by default the trapezoidal rule. The torque
    has a kink where |omega| r_i = v: 21 rings instead of an annulus give an error of up to 2e-4 mu N R. The difference from a
    stack of every second ring, stack_from_pressure(r[::2], theta, p[::2]), estimates the error. An axisymmetric Pressure has no
    such error.
    """
    r, theta, p = map(_array, (r, theta, p))
    if np.isnan(p).any():
        raise BadInput(f"{np.isnan(p).sum()} of {p.size} pressures are masked or NaN; give 0 where nothing touches")
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


def stack_from_csv(file: Union[str, os.PathLike], n_max: int = 16) -> RingStack:
    """Returns the RingStack of a CSV file with the columns r [m], theta [rad] and p [Pa], named in its first line as in the
    program's footprint.csv: one row for each pair of radius and angle, in any order; see stack_from_pressure()."""
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


def _reference_point(load, about):
    moment, N = getattr(load, "moment", (0.0, 0.0)), getattr(load, "normal_force", 1.0)
    points = {"axis": (0.0, 0.0), "centre of pressure": (-moment[1] / N, moment[0] / N)}
    if isinstance(about, str) and about not in points:
        raise BadInput(f"the reference point is \"{about}\"; give axis, centre of pressure or (x, y)")
    return points[about] if isinstance(about, str) else tuple(map(float, about))


def _moving(load, law, point, v_x, v_y, omega):
    """Returns the friction on a load of which `point` has the velocity (v_x, v_y): forces, and the torque about the point. Without
    a law mu = 1; a Pressure has the normal force 1 N."""
    x, y = point

    def at(v_x, v_y, omega):  # velocity of the axis = velocity of the point + omega x (vector from the point to the axis)
        v_x, v_y = v_x + omega * y, v_y - omega * x
        if isinstance(load, Pressure):
            one = _ring.Friction(load, 1.0).wrench(np.hypot(v_x, v_y), np.zeros_like(v_x), omega)
            heading = np.arctan2(v_y, v_x)
            return np.stack([one[..., 0] * np.cos(heading), one[..., 0] * np.sin(heading), one[..., 2]], axis=-1)
        if isinstance(load, Patch):
            return load._friction(v_x, v_y, omega)
        return _ring.Friction(load, law or coulomb(1.0)).wrench(v_x, v_y, omega)

    force_x, force_y, torque = np.moveaxis(_of_numbers(3, at, v_x, v_y, omega), -1, 0)
    return Wrench(force_x, force_y, torque - (x * force_y - y * force_x))


def wrench(load: Union[RingStack, Pressure, Patch, SelfConsistentRing], speed: ArrayLike, omega: ArrayLike,
           mu: Optional[ArrayLike] = None, law: Optional[FrictionLaw] = None, normal_force: Optional[ArrayLike] = None,
           direction: ArrayLike = 0.0, about: Point = "axis") -> Wrench:
    """Returns the friction of the table on the load: Wrench(force_x, force_y, torque) [N, N, N m].

    load: a RingStack, with mu or a law; a Patch, with mu; a Pressure, with mu and normal_force [N]; or a SelfConsistentRing,
    whose motion gives speed and friction. about: the reference point of velocity and torque: "axis", "centre of pressure" or
    (x, y) [m]. speed >= 0 [m/s] and omega [rad/s] are not both zero. direction [rad]: of the velocity in the frame of the load,
    which is also the frame of the forces. Arrays broadcast; NaN and masked values give NaN.
    """
    point = _reference_point(load, about)
    if isinstance(load, SelfConsistentRing):
        own = {"mu": mu, "law": law, "normal_force": normal_force, "direction": direction or None, "about": any(point) or None}
        given = [name for name, value in own.items() if value is not None]
        if given or not np.all(np.isin(_array(speed), [0.0, load.motion.orbit_speed])):
            raise BadInput(f"a SelfConsistentRing has its own motion, {load.motion.orbit_speed} m/s along x; leave out "
                           f"{', '.join(given) or 'the speed (0)'}, or give its load(omega)")
        return Wrench(*np.moveaxis(_of_numbers(3, lambda w: _ring.Friction(load).wrench(0 * w, 0 * w, w), omega), -1, 0))
    if not isinstance(load, (RingStack, Pressure, Patch)):
        raise BadInput(f"the load is {load!r}; give a RingStack, a Pressure, a Patch or a SelfConsistentRing")
    if (mu is None) == (law is None):
        raise BadInput("the friction is not given once; give mu or, for a RingStack, a law")
    if law is not None and not isinstance(load, RingStack):
        raise BadInput(f"a {type(load).__name__} takes mu; give a RingStack for a law")
    if (normal_force is None) == isinstance(load, Pressure):
        raise BadInput("a Pressure has no force of its own; give normal_force [N]" if normal_force is None else
                       f"the load has its own normal force, {load.normal_force:.6g} N; leave out normal_force")
    if (_array(speed) < 0).any():
        raise BadInput("a speed is negative; give speed >= 0 and the direction")
    limit = 1.0 if mu is None else _array(mu) * (1.0 if normal_force is None else _array(normal_force))
    if not np.all(np.isnan(limit) | (np.isfinite(limit) & (limit >= 0))):
        raise BadInput("mu or the normal force is negative or not finite; give values >= 0")
    speed, direction, omega, limit = _broadcast(speed, direction, omega, limit)
    one = _moving(load, law, point, speed * np.cos(direction), speed * np.sin(direction), omega)
    return Wrench(*(limit * part for part in one))


class LimitSurface:
    """Limit surface for one direction of travel, in arrays (n,): see limit_surface().

    angle [rad]: slip with v = cos(angle), omega R = sin(angle). force, across: friction against the direction of travel and
    perpendicular to it, over mu N. torque: against the spin, about the reference point, over mu N arm. arm [m]: torque of pure
    spin over mu N. radius [m]: R.
    """

    def __init__(self, angle: np.ndarray, force: np.ndarray, across: np.ndarray, torque: np.ndarray, arm: float,
                 radius: float, pressure: Optional[Pressure]):
        self.angle, self.force, self.across, self.torque = angle, force, across, torque
        self.arm, self.radius, self._pressure = arm, radius, pressure

    def __repr__(self):
        return f"LimitSurface({self.angle.size} slips, arm = {self.arm:.6g} m, radius = {self.radius:.6g} m)"

    def _within_range(self, name, most, force, torque):
        """Returns the Curve, with a warning if it misses the surface by more than the share `most`."""
        worst = np.abs(self.excess(force, torque)).max()
        if worst > most:
            warnings.warn(f"the {name} misses this limit surface by up to {100 * worst:.0f} %; use force and torque", UserWarning, 3)
        return Curve(force, torque)

    def _slip(self):
        at_end = np.abs(np.abs(self.angle) - np.pi / 2) < 1e-12
        return np.where(at_end, 0, np.cos(self.angle)), np.sin(self.angle)

    def ellipsoid(self) -> Curve:
        """Returns Curve(force, torque) of the ellipsoid f^2 + t^2 = 1 in the same slips, by maximum dissipation. The ellipsoid
        is the section of MuJoCo's elliptic cone at one normal force; Drake and most planners of pushing use it too. Warns
        if it misses the surface by more than 15 % (11 % for a thin ring), for instance for a load off the reference point."""
        v, u = self._slip()
        u = self.arm / self.radius * u
        return self._within_range("ellipsoid", 0.15, v / np.hypot(v, u), u / np.hypot(v, u))

    def pade(self, order: int = 1) -> Curve:
        """Returns Curve(force, torque) of the Contensou-Pade form for a Pressure, with its exact slopes at pure spin and at pure
        sliding. Warns if it misses the surface by more than 45 % (order 1) or 25 % (order 2), for instance for a thin ring; errors of
        43 % and 20 % are usual.

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
            return self._within_range("Pade form of order 1", 0.45, v / (v + u / slope_f), sign * u / (u + v / slope_t))
        b, d = square / (4 * self.radius**2), inverse * self.radius**2 / (4 * self.arm)
        f, t = v * v + b * slope_f * v * u, u * u + d * slope_t * v * u
        return self._within_range("Pade form of order 2", 0.25, f / (f + b * u * u), sign * t / (t + d * v * v))

    def excess(self, force: ArrayLike, torque: ArrayLike) -> np.ndarray:
        """Returns the relative distance of points (force, torque) beyond the surface, on the ray from 0; negative inside."""
        way = np.arctan2(self.torque, self.force)
        order = np.argsort(way)
        return np.hypot(force, torque) / np.interp(np.arctan2(torque, force), way[order],
                                                   np.hypot(self.force, self.torque)[order]) - 1


def limit_surface(load: Union[RingStack, Pressure, Patch], n: int = 361, about: Point = "axis",
                  direction: float = 0.0) -> LimitSurface:
    """Returns the LimitSurface of a RingStack, Pressure or Patch: n slips from pure clockwise to pure counter-clockwise spin.

    about: reference point of velocity and torque: "axis", "centre of pressure" or (x, y) [m]. direction [rad]: of the point's
    velocity in the load's frame. A load that is not the same all round has a different curve for each direction.

    >>> s = limit_surface(Pressure.hertz(0.03))
    >>> round(s.arm / 0.03 * 16 / (3 * np.pi), 9), round(float(s.force[180]), 12)
    (1.0, 1.0)
    """
    if not isinstance(load, (RingStack, Pressure, Patch)):
        raise BadInput(f"the load is {load!r}; give a Pressure, a RingStack or a Patch, for instance SelfConsistentRing.load(omega)")
    point, radius, angle = _reference_point(load, about), load.radius, np.linspace(-np.pi / 2, np.pi / 2, n)
    v = np.where(np.abs(np.abs(angle) - np.pi / 2) < 1e-12, 0, np.cos(angle))
    c, s = np.cos(direction), np.sin(direction)
    N = getattr(load, "normal_force", 1.0)
    T = _moving(load, None, point, c * v, s * v, np.sin(angle) / radius)
    arm = -float(_moving(load, None, point, 0.0, 0.0, 1.0).torque) / N
    return LimitSurface(angle, -(c * T.force_x + s * T.force_y) / N, -(c * T.force_y - s * T.force_x) / N, -T.torque / N / arm, arm,
                        radius, load if isinstance(load, Pressure) and not any(point) else None)


def _solve(load, motion, grip_torque, all=False, times=()):
    """Returns _ring.answer() for the arguments of answer()."""
    def at(omega):
        found = load(omega)
        if not isinstance(found, RingStack):
            raise BadInput(f"the load at {omega} rad/s is {found!r}; give a function that returns a RingStack")
        return found
    if not isinstance(load, (RingStack, SelfConsistentRing)) and not callable(load):
        raise BadInput(f"the load is {load!r}; give a RingStack, a SelfConsistentRing or a function of omega")
    motion = motion or getattr(load, "motion", None)
    if not isinstance(motion, Motion):
        raise BadInput("the load does not say how the glass moves; give a Motion")
    if not isinstance(grip_torque, numbers.Real):
        raise BadInput(f"the grip torque is {grip_torque!r}; give a number [N m]")
    return _ring.answer(at if callable(load) else load, motion, grip_torque, all, _array(times).ravel())


Load = Union[RingStack, SelfConsistentRing, Callable[[float], RingStack]]


def answer(load: Load, motion: Optional[Motion] = None, grip_torque: float = 0.0, all: bool = True) -> Answer:
    """Returns the terminal spin that the glass reaches from rest.

    load: a RingStack, the same at every spin; a SelfConsistentRing, which has its own motion; or a function of omega [rad/s]
    that returns a RingStack. The lean torque of a RingStack is included. grip_torque [N m]: torque of the fingers against the spin.

    Answer: omega [rad/s]; stable, held (True if the fingers stop the glass); torque_slope, d torque / d omega [N m s];
    time_constant [s]; torque_at_rest [N m], without the grip; spin_scale, v / R [rad/s]; all: a list of dicts of all zeros of the
    torque within 1.5 v / R of rest, empty with all=False, which is faster. Raises NoTerminalSpin, BalanceLost (last_spin), and
    Tipping if the moment exceeds N r of the outermost ring, at rest or at the terminal spin.

    >>> paper = SelfConsistentRing(motion=Motion(), closure="paper", radius=0.03)
    >>> round(answer(paper).omega, 9)
    -3.120558702
    """
    spin, spins, at_rest, scale, _ = _solve(load, motion, grip_torque, all)
    [spin], spins = ([dict(zip(some.dtype.names, one)) for one in some.tolist()] for some in (spin, spins))
    return Answer(**spin, torque_at_rest=at_rest, spin_scale=scale, all=spins)


def spin_up(load: Load, times: ArrayLike, motion: Optional[Motion] = None, grip_torque: float = 0.0) -> Dict[str, np.ndarray]:
    """Returns the spin-up from rest at equally spaced times [s], a dict of arrays time, yaw_angle [rad] and omega [rad/s]; NaN
    after the glass has tipped. For the other arguments see answer()."""
    return _columns(_solve(load, motion, grip_torque, times=times)[-1])


def yaw_motion(torque: Callable[[float, float, float], float], *, yaw_inertia: float, times: ArrayLike,
               initial_spin: float = 0.0, accuracy: float = 1e-9, spin_scale: float,
               grip_torque: float = 0.0) -> Dict[str, np.ndarray]:
    """Integrates yaw_inertia d omega/dt = torque(time, yaw_angle, omega) - grip_torque sgn(omega) [N m]; returns a dict of arrays
    time, yaw_angle [rad] and omega [rad/s] at the increasing times [s].

    yaw_inertia [kg m^2]. accuracy: of the angle in rad, and of omega relative to spin_scale [rad/s], for instance v / R.
    grip_torque [N m]: torque of the fingers; a glass at rest stays at rest until |torque| exceeds it.
    """
    return _columns(_ring.yaw_motion(torque, yaw_inertia, _array(times).ravel(), initial_spin, accuracy, spin_scale, grip_torque))
