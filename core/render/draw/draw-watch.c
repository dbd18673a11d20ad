/* How many states are saved cairo does not tell. But a state holds the greatest length of a mitre: within the drawing
 * it is another number than around it, by far less than can be seen, and so tells one from the other. */
#include "render/draw/draw-watch.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define MARK 1e-9

static gboolean are_same(const cairo_rectangle_list_t *a, const cairo_rectangle_list_t *b)
{
    return a->status == CAIRO_STATUS_SUCCESS && b->status == CAIRO_STATUS_SUCCESS &&
           a->num_rectangles == b->num_rectangles &&
           memcmp(a->rectangles, b->rectangles, (gsize)a->num_rectangles * sizeof *a->rectangles) == 0;
}

/* The box that holds the clip. It is infinite where nothing clips a surface without bounds,
 * as a recording may be: then there is no clip. */
static void clip_to_box(cairo_t *from, cairo_t *to)
{
    double x1, y1, x2, y2;
    cairo_clip_extents(from, &x1, &y1, &x2, &y2);
    if (!isfinite(x2 - x1) || !isfinite(y2 - y1)) return;
    cairo_rectangle(to, x1, y1, x2 - x1, y2 - y1);
    cairo_clip(to);
}

/* Nothing where the whole surface is drawn on: files would hold a clip for nothing. */
static void copy_clip(cairo_t *from, cairo_t *to)
{
    cairo_rectangle_list_t *clip = cairo_copy_clip_rectangle_list(from), *whole = cairo_copy_clip_rectangle_list(to);
    const gboolean same = are_same(clip, whole);
    cairo_rectangle_list_destroy(whole);
    if (same) {
        cairo_rectangle_list_destroy(clip);
        return;
    }
    if (clip->status == CAIRO_STATUS_SUCCESS) {
        for (int i = 0; i < clip->num_rectangles; i++)
            cairo_rectangle(to, clip->rectangles[i].x, clip->rectangles[i].y, clip->rectangles[i].width,
                            clip->rectangles[i].height);
        cairo_clip(to);
    } else { /* no rectangles, as where the context is turned */
        clip_to_box(from, to);
    }
    cairo_rectangle_list_destroy(clip);
}

cairo_t *tinker_context_new(cairo_t *cairo)
{
    cairo_t *context = cairo_create(cairo_get_group_target(cairo));
    cairo_matrix_t matrix;
    cairo_get_matrix(cairo, &matrix);
    cairo_set_matrix(context, &matrix);
    cairo_set_antialias(context, cairo_get_antialias(cairo));
    copy_clip(cairo, context);
    return context;
}

void tinker_draw_watch_begin(TinkerDrawWatch *watch, cairo_t *cairo)
{
    watch->target = cairo_get_group_target(cairo);
    watch->mark = cairo_get_miter_limit(cairo);
    cairo_get_matrix(cairo, &watch->matrix);
    cairo_save(cairo);
    cairo_set_miter_limit(cairo, watch->mark + MARK);
    cairo_new_path(cairo);
}

char *tinker_draw_watch_end(const TinkerDrawWatch *watch, cairo_t *cairo)
{
    const cairo_status_t status = cairo_status(cairo);
    if (status != CAIRO_STATUS_SUCCESS)
        return g_strdup_printf(_("leaves cairo in the state \"%s\""), cairo_status_to_string(status));
    if (cairo_get_group_target(cairo) != watch->target) return g_strdup(_("leaves a group open"));
    cairo_matrix_t matrix;
    cairo_restore(cairo);
    cairo_get_matrix(cairo, &matrix);
    const gboolean as_before = cairo_status(cairo) == CAIRO_STATUS_SUCCESS &&
                               cairo_get_miter_limit(cairo) == watch->mark &&
                               memcmp(&matrix, &watch->matrix, sizeof matrix) == 0;
    return as_before ? NULL : g_strdup(_("calls cairo_save and cairo_restore differently often"));
}
