"""Terminal spins of rigid feet on Winkler mats by two-dimensional quadrature. No code of Stemware.

    p(r, theta) = k (d0 + d1 x + d2 y - g(r))_+ on the land, g = (r - R)^2 / (2 crown) or 0 (flat),
    t = -mu p v_rel / |v_rel|,  v_rel = (v - omega y, omega x).

(d0, d1, d2) carry N and M_N = (int y p, -int x p); see `balance` for M_N. The terminal spin is the zero of
tau_z + d1 M_Nx + d2 M_Ny - grip sgn(omega), tau_z = int (x t_y - y t_x). Plain Python; prints the JSON file beside it:
python3 rigid_foot.py > rigid_foot.json (ten seconds).
"""
import json, math

pi = math.pi
mass, g, mu, v, rho, R, land, dz = 0.30, 9.81, 0.3, 0.35, 0.15, 0.030, 0.004, -0.05
N = mass * g
CROWN = 0.003


def gauss(n, cache={}):
    """Gauss-Legendre nodes and weights on [0, 1]."""
    if n not in cache:
        rule = []
        for i in range(n):
            x = math.cos(pi * (i + 0.75) / (n + 0.5))
            for _ in range(100):
                p0, p1 = 1.0, x
                for j in range(2, n + 1):
                    p0, p1 = p1, ((2 * j - 1) * x * p1 - (j - 1) * p0) / j
                slope = n * (x * p1 - p0) / (x * x - 1)
                step = p1 / slope
                x -= step
                if abs(step) < 1e-16:
                    break
            rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
        cache[n] = rule
    return cache[n]


def zero(f, x0, x1, tolerance=1e-14):
    """Secant method."""
    f0, f1 = f(x0), f(x1)
    for _ in range(60):
        x0, f0, x1 = x1, f1, x1 - f1 * (x1 - x0) / (f1 - f0)
        f1 = f(x1)
        if abs(x1 - x0) <= tolerance * abs(x1) or f1 == 0:
            return x1
    raise RuntimeError("no convergence")


def solve(f, x, scale):
    """Newton's method with a Jacobian by central differences (of steps `scale`)."""
    n = len(x)
    for _ in range(40):
        r = f(x)
        columns = []
        for j in range(n):
            up, down = list(x), list(x)
            up[j] += scale[j]
            down[j] -= scale[j]
            a, b = f(up), f(down)
            columns.append([(a[i] - b[i]) / (2 * scale[j]) for i in range(n)])
        A = [[columns[j][i] for j in range(n)] + [-r[i]] for i in range(n)]
        for c in range(n):
            pivot = max(range(c, n), key=lambda i: abs(A[i][c]))
            A[c], A[pivot] = A[pivot], A[c]
            for i in range(n):
                if i != c:
                    q = A[i][c] / A[c][c]
                    A[i] = [a - q * b for a, b in zip(A[i], A[c])]
        step = [A[i][n] / A[i][i] for i in range(n)]
        x = [a + b for a, b in zip(x, step)]
        if all(abs(s) < 1e-9 * w for s, w in zip(step, scale)):
            return x
    raise RuntimeError("no convergence")


def contact_band(crown, d0, slope):
    """Interval (r_inner, r_outer) of a radius with depth = d0 + slope r - g(r) > 0."""
    inner, outer = R - land / 2, R + land / 2
    if crown:
        D = (crown * slope) ** 2 + 2 * crown * (d0 + R * slope)
        inner = max(inner, R + crown * slope - math.sqrt(D))
        outer = min(outer, R + crown * slope + math.sqrt(D))
        return inner, outer
    if d0 + slope * inner <= 0 or d0 + slope * outer <= 0:
        raise RuntimeError("the flat land lifts off")
    return inner, outer


def depth(crown, d0, slope, r):
    return d0 + slope * r - ((r - R) ** 2 / (2 * crown) if crown else 0.0)


# ---- (a) annulus, pressure p0 + p1 r sin theta, moment balance `paper`
def annulus(n_r=20, n_theta=256):
    inner, outer = R - land / 2, R + land / 2
    M = dz * mass * v * v / rho
    p0, p1 = N / (pi * (outer**2 - inner**2)), M / (pi * (outer**4 - inner**4) / 4)

    def torque(omega):
        total = 0.0
        for x, w in gauss(n_r):
            r = inner + (outer - inner) * x
            for i in range(n_theta):
                s = math.sin(2 * pi * i / n_theta)
                slip = math.sqrt(v * v + (omega * r) ** 2 - 2 * v * omega * r * s)
                total += w * r * r * (p0 + p1 * r * s) * (v * s - omega * r) / slip
        return mu * total * (outer - inner) * 2 * pi / n_theta

    return zero(torque, -3.0, -3.2)


