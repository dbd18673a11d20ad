/* Boxes: the rectangles that bodies are drawn as. Nothing in a run holds two of them apart; this is for telling of it.
 */
#ifndef TINKER_CORE_BOXES_H
#define TINKER_CORE_BOXES_H

#include "scene/frame/frame.h"

/* Boxes that share less than this (m) touch and do not overlap. */
#define TINKER_BOXES_APART 1e-9

typedef struct {
    TinkerBlockId block;
    double x, y, angle, width, height; /* m, rad */
    double vx, vy;                     /* m/s */
    gboolean collides;                 /* two that do hold each other apart */
} TinkerBox;

/* Half the extent of a box in x and in y. */
void tinker_box_reach(const TinkerBox *box, double reach[2]);

/* Whether two boxes overlap at some time from 0 to `horizon` (s), each moving with its velocity and without turning;
 * `time` is the first. A horizon of 0: whether they do as they are. By separating axes: two rectangles overlap exactly
 * if their shadows on all four directions of their sides do. */
gboolean tinker_boxes_meet(const TinkerBox *a, const TinkerBox *b, double horizon, double *time);

/* Two boxes that meet, and when. */
typedef struct {
    TinkerBlockId first, second;
    double time; /* s */
} TinkerMeeting;

/* The first of all pairs to meet up to the horizon; of several at one time that with the least ids. FALSE where none
 * does, or where more pairs than can be looked at in about a second come near each other. The mean velocity is taken
 * out of the boxes. */
gboolean tinker_boxes_first_meeting(GArray *boxes, double horizon, TinkerMeeting *meeting);

/* The first meeting of the boxes of a scene's bodies, moved on with their start velocities, within this duration (s),
 * and what to say of it (transfer full); NULL where there is none. */
char *tinker_boxes_warning(const TinkerFrame *frame, double duration, TinkerMeeting *meeting);

/* Adds that warning (of char *) where there is one. A scene whose motions fail at the start has none. */
void tinker_boxes_tell(TinkerScene *scene, double duration, GPtrArray *warnings);

#endif
