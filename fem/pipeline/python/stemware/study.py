"""Studies, with the same numbers as the program: a Study has entries, a Result has the document and curves."""
from __future__ import annotations

import atexit
import functools
import html
import json
import os
import shutil
import tempfile
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import ring

try:
    from . import _study
except ImportError as failure:
    raise ImportError("stemware.Study needs the finite elements, which this build of stemware does not have; install deal.II and the other "
                      f"packages of packages.txt and build again, or install the package python3-stemware ({failure})") from failure
from ._study import ContactFailure, OutputFailure, Start  # noqa: F401

if TYPE_CHECKING:
    import pandas

Progress = Optional[Callable[[str, int, int], Any]]
Path = Union[str, "os.PathLike[str]"]


def _no_pickle(self):
    raise TypeError("a Start holds solved contacts, which stay in their process; make one Start in each process")


Start.__reduce__ = _no_pickle


@functools.lru_cache(None)
def _mpi():
    """Starts MPI for the first solid foot; MPI ends when Python exits."""
    atexit.register(_mpi.cache_clear)
    return _study.MpiSession()


def _text(value):
    """Returns the text of a value in a study file: numbers to the last digit, texts (with units) unchanged."""
    if isinstance(value, (bool, np.bool_)):
        raise ring.BadInput("an entry takes a number or a text, not True or False")
    return value if isinstance(value, str) else repr(int(value) if isinstance(value, (int, np.integer)) else float(value))


def _digits(value, band):
    """Returns the value with two digits of its band, or six digits without a band."""
    return f"{value:.6g}" if not band else f"{value:.{max(0, 1 - int(np.floor(np.log10(band))))}f}"


def _presets():
    return {"glass": _study.glass_presets(), "table": _study.table_presets()}


def limit_cache(n: int) -> None:
    """Empties the cache of compliances, which studies with equal meshes share, and limits it to n entries (at start 128) of 0.1
    to 1 MB each."""
    _study.limit_cache(n)


def presets() -> pandas.DataFrame:
    """Returns the presets of glasses and tables: a DataFrame with kind, name, words (a description) and entries (lines of a
    study file)."""
    import pandas
    return pandas.DataFrame([{"kind": kind, "name": one.name, "words": one.words, "entries": one.entries}
                             for kind, all in _presets().items() for one in all])


