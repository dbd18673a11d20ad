/* run, saved: the block in a small scene, built from its declaration, with bodies that are installed. */
#include <math.h>
#include <string.h>

#include "conformance/probe/kit.h"
#include "conformance/probe/scene-start.h"
#include "conformance/probe/state.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"
#include "scene/read/scene-json.h"

#define DURATION 0.2
#define INTERVAL 0.02

/* The kinds of body that ends attach to: by what they are, not by name; those that tell most of how they move. */
typedef struct {
    const TinkerBlockClass *mover, *support;
} Bodies;

/* What speaks of angles, and what resists turning, works between bodies that have an angle. */
static gboolean is_for_what_turns(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    return tinker_block_class_speaks_of_angles(block_class) ||
           (physics != NULL && physics->constraint != NULL && physics->constraint->friction != NULL);
}

static Bodies find_bodies(KitCheck *check)
{
    Bodies bodies = {NULL, NULL};
    const int32_t wanted = is_for_what_turns(check->block_class) ? 3 : 2; // degrees of freedom
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(check->catalogue);
    g_autoptr(GPtrArray) types = tinker_libraries_types(libraries);
    for (guint i = 0; i < types->len; i++) {
        const TinkerTypeEntry *type = g_ptr_array_index(types, i);
        if (strcmp(type->category, TINKER_CONNECTABLE) != 0) continue;
        const TinkerBlockClass *c = tinker_catalogue_type(check->catalogue, type->id, NULL);
        if (c == NULL || c->physics == NULL || c->physics->body == NULL) continue;
        const int32_t freedoms = c->physics->body->degrees_of_freedom;
        const TinkerBlockClass **slot = freedoms == wanted ? &bodies.mover : &bodies.support;
        if (freedoms != wanted && freedoms != 0) continue;
        if (*slot == NULL || (*slot)->quantity_count < c->quantity_count) *slot = c;
    }
    return bodies;
}

static TinkerBlockId add_body(KitCheck *check, TinkerScene *scene, const TinkerBlockClass *body)
{
    const TinkerBlockId block = tinker_scene_add_block(scene, body, NULL, NULL);
    const int32_t solid = body->meanings[TINKER_MEANING_SOLID];
    const int32_t count = tinker_scene_block_count(scene);
    const double place[2] = {1.5 * count + g_rand_double_range(check->random, -0.3, 0.3),
                             g_rand_double_range(check->random, -1, 1)};
    const double velocity[2] = {g_rand_double_range(check->random, -0.5, 0.5),
                                g_rand_double_range(check->random, -0.5, 0.5)};
    const double off = 0;
    tinker_scene_set(scene, block, body->meanings[TINKER_MEANING_POSITION], place, NULL);
    if (body->meanings[TINKER_MEANING_VELOCITY] >= 0)
        tinker_scene_set(scene, block, body->meanings[TINKER_MEANING_VELOCITY], velocity, NULL);
    if (solid >= 0) tinker_scene_set(scene, block, solid, &off, NULL);
    return block;
}

/* Ordinary values; what is left out has its default: lengths as placed, and every other property now and then. */
static void set_values(KitCheck *check, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *c = tinker_scene_block_class(scene, block);
    for (int32_t i = 0; i < c->property_count; i++) {
        const TinkerPropertyType *property = &c->properties[i];
        const double values[2] = {kit_ordinary_value(property, check->random),
                                  kit_ordinary_value(property, check->random)};
        const guint32 others = TINKER_READ_ONLY | TINKER_DERIVED | TINKER_DEFAULT_AS_PLACED | TINKER_DEFAULT_SAME_AS |
                               TINKER_DEFAULT_AS_SHAPED;
        const gboolean kept = property->flags & others || property->meaning == TINKER_MEANING_POSITION ||
                              property->kind == TINKER_KIND_TEXT || property->kind == TINKER_KIND_WAVEFORM;
        if (!kept && g_rand_boolean(check->random)) tinker_scene_set(scene, block, i, values, NULL);
    }
}

static gboolean attach(KitCheck *check, TinkerScene *scene, const Bodies *bodies, TinkerBlockId block)
{
    const guint32 accepts = tinker_scene_block_class(scene, block)->type->end_accepts;
    for (int32_t end = 0; end < tinker_scene_end_count(scene, block); end++) {
        const TinkerBlockClass *body = accepts & TINKER_ACCEPTS_BODY ? bodies->mover : bodies->support;
        if (body == NULL) return FALSE;
        const TinkerSceneEnd to = {add_body(check, scene, body), 0, 0};
        g_autoptr(GError) error = NULL;
        if (tinker_scene_set_end(scene, block, end, to, &error)) continue;
        kit_fail(check, "its end %d does not take a body that it says it accepts: %s", end, error->message);
        return FALSE;
    }
    return TRUE;
}

