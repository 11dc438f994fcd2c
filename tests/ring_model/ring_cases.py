"""Numbers of the Coulomb ring with 20 digits, by quadrature of its definitions; shares no code with Stemware. Needs mpmath.

    ring_cases.py > ring_cases.json    writes the file beside it (two minutes)
    ring_cases.py --check              recomputes every section, of long ones the first and last row; exit code 1 if a
                                       number of the file differs by more than 4e-15 (relative, absolute below 1)

Slip frame: x along the motion, theta counter-clockwise from x, lambda = a0 + sum a_n cos(n theta) + b_n sin(n theta) per radian,
a0 = N / (2 pi), eps = omega R / v, D = sqrt(1 + eps^2 - 2 eps sin(theta)), psi = theta - pi/2, M = (pi R b_1, -pi R a_1):

    T_par = -mu int lambda (1 - eps sin theta) / D,   T_perp = -mu int lambda eps cos theta / D
    tau = mu R int lambda (sin theta - eps) / D
    P_n = int sqrt(1 + eps^2 - 2 eps cos psi) cos n psi,   K_n = -dP_n/d eps,   U_n = P_n + eps K_n

Panels of 26 Gauss points become shorter towards the point where the rim hardly slides; a panel that ends where the rim lifts
off is integrated over the root of the distance to that end.
"""
import json
import pathlib
import re
import sys

from mpmath import (acos, cos, ellipe, ellipk, exp, fac2, findroot, hypot, log, matrix, mp, mpf, pi, sin, sqrt)

mp.dps = 24


def gauss(n):
    nodes = []
    for i in range(n):
        x = cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(8):
            before, value = mpf(1), x
            for k in range(2, n + 1):
                before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
            slope = n * (x * value - before) / (x * x - 1)
            x -= value / slope
        nodes.append((x, 2 / ((1 - x * x) * slope**2)))
    return nodes


nodes = gauss(26)


def panels(lower, upper, eps, edges):
    """Points and weights of (lower, upper) for integrands with the singularities of D at the slip ratio eps."""
    distance = abs(log(abs(eps))) if eps not in (0, 1, -1) else mpf(0)
    centre = pi / 2 if eps >= 0 else -pi / 2
    cuts = {lower, (lower + upper) / 2, upper}  # no panel extends from one end to near the other
    for turn in range(-2, 3):
        singular = centre + 2 * pi * turn
        cuts.add(singular)
        step = distance or mpf(1) / 2
        while step < pi:
            cuts |= {singular - step, singular + step}
            step *= 2
    cuts = sorted(cut for cut in cuts if lower <= cut <= upper)
    points = []
    for a, b in zip(cuts, cuts[1:]):
        if b - a < mpf(10)**-20:
            continue
        n = int(b - a) + 1
        for i in range(n):
            start, end = a + (b - a) * i / n, a + (b - a) * (i + 1) / n
            for x, w in nodes:
                s, weight = (1 + x) / 2, w / 2 * (end - start)
                if edges and start == lower:
                    points.append((start + (end - start) * s * s, 2 * s * weight))
                elif edges and end == upper:
                    points.append((end - (end - start) * s * s, 2 * s * weight))
                else:
                    points.append((start + (end - start) * s, weight))
    return points


def kernels(eps, n_max):
    D = lambda psi: sqrt((1 - eps)**2 + 4 * eps * sin(psi / 2)**2)
    P, K = [mpf(0)] * (n_max + 1), [mpf(0)] * (n_max + 1)
    for theta, w in panels(-pi / 2, 3 * pi / 2, eps, False):
        psi = theta - pi / 2
        d = D(psi)
        slope = (cos(psi) - eps) / d
        for n in range(n_max + 1):
            c = w * cos(n * psi)
            P[n] += c * d
            K[n] += c * slope
    return P, K, [p + eps * k for p, k in zip(P, K)]


def friction(load, eps, support=None):
    """(T_par, T_perp, tau) over mu and mu R, and the dissipation over mu v, of load(theta); support: interval of the load."""
    lower, upper = support or (-pi / 2, 3 * pi / 2)
    sums = [mpf(0)] * 4
    for theta, w in panels(lower, upper, eps, support is not None):
        s, c = sin(theta), cos(theta)
        d = sqrt(1 + eps * eps - 2 * eps * s)
        f = w * load(theta)
        sums[0] -= f * (1 - eps * s) / d
        sums[1] -= f * eps * c / d
        sums[2] += f * (s - eps) / d
        sums[3] += f * d
    return sums


