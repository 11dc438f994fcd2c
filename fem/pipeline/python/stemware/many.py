"""Many studies: solve() takes a table of cases and returns a table of answers; any executor of concurrent.futures works."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable, List, Mapping, Optional, Sequence, Union

from .ring import BadInput, NoBalance

if TYPE_CHECKING:
    import pandas

    from .study import Study


def _solve_one(source, changes, case, quantities):
    """Solves one case. Arguments and result are texts and numbers, so that another process can run the function (pickle)."""
    from .study import Study
    try:
        study = Study(source[0], text=source[1], entries={**changes, **case})
        found = study.answer() if quantities is None else study.run(quick=True)
        return {**{key: found[key] for key in (found if quantities is None else quantities)}, "failure": ""}
    except (BadInput, NoBalance) as failure:
        return {"failure": str(failure)}


def solve(cases: Union[pandas.DataFrame, Sequence[Mapping[str, Any]]], executor: Any = None, study: Union[Study, str, None] = None,
          quantities: Optional[Sequence[str]] = None,
          progress: Optional[Callable[[str, int, int], Any]] = None) -> pandas.DataFrame:
    """Solves the study with the entries of each case. Returns a DataFrame with the columns of cases, the columns of sweep.csv,
    and failure: the message of a case that failed, else an empty text. attrs["units"]: unit by column.

    cases: DataFrame or list of dicts with a column for each entry: numbers in SI units, texts with units, NaN for the study's
    value. executor: None, or an object with map(), for instance of concurrent.futures, dask or mpi4py.futures. study: a Study or
    file with the other entries. quantities: paths in the document of run(quick=True), which replace the columns of sweep.csv.
    progress: a function called as progress("cases", done, all).
    """
    import pandas

    from .study import Study, _study
    study = study if isinstance(study, Study) else Study(study or "")
    frame = cases if isinstance(cases, pandas.DataFrame) else pandas.DataFrame(list(cases))
    work = [(study._source, study.changes, {key: value for key, value in case.items() if value == value}, quantities)
            for case in frame.to_dict("records")]
    rows = []
    for row in (_solve_one(*one) for one in work) if executor is None else executor.map(_solve_one, *zip(*work)):
        rows.append(row)
        if progress:
            progress("cases", len(rows), len(work))
    found = _study.case_keys() if quantities is None else list(quantities)

    def unit_of(path):  # tables of the document declare their units; a sweep declares the other units
        section, _, key = path.rpartition("/")
        return (_study.unit(key, section) if section else "") or _study.unit(key, "sweep.csv").replace("*", "")

    units = {path: unit_of(path) for path in found}
    answers = pandas.DataFrame(rows, index=frame.index).reindex(columns=[*found, "failure"])
    both = pandas.concat([frame, answers], axis=1)
    both.attrs["units"] = {**{key: _study.unit_of_entry(key) for key in frame}, **units}
    return both
