"""Rigid flat strip on a bonded elastic layer in plane strain, frictionless, by a spectral method: no finite elements.

The pressure is p(x) = sum_n c_n T_n(x/a) / sqrt(1 - x^2/a^2), n even, on a strip of the half-width a. Its Fourier transform has
Bessel functions, so that u(x) = delta on the strip becomes

    delta [m = 0] = (2 a / E*) sum_n (-1)^((m+n)/2) c_n int_0^inf T(k h) J_m(k a) J_n(k a) dk/k,   E* = E / (1 - nu^2)

with T the layer's displacement over the half-space's. The force per length is pi a c_0. For T = 1 the integral is known,
1 / (2 n) for m = n > 0 and 0 for other pairs of even order; the rest, 1 - T, vanishes for k h > 25. For m = n = 0
1 - T is compared with exp(-k h), whose integral is a mean of asinh(h / (2 a sin phi)).

Prints the JSON file beside it: python3 strip_on_a_layer.py > strip_on_a_layer.json (seconds; numpy and scipy). `settlement` is
delta E* / P, P the force per length; `mat` the same of springs with the layer's constrained modulus.
"""
import json

import numpy as np
from scipy.special import jv


def transfer(alpha, nu):
    """Ratio of the displacements of a bonded layer and a half-space, at the wave number alpha / h."""
    kappa, e = 3 - 4 * nu, np.exp(-2 * alpha)
    return (kappa * (1 - e * e) - 4 * alpha * e) / (kappa * (1 + e * e) + (4 * alpha**2 + 1 + kappa**2) * e)


def settlement(width_over_thickness, nu, n_terms):
    h = 2 / width_over_thickness  # h / a
    # 1 - T ends at k h = 25; panels are shorter than the oscillation of the product of two Bessel functions.
    n_panels = int(np.ceil(25 / h / 3)) + 20
    x, w = np.polynomial.legendre.leggauss(16)
    edges = np.linspace(0, 25 / h, n_panels + 1)
    k = (edges[:-1, None] + np.diff(edges)[:, None] * (x + 1) / 2).ravel()
    weights = (np.diff(edges)[:, None] * w / 2).ravel()
    orders = 2 * np.arange(n_terms)
    bessel = jv(orders[:, None], k)
    rest = 1 - transfer(k * h, nu)
    matrix = -(bessel * (rest / k * weights)) @ bessel.T
    rest_of_first = rest - np.exp(-k * h)
    phi = (np.arange(4000) + 0.5) * np.pi / 4000  # midpoint rule; the mean of -ln(sin phi) is ln 2
    first = np.mean(np.arcsinh(h / (2 * np.sin(phi))) + np.log(np.sin(phi))) + np.log(2)
    matrix[0, 0] = first - np.sum(bessel[0]**2 * rest_of_first / k * weights)
    matrix[1:, 1:] += np.diag(1 / (2 * orders[1:]))
    sign = (-1.)**(orders // 2)
    c = np.linalg.solve(2 * sign[:, None] * sign * matrix, np.eye(n_terms)[0])
    return 1 / (np.pi * c[0])


cases = []
for ratio in (1, 10, 30, 100):
    for nu in (0, 0.3, 0.45):
        n = 20 + 2 * ratio
        value = settlement(ratio, nu, n)
        assert abs(settlement(ratio, nu, n + 20 + ratio) / value - 1) < 1e-6
        mat = (1 - 2 * nu) / (1 - nu)**2 / ratio
        assert nu > 0 or value < mat  # with nu = 0 the layer outside the strip carries a part of the load
        cases.append({"width_over_thickness": ratio, "poisson_ratio": nu, "settlement": round(value, 9), "mat": round(mat, 9)})
print(json.dumps({"cases": cases}, indent=1))
