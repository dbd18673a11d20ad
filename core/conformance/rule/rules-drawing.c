/* bounds, hit: the block drawn on a picture of its own; ink is looked for outside the declared bounds, and hit is asked
 * where ink is. */
#include <math.h>

#include <cairo.h>

#include <tinker/shapes.h>

#include "conformance/probe/sample-laws.h"
#include "conformance/probe/state.h"
#include "conformance/probe/watched-style.h"
#include "render/draw/draw-watch.h"
#include "render/draw/style.h"

#define PIXELS 900
#define SCALE  40.0 /* pixels a metre */
#define SYMBOL 0.25 /* m */
#define FAINT  40   /* of 255: less is the edge of something else */
#define ROUNDS 12
#define PATH   9 /* places of a path */

typedef struct {
    KitState *state; /* one instance */
    double columns[256];
    TinkerEnd ends[16];
    double path[2 * PATH];
    TinkerInstance instance;
    TinkerView view;
    TinkerStyleBrush brush;
    cairo_surface_t *surface;
    cairo_t *cairo;
    const unsigned char *ink; /* of the surface, drawn; rows of `stride` bytes */
    int stride;
    double bounds[4];
    char *fault;      /* what the drawing did to the context; or NULL */
    char *not_finite; /* a helper that was given a number that is not finite, with the numbers; or NULL */
} Picture;

static double meaning(const Picture *picture, int32_t number, int component)
{
    const int32_t column = tinker_block_class_meaning_column(picture->state->block_class, number);
    return column < 0 ? 0 : picture->columns[column + component];
}

typedef void (*Look)(KitCheck *check, const Picture *picture);

static void look_for_hits(KitCheck *check, const Picture *picture);

static void set_instance(KitCheck *check, Picture *picture, Look look)
{
    const KitState *state = picture->state;
    const gboolean body = state->block_class->physics != NULL && state->block_class->physics->body != NULL;
    const int32_t ends = body ? 0 : kit_state_end_count(state);
    double x = 0, y = 0;
    for (int32_t k = 0; k < ends && k < (int32_t)G_N_ELEMENTS(picture->ends); k++) {
        const TinkerPoint *p = &state->points[k];
        picture->ends[k] =
            (TinkerEnd){p->x, p->y, g_rand_boolean(check->random), 0, g_rand_double_range(check->random, -4, 4)};
        x += p->x / ends;
        y += p->y / ends;
    }
    for (int32_t c = 0; c < state->block_class->column_count; c++)
        picture->columns[c] = state->columns[c][0];
    for (int axis = 0; body && axis < 2; axis++) { // a place within the picture
        const int32_t column = tinker_block_class_meaning_column(state->block_class, TINKER_MEANING_POSITION);
        if (column >= 0) picture->columns[column + axis] /= 4;
    }
    picture->instance = (TinkerInstance){.struct_size = sizeof(TinkerInstance),
                                         .ends = MIN(ends, (int32_t)G_N_ELEMENTS(picture->ends)),
                                         .name = "Block 0",
                                         .columns = picture->columns,
                                         .end = picture->ends,
                                         .x = body ? meaning(picture, TINKER_MEANING_POSITION, 0) : x,
                                         .y = body ? meaning(picture, TINKER_MEANING_POSITION, 1) : y,
                                         .orientation = meaning(picture, TINKER_MEANING_ORIENTATION, 0),
                                         .time = state->time,
                                         .symbol_size = SYMBOL};
    picture->instance.point_lists = kit_sample_points(state->block_class, &picture->instance.point_list_count);
    /* A path need not be hit: what moves would lie under its own. */
    if ((state->block_class->type->flags & TINKER_LEAVES_PATH) == 0 || look == look_for_hits) return;
    for (int32_t k = 0; k < 2 * PATH; k++)
        picture->path[k] = g_rand_double_range(check->random, -8, 8);
    picture->instance.path = picture->path;
    picture->instance.path_count = PATH;
}

/* Where it offers none, the box about the ends or the body's size. */
static void find_bounds(Picture *picture, const TinkerRender *render)
{
    const TinkerStyle *style = &picture->brush.style;
    const TinkerInstance *at = &picture->instance;
    if (render->bounds != NULL) {
        render->bounds(at, style, picture->bounds);
        return;
    }
    const double size = hypot(meaning(picture, TINKER_MEANING_WIDTH, 0), meaning(picture, TINKER_MEANING_HEIGHT, 0));
    tinker_bounds_clear(picture->bounds);
    for (int32_t k = 0; k < at->ends; k++)
        tinker_bounds_add(picture->bounds, at->end[k].x, at->end[k].y, tinker_drawing_margin(style));
    if (at->ends == 0) tinker_bounds_add(picture->bounds, at->x, at->y, size / 2 + tinker_drawing_margin(style));
}

static void draw(KitCheck *check, Picture *picture)
{
    const TinkerRender *render = check->block_class->render;
    const double half = PIXELS / 2.0;
    picture->view = (TinkerView){SCALE, half, half, PIXELS, PIXELS};
    picture->surface = cairo_image_surface_create(CAIRO_FORMAT_A8, PIXELS, PIXELS);
    picture->cairo = cairo_create(picture->surface);
    tinker_style_begin(&picture->brush, picture->cairo, tinker_theme_find("light"), &picture->view, SYMBOL);
    tinker_style_enter_world(&picture->brush.style, picture->cairo);
    kit_style_watch(&picture->brush.style);
    kit_phase(check, "draw at %s", picture->state->label);
    TinkerDrawWatch watch;
    tinker_draw_watch_begin(&watch, picture->cairo);
    render->draw(&picture->instance, picture->cairo, &picture->brush.style);
    picture->fault = tinker_draw_watch_end(&watch, picture->cairo);
    picture->not_finite = kit_style_seen();
    kit_phase(check, "bounds at %s", picture->state->label);
    find_bounds(picture, render);
    cairo_surface_flush(picture->surface);
    picture->ink = cairo_image_surface_get_data(picture->surface);
    picture->stride = cairo_image_surface_get_stride(picture->surface);
}

