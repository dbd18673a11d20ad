/* A field whose law is typed, the same on every body: its components, or the potential of which it is minus the
 * gradient.
 */
#include <tinker/sdk.h>

static const TinkerPhysics physics;
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result);

static const TinkerPropertyType properties[] = {TINKER_TYPED_FORCES};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "power", "Power", "Power given to all bodies", TINKER_DIMENSION_POWER),
};

/* Drawing: a ring with its letter, where the host wants it. */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    style->circle(style, cairo, -1, TINKER_COLOUR_FIELD, instance->x, instance->y, style->symbol_size);
    style->text(style, cairo, TINKER_COLOUR_FIELD, instance->x, instance->y, "F");
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    box[0] = box[2] = instance->x;
    box[1] = box[3] = instance->y;
    tinker_bounds_add(box, instance->x, instance->y, style->symbol_size + tinker_drawing_margin(style));
}

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const double away = tinker_length(x - instance->x, y - instance->y);
    return away <= tinker_instance_symbol_size(instance) + reach ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

static void move(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor)
{
    (void)instance;
    (void)part;
    (void)dx;
    (void)dy;
    (void)editor;
}

/* Tables */

static const TinkerRender render = {sizeof(TinkerRender), 4, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, move, move, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};
static const TinkerUnitChoice unit_choices[] = {{"power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("law-field", "Typed Field", TINKER_FIELD), .summary = "A force on every body by a law that is typed",
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_TYPED_PLUGIN("org.tinker.law-field", "Typed Field", "0.1.0", "MIT", blocks)

/* Physics */

static TinkerStatus force(TinkerBatch *batch, const TinkerBodies *bodies, double *result)
{
    double of_one[2 * TINKER_TYPED_CHUNK];
    for (int32_t k = 0; k < 2 * bodies->range; k++)
        result[k] = 0.0;
    for (int32_t first = 0; first < bodies->range; first += TINKER_TYPED_CHUNK) {
        const int32_t left = bodies->range - first, count = left < TINKER_TYPED_CHUNK ? left : TINKER_TYPED_CHUNK;
        const int32_t body = bodies->first + first;
        for (int32_t i = 0; i < batch->count; i++) {
            tinker_typed_forces(tinker_typed_laws, batch, i, 0, count, &bodies->points[body], &bodies->masses[body],
                                of_one);
            for (int32_t k = 0; k < 2 * count; k++)
                result[2 * first + k] += of_one[k];
        }
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerBodies *bodies, double *potential)
{
    *potential = 0.0;
    for (int32_t k = 0; k < bodies->count; k++) {
        const TinkerTypedLawPlace place = tinker_typed_place(batch, &bodies->points[k], bodies->masses[k]);
        for (int32_t i = 0; i < batch->count; i++)
            *potential += tinker_typed_energy(tinker_typed_laws, batch, i, &place);
    }
    return TINKER_OK;
}

/* Row by row: by x and y, then by vx and vy. */
static TinkerStatus derivatives(TinkerBatch *batch, const TinkerBodies *bodies, double *jacobian)
{
    for (int32_t k = 0; k < bodies->range; k++) {
        const int32_t body = bodies->first + k;
        const TinkerTypedLawPlace place = tinker_typed_place(batch, &bodies->points[body], bodies->masses[body]);
        for (int32_t entry = 0; entry < 8; entry++) {
            const int32_t axis = entry % 4 / 2, by = entry % 2 + (entry < 4 ? 0 : 2);
            double sum = 0.0;
            for (int32_t i = 0; i < batch->count; i++)
                sum += tinker_typed_force_slope(tinker_typed_laws, batch, i, axis, by, &place);
            jacobian[8 * k + entry] = sum;
        }
    }
    return TINKER_OK;
}

static const TinkerField field = {
    .struct_size = sizeof(TinkerField), .force = force, .energy = energy, .derivatives = derivatives};
static const TinkerPhysics physics = {
    .struct_size = sizeof(TinkerPhysics), .field = &field, .prepare = tinker_typed_prepare};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    (void)quantity;
    if (batch->laws == NULL) return tinker_fail(batch, 0, "its law is not known before a run");
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = 0.0;
        for (int32_t k = 0; k < input->body_count; k++) {
            const TinkerPoint *body = &input->bodies[k];
            const TinkerTypedLawPlace place = tinker_typed_place(batch, body, input->masses[k]);
            result[i] += tinker_typed_force(tinker_typed_laws, batch, i, 0, &place) * body->vx +
                         tinker_typed_force(tinker_typed_laws, batch, i, 1, &place) * body->vy;
        }
    }
    return TINKER_OK;
}
