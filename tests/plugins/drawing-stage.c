/* Helpers of a style that only take notes, and a stage for one instance. */
#include "drawing-stage.h"

#include <math.h>
#include <string.h>

static Recorder *recorder_of(const TinkerStyle *style)
{
    return style->context;
}

/* Strokes reach half their width, symbols 0.6 of the symbol size: what shapes.h promises of a host's helpers. */
static void touch(Recorder *recorder, double x, double y, double reach)
{
    tinker_bounds_add(recorder->box, x, y, reach + recorder->style.line_width / 2);
}

static void take(Recorder *recorder, Note note)
{
    g_assert_cmpint(recorder->count, <, (int)G_N_ELEMENTS(recorder->notes));
    g_assert_true(isfinite(note.x1) && isfinite(note.y1) && isfinite(note.x2) && isfinite(note.y2));
    recorder->notes[recorder->count++] = note;
}

static void take_line(const TinkerStyle *style, const char *helper, int32_t colour, const double line[4], double reach)
{
    Recorder *recorder = recorder_of(style);
    take(recorder, (Note){helper, colour, 0, line[0], line[1], line[2], line[3]});
    touch(recorder, line[0], line[1], reach);
    touch(recorder, line[2], line[3], reach);
}

#define LINE_HELPER(name, reach)                                                                                       \
    static void name(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1, double x2,  \
                     double y2)                                                                                        \
    {                                                                                                                  \
        take_line(style, #name, colour, (const double[4]){x1, y1, x2, y2}, (reach)*SYMBOL);                            \
    }
LINE_HELPER(line, 0)
LINE_HELPER(hatch, 0.5)
LINE_HELPER(dashpot, 0.4)
LINE_HELPER(bar, 0.2)
LINE_HELPER(arrow, 0.4)

static void coil(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1, double x2,
                 double y2, double rest_length)
{
    take_line(style, "coil", colour, (const double[4]){x1, y1, x2, y2}, 0.5 * SYMBOL);
    Recorder *recorder = recorder_of(style);
    recorder->notes[recorder->count - 1].number = rest_length;
}

static void box(const TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x, double y,
                double width, double height, double orientation)
{
    Recorder *recorder = recorder_of(style);
    take(recorder, (Note){"box", fill, edge, x, y, width, height, orientation});
    if (width == 0 && height == 0) touch(recorder, x, y, 0.25 * SYMBOL);
    for (int corner = 0; corner < 4; corner++) {
        const double own_x = (corner & 1 ? 0.5 : -0.5) * width, own_y = (corner & 2 ? 0.5 : -0.5) * height;
        touch(recorder, x + own_x * cos(orientation) - own_y * sin(orientation),
              y + own_x * sin(orientation) + own_y * cos(orientation), 0);
    }
}

static void end_mark(const TinkerStyle *style, struct _cairo *cairo, double x, double y, int32_t attached)
{
    Recorder *recorder = recorder_of(style);
    take(recorder, (Note){"end_mark", 0, attached, x, y, x, y, 0});
    touch(recorder, x, y, 0.3 * SYMBOL);
}

static void circle(const TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x, double y,
                   double radius)
{
    Recorder *recorder = recorder_of(style);
    take(recorder, (Note){"circle", fill, edge, x, y, x, y, radius});
    touch(recorder, x, y, radius);
}

static void text(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y, const char *string)
{
    Recorder *recorder = recorder_of(style);
    take(recorder, (Note){"text", colour, 0, x, y, x, y, (double)strlen(string)});
    touch(recorder, x, y, 0.5 * SYMBOL * (double)strlen(string));
}

static void polyline(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, const double *points,
                     int32_t count)
{
    const double *last = &points[2 * (count - 1)];
    Recorder *recorder = recorder_of(style);
    g_assert_cmpint(recorder->point_count + count, <=, STAGE_POINTS);
    double *kept = recorder->points + 2 * recorder->point_count;
    memcpy(kept, points, 2 * (size_t)count * sizeof(double));
    recorder->point_count += count;
    take(recorder, (Note){"polyline", colour, 0, points[0], points[1], last[0], last[1], count, kept});
    for (int32_t k = 0; k < count; k++) {
        touch(recorder, points[2 * k], points[2 * k + 1], 0);
    }
}

static void recorder_init(Recorder *recorder)
{
    *recorder = (Recorder){.style = {.struct_size = sizeof(TinkerStyle),
                                     .pixel = 0.0125,
                                     .line_width = 0.02,
                                     .symbol_size = SYMBOL,
                                     .view = {-10, -10, 10, 10},
                                     .transform = {80, 0, 0, 0, -80, 0},
                                     .context = recorder,
                                     .line = line,
                                     .box = box,
                                     .hatch = hatch,
                                     .coil = coil,
                                     .dashpot = dashpot,
                                     .bar = bar,
                                     .arrow = arrow,
                                     .end_mark = end_mark,
                                     .circle = circle,
                                     .text = text,
                                     .polyline = polyline}};
    tinker_bounds_clear(recorder->box);
}

void stage_init(Stage *stage, const char *name)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open(name), 1);
    *stage = (Stage){.ends = {{1, 2, 1, 0}, {4, 6, 0, 0}}};
    for (int32_t column = 0; column < block_columns(batch->block); column++) {
        stage->columns[column] = batch->columns[column][0];
    }
    stage->instance = (TinkerInstance){.struct_size = sizeof(TinkerInstance),
                                       .ends = MAX(batch->block->most_ends, batch->block->least_ends),
                                       .name = name,
                                       .columns = stage->columns,
                                       .end = stage->ends,
                                       .x = 1,
                                       .y = 2};
}

void stage_set(Stage *stage, const char *property, double value)
{
    stage->columns[block_column(block_open(stage->instance.name), property)] = value;
}

void stage_draw(Stage *stage)
{
    const TinkerRender *render = block_interface(block_open(stage->instance.name), TINKER_RENDER_INTERFACE);
    double bounds[4];
    recorder_init(&stage->recorder);
    stage->recorder.style.state = stage->state;
    render->draw(&stage->instance, NULL, &stage->recorder.style);
    g_assert_cmpint(stage->recorder.count, >, 0);
    render->bounds(&stage->instance, &stage->recorder.style, bounds);
    const double *drawn = stage->recorder.box;
    if (drawn[0] < bounds[0] || drawn[1] < bounds[1] || drawn[2] > bounds[2] || drawn[3] > bounds[3])
        g_error("%s draws on %g %g %g %g, but its bounds are %g %g %g %g", stage->instance.name, drawn[0], drawn[1],
                drawn[2], drawn[3], bounds[0], bounds[1], bounds[2], bounds[3]);
}

const Note *stage_note(const Stage *stage, const char *helper, int number)
{
    for (int i = 0; i < stage->recorder.count; i++) {
        if (strcmp(stage->recorder.notes[i].helper, helper) == 0 && number-- == 0) return &stage->recorder.notes[i];
    }
    g_error("%s does not draw with %s", stage->instance.name, helper);
}

int stage_notes(const Stage *stage, const char *helper)
{
    int count = 0;
    for (int i = 0; i < stage->recorder.count; i++) {
        count += strcmp(stage->recorder.notes[i].helper, helper) == 0;
    }
    return count;
}

void stage_assert_line(const Note *drawn, double x1, double y1, double x2, double y2)
{
    g_assert_cmpfloat_with_epsilon(drawn->x1, x1, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->y1, y1, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->x2, x2, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->y2, y2, 1e-14);
}
