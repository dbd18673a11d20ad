/* What the canvas shows of a start beyond the scene itself: with which velocity bodies set off, and which blocks
 * something is wrong with. Arrows are those of forces, in the colour of motions and with the scale of velocities. */
#include <math.h>

#include "gui/canvas/canvas-private.h"
#include "render/draw/text.h"
#include "render/picture/arrows.h"

#define SHARE      0.7 /* of the length that arrows of forces have */
#define BADGE      9.0 /* widget units: half the width of a badge */
#define BADGE_GAP  4.0
#define BADGE_EDGE 2.0

/* Velocities
 * ------------------------------------------------------------------------------------------------------------ */

static gboolean is_marked(TinkerCanvas *canvas, TinkerBlockId block)
{
    for (guint i = 0; i < canvas->marked->len; i++)
        if (g_array_index(canvas->marked, TinkerBlockId, i) == block) return TRUE;
    return FALSE;
}

/* The arrow of a block that sets off with a velocity. */
static gboolean arrow_of(const TinkerFrame *frame, TinkerBlockId block, TinkerForceArrow *arrow)
{
    const TinkerDimension speed = TINKER_DIMENSION_VELOCITY;
    TinkerScene *scene = tinker_frame_scene(frame);
    double orientation;
    arrow->fx = tinker_frame_meaning(frame, block, TINKER_MEANING_VELOCITY, 0, 0);
    arrow->fy = tinker_frame_meaning(frame, block, TINKER_MEANING_VELOCITY, 1, 0);
    double size = hypot(arrow->fx, arrow->fy);
    if (!(size > 0)) return FALSE;
    tinker_frame_centre(frame, block, &arrow->x, &arrow->y, &orientation);
    arrow->kind = TINKER_ARROW_MOTION;
    arrow->label = tinker_quantity_brief(size, speed, tinker_scene_head(scene)->units);
    return TRUE;
}

static GArray *find_arrows(TinkerCanvas *canvas, const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    GArray *arrows = g_array_new(FALSE, FALSE, sizeof(TinkerForceArrow));
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        TinkerForceArrow arrow = {0};
        if (!canvas->show_labels && !is_marked(canvas, block)) continue;
        if (arrow_of(frame, block, &arrow)) g_array_append_val(arrows, arrow);
    }
    return arrows;
}

/* The boxes (double[4]) of panels, which are texts without words. (transfer full) */
static GArray *panel_boxes(const GPtrArray *texts)
{
    GArray *boxes = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    for (guint i = 0; i < texts->len; i++) {
        const TinkerWrittenText *text = g_ptr_array_index(texts, i);
        if (text->text == NULL) g_array_append_vals(boxes, text->box, 1);
    }
    return boxes;
}

static void paint_velocities(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme,
                             const GPtrArray *texts)
{
    g_autoptr(GArray) panels = panel_boxes(texts);
    g_autoptr(GArray) all = find_arrows(canvas, frame);
    const TinkerForceArrow *arrows = (const TinkerForceArrow *)(const void *)all->data;
    canvas->velocity_scale = tinker_arrows_scale(arrows, all->len, &canvas->view, canvas->velocity_scale);
    const TinkerArrowOptions options = {.theme = theme,
                                        .scale = SHARE * canvas->velocity_scale,
                                        .taken = (const double(*)[4])(gpointer)panels->data,
                                        .taken_count = (int)panels->len};
    tinker_arrows_draw(cairo, &canvas->view, arrows, all->len, &options);
    for (guint i = 0; i < all->len; i++)
        g_free((char *)arrows[i].label);
}

/* Badges
 * ---------------------------------------------------------------------------------------------------------------- */

/* Where the badge of a block goes, in widget units: into the upper right corner of a body that has room for it, where
 * neither names nor handles are; else beside the block's centre or corner. FALSE where the block is nowhere. */
static gboolean place_of(TinkerCanvas *canvas, const TinkerFrame *frame, TinkerBlockId block, double place[2])
{
    double x, y, orientation, off = (BADGE + BADGE_GAP) / canvas->view.scale;
    tinker_frame_centre(frame, block, &x, &y, &orientation);
    if (!isfinite(x) || !isfinite(y)) return FALSE;
    double right = 0.5 * tinker_frame_meaning(frame, block, TINKER_MEANING_WIDTH, 0, 0);
    double up = 0.5 * tinker_frame_meaning(frame, block, TINKER_MEANING_HEIGHT, 0, 0);
    gboolean has_room = fmin(right, up) > 1.5 * off;
    right += has_room ? -off : off;
    up += has_room ? -off : off;
    double c = cos(orientation), s = sin(orientation);
    tinker_view_to_canvas(&canvas->view, x + c * right - s * up, y + s * right + c * up, &place[0], &place[1]);
    return TRUE;
}

static void triangle(cairo_t *cairo, double x, double y)
{
    cairo_new_path(cairo);
    cairo_move_to(cairo, x, y - BADGE);
    cairo_line_to(cairo, x + BADGE, y + 0.75 * BADGE);
    cairo_line_to(cairo, x - BADGE, y + 0.75 * BADGE);
    cairo_close_path(cairo);
}

/* A triangle with an exclamation mark, and an edge of the background so that it stands out. */
static void paint_badge(cairo_t *cairo, const TinkerTheme *theme, double x, double y)
{
    const double *colour = theme->colours[TINKER_COLOUR_WARNING], *ground = theme->background;
    const double top = y - BADGE, height = 1.75 * BADGE;
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    triangle(cairo, x, y);
    cairo_set_source_rgb(cairo, ground[0], ground[1], ground[2]);
    cairo_set_line_width(cairo, 3 + 2 * BADGE_EDGE);
    cairo_stroke(cairo);
    triangle(cairo, x, y);
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_fill_preserve(cairo);
    cairo_set_line_width(cairo, 3);
    cairo_stroke(cairo);
    cairo_set_source_rgb(cairo, ground[0], ground[1], ground[2]);
    cairo_set_line_width(cairo, 2);
    cairo_move_to(cairo, x, top + 0.35 * height);
    cairo_line_to(cairo, x, top + 0.65 * height);
    cairo_move_to(cairo, x, top + 0.88 * height);
    cairo_line_to(cairo, x, top + 0.88 * height + 0.01);
    cairo_stroke(cairo);
}

static void paint_badges(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    for (guint i = 0; i < canvas->marked->len; i++) {
        TinkerBlockId block = g_array_index(canvas->marked, TinkerBlockId, i);
        double place[2];
        if (!tinker_scene_has_block(scene, block) || !place_of(canvas, frame, block, place)) continue;
        paint_badge(cairo, theme, place[0], place[1]);
    }
}

void canvas_paint_marks(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme,
                        const GPtrArray *texts)
{
    if (tinker_player_state(canvas->player) != TINKER_PLAYER_SETUP) return;
    cairo_save(cairo);
    if (!canvas->show_vectors.kinds[TINKER_VECTOR_VELOCITY]) paint_velocities(canvas, cairo, frame, theme, texts);
    paint_badges(canvas, cairo, frame, theme);
    cairo_restore(cairo);
}
