"""What happens to Z and M, which an overlay of regions of the plane leaves out."""

from __future__ import annotations

import warnings
from typing import Literal

__all__ = ["ZRule", "z_left_out"]

ZRule = Literal["warn", "drop", "error"]


def z_left_out(has_z: bool, rule: ZRule, stacklevel: int = 3) -> None:
    """Warn or raise if there is Z or M, as the caller chose."""
    if rule not in ("warn", "drop", "error"):
        raise ValueError(f"z={rule!r}: expected 'warn', 'drop' or 'error'")
    if not has_z or rule == "drop":
        return
    if rule == "error":
        raise ValueError("geometries have Z or M, which oblast leaves out: z='drop' allows it")
    warnings.warn(
        "Z and M of the geometries are left out; z='drop' says that this is meant",
        UserWarning,
        stacklevel=stacklevel,
    )
