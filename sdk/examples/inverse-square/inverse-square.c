/* Inverse-square field: all bodies attract each other with G m M / r^2, and store -G m M / r a pair.
 *
 * A field sees all bodies at once and is asked for the forces on a range of them. It says that it couples bodies, so
 * that the host keeps them together in one island. Several fields in one scene add up. */
#include <tinker/sdk.h>

enum { COLUMN_G };

#define SAME_PLACE "two bodies are in the same place, where the attraction is infinite (move one)"

/* The size of the drawing, in symbols. */
#define REACH 1.0

static double sum_of_constants(const TinkerBatch *batch)
{
    double sum = 0.0;
    for (int32_t i = 0; i < batch->count; i++)
        sum += tinker_column(batch, COLUMN_G)[i];
    return sum;
}

/* Physics */

/* The attraction of all bodies on one, per its mass and G; 0 where that is no number: another is in the same place. */
static int attract(const TinkerBodies *bodies, int32_t own, double *x, double *y)
{
    const TinkerPoint *at = &bodies->points[own];
    *x = *y = 0.0;
    for (int32_t k = 0; k < bodies->count; k++) {
        if (k == own) continue;
        const double dx = bodies->points[k].x - at->x, dy = bodies->points[k].y - at->y;
        const double distance = tinker_length(dx, dy), pull = bodies->masses[k] / (distance * distance);
        *x += pull * (dx / distance);
        *y += pull * (dy / distance);
    }
    return isfinite(*x) && isfinite(*y);
}

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    const double constant = sum_of_constants(batch);
    for (int32_t i = 0; i < bodies->range; i++) {
        const int32_t own = bodies->first + i;
        double x, y;
        if (!attract(bodies, own, &x, &y)) return tinker_retry(batch, 0, SAME_PLACE);
        result[2 * i] = constant * bodies->masses[own] * x;
        result[2 * i + 1] = constant * bodies->masses[own] * y;
    }
    return TINKER_OK;
}

/* Per G. */
static double pair_energies(int32_t count, const TinkerPoint *points, const double *masses)
{
    double sum = 0.0;
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = 0; k < i; k++)
            sum -= masses[i] * masses[k] / tinker_length(points[k].x - points[i].x, points[k].y - points[i].y);
    return sum;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerBodies *bodies, double *potential)
{
    *potential = sum_of_constants(batch) * pair_energies(bodies->count, bodies->points, bodies->masses);
    return isfinite(*potential) ? TINKER_OK : tinker_retry(batch, 0, SAME_PLACE);
}

static const TinkerField field = {
    .struct_size = sizeof(TinkerField), .couples_bodies = 1, .force = force, .energy = energy};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .field = &field};

/* Drawing: four arrows towards a point. It stands where the host wants it, and is not moved. */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    static const double directions[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double far = REACH * style->symbol_size, near = 0.3 * far;
    for (int k = 0; k < 4; k++)
        style->arrow(style, cairo, TINKER_COLOUR_FIELD, instance->x + far * directions[k][0],
                     instance->y + far * directions[k][1], instance->x + near * directions[k][0],
                     instance->y + near * directions[k][1]);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    tinker_bounds_clear(box);
    tinker_bounds_add(box, instance->x, instance->y, REACH * style->symbol_size + tinker_drawing_margin(style));
}

static const TinkerRender render = {.struct_size = sizeof(TinkerRender), .layer = 3, .draw = draw, .bounds = bounds};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double pairs = pair_energies(input->body_count, input->bodies, input->masses);
    if (!isfinite(pairs)) return tinker_fail(batch, 0, SAME_PLACE);
    for (int32_t i = 0; i < batch->count; i++)
        result[i] = tinker_column(batch, COLUMN_G)[i] * pairs;
    return TINKER_OK;
}

static const TinkerGraph graph = {.struct_size = sizeof(TinkerGraph), .values = values};

/* Declaration */

/* clang-format off */
#define DIMENSION_OF_G {-1, 3, -2, 0}
/* clang-format on */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("constant", "G", "Inverse-Square Field", DIMENSION_OF_G), TINKER_NOT_NEGATIVE(0, 10.0),
     .default_value = {6.6743e-11}, .symbol = "G", .variability = TINKER_TUNABLE,
     .description = "Gravitational constant; the default is that of nature (CODATA 2018)"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("r", "sqrt((x2 - x)^2 + (y2 - y)^2)", "distance of the two bodies", TINKER_DIMENSION_LENGTH),
    TINKER_EQUATION("pair_force_x", "G*m*m2*(x2 - x)/r^3", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("pair_force_y", "G*m*m2*(y2 - y)/r^3", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("pair_potential", "-G*m*m2/r", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "energy", "Potential Energy", "-G m M / r of all pairs", TINKER_DIMENSION_ENERGY),
};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics},
    {TINKER_RENDER_INTERFACE, &render},
    {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("inverse-square", "Inverse-Square Field", TINKER_FIELD),
     .summary = "All bodies attract each other as stars do", .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.example.inverse-square", "Inverse-Square Field", "1.0.0", "MIT", blocks)
