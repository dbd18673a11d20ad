/* The forces as arrows: one scale for all, and those that would lie on each other moved apart. */
#include <math.h>

#include "common/diagram/diagram-picture-private.h"
#include "common/diagram/diagram-scale.h"

/* Canvas units. */
#define BESIDE      10.0 /* between arrows that would lie on each other */
#define LEAST_ARROW 4.0  /* shorter ones could not be seen */

/* Whether two arrows lie on one line and over each other. */
static gboolean lie_together(const TinkerForceArrow *a, const TinkerForceArrow *b, double beside)
{
    const double length = hypot(a->fx, a->fy), other = hypot(b->fx, b->fy);
    const double ux = a->fx / length, uy = a->fy / length;
    if (fabs(ux * b->fy - uy * b->fx) > 0.12 * other) return FALSE;
    if (fabs(ux * (b->y - a->y) - uy * (b->x - a->x)) > 0.9 * beside) return FALSE;
    const double from = ux * (b->x - a->x) + uy * (b->y - a->y), to = from + ux * b->fx + uy * b->fy;
    return fmax(from, to) > 1e-6 * length && fmin(from, to) < length * (1 - 1e-6);
}

static void move_apart(const DiagramPart *part, TinkerForceArrow *arrow)
{
    static const double steps[] = {0, 1, -1, 2, -2, 3, -3, 4, -4};
    const double length = hypot(arrow->fx, arrow->fy), beside = BESIDE / part->view->scale;
    const double x = arrow->x, y = arrow->y;
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        gboolean alone = TRUE;
        arrow->x = x + steps[i] * beside * arrow->fy / length;
        arrow->y = y - steps[i] * beside * arrow->fx / length;
        for (guint k = 0; k < part->arrows->len && alone; k++)
            alone = !lie_together(&g_array_index(part->arrows, TinkerForceArrow, k), arrow, beside);
        if (alone) return;
    }
    arrow->x = x;
    arrow->y = y;
}

/* What pushes ends where it acts: its arrow stands outside of the body. */
static gboolean pushes(const DiagramDrawing *drawing, const TinkerDiagramForce *force)
{
    double x, y, orientation;
    tinker_frame_centre(drawing->picture->frame, force->on, &x, &y, &orientation);
    const double inward = force->force[0] * (x - force->point[0]) + force->force[1] * (y - force->point[1]);
    return inward > 0.3 * diagram_strength(force->force) * hypot(x - force->point[0], y - force->point[1]);
}

/* Adds an arrow of this force, which takes the label over. */
static void add_arrow(DiagramPart *part, const double point[2], const double force[2], gboolean to_point,
                      TinkerArrowKind kind, gboolean faded, char *label)
{
    const DiagramDrawing *drawing = part->drawing;
    const double size = diagram_strength(force), unit = 1 / part->view->scale;
    const double to_scale = fmin(fmax(size / drawing->size, 1 / TINKER_DIAGRAM_RATIO), 1) * part->longest;
    const double shown = fmax(to_scale, LEAST_ARROW) * unit;
    TinkerForceArrow arrow = {.x = point[0],
                              .y = point[1],
                              .fx = force[0] / size * shown,
                              .fy = force[1] / size * shown,
                              .label = label,
                              .kind = kind};
    if (to_point) {
        arrow.look |= TINKER_ARROW_PUSHES;
        arrow.x -= arrow.fx;
        arrow.y -= arrow.fy;
    }
    if (diagram_is_broken(drawing, size)) arrow.look |= TINKER_ARROW_BROKEN;
    if (diagram_is_stub(drawing, size)) arrow.look |= TINKER_ARROW_STUB;
    if (faded) arrow.look |= TINKER_ARROW_FADED;
    move_apart(part, &arrow);
    g_ptr_array_add(part->texts, label);
    g_array_append_val(part->arrows, arrow);
}

/* What stands at an arrow: all of it, or as much as there is room for. (transfer full) */
static char *label_of(const DiagramPart *part, const char *name, const double force[2])
{
    if (part->drawing->brief) return g_strdup(name);
    g_autofree char *value = diagram_force_text(part->drawing, diagram_strength(force));
    return g_strdup_printf("%s  %s", name, value);
}

static gboolean is_lit(const DiagramDrawing *drawing, guint number)
{
    const TinkerPointed thing = diagram_pointed(&g_array_index(drawing->forces, TinkerDiagramForce, number));
    return tinker_pointed_lights(drawing->picture->lit, &thing);
}

static gboolean any_is_lit(const DiagramDrawing *drawing)
{
    for (guint i = 0; i < drawing->forces->len; i++)
        if (is_lit(drawing, i)) return TRUE;
    return FALSE;
}

void diagram_add_forces(DiagramPart *part)
{
    const DiagramDrawing *drawing = part->drawing;
    const gboolean some_lit = any_is_lit(drawing);
    for (guint i = 0; i < drawing->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(drawing->forces, TinkerDiagramForce, i);
        g_autofree char *name = drawing->numbered ? g_strdup_printf("%u", i + 1) : diagram_force_name(drawing, force);
        add_arrow(part, force->point, force->force, pushes(drawing, force), diagram_arrow_kind(force->kind),
                  some_lit && !is_lit(drawing, i), label_of(part, name, force->force));
    }
}

void diagram_add_resultant(DiagramPart *part)
{
    const TinkerDiagram *diagram = part->drawing->picture->diagram;
    add_arrow(part, diagram->centre, diagram->kinetic, FALSE, TINKER_ARROW_MOTION, FALSE,
              label_of(part, "m a", diagram->kinetic));
}

void diagram_add_spots(const DiagramPart *part, const GArray *places, const double at[2])
{
    const DiagramDrawing *drawing = part->drawing;
    GArray *spots = drawing->picture->spots;
    const guint first = spots->len;
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        const TinkerDiagramForce *force = &g_array_index(drawing->forces, TinkerDiagramForce, place->number);
        g_autofree char *name = diagram_force_name(drawing, force), *text = label_of(part, name, force->force);
        tinker_spots_add_line(spots, place->shaft, diagram_pointed(force), text);
        if (place->label[2] > place->label[0]) tinker_spots_add_box(spots, place->label, diagram_pointed(force), text);
    }
    tinker_spots_move(spots, first, at[0], at[1]);
}
