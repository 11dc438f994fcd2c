"""Friction of a ring that slides and spins, and the elastic foot of a glass that makes it spin on a table.

`import stemware` loads the ring alone (stemware.ring).
"""
from . import ring  # noqa: F401
