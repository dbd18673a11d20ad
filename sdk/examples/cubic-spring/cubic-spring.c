/* Cubic spring: a line law that is not linear, T = k d + c d^3 with d = L - L0, and the energy k d^2 / 2 + c d^4 / 4.
 *
 * With c above 0 it hardens, below 0 it softens. Where c is 0 it says so by `linear`, and the host treats it as any
 * other spring: exact stepping, merged with its neighbours. */
#include <tinker/sdk.h>

enum { COLUMN_STIFFNESS, COLUMN_CUBIC, COLUMN_REST_LENGTH };

enum { QUANTITY_EXTENSION, QUANTITY_TENSION, QUANTITY_ENERGY };

/* Physics: loops over plain arrays, which the compiler turns into vector code */

static void tension_loop(int32_t count, const double *TINKER_RESTRICT k, const double *TINKER_RESTRICT c,
                         const double *TINKER_RESTRICT rest, const double *TINKER_RESTRICT length,
                         double *TINKER_RESTRICT result)
{
    for (int32_t i = 0; i < count; i++) {
        const double d = length[i] - rest[i];
        result[i] = (k[i] + c[i] * d * d) * d;
    }
}

static void stiffness_loop(int32_t count, const double *TINKER_RESTRICT k, const double *TINKER_RESTRICT c,
                           const double *TINKER_RESTRICT rest, const double *TINKER_RESTRICT length,
                           double *TINKER_RESTRICT result)
{
    for (int32_t i = 0; i < count; i++) {
        const double d = length[i] - rest[i];
        result[i] = k[i] + 3.0 * c[i] * d * d;
    }
}

static void energy_loop(int32_t count, const double *TINKER_RESTRICT k, const double *TINKER_RESTRICT c,
                        const double *TINKER_RESTRICT rest, const double *TINKER_RESTRICT length,
                        double *TINKER_RESTRICT result)
{
    for (int32_t i = 0; i < count; i++) {
        const double square = (length[i] - rest[i]) * (length[i] - rest[i]);
        result[i] = (0.5 * k[i] + 0.25 * c[i] * square) * square;
    }
}

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    tension_loop(batch->count, tinker_column(batch, COLUMN_STIFFNESS), tinker_column(batch, COLUMN_CUBIC),
                 tinker_column(batch, COLUMN_REST_LENGTH), length, result);
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    stiffness_loop(batch->count, tinker_column(batch, COLUMN_STIFFNESS), tinker_column(batch, COLUMN_CUBIC),
                   tinker_column(batch, COLUMN_REST_LENGTH), length, by_length);
    for (int32_t i = 0; i < batch->count; i++)
        by_rate[i] = 0.0;
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    energy_loop(batch->count, tinker_column(batch, COLUMN_STIFFNESS), tinker_column(batch, COLUMN_CUBIC),
                tinker_column(batch, COLUMN_REST_LENGTH), length, stored);
    return TINKER_OK;
}

/* Linear is what all of them are, or none. */
static TinkerStatus linear(TinkerBatch *batch, double *stiffness, double *damping, double *length, double *at_length)
{
    for (int32_t i = 0; i < batch->count; i++) {
        if (tinker_column(batch, COLUMN_CUBIC)[i] != 0.0) return TINKER_RETRY_SMALLER;
        stiffness[i] = tinker_column(batch, COLUMN_STIFFNESS)[i];
        length[i] = tinker_column(batch, COLUMN_REST_LENGTH)[i];
        damping[i] = at_length[i] = 0.0;
    }
    return TINKER_OK;
}

static const TinkerLineLaw line_law = {.struct_size = sizeof(TinkerLineLaw),
                                       .tension = tension,
                                       .derivatives = derivatives,
                                       .energy = energy,
                                       .linear = linear};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};

/* Drawing and editing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double rest = instance->columns[COLUMN_REST_LENGTH], length = tinker_length(b->x - a->x, b->y - a->y);
    style->coil(style, cairo, length < rest ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_STRETCHED, a->x, a->y, b->x,
                b->y, rest);
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
    const double *rest = tinker_column(batch, COLUMN_REST_LENGTH);
    double length[1], of_one[1];
    for (int32_t i = 0; i < batch->count; i++) {
        const double k = tinker_column(batch, COLUMN_STIFFNESS)[i], c = tinker_column(batch, COLUMN_CUBIC)[i];
        tinker_end_distances(1, &input->ends[2 * i], length);
        of_one[0] = length[0] - rest[i];
        if (quantity == QUANTITY_TENSION) tension_loop(1, &k, &c, &rest[i], length, of_one);
        if (quantity == QUANTITY_ENERGY) energy_loop(1, &k, &c, &rest[i], length, of_one);
        result[i] = of_one[0];
    }
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* Declaration */

/* clang-format off */
#define DIMENSION_CUBIC_STIFFNESS {1, -2, -2, 0}
/* clang-format on */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Cubic Spring", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 200.0),
     .default_value = {25.0}, .symbol = "k", .variability = TINKER_TUNABLE,
     .description = "Force per extension where that is small"},
    {TINKER_REAL_PROPERTY("cubic", "C", "Cubic Spring", DIMENSION_CUBIC_STIFFNESS), TINKER_ANY_VALUE(0, -200.0, 200.0),
     .default_value = {25.0}, .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Force per cube of the extension"},
    {TINKER_REAL_PROPERTY("rest_length", "Undeformed Length", "Cubic Spring", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_AS_PLACED, 10.0), .symbol = "L0", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_TUNABLE, .description = "Length at which it exerts no force"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("tension", "k*(L - L0) + c*(L - L0)^3", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("potential", "k*(L - L0)^2/2 + c*(L - L0)^4/4", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "extension", "Extension", "d = L - L0", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "k d^2 / 2 + c d^4 / 4", TINKER_DIMENSION_ENERGY),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("cubic-spring", "Cubic Spring", TINKER_CONNECTOR),
     .summary = "A spring that hardens or softens with the cube of its extension", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.cubic-spring", "Cubic Spring", "1.0.0", "MIT", blocks)
