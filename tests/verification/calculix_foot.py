"""Feet with the step profile pressed on tables: elasticity by CalculiX, contact by quadrature. No code of the program.

CalculiX condenses a three-dimensional foot (C3D20 and C3D15, stem cut clamped) to the nodes of its land; the pressure
p = k (-(gap + u_z + q0 + q1 x + q2 y))_+ and the friction t = -mu p v_rel / |v_rel|, v_rel = (1 - s y, s x), are integrated
over the land's faces by Gauss quadrature, and (q0, q1, q2) carry N and the moments (sum y f, -sum x f). A hard table is a
mat of 4e15 Pa/m. `compliance` holds (1/pi) int u_z cos(n theta) dA over the land under a unit pressure cos(n theta) (zz),
a unit radial traction cos(n theta) (zr) and a unit azimuthal one sin(n theta) (zt).

CalculiX 2.20 and numpy 1.24, of Debian 12 (calculix-ccx, python3-numpy); a few minutes:
/usr/bin/python3 calculix_foot.py > calculix_foot.json
"""
import json
import os
import subprocess
import sys
import tempfile

os.environ.setdefault("OMP_NUM_THREADS", "1")
import numpy as np

E, nu = 70e9, 0.22
N, R = 2.943, 0.030
HARD = 4e15
mm = 1e-3
z_lines = np.array([0, 0.5, 1, 2, 3.5, 5, 7, 10, 15]) * mm
r_lines = {
    "flat": np.array([0, 2.5, 5, 7, 10, 14, 18, 22, 25.5, 28, 29, 29.06, 29.2, 29.5, 30, 30.6, 31, 32, 34]) * mm,
    "crown": np.array([0, 2.5, 5, 7, 10, 14, 18, 22, 25.5, 28, 29, 29.6, 29.85, 30.15, 30.4, 31, 32, 34]) * mm}
land = {"flat": (29 * mm, 31 * mm), "crown": (28 * mm, 32 * mm)}
crown = {"flat": 0.0, "crown": 3 * mm}
gauss = np.polynomial.legendre.leggauss


def fine(lines):
    result = np.empty(2 * len(lines) - 1)
    result[::2], result[1::2] = lines, (lines[1:] + lines[:-1]) / 2
    return result


def mesh(foot, n_sectors):
    """Nodes, elements, the eight-node faces of the land, and the numbers of the nodes by their places (i, j, k), twice the
    cell's index along r, z and theta."""
    r, z = fine(r_lines[foot]), fine(z_lines)
    places, points, hexahedra, wedges, faces = {}, [], [], [], []

    def node(i, j, k):
        key = (0, j, 0) if i == 0 else (i, j, k % (2 * n_sectors))
        if key not in places:
            places[key] = len(points) + 1
            angle = np.pi * key[2] / n_sectors
            points.append((r[i] * np.cos(angle), r[i] * np.sin(angle), z[j]))
        return places[key]

    for a in range(0, len(r) - 2, 2):
        for b in range(0, len(z) - 2, 2):
            rm, zm = r[a + 1], z[b + 1]
            if not (land[foot][0] < rm < land[foot][1] or zm > 1 * mm) or (zm > 5 * mm and rm > 5 * mm):
                continue
            for k in range(0, 2 * n_sectors, 2):
                if a == 0:
                    ring = lambda j: [node(0, j, k), node(2, j, k), node(2, j, k + 2)]
                    mid = lambda j: [node(1, j, k), node(2, j, k + 1), node(1, j, k + 2)]
                    wedges.append(ring(b) + ring(b + 2) + mid(b) + mid(b + 2) + ring(b + 1))
                else:
                    ring = lambda j: [node(a, j, k), node(a + 2, j, k), node(a + 2, j, k + 2), node(a, j, k + 2)]
                    mid = lambda j: [node(a + 1, j, k), node(a + 2, j, k + 1), node(a + 1, j, k + 2), node(a, j, k + 1)]
                    hexahedra.append(ring(b) + ring(b + 2) + mid(b) + mid(b + 2) + ring(b + 1))
                    if b == 0:
                        faces.append(ring(0) + mid(0))
    return np.array(points), hexahedra, wedges, np.array(faces), places