/* NULL with the reason told. (transfer full) */
static TinkerScene *build_scene(KitCheck *check)
{
    const Bodies bodies = find_bodies(check);
    g_autoptr(TinkerScene) scene = tinker_scene_new(check->catalogue);
    TinkerSceneHead *head = tinker_scene_head(scene);
    head->run.duration = DURATION;
    head->run.interval = INTERVAL;
    if (bodies.mover == NULL) {
        kit_skip(check, "no body that can move is installed to build a scene with");
        return NULL;
    }
    g_autoptr(GError) error = NULL;
    const TinkerBlockId block = tinker_scene_add_block(scene, check->block_class, NULL, &error);
    if (block == TINKER_NO_BLOCK) {
        kit_fail(check, "a scene does not take it: %s", error->message);
        return NULL;
    }
    set_values(check, scene, block);
    if (!attach(check, scene, &bodies, block)) {
        kit_skip(check, "no support is installed to build a scene with");
        return NULL;
    }
    kit_fit_start(check, scene, block);
    for (int i = 0; i < 2; i++)
        add_body(check, scene, bodies.mover);
    return g_steal_pointer(&scene);
}

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    const GArray *columns = ((gpointer *)data)[0];
    GArray *record = ((gpointer *)data)[1];
    g_array_append_val(record, time);
    g_array_append_vals(record, values, columns->len);
    return TRUE;
}

/* Values that do not go together are no fault of the plugin's; what its role lacks is, and the host says what that is.
 * Of the two rules it is `run` that fails of it. */
static void tell_refusal(KitCheck *check, const GError *error, gboolean blame)
{
    if (blame && g_error_matches(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_PLUGIN))
        kit_fail(check, "%s", error->message);
    else
        kit_skip(check, "no start was found that a scene with it can have: %s", error->message);
}

/* The record of a run with every quantity of every block; NULL with the reason told. (transfer full) */
static GArray *run_scene(KitCheck *check, TinkerScene *scene, gboolean blame)
{
    g_autoptr(GError) error = NULL;
    kit_phase(check, "compiling a scene with it");
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    if (model == NULL) {
        tell_refusal(check, error, blame);
        return NULL;
    }
    g_autoptr(GArray) columns = tinker_columns_new();
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        for (int32_t q = 0; q < tinker_scene_block_class(scene, block)->quantity_count; q++)
            tinker_columns_add_quantity(columns, scene, block, q);
    }
    TinkerRunOptions options = tinker_run_options_of(scene);
    options.estimate = FALSE;
    kit_phase(check, "a run of a scene with it");
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, &error);
    g_autoptr(GArray) record = g_array_new(FALSE, FALSE, sizeof(double));
    gpointer data[] = {columns, record};
    if (simulation == NULL || !tinker_simulation_run(simulation, columns, take_sample, data, &error)) {
        kit_fail(check, "a scene with it does not run: %s", error->message);
        return NULL;
    }
    for (guint i = 0; i < record->len; i++)
        if (!isfinite(g_array_index(record, double, i)))
            kit_fail(check, "the record of a scene with it is not finite at t = %g s",
                     g_array_index(record, double, i / (columns->len + 1) * (columns->len + 1)));
    return g_steal_pointer(&record);
}

#define ROUNDS 3

void kit_try_run(KitCheck *check)
{
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(TinkerScene) scene = build_scene(check);
        g_autoptr(GArray) record = scene == NULL ? NULL : run_scene(check, scene, TRUE);
        (void)record;
    }
}

void kit_try_saved(KitCheck *check)
{
    for (int round = 0; round < ROUNDS && !kit_decided(check); round++) {
        g_autoptr(TinkerScene) scene = build_scene(check);
        g_autoptr(GArray) before = scene == NULL ? NULL : run_scene(check, scene, FALSE);
        if (before == NULL) return;
        g_autoptr(GError) error = NULL;
        g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
        g_autoptr(TinkerScene) again = tinker_scene_read_text(check->catalogue, text, strlen(text), NULL, NULL, &error);
        if (again == NULL) {
            kit_fail(check, "a scene with it is saved, but cannot be read back: %s", error->message);
            return;
        }
        g_autoptr(GArray) after = run_scene(check, again, FALSE);
        if (after == NULL) return;
        if (before->len != after->len || memcmp(before->data, after->data, before->len * sizeof(double)) != 0)
            kit_fail(check, "a scene with it runs to other bits after it was saved and loaded");
    }
}
