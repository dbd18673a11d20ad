/* Bumper: a one-sided spring and damper. Shorter than its length it pushes with k (L0 - L) - c dL/dt, as long as that
 * pushes; it never pulls.
 *
 * Without damping it stores the energy of its spring. With it, some of that is lost after it has let go, while nothing
 * moves by it: no step of a run would resolve that. So all of its power is booked as its damper's then. */
#include <tinker/sdk.h>

#define PAD 0.6 /* of the plate, what pushes it */

enum { COLUMN_STIFFNESS, COLUMN_DAMPING, COLUMN_LENGTH };

enum { QUANTITY_COMPRESSION, QUANTITY_FORCE, QUANTITY_ENERGY, QUANTITY_POWER };

/* Physics */

static double push_of(double k, double c, double compression, double rate)
{
    const double push = k * compression - c * rate;
    return compression > 0.0 && push > 0.0 ? push : 0.0;
}

static double energy_of(double k, double compression)
{
    return compression > 0.0 ? 0.5 * k * compression * compression : 0.0;
}

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *result)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *c = tinker_column(batch, COLUMN_DAMPING);
    const double *free_length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        result[i] = -push_of(k[i], c[i], free_length[i] - length[i], rate[i]);
    }
    return TINKER_OK;
}

static TinkerStatus derivatives(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *c = tinker_column(batch, COLUMN_DAMPING);
    const double *free_length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const int pushes = push_of(k[i], c[i], free_length[i] - length[i], rate[i]) > 0.0;
        by_length[i] = pushes ? k[i] : 0.0;
        by_rate[i] = pushes ? c[i] : 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus energy(TinkerBatch *batch, const double *length, double *stored)
{
    const double *k = tinker_column(batch, COLUMN_STIFFNESS), *c = tinker_column(batch, COLUMN_DAMPING);
    const double *free_length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        stored[i] = c[i] > 0.0 ? NAN : energy_of(k[i], free_length[i] - length[i]);
    }
    return TINKER_OK;
}

/* Drawing: a coil on the first end, and the plate that the second pushes: a shorter plate, which stands where that end
 * is, in the middle of a mass, so that both meet at the moment at which the force begins. */

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style)
{
    const TinkerEnd *a = &instance->end[0], *b = &instance->end[1];
    const double free_length = instance->columns[COLUMN_LENGTH], half = 0.8 * tinker_instance_symbol_size(instance);
    const double length = tinker_length(b->x - a->x, b->y - a->y);
    const double reach = length < free_length ? length : free_length;
    const double along_x = length > 0.0 ? (b->x - a->x) / length : 1.0;
    const double along_y = length > 0.0 ? (b->y - a->y) / length : 0.0;
    const double x = a->x + reach * along_x, y = a->y + reach * along_y;
    const int32_t colour = length < free_length ? TINKER_COLOUR_COMPRESSED : TINKER_COLOUR_CONNECTOR;
    style->coil(style, cairo, colour, a->x, a->y, x, y, free_length);
    style->line(style, cairo, colour, x + half * along_y, y - half * along_x, x - half * along_y, y + half * along_x);
    if (length > free_length)
        style->line(style, cairo, colour, b->x + PAD * half * along_y, b->y - PAD * half * along_x,
                    b->x - PAD * half * along_y, b->y + PAD * half * along_x);
    tinker_ends_draw_marks(instance, cairo, style);
}

/* Graphs */

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *result)
{
    const double *stiffness = tinker_column(batch, COLUMN_STIFFNESS), *damping = tinker_column(batch, COLUMN_DAMPING);
    const double *free_length = tinker_column(batch, COLUMN_LENGTH);
    for (int32_t i = 0; i < batch->count; i++) {
        const double k = stiffness[i], c = damping[i];
        double length[1], rate[1];
        tinker_end_distances(1, &input->ends[2 * i], length);
        tinker_end_rates(1, &input->ends[2 * i], rate);
        const double compression = free_length[i] - length[0], push = push_of(k, c, compression, rate[0]);
        switch (quantity) {
        case QUANTITY_COMPRESSION:
            result[i] = compression > 0.0 ? compression : 0.0;
            break;
        case QUANTITY_FORCE:
            result[i] = push;
            break;
        case QUANTITY_ENERGY:
            result[i] = energy_of(k, compression);
            break;
        default:
            result[i] = compression > 0.0 ? (k * compression - push) * rate[0] : 0.0;
            break;
        }
    }
    return TINKER_OK;
}

