"""Is the wheel whole? Run in an environment that has the wheel and what it requires, and nothing else."""

from __future__ import annotations

import sys

import oblast


def main() -> None:
    a = oblast.from_ragged([[0, 0], [2, 0], [2, 2], [0, 2]], [0, 4])
    b = oblast.from_ragged([[1, 1], [3, 1], [3, 3], [1, 3]], [0, 4])
    r = oblast.union(a, b)
    assert r.area == 7 and oblast.check(r, canonical=True)
    assert oblast.from_arrow(r.to_arrow()).area == 7 and oblast.from_wkb(r.to_wkb()) == r
    assert not {"shapely", "pandas", "pyarrow"} & set(sys.modules)
    with open("/proc/self/maps") as file:
        libraries = {line.split()[-1] for line in file if "libtbb" in line}
    assert libraries and all("/oblast.libs/" in library for library in libraries), libraries
    print(f"oblast {oblast.__version__} in an environment of its own: oneTBB is the one of the wheel")


if __name__ == "__main__":
    main()
