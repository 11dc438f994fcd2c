"""Stemware in Python: friction of loads that slide and spin (stemware.ring), and studies of a wine glass that spins on a table.

`import stemware` loads stemware.ring only. Study, fit, read, solve and figures load their libraries at first use.
"""
from __future__ import annotations

import importlib.util
from typing import TYPE_CHECKING, Any, List

from . import ring  # noqa: F401
from ._ring import __version__  # noqa: F401
from .ring import BadInput, BalanceLost, NoBalance, NoTerminalSpin, Tipping  # noqa: F401

_places = {"Study": "study", "Result": "study", "read": "study", "presets": "study", "ContactFailure": "study",
           "OutputFailure": "study", "Start": "study", "limit_cache": "study", "solve": "many", "fit": "fitting", "Fit": "fitting",
           "study": "", "many": "", "fitting": "", "figures": ""}
if TYPE_CHECKING:  # the attributes that __getattr__ loads
    from . import figures, fitting, many, study  # noqa: F401
    from .fitting import Fit, fit  # noqa: F401
    from .many import solve  # noqa: F401
    from .study import ContactFailure, OutputFailure, Result, Start, Study, limit_cache, presets, read  # noqa: F401

__all__ = ["ring", "BadInput", "BalanceLost", "NoBalance", "NoTerminalSpin", "Tipping"]
if importlib.util.find_spec(__name__ + "._study"):  # false in a build without deal.II
    __all__ += _places


def __getattr__(name: str) -> Any:
    if name not in _places:
        raise AttributeError(f"stemware has no {name}")
    module = importlib.import_module("." + (_places[name] or name), __name__)
    return getattr(module, name) if _places[name] else module


def __dir__() -> List[str]:
    return sorted([*globals(), *_places])
