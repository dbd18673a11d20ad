/* What the files of diagrams as pictures share. */
#ifndef TINKER_HOST_DIAGRAM_PICTURE_PRIVATE_H
#define TINKER_HOST_DIAGRAM_PICTURE_PRIVATE_H

#include "common/diagram/diagram-picture.h"
#include "common/overlay/force-arrows.h"
#include "render/draw/text.h"

/* Canvas units. */
#define DIAGRAM_EDGE 14.0
#define DIAGRAM_TEXT 12.0
#define DIAGRAM_ROW  17.0

#define DIAGRAM_HEADING   20.0
#define DIAGRAM_MOST_BODY 110.0
#define DIAGRAM_TURN_STEP 8.0 /* between turning arrows */

/* What a picture is made from. */
typedef struct {
    const TinkerDiagramPicture *picture;
    TinkerScene *scene;
    cairo_t *cairo;
    TinkerTextPen pen;
    GArray *forces;    /* of TinkerDiagramForce: those that are not 0, */
    GArray *torques;   /* and those whose torque beside that of the force is not 0 */
    double size;       /* N: the greatest force that is drawn to scale; 0: there is none */
    double lesser;     /* canvas units: the least side of the parts of the paper, which all sizes are measured by */
    gboolean numbered; /* arrows have numbers, which the list explains, */
    gboolean brief;    /* and nothing else */
} DiagramDrawing;

/* One part of the paper, in its canvas units: its arrows have a scale of 1 canvas unit. */
typedef struct {
    DiagramDrawing *drawing;
    const TinkerView *view;
    double longest;   /* canvas units: of its arrows */
    GArray *arrows;   /* of TinkerForceArrow */
    GPtrArray *texts; /* their labels */
} DiagramPart;

/* Where turning arrows stand: the middle of the body, the radius of the innermost, and the box that their labels take.
 */
typedef struct {
    double at[2], least, labels[4];
    guint count;
    gboolean bare; /* the resultant is without its value, which the list has */
} DiagramTurns;

void diagram_begin(DiagramDrawing *drawing, const TinkerDiagramPicture *picture, cairo_t *cairo);
void diagram_end(DiagramDrawing *drawing);

/* The size of a force; 0 where it is none. */
double diagram_strength(const double force[2]);
double diagram_greatest_force(const TinkerDiagram *diagram);
/* Whether there is a resultant, m a, that is not just what rounding leaves. */
gboolean diagram_has_resultant(const TinkerDiagram *diagram);
/* Whether a force of this size is longer, or shorter, than it is drawn. */
gboolean diagram_is_broken(const DiagramDrawing *drawing, double size);
gboolean diagram_is_stub(const DiagramDrawing *drawing, double size);

/* (transfer full) */
char *diagram_quantity(const DiagramDrawing *drawing, double value, TinkerDimension dimension);
/* With a minus as it is printed. (transfer full) */
char *diagram_force_text(const DiagramDrawing *drawing, double newtons);
char *diagram_torque_text(const DiagramDrawing *drawing, double newton_metres);
/* Whether there is a moment of the resultant, I alpha, that is not just what rounding leaves. */
gboolean diagram_has_turning(const TinkerDiagram *diagram);
/* "Floor (Normal force)": of what touches there are two forces. (transfer full) */
char *diagram_force_name(const DiagramDrawing *drawing, const TinkerDiagramForce *force);
TinkerArrowKind diagram_arrow_kind(TinkerTermKind kind);
TinkerPointed diagram_pointed(const TinkerDiagramForce *force);
/* (transfer full) */
GPtrArray *diagram_notes(const DiagramDrawing *drawing);

/* diagram-bodies.c: the bodies in the middle of a part of the paper of this size, small enough that the arrows have
 * room around them; their boxes in it, of double[4] (transfer full); and how large (canvas units) a single one is at
 * most. */
TinkerView diagram_view(const DiagramDrawing *drawing, double width, double height);
GArray *diagram_drawn_boxes(const DiagramDrawing *drawing, const TinkerView *view);
double diagram_body_room(const DiagramDrawing *drawing);
void diagram_draw_bodies(DiagramDrawing *drawing, const TinkerView *view);

/* diagram-arrows.c: adds the arrows of a part; notes where those of forces were drawn, in a part at this place. */
void diagram_add_forces(DiagramPart *part);
void diagram_add_resultant(DiagramPart *part);
/* Where an arrow begins, along x (0) or y. */
double diagram_arrow_start(const TinkerForceArrow *arrow, int axis);
void diagram_add_spots(const DiagramPart *part, const GArray *places, const double at[2]);

/* diagram-turns.c: where turning arrows and their labels have room beside the arrows of the part; and draws them. */
DiagramTurns diagram_turns(const DiagramPart *part, gboolean kinetic);
void diagram_draw_turns(const DiagramPart *part, const DiagramTurns *turns, gboolean kinetic);

/* In the theme's colour of text. */
void diagram_write(DiagramDrawing *drawing, TinkerText text, double x, double y);
/* Canvas units: of what is written in DIAGRAM_TEXT. */
double diagram_text_width(DiagramDrawing *drawing, const char *text, gboolean bold);
void diagram_set_colour(cairo_t *cairo, const double colour[4]);

/* The forces in numbers, what they make, and notes: how high they are, and drawn into a box, least and greatest x and
 * y, as far as there is room. */
double diagram_list_height(DiagramDrawing *drawing, double width);
void diagram_draw_list(DiagramDrawing *drawing, const double place[4]);

#endif
