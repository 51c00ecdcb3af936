"""The exception of all functions."""

from __future__ import annotations

__all__ = ["OblastError"]


class OblastError(ValueError):
    """Faulty data or options, or a call that needs more memory than it may have.

    Degenerate geometry is never an error: operands may cross themselves, overlap, touch and repeat.

    Attributes
    ----------
    code : str
        ``"not_finite"``, ``"out_of_domain"``, ``"too_large"``, ``"bad_offsets"``, ``"bad_option"``,
        ``"precondition"``, ``"memory_limit"`` or ``"bad_wkb"``.
    operand : int or None
        0 for the first operand, 1 for the second one.
    row, polygon, ring : int or None
        Indices within the operand.
    vertex : int or None
        Index within the ring.
    byte : int or None
        Number of bytes before the fault, in WKB.

    Examples
    --------
    >>> import oblast
    >>> try:
    ...     oblast.union_all(([[0, 0], [1, 0], [float("nan"), 1]], [0, 3]))
    ... except oblast.OblastError as error:
    ...     print(error.code, error.row, error.ring, error.vertex)
    not_finite 0 0 2
    """

    def __init__(
        self,
        message: str,
        code: str = "precondition",
        *,
        operand: int | None = None,
        row: int | None = None,
        polygon: int | None = None,
        ring: int | None = None,
        vertex: int | None = None,
        byte: int | None = None,
    ) -> None:
        super().__init__(message)
        self.code = code
        self.operand = operand
        self.row = row
        self.polygon = polygon
        self.ring = ring
        self.vertex = vertex
        self.byte = byte

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self.args, self.__dict__
