"""Fits entries of studies to measured spin-ups by scipy's least squares (Debian: python3-scipy)."""
import concurrent.futures
import warnings
from typing import Any

import numpy as np

from . import figures, ring
from .study import Start
_not_of_the_load = "Motion/Grip torque", "Motion/Yaw inertia"


def _prior(given, unknown):
    """Returns value and standard deviation of a prior: deviation 0 for a fixed value, the pair `unknown` for None."""
    value, spread = unknown if given is None else given if isinstance(given, tuple) else (given, 0.0)
    if isinstance(value, str) or not (np.isfinite(value) and spread >= 0):
        raise ring.BadInput(f"{given!r} is no value; give None, a number that is held, or (value, standard deviation)")
    return float(value), float(spread)


def _require_fittable(time, values, is_angle):
    """Raises BadInput for times and values that cannot be fitted; the message has a line of numpy that repairs them."""
    if time.size < 5 or np.ptp(values) == 0:
        raise ring.BadInput(f"the run has {time.size} points, or all are equal; measure at least 5 of a glass that begins to turn")
    step, jumps = np.diff(time), np.abs(np.diff(values, 2))
    i = int(step.argmin()) + 1
    if step[i - 1] <= 0:
        cure = (f"the clock began anew: fit one recording, time[{i}:] or time[:{i}], and the values alike" if step[i - 1] < 0 else
                "keep the first of equal times: time, kept = numpy.unique(time, return_index=True), and values[kept]")
        raise ring.BadInput(f"the time goes from {time[i - 1]:.9g} to {time[i]:.9g} at point {i}; {cure}")
    if time[-1] - time[0] > 1e4:
        raise ring.BadInput(f"the times span {time[-1] - time[0]:.3g}; times are in seconds: time = 1e-9 * time for nanoseconds, "
                            "1e-3 * time for milliseconds")
    # A wrapped angle has two large second differences of opposite sign; an angle read once per turn has none.
    pairs = np.minimum(jumps[1:], jumps[:-1]) * is_angle
    i = int(pairs.argmax())
    for turn, cure in ((2 * np.pi, "numpy.unwrap(angle)"), (360.0, "numpy.unwrap(numpy.radians(angle))")):
        if 0.8 < pairs[i] / turn < 1.2:
            raise ring.BadInput(f"the angle jumps by a turn at point {i + 1}, {values[i + 1]:.4g}; count turns on: angle = {cure}")


