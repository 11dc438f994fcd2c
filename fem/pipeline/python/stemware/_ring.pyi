from typing import Any, Callable

from numpy import ndarray
from numpy.typing import ArrayLike

__version__: str

def __getattr__(name: str) -> Any: ...  # the functions that stemware.ring calls

class BadInput(ValueError): ...
class NoBalance(RuntimeError): ...
class Tipping(NoBalance): ...
class NoTerminalSpin(NoBalance): ...
class BalanceLost(NoBalance):
    last_spin: float

class Motion:
    def __init__(self, **values: Any) -> None: ...
    def replace(self, **values: Any) -> Motion: ...
    def as_dict(self) -> dict[str, Any]: ...
    mass: float
    yaw_inertia: float
    centre_of_mass_height: float
    force_offset: float
    orbit_radius: float
    orbit_speed: float
    orbit_acceleration: float
    friction_coefficient: float
    static_coefficient: float
    friction_decay_speed: float
    viscous_friction: float
    gravity: float
    liquid_mass: float
    liquid_density: float
    bowl_radius: float
    bowl_height: float
    bowl_depth: float
    surface_leans: bool
    clockwise: bool
    stribeck: bool
    normal_force: float

class FrictionLaw:
    def coefficient(self, slip_speed: float) -> float: ...

class Stribeck(FrictionLaw):
    def __init__(self, *, static: float, kinetic: float, decay_speed: float, viscous: float = 0, decay_exponent: float = 2) -> None: ...

class RingStack:
    def __init__(self, radii: ArrayLike, a: ArrayLike, b: ArrayLike, tilt: ArrayLike = ...) -> None: ...
    @staticmethod
    def first_harmonic(*, normal_force: float, moment: ArrayLike, radius: float) -> RingStack: ...
    radii: ndarray
    a: ndarray
    b: ndarray
    tilt: ndarray
    moment: ndarray
    lean_torque: float
    n_harmonics: int
    normal_force: float
    radius: float
    minimum: float
    pulling_force: float
    def truncated(self, n_max: int) -> RingStack: ...
    def rotated(self, angle: float) -> RingStack: ...
    def at(self, theta: ArrayLike) -> ndarray: ...

class SelfConsistentRing:
    def __init__(self, motion: Motion, closure: str, radius: float) -> None: ...
    def load(self, omega: float) -> RingStack: ...

class Pressure:
    def __init__(self, p: Callable[[Any], Any], inner: float, outer: float) -> None: ...
    @staticmethod
    def ring(radius: float) -> Pressure: ...
    @staticmethod
    def annulus(inner: float, outer: float) -> Pressure: ...
    @staticmethod
    def disc(radius: float) -> Pressure: ...
    @staticmethod
    def hertz(radius: float) -> Pressure: ...
    radius: float
    def mean_power(self, exponent: float) -> float: ...
