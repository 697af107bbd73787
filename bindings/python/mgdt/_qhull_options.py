# SPDX-License-Identifier: MIT
"""Options for Qhull, as SciPy takes them: those that an exact triangulation can heed."""

from __future__ import annotations

import re
from typing import Union

# How Qhull rounds, merges, perturbs, rotates, reports and traces. An exact triangulation into
# tetrahedra in which every distinct point is a vertex has what these ask for.
_NUMBER = r"-?[\d.]+(e[-+]?\d+)?"
_WITHOUT_EFFECT = re.compile(
    rf"d|Qbb|Qc|Qi|Qs|Qt|Qw|Qx|Qz|Qa|Q\d+|QJ({_NUMBER})?|QR(-?\d+)?|Pp|Ts|T\d|[ACERUWV]{_NUMBER}"
)


def check(options: Union[None, str, bytes]) -> None:
    """Raises ValueError for an option that would give another triangulation."""
    if options is None:
        return
    if isinstance(options, bytes):
        options = options.decode("latin-1")
    if not isinstance(options, str):
        raise TypeError(f"qhull_options must be a string or None, not {type(options).__name__}")
    for option in options.split():
        if option == "Qu":
            raise ValueError("mgdt has no furthest-site triangulation (Qhull's option Qu)")
        if not _WITHOUT_EFFECT.fullmatch(option):
            raise ValueError(
                f"mgdt knows no Qhull option {option!r}; of Qhull's options it takes those that "
                "do not change an exact Delaunay triangulation, and they have no effect"
            )
