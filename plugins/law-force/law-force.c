/* A force on one body whose law is typed: its components, or the potential of which it is minus the gradient. */
#include <tinker/sdk.h>

enum { QUANTITY_FORCE_X, QUANTITY_FORCE_Y };

static const TinkerPhysics physics;
static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result);

static const TinkerPropertyType properties[] = {TINKER_TYPED_FORCES};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(TINKER_RECORDED, "force x", "X Force", "Horizontal force on the body", TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(TINKER_RECORDED, "force y", "Y Force", "Vertical force on the body", TINKER_DIMENSION_FORCE),
};

/* Drawing */

static TinkerArrow arrow_of(const TinkerInstance *instance, double symbol_size)
{
    static const double up[] = {0.0, 1.0};
    return tinker_arrow_from(instance->end[0].x, instance->end[0].y, up, 3.0 * symbol_size);
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    style->arrow(style, cairo, TINKER_COLOUR_FORCE, arrow.x1, arrow.y1, arrow.x2, arrow.y2);
    style->text(style, cairo, TINKER_COLOUR_FORCE, arrow.x2 + 0.7 * style->symbol_size, arrow.y2, "F");
    tinker_ends_draw_marks(instance, cairo, style);
}

static void bounds(const TinkerInstance *instance, const TinkerStyle *style, double box[4])
{
    const TinkerArrow arrow = arrow_of(instance, style->symbol_size);
    tinker_arrow_bounds(&arrow, style->symbol_size + tinker_drawing_margin(style), box);
}

/* Editing */

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    const TinkerArrow arrow = arrow_of(instance, tinker_instance_symbol_size(instance));
    const int32_t part = tinker_ends_hit(instance, x, y, reach);
    if (part != TINKER_PART_NONE) return part;
    return tinker_arrow_is_hit(&arrow, x, y, reach) ? TINKER_PART_WHOLE : TINKER_PART_NONE;
}

/* Tables */

static const TinkerRender render = {sizeof(TinkerRender), 3, draw, bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit), 0, hit, tinker_ends_move, tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};
static const TinkerUnitChoice unit_choices[] = {{"force x", "N", "lbf"}, {"force y", "N", "lbf"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("law-force", "Typed Force", TINKER_FORCE), .summary = "A force on one body by a law that is typed",
     .least_ends = 1, .most_ends = 1, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(properties),
     .quantities = TINKER_SPAN(quantities), .interfaces = TINKER_SPAN(interfaces)},
};

TINKER_DEFINE_TYPED_PLUGIN("org.tinker.law-force", "Typed Force", "0.1.0", "MIT", blocks)

/* Physics */

static TinkerTypedLawPlace place_of(const TinkerBatch *batch, const TinkerPoint *ends, int32_t i)
{
    return tinker_typed_place(batch, &ends[i], batch->end_masses != NULL ? batch->end_masses[i] : 0.0);
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    tinker_typed_forces(tinker_typed_laws, batch, 0, 1, batch->count, ends, batch->end_masses, result);
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const TinkerPoint *ends, double *stored)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const TinkerTypedLawPlace place = place_of(batch, ends, i);
        stored[i] = tinker_typed_energy(tinker_typed_laws, batch, i, &place);
    }
    return TINKER_OK;
}

static const TinkerForceElement force_element = {
    .struct_size = sizeof(TinkerForceElement), .force = force, .energy = energy};
static const TinkerPhysics physics = {
    .struct_size = sizeof(TinkerPhysics), .force_element = &force_element, .prepare = tinker_typed_prepare};

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    if (input->forces == NULL) return tinker_fail(batch, 0, "its law is not known before a run");
    for (int32_t i = 0; i < batch->count; i++)
        result[i] = input->forces[2 * i + (quantity == QUANTITY_FORCE_X ? 0 : 1)];
    return TINKER_OK;
}
