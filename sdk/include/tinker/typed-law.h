/* Tinker SDK: laws that the user types.
 *
 * A text property with TINKER_TEXT_LAW holds an expression (docs/reference/expressions.md). Its `choices` name its
 * arguments ("L", "rate", "t"); besides, it may name the block's properties with TINKER_TEXT_QUANTITY by their ids,
 * which stand for their numbers in SI. The host reads it, compiles it with its exact derivatives and hands it to every
 * call in TinkerBatch.laws; the plugin works it out by this service, which needs no memory and may be used on any
 * thread:
 *
 *     static const TinkerTypedLawService *service;
 *     static TinkerStatus init(const TinkerHost *host)
 *     {
 *         service = host->service(host, TINKER_TYPED_SERVICE);
 *         return service != NULL ? TINKER_OK : TINKER_FAILED;
 *     }
 *
 * A text that cannot be read is an error of the scene before any call.
 *
 * Some names of arguments are reserved, as the host knows what they are and looks along each step whether a law did
 * something in it that the method passed over, as a short pulse or a thin wall. In a law that is a force or an energy
 * of a block with one or two ends, or of a field, they mean the same in all plugins, in SI:
 *
 *     x, y       the place of the end, or of the body that a field acts on, in the world; of two ends, that of the
 *                second as seen from the first
 *     vx, vy     its velocity
 *     L, rate    the distance of two ends, and how fast it grows
 *     t          the time
 *     m          the mass of the body
 *
 * A law that names any other argument is worked out all the same, and not looked at in this way. */
#ifndef TINKER_TYPED_LAW_H
#define TINKER_TYPED_LAW_H

#include "declare.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_TYPED_SERVICE "tinker.typed-laws/1"

typedef struct TinkerTypedLaw TinkerTypedLaw;

#define TINKER_TYPED_MOST_ARGUMENTS 16

/* A question to the laws of many instances at once, which is much faster than one by one. */
typedef struct TinkerTypedQuestion {
    const TinkerTypedLaw *const *laws; /* that of instance i is laws[i * stride]; one that is NULL is passed over */
    int32_t stride;                    /* 0: all have one law */
    int32_t count;                     /* of instances */
    const double *const *arguments;    /* argument k of instance i is arguments[k][i]; where arguments[k] is NULL ... */
    const double *uniform;             /* ... it is uniform[k] of all; NULL where there is none such */
} TinkerTypedQuestion;

/* `arguments` are as many as the property names, in their order. What switches has the slope of the piece it is in. */
typedef struct TinkerTypedLawService {
    uint32_t struct_size;
    int32_t reserved;
    double (*value)(const TinkerTypedLaw *formula, const double *arguments);
    double (*slope)(const TinkerTypedLaw *formula, int32_t by, const double *arguments);
    double (*curvature)(const TinkerTypedLaw *formula, int32_t by, int32_t and_by, const double *arguments);
    /* The same of many, to the same bits; `results` is by instance, and overlaps no argument. */
    void (*values)(const TinkerTypedQuestion *question, double *results);
    void (*slopes)(const TinkerTypedQuestion *question, int32_t by, double *results);
    void (*curvatures)(const TinkerTypedQuestion *question, int32_t by, int32_t and_by, double *results);
    /* The energy that a tension or force stores by what it is at rest, over the law's own arguments; of two forces the
     * one that is given first knows that of both. NAN: none that is known, as of what depends on t. */
    double (*energy)(const TinkerTypedLaw *formula, const double *arguments);
} TinkerTypedLawService;

/* The formula of an instance; NULL where its text is empty. */
static inline const TinkerTypedLaw *tinker_typed(const TinkerBatch *batch, int32_t instance, int32_t number)
{
    return batch->laws != 0 ? batch->laws[instance * batch->law_count + number] : 0;
}

/* The laws with this number of all instances, over these arguments; `uniform` may be NULL. */
static inline TinkerTypedQuestion tinker_typed_question(const TinkerBatch *batch, int32_t number,
                                                        const double *const *arguments, const double *uniform)
{
    const TinkerTypedQuestion question = {batch->laws + number, batch->law_count, batch->count, arguments, uniform};
    return question;
}

/* A typed law over the arguments `names_`, a static array. */
#define TINKER_TYPED_PROPERTY(id_, title_, names_, ...)                                                                \
    TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_TEXT, id_, title_, "Law", __VA_ARGS__),                                   \
        .flags = TINKER_TEXT_LAW, .default_text = "", .choices = (names_),                                             \
        .choice_count = (int32_t)(sizeof(names_) / sizeof((names_)[0])), .variability = TINKER_STRUCTURAL

/* A number of a typed law. */
#define TINKER_TYPED_PARAMETER(id_)                                                                                    \
    {                                                                                                                  \
        TINKER_PROPERTY_IN_PANEL(-1, TINKER_KIND_TEXT, id_, id_, "Numbers", {0, 0, 0, 0}),                             \
            .flags = TINKER_TEXT_QUANTITY, .default_text = "", .variability = TINKER_STRUCTURAL,                       \
            .description = "A number that the law names, with any unit"                                                \
    }
