/* A connector whose law is typed: its tension, or the potential whose slope that is. */
#include <tinker/sdk.h>

enum { FORMULA_TENSION, FORMULA_POTENTIAL };
enum { BY_LENGTH, BY_RATE };
enum { QUANTITY_LENGTH, QUANTITY_TENSION, QUANTITY_ENERGY };

static const TinkerLineLaw line_law;
static const TinkerPhysics physics;

static const char *const of_tension[] = {"L", "rate", "t"};
static const char *const of_potential[] = {"L"};

static const TinkerPropertyType properties[] = {
    {TINKER_TYPED_PROPERTY("tension", "Tension", of_tension, TINKER_DIMENSION_FORCE), .symbol = "T",
     .description = "Force that pulls its ends together, of L, rate and t: k*(L - 1)^3"},
    {TINKER_TYPED_PROPERTY("potential", "Potential", of_potential, TINKER_DIMENSION_ENERGY), .symbol = "V",
     .description = "Instead of a tension: the energy that it stores, of L"},
    TINKER_TYPED_PARAMETERS,
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "length", "Length", "Distance between the ends", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "tension", "Tension", "Force that pulls the ends together",
                    TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "By its potential, or by what its tension stores",
                    TINKER_DIMENSION_ENERGY),
};

/* Drawing */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    style->line(style, cairo, TINKER_COLOUR_CONNECTOR, a->x, a->y, b->x, b->y);
    style->circle(style, cairo, TINKER_COLOUR_SUPPORT, TINKER_COLOUR_CONNECTOR, instance->x, instance->y,
                  0.25 * style->symbol_size);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Tables */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result);