static gboolean has_ink(const Picture *picture, int column, int row)
{
    return picture->ink[row * picture->stride + column] >= FAINT;
}

static gboolean is_inside(const double *bounds, double x, double y, double slack)
{
    return x >= bounds[0] - slack && y >= bounds[1] - slack && x <= bounds[2] + slack && y <= bounds[3] + slack;
}

static void look_for_ink(KitCheck *check, const Picture *picture)
{
    const double *b = picture->bounds;
    if (picture->fault != NULL) {
        kit_fail(check, "its drawing %s, at %s", picture->fault, picture->state->label);
        return;
    }
    if (picture->not_finite != NULL) {
        g_autofree char *values = kit_state_describe(picture->state, 0);
        kit_fail(check, "it draws a %s, finite numbers were expected, at %s (%s)", picture->not_finite,
                 picture->state->label, values);
        return;
    }
    if (!isfinite(b[0] + b[1] + b[2] + b[3]) || b[0] > b[2] || b[1] > b[3]) {
        kit_fail(check, "its bounds %g %g to %g %g are no box, at %s", b[0], b[1], b[2], b[3], picture->state->label);
        return;
    }
    for (int row = 0; row < PIXELS; row++)
        for (int column = 0; column < PIXELS; column++) {
            double x, y;
            if (!has_ink(picture, column, row)) continue;
            tinker_view_to_world(&picture->view, column + 0.5, row + 0.5, &x, &y);
            if (is_inside(b, x, y, 1.5 / SCALE)) continue;
            g_autofree char *values = kit_state_describe(picture->state, 0);
            kit_fail(check, "it draws at (%.3g, %.3g), outside its bounds %.3g %.3g to %.3g %.3g, at %s (%s)", x, y,
                     b[0], b[1], b[2], b[3], picture->state->label, values);
            return;
        }
}

/* Ink can be hit from within a symbol or so, since symbols are wide; a point four symbols beyond the bounds cannot. */
static void look_for_hits(KitCheck *check, const Picture *picture)
{
    const TinkerEdit *edit = check->block_class->edit;
    const double *b = picture->bounds, away = 4 * SYMBOL;
    kit_phase(check, "hit at %s", picture->state->label);
    for (int row = 0; row < PIXELS; row += 3)
        for (int column = 0; column < PIXELS; column += 3) {
            double x, y;
            if (!has_ink(picture, column, row)) continue;
            tinker_view_to_world(&picture->view, column + 0.5, row + 0.5, &x, &y);
            if (!is_inside(b, x, y, 0) || edit->hit(&picture->instance, x, y, 1.5 * SYMBOL) != TINKER_PART_NONE)
                continue;
            g_autofree char *values = kit_state_describe(picture->state, 0);
            kit_fail(check, "it draws at (%.3g, %.3g), but a hit there with a reach of %g m finds nothing (%s)", x, y,
                     1.5 * SYMBOL, values);
            return;
        }
    const double around[][2] = {{b[0] - away, b[1]}, {b[2] + away, b[3]}, {b[0], b[3] + away}, {b[2], b[1] - away}};
    for (gsize i = 0; i < G_N_ELEMENTS(around); i++)
        if (edit->hit(&picture->instance, around[i][0], around[i][1], SYMBOL) != TINKER_PART_NONE)
            kit_fail(check, "a hit at (%.3g, %.3g) finds it, %g m outside its bounds", around[i][0], around[i][1],
                     away);
    if (edit->hit(&picture->instance, NAN, NAN, SYMBOL) != TINKER_PART_NONE)
        kit_fail(check, "a hit at a place that is no number finds it");
}

static void try_picture(KitCheck *check, KitState *state, Look look)
{
    Picture *picture = g_new0(Picture, 1);
    picture->state = state;
    set_instance(check, picture, look);
    draw(check, picture);
    if (!kit_decided(check)) look(check, picture);
    cairo_restore(picture->cairo);
    tinker_style_end(&picture->brush);
    cairo_destroy(picture->cairo);
    cairo_surface_destroy(picture->surface);
    g_free(picture->not_finite);
    g_free(picture->fault);
    g_free(picture);
}

static void try_pictures(KitCheck *check, Look look)
{
    g_autoptr(KitState) all = kit_state_new(check, ROUNDS);
    for (int32_t i = 0; all != NULL && i < ROUNDS && !kit_decided(check); i++) {
        g_autoptr(KitState) one = kit_state_slice(all, i, 1);
        if (i % 4 == 3) {
            for (int32_t e = 0; e < kit_state_end_count(one); e++)
                one->points[e] = one->points[0];
            g_strlcpy(one->label, "coincident ends", sizeof one->label);
        }
        try_picture(check, one, look);
    }
}

void kit_try_bounds(KitCheck *check)
{
    if (check->block_class->render == NULL)
        kit_skip(check, "it offers no drawing: the host draws it");
    else if (check->block_class->column_count > 256)
        kit_skip(check, "it has too many columns to be drawn here");
    else
        try_pictures(check, look_for_ink);
}

void kit_try_hit(KitCheck *check)
{
    if (check->block_class->render == NULL || check->block_class->edit == NULL)
        kit_skip(check, "the host draws it, or edits it");
    else
        try_pictures(check, look_for_hits);
}
