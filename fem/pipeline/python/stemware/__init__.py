"""Stemware in Python: friction of loads that slide and spin (stemware.ring), and studies of a wine glass that spins on a table.

`import stemware` loads stemware.ring only. Study, fit, read, solve and figures load their libraries at first use.
"""
import importlib

from . import ring  # noqa: F401
from .ring import BadInput, BalanceLost, NoBalance, NoTerminalSpin, Tipping  # noqa: F401

_places = {"Study": "study", "Result": "study", "read": "study", "presets": "study", "ContactFailure": "study",
           "OutputFailure": "study", "fit": "study", "Start": "study", "limit_cache": "study", "solve": "many",
           "study": "", "many": "", "figures": ""}


def __getattr__(name):
    if name not in _places:
        raise AttributeError(f"stemware has no {name}")
    module = importlib.import_module("." + (_places[name] or name), __name__)
    return getattr(module, name) if _places[name] else module


def __dir__():
    return sorted([*globals(), *_places])
