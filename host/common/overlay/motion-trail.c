/* Rows of poses, one a time noted. A mark lies between two of them, or on one where whoever notes sees to it. */
#include "common/overlay/motion-trail.h"

#include <math.h>

#include "common/overlay/motion-vectors.h"

#define LEAST_MARKS 8    /* in a duration */
#define NEAR        1.5  /* canvas units: points of a path are no nearer */
#define WIDTH       1.4  /* canvas units: of a path */
#define MARK        2.8  /* canvas units: radius */
#define EDGE        1.2  /* canvas units: the ground about a mark, so that it stands out from what it lies on */
#define GHOST       0.28 /* how much of a body that was is seen */
#define SLIP        1e-9 /* of the time between marks */

struct _TinkerMotionTrail {
    double every;   /* s */
    GArray *bodies; /* of TinkerBlockId, then TINKER_NO_BLOCK */
    GArray *times;  /* of double, s */
    GArray *poses;  /* of double: three a body and time */
};

double tinker_motion_trail_spacing(double duration)
{
    static const double mantissas[] = {5, 2, 1};
    const double most = duration / LEAST_MARKS;
    if (!(most > 0) || !isfinite(most)) return 1;
    const double decade = pow(10, floor(log10(most) + SLIP));
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(mantissas) && mantissas[i] * decade > most * (1 + SLIP))
        i++;
    return mantissas[i] * decade;
}

TinkerMotionTrail *tinker_motion_trail_new(TinkerScene *scene, double every)
{
    TinkerMotionTrail *trail = g_new0(TinkerMotionTrail, 1);
    trail->every = every;
    trail->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    trail->times = g_array_new(FALSE, FALSE, sizeof(double));
    trail->poses = g_array_new(FALSE, FALSE, sizeof(double));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (tinker_block_moves(scene, block)) g_array_append_val(trail->bodies, block);
    }
    const TinkerBlockId end = TINKER_NO_BLOCK;
    g_array_append_val(trail->bodies, end);
    return trail;
}

void tinker_motion_trail_free(TinkerMotionTrail *trail)
{
    if (trail == NULL) return;
    g_array_unref(trail->bodies);
    g_array_unref(trail->times);
    g_array_unref(trail->poses);
    g_free(trail);
}

const TinkerBlockId *tinker_motion_trail_bodies(const TinkerMotionTrail *trail, int *count)
{
    *count = (int)trail->bodies->len - 1;
    return (const TinkerBlockId *)(gpointer)trail->bodies->data;
}

double tinker_motion_trail_every(const TinkerMotionTrail *trail)
{
    return trail->every;
}

double tinker_motion_trail_reached(const TinkerMotionTrail *trail)
{
    return trail->times->len > 0 ? g_array_index(trail->times, double, trail->times->len - 1) : -1;
}

void tinker_motion_trail_note(TinkerMotionTrail *trail, double time, const double *poses)
{
    if (!(time > tinker_motion_trail_reached(trail))) return;
    g_array_append_val(trail->times, time);
    g_array_append_vals(trail->poses, poses, 3 * (trail->bodies->len - 1));
}

void tinker_motion_trail_note_frame(TinkerMotionTrail *trail, const TinkerFrame *frame)
{
    int count;
    const TinkerBlockId *bodies = tinker_motion_trail_bodies(trail, &count);
    g_autofree double *poses = g_new0(double, 3 * (gsize)count + 3);
    for (int i = 0; i < count; i++)
        tinker_frame_centre(frame, bodies[i], &poses[3 * i], &poses[3 * i + 1], &poses[3 * i + 2]);
    tinker_motion_trail_note(trail, tinker_frame_time(frame), poses);
}

void tinker_motion_trail_clear(TinkerMotionTrail *trail)
{
    g_array_set_size(trail->times, 0);
    g_array_set_size(trail->poses, 0);
}

static double time_of(const TinkerMotionTrail *trail, guint row)
{
    return g_array_index(trail->times, double, row);
}

static const double *pose_of(const TinkerMotionTrail *trail, guint row, int body)
{
    return &g_array_index(trail->poses, double, 3 * ((gsize)row * (trail->bodies->len - 1) + (gsize)body));
}

