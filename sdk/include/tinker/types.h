/* Tinker SDK: the words that every other header of the contract is written in.
 *
 * Ground rules of the whole contract:
 *  - only the C library's headers are needed; the headers compile alone as C99, C11, C17, C++11 and C++20;
 *  - strings are UTF-8; physical numbers are `double` in SI (m, kg, s, rad); counts and indices are `int32_t`;
 *  - a struct that crosses the boundary and may grow begins with `struct_size`, which the side that fills it sets to
 *    sizeof the struct it was compiled with. Members are only ever appended, and a member is read only where
 *    TINKER_HAS says that it lies inside the size the other side declared;
 *  - an unset function is NULL and means the default behaviour; an unset number is marked by a flag, never by zero;
 *  - arrays of structs that may grow are spans with a stride.
 */
#ifndef TINKER_TYPES_H
#define TINKER_TYPES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The contract's version. The major number is part of the entry's name; the minor one grows with every addition. */
#define TINKER_ABI_MAJOR 1
#define TINKER_ABI_MINOR 0

/* True where `member` of the struct that `pointer` shows lies inside the size its owner declared. */
#define TINKER_HAS(type, pointer, member)                                                                              \
    ((size_t)(pointer)->struct_size >= offsetof(type, member) + sizeof((pointer)->member))

/* The entry is the one symbol that a plugin exports; everything else is compiled with hidden visibility. */
#if defined(_WIN32)
#define TINKER_EXPORT __declspec(dllexport)
#else
#define TINKER_EXPORT __attribute__((visibility("default")))
#endif

/* `restrict` for C and C++ alike: GCC 12 vectorises a kernel only when its own parameters carry it. */
#if defined(__cplusplus)
#define TINKER_RESTRICT __restrict
#else
#define TINKER_RESTRICT restrict
#endif

/* Before a kernel over plain arrays: built for AVX2 as well, and chosen when the library is loaded. Both do the same
 * operations in the same order, since nothing is contracted, so they give the same bits. Not under the thread
 * sanitizer, which is not up yet when the choice is made. */
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&                       \
    !defined(__SANITIZE_THREAD__)
#define TINKER_VARIANTS __attribute__((target_clones("avx2", "default")))
#else
#define TINKER_VARIANTS
#endif

/* What a callback answers. */
typedef int32_t TinkerStatus;
#define TINKER_OK            0 /* done */
#define TINKER_RETRY_SMALLER 1 /* not computable here; an adaptive method may try a smaller step */
#define TINKER_FAILED        2 /* an instance is at fault: TinkerBatch.failed_instance and .failure say which and why */

/* A borrowed array of structs: element i starts at (const char *)data + i * stride. */
typedef struct TinkerSpan {
    const void *data;
    int32_t count;
    int32_t stride;
} TinkerSpan;

/* Exponents of the four base dimensions, so N/m is {1, 0, -2, 0}. Angles carry their own exponent: a torque per angle
 * is not an energy. */
typedef struct TinkerDimension {
    int8_t mass;
    int8_t length;
    int8_t time;
    int8_t angle;
} TinkerDimension;

/* One interface of a block type, found by its id when the plugin is loaded. `vtable` is borrowed and lives as long as
 * the library; its type is the one that the id's header names. */
typedef struct TinkerInterface {
    const char *id;
    const void *vtable;
} TinkerInterface;

/* The state of a point in the plane, packed as one row so that it can be gathered with a single load:
 * position (m) and velocity (m/s). */
typedef struct TinkerPoint {
    double x, y, vx, vy;
} TinkerPoint;

/* How what a point is fixed to is turned: its angle (rad, counter-clockwise, counting turns), how fast that grows
 * (rad/s), and its acceleration (rad/s^2; 0 where nobody knows it). What cannot turn has rate and acceleration 0. */
typedef struct TinkerPose {
    double angle, rate, acceleration;
} TinkerPose;

#ifdef __cplusplus
}
#endif
#endif
