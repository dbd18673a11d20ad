/* Descriptors of plugins in memory, made by a list of choices, one byte each. Where the bytes run out every choice is
 * the proper one, so no byte at all makes a descriptor that passes. Spans have the memory that they claim and not a
 * byte more, as long as what they claim could be allowed. A pointer that leads nowhere cannot be told from a good one,
 * so there is none. */
#include <math.h>
#include <string.h>

#include "fuzz-target.h"
#include "plugin/call/library.h"

typedef struct {
    const uint8_t *data;
    size_t size, at;
    GPtrArray *memory; /* of the descriptor */
} Maker;

/* 0 to choices - 1; 0 behind the last byte. */
static int choose(Maker *maker, int choices)
{
    return maker->at < maker->size ? maker->data[maker->at++] % choices : 0;
}

static gpointer allot(Maker *maker, gsize size)
{
    gpointer memory = g_malloc0(size);
    g_ptr_array_add(maker->memory, memory);
    return memory;
}

/* Numbers ---------------------------------------------------------------------------------------------------------- */

static double number(Maker *maker, double proper)
{
    static const double others[] = {0, 1, -1, 0.5, 1e308, -1e308};
    const int choice = choose(maker, 10);
    if (choice == 0) return proper;
    if (choice == 7) return (double)NAN;
    if (choice >= 8) return choice == 8 ? (double)INFINITY : -(double)INFINITY;
    return others[choice - 1];
}

static int32_t whole(Maker *maker, int32_t proper)
{
    static const int32_t others[] = {0, 1, 2, 3, 5, 6, 7, 14, 15, -1, -2, G_MAXINT32, G_MININT32};
    const int choice = choose(maker, (int)G_N_ELEMENTS(others) + 1);
    return choice == 0 ? proper : others[choice - 1];
}

static TinkerDimension dimension(Maker *maker, TinkerDimension proper)
{
    switch (choose(maker, 4)) {
    case 0:
        return proper;
    case 1:
        return (TinkerDimension){127, -128, 127, -128};
    case 2:
        return (TinkerDimension){.length = 1};
    default:
        return (TinkerDimension){.angle = 1};
    }
}

/* Texts ------------------------------------------------------------------------------------------------------------ */

static const char *text(Maker *maker, const char *proper)
{
    static const char *const others[] = {
        NULL,   "",     " ",    "\xff\xfe", "two\nlines", "\x01",      "../up", "a.b,c", "mass",   "position",
        "id 0", "ends", "sine", "cosine",   "\xc3\xa4",   "connector", "m",     "kg",    "lbf/ft", "tinker.log/1"};
    const int choice = choose(maker, (int)G_N_ELEMENTS(others) + 2);
    if (choice == 0) return proper;
    if (choice <= (int)G_N_ELEMENTS(others)) return others[choice - 1];
    char *longest = allot(maker, 5000);
    memset(longest, 'x', 4999);
    return longest;
}

static const char *numbered(Maker *maker, const char *stem, int32_t i)
{
    char *proper = allot(maker, 32);
    g_snprintf(proper, 32, "%s %d", stem, i);
    return text(maker, proper);
}

/* Structs and spans ------------------------------------------------------------------------------------------------ */

/* The bytes that a struct of `size` is given: those of this host, or of an older or a newer one. */
static gsize declared(Maker *maker, gsize size)
{
    switch (choose(maker, 6)) {
    case 1:
        return 8;
    case 2:
        return size - 8;
    case 3:
        return size + 8;
    case 4:
        return size - 3;
    case 5:
        return 65536;
    default:
        return size;
    }
}

/* A struct_size that may be a lie, for `size` bytes: beyond what is allowed where it says more. */
static uint32_t struct_size(Maker *maker, gsize size)
{
    switch (choose(maker, 5)) {
    case 1:
        return 0;
    case 2:
        return 65537;
    case 3:
        return G_MAXUINT32;
    default:
        return (uint32_t)size;
    }
}

