/* A row of the record is a picture: its time, and place and orientation of every body that can move. */
#include "motion-film.h"

#include <math.h>

#include "film-graphs.h"
#include "film.h"
#include "force-arrows.h"
#include "physics/record/record.h"
#include "physics/run/simulation.h"

#define MARGIN 0.08 /* about the motion, of the picture's shorter side: for the names */

struct _TinkerMotionFilm {
    TinkerFrame *frame;
    GArray *bodies; /* of TinkerBlockId */
    TinkerRecord *record;
    GArray *row; /* of double: scratch */
    double box[4];
    TinkerActingForces *acting; /* NULL: forces are not shown */
    TinkerFilmGraphs *graphs;   /* NULL: none are shown */
    GPtrArray *forces;          /* of GArray of TinkerActingForce, a picture each */
};

static gboolean can_move(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL && block_class->physics->body != NULL &&
           block_class->physics->body->degrees_of_freedom > 0;
}

void tinker_motion_film_free(TinkerMotionFilm *motion)
{
    if (motion == NULL) return;
    tinker_frame_free(motion->frame);
    g_array_unref(motion->bodies);
    tinker_record_free(motion->record);
    g_array_unref(motion->row);
    g_clear_pointer(&motion->acting, tinker_acting_forces_free);
    g_ptr_array_unref(motion->forces);
    tinker_film_graphs_free(motion->graphs);
    g_free(motion);
}

TinkerMotionFilm *tinker_motion_film_new(TinkerScene *scene, GError **error)
{
    TinkerFrame *frame = tinker_frame_new(scene, error);
    if (frame == NULL) return NULL;
    TinkerMotionFilm *motion = g_new0(TinkerMotionFilm, 1);
    motion->frame = frame;
    motion->forces = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    motion->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (can_move(tinker_scene_block_class(scene, block))) g_array_append_val(motion->bodies, block);
    }
    guint width = 1 + 3 * motion->bodies->len;
    motion->record = tinker_record_new(width, 0);
    motion->row = g_array_set_size(g_array_new(FALSE, TRUE, sizeof(double)), width);
    tinker_painter_bounds(motion->frame, motion->box);
    return motion;
}

void tinker_motion_film_show_forces(TinkerMotionFilm *motion, TinkerModel *model)
{
    motion->acting = tinker_acting_forces_new(model);
}

void tinker_motion_film_show_graphs(TinkerMotionFilm *motion)
{
    motion->graphs = tinker_film_graphs_new(tinker_frame_scene(motion->frame));
}

const GArray *tinker_motion_film_columns(const TinkerMotionFilm *motion)
{
    return motion->graphs != NULL ? tinker_film_graphs_columns(motion->graphs) : NULL;
}

static gboolean keep_forces(TinkerMotionFilm *motion, TinkerSimulation *simulation, GError **error)
{
    if (motion->acting == NULL) return TRUE;
    GArray *forces = tinker_acting_forces_array();
    g_ptr_array_add(motion->forces, forces);
    if (!tinker_acting_forces_at(motion->acting, simulation, forces, error)) return FALSE;
    tinker_force_arrows_keep_moving(tinker_frame_scene(motion->frame), forces);
    return TRUE;
}

gboolean tinker_motion_film_sample(TinkerSimulation *simulation, double time, const double *values, void *data,
                                   GError **error)
{
    TinkerMotionFilm *motion = data;
    if (!tinker_simulation_place(simulation, motion->frame, error) || !keep_forces(motion, simulation, error))
        return FALSE;
    if (motion->graphs != NULL) tinker_film_graphs_add(motion->graphs, time, values);
    double *row = (double *)(gpointer)motion->row->data;
    *row++ = time;
    for (guint i = 0; i < motion->bodies->len; i++, row += 3)
        tinker_frame_centre(motion->frame, g_array_index(motion->bodies, TinkerBlockId, i), &row[0], &row[1], &row[2]);
    return tinker_record_append(motion->record, (const double *)(gpointer)motion->row->data, error);
}

void tinker_motion_film_begin_again(void *data)
{
    TinkerMotionFilm *motion = data;
    tinker_record_cut(motion->record, 0);
    g_ptr_array_set_size(motion->forces, 0);
    if (motion->graphs != NULL) tinker_film_graphs_cut(motion->graphs, 0);
}

gsize tinker_motion_film_cut(TinkerMotionFilm *motion, double valid_until)
{
    double *row = (double *)(gpointer)motion->row->data;
    gsize count = tinker_record_rows(motion->record);
    while (count > 0 && tinker_record_read(motion->record, count - 1, 1, row, NULL) && row[0] > valid_until)
        tinker_record_cut(motion->record, --count);
    if (motion->graphs != NULL) tinker_film_graphs_cut(motion->graphs, count);
    return count;
}

