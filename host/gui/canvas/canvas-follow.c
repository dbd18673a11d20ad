/* Bodies that leave the view: a mark at the edge says where they are, with their names, and one that is followed takes
 * the view along, so that it stays where it is on the canvas. */
#include <math.h>

#include "gui/canvas/canvas-private.h"

#define MARK 7.0 /* widget units: half the width of a mark */
#define EDGE 4.0 /* between it and the edge */
#define TEXT 12.0
#define MOST 12 /* marks: of more, none could be told from another */

static gboolean can_move(const TinkerScene *scene, TinkerBlockId block)
{
    return tinker_block_class_moves(tinker_scene_block_class(scene, block));
}

/* Where a body is on the canvas; FALSE where it is nowhere. */
static gboolean place_of(TinkerCanvas *canvas, TinkerFrame *frame, TinkerBlockId block, double world[2],
                         double place[2])
{
    double orientation;
    tinker_frame_centre(frame, block, &world[0], &world[1], &orientation);
    tinker_view_to_canvas(&canvas->view, world[0], world[1], &place[0], &place[1]);
    return isfinite(place[0]) && isfinite(place[1]);
}

static gboolean is_in_view(const TinkerCanvas *canvas, const double place[2])
{
    return place[0] >= 0 && place[1] >= 0 && place[0] <= canvas->view.width && place[1] <= canvas->view.height;
}

/* Marks
 * ----------------------------------------------------------------------------------------------------------------- */

double canvas_seen_from(const TinkerCanvas *canvas)
{
    return canvas->cover != NULL ? fmin(gtk_widget_get_height(canvas->cover), canvas->view.height / 2) : 0;
}

/* Where at the edge the mark of a body out of the view is. Fields stand in the upper left corner, `corner` wide and
 * high: a mark goes below them, or beside them where the body is above the view or below them is no room. */
static void mark_at(const TinkerCanvas *canvas, const double place[2], const double corner[2], double at[2])
{
    const double off = MARK + EDGE, top = canvas_seen_from(canvas);
    const double most[2] = {fmax(canvas->view.width - off, off), fmax(canvas->view.height - off, top + off)};
    at[0] = CLAMP(place[0], off, most[0]);
    at[1] = CLAMP(place[1], top + off, most[1]);
    if (at[0] - off >= corner[0] || at[1] - off >= corner[1]) return;
    int k = place[0] < 0 ? 1 : 0;
    if (corner[k] + off > most[k]) k = 1 - k;
    at[k] = fmin(corner[k] + off, most[k]);
}

/* A triangle at the edge that points to where the body is, and its name beside it, inside the view. */
static void paint_mark(TinkerCanvas *canvas, cairo_t *cairo, const TinkerTheme *theme, const double place[2],
                       const double corner[2], const char *name)
{
    const double *colour = theme->colours[TINKER_COLOUR_BODY_EDGE], *ink = theme->colours[TINKER_COLOUR_TEXT];
    const double top = canvas_seen_from(canvas);
    double at[2];
    mark_at(canvas, place, corner, at);
    const double x = at[0], y = at[1];
    cairo_text_extents_t extents;
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_rotate(cairo, atan2(place[1] - y, place[0] - x));
    cairo_move_to(cairo, MARK, 0);
    cairo_line_to(cairo, -MARK, MARK);
    cairo_line_to(cairo, -MARK, -MARK);
    cairo_close_path(cairo);
    cairo_restore(cairo);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_fill(cairo);
    cairo_set_font_size(cairo, TEXT);
    cairo_text_extents(cairo, name, &extents);
    const double right = canvas->view.width - extents.width - EDGE, beside = x + MARK + EDGE;
    cairo_move_to(cairo, beside <= right ? beside : x - MARK - EDGE - extents.width,
                  CLAMP(y + TEXT / 3, top + TEXT + EDGE, fmax(canvas->view.height - EDGE, top + TEXT + EDGE)));
    cairo_set_source_rgba(cairo, ink[0], ink[1], ink[2], ink[3]);
    cairo_show_text(cairo, name);
}

void canvas_paint_edge_marks(TinkerCanvas *canvas, cairo_t *cairo, TinkerFrame *frame, const TinkerTheme *theme)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    int count = 0;
    double corner[2];
    cairo_save(cairo);
    for (int32_t i = 0; i < tinker_scene_block_count(scene) && count < MOST; i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        double world[2], place[2];
        if (!can_move(scene, block) || !place_of(canvas, frame, block, world, place) || is_in_view(canvas, place))
            continue;
        if (count++ == 0) tinker_painter_fields_reach(frame, &canvas->view, corner);
        paint_mark(canvas, cairo, theme, place, corner, tinker_scene_block_name(scene, block));
    }
    cairo_restore(cairo);
}

/* Following
 * ------------------------------------------------------------------------------------------------------------- */

void canvas_follow(TinkerCanvas *canvas)
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    TinkerBlockId block = tinker_document_selected(canvas->document), before = canvas->followed;
    double world[2], place[2];
    canvas->followed = TINKER_NO_BLOCK;
    if (!canvas->follow || frame == NULL || block == TINKER_NO_BLOCK) return;
    if (!can_move(tinker_frame_scene(frame), block) || !place_of(canvas, frame, block, world, place)) return;
    double dx = 0, dy = 0;
    if (block == before) {
        dx = -canvas->view.scale * (world[0] - canvas->followed_at[0]);
        dy = canvas->view.scale * (world[1] - canvas->followed_at[1]);
    } else if (!is_in_view(canvas, place)) {
        dx = canvas->view.width / 2 - place[0];
        dy = canvas->view.height / 2 - place[1];
    }
    canvas->followed = block;
    canvas->followed_at[0] = world[0];
    canvas->followed_at[1] = world[1];
    if (dx == 0 && dy == 0) return;
    tinker_view_pan(&canvas->view, dx, dy);
    canvas_view_changed(canvas);
}