# ---- (b) given moment ratio, load maximum at theta = -90 deg; phi = theta + 90 deg, everything even in phi
def one_sided_torque(crown, k, d0, d2, omega, n):
    """|tau_z| for contact in |phi| < phi_c; also N and |M_Nx|. omega > 0 stands for -omega. Intervals shrink
    towards phi = 0, r = v / omega, where the slip may vanish."""
    if crown:  # at the end of the contact, the largest depth along the radius is zero
        ends = [math.acos((-R + math.sqrt(R * R - 2 * crown * d0)) / (crown * d2))]
    else:  # at the zeros of the depth at one edge of the land, then at the other
        ends = sorted(math.acos(-d0 / (d2 * r)) for r in (R - land / 2, R + land / 2))
    end = ends[-1]
    marks = sorted([ends[0] * 2.0**-j for j in range(30, -1, -1)] + ends[1:])
    force = moment = torque = 0.0
    for a, b in zip([0.0] + marks[:-1], marks):
        for x, w in gauss(n):
            if b == end:  # the depth vanishes: the integrand has the power 3/2 (or a kink) of end - phi
                phi, weight = end - (end - a) * (1 - x) ** 2, w * 2 * (1 - x) * (end - a)
            else:
                phi, weight = a + (b - a) * x, w * (b - a)
            c = math.cos(phi)
            if crown:
                band = contact_band(crown, d0, d2 * c)
            else:
                edge = -d0 / (d2 * c)
                band = (max(R - land / 2, edge), R + land / 2) if c > 0 else (R - land / 2, min(R + land / 2, edge))
            breaks = {band[0], band[1]}
            if omega:
                star = v / omega
                for j in range(-1, 40):
                    distance = R * phi * 2.0**j if j >= 0 else 0.0
                    if distance > land:
                        break
                    breaks |= {r for r in (star - distance, star + distance) if band[0] < r < band[1]}
            breaks = sorted(breaks)
            for low, high in zip(breaks, breaks[1:]):
                for y, u in gauss(n):
                    r = low + (high - low) * y
                    p = weight * u * (high - low) * k * depth(crown, d0, d2 * c, r) * r
                    force += 2 * p
                    moment += 2 * p * r * c
                    slip = math.sqrt((v - omega * r * c) ** 2 + (omega * r * math.sin(phi)) ** 2)
                    torque += 2 * mu * p * r * (v * c - omega * r) / slip
    return force, moment, torque


def thin_ring(crown, k, m):
    """(d0, d2) of a ring of zero width: load ~ (cos phi - c)_+^q, q = 3/2 (crown) or 1 (flat)."""
    q = 1.5 if crown else 1.0

    def moments(c):
        end = math.acos(c)
        parts = [(math.cos(end * x) - c, math.cos(end * x), w * 2 * end) for x, w in gauss(40)]
        return sum(w * max(h, 0) ** q for h, _, w in parts), sum(w * max(h, 0) ** q * c for h, c, w in parts)

    low, high = -1.0, 1.0
    for _ in range(50):
        c = (low + high) / 2
        force, moment = moments(c)
        low, high = (c, high) if moment / force < m / 2 else (low, c)
    stiffness = k * (4 / 3 * math.sqrt(2 * crown) if crown else land)
    A = (N / (stiffness * R * moments(c)[0])) ** (1 / q)
    return -c * A, A / R


def given_moment(crown, k, m, n):
    d0, d2 = thin_ring(crown, k, m)
    unit = d2 * R

    def residual(d):
        force, moment, _ = one_sided_torque(crown, k, d[0] * unit, d[1] * unit / R, 0.0, 12)
        return [force / N - 1, moment / (m * N * R / 2) - 1]

    x0, x1 = solve(residual, [d0 / unit, 1.0], [1e-4, 1e-4])
    d0, d2 = x0 * unit, x1 * unit / R
    return -zero(lambda w: one_sided_torque(crown, k, d0, d2, w, n)[2], 9.5, 11.0, 1e-12), d0, d2


