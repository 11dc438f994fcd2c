"""A study as the program solves it: entries in, a Result out. Loads the program's libraries; deal.II when a foot is made."""
import atexit
import functools
import html
import json
import os
import shutil
import sys
import tempfile

import numpy as np

from . import ring

_flags = sys.getdlopenflags()
try:
    sys.setdlopenflags(_flags | os.RTLD_GLOBAL)  # the program's modules look for their symbols in _study
    from . import _study
except ImportError as failure:
    raise ImportError("this stemware has the ring alone; build the study with `cmake --build` or install the package "
                      f"python3-stemware ({failure})") from failure
finally:
    sys.setdlopenflags(_flags)
from ._study import ContactFailure, OutputFailure  # noqa: F401


@functools.lru_cache(None)
def _mpi():
    """MPI, from the first solid foot to the end of Python."""
    atexit.register(_mpi.cache_clear)
    return _study.MpiSession()


def _text(value):
    """What a study file would say: numbers to the last digit, texts (with units) as they are."""
    if isinstance(value, (bool, np.bool_)):
        raise ring.BadInput("an entry takes a number or a text, not True or False")
    return value if isinstance(value, str) else repr(int(value) if isinstance(value, (int, np.integer)) else float(value))


def _presets():
    return {"glass": _study.glass_presets(), "table": _study.table_presets()}


def limit_cache(n):
    """Forgets what studies with equal meshes share, their compliances, and keeps at most n of them from now on (at first 128),
    0.1 to 1 MB each."""
    _study.limit_cache(n)


def presets():
    """Glasses and tables with names: a DataFrame with kind, name, words and entries (lines of a study file)."""
    import pandas
    return pandas.DataFrame([{"kind": kind, "name": one.name, "words": one.words, "entries": one.entries}
                             for kind, all in _presets().items() for one in all])


class Start:
    """Keeps the contact of one Study.answer(start=...) for the next; for one thread."""
    _foot = None


class Study:
    """Study(), Study("my_glass.prm"), Study(text="..."), Study(glass="tumbler", table="oak"); entries={path: value}.

    study["Motion/Mass"] = "250 g" refuses at once, with the program's sentence, what is no mass; numbers are in SI units. What
    must go together is checked when the study is solved, or by check(). Progress is a function (what, done, all).

    >>> study = Study()
    >>> study["Motion/Mass"] = "250 g"
    >>> study["Motion/Mass"]
    0.25
    """

    def __init__(self, file="", *, text=None, glass="", table="", entries=None):
        if bool(file) + (text is not None) + bool(glass or table) > 1:
            raise ring.BadInput("a study comes from a file, a text or a preset; give one of them")
        if glass or table:
            given = {"glass": glass, "table": table}
            text = _study.new_study_text(*(_study.preset_of(all, kind, given[kind] or all[0].name)
                                           for kind, all in _presets().items()), "study.prm")
        self._source = os.path.abspath(file) if file else "", text
        self._study = _study.Study(os.fspath(file)) if text is None else _study.Study.of_text("the text", text)
        self.changes = {}
        if file:
            self._study.name = os.path.splitext(os.path.basename(file))[0]
        for path, value in (entries or {}).items():
            self[path] = value

    def __setitem__(self, path, value):
        self._study.assign(path, _text(value))
        self.changes[path] = _text(value)

    def __getitem__(self, path):
        return self._study.value(path)

    def __reduce__(self):
        return _restored, (*self._source, self.changes)

    def copy(self):
        return _restored(*self._source, self.changes)

    def __repr__(self):
        return f"Study({self._study.name!r}, entries={self.changes!r})"

    def entries(self):
        """All that can be set: a DataFrame by path with value, unit, allowed, help, given."""
        import pandas
        return pandas.DataFrame(self._study.entries()).set_index("path")

    def prm(self):
        """The study as the text of a study file."""
        return self._study.prm()

    def check(self):
        """Raises BadInput if the entries do not go together; returns a list of warnings about values that no glass has."""
        self._study.check()
        return self._study.notes()

    def _ready(self):
        if self["Contact/Body"] == "solid":
            if int(os.environ.get("OMPI_COMM_WORLD_SIZE", os.environ.get("PMI_SIZE", 1))) > 1:
                raise ring.BadInput("a solid foot is solved by one process in Python; use `mpirun stemware run` for several")
            _mpi()
        return self._study

    def answer(self, start=None):
        """The numbers that a case of `sweep` has: a dict by key; None where there is none. The quickest way to a spin.

        start: a stemware.Start(), which keeps the contact of its last answer() for the next one to start near it: quicker for
        studies that differ little; the numbers then depend on the one before, by rounding or the tolerance of the contact.
        """
        numbers, foot = self._ready().answer(start and start._foot)
        if start is not None:
            start._foot = foot
        return numbers

    def run(self, quick=False, threads=1, progress=None):
        """Result of `stemware run`, without files and fields; quick: without budget and bands. Raises BadInput, NoBalance
        (and classes derived from it), ContactFailure; Ctrl-C ends it."""
        return Result._of(_study.Found("run", self._ready(), quick=quick, n_threads=threads, progress=progress))

    def truncate(self, threads=1, progress=None):
        """Result of `stemware truncate`: how many harmonics matter, result.table("truncation")."""
        return Result._of(_study.Found("truncate", self._ready(), n_threads=threads, progress=progress))

    def converge(self, levels=3, threads=1, progress=None):
        """Result of `stemware converge`: observed orders, limits, bands (the grid convergence index)."""
        return Result._of(_study.Found("converge", self._ready(), n_levels=levels, n_threads=threads, progress=progress))