class _Run:
    """Measured run with times since the first point; the spin-up of its study is the initial guess."""
    def __init__(self, study, time, omega, angle, sigma, start, zero):
        if (omega is None) == (angle is None):
            raise ring.BadInput("a run has spins or angles; give omega or angle")
        self.study, self.is_angle, self.unit, self.name = study, omega is None, *(("rad", "angle") if omega is None else ("rad/s", "omega"))
        time, values = (np.ma.filled(np.ma.asarray(one, dtype=float), np.nan) for one in (time, angle if omega is None else omega))
        if time.ndim != 1 or time.shape != values.shape:
            raise ring.BadInput(f"times have the shape {time.shape}, values {values.shape}; give two columns of the same length")
        kept = np.isfinite(time) & np.isfinite(values)
        _require_fittable(time[kept], values[kept], self.is_angle)
        self.kept, self.time, self.values = np.flatnonzero(kept), time[kept] - time[kept][0], values[kept]
        # The second difference of white noise has 6 times the variance of the noise.
        scatter = max(np.sqrt(np.mean(np.diff(self.values, 2) ** 2) / 6), 1e-6 * np.ptp(self.values))
        self.has_sigma = sigma is not None
        self.stated = self.sigma = np.broadcast_to(scatter if sigma is None else np.asarray(sigma, dtype=float), time.shape)[kept]
        if not np.all(self.sigma > 0):
            raise ring.BadInput("sigma is the standard deviation of the values; give numbers greater than 0")
        end, grid = self.time[-1], np.linspace(0, 2 * self.time[-1], 800)
        model = study.spin_up(grid)[self.is_angle]
        self.rise = grid[np.argmax(np.abs(model) > 0.63 * np.abs(model[-1]))] or end
        self.start, self.latest = _prior(start, (0, 100 * self.rise + end)), 0.8 * end if start is None else np.inf
        self.zero = _prior(zero, (self.values[0], np.inf) if self.is_angle else (0, 0.01))
        tried = np.linspace(-5 * self.rise, 0.75 * end, 400) if start is None else [self.start[0]]
        left = [self.values - np.interp(self.time - one, grid, model, left=0.0) for one in tried]
        zeros = [np.mean(one) if self.is_angle and self.zero[1] else self.zero[0] for one in left]
        best = np.argmin([np.sum((one - zero) ** 2) for one, zero in zip(left, zeros)])
        self.guess = tried[best], zeros[best]
        turn = np.median(self.values[-max(self.time.size // 4, 1):]) - (self.values[0] if self.is_angle else 0)
        self.turns_back = turn * model[-1] < 0 and abs(turn) > 5 * scatter

    def find_misfits(self, left):
        """Yields warnings about a model with the residuals `left`, measured less fitted."""
        if self.turns_back:
            yield "the glass of the study turns the other way; change the sign of the values, or Motion/Orbit sense"
        t, y, m = self.time, self.values, max(self.time.size // 10, 1)
        fast = np.max(np.abs(y[m:] - y[:-m]) / (t[m:] - t[:-m])) if self.is_angle else np.percentile(np.abs(y), 90)
        limit = 1.05 * self.study["Motion/Orbit speed"] / self.study["Glass/Contact radius"]
        if fast > limit:
            yield (f"spins of {fast:.3g} rad/s are over 1.05 v/R = {limit:.3g} rad/s, beyond which friction brakes; for degrees "
                   f"{self.name} = numpy.radians({self.name}), for milliseconds time = 1e-3 * time")
        noise, largest = np.sqrt(np.mean(left**2)), np.ptp(y) if self.is_angle else np.max(np.abs(y))
        if noise > 0.1 * largest:
            yield f"residuals of {noise:.2g} {self.unit} are over a tenth of the largest value, {largest:.3g}; check units and start"
        robust = np.abs(left) / np.maximum(1.4826 * np.median(np.abs(left)), self.stated if self.has_sigma else 0)
        if far := self.kept[robust > 5].tolist():
            yield f"points beyond 5 sigma: {far[:10]}{' and more' * (len(far) > 10)}; without them: numpy.delete(time, {far[:10]})"
        n, high = left.size, np.sum(left > 0)
        runs, mean = 1 + np.sum(np.diff(left > 0)), 1 + 2 * high * (n - high) / n  # runs test of Wald and Wolfowitz
        if (mean - runs) * np.sqrt(n - 1) > 3.3 * (mean - 1):
            yield (f"the residuals have a trend ({runs} runs of equal sign; noise has {mean:.0f}): model or sensor miss something, "
                   "and the standard errors are too small")


class _Problem:
    """Least-squares problem in x: free entries, start and zero of each run that are not fixed, each divided by its scale."""
    def __init__(self, runs, free, threads):
        self.runs, self.free, self.cache, self.warm = runs, list(free), {}, {}
        self.threads = 1 if any(run.study._study.is_collective for run in runs) else threads
        rows = [self._entry(path, prior) for path, prior in free.items()]
        for r, run in enumerate(runs):
            own = f" of run {r + 1}" * (len(runs) > 1)
            rows += [("start" + own, "s", run.guess[0], run.rise, -np.inf, run.latest, *run.start),
                     ("zero" + own, run.unit, run.guess[1], np.ptp(run.values) / 10, -np.inf, np.inf, *run.zero)]
        names, units, *columns = zip(*rows)
        self.guess, *columns = np.array(columns)
        self.is_fitted = columns[-1] > 0  # a standard deviation of 0 fixes the value
        self.names, self.units = ([one for one, fitted in zip(words, self.is_fitted) if fitted] for words in (names, units))
        self.scale, self.lower, self.upper, self.prior, self.spread = (one[self.is_fitted] for one in columns)

    def _entry(self, path, prior):
        study = self.runs[0].study.copy()
        entry = {one["path"]: one for one in study._study.entries()}.get(path)
        if entry is None or not isinstance(entry["value"], float):
            raise ring.BadInput(f"{path} is no number that can be fitted; see study.entries()")
        value, spread = _prior(prior, (entry["value"], np.inf))
        lower, scale = -np.inf, abs(value) or {"N m": 1e-3, "m": 1e-2, "kg": 0.1}.get(entry["unit"], 1.0)
        for number, bound in ((-1e-9, 0.0), (0.0, 1e-3 * scale)):
            try:
                study[path] = number
            except ring.BadInput:
                lower = bound
        return path, entry["unit"], max(value, lower + 0.1 * scale), scale, lower, np.inf, value, spread

    def _solved(self, r, entries, slot):
        """Returns the torque of a run as a function of the spin, or the exception if the study has no solution."""
        study = self.runs[r].study.copy()
        try:
            for path, value in zip(self.free, entries):
                study[path] = value
            return study._torque(self.warm.setdefault((r, slot), Start()))
        except (ring.BadInput, ring.NoBalance) as failure:
            return failure

    def _models(self, points):
        """Returns the model at the times of all runs, one row per point of `points`; NaN without a spin-up. Threads solve the loads."""
        n, rows = len(self.free), np.array([self.guess] * len(points))
        rows[:, self.is_fitted] = points * self.scale
        load_of = lambda r, row: (r, *(value for path, value in zip(self.free, row) if path not in _not_of_the_load))
        jobs = {load_of(r, row): (r, row[:n], slot) for slot, row in reversed([*enumerate(rows)]) for r in range(len(self.runs))}
        with concurrent.futures.ThreadPoolExecutor(self.threads) as pool:
            torques = dict(zip(jobs, pool.map(lambda job: self._solved(*job), jobs.values())))
        def curve(r, run, row):
            torque, (start, zero) = torques[load_of(r, row)], row[n + 2 * r:n + 2 * r + 2]
            late, found = run.time > start, np.full(run.time.size, np.nan if isinstance(torque, Exception) else zero)
            if late.any() and not isinstance(torque, Exception):
                own = dict(zip(self.free, row))
                found[late] += torque.spin_up(run.time[late] - start, *(own.get(one, run.study[one]) for one in _not_of_the_load))[run.is_angle]
            return found
        return np.array([np.concatenate([curve(r, run, row) for r, run in enumerate(self.runs)]) for row in rows])

    def evaluate(self, x):
        """Returns the model at the times of all runs and its derivatives with respect to x."""
        if x.tobytes() not in self.cache:
            first, *moved = self._models(np.vstack([x, x + 1e-3 * np.eye(x.size)]))
            self.cache = {x.tobytes(): (first, np.nan_to_num((np.array(moved) - first).T / 1e-3))}  # NaN after the glass tips
        return self.cache[x.tobytes()]


    all = lambda self, key: np.concatenate([getattr(run, key) for run in self.runs])

    def residuals(self, x):
        left = self.evaluate(x)[0] - self.all("values")
        return np.concatenate([left / self.all("sigma"), (x * self.scale - self.prior) / self.spread])

    def jacobian(self, x):
        return np.vstack([self.evaluate(x)[1] / self.all("sigma")[:, None], np.diag(self.scale / self.spread)])

    def covariance(self, x):
        """Returns the covariance of x and, for each point, 1 - leverage; their sum is the number of degrees of freedom."""
        slopes = self.jacobian(x)
        covariance = np.linalg.pinv(slopes.T @ slopes, hermitian=True) + np.diag(np.where(slopes.any(axis=0), 0, 1e30))
        return covariance, 1 - np.sum((slopes @ covariance) * slopes, axis=1)[:-x.size]

    def update_sigma(self, x):
        """Sets sigma of the runs without a given sigma to the standard deviation of the residuals. Returns its relative change."""
        factor = np.sqrt(np.sum(self.residuals(x)[:-x.size] ** 2) / max(np.sum(self.covariance(x)[1]), 1.0))
        for run in (without := [run for run in self.runs if not run.has_sigma]):
            run.sigma = run.sigma * factor
        return abs(factor - 1) * bool(without)


class Fit:
    """Result of fit() in SI units.

    names: fitted numbers, entries first. values, standard_errors, units: dicts by name. correlation: matrix in the order of names.
    residuals: measured less fitted, of all runs. reduced_chi2: with the given sigma, or the scatter between neighbouring points.
    runs: a dict per run of the arrays time (since the first point), measured, fitted, residuals, sigma. study: study of the first
    run with the fitted entries. warnings: sentences about undetermined numbers and misfits of the model.
    """
    def __init__(self, problem, x):
        covariance, free = problem.covariance(x)
        errors, self.names = np.sqrt(covariance.diagonal()), problem.names
        numbers = x * problem.scale, errors * problem.scale, problem.units
        self.values, self.standard_errors, self.units = (dict(zip(self.names, one)) for one in numbers)
        self.correlation, self.residuals = covariance / np.outer(errors, errors), problem.all("values") - problem.evaluate(x)[0]
        self.reduced_chi2 = np.sum((self.residuals / problem.all("stated")) ** 2) / free.sum()
        parts = np.split(self.residuals, np.cumsum([run.time.size for run in problem.runs]))
        self.runs = [{"time": run.time, "measured": run.values, "fitted": run.values - left, "residuals": left, "sigma": run.sigma}
                     for run, left in zip(problem.runs, parts)]
        self.study = problem.runs[0].study.copy()
        for path in problem.free:
            self.study[path] = self.values[path]
        together = np.argwhere(np.triu(np.abs(self.correlation), 1) > 0.98)
        self.warnings = [f"{self.names[i]} and {self.names[j]} are known together only (correlation {self.correlation[i, j]:.3f}); "
                         "a run with the hand at another height or speed separates them" for i, j in together]
        for r, (run, one) in enumerate(zip(problem.runs, self.runs)):
            self.warnings += [f"run {r + 1}: " * (len(self.runs) > 1) + words for words in run.find_misfits(one["residuals"])]

    def __repr__(self):
        rows = [f"{name:32}{self.values[name]:.6g} ± {error:.2g} {self.units[name]}" for name, error in self.standard_errors.items()]
        return "\n".join([*rows, f"{'reduced chi-squared':32}{self.reduced_chi2:.3g}", *self.warnings])

    def plot(self, axes: Any = None) -> Any:
        """Draws points, curves and residuals into two axes of matplotlib. Returns the axes."""
        return figures.fit(self, axes)


def fit(study: Any, time: Any, omega: Any = None, free: Any = (), sigma: Any = None, start: Any = None, zero: Any = None,
        angle: Any = None, threads: int = 2) -> Fit:
    """Fits entries of a study to a measured spin-up from rest. Returns a Fit.

    time [s], and omega [rad/s] or angle [rad], counter-clockwise > 0: arrays; points that are not finite are omitted. Several runs:
    lists of arrays, and one value or a list for study, sigma, start and zero. free: paths of entries, the same in all runs, or
    a dict {path: (value, standard deviation)} of priors (None: no prior). sigma: standard deviation of the values, by default of
    the residuals. start: time from the first point to the begin of sliding [s]. zero: offset of the gyroscope at rest, by default
    0 ± 0.01 rad/s, or angle at the start. start and zero: None (fitted), a number (fixed), or a prior. Warns by UserWarning.
    """
    from scipy.optimize import least_squares
    n = len(time) if (several := isinstance(time, (list, tuple)) and len(time) > 0 and np.ndim(time[0]) > 0) else 1
    given = [one if several and isinstance(one, list) else [one] * n for one in (study, time, omega, angle, sigma, start, zero)]
    if any(len(one) != n for one in given):
        raise ring.BadInput(f"there are {n} times; give {n} values, or one for all runs, of the other arguments")
    free = free if isinstance(free, dict) else dict.fromkeys([free] if isinstance(free, str) else free)
    if not free:
        raise ring.BadInput('no entry is free; give free=["Motion/Friction coefficient"]')
    problem = _Problem([_Run(*one) for one in zip(*given)], free, threads)
    x, bounds = problem.guess[problem.is_fitted] / problem.scale, (problem.lower / problem.scale, problem.upper / problem.scale)
    if idle := [name for name, slope in zip(problem.names, problem.jacobian(x).T) if not slope.any()]:
        raise ring.BadInput(f"{idle[0]} has no effect on this spin-up; leave it out of free")
    for _ in range(5):
        found = least_squares(problem.residuals, x, problem.jacobian, bounds, x_scale="jac", ftol=1e-7, xtol=1e-7, max_nfev=50)
        if problem.update_sigma(x := found.x) < 0.01:
            break
    result = Fit(problem, x)
    result.warnings += ["the search did not end; give other values of the entries in the study"] * (found.status == 0)
    for words in result.warnings:
        warnings.warn(words, stacklevel=2)
    return result
