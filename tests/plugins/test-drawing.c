/* Drawings on a style whose helpers only take notes: which colours, where, and whether all stays in the bounds that the
 * block declares. */
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"

#define PI     3.14159265358979323846
#define SYMBOL 0.25

/* One call of a helper. */
typedef struct {
    const char *helper;
    int32_t colour, edge; /* of a mark: whether it is attached */
    double x1, y1, x2, y2;
    double number; /* rest length of a coil, radius of a circle */
} Note;

typedef struct {
    TinkerStyle style;
    Note notes[64];
    int count;
    double box[4]; /* what was drawn on, m */
} Recorder;

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
    take(recorder, (Note){helper, colour, 0, line[0], line[1], line[2], line[3], 0});
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

/* As one note from its first point to its last. */
static void polyline(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, const double *points,
                     int32_t count)
{
    const double *last = &points[2 * (count - 1)];
    take(recorder_of(style), (Note){"polyline", colour, 0, points[0], points[1], last[0], last[1], count});
    for (int32_t k = 0; k < count; k++) {
        touch(recorder_of(style), points[2 * k], points[2 * k + 1], 0);
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

/* One instance with default properties, at (1, 2), its ends at (1, 2) and (4, 6). */
typedef struct {
    BlockBatch *batch;
    double columns[32];
    TinkerEnd ends[4];
    TinkerInstance instance;
    Recorder recorder;
} Stage;

static void stage_init(Stage *stage, const char *name)
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

static void stage_set(Stage *stage, const char *property, double value)
{
    stage->columns[block_column(block_open(stage->instance.name), property)] = value;
}

/* Draws, and checks that the drawing stays in its bounds. */
static void draw(Stage *stage)
{
    const TinkerRender *render = block_interface(block_open(stage->instance.name), TINKER_RENDER_INTERFACE);
    double bounds[4];
    recorder_init(&stage->recorder);
    render->draw(&stage->instance, NULL, &stage->recorder.style);
    g_assert_cmpint(stage->recorder.count, >, 0);
    render->bounds(&stage->instance, &stage->recorder.style, bounds);
    const double *drawn = stage->recorder.box;
    if (drawn[0] < bounds[0] || drawn[1] < bounds[1] || drawn[2] > bounds[2] || drawn[3] > bounds[3])
        g_error("%s draws on %g %g %g %g, but its bounds are %g %g %g %g", stage->instance.name, drawn[0], drawn[1],
                drawn[2], drawn[3], bounds[0], bounds[1], bounds[2], bounds[3]);
}

/* The n-th call of a helper, which must exist. */
static const Note *note(const Stage *stage, const char *helper, int number)
{
    for (int i = 0; i < stage->recorder.count; i++) {
        if (strcmp(stage->recorder.notes[i].helper, helper) == 0 && number-- == 0) return &stage->recorder.notes[i];
    }
    g_error("%s does not draw with %s", stage->instance.name, helper);
}

static void assert_line(const Note *drawn, double x1, double y1, double x2, double y2)
{
    g_assert_cmpfloat_with_epsilon(drawn->x1, x1, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->y1, y1, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->x2, x2, 1e-14);
    g_assert_cmpfloat_with_epsilon(drawn->y2, y2, 1e-14);
}

static void test_connector(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    draw(&stage);
    const char *helper = strcmp(data, "spring") == 0 ? "coil" : strcmp(data, "rod") == 0 ? "bar" : "dashpot";
    assert_line(note(&stage, helper, 0), 1, 2, 4, 6);
    g_assert_cmpint(note(&stage, "end_mark", 0)->edge, ==, 1);
    g_assert_cmpint(note(&stage, "end_mark", 1)->edge, ==, 0);
    g_assert_cmpfloat(note(&stage, "end_mark", 1)->x1, ==, 4);
    stage.ends[1] = stage.ends[0];
    draw(&stage);
}

/* Over two wheels, up, across and down: strands touch the wheels on the outside, from a radius below each mass's line
 * to one above the wheels, and what lies on a wheel is as far from its centre as that is large. */
static void test_rope(void)
{
    const double radius = 0.5 * SYMBOL;
    Stage stage;
    stage_init(&stage, "rope");
    stage.instance.ends = 4;
    const TinkerEnd ends[4] = {{-1, -3, 1, 0, 0}, {-1, 0, 1, 0, 0}, {2, 0, 1, 0, 0}, {2, -4, 0, 0, 0}};
    memcpy(stage.ends, ends, sizeof ends);
    stage_set(&stage, "length", 10);
    draw(&stage);
    for (int wheel = 0; wheel < 2; wheel++) {
        g_assert_cmpfloat(note(&stage, "circle", wheel)->x1, ==, wheel == 0 ? -1 : 2);
        g_assert_cmpfloat(note(&stage, "circle", wheel)->number, ==, radius);
    }
    const Note *up = note(&stage, "line", 0);
    g_assert_cmpfloat(up->x1, ==, -1);
    g_assert_cmpfloat(up->y1, ==, -3);
    g_assert_cmpfloat(up->x2, <, -1);
    g_assert_cmpint(up->colour, ==, TINKER_COLOUR_CONNECTOR);
    for (int i = 0; i < stage.recorder.count; i++) {
        const Note *line = &stage.recorder.notes[i];
        if (strcmp(line->helper, "line") != 0) continue;
        /* nowhere does the rope cut into a wheel, but for the chords of its arcs */
        for (int wheel = 0; wheel < 2; wheel++) {
            const double x = wheel == 0 ? -1 : 2;
            g_assert_cmpfloat(tinker_segment_distance(x, 0, line->x1, line->y1, line->x2, line->y2), >, 0.98 * radius);
        }
    }
    /* the middle strand is the common tangent above */
    assert_line(note(&stage, "line", 13), -1, radius, 2, radius);
    stage_set(&stage, "length", 10.1);
    draw(&stage);
    g_assert_cmpint(note(&stage, "line", 0)->colour, ==, TINKER_COLOUR_COMPRESSED);
}

/* On a wheel of radius 3 about (1, 2), of which (4, 6) is 5 away: 4 m are free. Longer, it hangs from where it leaves
 * the wheel; where its length is not known it is drawn straight. */
static void test_cord(void)
{
    Stage stage;
    stage_init(&stage, "cord");
    stage_set(&stage, "radius", 3);
    const double lengths[] = {4, NAN, 5};
    for (size_t i = 0; i < G_N_ELEMENTS(lengths); i++) {
        stage_set(&stage, "length", lengths[i]);
        draw(&stage);
        const Note *free = note(&stage, i < 2 ? "line" : "polyline", i < 2 ? 0 : 1);
        assert_line(free, 1 + 3 * -0.28, 2 + 3 * 0.96, 4, 6);
        g_assert_cmpint(free->colour, ==, i < 2 ? TINKER_COLOUR_CONNECTOR : TINKER_COLOUR_COMPRESSED);
    }
}

/* A ring about its end; behind it the path, which goes on to where it is now. */
static void test_marker(void)
{
    const double path[6] = {-7, 3, 2, 8, 1, 5};
    Stage stage;
    stage_init(&stage, "marker");
    draw(&stage);
    g_assert_cmpfloat(note(&stage, "circle", 0)->x1, ==, 1);
    g_assert_cmpfloat(note(&stage, "circle", 0)->y1, ==, 2);
    g_assert_cmpint(note(&stage, "circle", 0)->colour, ==, -1);
    g_assert_cmpint(stage.recorder.count, ==, 6); /* with four ticks, and the mark of its end */
    stage.instance.path = path;
    stage.instance.path_count = 3;
    draw(&stage);
    g_assert_cmpfloat(note(&stage, "polyline", 0)->number, ==, 3);
    assert_line(note(&stage, "polyline", 0), -7, 3, 1, 5);
    assert_line(note(&stage, "polyline", 1), 1, 5, 1, 2);
}

/* Red, black, blue; black within a millionth of the rest length. The spring is 5 m long. */
static void test_spring_colours(void)
{
    static const struct {
        double rest_length;
        int32_t colour;
    } rows[] = {{6, TINKER_COLOUR_COMPRESSED},
                {5 * (1 + 2e-6), TINKER_COLOUR_COMPRESSED},
                {5 * (1 + 0.5e-6), TINKER_COLOUR_CONNECTOR},
                {5, TINKER_COLOUR_CONNECTOR},
                {5 * (1 - 0.5e-6), TINKER_COLOUR_CONNECTOR},
                {5 * (1 - 2e-6), TINKER_COLOUR_STRETCHED},
                {4, TINKER_COLOUR_STRETCHED},
                {0, TINKER_COLOUR_STRETCHED}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        Stage stage;
        stage_init(&stage, "spring");
        stage_set(&stage, "rest_length", rows[i].rest_length);
        draw(&stage);
        g_assert_cmpint(note(&stage, "coil", 0)->colour, ==, rows[i].colour);
        g_assert_cmpfloat(note(&stage, "coil", 0)->number, ==, rows[i].rest_length);
    }
}

static void test_mass(void)
{
    Stage stage;
    stage_init(&stage, "mass");
    stage.instance.orientation = 0.7;
    draw(&stage);
    const Note *drawn = note(&stage, "box", 0);
    assert_line(drawn, 1, 2, 0.8, 0.8);
    g_assert_cmpint(drawn->colour, ==, TINKER_COLOUR_BODY);
    g_assert_cmpint(drawn->edge, ==, TINKER_COLOUR_BODY_EDGE);
    g_assert_cmpfloat(drawn->number, ==, 0.7);
    stage_set(&stage, "width", 0);
    stage_set(&stage, "height", 0);
    draw(&stage);
    assert_line(note(&stage, "box", 0), 1, 2, 0, 0);
}

/* The solid line is the top, the hatching on its right-hand side, which is inside the slab. */
static void test_support(void)
{
    Stage stage;
    stage_init(&stage, "support");
    draw(&stage);
    assert_line(note(&stage, "line", 0), -1, 2.2, 3, 2.2);
    assert_line(note(&stage, "hatch", 0), -1, 2.2, 3, 2.2);
    stage.instance.orientation = PI; /* a ceiling: the top faces down, the hatching lies above */
    draw(&stage);
    assert_line(note(&stage, "line", 0), 3, 1.8, -1, 1.8);
    stage.instance.orientation = 0.6;
    draw(&stage);
    stage_set(&stage, "solid", 0);
    draw(&stage);
    g_assert_cmpint(note(&stage, "circle", 0)->edge, ==, TINKER_COLOUR_BODY_EDGE);
    g_assert_cmpfloat(note(&stage, "line", 0)->x1, ==, 1);
    stage_set(&stage, "width", 0);
    stage_set(&stage, "height", 0);
    draw(&stage);
    stage_set(&stage, "solid", 1);
    draw(&stage);
}

/* From the body along the force; it turns round with the sign, and is as long as the force is large. */
static void test_motor(void)
{
    Stage stage;
    stage_init(&stage, "motor");
    stage_set(&stage, "amplitude", 4);
    stage_set(&stage, "waveform", 4);
    draw(&stage);
    const Note full = *note(&stage, "arrow", 0);
    g_assert_cmpint(full.colour, ==, TINKER_COLOUR_FORCE);
    assert_line(&full, 1, 2, full.x2, 2);
    g_assert_cmpfloat(full.x2, >, 1);
    stage_set(&stage, "waveform", -2);
    draw(&stage);
    assert_line(note(&stage, "arrow", 0), 1, 2, 1 - (full.x2 - 1) / 2, 2);
    stage_set(&stage, "angle", PI / 2);
    draw(&stage);
    assert_line(note(&stage, "arrow", 0), 1, 2, 1, 2 - (full.x2 - 1) / 2);
    stage_set(&stage, "waveform", 400); /* an expression goes beyond the amplitude: the arrow does not */
    draw(&stage);
    assert_line(note(&stage, "arrow", 0), 1, 2, 1, 2 + (full.x2 - 1));
    stage_set(&stage, "waveform", 0); /* no force, no head, but something to be seen */
    draw(&stage);
    g_assert_cmpfloat(note(&stage, "line", 0)->y2, >, 2);
    stage_set(&stage, "amplitude", 0);
    draw(&stage);
}

static void test_support_motion(void)
{
    Stage stage;
    stage_init(&stage, "support-motion");
    stage_set(&stage, "angle", PI / 2);
    draw(&stage);
    const Note *down = note(&stage, "arrow", 0), *up = note(&stage, "arrow", 1);
    g_assert_cmpint(up->colour, ==, TINKER_COLOUR_MOTION);
    g_assert_cmpfloat(up->x2, ==, 1);
    g_assert_cmpfloat(up->y2, >, 2);
    g_assert_cmpfloat_with_epsilon(up->y2 - 2, 2 - down->y2, 1e-14);
}

static void test_fields(void)
{
    Stage stage;
    stage_init(&stage, "gravity");
    draw(&stage);
    const Note *arrow_down = note(&stage, "arrow", 0);
    g_assert_cmpfloat(arrow_down->x1, ==, arrow_down->x2);
    g_assert_cmpfloat(arrow_down->y2, <, arrow_down->y1);
    g_assert_cmpint(arrow_down->colour, ==, TINKER_COLOUR_FIELD);
    g_assert_cmpfloat(note(&stage, "text", 0)->number, ==, 1);
    stage_set(&stage, "angle", 0.9);
    draw(&stage);
    stage_init(&stage, "wind");
    draw(&stage);
    note(&stage, "circle", 0);
    for (int k = 0; k < 12; k++) {
        const int32_t column = block_column(block_open("wind"), "velocity");
        stage.columns[column] = 5 * cos(k * PI / 6);
        stage.columns[column + 1] = 5 * sin(k * PI / 6);
        draw(&stage);
        const Note *middle = note(&stage, "arrow", 1);
        g_assert_cmpfloat_with_epsilon(middle->x2 - middle->x1, 2 * SYMBOL * cos(k * PI / 6), 1e-14);
        g_assert_cmpfloat_with_epsilon(middle->y2 - middle->y1, 2 * SYMBOL * sin(k * PI / 6), 1e-14);
        note(&stage, "arrow", 2);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_data_func("/plugins/drawing/spring", "spring", test_connector);
    g_test_add_data_func("/plugins/drawing/damper", "damper", test_connector);
    g_test_add_data_func("/plugins/drawing/rod", "rod", test_connector);
    g_test_add_func("/plugins/drawing/spring/colours", test_spring_colours);
    g_test_add_func("/plugins/drawing/mass", test_mass);
    g_test_add_func("/plugins/drawing/support", test_support);
    g_test_add_func("/plugins/drawing/motor", test_motor);
    g_test_add_func("/plugins/drawing/rope", test_rope);
    g_test_add_func("/plugins/drawing/cord", test_cord);
    g_test_add_func("/plugins/drawing/marker", test_marker);
    g_test_add_func("/plugins/drawing/support-motion", test_support_motion);
    g_test_add_func("/plugins/drawing/fields", test_fields);
    return g_test_run();
}
