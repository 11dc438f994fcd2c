"""Flat annular punches on a half-space and on a bonded layer, by spectral collocation. No code of Stemware.

    u(r) cos(n theta) = w (r/a)^[n = 1] cos(n theta) on b < r < a,   u = (1/(pi E*)) int p dA / distance, less the layer's part

The pressure is p(s) s = g(x) / sqrt(1 - x^2), s = m + h x. The kernel over the azimuth is Q_{n-1/2}(chi) of Legendre, whose
logarithm is integrated by the trigonometric rule for ln 4 sin^2 (Kress), the rest by the Gauss-Chebyshev rule. An infinite
layer of thickness H, bonded below, subtracts the smooth kernel int (1 - T(kH)) J_n(kr) J_n(ks) dk.
Loads are over E* a w: P/(2 E* a w) and 3 M/(4 E* a^2 w) for n = 0, 1, and lambda_n / (E* a w) for all n, with w cos(n theta)
throughout. Needs numpy and scipy; prints the JSON file beside it: python3 annular_punch.py > annular_punch.json (seconds).
"""
import json

import numpy as np
from scipy.special import ellipe, ellipk, ellipkm1, jv


def legendre(n_max, chi_less_1):
    """P and Q of the orders n - 1/2, n = 0 ... n_max, at 1 + chi_less_1 > 1."""
    x = 1 + chi_less_1
    P = [2 / np.pi * np.sqrt(2 / (x + 1)) * ellipk(chi_less_1 / (x + 1))]
    Q = [np.sqrt(2 / (x + 1)) * ellipkm1(chi_less_1 / (x + 1))]
    eta = np.arccosh(x)
    P.append(2 / np.pi * np.exp(eta / 2) * ellipe(-np.expm1(-2 * eta)))
    Q.append(x * np.sqrt(2 / (x + 1)) * ellipkm1(chi_less_1 / (x + 1)) - np.sqrt(2 * (x + 1)) * ellipe(2 / (x + 1)))
    for n in range(1, n_max):
        for f in (P, Q):
            f.append((2 * n * x * f[n] - (n - 0.5) * f[n - 1]) / (n + 0.5))
    return P, Q


def transfer(alpha, poisson):
    """Ratio of the displacements of a bonded layer and a half-space, at the wave number alpha / H."""
    kappa, e = 3 - 4 * poisson, np.exp(-2 * alpha)
    return (kappa * (1 - e * e) - 4 * alpha * e) / (kappa * (1 + e * e) + (4 * alpha**2 + 1 + kappa**2) * e)


def punch(n, ratio, n_points, thickness=None, poisson=0.3, bending=False):
    """lambda_n / (E* a w) of the annulus ratio < r < 1; with `bending` w r cos theta and int p r^2 dr instead of int p r dr."""
    m, h, N = (1 + ratio) / 2, (1 - ratio) / 2, n_points
    phi = np.arange(2 * N) * np.pi / N  # angles of the pressure points, a whole turn for Kress's rule
    psi = (np.arange(N + 1)[:, None]) * np.pi / N  # angles of the displacement points
    x, y = np.cos(psi), np.cos(phi)
    r, s = m + h * x, m + h * y
    # ln |x - y| = (ln 4 sin^2((psi - phi)/2) + ln 4 sin^2((psi + phi)/2)) / 2 - ln 2; weights of ln 4 sin^2 after Kress.
    k = np.arange(1, N)
    distance = psi - phi
    weights = -2 * np.pi / N * (np.cos(k * distance[..., None]) / k).sum(-1) - np.pi / N**2 * np.cos(N * distance)
    chi_less_1 = (r - s)**2 / (2 * r * s)
    near = np.abs(r - s) < 1e-7
    P, Q = legendre(max(n, 1), np.where(near, 1e-15, chi_less_1))
    A = -P[n] / np.sqrt(r * s)  # coefficient of ln |x - y|
    with np.errstate(divide="ignore", invalid="ignore"):
        rest = Q[n] / np.sqrt(r * s) - A * np.log(np.abs(x - y))
    # For chi -> 1: Q = -ln(chi - 1)/2 + ln(2)/2 - psi(n + 1/2) - gamma, with chi - 1 = (r - s)^2 / (2 r s).
    digamma = -2 * np.log(2) + 2 * sum(1 / (2 * j - 1) for j in range(1, n + 1))
    rest = np.where(near, (np.log(2 * r / h) - digamma) / r, rest)
    half = np.pi / N * 0.5  # factor 1/2: a whole turn has every x twice
    kernel = 2 / np.pi * h * (0.5 * weights * A + half * (rest - np.log(2) * A))
    if thickness:
        t, v = np.polynomial.legendre.leggauss(400)
        wave = (t + 1) / 2 * 40 / thickness
        less = 20 / thickness * v * (1 - transfer(wave * thickness, poisson))
        J = lambda radius: jv(n, wave[:, None] * radius.ravel())
        kernel -= 2 * h * half * (J(r).T * less) @ J(s)
    # g has one value per node of half a turn.
    folded = kernel[:, :N + 1].copy()
    folded[:, 1:N] += kernel[:, :N:-1]
    g = np.linalg.solve(folded, r.ravel() if bending else np.ones(N + 1))
    end = np.ones(N + 1)
    end[[0, -1]] = 0.5
    return np.pi * h * np.pi / N * (end * g * (r.ravel() if bending else 1)).sum() / np.pi


def row(ratio, n_points, thickness=None, poisson=0.3):
    arguments = (n_points, thickness, poisson)
    return {"load": np.pi * punch(0, ratio, *arguments), "moment": 0.75 * np.pi * punch(1, ratio, *arguments, bending=True),
            "harmonics": [punch(n, ratio, *arguments) for n in range(7)]}


def main():
    rows = []
    for ratio in (0.5, 0.7, 0.8, 0.9, 0.96):
        for thickness, poisson in ((None, 0.3), (100, 0.3), (1 / 6, 0.3), (1 / 6, 0.0)):
            rows.append({"ratio": ratio, "thickness": thickness, "poisson_ratio": poisson, **row(ratio, 40, thickness, poisson)})
            coarser = row(ratio, 28, thickness, poisson)
            assert max(abs(np.array(coarser["harmonics"]) / rows[-1]["harmonics"] - 1)) < 1e-9, (ratio, thickness)
    print(json.dumps({"about": __doc__.strip(), "punches": rows}, indent=1))


if __name__ == "__main__":
    main()
