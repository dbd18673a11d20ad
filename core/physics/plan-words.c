/* What is modelled, and what is not because nothing asks for it: sentences from the compiled model, which knows roles and no
 * block by name. */
#include <math.h>
#include <stdarg.h>

#include "physics/contacts.h"
#include "physics/plan-private.h"

static void say(GPtrArray *sentences, const char *format, ...) G_GNUC_PRINTF(2, 3);
static void say(GPtrArray *sentences, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(sentences, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

/* "1 body", "3 bodies"; the text is good until the next call with the same buffer. */
static const char *counted(char buffer[64], int32_t count, const char *one, const char *many)
{
    g_snprintf(buffer, 64, "%d %s", count, count == 1 ? one : many);
    return buffer;
}

static int32_t count_asked(const GArray *batches)
{
    int32_t count = 0;
    for (guint i = 0; i < batches->len; i++)
        count += g_array_index(batches, TinkerAskedBatch, i).batch->count;
    return count;
}

static void describe_bodies(TinkerPlan *plan, const TinkerModel *model)
{
    char text[64];
    TinkerModelSizes sizes = tinker_model_sizes(model);
    say(plan->modelled, "%s as points with two coordinates each: %d degree%s of freedom",
        counted(text, model->bodies, "body", "bodies"), sizes.degrees_of_freedom,
        sizes.degrees_of_freedom == 1 ? "" : "s");
    if (model->bodies > 0) say(plan->left_out, "rotation: every body that moves is a point");
}

static void describe_lines(TinkerPlan *plan, const TinkerModel *model)
{
    char text[64], merged[64];
    int32_t laws = 0, asked = count_asked(model->asked_lines);
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics != NULL && physics->line_law != NULL) laws += batch->count;
    }
    if (laws - asked > 0)
        say(plan->modelled, "%s with a linear law, stepped as %s",
            counted(text, laws - asked, "connector", "connectors"),
            counted(merged, model->lines.count, "line", "lines"));
    if (asked > 0)
        say(plan->modelled, "%s with a nonlinear law, asked at every evaluation",
            counted(text, asked, "connector", "connectors"));
    if (laws == 0)
        say(plan->left_out, "elastic and viscous connectors: there are none");
    else if (asked == 0)
        say(plan->left_out, "nonlinear laws: every connector's law is linear");
}

static void describe_fields(TinkerPlan *plan, const TinkerModel *model)
{
    char text[64];
    double gravity = hypot(model->field_acceleration[0], model->field_acceleration[1]);
    int32_t asked = count_asked(model->asked_fields);
    if (gravity > 0)
        say(plan->modelled, "a uniform acceleration of %g m/s² on every body", gravity);
    else if (asked == 0)
        say(plan->left_out, "gravity: no block asks for it");
    if (model->field_drag != 0 || model->field_force[0] != 0 || model->field_force[1] != 0)
        say(plan->modelled, "air that moves or resists: a force linear in each body's velocity");
    else if (asked == 0)
        say(plan->left_out, "air: no block makes it resist or blow");
    if (asked > 0)
        say(plan->modelled, "%s that the state changes, asked at every evaluation",
            counted(text, asked, "field", "fields"));
}

static void describe_forces(TinkerPlan *plan, const TinkerModel *model)
{
    char text[64];
    int32_t asked = count_asked(model->asked_forces);
    if (model->driven->len > 0)
        say(plan->modelled, "%s of time alone", counted(text, (int32_t)model->driven->len, "force", "forces"));
    if (asked > 0)
        say(plan->modelled, "%s on the state", counted(text, asked, "force that depends", "forces that depend"));
    if (model->driven->len == 0 && asked == 0 && model->constant_force == NULL)
        say(plan->left_out, "driving forces: no block applies one");
}

/* Whether anything takes energy: dampers, drag, laws that are asked. */
static gboolean is_damped(const TinkerModel *model)
{
    return model->lines.any_damping || model->field_drag != 0 || model->asked_lines->len > 0 ||
           model->asked_forces->len > 0 || model->asked_fields->len > 0;
}

static void describe_constraints(TinkerPlan *plan, const TinkerModel *model)
{
    char text[64];
    const TinkerConstraints *all = &model->constraints;
    if (all->rows == 0) {
        say(plan->left_out, "constraint forces: nothing holds a distance fixed");
        return;
    }
    say(plan->modelled, "%s, solved after the other forces and held by projection",
        counted(text, all->rows, "constraint row", "constraint rows"));
    if (plan->redundant->len == 0) return;
    g_autoptr(GString) names = g_string_new(NULL);
    for (guint i = 0; i < plan->redundant->len; i++)
        g_string_append_printf(names, "%s%s", i > 0 ? ", " : "", (const char *)g_ptr_array_index(plan->redundant, i));
    say(plan->modelled, "redundant: %s; forces there are the share of least norm, as nothing determines them",
        names->str);
}