# ---- (c) moment balance `full`, whole land loaded all round
def resultants(crown, k, d, omega, n_theta, n_r):
    """N, M_Nx, M_Ny, T_x, T_y, tau_z. The trapezoidal rule in theta converges geometrically."""
    sums = [0.0] * 6
    for i in range(n_theta):
        theta = 2 * pi * i / n_theta
        c, s = math.cos(theta), math.sin(theta)
        slope = d[1] * c + d[2] * s
        low, high = contact_band(crown, d[0], slope)
        for y, u in gauss(n_r):
            r = low + (high - low) * y
            f = k * depth(crown, d[0], slope, r) * r * u * (high - low) * 2 * pi / n_theta
            sx, sy = v - omega * r * s, omega * r * c
            q = mu * f / math.hypot(sx, sy)
            for j, value in enumerate((f, f * r * s, -f * r * c, -q * sx, -q * sy, -q * r * (c * sy - s * sx))):
                sums[j] += value
    return sums


def balance(crown, k, z_cm, tilt, omega, start, n_theta=96, n_r=12):
    """M_N = -dz m k x a + (z_cm + dz) k x T + N z_cm (d2, -d1) (tilt), k x (x, y) = (-y, x), a = (0, v^2 / rho)."""
    h = z_cm + dz

    def residual(x):
        d = [x[0] * unit, x[1] * unit / R, x[2] * unit / R]
        f, mx, my, tx, ty, _ = resultants(crown, k, d, omega, n_theta, n_r)
        lean = N * z_cm if tilt else 0.0
        return [f / N - 1, (mx - dz * mass * v * v / rho + h * ty - lean * d[2]) / (N * R),
                (my - h * tx + lean * d[1]) / (N * R)]

    unit = start[0]
    x = solve(residual, [start[0] / unit, start[1] * R / unit, start[2] * R / unit], [1e-4] * 3)
    d = [x[0] * unit, x[1] * unit / R, x[2] * unit / R]
    return d, resultants(crown, k, d, omega, n_theta, n_r)


def balanced_spin(crown, k, z_cm, tilt, grip, **resolution):
    area = 2 * pi * R * (4 / 3 * math.sqrt(2 * crown) if crown else land) * k
    state = [[(N / area) ** (2 / 3 if crown else 1.0), 0.0, 0.0]]

    def drive(omega):
        state[0], (_, mx, my, _, _, tau) = balance(crown, k, z_cm, tilt, omega, state[0], **resolution)
        lean = (state[0][1] * mx + state[0][2] * my) if tilt else 0.0
        return tau + lean + grip

    omega = zero(drive, -3.5, -3.7, 1e-13)
    d, (f, mx, my, tx, ty, tau) = balance(crown, k, z_cm, tilt, omega, state[0], **resolution)
    return {"k": k, "crown": crown, "z_cm": z_cm, "tilt": tilt, "grip": grip, "omega": omega, "d": d,
            "moment": [mx, my], "friction": [tx, ty], "tau": tau, "lean_torque": d[1] * mx + d[2] * my}


def main():
    result = {"about": __doc__.strip(),
              "parameters": {"mass": mass, "gravity": g, "mu": mu, "speed": v, "orbit_radius": rho, "R": R,
                             "land": land, "force_offset": dz, "sense": "counterclockwise"}}
    result["annulus_closure_paper"] = {"omega": annulus(), "coarser": annulus(12, 96)}
    rows = []
    for crown, k, m in [(CROWN, k, m) for m in (1.8, 1.95) for k in (1e10, 1e11, 1e12)] + [(0.0, 1e10, 1.3)]:
        omega, d0, d2 = given_moment(crown, k, m, 20)
        rows.append({"crown": crown, "k": k, "moment_ratio": m, "omega": omega,
                     "coarser": given_moment(crown, k, m, 12)[0], "d": [d0, 0.0, -d2]})
    result["given_moment_direction_minus_90_deg"] = rows
    rows = []
    for crown in (CROWN, 0.0):
        for k in (1e9, 1e10):
            for tilt in (False, True):
                for grip in (0.0, 2e-4):
                    row = balanced_spin(crown, k, 0.08, tilt, grip)
                    row["coarser"] = balanced_spin(crown, k, 0.08, tilt, grip, n_theta=64, n_r=8)["omega"]
                    rows.append(row)
    result["closure_full"] = rows
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()