#define TINKER_TYPED_PARAMETERS                                                                                        \
    TINKER_TYPED_PARAMETER("a"), TINKER_TYPED_PARAMETER("b"), TINKER_TYPED_PARAMETER("c"),                             \
        TINKER_TYPED_PARAMETER("d"), TINKER_TYPED_PARAMETER("e"), TINKER_TYPED_PARAMETER("f"),                         \
        TINKER_TYPED_PARAMETER("g"), TINKER_TYPED_PARAMETER("h")

/* A law at a point: the first three laws of a block are force_x and force_y over x, y, vx, vy, t and m, and the
 * potential over x, y, t and m, which is given instead of both. */
enum { TINKER_TYPED_FORCE_X, TINKER_TYPED_FORCE_Y, TINKER_TYPED_POTENTIAL };

/* The arguments of both, places in the world. */
typedef struct TinkerTypedLawPlace {
    double of_force[6], of_potential[4];
} TinkerTypedLawPlace;

static inline TinkerTypedLawPlace tinker_typed_place(const TinkerBatch *batch, const TinkerPoint *point, double mass)
{
    const double x = point->x + batch->origin[0], y = point->y + batch->origin[1], t = batch->time;
    TinkerTypedLawPlace place = {{x, y, point->vx, point->vy, t, mass}, {x, y, t, mass}};
    return place;
}

static inline double tinker_typed_force(const TinkerTypedLawService *service, const TinkerBatch *batch,
                                        int32_t instance, int32_t axis, const TinkerTypedLawPlace *place)
{
    const TinkerTypedLaw *force = tinker_typed(batch, instance, TINKER_TYPED_FORCE_X + axis);
    const TinkerTypedLaw *potential = tinker_typed(batch, instance, TINKER_TYPED_POTENTIAL);
    if (potential != NULL) return -service->slope(potential, axis, place->of_potential);
    return force != NULL ? service->value(force, place->of_force) : 0.0;
}

#define TINKER_TYPED_CHUNK 64

/* The forces (x and y by turns) at up to TINKER_TYPED_CHUNK places, in one question a law: of place k those of the
 * instance `instance` + k * `each`, so that with 0 all are of one. `masses` may be NULL: 0. */
static inline void tinker_typed_ask_forces(const TinkerTypedLawService *service, const TinkerBatch *batch,
                                           int32_t instance, int32_t each, int32_t count, const TinkerPoint *points,
                                           const double *masses, double *result)
{
    double x[TINKER_TYPED_CHUNK], y[TINKER_TYPED_CHUNK], vx[TINKER_TYPED_CHUNK], vy[TINKER_TYPED_CHUNK];
    double answer[TINKER_TYPED_CHUNK];
    const double *const of_force[6] = {x, y, vx, vy, NULL, masses}, *const of_potential[4] = {x, y, NULL, masses};
    const double uniform_force[6] = {0.0, 0.0, 0.0, 0.0, batch->time, 0.0};
    const double uniform_potential[4] = {0.0, 0.0, batch->time, 0.0};
    const TinkerTypedLaw *const *laws = batch->laws + instance * batch->law_count;
    const int32_t stride = each * batch->law_count;
    for (int32_t k = 0; k < count; k++) {
        x[k] = points[k].x + batch->origin[0];
        y[k] = points[k].y + batch->origin[1];
        vx[k] = points[k].vx;
        vy[k] = points[k].vy;
    }
    for (int32_t axis = 0; axis < 2; axis++) {
        const TinkerTypedQuestion force = {laws + TINKER_TYPED_FORCE_X + axis, stride, count, of_force, uniform_force};
        const TinkerTypedQuestion potential = {laws + TINKER_TYPED_POTENTIAL, stride, count, of_potential,
                                               uniform_potential};
        for (int32_t k = 0; k < count; k++)
            answer[k] = 0.0;
        service->values(&force, answer);
        service->slopes(&potential, axis, answer);
        for (int32_t k = 0; k < count; k++)
            result[2 * k + axis] = laws[k * stride + TINKER_TYPED_POTENTIAL] != NULL ? -answer[k] : answer[k];
    }
}

/* The forces at any number of places; see above. Few are asked one by one, which is faster. */
static inline void tinker_typed_forces(const TinkerTypedLawService *service, const TinkerBatch *batch, int32_t instance,
                                       int32_t each, int32_t count, const TinkerPoint *points, const double *masses,
                                       double *result)
{
    for (int32_t first = 0; count >= 8 && first < count; first += TINKER_TYPED_CHUNK) {
        const int32_t left = count - first, chunk = left < TINKER_TYPED_CHUNK ? left : TINKER_TYPED_CHUNK;
        tinker_typed_ask_forces(service, batch, instance + first * each, each, chunk, points + first,
                                masses != NULL ? masses + first : NULL, result + 2 * first);
    }
    for (int32_t k = 0; count < 8 && k < count; k++) {
        const TinkerTypedLawPlace place = tinker_typed_place(batch, &points[k], masses != NULL ? masses[k] : 0.0);
        for (int32_t axis = 0; axis < 2; axis++)
            result[2 * k + axis] = tinker_typed_force(service, batch, instance + k * each, axis, &place);
    }
}