/* A motion need not begin at 0: a cosine begins at its amplitude. */
static void describe_displaced(TinkerPlan *plan, const TinkerModel *model)
{
    TinkerBlockId last = TINKER_NO_BLOCK;
    for (guint i = 0; i < model->support_points->len; i++) {
        const TinkerSupportPoint *at = &g_array_index(model->support_points, TinkerSupportPoint, i);
        const TinkerPoint *now = &model->point[model->bodies + (int32_t)i];
        double dx = now->x - at->x, dy = now->y - at->y;
        if (!at->moving || at->support == last || hypot(dx, dy) == 0) continue;
        last = at->support;
        say(plan->modelled, "%s starts displaced by (%.4g, %.4g) m: its motion does not begin at 0",
            tinker_scene_block_name(model->scene, at->support), dx, dy);
    }
}

static void describe_supports(TinkerPlan *plan, TinkerModel *model)
{
    char text[64];
    if (model->moving_supports == 0) {
        say(plan->left_out, "motion of supports: all of them stand still");
        return;
    }
    say(plan->modelled, "%s in a way that is given, with exact velocity and acceleration",
        counted(text, model->moving_supports, "support that moves", "supports that move"));
    if (tinker_model_set_time(model, 0.0) == TINKER_OK) describe_displaced(plan, model);
}

/* Bodies that could meet a solid side. */
static int32_t count_shapes(const TinkerContacts *contacts)
{
    int32_t count = 0;
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        count += !isnan(contacts->half_height[i]);
    return count;
}

static gboolean is_rough(const TinkerModel *model)
{
    const TinkerContacts *contacts = model->contacts;
    for (int32_t i = 0; contacts != NULL && i < contacts->plate_count; i++)
        if (contacts->plates[i].static_friction > 0) return TRUE;
    return FALSE;
}

static void describe_contact(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    char bodies[64], plates[64];
    const TinkerContacts *contacts = model->contacts;
    if (contacts == NULL || contacts->plate_count == 0) {
        say(plan->left_out, "contact and friction: nothing has a solid side that a body could meet");
        return;
    }
    say(plan->modelled, "contact of %s with %s%s: %s", counted(bodies, count_shapes(contacts), "body", "bodies"),
        counted(plates, contacts->plate_count, "solid side", "solid sides"), is_rough(model) ? ", with friction" : "",
        options->impulses ? "impulses, once a step"
                          : "what comes near is watched, impacts and changes of friction are events within the steps");
    if (!is_rough(model)) say(plan->left_out, "friction: every solid side is smooth");
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (!tinker_contacts_touch(contacts) && !options->impulses)
        say(plan->left_out, "forces of contact: nothing touches at the start; they enter when something does");
}

static gboolean any_nonlinear(const TinkerPlan *plan)
{
    for (guint i = 0; i < plan->islands->len; i++)
        if (!((const TinkerIslandPlan *)g_ptr_array_index(plan->islands, i))->linear) return TRUE;
    return FALSE;
}

static void describe_islands(TinkerPlan *plan)
{
    char text[64];
    int32_t straight = 0, joined = 0, count = (int32_t)plan->islands->len;
    for (guint i = 0; i < plan->islands->len; i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->islands, i);
        straight += island->straight;
        joined = MAX(joined, island->joined);
        if (island->sideways_growth > 0)
            say(plan->warnings,
                "straight motion is unstable, grows at %.3g/s: island %u is stepped in both coordinates, and any "
                "disturbance "
                "across its line grows",
                island->sideways_growth, i + 1);
        else if (island->growth_max > 0)
            say(plan->modelled, "the start of island %u is unstable: what leaves it grows at %.3g/s", i + 1,
                island->growth_max);
    }
    if (count > 1)
        say(plan->modelled, "%s, each with its own method and step", counted(text, count, "island", "islands"));
    if (joined > 1) say(plan->modelled, "the %d smallest islands are stepped together", joined);
    if (straight > 0)
        say(plan->left_out, "motion across the line: %s %s and %s along one line",
            counted(text, straight, "island", "islands"), straight == 1 ? "lies" : "lie",
            straight == 1 ? "moves" : "move");
    if (!any_nonlinear(plan)) say(plan->left_out, "large-displacement geometry: all motion is linear");
}

void tinker_plan_describe(TinkerPlan *plan, TinkerModel *model, const TinkerRunOptions *options)
{
    describe_bodies(plan, model);
    describe_islands(plan);
    describe_lines(plan, model);
    describe_fields(plan, model);
    describe_forces(plan, model);
    describe_constraints(plan, model);
    describe_supports(plan, model);
    describe_contact(plan, model, options);
    if (!is_damped(model) && !is_rough(model)) say(plan->left_out, "damping: no block takes energy");
    if (!options->estimate) say(plan->left_out, "the error estimate: it is switched off");
}
