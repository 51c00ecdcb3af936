/* The C interface: for C, and for other languages through their foreign-function interface.
 *
 * Handles are opaque. No function throws an exception. oblast_overlay() and oblast_unite() return an oblast_status.
 * If `error` is not NULL, they and oblast_signed_area() fill it. Several threads may call any functions at the same
 * time, as long as no thread changes or frees a handle or an array that another thread uses. Names and enumerators are
 * stable within a major version. The reference for all behaviour is overlay.h and options.h.
 */
#ifndef OBLAST_C_H
#define OBLAST_C_H

#include <oblast/export.h>
#include <oblast/version.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum oblast_status {
  OBLAST_OK = 0,
  OBLAST_NOT_FINITE,    /* a coordinate is NaN or infinite */
  OBLAST_OUT_OF_DOMAIN, /* a coordinate other than 0 has a magnitude below 2^-300 or above 2^300 */
  OBLAST_TOO_LARGE,     /* more vertices or crossings than 32-bit indices allow */
  OBLAST_BAD_OFFSETS,   /* contour_ends or polygon_ends decrease, or do not end at the count that they divide */
  OBLAST_BAD_OPTION,    /* an option or the operation is out of range */
  OBLAST_PRECONDITION,  /* the input is outside the stated domain of the function */
  OBLAST_CANCELLED,     /* the progress function returned 0 */
  OBLAST_MEMORY_LIMIT,  /* the call needs more memory than oblast_options_set_memory() allows */
  OBLAST_OUT_OF_MEMORY, /* the system has no more memory */
  OBLAST_NULL_POINTER,  /* an argument that must not be NULL is NULL */
  OBLAST_UNKNOWN = 1000 /* an error that this interface has no name for */
} oblast_status;

/* What is wrong and where. An index that does not apply is SIZE_MAX. After success, status is OBLAST_OK and the message
 * is empty. A message longer than 255 bytes is cut off. */
typedef struct oblast_error {
  oblast_status status;
  size_t operand; /* 0: a, 1: b */
  size_t polygon;
  size_t contour; /* index within the operand */
  size_t vertex;  /* index within the contour */
  char message[256];
} oblast_error;

/* Contours in arrays that the caller owns. Nothing is copied.
 * Contour c has the vertices contour_ends[c - 1] (0 for the first contour) to contour_ends[c] - 1. A contour is closed
 * without a repetition of its first vertex. Polygon p has the contours polygon_ends[p - 1] (0 for the first polygon) to
 * polygon_ends[p] - 1. If there are no polygon_ends, each contour is a polygon.
 */
typedef struct oblast_view {
  const double* points; /* x and y of each vertex: 2 * point_count numbers */
  size_t point_count;
  const uint32_t* contour_ends;
  size_t contour_count;
  const uint32_t* polygon_ends; /* may be NULL */
  size_t polygon_count;         /* 0 if polygon_ends is NULL */
} oblast_view;

typedef enum oblast_operation {
  OBLAST_INTERSECTION = 0,
  OBLAST_UNION = 1,
  OBLAST_DIFFERENCE = 2,
  OBLAST_SYMMETRIC_DIFFERENCE = 3
} oblast_operation;

typedef enum oblast_fill {
  OBLAST_FILL_POLYGONS = 0, /* each polygon is filled by even-odd of its own rings; the operand is their union */
  OBLAST_FILL_AT_LEAST = 1, /* as OBLAST_FILL_POLYGONS, but inside is what at least `depth` polygons cover */
  /* The others use the winding number of all contours of the operand together, as they are directed: */
  OBLAST_FILL_EVEN_ODD = 2, /* it is odd */
  OBLAST_FILL_NONZERO = 3,  /* it is not zero */
  OBLAST_FILL_POSITIVE = 4, /* it is greater than zero */
  OBLAST_FILL_NEGATIVE = 5  /* it is less than zero */
} oblast_fill;

typedef struct oblast_options oblast_options; /* options of a call; NULL stands for the defaults */
typedef struct oblast_regions oblast_regions; /* a region set: the result of a call */

/* The library calls this function every few milliseconds with the fraction of the work that is done, 0 to 1. Return 0
 * to cancel the call; return any other number to continue. Any thread that works for the call may call the function,
 * but never two threads at once. `data` is the pointer that was given to oblast_options_set_progress(). */
typedef int (*oblast_progress)(double fraction, void* data);

/* The version of the library that is linked, as OBLAST_VERSION_NUMBER. */
OBLAST_API int oblast_version(void);

/* New options with the default values, or NULL if there is no memory. Free them with oblast_options_free(), which also
 * accepts NULL. The setters below require options that are not NULL. They check nothing: the call that uses a value
 * that is out of range returns OBLAST_BAD_OPTION. */
OBLAST_API oblast_options* oblast_options_new(void);
OBLAST_API void oblast_options_free(oblast_options* options);
/* The number of threads, 1 to 1024. 0 (default): all cores. */
OBLAST_API void oblast_options_set_threads(oblast_options* options, int threads);
/* The most memory that a call may use, in bytes. 0 (default): no limit. */
OBLAST_API void oblast_options_set_memory(oblast_options* options, size_t most_bytes);
/* NULL (default): no progress function. */
OBLAST_API void oblast_options_set_progress(oblast_options* options, oblast_progress progress, void* data);
/* The fill rule of operand 0 (a) or 1 (b). `fill` is one of oblast_fill. Only OBLAST_FILL_AT_LEAST uses `depth`; it
 * must be 1 or more. Default: OBLAST_FILL_POLYGONS. */
OBLAST_API void oblast_options_set_fill(oblast_options* options, int operand, int fill, int32_t depth);
/* If `minimal` is not 0, the result leaves out vertices that are exactly on the line between their neighbours. */
OBLAST_API void oblast_options_set_minimal(oblast_options* options, int minimal);
/* If `keep` is not 0, calls keep up to 16 MiB of memory for the next call with these options. The memory is freed with
 * the options. Several calls may share the options at the same time, but one call at a time is fastest. If there is no
 * memory for the workspace, calls work without it. */
OBLAST_API void oblast_options_set_workspace(oblast_options* options, int keep);

/* The overlay a OPERATION b. `operation` is one of oblast_operation. On success *result is a new region set that the
 * caller must free; otherwise it is NULL. Cost: O((n + k) log n) time for n edges that meet at k points. */
OBLAST_API oblast_status oblast_overlay(const oblast_view* a, const oblast_view* b, int operation,
                                        const oblast_options* options, oblast_regions** result, oblast_error* error);
/* The union of all polygons of a, with the fill rule of operand 0. Result and cost as oblast_overlay(). */
OBLAST_API oblast_status oblast_unite(const oblast_view* a, const oblast_options* options, oblast_regions** result,
                                      oblast_error* error);

/* The arrays of a region set. They are valid until the region set is freed. For NULL, an empty view. */
OBLAST_API oblast_view oblast_regions_view(const oblast_regions* regions);
/* Frees a region set; does nothing for NULL. */
OBLAST_API void oblast_regions_free(oblast_regions* regions);
/* The signed area, in squared units of the coordinates. Counter-clockwise contours count positive, clockwise contours
 * negative. For the result of an overlay this is the area of its regions. If the view is not valid, the function
 * returns 0 and fills `error`. Cost: linear. */
OBLAST_API double oblast_signed_area(const oblast_view* a, oblast_error* error);

#ifdef __cplusplus
}
#endif

#endif