def root_between(function, lower, upper):
    """Root to the last digits; findroot compares the square of the value with tol."""
    return findroot(function, (lower, upper), solver="anderson", tol=mpf(10)**-38, maxsteps=60)


class Foundation:
    """Load max(0, cos(theta) - c)^p of a ring on springs, over its mean; p = 1: a flat rim, p = 3/2: a round one."""

    def __init__(self, p, c):
        self.p, self.c = p, c
        self.edge = acos(c) if c > -1 else +pi  # a number of the precision in use
        if c > -1:
            self.points = [(theta, w * self.shape(theta)) for theta, w in panels(-self.edge, self.edge, 0, True)]
        else:
            self.points = [(theta, w * self.shape(theta)) for theta, w in panels(-pi, pi, 0, False)]
        self.mean = sum(w for _, w in self.points) / (2 * pi)

    def shape(self, theta):
        penetration = cos(theta) - self.c
        return penetration**self.p if penetration > 0 else mpf(0)

    def harmonic(self, n):
        return sum(w * cos(n * theta) for theta, w in self.points) / (pi * self.mean)

    @classmethod
    def of_moment(cls, p, ratio):
        """Foundation with a_1/a_0 = ratio."""
        if p == 1 and ratio <= 1:
            return cls(p, -1 / ratio)
        onset = 2 * p / (p + 1)
        if abs(ratio - onset) < mpf(10)**-18:
            return cls(p, mpf(-1))
        if ratio < onset:  # c <= -1; 2 p / (-c) is an upper bound of a_1/a_0 for large -c
            bracket = (-1 / mpf("0.99999"), -4 * p / ratio)
        else:
            bracket = (mpf("-0.99999"), mpf("0.99999"))
        return cls(p, root_between(lambda c: cls(p, c).harmonic(1) - ratio, *bracket))

    def friction(self, eps, beta):
        """Friction over mu N and mu N R of the load rotated by beta."""
        load = lambda theta: self.shape(theta - beta) / (2 * pi * self.mean)
        return friction(load, eps, (beta - self.edge, beta + self.edge) if self.c > -1 else None)


class Paper:
    """Motion of the paper's glass."""

    mass, radius, orbit_radius, speed, offset, mu = mpf("0.3"), mpf("0.03"), mpf("0.15"), mpf("0.35"), mpf("-0.05"), mpf("0.3")

    def __init__(self, closure, g, z_cm=None):
        self.closure, self.weight, self.z_cm = closure, self.mass * mpf(g), mpf(z_cm or 0)
        self.centripetal = self.mass * self.speed**2 / self.orbit_radius

    def moment(self, T):
        """Moment M of the normal forces that balances the friction T about the centre of mass of a glass that does not tip."""
        if self.closure == "A":
            return self.offset * self.centripetal, mpf(0)
        hand = -T[0], self.centripetal - T[1]
        return self.offset * hand[1] - self.z_cm * T[1], -self.offset * hand[0] + self.z_cm * T[0]

    def amplitudes(self, T):
        M = self.moment(T)
        return -2 * M[1] / (self.weight * self.radius), 2 * M[0] / (self.weight * self.radius)

    def first_harmonic(self, eps):
        """a_1/a_0, b_1/a_0, T_par, T_perp, tau of a load with the first harmonic only; T and M are linear in each other."""
        parts = [friction(part, eps)[:3] for part in (lambda theta: 1 / (2 * pi), lambda theta: cos(theta) / (2 * pi), lambda theta: sin(theta) / (2 * pi))]
        force = self.mu * self.weight
        T = lambda a, b: [force * (p + a * q + b * r) for p, q, r in zip(*parts)]
        start, of_a, of_b = [self.amplitudes(T(*ab)) for ab in ((0, 0), (1, 0), (0, 1))]
        A = matrix([[1 - of_a[0] + start[0], start[0] - of_b[0]], [start[1] - of_a[1], 1 - of_b[1] + start[1]]])
        a, b = mp.lu_solve(A, matrix(start))
        Tx, Ty, torque = T(a, b)
        return a, b, Tx, Ty, self.radius * torque

    def terminal(self, guess):
        return findroot(lambda eps: self.first_harmonic(eps)[4], (mpf(guess), mpf(guess) * mpf("1.01")), solver="secant", tol=mpf(10)**-19)

    def unilateral(self, p, state, eps=None):
        """Edge c, direction beta, eps and friction of a unilateral load in balance: at eps, or at the terminal spin, from state."""
        def residual(c, beta, e=eps):
            found = Foundation(p, c)
            T = [self.mu * self.weight * t for t in found.friction(e, beta)]
            a, b = self.amplitudes(T)
            m = found.harmonic(1)
            balance = [m * cos(beta) - a, m * sin(beta) - b]
            return balance if eps is not None else [*balance, T[2]]

        if eps is not None:  # initial guess for a terminal spin
            return [*findroot(residual, state, tol=mpf("1e-4")), eps]
        c, beta, e = findroot(residual, state, tol=mpf(10)**-19)
        return [c, beta, e, *[self.mu * self.weight * t for t in Foundation(p, c).friction(e, beta)[:2]]]


