/* Tops: the solid sides of plates, and how bodies lie to them. A top is the side of +y of the plate's own axes, where
 * the frame has the plate. */
#ifndef TINKER_CORE_TOPS_H
#define TINKER_CORE_TOPS_H

#include "scene/frame/frame.h"

typedef struct {
    TinkerBlockId plate; /* TINKER_NO_BLOCK: none */
    double middle[2];    /* m */
    double along[2], normal[2];
    double uphill[2]; /* along or against `along`; of a level top to the right */
    gboolean level;
    double half_width; /* m */
    double angle;      /* rad: the plate's orientation */
} TinkerTop;

/* Whether blocks of this class are plates, and whether they are bodies that can move and lie on one: that a top turns
 * along it, and that go along where it is moved. */
gboolean tinker_class_has_top(const TinkerBlockClass *block_class);
gboolean tinker_class_can_lie(const TinkerBlockClass *block_class);

/* Whether a file may put them on a top in place of a position: those that lie, and boxes and discs that turn. */
gboolean tinker_class_can_be_put(const TinkerBlockClass *block_class);

/* Whether a body turns, and meets tops as a disc or a rectangle: it can be put on one, as it is turned. */
gboolean tinker_body_can_stand(const TinkerFrame *frame, TinkerBlockId body);

/* The top of a plate, solid or not. */
TinkerTop tinker_top_of(const TinkerFrame *frame, TinkerBlockId plate);

/* The solid top nearest to a body, with what the body touches before all others. */
TinkerTop tinker_top_nearest(const TinkerFrame *frame, TinkerBlockId body);

/* The solid top that a place (m) is nearest to, within `reach` (m) of its line and over its width; its `plate` is
 * TINKER_NO_BLOCK where there is none. */
TinkerTop tinker_top_at(const TinkerFrame *frame, const double place[2], double reach);

/* How far a place (m) is off the line of a top, in front of it (m). */
double tinker_top_height(const TinkerTop *top, const double place[2]);

/* How far a body reaches from its centre towards a top (m): what lies along it by half its height; what turns as it is
 * turned by `orientation` (rad). */
double tinker_top_reach(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body, double orientation);

/* The orientation (rad) in which a body that can stand lies with a side on the top, of those the one that it has least
 * far to turn to. */
double tinker_top_flat(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body);

/* Of a body: how far its foot is along the top from its middle, and how far its side is off the top (m). */
void tinker_top_foot(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body, double *along, double *gap);
gboolean tinker_top_touches(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body);

/* Turns the bodies that touch a solid top along it, as a run does from its start on. Scenes in which that would take
 * long are left as they are. */
void tinker_tops_turn_bodies(TinkerFrame *frame);

/* A place along the top (m) to so many digits as anybody would type. */
double tinker_top_round(const TinkerTop *top, double along);

/* Where the centre of a body that reaches so far (m) towards the top is when it touches it so far (m) along it from its
 * middle. */
void tinker_top_centre(const TinkerTop *top, double along, double reach, double centre[2]);

#endif
