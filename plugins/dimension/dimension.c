/* Dimension: the distance between two points, drawn as in a drawing of a workshop. It acts on nothing, so that a scene
 * moves with it as without it. Its length is among what every block with two ends has. */
#include <stdio.h>

#include <tinker/sdk.h>

#define BESIDE 1.4 /* symbol sizes between the points and the dimension line */
#define BEYOND 0.3 /* how far extension lines go past it */
#define HALF   1.6 /* symbol sizes: half a text */
#define ALONG  0.3 /* where the text stands along the line: in the middle is the name */
#define ABOVE  1.5 /* symbol sizes from the line to the middle of the text */

/* The dimension line, parallel to the points' own and to its left as seen from the first; where the points coincide
 * there is none. */
typedef struct {
    double length, nx, ny; /* across, a unit vector */
    double x1, y1, x2, y2;
} Line;

static Line line_of(const TinkerInstance *instance)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double dx = b->x - a->x, dy = b->y - a->y, length = tinker_length(dx, dy);
    const double off = BESIDE * tinker_instance_symbol_size(instance);
    Line line = {length, 0.0, 1.0, a->x, a->y, b->x, b->y};
    if (length > 0.0) {
        line.nx = -dy / length;
        line.ny = dx / length;
    }
    line.x1 += off * line.nx;
    line.y1 += off * line.ny;
    line.x2 += off * line.nx;
    line.y2 += off * line.ny;
    return line;
}

/* Drawing */

static void draw_extension(const TinkerStyle *style, struct _cairo *cairo, const TinkerEnd *end, const Line *line,
                           double x, double y)
{
    const double past = BEYOND * style->symbol_size;
    style->line(style, cairo, TINKER_COLOUR_MOTION, end->x, end->y, x + past * line->nx, y + past * line->ny);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    char text[48];
    const Line line = line_of(instance);
    const double x = 0.5 * (line.x1 + line.x2), y = 0.5 * (line.y1 + line.y2);
    draw_extension(style, cairo, &instance->end[0], &line, line.x1, line.y1);
    draw_extension(style, cairo, &instance->end[1], &line, line.x2, line.y2);
    style->arrow(style, cairo, TINKER_COLOUR_MOTION, x, y, line.x1, line.y1);
    style->arrow(style, cairo, TINKER_COLOUR_MOTION, x, y, line.x2, line.y2);
    snprintf(text, sizeof text, "%.4g m", line.length);
    style->text(style, cairo, TINKER_COLOUR_TEXT,
                line.x1 + ALONG * (line.x2 - line.x1) + ABOVE * style->symbol_size * line.nx,
                line.y1 + ALONG * (line.y2 - line.y1) + ABOVE * style->symbol_size * line.ny, text);
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const Line line = line_of(instance);
    const double margin = (ABOVE + 1.0) * style->symbol_size + tinker_drawing_margin(style);
    tinker_connector_bounds(instance, style, box);
    tinker_bounds_add(box, line.x1, line.y1, margin);
    tinker_bounds_add(box, line.x2, line.y2, margin);
}

/* Editing */

/* The dimension line, those to the points, and the text. */
static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const Line line = line_of(instance);
    const TinkerEnd *end = instance->end;
    const double symbol = tinker_instance_symbol_size(instance), past = BEYOND * symbol;
    const double xt = line.x1 + ALONG * (line.x2 - line.x1) + ABOVE * symbol * line.nx,
                 yt = line.y1 + ALONG * (line.y2 - line.y1) + ABOVE * symbol * line.ny;
    const double lines[3][4] = {
        {line.x1, line.y1, line.x2, line.y2},
        {end[0].x, end[0].y, line.x1 + past * line.nx, line.y1 + past * line.ny},
        {end[1].x, end[1].y, line.x2 + past * line.nx, line.y2 + past * line.ny},
    };
    int32_t part = tinker_ends_hit(instance, x, y, reach);
    for (int k = 0; k < 3 && part == TINKER_PART_NONE; k++) {
        const double *at = lines[k];
        if (tinker_segment_distance(x, y, at[0], at[1], at[2], at[3]) <= reach) part = TINKER_PART_WHOLE;
    }
    if (part == TINKER_PART_NONE && tinker_length(x - xt, y - yt) <= HALF * symbol + reach) part = TINKER_PART_WHOLE;
    return part;
}

/* Tables */

static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};

static const TinkerInterface interfaces[] = {
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("dimension", "Dimension", TINKER_MEASURE), .summary = "The distance between two points, as it is now",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_PLUGIN("org.tinker.dimension", "Dimension", "0.1.0", "MIT", blocks)