def closure_row(closure, g, z_cm):
    motion = Paper(closure, g, z_cm)
    row = {"closure": closure, "g": float(g)}
    if z_cm:
        row["zcm"] = float(z_cm)
    eps = motion.terminal("-0.4")
    slope = mp.diff(lambda e: motion.first_harmonic(e)[4], eps, h=mpf(10)**-8)
    negative = False
    for at, e in (("_0", mpf(0)), ("_T", eps)):
        a, b, Tx, Ty, torque = motion.first_harmonic(e)
        row |= {"ratio" + at: hypot(a, b), "a1_over_a0" + at: a, "b1_over_a0" + at: b, "T_par" + at: Tx, "T_perp" + at: Ty}
        if at == "_0":
            row["tau_0"] = torque
        negative = negative or bool(hypot(a, b) > 1)
    per_omega = motion.radius / motion.speed
    return row | {"eps_T": eps, "omega_T": eps / per_omega, "dtau_domega_T": slope * per_omega, "formal_negative_load": negative}


def unilateral_row(p, z_cm):
    motion = Paper("C", "9.81", z_cm)
    a, b = motion.amplitudes((-motion.mu * motion.weight, mpf(0)))
    ratio, beta = hypot(a, b), mp.atan2(b, a)
    at_rest = Foundation.of_moment(p, ratio).c
    eps = motion.terminal("-0.4")
    state = [at_rest, beta]
    for part in (mpf(1) / 2, mpf(1)):
        state = motion.unilateral(p, state[:2], part * eps)
    c, beta_T, eps, Tx, Ty = motion.unilateral(p, state)
    a_T, b_T = motion.amplitudes((Tx, Ty))
    return {"p": float(p), "zcm": float(z_cm), "ratio0": ratio, "beta0": beta, "c0": at_rest, "tau0": motion.offset * motion.centripetal * motion.mu,
            "eps": eps, "omega": eps * motion.speed / motion.radius, "ratioT": hypot(a_T, b_T), "betaT": beta_T, "cT": c, "Tx": Tx, "Ty": Ty}


def radial_row(ratio):
    """Terminal slip ratio of a fixed load with its maximum at theta = pi/2."""
    row = {"ratio": float(ratio)}
    torque = lambda eps: friction(lambda theta: 1 + mpf(ratio) * sin(theta), eps)[2]
    row["eps_first_harmonic"] = root_between(torque, mpf("0.1"), mpf("0.99"))
    for p in (mpf(1), mpf("1.5")):
        found = Foundation.of_moment(p, mpf(ratio))
        row[f"eps_p{float(p)}"] = root_between(lambda eps: found.friction(eps, pi / 2)[2], mpf("0.1"), mpf("0.995"))
    return row


def contact_row(p, ratio):
    found = Foundation.of_moment(p, mpf(ratio))
    return {"ratio": float(ratio), "full_contact": bool(found.c <= -1), "c": found.c, "theta_c": found.edge,
            "a_over_a0": [mpf(1)] + [found.harmonic(n) for n in range(1, 17)], "lambda_max_over_a0": found.shape(0) / found.mean}


def wrench_row(load, eps):
    mu, R = mpf("0.3"), mpf("0.03")
    T_par, T_perp, torque, dissipation = friction(load, mpf(eps))
    return {"eps": float(eps), "tau": mu * R * torque, "T_par": mu * T_par, "T_perp": mu * T_perp, "dissipation_over_v": mu * dissipation}


def ring_wrench(eps):
    """Force over mu N and torque over mu N R of a ring with an even load, in elliptic integrals of the modulus eps."""
    if eps > 1:
        force, torque = ring_wrench(1 / eps)
        return torque, force
    if eps == 1:
        return 2 / pi, 2 / pi
    E, K = ellipe(eps * eps), ellipk(eps * eps)
    return 2 * E / pi, (2 / pi) * (E - (1 - eps * eps) * K) / eps if eps else mpf(0)