def condensed(foot, n_sectors):
    """u_z of the land's nodes under unit forces there along z, x and y, three matrices [n, n], the nodes' positions and the
    faces. CalculiX solves for forces on the nodes of one sector (*GREEN); the other sectors are rotations of it."""
    points, hexahedra, wedges, faces, places = mesh(foot, n_sectors)
    on_land = np.unique(faces)
    clamped = 1 + np.flatnonzero(np.abs(points[:, 2] - z_lines[-1]) < 1e-9)
    place_of = {number: place for place, number in places.items()}
    sources = [n for n in on_land if place_of[n][2] in (0, 1)]

    def lines(numbers):
        return ",\n".join(", ".join(map(str, numbers[i:i + 10])) for i in range(0, len(numbers), 10))

    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "foot.inp"), "w") as f:
            f.write("*NODE, NSET=ALL\n" + "".join("%d, %.12e, %.12e, %.12e\n" % (i + 1, *p) for i, p in enumerate(points)))
            f.write("*ELEMENT, TYPE=C3D20, ELSET=GLASS\n")
            f.write("".join("%d, %s\n" % (i + 1, lines(e)) for i, e in enumerate(hexahedra)))
            f.write("*ELEMENT, TYPE=C3D15, ELSET=GLASS\n")
            f.write("".join("%d, %s\n" % (i + 1 + len(hexahedra), lines(e)) for i, e in enumerate(wedges)))
            for name, nodes in (("CLAMPED", clamped), ("LAND", on_land)):
                f.write("*NSET, NSET=%s\n" % name + "".join("%d,\n" % n for n in nodes))
            f.write("*MATERIAL, NAME=GLASS\n*ELASTIC\n%g, %g\n*SOLID SECTION, ELSET=GLASS, MATERIAL=GLASS\n" % (E, nu))
            f.write("*BOUNDARY\nCLAMPED, 1, 3\n*STEP\n*GREEN\n*CLOAD\n")
            f.write("".join("%d, %d, 1.0\n" % (n, d) for n in sources for d in (1, 2, 3)))
            f.write("*NODE PRINT, NSET=LAND\nU\n*END STEP\n")
        run = subprocess.run(["ccx", "-i", "foot"], cwd=folder, capture_output=True, text=True,
                             env=dict(os.environ, OMP_NUM_THREADS="1"))
        with open(os.path.join(folder, "foot.dat")) as f:
            rows = [line.split() for line in f.read().splitlines()]
    rows = np.array([[float(x) for x in row] for row in rows if len(row) == 4 and row[0].isdigit()])
    if len(rows) != 3 * len(sources) * len(on_land):
        sys.exit("CalculiX failed:\n" + run.stdout[-2000:])
    response = rows[:, 3].reshape(len(sources), 3, len(on_land))  # u_z under forces along x, y, z
    index = {n: i for i, n in enumerate(on_land)}
    z, x, y = np.zeros((3, len(on_land), len(on_land)))
    for source, (along_x, along_y, along_z) in zip(sources, response):
        i, j, k = place_of[source]
        for turn in range(n_sectors):
            def turned(n):
                return index[places[(*place_of[n][:2], (place_of[n][2] + 2 * turn) % (2 * n_sectors))]]
            to, column = [turned(n) for n in on_land], turned(source)
            c, s = np.cos(2 * np.pi * turn / n_sectors), np.sin(2 * np.pi * turn / n_sectors)
            z[to, column], x[to, column], y[to, column] = along_z, c * along_x - s * along_y, s * along_x + c * along_y
    return (z, x, y), points[on_land - 1, :2], np.searchsorted(on_land, faces)


