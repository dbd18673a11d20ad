/* A row of the record is a picture: its time, place and orientation of every body that can move, and how long is what
 * is wound. */
#include "common/film/motion-film.h"

#include <math.h>

#include "common/film/film-graphs.h"
#include "common/film/film.h"
#include "physics/record/record.h"
#include "physics/run/simulation.h"

#define MARGIN       0.08 /* about the motion, of the picture's shorter side: for the names */
#define MOST_BETWEEN 20   /* samples a picture, for paths */
#define SLIP         1e-9

struct _TinkerMotionFilm {
    TinkerFrame *frame;
    GArray *bodies; /* of TinkerBlockId */
    TinkerRecord *record;
    GArray *row; /* of double: scratch */
    double box[4];
    TinkerFilmOverlay overlay;
    TinkerFilmArrows *arrows; /* NULL: nothing is shown over the pictures */
    TinkerFilmGraphs *graphs; /* NULL: none are shown */
    int samples;              /* a picture has */
    gint64 taken;             /* samples */
    double end;               /* s: of the run */
};

void tinker_motion_film_free(TinkerMotionFilm *motion)
{
    if (motion == NULL) return;
    tinker_frame_free(motion->frame);
    g_array_unref(motion->bodies);
    tinker_record_free(motion->record);
    g_array_unref(motion->row);
    tinker_film_arrows_free(motion->arrows);
    tinker_film_graphs_free(motion->graphs);
    g_free(motion);
}

TinkerMotionFilm *tinker_motion_film_new(TinkerScene *scene, GError **error)
{
    TinkerFrame *frame = tinker_frame_new(scene, error);
    if (frame == NULL) return NULL;
    TinkerMotionFilm *motion = g_new0(TinkerMotionFilm, 1);
    motion->frame = frame;
    motion->samples = 1;
    motion->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        if (tinker_block_moves(scene, block)) g_array_append_val(motion->bodies, block);
    }
    int32_t wound;
    tinker_frame_wound(frame, &wound);
    guint width = 1 + 3 * motion->bodies->len + (guint)wound;
    motion->record = tinker_record_new(width, 0);
    motion->row = g_array_set_size(g_array_new(FALSE, TRUE, sizeof(double)), width);
    tinker_painter_bounds(motion->frame, motion->box);
    return motion;
}

double tinker_motion_film_show(TinkerMotionFilm *motion, const TinkerFilmOverlay *overlay, double spacing)
{
    const double interval = tinker_scene_head(tinker_frame_scene(motion->frame))->run.interval;
    motion->overlay = *overlay;
    if (overlay->marks > 0) motion->samples = (int)CLAMP(ceil(spacing / interval - SLIP), 1, MOST_BETWEEN);
    return spacing / motion->samples;
}

void tinker_motion_film_begin(TinkerMotionFilm *motion, TinkerModel *model, double end)
{
    TinkerScene *scene = tinker_frame_scene(motion->frame);
    motion->end = end;
    if (tinker_film_overlay_any(&motion->overlay))
        motion->arrows = tinker_film_arrows_new(model, scene, &motion->overlay);
}

void tinker_motion_film_show_graphs(TinkerMotionFilm *motion, TinkerTextFunc translate)
{
    motion->graphs = tinker_film_graphs_new(tinker_frame_scene(motion->frame), translate);
}

const GArray *tinker_motion_film_columns(const TinkerMotionFilm *motion)
{
    return motion->graphs != NULL ? tinker_film_graphs_columns(motion->graphs) : NULL;
}

gboolean tinker_motion_film_sample(TinkerSimulation *simulation, double time, const double *values, void *data,
                                   GError **error)
{
    TinkerMotionFilm *motion = data;
    const gboolean is_picture = motion->taken++ % motion->samples == 0 || time >= motion->end;
    if (!is_picture && motion->arrows == NULL) return TRUE;
    if (!tinker_simulation_place(simulation, motion->frame, error)) return FALSE;
    if (motion->arrows != NULL) tinker_film_arrows_note(motion->arrows, motion->frame);
    if (!is_picture) return TRUE;
    if (motion->arrows != NULL && !tinker_film_arrows_add(motion->arrows, simulation, motion->frame, error))
        return FALSE;
    if (motion->graphs != NULL) tinker_film_graphs_add(motion->graphs, time, values);
    double *row = (double *)(gpointer)motion->row->data;
    *row++ = time;
    for (guint i = 0; i < motion->bodies->len; i++, row += 3)
        tinker_frame_centre(motion->frame, g_array_index(motion->bodies, TinkerBlockId, i), &row[0], &row[1], &row[2]);
    int32_t count;
    const TinkerBlockId *wound = tinker_frame_wound(motion->frame, &count);
    for (int32_t i = 0; i < count; i++)
        *row++ = tinker_frame_length(motion->frame, wound[i]);
    return tinker_record_append(motion->record, (const double *)(gpointer)motion->row->data, error);
}

void tinker_motion_film_begin_again(void *data)
{
    TinkerMotionFilm *motion = data;
    tinker_record_cut(motion->record, 0);
    motion->taken = 0;
    if (motion->arrows != NULL) tinker_film_arrows_cut(motion->arrows, 0);
    if (motion->graphs != NULL) tinker_film_graphs_cut(motion->graphs, 0);
}

gsize tinker_motion_film_cut(TinkerMotionFilm *motion, double valid_until)
{
    double *row = (double *)(gpointer)motion->row->data;
    gsize count = tinker_record_rows(motion->record);
    while (count > 0 && tinker_record_read(motion->record, count - 1, 1, row, NULL) && row[0] > valid_until)
        tinker_record_cut(motion->record, --count);
    if (motion->graphs != NULL) tinker_film_graphs_cut(motion->graphs, count);
    if (motion->arrows != NULL) tinker_film_arrows_cut(motion->arrows, count);
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
    int32_t count;
    const TinkerBlockId *wound = tinker_frame_wound(motion->frame, &count);
    for (int32_t i = 0; i < count; i++)
        tinker_frame_set_length(motion->frame, wound[i], row[3 * motion->bodies->len + 1 + (guint)i]);
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
        tinker_frame_note_spans(motion->frame);
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
    cairo_t *cairo = cairo_create(surface);
    gsize count = tinker_record_rows(motion->record), picture = 0;
    gboolean fine = TRUE;
    for (; fine && picture < count; picture++) {
        if (picture > 0 && drawing->enough != NULL && drawing->enough(drawing->data)) break;
        fine = place_picture(motion, picture, error);
        if (!fine) break;
        if (motion->arrows != NULL) tinker_film_arrows_dress(motion->arrows, picture, motion->frame, &paint);
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