def annulus_wrench(eta, eps):
    """Force over mu N and torque over mu N R of an annulus with uniform pressure; eps = omega R_out / v."""
    cuts = sorted({mpf(eta), mpf(1), min(max(1 / eps, mpf(eta)), mpf(1))})
    weight = 1 - mpf(eta)**2
    force = mp.quad(lambda r: 2 * r * ring_wrench(eps * r)[0], cuts) / weight
    return force, mp.quad(lambda r: 2 * r * r * ring_wrench(eps * r)[1], cuts) / weight


def annulus_row(eta):
    gamma = (1 + mpf(eta)**2) / 2

    def excess(eps):
        force, torque = annulus_wrench(eta, eps)
        return force * gamma * eps - torque

    eps = root_between(excess, mpf("1.0001"), mpf(2))
    force, torque = annulus_wrench(eta, eps)
    return {"eta": float(eta), "gamma": gamma, "eps0_omegaR_over_v": eps, "v_over_omegaR": 1 / eps, "f": force, "t": torque}


def disc_row(speed):
    force, torque = annulus_wrench(0, 1 / mpf(speed))
    return {"v_over_omegaR": float(speed), "f": force, "t": torque}


def kernel_row(eps):
    P, K, U = kernels(mpf(eps), 12)
    return {"eps": float(eps), "P": P, "K": K, "U": U}


paper = Paper("A", "9.81")
inertia, time_nodes = mpf("0.000135"), gauss(12)


def paper_torque(omega):
    b_1 = paper.amplitudes((0, 0))[1]
    return paper.radius * paper.mu * paper.weight * friction(lambda theta: (1 + b_1 * sin(theta)) / (2 * pi), omega * paper.radius / paper.speed)[2]


def time_to(omega):
    n = max(1, int(abs(omega) / mpf("0.5")))
    total, points = mpf(0), time_nodes
    for i in range(n):
        for x, w in points:
            # w = 1 - exp(-s) times the terminal spin: the integrand is nearly constant in s.
            s = end_of(omega) * (i + (1 + x) / 2) / n
            spin = terminal_spin * (1 - exp(-s))
            total += w / 2 * end_of(omega) / n * inertia * terminal_spin * exp(-s) / paper_torque(spin)
    return total


def end_of(omega):
    return -log(1 - omega / terminal_spin)


terminal_spin = paper.terminal("-0.26") * paper.speed / paper.radius


def time_row(omega):
    return {"omega": float(omega), "t": time_to(mpf(omega)), "tau": paper_torque(mpf(omega))}


def omega_at(time):
    omega = mpf("-2")
    for _ in range(8):  # Newton's method: dt / d omega = Iz / tau
        change = (time_to(omega) - time) * paper_torque(omega) / inertia
        omega -= change
        if abs(change) < mpf(10)**-11:  # its square is below rounding
            return omega
    raise RuntimeError("no time")


def liftoff():
    limit = paper.weight * paper.radius / 2
    radial, tangential = abs(paper.offset) * paper.centripetal, abs(paper.offset) * paper.mu * paper.weight
    return {"Mh_radial_part": radial, "Mh_tangential_part": tangential, "Mh_total": hypot(radial, tangential), "NR_over_2": limit,
            "ratio_total": hypot(radial, tangential) / limit, "ratio_tangential_only": tangential / limit}


ratios = "0.2 0.5 0.8 1.0 1.2 1.5 1.8 1.95".split()
a, b = [mpf(x) for x in "0.5 0.12 -0.07 0.03 0.02".split()], [mpf(x) for x in "0 -0.15 0.05 -0.04 0.01".split()]


def general_load(theta):
    return sum(a[n] * cos(n * theta) + b[n] * sin(n * theta) for n in range(5))


def rows(function, cases):
    """Rows of a section, each a function without arguments."""
    return [lambda case=case: function(*case) if isinstance(case, tuple) else function(case) for case in cases]


