"""Load harmonics of an elastic foot on a unilateral mat, by spectral elements; shares no code with Stemware. numpy and scipy.

    foot_contact.py > foot_contact.json    writes the file beside it (minutes)
    foot_contact.py --check                repeats the coarser of the two resolutions; exit code 1 if a number differs
                                           from the file by more than its band, or a mean radius by more than 5e-8 m

Displacements (U cos n theta, V sin n theta, W cos n theta) on a meridian of elements of degree 4, then 6, with Gauss-Lobatto
nodes, in geometric layers at the re-entrant corners; n <= 20. On 1024 azimuth lines the mat's pressure k [penetration]_+ is
integrated by Gauss points between its zeros along r. Newton's method finds the amplitudes u_n = C_n f_n / (pi (1 + [n = 0]))
of the land's nodes and the settlement and tilt of the table, which stands under the clamped stem with the given N and M.
"""
import json
import pathlib
import sys

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import splu

millimetre = 1e-3
E, nu = 70e9, 0.22
N, R = 2.943, 0.03
n_max, n_lines = 20, 512  # lines on half the circumference: the load is symmetric


def lobatto(degree):
    """Nodes on [-1, 1]: the ends and the extrema of Legendre's polynomial."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots().real
    return np.concatenate([[-1], np.sort(inner), [1]])


class Basis:
    """Lagrange polynomials at Gauss-Lobatto nodes."""

    def __init__(self, degree):
        self.nodes = lobatto(degree)
        self.to_legendre = np.linalg.inv(np.polynomial.legendre.legvander(self.nodes, degree))

    def values(self, x):
        return np.polynomial.legendre.legvander(x, len(self.nodes) - 1) @ self.to_legendre

    def slopes(self, x):
        n = len(self.nodes)
        series = np.polynomial.legendre.legder(np.eye(n))
        return np.polynomial.legendre.legvander(x, n - 2) @ series @ self.to_legendre


def layers(length, n, first):
    """Lines from 0 to length: n steps shrink by 3 towards 0, the others are at most `first`."""
    steps = [min(first, length / 2) / 3**i for i in range(n, -1, -1)]
    lines = np.cumsum([0, steps[0], *[b - a for a, b in zip(steps, steps[1:])]])
    rest = max(1, int(np.ceil((length - lines[-1]) / first)))
    return np.concatenate([lines[:-1], np.linspace(lines[-1], length, rest + 1)])


def between(a, b, n, first, at):
    """Lines from a to b with layers at the ends in `at`."""
    if at == "both":
        half = layers((b - a) / 2, n, first)
        return np.concatenate([a + half, b - half[-2::-1]])
    return a + layers(b - a, n, first) if at == "a" else b - layers(b - a, n, first)[::-1] if at == "b" else np.linspace(a, b, n)


class Foot:
    """Compliances C_n of the nodes of the land, stem cut clamped, n = 0 ... n_max."""

    def __init__(self, land, crowned, degree, n_layers):
        inner, outer = R / millimetre - land / 2, R / millimetre + land / 2
        on_land = between(inner, outer, n_layers, 0.4, "both")
        if crowned:  # narrow contact, finer cells
            fine = np.array([-0.8, -0.5, -0.3, -0.15, 0, 0.15, 0.3, 0.5, 0.8]) + R / millimetre
            on_land = np.concatenate([on_land[on_land < fine[0] - 0.1], fine, on_land[on_land > fine[-1] + 0.1]])
        r = np.concatenate([[0, 2], between(2, 5, n_layers, 2, "b")[1:], between(5, inner, n_layers, 4, "both")[1:], on_land[1:],
                            between(outer, 34, n_layers, 1, "a")[1:]]) * millimetre
        z = np.concatenate([between(0, 1, n_layers, 0.5, "b"), between(1, 5, n_layers, 1.5, "both")[1:], between(5, 15, n_layers, 4, "a")[1:]]) * millimetre
        self.basis = Basis(degree)
        reference = (self.basis.nodes + 1) / 2
        cells = [(i, j) for i in range(len(r) - 1) for j in range(len(z) - 1)
                 if self.inside((r[i] + r[i + 1]) / 2 / millimetre, (z[j] + z[j + 1]) / 2 / millimetre, inner, outer)]
        n_z = degree * (len(z) - 1) + 1
        local = np.arange(degree + 1)
        numbers = np.array([((degree * i + local[:, None]) * n_z + degree * j + local).ravel() for i, j in cells])
        used, self.cells = np.unique(numbers, return_inverse=True)
        self.cells = self.cells.reshape(numbers.shape)
        all_r = np.concatenate([*[r[i] + (r[i + 1] - r[i]) * reference[:-1] for i in range(len(r) - 1)], [r[-1]]])
        all_z = np.concatenate([*[z[j] + (z[j + 1] - z[j]) * reference[:-1] for j in range(len(z) - 1)], [z[-1]]])
        self.r, self.z = all_r[used // n_z], all_z[used % n_z]
        nodes = np.flatnonzero(self.z < 1e-12)
        self.land = nodes[np.argsort(self.r[nodes])]
        self.land_r = self.r[self.land]
        self.elements = [(a, self.land_r[a], self.land_r[a + degree]) for a in range(0, len(nodes) - 1, degree)]
        stiffness = self.stiffness([(r[i], r[i + 1], z[j], z[j + 1]) for i, j in cells])
        self.compliance = [self.solve(stiffness, n) for n in range(n_max + 1)]

    @staticmethod
    def inside(r, z, inner, outer):
        return inner < r < outer if z < 1 else r < 34 if z < 5 else r < 5

    def stiffness(self, cells):
        """Matrices of n^0, n^1 and n^2."""
        shear, lame = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
        law = np.diag([2 * shear] * 3 + [shear] * 3)
        law[:3, :3] += lame
        x, w = np.polynomial.legendre.leggauss(len(self.basis.nodes) + 1)
        value, slope = self.basis.values(x), self.basis.slopes(x)
        size = len(self.basis.nodes)**2
        sums = np.zeros((3, len(cells), 3 * size, 3 * size))
        for e, (r0, r1, z0, z1) in enumerate(cells):
            h, g = (r1 - r0) / 2, (z1 - z0) / 2
            for p in range(len(x)):
                r = r0 + h * (1 + x[p])
                for q in range(len(x)):
                    shape = np.outer(value[p], value[q]).ravel() / r
                    of_r, of_z = np.outer(slope[p], value[q]).ravel() / h, np.outer(value[p], slope[q]).ravel() / g
                    even, odd = np.zeros((6, size, 3)), np.zeros((6, size, 3))  # strains rr, tt, zz, rz, rt, tz of n^0 and n^1
                    even[0, :, 0], even[1, :, 0], even[2, :, 2] = of_r, shape, of_z
                    even[3, :, 0], even[3, :, 2], even[4, :, 1], even[5, :, 1] = of_z, of_r, of_r - shape, of_z
                    odd[1, :, 1], odd[4, :, 0], odd[5, :, 2] = shape, -shape, -shape
                    even, odd = even.reshape(6, -1), odd.reshape(6, -1)
                    weighted = law * (w[p] * w[q] * h * g * r)
                    mixed = even.T @ weighted @ odd
                    sums[0, e] += even.T @ weighted @ even
                    sums[1, e] += mixed + mixed.T
                    sums[2, e] += odd.T @ weighted @ odd
        unknowns = (3 * self.cells[:, :, None] + np.arange(3)).reshape(len(cells), -1)
        rows = np.repeat(unknowns, 3 * size, axis=1).ravel()
        columns = np.tile(unknowns, (1, 3 * size)).ravel()
        n = 3 * len(self.r)
        return [sparse.csc_matrix((s.ravel(), (rows, columns)), shape=(n, n)) for s in sums]

    def solve(self, stiffness, n):
        K = stiffness[0] + n * stiffness[1] + n * n * stiffness[2]
        n_nodes = len(self.r)
        free = np.ones((n_nodes, 3), bool)
        free[self.z > 15 * millimetre - 1e-9] = False
        axis = np.flatnonzero(self.r < 1e-12)
        free[axis] = [[False, False, True]] if n == 0 else [[True, False, False]] if n == 1 else False
        free[self.z > 15 * millimetre - 1e-9] = False
        select = sparse.identity(3 * n_nodes, format="lil")
        if n == 1:  # U = -V on the axis, a sideways motion
            for i in axis:
                select[3 * i + 1, 3 * i] = -1
        select = select.tocsc()[:, np.flatnonzero(free.ravel())]
        loads = sparse.csc_matrix((np.ones(len(self.land)), (3 * self.land + 2, np.arange(len(self.land)))), shape=(3 * n_nodes, len(self.land)))
        factors = splu((select.T @ K @ select).tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.01, options={"SymmetricMode": True})
        return (select @ factors.solve((select.T @ loads).toarray()))[3 * self.land + 2]

    def mat(self, penetration, modulus):
        """Nodal forces per radian of each line, their derivatives by element, from the penetrations of the land's nodes."""
        degree = len(self.basis.nodes) - 1
        forces = np.zeros_like(penetration)
        tangents = np.zeros((len(self.elements), len(penetration), degree + 1, degree + 1))
        cuts = np.linspace(-1, 1, 9)
        x, w = np.polynomial.legendre.leggauss(degree + 2)
        at_cuts = self.basis.values(cuts)
        for e, (a, r0, r1) in enumerate(self.elements):
            d = penetration[:, a:a + degree + 1]
            found = d @ at_cuts.T
            for i in range(len(cuts) - 1):
                lower, upper = found[:, i], found[:, i + 1]
                lines = np.flatnonzero((lower > 0) | (upper > 0))
                if not len(lines):
                    continue
                start, end = np.full(len(lines), cuts[i]), np.full(len(lines), cuts[i + 1])
                crossed = np.flatnonzero((lower[lines] > 0) != (upper[lines] > 0))
                if len(crossed):
                    of = lines[crossed]
                    positive, negative = np.where(lower[of] > 0, cuts[i], cuts[i + 1]), np.where(lower[of] > 0, cuts[i + 1], cuts[i])
                    for _ in range(30):
                        middle = (positive + negative) / 2
                        above = np.einsum("li,li->l", self.basis.values(middle), d[of]) > 0
                        positive, negative = np.where(above, middle, positive), np.where(above, negative, middle)
                    start[crossed] = np.where(lower[of] > 0, cuts[i], positive)
                    end[crossed] = np.where(lower[of] > 0, positive, cuts[i + 1])
                points = start[:, None] + (end - start)[:, None] * (1 + x) / 2
                shape = self.basis.values(points)
                radius = r0 + (r1 - r0) * (1 + points) / 2
                weight = modulus * (end - start)[:, None] / 2 * w * (r1 - r0) / 2 * radius
                block = np.einsum("lpi,lp,lpj->lij", shape, weight, shape, optimize=True)
                tangents[e, lines] += block
            forces[:, a:a + degree + 1] += np.einsum("lij,lj->li", tangents[e], d)
        return forces, tangents

    def load(self, modulus, gap, moment_ratio, start=None):
        """a_n / a_0 to n = 8, mean radius and the unknowns, from the unknowns `start`."""
        n_land, degree = len(self.land), len(self.basis.nodes) - 1
        theta = np.pi * np.arange(n_lines + 1) / n_lines
        cosines = np.cos(np.outer(np.arange(2 * n_max + 2), theta))
        weighted = cosines * (2 * np.pi / n_lines * np.where((theta == 0) | (theta == np.pi), 0.5, 1))
        scale = np.array([2 * np.pi] + [np.pi] * n_max)
        arm = np.cos(theta)[:, None] * self.land_r
        moment = moment_ratio * N * R / 2
        unknowns = np.zeros((n_max + 1) * n_land + 2) if start is None else start.copy()
        if start is None:
            unknowns[-2] = 1e-5
        for _ in range(100):
            amplitudes = unknowns[:-2].reshape(n_max + 1, n_land)
            penetration = unknowns[-2] + unknowns[-1] * arm - gap - cosines[:n_max + 1].T @ amplitudes
            forces, tangents = self.mat(penetration, modulus)
            harmonics = weighted[:n_max + 1] @ forces
            residual = np.concatenate([(amplitudes - np.array([C @ f for C, f in zip(self.compliance, harmonics)]) / scale[:, None]).ravel(),
                                       [harmonics[0].sum() - N, (harmonics[1] @ self.land_r - moment) / R]])
            # Sums of the tangents with cos k theta give the sums with cos n theta cos m theta.
            sums = np.zeros((2 * n_max + 2, n_land, n_land))
            for e, (a, _, _) in enumerate(self.elements):
                s = slice(a, a + degree + 1)
                sums[:, s, s] += np.tensordot(weighted, tangents[e], 1)
            orders = np.arange(n_max + 1)
            products = (sums[abs(orders[:, None] - orders)] + sums[orders[:, None] + orders]) / 2
            tilt = np.array([(sums[abs(n - 1)] + sums[n + 1]) @ self.land_r / 2 for n in orders])
            # Columns of nodes outside the contact equal columns of the identity.
            active = np.flatnonzero(sums[0].diagonal() > 0)
            n_active = (n_max + 1) * len(active)
            forward = np.zeros((n_max + 1, n_land, n_active + 2))
            for n in orders:
                C = self.compliance[n] / scale[n]
                block = products[n][:, active[:, None], active]
                forward[n, :, :-2] = C[:, active] @ block.transpose(1, 0, 2).reshape(len(active), -1)
                forward[n, :, -2], forward[n, :, -1] = -C @ sums[n].sum(axis=1), -C @ tilt[n]
            jacobian = np.zeros((n_active + 2, n_active + 2))
            jacobian[:-2] = forward[:, active].reshape(n_active, -1)
            jacobian[range(n_active), range(n_active)] += 1
            jacobian[-2, :-2] = -sums[:n_max + 1].sum(axis=1)[:, active].ravel()
            jacobian[-1, :-2] = -tilt[:, active].ravel() / R
            twice = (sums[0] + sums[2]) / 2
            jacobian[-2, -2:] = sums[0].sum(), sums[1].sum(axis=0) @ self.land_r
            jacobian[-1, -2:] = sums[1].sum(axis=0) @ self.land_r / R, self.land_r @ twice @ self.land_r / R
            rest = residual[:-2].reshape(n_max + 1, n_land)
            solved = np.linalg.solve(jacobian, -np.concatenate([rest[:, active].ravel(), residual[-2:]]))
            change = np.concatenate([(-rest - forward @ solved).ravel(), solved[-2:]])
            change[:-2].reshape(n_max + 1, n_land)[:, active] = solved[:-2].reshape(n_max + 1, -1)
            unknowns += change
            if max(abs(residual[-2:])) < 1e-11 * N and max(abs(change[:-2])) < 1e-9 * abs(unknowns[-2]):
                a = harmonics.sum(axis=1) / scale
                return a[:9] / a[0], harmonics[0] @ self.land_r / harmonics[0].sum(), unknowns
        raise RuntimeError(f"Newton's method does not converge at k = {modulus}, m = {moment_ratio}")


