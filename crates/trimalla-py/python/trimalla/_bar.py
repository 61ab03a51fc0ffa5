"""A bar for long work: on a terminal and in a notebook."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable


def bar(progress: bool | Callable[[int, int], object] | None) -> Callable[[int, int], object] | None:
    """The callback of a call: `True` stands for a line on standard error."""
    if progress is True:
        return _Line()
    return progress or None


class _Line:
    """Rewrites one line, twice a second."""

    def __init__(self) -> None:
        self.shown = 0.0

    def __call__(self, vertices: int, waiting: int) -> None:
        if time.monotonic() - self.shown > 0.5:
            self.shown = time.monotonic()
            sys.stderr.write(f"\r{vertices} vertices, {waiting} triangles wait   ")
            sys.stderr.flush()