sections = {
    ("kernels",): rows(kernel_row, "-0.27 0.01 0.1 0.5 0.9 0.99 0.999 1.0 1.001 1.1 2.0 10.0".split()),
    ("general_wrench", "cases"): rows(lambda eps: wrench_row(general_load, eps), "-1.3 -0.27 0 0.5 0.95 1 1.3 5".split()),
    ("closures_first_harmonic",): rows(closure_row, [("A", "9.81", None), ("A", "9.80665", None), ("A", "9.8", None), ("B", "9.81", None)] +
                                       [("C", "9.81", z) for z in "0.06 0.08 0.09 0.1 0.12".split()]),
    ("closures_C_unilateral", "cases"): rows(unilateral_row, [(p, z) for p in (mpf(1), mpf("1.5")) for z in "0.06 0.08 0.1 0.12".split()]),
    ("terminal_radial_load", "rows"): rows(radial_row, "0.2 0.277494620002265 0.5 0.8 1.0 1.2 1.5 1.8".split()),
    ("time_evolution_A", "rows"): rows(time_row, "-0.5 -1.0 -1.5 -2.0 -2.5 -3.0 -3.1".split()),
    ("literature", "annulus_free_terminal", "rows"): rows(annulus_row, "0 0.1 0.2 0.25 0.3 0.4 0.5 0.6 0.7 0.75 0.8 0.9 0.95 0.99".split()),
    ("literature", "disc_uniform", "rows"): rows(disc_row, "0.3 0.5 1.0 1.5 4.0".split()),
    ("contact_winkler_linear", "rows"): rows(contact_row, [(mpf(1), m) for m in ratios]),
    ("contact_torus_winkler", "rows"): rows(contact_row, [(mpf("1.5"), m) for m in ratios]),
}


def everything(all_rows):
    """Contents of the file as nested dictionaries; without all_rows only the first and the last row of each section."""
    ring_eps = [mpf(x) for x in "0 0.1 0.25 0.5 0.75 0.9 1 1.1 1.5 2 4 10".split()]
    even = [friction(lambda theta: 1 / (2 * pi), eps) for eps in ring_eps]
    spins = [mpf(x) for x in range(-10, 11, 2)]
    document = {
        "about": "Written by ring_cases.py: symbols and definitions stand there. SI units; rounded to double precision.",
        "kernel_small_eps": {"note": "K_n = kappa_n eps^(n-1) (1 + O(eps^2)), kappa_n = pi (2n-3)!!/(2n-2)!!",
                             "kappa": [pi * fac2(2 * n - 3) / fac2(2 * n - 2) for n in range(1, 13)]},
        "general_wrench": {"mu": 0.3, "R": 0.03, "a": a, "b": b},
        "paper_liftoff_check": liftoff(),
        "time_evolution_A": {"Iz": inertia, "g": 9.81, "omega_at_t0p1": omega_at(mpf("0.1")), "omega_at_t0p2": omega_at(mpf("0.2")),
                             "omega_dot_0": paper_torque(mpf(0)) / inertia},
        "torque_curve_A": {"omega": spins, "tau": [paper_torque(omega) for omega in spins]},
        "literature": {"ring_uniform": {"eps": ring_eps, "f": [-x[0] for x in even], "t": [-x[2] for x in even]}},
    }
    for keys, functions in sections.items():
        place = document
        for key in keys[:-1]:
            place = place.setdefault(key, {})
        place[keys[-1]] = [f() if all_rows or i in (0, len(functions) - 1) else None for i, f in enumerate(functions)]
        print(keys, file=sys.stderr)
    return document


def rounded(x):
    """Numbers rounded to the nearest double; numbers below the error of the quadrature become 0."""
    if isinstance(x, dict):
        return {key: rounded(value) for key, value in x.items()}
    if isinstance(x, list):
        return [rounded(value) for value in x]
    if isinstance(x, (bool, str, type(None))):
        return x
    return 0. if abs(x) < mpf(10)**-19 else float(x)


def differences(made, kept, where=""):
    if made is None:
        return []
    if isinstance(made, dict):
        missing = [f"{where}: keys {sorted(made)} here, {sorted(kept)} in the file"] if set(made) != set(kept) else []
        return missing + [line for key in made.keys() & kept.keys() for line in differences(made[key], kept[key], f"{where}/{key}")]
    if isinstance(made, list):
        return [line for i, (x, y) in enumerate(zip(made, kept)) for line in differences(x, y, f"{where}/{i}")] + (
            [f"{where}: {len(made)} values here, {len(kept)} in the file"] if len(made) != len(kept) else [])
    if isinstance(made, float) and abs(made - kept) > 4e-15 * max(1., abs(made)):
        return [f"{where}: {made!r} here, {kept!r} in the file"]
    return [f"{where}: {made!r} here, {kept!r} in the file"] if type(made) is not float and made != kept else []


if __name__ == "__main__":
    check = sys.argv[1:] == ["--check"]
    found = rounded(everything(not check))
    if not check:
        print(re.sub(r"\[[^\[\]{}]*\]", lambda numbers: " ".join(numbers.group().split()), json.dumps(found, indent=1)))  # a list per line
        sys.exit(0)
    file = pathlib.Path(__file__).with_name("ring_cases.json")
    wrong = differences(found, json.loads(file.read_text()))
    print("\n".join(wrong) or "ring_cases.json has the numbers computed here.")
    sys.exit(len(wrong) > 0)