/* A copy of a struct that begins with struct_size, in memory of the size it declares. */
static const void *placed(Maker *maker, const void *own, gsize size)
{
    const gsize bytes = declared(maker, size);
    const uint32_t says = struct_size(maker, bytes);
    char *memory = allot(maker, bytes);
    memcpy(memory, own, MIN(size, bytes));
    memcpy(memory, &says, sizeof says);
    return memory;
}

/* A span over copies of `count` structs. */
static TinkerSpan span_of(Maker *maker, const void *own, int32_t count, gsize size, gboolean sized)
{
    const gsize stride = declared(maker, size);
    char *memory = allot(maker, MAX((gsize)count * stride, 1));
    for (int32_t i = 0; i < count; i++) {
        char *element = memory + (gsize)i * stride;
        memcpy(element, (const char *)own + (gsize)i * size, MIN(size, stride));
        const uint32_t says = sized ? struct_size(maker, stride) : 0;
        if (sized) memcpy(element, &says, sizeof says);
    }
    TinkerSpan span = {memory, count, (int32_t)stride};
    switch (choose(maker, 10)) {
    case 1:
        span.data = NULL;
        break;
    case 2:
        span.count = -1;
        break;
    case 3:
        span.count = 10001;
        break;
    case 4:
        span.count = G_MAXINT32;
        break;
    case 5:
        span.stride = -8;
        break;
    case 6:
        span.stride = 0;
        break;
    case 7:
        span.stride = G_MININT32;
        break;
    case 8:
        span.stride = 65544;
        break;
    case 9:
        span.data = memory + 1;
        break;
    default:
        break;
    }
    return span;
}

/* Functions are never called by the checks: any one will do, or none. */
static void nothing(void) {}

#define FUNCTION(maker, target)                                                                                        \
    do {                                                                                                               \
        void (*function_)(void) = choose((maker), 8) == 1 ? NULL : nothing;                                            \
        memcpy(&(target), &function_, sizeof function_);                                                               \
    } while (0)

/* What a block declares -------------------------------------------------------------------------------------------- */

/* The proper ones: the place and mass of a body, then one of each kind. */
static TinkerPropertyType property(Maker *maker, int32_t i)
{
    static const int32_t kinds[] = {TINKER_KIND_VECTOR, TINKER_KIND_REAL, TINKER_KIND_INTEGER, TINKER_KIND_SWITCH,
                                    TINKER_KIND_CHOICE, TINKER_KIND_TEXT, TINKER_KIND_WAVEFORM};
    static const int32_t meanings[] = {TINKER_MEANING_POSITION, TINKER_MEANING_MASS};
    static const TinkerDimension dimensions[] = {{.length = 1}, {.mass = 1}};
    static const char *const choices[] = {"one", "two", NULL, "\xff"};
    const gboolean named = i < 2;
    TinkerPropertyType type = {
        .kind = whole(maker, kinds[i % (int32_t)G_N_ELEMENTS(kinds)]),
        .id = numbered(maker, "id", i),
        .title = text(maker, "Title"),
        .group = text(maker, NULL),
        .symbol = text(maker, NULL),
        .description = text(maker, "What it is."),
        .dimension = dimension(maker, named ? dimensions[i] : (TinkerDimension){0}),
        .flags = choose(maker, 4) == 1 ? (uint32_t)choose(maker, 256) << choose(maker, 8) : 0,
        .meaning = whole(maker, named ? meanings[i] : TINKER_MEANING_NONE),
        .variability = whole(maker, TINKER_STRUCTURAL),
        .panel = whole(maker, -1),
        .choice_count = whole(maker, kinds[i % (int32_t)G_N_ELEMENTS(kinds)] == TINKER_KIND_CHOICE ? 2 : 0),
        .default_value = {number(maker, 1), number(maker, 0)},
        .hard_minimum = number(maker, 0),
        .hard_maximum = number(maker, 2),
        .soft_minimum = number(maker, 0),
        .soft_maximum = number(maker, 1),
        .default_text = text(maker, NULL),
        .default_from = text(maker, NULL),
        .component_titles = {text(maker, "X"), text(maker, "Y")},
        .amplitude = text(maker, NULL),
        .frequency = text(maker, NULL),
        .phase = text(maker, NULL),
    };
    // As many choices as are counted: a span has a length, this has none.
    const int32_t most = (int32_t)G_N_ELEMENTS(choices) - (choose(maker, 4) == 1 ? 0 : 2);
    if (type.choice_count <= most || type.choice_count > 1000) type.choices = choose(maker, 8) == 1 ? NULL : choices;
    return type;
}

