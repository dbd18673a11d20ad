/* What a diagram says, and which of its arrows are to scale. */
#include <glib/gi18n.h>
#include <math.h>

#include "common/diagram/diagram-picture-private.h"
#include "common/diagram/diagram-scale.h"

#define NO_RESULT 1e-9 /* a resultant below this share of the forces is 0 */

double diagram_strength(const double force[2])
{
    const double size = hypot(force[0], force[1]);
    return isfinite(size) ? size : 0;
}

double diagram_greatest_force(const TinkerDiagram *diagram)
{
    double most = 0;
    for (guint i = 0; i < diagram->forces->len; i++)
        most = fmax(most, diagram_strength(g_array_index(diagram->forces, TinkerDiagramForce, i).force));
    return most;
}

/* m a that is not just what rounding leaves. */
gboolean diagram_has_resultant(const TinkerDiagram *diagram)
{
    return diagram->moves && diagram_strength(diagram->kinetic) > NO_RESULT * diagram_greatest_force(diagram);
}

/* N m: this share of all moments together. */
static double share_of_moments(const TinkerDiagram *diagram, double share)
{
    double sum = 0;
    for (guint i = 0; i < diagram->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(diagram->forces, TinkerDiagramForce, i);
        const double arm = hypot(force->point[0] - diagram->centre[0], force->point[1] - diagram->centre[1]);
        sum += diagram_strength(force->force) * arm + fabs(force->torque);
    }
    return share * sum;
}

gboolean diagram_has_turning(const TinkerDiagram *diagram)
{
    return diagram->moves && fabs(diagram->turning) > share_of_moments(diagram, NO_RESULT);
}

void diagram_begin(DiagramDrawing *drawing, const TinkerDiagramPicture *picture, cairo_t *cairo)
{
    *drawing = (DiagramDrawing){.picture = picture, .scene = tinker_frame_scene(picture->frame), .cairo = cairo};
    drawing->pen = (TinkerTextPen)TINKER_TEXT_PEN_INIT;
    drawing->forces = g_array_new(FALSE, FALSE, sizeof(TinkerDiagramForce));
    drawing->torques = g_array_new(FALSE, FALSE, sizeof(TinkerDiagramForce));
    const TinkerDiagram *diagram = picture->diagram;
    const double least = TINKER_FORCE_NOTHING * diagram_greatest_force(diagram),
                 still = share_of_moments(diagram, TINKER_FORCE_NOTHING);
    g_autoptr(GArray) sizes = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < diagram->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(diagram->forces, TinkerDiagramForce, i);
        const double size = diagram_strength(force->force);
        if (fabs(force->torque) > still) g_array_append_val(drawing->torques, *force);
        if (size <= least) continue;
        g_array_append_val(drawing->forces, *force);
        g_array_append_val(sizes, size);
    }
    const double resultant = diagram_strength(diagram->kinetic);
    if (diagram_has_resultant(diagram)) g_array_append_val(sizes, resultant);
    drawing->size = tinker_diagram_greatest_to_scale((const double *)(gpointer)sizes->data, sizes->len);
}

void diagram_end(DiagramDrawing *drawing)
{
    g_array_unref(drawing->forces);
    g_array_unref(drawing->torques);
    tinker_text_pen_clear(&drawing->pen);
}

void diagram_set_colour(cairo_t *cairo, const double colour[4])
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
}

double diagram_text_width(DiagramDrawing *drawing, const char *text, gboolean bold)
{
    return tinker_text_width(&drawing->pen, &(TinkerText){.text = text, .size = DIAGRAM_TEXT, .bold = bold});
}

void diagram_write(DiagramDrawing *drawing, TinkerText text, double x, double y)
{
    diagram_set_colour(drawing->cairo, drawing->picture->theme->colours[TINKER_COLOUR_TEXT]);
    tinker_text_draw(&drawing->pen, drawing->cairo, &text, x, y);
}

/* Words ------------------------------------------------------------------------------------------------------------ */

char *diagram_quantity(const DiagramDrawing *drawing, double value, TinkerDimension dimension)
{
    return tinker_quantity_brief(value, dimension, tinker_scene_head(drawing->scene)->units);
}

static char *load_text(const DiagramDrawing *drawing, double si, gboolean is_torque)
{
    return tinker_load_brief(si, is_torque, tinker_scene_head(drawing->scene)->units);
}