static gboolean place_picture(TinkerMotionFilm *motion, gsize picture, GError **error)
{
    double *row = (double *)(gpointer)motion->row->data;
    if (!tinker_record_read(motion->record, picture, 1, row, error)) return FALSE;
    if (!tinker_frame_set_time(motion->frame, row[0], error)) return FALSE;
    for (guint i = 0; i < motion->bodies->len; i++)
        tinker_frame_place(motion->frame, g_array_index(motion->bodies, TinkerBlockId, i), row[3 * i + 1],
                           row[3 * i + 2], row[3 * i + 3]);
    tinker_frame_note_paths(motion->frame);
    return TRUE;
}

static double column_of(const TinkerMotionFilm *motion, TinkerBlockId block, int32_t meaning)
{
    int32_t column =
        tinker_block_class_meaning_column(tinker_scene_block_class(tinker_frame_scene(motion->frame), block), meaning);
    return column < 0 ? 0 : tinker_frame_column(motion->frame, block, column);
}

/* Widens the box by every block as it lies now, turned any way. */
static void widen_box(TinkerMotionFilm *motion)
{
    TinkerScene *scene = tinker_frame_scene(motion->frame);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        double x, y, orientation;
        tinker_frame_centre(motion->frame, block, &x, &y, &orientation);
        if (isnan(x)) continue;
        double reach =
            hypot(column_of(motion, block, TINKER_MEANING_WIDTH), column_of(motion, block, TINKER_MEANING_HEIGHT)) / 2;
        motion->box[0] = fmin(motion->box[0], x - reach);
        motion->box[1] = fmin(motion->box[1], y - reach);
        motion->box[2] = fmax(motion->box[2], x + reach);
        motion->box[3] = fmax(motion->box[3], y + reach);
    }
}

static gboolean is_cancelled(const TinkerFilmDrawing *drawing)
{
    return drawing->cancelled != NULL && drawing->cancelled(drawing->data);
}

/* Finds the box that holds all pictures. One that is given up meanwhile is told of by the film. */
static gboolean bound_motion(TinkerMotionFilm *motion, const TinkerFilmDrawing *drawing, GError **error)
{
    gsize count = tinker_record_rows(motion->record);
    for (gsize picture = 0; picture < count && !is_cancelled(drawing); picture++) {
        if (!place_picture(motion, picture, error)) return FALSE;
        widen_box(motion);
    }
    return TRUE;
}

static void draw_picture(TinkerMotionFilm *motion, cairo_t *cairo, const TinkerView *view,
                         const TinkerPaintOptions *paint, double height)
{
    tinker_paint_scene(cairo, motion->frame, view, paint);
    if (motion->graphs == NULL) return;
    cairo_save(cairo);
    cairo_translate(cairo, 0, view->height);
    tinker_film_graphs_draw(motion->graphs, cairo, paint->theme, view->width, height - view->height,
                            tinker_frame_time(motion->frame));
    cairo_restore(cairo);
}

static gboolean draw_pictures(TinkerMotionFilm *motion, TinkerFilm *film, const TinkerFilmDrawing *drawing,
                              cairo_surface_t *surface, gsize *drawn, GError **error)
{
    int width = drawing->width, height = drawing->height;
    const double below = motion->graphs != NULL ? floor(tinker_film_graphs_height(height)) : 0;
    const TinkerView view = tinker_view_fit(motion->box, width, height - below, MARGIN * MIN(width, height - below));
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    TinkerPaintOptions paint = drawing->paint;
    paint.memory = memory;
    TinkerForceArrows forces = {.scene = tinker_frame_scene(motion->frame), .lit = TINKER_NO_BLOCK};
    cairo_t *cairo = cairo_create(surface);
    gsize count = tinker_record_rows(motion->record), picture = 0;
    gboolean fine = TRUE;
    for (; fine && picture < count; picture++) {
        if (picture > 0 && drawing->enough != NULL && drawing->enough(drawing->data)) break;
        fine = place_picture(motion, picture, error);
        if (!fine) break;
        if (motion->acting != NULL) {
            forces.acting = g_ptr_array_index(motion->forces, picture);
            paint.over = tinker_force_arrows_over;
            paint.over_data = &forces;
        }
        draw_picture(motion, cairo, &view, &paint, height);
        fine = tinker_film_add(film, surface, error);
        if (fine && drawing->progress != NULL) drawing->progress((double)picture + 1, (double)count, drawing->data);
    }
    cairo_destroy(cairo);
    *drawn = picture;
    return fine;
}

gboolean tinker_motion_film_write(TinkerMotionFilm *motion, const TinkerFilmDrawing *drawing, gsize *drawn,
                                  GError **error)
{
    *drawn = 0;
    if (!bound_motion(motion, drawing, error)) return FALSE;
    g_autoptr(TinkerFilm) film =
        tinker_film_new(drawing->path, drawing->width, drawing->height, drawing->frames_per_second, error);
    if (film == NULL) return FALSE;
    tinker_film_set_cancelled(film, drawing->cancelled, drawing->data);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, drawing->width, drawing->height);
    gboolean fine = draw_pictures(motion, film, drawing, surface, drawn, error);
    cairo_surface_destroy(surface);
    return fine && tinker_film_finish(film, error);
}