static TinkerSpan properties(Maker *maker)
{
    TinkerPropertyType types[7];
    const int32_t count = 7 - choose(maker, 8);
    for (int32_t i = 0; i < count; i++)
        types[i] = property(maker, i);
    return span_of(maker, types, count, sizeof types[0], TRUE);
}

static TinkerSpan quantities(Maker *maker)
{
    TinkerQuantityType types[2];
    const int32_t count = 2 - choose(maker, 3);
    for (int32_t i = 0; i < count; i++)
        types[i] = (TinkerQuantityType){
            .id = numbered(maker, "quantity", i),
            .title = text(maker, "Quantity"),
            .description = text(maker, NULL),
            .dimension = dimension(maker, (TinkerDimension){.length = 1}),
        };
    return span_of(maker, types, count, sizeof types[0], TRUE);
}

/* Interfaces ------------------------------------------------------------------------------------------------------- */

static const void *body(Maker *maker)
{
    const TinkerBody own = {.degrees_of_freedom = whole(maker, 2), .shape = whole(maker, TINKER_SHAPE_BOX)};
    return placed(maker, &own, sizeof own);
}

static const void *physics(Maker *maker)
{
    TinkerPhysics own = {.scratch_size = whole(maker, 0)};
    TinkerLineLaw line_law = {0};
    TinkerForceElement force_element = {0};
    TinkerField field = {0};
    TinkerConstraint constraint = {0};
    TinkerMotion motion = {0};
    const int role = choose(maker, 7);
    FUNCTION(maker, line_law.tension);
    FUNCTION(maker, force_element.force);
    FUNCTION(maker, field.force);
    FUNCTION(maker, constraint.rows_at);
    FUNCTION(maker, motion.motion);
    constraint.rows = whole(maker, 1);
    if (choose(maker, 8) != 1) own.body = body(maker);
    if (role == 1 || role == 6) own.line_law = placed(maker, &line_law, sizeof line_law);
    if (role == 2) own.force_element = placed(maker, &force_element, sizeof force_element);
    if (role == 3) own.field = placed(maker, &field, sizeof field);
    if (role == 4) own.constraint = placed(maker, &constraint, sizeof constraint);
    if (role == 5 || role == 6) own.motion = placed(maker, &motion, sizeof motion);
    return placed(maker, &own, sizeof own);
}

static const void *units(Maker *maker)
{
    TinkerUnitChoice choices[2];
    for (int32_t i = 0; i < 2; i++)
        choices[i] = (TinkerUnitChoice){numbered(maker, "id", i), text(maker, NULL), text(maker, NULL)};
    TinkerUnits own = {.choices = span_of(maker, choices, 2, sizeof choices[0], FALSE)};
    return placed(maker, &own, sizeof own);
}

static TinkerSpan interfaces(Maker *maker)
{
    TinkerRender render = {0};
    TinkerEdit edit = {0};
    TinkerGraph graph = {0};
    FUNCTION(maker, render.draw);
    FUNCTION(maker, edit.hit);
    FUNCTION(maker, edit.move);
    FUNCTION(maker, edit.move_absolute);
    FUNCTION(maker, graph.values);
    TinkerInterface list[] = {
        {text(maker, TINKER_PHYSICS_INTERFACE), physics(maker)},
        {text(maker, TINKER_UNITS_INTERFACE), units(maker)},
        {text(maker, TINKER_RENDER_INTERFACE), placed(maker, &render, sizeof render)},
        {text(maker, TINKER_EDIT_INTERFACE), placed(maker, &edit, sizeof edit)},
        {text(maker, TINKER_GRAPH_INTERFACE), placed(maker, &graph, sizeof graph)},
    };
    const int without = choose(maker, 8);
    if (without >= 3) list[without - 3].vtable = NULL;
    if (without == 1) list[4] = list[0];
    return span_of(maker, list, (int32_t)G_N_ELEMENTS(list), sizeof list[0], FALSE);
}

