"""The shared library from Python by ctypes alone: ctypes_consumer.py liboblast.so"""

import ctypes
import sys

double_p, uint32_p, size_t = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_uint32), ctypes.c_size_t


class View(ctypes.Structure):
    _fields_ = [
        ("points", double_p),
        ("point_count", size_t),
        ("contour_ends", uint32_p),
        ("contour_count", size_t),
        ("polygon_ends", uint32_p),
        ("polygon_count", size_t),
    ]


class Error(ctypes.Structure):
    _fields_ = [
        ("status", ctypes.c_int),
        ("operand", size_t),
        ("polygon", size_t),
        ("contour", size_t),
        ("vertex", size_t),
        ("message", ctypes.c_char * 256),
    ]


def view(coordinates, end):
    points, ends = (ctypes.c_double * len(coordinates))(*coordinates), (ctypes.c_uint32 * 1)(end)
    return View(points, len(coordinates) // 2, ends, 1, None, 0)


DIFFERENCE = 2
BAD_OFFSETS = 4
oblast = ctypes.CDLL(sys.argv[1])
oblast.oblast_regions_view.restype = View
oblast.oblast_regions_view.argtypes = oblast.oblast_regions_free.argtypes = [ctypes.c_void_p]
oblast.oblast_signed_area.restype = ctypes.c_double

a, b = view([0, 0, 4, 0, 4, 4, 0, 4], 4), view([2, 2, 6, 2, 6, 6, 2, 6], 4)
result, error = ctypes.c_void_p(), Error()
status = oblast.oblast_overlay(
    ctypes.byref(a), ctypes.byref(b), DIFFERENCE, None, ctypes.byref(result), ctypes.byref(error)
)
assert status == 0, error.message
difference = oblast.oblast_regions_view(result)
assert difference.point_count == 6
assert oblast.oblast_signed_area(ctypes.byref(difference), None) == 12
oblast.oblast_regions_free(result)
status = oblast.oblast_unite(ctypes.byref(view([0, 0, 1, 0, 1, 1], 5)), None, ctypes.byref(result), ctypes.byref(error))
assert status == BAD_OFFSETS and b"contour" in error.message, error.message
print(f"oblast {oblast.oblast_version()}: right")