/* Tables */

static const TinkerPropertyType properties[] = {
    {TINKER_REAL_PROPERTY("stiffness", "K", "Bumper", TINKER_DIMENSION_STIFFNESS), TINKER_NOT_NEGATIVE(0, 5000.0),
     .default_value = {1000.0}, .symbol = "k", .variability = TINKER_TUNABLE,
     .description = "Stiffness: force per compression"},
    {TINKER_REAL_PROPERTY("damping", "C", "Bumper", TINKER_DIMENSION_DAMPING), TINKER_NOT_NEGATIVE(0, 100.0),
     .symbol = "c", .variability = TINKER_TUNABLE,
     .description = "Damping: force per rate at which it gets shorter, while it pushes"},
    {TINKER_REAL_PROPERTY("length", "Length", "Bumper", TINKER_DIMENSION_LENGTH),
     TINKER_NOT_NEGATIVE(TINKER_DEFAULT_AS_PLACED, 10.0), .symbol = "L0", .meaning = TINKER_MEANING_LENGTH,
     .variability = TINKER_TUNABLE,
     .description =
         "It pushes while its ends are nearer to each other than this. The end on a mass is in its middle: half of its "
         "width counts in"},
};

static const TinkerLawEquation law[] = {
    TINKER_EQUATION("tension", "if(L < L0, min(k*(L - L0) + c*rate, 0), 0)", NULL, TINKER_DIMENSION_FORCE),
    TINKER_EQUATION("potential", "k*ramp(L0 - L)^2/2", NULL, TINKER_DIMENSION_ENERGY),
};

static const TinkerQuantityType quantities[] = {
    TINKER_QUANTITY(0, "compression", "Compression", "How much shorter it is than its length", TINKER_DIMENSION_LENGTH),
    TINKER_QUANTITY(TINKER_RECORDED, "force", "Force", "Force that pushes the ends apart", TINKER_DIMENSION_FORCE),
    TINKER_QUANTITY(0, "energy", "Stored Energy", "k (L0 - L)^2 / 2 while it is shorter", TINKER_DIMENSION_ENERGY),
    TINKER_QUANTITY(0, "dissipated power", "Dissipated Power", "Power turned into heat", TINKER_DIMENSION_POWER),
};

static const TinkerLineLaw line_law = {.struct_size = sizeof(TinkerLineLaw),
                                       .partly_stores = 1,
                                       .tension = tension,
                                       .derivatives = derivatives,
                                       .energy = energy};
static const TinkerPhysics physics = {.struct_size = sizeof(TinkerPhysics), .line_law = &line_law};
static const TinkerRender render = {sizeof(TinkerRender), 2, draw, tinker_connector_bounds};
static const TinkerEdit edit = {sizeof(TinkerEdit),        0,   tinker_connector_hit, tinker_ends_move,
                                tinker_ends_move_absolute, NULL};
static const TinkerGraph graph = {sizeof(TinkerGraph), 0, values};

static const TinkerUnitChoice unit_choices[] = {{"stiffness", "N/m", "lbf/ft"},
                                                {"damping", "N*s/m", "lbf*s/ft"},
                                                {"energy", "J", "lbf*ft"},
                                                {"dissipated power", "W", "lbf*ft/s"}};
static const TinkerUnits units = {sizeof(TinkerUnits), 0, TINKER_SPAN(unit_choices)};

static const TinkerInterface interfaces[] = {
    {TINKER_PHYSICS_INTERFACE, &physics}, {TINKER_RENDER_INTERFACE, &render}, {TINKER_EDIT_INTERFACE, &edit},
    {TINKER_UNITS_INTERFACE, &units},     {TINKER_GRAPH_INTERFACE, &graph},
};

static const TinkerBlockType blocks[] = {
    {TINKER_BLOCK("bumper", "Bumper", TINKER_CONNECTOR),
     .summary = "A spring that bodies run into, a buffer: pushes its ends apart while they are nearer than its length, "
                "and never pulls",
     .least_ends = 2, .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT,
     .properties = TINKER_SPAN(properties), .quantities = TINKER_SPAN(quantities),
     .interfaces = TINKER_SPAN(interfaces), .law = TINKER_SPAN(law)},
};

TINKER_DEFINE_PLUGIN("org.tinker.bumper", "Bumper", "0.1.0", "MIT", blocks)