/* The derivative of a force by x, y, vx or vy (0 to 3). */
static inline double tinker_typed_force_slope(const TinkerTypedLawService *service, const TinkerBatch *batch,
                                              int32_t instance, int32_t axis, int32_t by,
                                              const TinkerTypedLawPlace *place)
{
    const TinkerTypedLaw *force = tinker_typed(batch, instance, TINKER_TYPED_FORCE_X + axis);
    const TinkerTypedLaw *potential = tinker_typed(batch, instance, TINKER_TYPED_POTENTIAL);
    if (potential != NULL) return by < 2 ? -service->curvature(potential, axis, by, place->of_potential) : 0.0;
    return force != NULL ? service->slope(force, by, place->of_force) : 0.0;
}

/* The energy of a potential, or what forces store that are given; 0 where there is none. */
static inline double tinker_typed_energy(const TinkerTypedLawService *service, const TinkerBatch *batch,
                                         int32_t instance, const TinkerTypedLawPlace *place)
{
    const TinkerTypedLaw *potential = tinker_typed(batch, instance, TINKER_TYPED_POTENTIAL);
    const TinkerTypedLaw *along_x = tinker_typed(batch, instance, TINKER_TYPED_FORCE_X);
    const TinkerTypedLaw *first = along_x != NULL ? along_x : tinker_typed(batch, instance, TINKER_TYPED_FORCE_Y);
    if (potential != NULL) return service->value(potential, place->of_potential);
    const double stored = first != NULL ? service->energy(first, place->of_force) : 0.0;
    return stored == stored ? stored : 0.0;
}

/* TinkerPhysics.prepare of such a block. */
static inline TinkerStatus tinker_typed_prepare(TinkerBatch *batch)
{
    for (int32_t i = 0; i < batch->count; i++) {
        const int forces = tinker_typed(batch, i, TINKER_TYPED_FORCE_X) != NULL ||
                           tinker_typed(batch, i, TINKER_TYPED_FORCE_Y) != NULL;
        const int potential = tinker_typed(batch, i, TINKER_TYPED_POTENTIAL) != NULL;
        if (forces == potential) {
            batch->failed_instance = i;
            batch->failure =
                forces ? "it has forces and a potential; minus the potential's gradient is the force: give one"
                       : "it has no law; give force_x and force_y, or a potential";
            return TINKER_FAILED;
        }
    }
    return TINKER_OK;
}

static const char *const tinker_typed_of_force[] = {"x", "y", "vx", "vy", "t", "m"};
static const char *const tinker_typed_of_potential[] = {"x", "y", "t", "m"};

/* Its properties. */
#define TINKER_TYPED_FORCES                                                                                            \
    {TINKER_TYPED_PROPERTY("force_x", "X Force", tinker_typed_of_force, TINKER_DIMENSION_FORCE),                       \
     .description = "Of x, y, vx, vy, t and m: -a*x"},                                                                 \
        {TINKER_TYPED_PROPERTY("force_y", "Y Force", tinker_typed_of_force, TINKER_DIMENSION_FORCE),                   \
         .description = "Of x, y, vx, vy, t and m: -a*y - m*9.81"},                                                    \
        {TINKER_TYPED_PROPERTY("potential", "Potential", tinker_typed_of_potential, TINKER_DIMENSION_ENERGY),          \
         .description = "Instead of forces: of x, y, t and m, of which they are minus the gradient"},                  \
        TINKER_TYPED_PARAMETERS

/* Declares a plugin whose blocks stand in the static array `blocks_`, and which cannot do without laws. */
#define TINKER_DEFINE_TYPED_PLUGIN(id_, title_, version_, licence_, blocks_)                                           \
    static const TinkerTypedLawService *tinker_typed_laws;                                                             \
    static const char *const tinker_needed_services[] = {TINKER_TYPED_SERVICE};                                        \
    static TinkerStatus tinker_find_formulas(const TinkerHost *host)                                                   \
    {                                                                                                                  \
        tinker_typed_laws = (const TinkerTypedLawService *)host->service(host, TINKER_TYPED_SERVICE);                  \
        return tinker_typed_laws != NULL && tinker_typed_laws->struct_size >= sizeof(TinkerTypedLawService)            \
                   ? TINKER_OK                                                                                         \
                   : TINKER_FAILED;                                                                                    \
    }                                                                                                                  \
    static const TinkerPlugin tinker_the_plugin = {TINKER_PLUGIN_HEAD,                                                 \
                                                   id_,                                                                \
                                                   title_,                                                             \
                                                   version_,                                                           \
                                                   licence_,                                                           \
                                                   "",                                                                 \
                                                   TINKER_SPAN(blocks_),                                               \
                                                   TINKER_NO_SPAN,                                                     \
                                                   TINKER_SPAN(tinker_needed_services),                                \
                                                   tinker_find_formulas};                                              \
    TINKER_DEFINE_ENTRY

#ifdef __cplusplus
}
#endif
#endif