/* The last row that is not later; 0 where there is none. */
static guint row_at(const TinkerMotionTrail *trail, double time)
{
    guint low = 0, high = trail->times->len;
    while (high - low > 1) {
        const guint middle = low + (high - low) / 2;
        if (time_of(trail, middle) <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Where a body is at a time, straight between two rows. */
static void pose_at(const TinkerMotionTrail *trail, int body, double time, double pose[3])
{
    const guint row = row_at(trail, time);
    const double *from = pose_of(trail, row, body);
    const gboolean is_last = row + 1 >= trail->times->len;
    const double *to = is_last ? from : pose_of(trail, row + 1, body);
    const double began = time_of(trail, row), span = is_last ? 1 : time_of(trail, row + 1) - began;
    const double share = is_last ? 0 : CLAMP((time - began) / span, 0, 1);
    for (int k = 0; k < 3; k++)
        pose[k] = from[k] + share * (to[k] - from[k]);
}

/* How many marks there are up to a time, the start among them. */
static gsize marks_until(const TinkerMotionTrail *trail, double until)
{
    const double last = fmin(until, tinker_motion_trail_reached(trail));
    return last < 0 ? 0 : (gsize)floor(last / trail->every + SLIP) + 1;
}

/* A body's place at a mark, straight between the times noted: x, y, orientation. */
static void pose_at_mark(const TinkerMotionTrail *trail, gsize mark, int body, double pose[3])
{
    pose_at(trail, body, (double)mark * trail->every, pose);
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static void draw_path(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view, int body, double until)
{
    double pose[3], x, y, drawn[2] = {NAN, NAN};
    const guint last = row_at(trail, until);
    cairo_new_path(cairo);
    for (guint row = 0; row <= last && row < trail->times->len; row++) {
        const double *at = pose_of(trail, row, body);
        tinker_view_to_canvas(view, at[0], at[1], &x, &y);
        if (hypot(x - drawn[0], y - drawn[1]) < NEAR) continue;
        cairo_line_to(cairo, x, y);
        drawn[0] = x;
        drawn[1] = y;
    }
    pose_at(trail, body, until, pose);
    tinker_view_to_canvas(view, pose[0], pose[1], &x, &y);
    cairo_line_to(cairo, x, y);
    cairo_stroke(cairo);
}

static void draw_marks(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme,
                       int body, double until)
{
    const double *colour = theme->colours[TINKER_COLOUR_MOTION], *ground = theme->background;
    const gsize marks = marks_until(trail, until);
    for (gsize mark = 0; mark < marks; mark++) {
        double pose[3], x, y;
        pose_at_mark(trail, mark, body, pose);
        tinker_view_to_canvas(view, pose[0], pose[1], &x, &y);
        if (!isfinite(x) || !isfinite(y)) continue;
        cairo_new_path(cairo);
        cairo_arc(cairo, x, y, MARK + EDGE, 0, 2 * G_PI);
        cairo_set_source_rgb(cairo, ground[0], ground[1], ground[2]);
        cairo_fill(cairo);
        cairo_arc(cairo, x, y, MARK, 0, 2 * G_PI);
        cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
        cairo_fill(cairo);
    }
}

void tinker_motion_trail_draw(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme, double until, TinkerTrailFilter only, void *data)
{
    int count;
    const TinkerBlockId *bodies = tinker_motion_trail_bodies(trail, &count);
    const double *colour = theme->colours[TINKER_COLOUR_MOTION];
    if (trail->times->len == 0) return;
    cairo_save(cairo);
    cairo_set_line_width(cairo, WIDTH);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    for (int i = 0; i < count; i++) {
        if (only != NULL && !only(bodies[i], data)) continue;
        cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
        draw_path(trail, cairo, view, i, until);
        draw_marks(trail, cairo, view, theme, i, until);
    }
    cairo_restore(cairo);
}

static void place_at_mark(const TinkerMotionTrail *trail, gsize mark, TinkerFrame *frame)
{
    int count;
    const TinkerBlockId *bodies = tinker_motion_trail_bodies(trail, &count);
    for (int i = 0; i < count; i++) {
        double pose[3];
        pose_at_mark(trail, mark, i, pose);
        tinker_frame_place(frame, bodies[i], pose[0], pose[1], pose[2]);
    }
}

void tinker_motion_trail_draw_ghosts(const TinkerMotionTrail *trail, cairo_t *cairo, const TinkerView *view,
                                     const TinkerTheme *theme, TinkerFrame *frame)
{
    const gsize marks = marks_until(trail, INFINITY);
    int count;
    TinkerTheme clear = *theme;
    TinkerPaintOptions options = tinker_paint_options_default();
    clear.background[3] = 0;
    options.theme = &clear;
    options.show_grid = options.show_labels = FALSE;
    options.only = tinker_motion_trail_bodies(trail, &count);
    for (gsize mark = 0; mark < marks && count > 0; mark++) {
        place_at_mark(trail, mark, frame);
        cairo_push_group(cairo);
        tinker_paint_scene(cairo, frame, view, &options);
        cairo_pop_group_to_source(cairo);
        cairo_paint_with_alpha(cairo, GHOST);
    }
}

void tinker_motion_trail_widen(const TinkerMotionTrail *trail, TinkerFrame *frame, double box[4])
{
    const gsize marks = marks_until(trail, INFINITY);
    for (gsize mark = 0; mark < marks; mark++) {
        double other[4];
        place_at_mark(trail, mark, frame);
        tinker_painter_bounds(frame, other);
        tinker_painter_unite(box, other);
    }
    for (guint i = 0; i + 2 < trail->poses->len; i += 3) {
        const double *at = &g_array_index(trail->poses, double, i);
        if (isfinite(at[0]) && isfinite(at[1])) tinker_painter_unite(box, (double[]){at[0], at[1], at[0], at[1]});
    }
}