class Study:
    """Study(), Study("my_glass.prm"), Study(text="..."), Study(glass="tumbler", table="oak"); entries={path: value}.

    study["Motion/Mass"] = "250 g" sets an entry: a text as in a study file, or a number in SI units. A value of the wrong kind
    raises BadInput at once; the combination of entries is checked by check() and when the study is solved. Arguments of the
    solvers: threads, their number; progress, a function called as progress(stage, done, all); Ctrl-C ends the work.

    >>> study = Study()
    >>> study["Motion/Mass"] = "250 g"
    >>> study["Motion/Mass"]
    0.25
    """

    def __init__(self, file: Path = "", *, text: Optional[str] = None, glass: str = "", table: str = "",
                 entries: Optional[Mapping[str, Any]] = None):
        if bool(file) + (text is not None) + bool(glass or table) > 1:
            raise ring.BadInput("a study comes from a file, a text or a preset; give one of them")
        if glass or table:
            given = {"glass": glass, "table": table}
            text = _study.new_study_text(*(_study.preset_of(all, kind, given[kind] or all[0].name)
                                           for kind, all in _presets().items()), "study.prm")
        self._source = os.path.abspath(file) if file else "", text
        self._study = _study.Study(os.fspath(file), text)
        self.changes: Dict[str, str] = {}
        if file:
            self._study.name = os.path.splitext(os.path.basename(file))[0]
        for path, value in (entries or {}).items():
            self[path] = value

    def __setitem__(self, path: str, value: Any) -> None:
        self._study.assign(path, _text(value))
        self.changes[path] = _text(value)

    def __getitem__(self, path: str) -> Any:
        return self._study.value(path)

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def keys(self) -> List[str]:
        """Returns the paths of all entries."""
        return [one["path"] for one in self._study.entries()]

    def __reduce__(self):
        return _restored, (*self._source, self.changes)

    def copy(self) -> Study:
        """Returns a Study with the same source and the same changed entries."""
        return _restored(*self._source, self.changes)

    def __repr__(self):
        return f"Study({self._study.name!r}, entries={self.changes!r})"

    def entries(self) -> pandas.DataFrame:
        """Returns all entries: a DataFrame by path with value, unit, allowed, help and given (False: the default)."""
        import pandas
        return pandas.DataFrame(self._study.entries()).set_index("path")

    def prm(self) -> str:
        """Returns the text of a study file."""
        return self._study.prm()

    def check(self) -> List[str]:
        """Returns a list of warnings about implausible values; raises BadInput if the entries contradict each other."""
        self._study.check()
        return self._study.notes()

    def _ready(self):
        if self._study.is_collective:
            if int(os.environ.get("OMPI_COMM_WORLD_SIZE", os.environ.get("PMI_SIZE", 1))) > 1:
                raise ring.BadInput("a solid foot is solved by one process in Python; use `mpirun stemware run` for several")
            _mpi()
        return self._study

    def answer(self, start: Optional[Start] = None) -> Dict[str, Any]:
        """Returns the numbers of one case of `stemware sweep`, a dict by key; None for a number that does not exist. It is the
        fastest way to a terminal spin. Raises BadInput, ContactFailure, NoBalance or a class derived from NoBalance.

        start: a stemware.Start(), whose contact is the initial guess (warm start) and is replaced by the contact of this study.
        It saves time for similar studies; the numbers then depend on it within the tolerance of the contact.
        """
        return self._ready().answer(start)

    def run(self, quick: bool = False, threads: int = 1, progress: Progress = None, start: Optional[Start] = None) -> Result:
        """Returns the Result of `stemware run`, without files and fields; quick: without budget and bands. For start and
        exceptions see answer()."""
        return Result._of(_study.Found("run", self._ready(), quick, 0, threads, progress, start))

    def _torque(self, start=None):
        """Returns the torque as a function of the spin, from which spin-ups with any grip torque and yaw inertia follow."""
        return _study.FreeTorque(self._ready(), start)

    def spin_up(self, times: Any, start: Optional[Start] = None) -> Tuple[np.ndarray, np.ndarray]:
        """Returns two arrays, spin [rad/s] and yaw angle [rad] of a spin-up from rest at increasing times >= 0 [s]; NaN after the
        glass has tipped. For start and exceptions see answer()."""
        times = np.asarray(times, dtype=float)
        if times.ndim != 1 or not np.all(np.isfinite(times)) or np.any(times < 0) or np.any(np.diff(times) <= 0):
            raise ring.BadInput("the times of a spin-up rise from 0 or later; give numpy.linspace(0, 2, 200)")
        found = self._torque(start).spin_up(times, self["Motion/Grip torque"], self["Motion/Yaw inertia"])
        return np.array(found[0]), np.array(found[1])

    def truncate(self, threads: int = 1, progress: Progress = None) -> Result:
        """Returns the Result of `stemware truncate`: the spin over the number of harmonics, result.table("truncation")."""
        return Result._of(_study.Found("truncate", self._ready(), False, 0, threads, progress, None))

    def converge(self, levels: int = 3, threads: int = 1, progress: Progress = None) -> Result:
        """Returns the Result of `stemware converge`: observed orders, limits and bands (grid convergence index)."""
        return Result._of(_study.Found("converge", self._ready(), False, levels, threads, progress, None))


def _restored(file, text, changes):
    return Study(file, text=text, entries=changes)


def _on_grid(points):
    """Returns theta (n,), r (n, m) and p (n, m) of the pressure's cuts at equal angles, one row per angle in ascending order; the
    flat columns if the cuts differ in their number of points."""
    theta = points["theta"]
    m = int(np.argmax(theta != theta[0])) or theta.size if theta.size else 1
    if theta.size % m or (theta.reshape(-1, m) != theta[::m, None]).any():
        return points
    order = np.argsort(theta[::m], kind="stable")
    return {"theta": theta[::m][order], **{key: points[key].reshape(-1, m)[order] for key in "rp"}}


