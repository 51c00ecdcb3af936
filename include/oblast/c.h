/* The C interface: for C, and for other languages through their foreign-function interface.
 *
 * Handles are opaque and no exception leaves a function. A function that can fail returns an oblast_status and, if
 * `error` is not NULL, says there what was wrong and where. All functions may be called from several threads at once,
 * on handles that no other thread changes. Names and enumerators are stable within a major version.
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
  OBLAST_BAD_OFFSETS,   /* contour_ends or polygon_ends decrease or run past the end */
  OBLAST_BAD_OPTION,    /* an option is out of range or contradicts another */
  OBLAST_PRECONDITION,  /* the input is outside the stated domain of the function */
  OBLAST_CANCELLED,     /* the progress function returned 0 */
  OBLAST_MEMORY_LIMIT,  /* the call needs more memory than oblast_options_set_memory() allows */
  OBLAST_OUT_OF_MEMORY, /* the system has no more memory */
  OBLAST_NULL_POINTER,  /* an argument that must not be NULL is */
  OBLAST_UNKNOWN = 1000 /* an error that this interface has no name for */
} oblast_status;

/* What was wrong and where. A place that does not apply is SIZE_MAX. */
typedef struct oblast_error {
  oblast_status status;
  size_t operand; /* 0: a, 1: b */
  size_t polygon;
  size_t contour; /* index within the operand */
  size_t vertex;  /* index within the contour */
  char message[256];
} oblast_error;

/* Contours as arrays of the caller's. Contour c has the vertices contour_ends[c - 1] (or 0) to contour_ends[c] - 1; its
 * first vertex is not repeated. Polygon p has the contours polygon_ends[p - 1] (or 0) to polygon_ends[p] - 1; without
 * polygon_ends each contour is a polygon. Nothing is copied.
 */
typedef struct oblast_view {
  const double* points; /* x and y of each vertex: 2 * point_count numbers */
  size_t point_count;
  const uint32_t* contour_ends;
  size_t contour_count;
  const uint32_t* polygon_ends; /* may be NULL */
  size_t polygon_count;         /* 0 where polygon_ends is NULL */
} oblast_view;

typedef enum oblast_operation {
  OBLAST_INTERSECTION = 0,
  OBLAST_UNION = 1,
  OBLAST_DIFFERENCE = 2,
  OBLAST_SYMMETRIC_DIFFERENCE = 3
} oblast_operation;

typedef enum oblast_fill {
  OBLAST_FILL_POLYGONS = 0, /* each polygon is the even-odd of its own rings; the operand is their union */
  OBLAST_FILL_AT_LEAST = 1, /* covered by at least `depth` polygons */
  OBLAST_FILL_EVEN_ODD = 2, /* these read all contours of an operand together, as they are directed */
  OBLAST_FILL_NONZERO = 3,
  OBLAST_FILL_POSITIVE = 4,
  OBLAST_FILL_NEGATIVE = 5
} oblast_fill;

typedef struct oblast_options oblast_options; /* options of a call; NULL stands for the defaults */
typedef struct oblast_regions oblast_regions; /* a region set: the result of a call */

/* Asked from time to time with the fraction done, 0 to 1. Return 0 to cancel. It may be called from other threads, but
 * never from two at once. */
typedef int (*oblast_progress)(double fraction, void* data);

/* The version of the library that is linked, as OBLAST_VERSION_NUMBER. */
OBLAST_API int oblast_version(void);

/* Default options; NULL if there is no memory. Free them with oblast_options_free(), which takes NULL, too. */
OBLAST_API oblast_options* oblast_options_new(void);
OBLAST_API void oblast_options_free(oblast_options* options);
OBLAST_API void oblast_options_set_threads(oblast_options* options, int threads);      /* 1 to 1024; 0: all cores */
OBLAST_API void oblast_options_set_memory(oblast_options* options, size_t most_bytes); /* 0: no limit */
OBLAST_API void oblast_options_set_progress(oblast_options* options, oblast_progress progress, void* data);
/* operand 0 or 1; fill is one of oblast_fill; depth counts for OBLAST_FILL_AT_LEAST only. */
OBLAST_API void oblast_options_set_fill(oblast_options* options, int operand, int fill, int32_t depth);
/* Not 0: vertices exactly on the line between their neighbours are left out of the result. */
OBLAST_API void oblast_options_set_minimal(oblast_options* options, int minimal);
/* Not 0: the calls keep their memory for the next call with these options (one call at a time is quickest). */
OBLAST_API void oblast_options_set_workspace(oblast_options* options, int keep);

/* a OPERATION b; operation is one of oblast_operation. On success *result is a new region set; else it is NULL. Cost:
 * O((n + k) log n). */
OBLAST_API oblast_status oblast_overlay(const oblast_view* a, const oblast_view* b, int operation,
                                        const oblast_options* options, oblast_regions** result, oblast_error* error);
/* The union of all polygons of a. */
OBLAST_API oblast_status oblast_unite(const oblast_view* a, const oblast_options* options, oblast_regions** result,
                                      oblast_error* error);

/* The arrays of a region set, valid until it is freed. */
OBLAST_API oblast_view oblast_regions_view(const oblast_regions* regions);
OBLAST_API void oblast_regions_free(oblast_regions* regions);
/* Shells count positive, holes negative, as they are directed. 0 and an error for bad offsets. */
OBLAST_API double oblast_signed_area(const oblast_view* a, oblast_error* error);

#ifdef __cplusplus
}
#endif

#endif
