/* Lines of rods that nothing leads off (straight-bars.h), as the search for them sees them. */
#ifndef TINKER_CORE_STRAIGHT_LINES_H
#define TINKER_CORE_STRAIGHT_LINES_H

#include "physics/constraint/straight-bars.h"
#include "physics/model/model.h"

typedef struct {
    int32_t ends[2];
    double *length; /* as the host keeps it */
    TinkerBlockId block;
} TinkerLineRod;

typedef struct {
    const TinkerModel *model;
    GArray *rods;          /* of TinkerLineRod */
    int32_t *starts, *at;  /* by point: the rods there */
    int32_t *ahead, *back; /* by point: the last search that reached it from either end */
    int32_t searches;
    GArray *queue;    /* of int32_t: points */
    GPtrArray *lines; /* of GArray of int32_t: points */
    int32_t *fitted;  /* how many rods have the length that the others give */
} TinkerLineFinder;

/* A way from `from` along the unit vector `along`, no farther than `most` (m). */
typedef struct {
    int32_t from, skipped; /* a point; a rod that is not followed, or -1 */
    double along[2], most;
    int32_t *reached; /* by point: marked with the number of the search */
} TinkerLineWay;

/* Finds the lines, of three points and more; several may be parts of one bar. Cleared by whoever searched. */
void tinker_line_finder_search(TinkerLineFinder *finder, const TinkerModel *model);
void tinker_line_finder_clear(TinkerLineFinder *finder);

/* From one point towards another, as far as that is. FALSE where they are at one place. */
gboolean tinker_line_aim(const TinkerLineFinder *finder, int32_t from, int32_t to, TinkerLineWay *line);
/* Whether two points of supports keep their distance. */
gboolean tinker_line_stays(const TinkerModel *model, int32_t a, int32_t b);

static inline const TinkerLineRod *tinker_line_rod(const TinkerLineFinder *finder, int32_t number)
{
    return &g_array_index(finder->rods, TinkerLineRod, number);
}

static inline int32_t tinker_line_other_end(const TinkerLineRod *rod, int32_t point)
{
    return rod->ends[rod->ends[0] == point];
}

static inline void tinker_line_way(const TinkerLineFinder *finder, int32_t from, int32_t to, double d[2])
{
    const TinkerPoint *a = &finder->model->point[from], *b = &finder->model->point[to];
    d[0] = b->x - a->x;
    d[1] = b->y - a->y;
}

#endif