char *diagram_force_text(const DiagramDrawing *drawing, double newtons)
{
    return load_text(drawing, newtons, FALSE);
}

char *diagram_torque_text(const DiagramDrawing *drawing, double newton_metres)
{
    return load_text(drawing, newton_metres, TRUE);
}

TinkerPointed tinker_diagram_pointed(TinkerBlockId from, TinkerBlockId on, TinkerTermKind kind)
{
    const TinkerPointedPart part = kind == TINKER_TERM_NORMAL     ? TINKER_POINTED_NORMAL
                                   : kind == TINKER_TERM_FRICTION ? TINKER_POINTED_FRICTION
                                                                  : TINKER_POINTED_WHOLE;
    return (TinkerPointed){from, on, part};
}

TinkerPointed diagram_pointed(const TinkerDiagramForce *force)
{
    return tinker_diagram_pointed(force->from, force->on, force->kind);
}

TinkerArrowKind diagram_arrow_kind(TinkerTermKind kind)
{
    static const TinkerArrowKind kinds[] = {
        [TINKER_TERM_CONNECTOR] = TINKER_ARROW_CONNECTOR, [TINKER_TERM_CONSTRAINT] = TINKER_ARROW_CONSTRAINT,
        [TINKER_TERM_FORCE] = TINKER_ARROW_APPLIED,       [TINKER_TERM_FIELD] = TINKER_ARROW_FIELD,
        [TINKER_TERM_NORMAL] = TINKER_ARROW_NORMAL,       [TINKER_TERM_FRICTION] = TINKER_ARROW_FRICTION,
    };
    return kinds[kind];
}

static gboolean is_of_contact(const TinkerDiagramForce *force)
{
    return force->kind == TINKER_TERM_NORMAL || force->kind == TINKER_TERM_FRICTION;
}

/* "Floor (Normal force)": of what touches there are two forces. */
char *diagram_force_name(const DiagramDrawing *drawing, const TinkerDiagramForce *force)
{
    const char *from = tinker_scene_block_name(drawing->scene, force->from);
    return is_of_contact(force)
               ? g_strdup_printf("%s (%s)", from, tinker_force_arrow_word(diagram_arrow_kind(force->kind)))
           : force->end > 0 ? g_strdup_printf(_("%s, end %d"), from, force->end)
                            : g_strdup(from);
}

gboolean diagram_is_broken(const DiagramDrawing *drawing, double size)
{
    return size > drawing->size * (1 + NO_RESULT);
}

gboolean diagram_is_stub(const DiagramDrawing *drawing, double size)
{
    return size * TINKER_DIAGRAM_RATIO < drawing->size * (1 - NO_RESULT);
}

GPtrArray *diagram_notes(const DiagramDrawing *drawing)
{
    const TinkerDiagram *diagram = drawing->picture->diagram;
    GPtrArray *notes = g_ptr_array_new_with_free_func(g_free);
    gboolean broken = diagram_has_resultant(diagram) && diagram_is_broken(drawing, diagram_strength(diagram->kinetic));
    gboolean stub = diagram_has_resultant(diagram) && diagram_is_stub(drawing, diagram_strength(diagram->kinetic));
    for (guint i = 0; i < drawing->forces->len; i++) {
        const double size = diagram_strength(g_array_index(drawing->forces, TinkerDiagramForce, i).force);
        broken = broken || diagram_is_broken(drawing, size);
        stub = stub || diagram_is_stub(drawing, size);
    }
    if (broken) g_ptr_array_add(notes, g_strdup(_("A broken arrow is longer than it is drawn.")));
    if (stub) g_ptr_array_add(notes, g_strdup(_("An arrow with a ring is shorter than it is drawn.")));
    if (diagram->forces->len > 0 && drawing->forces->len + drawing->torques->len == 0)
        g_ptr_array_add(notes, g_strdup(_("No force acts just now.")));
    for (guint i = 0; i < diagram->cancelled->len; i++)
        g_ptr_array_add(notes,
                        g_strdup_printf(_("%s acts between them: its forces cancel."),
                                        tinker_scene_block_name(drawing->scene,
                                                                g_array_index(diagram->cancelled, TinkerBlockId, i))));
    return notes;
}
