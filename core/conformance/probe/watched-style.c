/* The helpers of a style, exchanged for ones that look at their numbers before they draw. The host's helpers draw
 * nothing where a number is none, so that a mistake would show in no picture. */
#include "conformance/probe/watched-style.h"

#include <math.h>

static TinkerStyle plain; /* the host's helpers; a child draws one picture at a time */
static char *seen;

static void look(const char *helper, const char *names, const double *numbers, int count)
{
    gboolean finite = TRUE;
    for (int i = 0; i < count; i++)
        finite = finite && isfinite(numbers[i]);
    if (finite || seen != NULL) return;
    GString *text = g_string_new(NULL);
    g_string_printf(text, "%s with (%s) = (", helper, names);
    for (int i = 0; i < count; i++)
        g_string_append_printf(text, "%s%.4g", i > 0 ? ", " : "", isnan(numbers[i]) ? NAN : numbers[i]);
    g_string_append_c(text, ')');
    seen = g_string_free(text, FALSE);
}

#define LOOK(helper, names, ...)                                                                                       \
    do {                                                                                                               \
        const double numbers[] = {__VA_ARGS__};                                                                        \
        look(helper, names, numbers, (int)G_N_ELEMENTS(numbers));                                                      \
    } while (0)

#define WATCH_LINE(name)                                                                                               \
    static void watched_##name(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1,   \
                               double x2, double y2)                                                                   \
    {                                                                                                                  \
        LOOK(#name, "x1, y1, x2, y2", x1, y1, x2, y2);                                                                 \
        plain.name(style, cairo, colour, x1, y1, x2, y2);                                                              \
    }

WATCH_LINE(line)
WATCH_LINE(hatch)
WATCH_LINE(dashpot)
WATCH_LINE(bar)
WATCH_LINE(arrow)

static void watched_coil(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x1, double y1,
                         double x2, double y2, double rest_length)
{
    LOOK("coil", "x1, y1, x2, y2, rest_length", x1, y1, x2, y2, rest_length);
    plain.coil(style, cairo, colour, x1, y1, x2, y2, rest_length);
}

static void watched_box(const TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x, double y,
                        double width, double height, double orientation)
{
    LOOK("box", "x, y, width, height, orientation", x, y, width, height, orientation);
    plain.box(style, cairo, fill, edge, x, y, width, height, orientation);
}

static void watched_end_mark(const TinkerStyle *style, struct _cairo *cairo, double x, double y, int32_t attached)
{
    LOOK("end_mark", "x, y", x, y);
    plain.end_mark(style, cairo, x, y, attached);
}

static void watched_circle(const TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge, double x,
                           double y, double radius)
{
    LOOK("circle", "x, y, radius", x, y, radius);
    plain.circle(style, cairo, fill, edge, x, y, radius);
}

static void watched_text(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y,
                         const char *text)
{
    LOOK("text", "x, y", x, y);
    plain.text(style, cairo, colour, x, y, text);
}

static void watched_polyline(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, const double *points,
                             int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        LOOK("polyline", "x, y", points[2 * i], points[2 * i + 1]);
    plain.polyline(style, cairo, colour, points, count);
}

static void watched_polygon(const TinkerStyle *style, struct _cairo *cairo, int32_t fill, int32_t edge,
                            const double *points, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        LOOK("polygon", "x, y", points[2 * i], points[2 * i + 1]);
    plain.polygon(style, cairo, fill, edge, points, count);
}

static void watched_note(const TinkerStyle *style, struct _cairo *cairo, int32_t colour, double x, double y,
                         double height, const char *text)
{
    LOOK("note", "x, y, height", x, y, height);
    if (plain.note != NULL) plain.note(style, cairo, colour, x, y, height, text);
}

void kit_style_watch(TinkerStyle *style)
{
    plain = *style;
    g_clear_pointer(&seen, g_free);
    style->line = watched_line;
    style->box = watched_box;
    style->hatch = watched_hatch;
    style->coil = watched_coil;
    style->dashpot = watched_dashpot;
    style->bar = watched_bar;
    style->arrow = watched_arrow;
    style->end_mark = watched_end_mark;
    style->circle = watched_circle;
    style->text = watched_text;
    style->polyline = watched_polyline;
    style->polygon = watched_polygon;
    style->note = watched_note;
}

char *kit_style_seen(void)
{
    return g_steal_pointer(&seen);
}
