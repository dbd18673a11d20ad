/* The forces as arrows, in one scale. */
#include <math.h>

#include "common/diagram/diagram-picture-private.h"
#include "common/diagram/diagram-scale.h"

/* Canvas units. */
#define BEHIND      8.0 /* from the head of a normal force to where its friction begins */
#define LEAST_ARROW 4.0 /* shorter ones could not be seen */

double diagram_arrow_start(const TinkerForceArrow *arrow, int axis)
{
    const double point = axis == 0 ? arrow->x : arrow->y, force = axis == 0 ? arrow->fx : arrow->fy;
    return arrow->look & TINKER_ARROW_PUSHES ? point - force : point;
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
    if (to_point) arrow.look |= TINKER_ARROW_PUSHES;
    if (kind == TINKER_ARROW_FRICTION) { /* beside the head of the normal force */
        arrow.x += BEHIND * unit * force[0] / size;
        arrow.y += BEHIND * unit * force[1] / size;
    }
    if (diagram_is_broken(drawing, size)) arrow.look |= TINKER_ARROW_BROKEN;
    if (diagram_is_stub(drawing, size)) arrow.look |= TINKER_ARROW_STUB;
    if (faded) arrow.look |= TINKER_ARROW_FADED;
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
        add_arrow(part, force->point, force->force,
                  tinker_force_arrow_pushes(drawing->picture->frame, force->on, force->point, force->force),
                  diagram_arrow_kind(force->kind), some_lit && !is_lit(drawing, i), label_of(part, name, force->force));
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