feet = {
    "crown 0.003, land width 0.004": (4, 0.003, {1e9: [0.2, 0.5, 1.2, 1.8], 1e10: [0.2, 0.5, 1.2, 1.8], 1e11: [0.2, 0.5, 1.2, 1.8]}),
    "flat, land width 0.002": (2, None, {1e10: [0.4, 1.3], 1e11: [0.4, 1.3]}),
}


def loads(name, degree, n_layers):
    """{(modulus, m): (a_n / a_0, mean radius)} of one resolution."""
    land, crown, states = feet[name]
    foot = Foot(land, crown is not None, degree, n_layers)
    print(f"{name}: {len(foot.r)} nodes, {len(foot.land)} on the land", file=sys.stderr)
    gap = (foot.land_r - R)**2 / (2 * crown) if crown else np.zeros(len(foot.land))
    found = {}
    for modulus, ratios in states.items():
        start = None
        for ratio in ratios:
            a, mean_radius, start = foot.load(modulus, gap, ratio, start)
            found[modulus, ratio] = a, mean_radius
    return found


def text(modulus):
    return f"k=1e{round(np.log10(modulus))} Pa/m"


def main():
    coarse = {name: loads(name, 4, 1) for name in feet}
    if sys.argv[1:] == ["--check"]:
        kept = json.loads(pathlib.Path(__file__).with_name("foot_contact.json").read_text())
        wrong = []
        for name, states in coarse.items():
            for (modulus, ratio), (a, mean_radius) in states.items():
                there = kept[name][text(modulus)][f"m={ratio}"]
                wrong += [f"{name}, {text(modulus)}, m = {ratio}: a_{n}/a_0 = {a[n]:.8f} here, {there['a_over_a0'][n]} in the file" for n in range(9)
                          if abs(a[n] - there["a_over_a0"][n]) > there["band"][n]]
                if abs(mean_radius - there["mean_radius"]) > 5e-8:
                    wrong.append(f"{name}, {text(modulus)}, m = {ratio}: mean radius {mean_radius:.9f} here, {there['mean_radius']} in the file")
        print("\n".join(wrong) or "foot_contact.json has the numbers computed here.")
        return len(wrong) > 0
    document = {
        "about": "Written by foot_contact.py. Load harmonics a_n/a_0 (n = 0..8) of an elastic foot on a unilateral mat, load centre at theta = 0, "
                 "N = 2.943 N, moment ratio m = |M_N|/(N R/2), R = 0.030 m. band: three times the difference of two meridians (elements of degree 4 and 6) plus 2e-6.",
        "foot": "step profile, SI: land r in [R - w/2, R + w/2], 0 <= z <= 0.001; foot r <= 0.034, 0.001 <= z <= 0.005; stem r <= 0.005, 0.005 <= z <= 0.015; "
                "stem cut z = 0.015 clamped, table moves; E = 70e9, nu = 0.22; gap (r-R)^2/(2 crown)"}
    for name in feet:
        document[name] = {}
        for (modulus, ratio), (a, mean_radius) in loads(name, 6, 1).items():
            document[name].setdefault(text(modulus), {})[f"m={ratio}"] = {
                "a_over_a0": [round(value, 8) + 0. for value in a],
                "band": [round(3 * abs(here - there) + 2e-6, 8) for here, there in zip(a, coarse[name][modulus, ratio][0])], "mean_radius": round(mean_radius, 9)}
    print(json.dumps(document, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