class Result:
    """Result of a solver. document: the dict of summary.json (docs/summary.md). curves: "torque", "spin_up" and "load", each a
    dict of arrays in SI units, and "pressure": theta (n,) [rad], and r and p on its grid, (n, m) [m, Pa].
    result["ring/omega_terminal"]: value by its path; result.ring: a part."""

    def __init__(self, document: Dict[str, Any], curves: Optional[Dict[str, Any]] = None, found: Any = None):
        self.document, self.curves, self._found = document, curves or {}, found

    @classmethod
    def _of(cls, found):
        curves = {name: ring._columns(one) if isinstance(one, np.ndarray) else one for name, one in found.curves().items()}
        if "pressure" in curves:
            curves["pressure"] = _on_grid(curves["pressure"])
        return cls(json.loads(found.document()), curves, found)

    def __getitem__(self, path: str) -> Any:
        part = self.document
        for key in path.split("/"):
            part = part[int(key) if isinstance(part, list) else key]
        return part

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self.__dict__.get("document", {}):
            raise AttributeError(f"the result has no {name}")
        return self.document[name]

    def __getstate__(self):
        return {"document": self.document, "curves": self.curves, "_found": None}

    def _spin_text(self):
        """Returns the terminal spin as text, rounded to two digits of its band."""
        band = ((self.document.get("error_bands") or {}).get("omega_terminal") or {}).get("band")
        return "none" if self.omega is None else _digits(self.omega, band) + (f" ± {band:.1e}" if band else "")

    def __repr__(self):
        verb = self.document["verb"]
        return f"Result({verb}: terminal spin {self._spin_text()} rad/s)" if "ring" in self.document else f"Result({verb})"

    @property
    def omega(self) -> Optional[float]:
        """Terminal spin [rad/s]; None without one."""
        return self["ring/omega_terminal"]

    def table(self, name: str) -> pandas.DataFrame:
        """Returns a list of the document ("budget", "without", "truncation") as a DataFrame; attrs["units"]: unit by column."""
        import pandas
        frame = pandas.DataFrame(self[name])
        frame.attrs["units"] = {key: _study.unit(key, name) for key in frame}
        return frame

    def bands(self) -> pandas.DataFrame:
        """Returns the error bands, a DataFrame by quantity: value, band (half-width) and the parts of the band; attrs["units"]:
        unit by quantity."""
        import pandas
        if not self.document.get("error_bands"):
            raise ring.BadInput("this result has no error bands; solve it with run() without quick")
        rows = {key: {"value": one["value"], "band": one["band"], **one["parts"]} for key, one in self["error_bands"].items()}
        frame = pandas.DataFrame.from_dict(rows, orient="index")
        frame.attrs["units"] = {key: one["unit"] for key, one in self["error_bands"].items()}
        return frame

    def load(self, at: str = "rest") -> ring.RingStack:
        """Returns the load at "rest" or at the "terminal" spin as a ring.RingStack, the same at every spin. Its tilt is the
        smallest tilt that gives the lean torque of the glass in that state."""
        part, lean = self["load" if at == "rest" else "load_at_terminal"], self["ring/lean_torque_at_" + at] or 0.0
        load = {"radii": part["radii"], **{key: [one[key] for one in part["rings"]] for key in "ab"}}
        moment = ring.RingStack(**load).moment
        return ring.RingStack(**load, tilt=-lean * moment / (moment @ moment) if lean else (0.0, 0.0))

    def save(self, folder: Path) -> None:
        """Writes the program's folder of results, without fields; overwrites earlier results of Stemware."""
        if self._found is None:
            raise ring.BadInput("this result was read or sent from another process; save it where it was solved")
        self._found.save(os.path.abspath(folder))

    def page(self, path: Path) -> None:
        """Writes the report, an HTML file, to path."""
        with tempfile.TemporaryDirectory() as folder:
            self.save(os.path.join(folder, "results"))
            shutil.move(os.path.join(folder, "results", "report.html"), path)

    def _repr_html_(self):
        def show(row, key):
            value = row[key]
            digits = _digits(value, 1e-4 * abs(self.omega or 1)) if isinstance(value, float) else str("" if value is None else value)
            return html.escape(digits)
        if "ring" not in self.document:
            return f"<p>{html.escape(self.document['verb'])}</p>"
        keys = ("step", "name", "harmonics", "omega_terminal", "difference")
        # Rows of harmonics without an effect on the spin are omitted.
        rows = "".join("<tr>" + "".join(f"<td>{show(row, key)}</td>" for key in keys) + "</tr>" for row in self.document["budget"] or []
                       if row["difference"] is None or abs(row["difference"]) > 1e-6 * abs(self.omega or 1))
        return (f"<p>terminal spin <b>{self._spin_text()}</b> rad/s, {html.escape(str(self['ring/standing']))}</p><table><tr><th></th>"
                f"<th>model</th><th>harmonics</th><th>rad/s</th><th>difference</th></tr>{rows}</table>")


def read(folder: Path) -> Result:
    """Returns the Result in a folder written by the program or by save(); without curves."""
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return Result(json.load(file))