def _restored(file, text, changes):
    return Study(file, text=text, entries=changes)


class Result:
    """document: what summary.json says (docs/summary.md); curves: torque, spin_up, load, pressure, each a dict of arrays in SI
    units. result["ring/omega_terminal"] finds a number of the document by its path, result.ring a part of it."""

    def __init__(self, document, curves=None, found=None):
        self.document, self.curves, self._found = document, curves or {}, found

    @classmethod
    def _of(cls, found):
        return cls(json.loads(found.document()), found.curves(), found)

    def __getitem__(self, path):
        part = self.document
        for key in path.split("/"):
            part = part[int(key) if isinstance(part, list) else key]
        return part

    def __getattr__(self, name):
        if name.startswith("_") or name not in self.__dict__.get("document", {}):
            raise AttributeError(f"the result has no {name}")
        return self.document[name]

    def __getstate__(self):
        return {"document": self.document, "curves": self.curves, "_found": None}

    @property
    def omega(self):
        """Terminal spin [rad/s]; None where there is none."""
        return self["ring/omega_terminal"]

    def table(self, name):
        """A list of the document (budget, without, truncation) as a DataFrame; attrs["units"]: unit by column."""
        import pandas
        frame = pandas.DataFrame(self[name])
        frame.attrs["units"] = {key: _study.unit(key, name) for key in frame}
        return frame

    def bands(self):
        """error_bands as a DataFrame by quantity: value, band, and its parts."""
        import pandas
        rows = {key: {"value": one["value"], "band": one["band"], **one["parts"]} for key, one in self["error_bands"].items()}
        return pandas.DataFrame.from_dict(rows, orient="index")

    def load(self, at="rest"):
        """The load as stemware.ring takes it: frozen, it does not react to the spin as the study's does. at: rest or terminal.
        Its tilt is the least one with the lean torque that the glass has there."""
        part, lean = self["load" if at == "rest" else "load_at_terminal"], self["ring/lean_torque_at_" + at] or 0.0
        load = {"radii": part["radii"], **{key: [one[key] for one in part["rings"]] for key in "ab"}}
        moment = ring.RingStack(**load).moment
        return ring.RingStack(**load, tilt=-lean * moment / (moment @ moment) if lean else (0.0, 0.0))

    def save(self, folder):
        """Writes the folder of results that the program writes, without fields; also over an earlier one."""
        if self._found is None:
            raise ring.BadInput("this result was read or sent from another process; save it where it was solved")
        self._found.save(os.path.abspath(folder))

    def page(self, path):
        """Writes report.html as the file path."""
        with tempfile.TemporaryDirectory() as folder:
            self.save(os.path.join(folder, "results"))
            shutil.move(os.path.join(folder, "results", "report.html"), path)

    def _repr_html_(self):
        def show(x):
            return "" if x is None else f"{x:.5g}" if isinstance(x, float) else html.escape(str(x))
        if "ring" not in self.document:
            return f"<p>{show(self.document['verb'])}</p>"
        band = ((self.document.get("error_bands") or {}).get("omega_terminal") or {}).get("band")
        spin = "none" if self.omega is None else show(self.omega) + (f" ± {show(band)}" if band is not None else "")
        keys = ("step", "name", "harmonics", "omega_terminal", "difference")
        rows = "".join("<tr>" + "".join(f"<td>{show(row[key])}</td>" for key in keys) + "</tr>"
                       for row in self.document["budget"] or [])
        return (f"<p>terminal spin <b>{spin}</b> rad/s, {show(self['ring/standing'])}</p><table><tr><th></th><th>model</th>"
                f"<th>harmonics</th><th>rad/s</th><th>difference</th></tr>{rows}</table>")


class Fit(Result):
    """Result of stemware.fit. values, spreads: by entry; correlation: an array; sentences: what the data leave open; runs: a list
    of dicts with start, zero, noise for each; curves: "run_1" and so on, each with time, measured, fitted."""

    @property
    def values(self):
        return {one["entry"]: one["value"] for one in self["fit/entries"]}

    @property
    def spreads(self):
        return {one["entry"]: one["spread"] for one in self["fit/entries"]}

    @property
    def correlation(self):
        return np.array(self["fit/correlation"])

    @property
    def sentences(self):
        return self["fit/sentences"]

    @property
    def runs(self):
        return self["fit/runs"]


def fit(study, data, free, gyroscope_zero="", quick=False, threads=1, progress=None):
    """Fits entries to measured runs of a spin-up, as `stemware fit` does: a Fit.

    data: a file, or arrays (time, spin) in SI units, or a list of runs, each such data or a pair (data, study of its own).
    free: entries, each a path or "path = value +- spread". Files of angles are fitted as angles.
    """
    def run_of(one, own):
        if isinstance(one, (str, os.PathLike)):
            return (os.fspath(one), own._ready(), *_study.read_run(os.fspath(one), own["Motion/Measured column"]))
        time, spin = (np.asarray(column, dtype=float).tolist() for column in one)
        return "data", own._ready(), time, spin, False

    runs = [run_of(*one) if isinstance(one, tuple) and isinstance(one[1], Study) else run_of(one, study)
            for one in (data if isinstance(data, list) else [data])]
    found = _study.fit(runs, [free] if isinstance(free, str) else list(free), gyroscope_zero, quick, threads, progress)
    return Fit._of(found)


def read(folder):
    """The Result of a folder that the program or save() has written; without curves."""
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return Result(json.load(file))
