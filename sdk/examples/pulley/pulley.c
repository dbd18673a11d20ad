/* Pulley: a rope of fixed length from its first end over any number of small wheels to its last end.
 *
 * The wheels are the ends between: points of bodies or supports that the rope passes without friction. With L, the path
 * from end to end (tinker_path_row):
 *
 *     g = L - l <= 0
 *
 * The row holds in one direction only: a rope can be shorter than its length, but not longer. Its multiplier is minus
 * the tension, which is the same in all strands. */
#include <tinker/sdk.h>

enum { COLUMN_LENGTH };

enum { QUANTITY_TENSION, QUANTITY_SLACK };

/* Where a rope pulls something into a wheel the strand between them swings round faster without end: small as the
 * wheels are, the motion ends there, at this share of the rope's length, unless the rope is slack. */
#define LEAST_STRAND 1e-3
#define NEARLY_TAUT  0.999

/* A rope that is shorter than this share of its length is drawn slack. */
#define VISIBLY_SLACK 1e-6

/* Physics */

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    const double *length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const int32_t first = tinker_first_end(batch, i), count = tinker_first_end(batch, i + 1) - first;
        const double shortest = tinker_path_row(&ends[first], count, &g[i], &jacobian[2 * first], &drift[i]);
        if (shortest < LEAST_STRAND * length[i] && g[i] > NEARLY_TAUT * length[i])
            return tinker_retry(batch, i, "what it pulls has run into a wheel (or two of its ends are in one place)");
        g[i] -= length[i];
    }
    return TINKER_OK;
}

/* What errors of the row are measured against. */
static TinkerStatus scale(TinkerBatch *batch, double *length)
{
    for (int32_t i = 0; i < batch->count; i++)
        length[i] = tinker_column(batch, COLUMN_LENGTH)[i];
    return TINKER_OK;
}

static const TinkerConstraint constraint = {
    .struct_size = sizeof(TinkerConstraint), .rows = 1, .unilateral = 1, .rows_at = rows_at, .scale = scale};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .constraint = &constraint};

/* Drawing and editing */

static double path_of(const TinkerInstance *instance)
{
    double path = 0.0;
    for (int32_t k = 1; k < instance->ends; k++)
        path += tinker_length(instance->end[k].x - instance->end[k - 1].x, instance->end[k].y - instance->end[k - 1].y);
    return path;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *end = instance->end;
    const double length = instance->columns[COLUMN_LENGTH];
    const int slack = length - path_of(instance) > VISIBLY_SLACK * length;
    for (int32_t k = 1; k < instance->ends; k++)
        style->line(style, cairo, slack ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_CONNECTOR, end[k - 1].x,
                    end[k - 1].y, end[k].x, end[k].y);
    for (int32_t k = 1; k < instance->ends - 1; k++)
        style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_BODY_EDGE, end[k].x, end[k].y,
                      0.5 * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

static const TinkerRender render = {
    .struct_size = sizeof(TinkerRender), .layer = 2, .draw = draw, .bounds = tinker_connector_bounds};

static const TinkerEdit edit = {.struct_size = sizeof(TinkerEdit),
                                .hit = tinker_connector_hit,
                                .move = tinker_ends_move,
                                .move_absolute = tinker_ends_move_absolute};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (quantity == QUANTITY_TENSION) {
        if (input->multipliers == NULL) return tinker_fail(batch, 0, "the rope's force is not known yet");
        for (int32_t i = 0; i < batch->count; i++)
            result[i] = 0.0 - input->multipliers[i];
        return TINKER_OK;
    }
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = tinker_column(batch, COLUMN_LENGTH)[i];
        for (int32_t k = tinker_first_end(batch, i) + 1; k < tinker_first_end(batch, i + 1); k++)
            result[i] -=
                tinker_length(input->ends[k].x - input->ends[k - 1].x, input->ends[k].y - input->ends[k - 1].y);
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* Declaration */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("length", "Length", "Rope", TINKER_DIMENSION_LENGTH),
     TINKER_POSITIVE(TINKER_DEFAULT_AS_PLACED, 0.1, 10.0), .symbol = "l", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_STRUCTURAL, .description = "Longest path from its first end over the wheels to its last"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("g", "L - l", NULL, TINKER_DIMENSION_LENGTH),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force along the rope, the same in all strands",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "slack", "Slack", "How much longer the rope is than its path", TINKER_DIMENSION_LENGTH),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("pulley", "Pulley", TINKER_CONNECTOR), .summary = "A rope over wheels; it may be slack",
     .least_ends = 2, .most_ends = -1, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.pulley", "Pulley", "1.0.0", "MIT", blocks)