def shapes(s, t):
    """Eight-node shape functions [8] and their derivatives [2, 8] at (s, t) in [-1, 1]^2."""
    S, T = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
    value, slope = np.empty(8), np.empty((2, 8))
    value[:4] = (1 + S * s) * (1 + T * t) * (S * s + T * t - 1) / 4
    slope[0, :4] = S * (1 + T * t) * (2 * S * s + T * t) / 4
    slope[1, :4] = T * (1 + S * s) * (2 * T * t + S * s) / 4
    for i, (a, b) in enumerate(((0, -1), (1, 0), (0, 1), (-1, 0))):
        if b:
            value[4 + i], slope[:, 4 + i] = (1 - s * s) * (1 + b * t) / 2, (-s * (1 + b * t), b * (1 - s * s) / 2)
        else:
            value[4 + i], slope[:, 4 + i] = (1 + a * s) * (1 - t * t) / 2, (a * (1 - t * t) / 2, -t * (1 + a * s))
    return value, slope


class Foot:
    def __init__(self, kind, n_sectors, pieces=(1, 4)):
        """Divides each face into `pieces` along r and theta, with three Gauss points in each direction of a piece."""
        self.kind = kind
        self.compliance, self.nodes, self.faces = condensed(kind, n_sectors)
        self.n = len(self.nodes)

        def rule(n):
            x, w = gauss(3)
            return [((2 * i + 1 + a) / n - 1, b / n) for i in range(n) for a, b in zip(x, w)]

        values, positions, weights = [], [], []
        for s, ws in rule(pieces[0]):
            for t, wt in rule(pieces[1]):
                value, slope = shapes(s, t)
                corners = self.nodes[self.faces]  # [faces, 8, 2]
                jacobian = np.abs(np.linalg.det(np.einsum("da,fax->fdx", slope, corners)))
                values.append(value)
                positions.append(np.einsum("a,fax->fx", value, corners))
                weights.append(ws * wt * jacobian)
        self.values = np.array(values)                        # [q, 8]
        self.positions = np.array(positions).swapaxes(0, 1)   # [f, q, 2]
        self.weights = np.array(weights).T                    # [f, q]
        self.radius = np.hypot(*np.moveaxis(self.positions, -1, 0))
        self.theta = np.arctan2(self.positions[..., 1], self.positions[..., 0])
        self.gap = (self.radius - R) ** 2 / (2 * crown[kind]) if crown[kind] else np.zeros_like(self.radius)
        self.motions = np.stack([np.ones_like(self.radius), self.positions[..., 0], self.positions[..., 1]], -1)

    def nodal(self, density):
        """int N_i density dA."""
        result = np.zeros(self.n)
        np.add.at(result, self.faces, np.einsum("fq,qa->fa", density * self.weights, self.values))
        return result

    def press(self, k, m, direction=0.0, friction=0.0, spin=0.0, n_harmonics=6):
        n = self.n
        x, y = self.positions[..., 0], self.positions[..., 1]
        slip = np.stack([1 - spin * y, spin * x], -1)
        tangential = -friction * slip / np.linalg.norm(slip, axis=-1)[..., None]
        M = m * N * R / 2
        target = np.array([N, M * np.cos(direction), M * np.sin(direction)])  # sums of f (1, x, y)
        u, q = np.zeros(n), np.array([-1e-5 if crown[self.kind] else -N / k / self.weights.sum() * 3, 0, 0])
        factors = (np.ones_like(x), tangential[..., 0], tangential[..., 1])

        def contact(u, q):
            depth = -(self.gap + np.einsum("fa,qa->fq", u[self.faces], self.values) + self.motions @ q)
            return depth

        def residual(u, q):
            p = k * np.maximum(contact(u, q), 0)
            f = [self.nodal(p * factor) for factor in factors]
            return (u - sum(C @ forces for C, forces in zip(self.compliance, f)),
                    np.einsum("fq,fq,fqk->k", p, self.weights, self.motions) - target, p)

        scale = np.array([N, N * R, N * R])
        for step in range(100):
            r1, r2, p = residual(u, q)
            stiff = k * (contact(u, q) > 0) * self.weights
            A = np.eye(n + 3)
            A[n:, n:] = -np.einsum("fq,fqk,fql->kl", stiff, self.motions, self.motions)
            for factor, columns in zip(factors, self.compliance):
                blocks = np.einsum("fq,qa,qb->fab", stiff * factor, self.values, self.values)
                T = np.zeros((n, n))
                np.add.at(T, (self.faces[:, :, None], self.faces[:, None, :]), blocks)
                L = np.zeros((n, 3))
                np.add.at(L, self.faces, np.einsum("fq,qa,fqk->fak", stiff * factor, self.values, self.motions))
                A[:n, :n] += columns @ T
                A[:n, n:] += columns @ L
                if factor is factors[0]:
                    A[n:, :n] = -L.T
            change = -np.linalg.solve(A, np.concatenate([r1, r2]))
            length, before = 1.0, np.linalg.norm(r2 / scale) / N + np.linalg.norm(r1) / np.linalg.norm(q[0])
            while length > 1e-3:
                new = residual(u + length * change[:n], q + length * change[n:])
                if np.linalg.norm(new[1] / scale) / N + np.linalg.norm(new[0]) / np.linalg.norm(q[0]) < 2 * before:
                    break
                length /= 2
            u, q = u + length * change[:n], q + length * change[n:]
            if length == 1 and np.abs(change[:n + 1]).max() < 1e-11 * np.abs(q[0]):
                break
        else:
            raise RuntimeError("no contact")
        p = residual(u, q)[2] * self.weights
        self.forces = p  # at the Gauss points
        a0 = p.sum() / (2 * np.pi)
        a, b = ([round(float((p * f(i * self.theta)).sum() / np.pi / a0), 6) + 0.0 for i in range(n_harmonics + 1)]
                for f in (np.cos, np.sin))
        return {"k": k, "moment_ratio": m, "direction": direction, "friction": friction, "spin": spin,
                "a_over_a0": [1.0] + a[1:], "b_over_a0": b}

    def averaged(self, n):
        """zz, zr and zt of one harmonic [m^5/N]."""
        c, s = np.cos(n * self.theta), np.sin(n * self.theta)
        er = self.positions / self.radius[..., None]
        of_z, of_x, of_y = self.compliance
        mean = self.nodal(c) / np.pi / (2 if n == 0 else 1)
        radial = of_x @ self.nodal(c * er[..., 0]) + of_y @ self.nodal(c * er[..., 1])
        azimuthal = -of_x @ self.nodal(s * er[..., 1]) + of_y @ self.nodal(s * er[..., 0])
        return [float("%.5e" % (mean @ u)) for u in (of_z @ self.nodal(c), radial, azimuthal)]


def main():
    result = {"about": __doc__.strip(), "feet": {}}
    for kind, pieces in (("flat", (2, 4)), ("crown", (80, 3))):
        foot = Foot(kind, 48, pieces)
        rows = [foot.averaged(n) for n in range(7)]
        cases = [(k, m) for k in (1e9, 1e10, 1e11) for m in (0.5, 1.2, 1.8)]
        sliding = [(1e11, 0.8, 0.3, 0.2, -10.0)]
        if kind == "flat":
            cases = [(1e10, 1.2), (1e10, 1.3), (1e11, 1.2), (1e11, 1.3), (HARD, 0.5), (HARD, 1.2), (HARD, 1.3)]
            sliding += [(k, 0.4, 0.0, 0.3, 0.0) for k in (1e9, 1e10, 1e11)] + [(HARD, 0.8, 0.3, 0.2, -10.0)]
        loads = []
        for case in cases + sliding:
            loads.append(foot.press(*case))
            if case[0] == HARD:
                loads[-1]["k"] = None
            print(kind, case, file=sys.stderr, flush=True)
        result["feet"][kind] = {"compliance": {name: [row[i] for row in rows] for i, name in enumerate(("zz", "zr", "zt"))},
                                "loads": loads}
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
