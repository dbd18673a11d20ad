/* Compiling forces along lines, as part of all forces. */
#ifndef TINKER_CORE_COMPILE_LINES_H
#define TINKER_CORE_COMPILE_LINES_H

#include <string.h>

#include "physics/model/model-data.h"

/* One linear law before merging. */
typedef struct {
    int32_t a, b; /* a < b */
    int32_t order;
    double stiffness, length, damping, tension;
} LinearLine;

/* Room to compile forces in. */
typedef struct {
    LinearLine *lines; /* the laws of lines that are linear ... */
    gsize count;       /* ... so far */
    gpointer answers;  /* of one batch to one question */
} CompileWork;

/* (transfer none) */
static inline gpointer tinker_compile_clear_answers(CompileWork *work, gsize bytes)
{
    return memset(work->answers, 0, bytes);
}

/* A law that a waveform changes gives energy of its own accord: nothing it stores is counted, its power is booked
 * whole. */
static inline gboolean tinker_compile_stores_energy(const TinkerBlockBatch *batch, gboolean offered)
{
    return offered && batch->waveforms == 0;
}

/* Lists the laws of a batch between these points, two a block, that are linear with constants. FALSE where they are
 * not. */
gboolean tinker_compile_linear_lines(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points,
                                     CompileWork *work);

/* Those that are not, to be asked at every evaluation. */
void tinker_compile_asked_lines(TinkerModel *model, TinkerBlockBatch *batch, const int32_t *points, CompileWork *work);

/* Linear laws between the same two points become one. No memory: the model says so. */
void tinker_compile_merge_lines(TinkerModel *model, CompileWork *work);

#endif
