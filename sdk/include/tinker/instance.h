/* Tinker SDK: one block as drawing and editing see it. */
#ifndef TINKER_INSTANCE_H
#define TINKER_INSTANCE_H

#include "block.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An end of an instance: where it lies now (m), how what it is on is turned (rad), and what it is attached to. */
#define TINKER_ATTACHED_TO_SUPPORT 2 /* to a block that no force moves */
typedef struct TinkerEnd {
    double x, y;
    int32_t attached; /* 0: to nothing, 1: to a body, or TINKER_ATTACHED_TO_SUPPORT */
    int32_t reserved;
    double angle;
} TinkerEnd;

/* Everything is borrowed for the length of the call. */
typedef struct TinkerInstance {
    uint32_t struct_size;
    int32_t ends;          /* entries of `end` */
    const char *name;      /* "Spring 0" */
    const double *columns; /* the instance's columns, in the order of the declaration, SI; of a waveform its value,
                               first and second derivative at `time`; the length of what is wound on a body
                               (a row with `angles`, TINKER_MEANING_RADIUS and _LENGTH) as it is then; NAN: not known */
    const TinkerEnd *end;  /* of a block that is itself a body: none */
    double x, y;           /* its centre now; of a connector the middle of its ends; of a block that has neither ends
                               nor a place (a field): the corner of the canvas where the host wants it shown */
    double orientation;    /* rad */
    double time;           /* s */
    double symbol_size; /* m: that of the style it is drawn with, so that what is hit is what was drawn; 0: unknown */
    const double *path; /* of a type with TINKER_LEAVES_PATH: x, y of each place where its first end has been up to
                           now, from the start on; else NULL */
    int32_t path_count; /* places; 0 where nothing has run */
    int32_t point_list_count;
    const TinkerPointList *point_lists; /* of the properties with TINKER_TEXT_POINTS, in order; NULL: there are none */
    int32_t text_count;                 /* entries of `texts` */
    const char *const *texts; /* the values of its properties that are texts, in the order of the declaration, UTF-8 */
    double span; /* of a type with TINKER_HAS_SPAN: how far its first two ends are apart at most in the run that is
                    shown, as far as that is known (m); what is drawn by it does not change with the motion. Else 0 */
} TinkerInstance;

#ifdef __cplusplus
}
#endif
#endif