/* The descriptor --------------------------------------------------------------------------------------------------- */

static TinkerSpan blocks(Maker *maker)
{
    TinkerBlockType types[2];
    const int32_t count = 1 + choose(maker, 2);
    for (int32_t i = 0; i < count; i++)
        types[i] = (TinkerBlockType){
            .schema_version = whole(maker, 1),
            .id = numbered(maker, "block", i),
            .title = text(maker, "Block"),
            .category = text(maker, TINKER_CONNECTABLE),
            .summary = text(maker, NULL),
            .icon_path = text(maker, NULL),
            .help_link = text(maker, NULL),
            .least_ends = whole(maker, 0),
            .most_ends = whole(maker, 0),
            .end_accepts = (uint32_t)whole(maker, 3),
            .properties = properties(maker),
            .quantities = quantities(maker),
            .interfaces = interfaces(maker),
        };
    return span_of(maker, types, count, sizeof types[0], TRUE);
}

static TinkerSpan integrators(Maker *maker)
{
    TinkerIntegrator integrator = {.id = text(maker, "method"), .title = text(maker, "Method")};
    FUNCTION(maker, integrator.create);
    FUNCTION(maker, integrator.destroy);
    FUNCTION(maker, integrator.restart);
    FUNCTION(maker, integrator.step);
    FUNCTION(maker, integrator.interpolate);
    return span_of(maker, &integrator, 1 - choose(maker, 2), sizeof integrator, TRUE);
}

static TinkerStatus start(const TinkerHost *host)
{
    return host->service(host, TINKER_LOG_SERVICE) != NULL ? TINKER_OK : TINKER_FAILED;
}

static const TinkerPlugin *plugin(Maker *maker)
{
    const char *service = text(maker, TINKER_LOG_SERVICE);
    const TinkerPlugin own = {
        .magic = choose(maker, 32) == 1 ? 0 : TINKER_MAGIC,
        .abi_minor = whole(maker, TINKER_ABI_MINOR),
        .least_host_minor = whole(maker, 0),
        .size_of_double = whole(maker, (int32_t)sizeof(double)),
        .size_of_index = whole(maker, (int32_t)sizeof(int32_t)),
        .id = text(maker, "org.tinker.fuzz"),
        .title = text(maker, "Fuzz"),
        .version = text(maker, "1"),
        .licence = text(maker, "MIT"),
        .home_page = text(maker, NULL),
        .services = span_of(maker, &service, 1, sizeof service, FALSE),
        .integrators = integrators(maker),
        .blocks = blocks(maker),
        .init = choose(maker, 4) == 1 ? NULL : start,
    };
    // The magic number comes first, then struct_size.
    const gsize bytes = MAX(declared(maker, sizeof own), 8);
    const uint32_t says = struct_size(maker, bytes);
    char *memory = allot(maker, bytes);
    memcpy(memory, &own, MIN(sizeof own, bytes));
    memcpy(memory + offsetof(TinkerPlugin, struct_size), &says, sizeof says);
    return (const void *)memory;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Maker maker = {.data = data, .size = size, .memory = g_ptr_array_new_with_free_func(g_free)};
    g_autoptr(GError) error = NULL;
    const gboolean passed = tinker_library_check_descriptor(plugin(&maker), &error);
    if (passed != (error == NULL)) g_error("a refusal without a reason, or the other way round");
    if (error != NULL && !g_utf8_validate(error->message, -1, NULL)) g_error("the message is not UTF-8");
    if (size == 0 && !passed) g_error("the proper descriptor is refused: %s", error->message);
    g_ptr_array_unref(maker.memory);
    return 0;
}