static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};
static const TinkerUnitChoice unit_choices[] = {{"length", "m", "ft"}, {"tension", "N", "lbf"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("law-connector", "Typed Connector", TINKER_CONNECTOR),
     .summary = "Pulls its ends together by a law that is typed", .least_ends = 2, .most_ends = 2,
     .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_TYPED_PLUGIN("org.tinker.law-connector", "Typed Connector", "0.1.0", "MIT", blocks)

/* Physics */

static double tension_of(const TinkerBatch *batch, int32_t i, double length, double rate)
{
    const double at[] = {length, rate, batch->time};
    const TinkerTypedLaw *given = tinker_typed(batch, i, FORMULA_TENSION);
    return given != NULL ? tinker_typed_laws->value(given, at)
                         : tinker_typed_laws->slope(tinker_typed(batch, i, FORMULA_POTENTIAL), BY_LENGTH, at);
}

static void derivatives_of(const TinkerBatch *batch, double length, double rate, double *by_length, double *by_rate)
{
    const double at[] = {length, rate, batch->time};
    const TinkerTypedLaw *given = tinker_typed(batch, 0, FORMULA_TENSION),
                         *potential = tinker_typed(batch, 0, FORMULA_POTENTIAL);
    *by_length = given != NULL ? tinker_typed_laws->slope(given, BY_LENGTH, at)
                               : tinker_typed_laws->curvature(potential, BY_LENGTH, BY_LENGTH, at);
    *by_rate = given != NULL ? tinker_typed_laws->slope(given, BY_RATE, at) : 0.0;
}

/* Whether any of them has this law. Mostly all have the same one, which the first tells of; that none has it is found
 * without a branch for each, as a question to none would take as long as one that is answered. */
static int any_has(const TinkerBatch *batch, int32_t number)
{
    const TinkerTypedLaw *const *law = batch->laws + number;
    uintptr_t any = (uintptr_t)*law;
    if (any != 0) return 1;
    for (int32_t i = 1; i < batch->count; i++)
        any |= (uintptr_t)law[i * batch->law_count];
    return any != 0;
}

/* Each connector has one of both laws, and the service passes those over that have not the one that is asked for. */
static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    if (batch->count == 1) {
        result[0] = tension_of(batch, 0, length[0], rate[0]);
        return TINKER_OK;
    }
    if (any_has(batch, FORMULA_TENSION)) {
        const double *const arguments[] = {length, rate, NULL}, uniform[] = {0.0, 0.0, batch->time};
        const TinkerTypedQuestion given = tinker_typed_question(batch, FORMULA_TENSION, arguments, uniform);
        tinker_typed_laws->values(&given, result);
    }
    if (any_has(batch, FORMULA_POTENTIAL)) {
        const TinkerTypedQuestion potential = tinker_typed_question(batch, FORMULA_POTENTIAL, &length, NULL);
        tinker_typed_laws->slopes(&potential, BY_LENGTH, result);
    }
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    if (batch->count == 1) {
        derivatives_of(batch, length[0], rate[0], by_length, by_rate);
        return TINKER_OK;
    }
    if (any_has(batch, FORMULA_POTENTIAL)) {
        const TinkerTypedQuestion potential = tinker_typed_question(batch, FORMULA_POTENTIAL, &length, NULL);
        for (int32_t i = 0; i < batch->count; i++)
            by_rate[i] = 0.0;
        tinker_typed_laws->curvatures(&potential, BY_LENGTH, BY_LENGTH, by_length);
    }
    if (any_has(batch, FORMULA_TENSION)) {
        const double *const arguments[] = {length, rate, NULL}, uniform[] = {0.0, 0.0, batch->time};
        const TinkerTypedQuestion given = tinker_typed_question(batch, FORMULA_TENSION, arguments, uniform);
        tinker_typed_laws->slopes(&given, BY_LENGTH, by_length);
        tinker_typed_laws->slopes(&given, BY_RATE, by_rate);
    }
    return TINKER_OK;
}

/* By its potential, or what its tension stores. NAN: none that is known. */
static double energy_of(const TinkerBatch *batch, int32_t i, double length)
{
    const double at[] = {length, 0.0, batch->time};
    const TinkerTypedLaw *potential = tinker_typed(batch, i, FORMULA_POTENTIAL);
    return potential != NULL ? tinker_typed_laws->value(potential, at)
                             : tinker_typed_laws->energy(tinker_typed(batch, i, FORMULA_TENSION), at);
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    if (batch->count == 1) {
        stored[0] = energy_of(batch, 0, length[0]);
        return TINKER_OK;
    }
    const TinkerTypedQuestion potential = tinker_typed_question(batch, FORMULA_POTENTIAL, &length, NULL);
    tinker_typed_laws->values(&potential, stored);
    for (int32_t i = 0; i < batch->count; i++)
        if (tinker_typed(batch, i, FORMULA_POTENTIAL) == NULL) stored[i] = energy_of(batch, i, length[i]);
    return TINKER_OK;
}

static TinkerStatus prepare(TinkerBatch *batch)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const int tensions = tinker_typed(batch, i, FORMULA_TENSION) != NULL,
                  potentials = tinker_typed(batch, i, FORMULA_POTENTIAL) != NULL;
        if (tensions && potentials)
            return tinker_fail(batch, i,
                               "it has a tension and a potential; the potential's slope is the tension: give one");
        if (!tensions && !potentials)
            return tinker_fail(batch, i, "it has no law; give a tension of L, rate and t, or a potential of L");
    }
    return TINKER_OK;
}

static const TinkerLineLaw line_law = {.struct_size = sizeof(TinkerLineLaw),
                                       .partly_stores = 1,
                                       .tension = tension,
                                       .derivatives = derivatives,
                                       .energy = energy};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law, .prepare = prepare};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    tinker_end_distances(batch->count, input->ends, result);
    if (quantity == QUANTITY_LENGTH) return TINKER_OK;
    if (batch->laws == NULL) return tinker_fail(batch, 0, "its law is not known before a run");
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerPoint *a = &input->ends[2 * i], *b = a + 1;
        const double length = result[i];
        const double along = (b->x - a->x) * (b->vx - a->vx) + (b->y - a->y) * (b->vy - a->vy);
        const double rate = length > 0.0 ? along / length : 0.0;
        const double stored = quantity == QUANTITY_ENERGY ? energy_of(batch, i, length) : 0.0;
        if (quantity == QUANTITY_TENSION)
            result[i] = tension_of(batch, i, length, rate);
        else
            result[i] = stored == stored ? stored : 0.0;
    }
    return TINKER_OK;
}
