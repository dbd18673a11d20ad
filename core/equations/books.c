/* The books, kept while the scene runs. */
#include "equations/books.h"

#include <math.h>
#include <string.h>

#include "equations/book-nodes-private.h"
#include "physics/compile/compile.h"
#include "physics/model/breaks.h"
#include "physics/run/accurate-run.h"
#include "scene/frame/frame.h"

#define FIRST_PANELS 8
#define MOST_PANELS  4096
#define STANDS_STILL 1e-11 /* of the scales, from one number of panels to twice as many */
#define CLOSEST_CUTS 1e-9  /* of the interval: cuts that are nearer are one */

typedef struct {
    TinkerBookEntry entry;
    double work, impulse, angular; /* of magnitudes */
} Account;

typedef struct {
    TinkerBlockId block;
    double mass;
    double speed[2]; /* m/s: before a jump */
} Body;

/* Something happened in the run: contact, a jerk, a rope that went taut. */
typedef struct {
    double time;
    char *blocks; /* names, joined by ", " */
} Instant;

typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    TinkerBooks *books;
    GArray *bodies;   /* of Body */
    GArray *accounts; /* of Account, by block id */
    GArray *nodes;
    guint next; /* node */
    GArray *columns;
    const GPtrArray *instants; /* of Instant: those of the run before */
    double greatest[3]; /* sums over the bodies of kinetic energy, |momentum|, |angular momentum|: the greatest */
} Keeper;

static Body *body_at(const Keeper *keeper, guint number)
{
    return &g_array_index(keeper->bodies, Body, number);
}

static const Body *find_body(const Keeper *keeper, TinkerBlockId block)
{
    for (guint i = 0; i < keeper->bodies->len; i++)
        if (body_at(keeper, i)->block == block) return body_at(keeper, i);
    return NULL;
}

/* Whether all that a block is attached to is among the bodies. */
static gboolean is_inner(const Keeper *keeper, TinkerBlockId block)
{
    const int32_t ends = tinker_scene_end_count(keeper->scene, block);
    for (int32_t i = 0; i < ends; i++)
        if (find_body(keeper, tinker_scene_end(keeper->scene, block, i).block) == NULL) return FALSE;
    return ends > 1;
}

static Account *account_of(Keeper *keeper, TinkerBlockId by)
{
    Account *account = &g_array_index(keeper->accounts, Account, by);
    if (account->entry.by == by) return account;
    account->entry.by = by;
    account->entry.inner = is_inner(keeper, by);
    return account;
}

/* The three moments of motion of one body: kinetic energy, momentum, angular momentum. */
static void add_motion(Keeper *keeper, const TinkerModelState *state, int which)
{
    TinkerBooks *books = keeper->books;
    double sizes[3] = {0, 0, 0}, kinetic = 0, momentum[2] = {0, 0}, angular = 0;
    for (guint i = 0; i < keeper->bodies->len; i++) {
        const Body *body = body_at(keeper, i);
        const TinkerBodySample *at = tinker_model_state_body(state, body->block);
        const double m = body->mass, rx = at->x - books->about[0], ry = at->y - books->about[1];
        const double own = 0.5 * m * (at->vx * at->vx + at->vy * at->vy), turn = m * (rx * at->vy - ry * at->vx);
        kinetic += own;
        momentum[0] += m * at->vx;
        momentum[1] += m * at->vy;
        angular += turn;
        sizes[0] += own;
        sizes[1] += m * hypot(at->vx, at->vy);
        sizes[2] += m * hypot(at->vx, at->vy) * hypot(rx, ry);
    }
    for (int k = 0; k < 3; k++)
        keeper->greatest[k] = fmax(keeper->greatest[k], sizes[k]);
    if (which < 0) return;
    books->kinetic[which] = kinetic;
    memcpy(books->momentum[which], momentum, sizeof momentum);
    books->angular[which] = angular;
}

static void add_forces(Keeper *keeper, const TinkerModelState *state, double weight, gboolean end)
{
    const TinkerBooks *books = keeper->books;
    for (guint i = 0; i < state->forces->len; i++) {
        const TinkerActingForce *force = &g_array_index(state->forces, TinkerActingForce, i);
        if (find_body(keeper, force->on) == NULL) continue;
        const TinkerBodySample *at = tinker_model_state_body(state, force->on);
        Account *account = account_of(keeper, force->by);
        const double power = force->fx * at->vx + force->fy * at->vy;
        const double moment = (at->x - books->about[0]) * force->fy - (at->y - books->about[1]) * force->fx;
        account->entry.work += weight * power;
        account->entry.impulse[0] += weight * force->fx;
        account->entry.impulse[1] += weight * force->fy;
        account->entry.angular += weight * moment;
        account->work += weight * fabs(power);
        account->impulse += weight * hypot(force->fx, force->fy);
        account->angular += weight * fabs(moment);
        if (end) account->entry.force[0] += force->fx;
        if (end) account->entry.force[1] += force->fy;
    }
}

/* Impacts ---------------------------------------------------------------------------------------------------------- */

/* Whether the text, names joined by ", ", is of these two, or of the second alone. */
static gboolean names_both(const char *text, const char *one, const char *other)
{
    g_autofree char *first = g_strconcat(one, ", ", other, NULL), *second = g_strconcat(other, ", ", one, NULL);
    return strcmp(text, first) == 0 || strcmp(text, second) == 0 || strcmp(text, other) == 0;
}

/* The block that an event at the time names beside the body; -1 for none. */
static TinkerBlockId struck_by(const Keeper *keeper, TinkerBlockId body, double time)
{
    const char *name = tinker_scene_block_name(keeper->scene, body);
    for (guint i = 0; keeper->instants != NULL && i < keeper->instants->len; i++) {
        const Instant *instant = g_ptr_array_index(keeper->instants, i);
        if (instant->time != time || instant->blocks == NULL) continue;
        for (int32_t k = 0; k < tinker_scene_block_count(keeper->scene); k++) {
            const TinkerBlockId other = tinker_scene_block_at(keeper->scene, k);
            if (other != body && names_both(instant->blocks, name, tinker_scene_block_name(keeper->scene, other)))
                return other;
        }
    }
    return -1;
}

static void add_impact(Keeper *keeper, const Body *body, const TinkerBodySample *at, double time)
{
    const double m = body->mass, px = m * (at->vx - body->speed[0]), py = m * (at->vy - body->speed[1]);
    const double before = body->speed[0] * body->speed[0] + body->speed[1] * body->speed[1];
    const TinkerBookImpact impact = {.time = time,
                                     .by = struck_by(keeper, body->block, time),
                                     .on = body->block,
                                     .impulse = {px, py},
                                     .work = 0.5 * m * (at->vx * at->vx + at->vy * at->vy - before)};
    const double rx = at->x - keeper->books->about[0], ry = at->y - keeper->books->about[1];
    g_array_append_val(keeper->books->impacts, impact);
    if (impact.by < 0) return;
    Account *account = account_of(keeper, impact.by);
    account->entry.work += impact.work;
    account->entry.impulse[0] += px;
    account->entry.impulse[1] += py;
    account->entry.angular += rx * py - ry * px;
    account->work += fabs(impact.work);
    account->impulse += hypot(px, py);
    account->angular += fabs(rx * py - ry * px);
}

/* Rounding and the short time before the instant are no jump. */
#define LEAST_JUMP 1e-11

static void look_for_jumps(Keeper *keeper, const TinkerModelState *state, gboolean after)
{
    for (guint i = 0; i < keeper->bodies->len; i++) {
        Body *body = body_at(keeper, i);
        const TinkerBodySample *at = tinker_model_state_body(state, body->block);
        if (!after) {
            body->speed[0] = at->vx;
            body->speed[1] = at->vy;
            continue;
        }
        const double jump = hypot(at->vx - body->speed[0], at->vy - body->speed[1]);
        if (jump > LEAST_JUMP * (hypot(at->vx, at->vy) + hypot(body->speed[0], body->speed[1])))
            add_impact(keeper, body, at, state->time);
    }
}

/* The run ---------------------------------------------------------------------------------------------------------- */

static void begin_again(void *data)
{
    Keeper *keeper = data;
    keeper->next = 0;
    for (guint i = 0; i < keeper->accounts->len; i++)
        g_array_index(keeper->accounts, Account, i) = (Account){.entry = {.by = -1}};
    g_array_set_size(keeper->books->impacts, 0);
    memset(keeper->greatest, 0, sizeof keeper->greatest);
    memset(keeper->books->rate, 0, sizeof keeper->books->rate);
}

static gboolean look(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Keeper *keeper = data;
    if (keeper->next >= keeper->nodes->len) return TRUE;
    const TinkerBookNode *node = &g_array_index(keeper->nodes, TinkerBookNode, keeper->next++);
    g_autoptr(TinkerModelState) state =
        tinker_model_state_take(simulation, keeper->model, keeper->scene, time, values, error);
    if (state == NULL) return FALSE;
    const gboolean start = node->kind == TINKER_NODE_START, end = node->kind == TINKER_NODE_END;
    add_motion(keeper, state, start ? 0 : end ? 1 : -1);
    if (node->kind == TINKER_NODE_INSIDE || end) add_forces(keeper, state, node->weight, end);
    if (node->kind == TINKER_NODE_BEFORE || node->kind == TINKER_NODE_AFTER)
        look_for_jumps(keeper, state, node->kind == TINKER_NODE_AFTER);
    for (guint i = 0; end && i < state->bodies->len; i++) {
        const TinkerBodyState *at = &g_array_index(state->bodies, TinkerBodyState, i);
        const Body *body = find_body(keeper, at->block);
        for (int axis = 0; body != NULL && axis < 2; axis++)
            keeper->books->rate[axis] += body->mass * at->acceleration[axis];
    }
    return TRUE;
}

static void instant_free(void *data)
{
    g_free(((Instant *)data)->blocks);
    g_free(data);
}

/* (transfer full) */
static GPtrArray *instants_of(TinkerSimulation *simulation)
{
    const GPtrArray *events = tinker_simulation_summary(simulation)->events;
    GPtrArray *instants = g_ptr_array_new_with_free_func(instant_free);
    for (guint i = 0; i < events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(events, i);
        Instant *instant = g_new(Instant, 1);
        *instant = (Instant){event->time, g_strdup(event->blocks)};
        g_ptr_array_add(instants, instant);
    }
    return instants;
}

/* Runs to the last node; what happened is left in `instants` (NULL: nobody asks) (transfer full). */
static gboolean run(Keeper *keeper, const TinkerRunOptions *options, GPtrArray **instants, GError **error)
{
    TinkerRunOptions with = *options;
    g_autofree double *times = g_new(double, keeper->nodes->len);
    for (guint i = 0; i < keeper->nodes->len; i++)
        times[i] = g_array_index(keeper->nodes, TinkerBookNode, i).time;
    with.at = times;
    with.at_count = keeper->nodes->len;
    with.estimate = with.accuracy > 0;
    begin_again(keeper);
    keeper->model = tinker_model_new(keeper->scene, error);
    TinkerSimulation *simulation = keeper->model != NULL ? tinker_simulation_new(keeper->model, &with, error) : NULL;
    const TinkerSampleTaker taker = {look, begin_again, keeper};
    const gboolean done = simulation != NULL && tinker_accurate_run(&simulation, keeper->columns, &taker, error);
    if (done && instants != NULL) *instants = instants_of(simulation);
    g_clear_pointer(&simulation, tinker_simulation_free);
    g_clear_pointer(&keeper->model, tinker_model_free);
    return done;
}

static gint by_value(gconstpointer a, gconstpointer b)
{
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* Every instant within the interval at which a force may jump: breaks of waveforms and laws, events. (transfer full) */
static GArray *cuts_of(TinkerScene *scene, const TinkerBooks *books, const GPtrArray *instants, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return NULL;
    GArray *cuts = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < instants->len; i++)
        g_array_append_val(cuts, ((Instant *)g_ptr_array_index(instants, i))->time);
    for (double t = tinker_model_next_break(model, books->from, books->to); isfinite(t) && t < books->to;
         t = tinker_model_next_break(model, t, books->to))
        g_array_append_val(cuts, t);
    g_array_sort(cuts, by_value);
    const double least = CLOSEST_CUTS * (books->to - books->from);
    guint kept = 0;
    double last = books->from;
    for (guint i = 0; i < cuts->len; i++) {
        const double cut = g_array_index(cuts, double, i);
        if (cut - last <= least || books->to - cut <= least) continue;
        g_array_index(cuts, double, kept++) = last = cut;
    }
    g_array_set_size(cuts, kept);
    return cuts;
}

/* Conclusions ------------------------------------------------------------------------------------------------------ */

static void conclude(Keeper *keeper)
{
    TinkerBooks *books = keeper->books;
    double sums[3] = {0, 0, 0}, work = 0, impulse[2] = {0, 0}, angular = 0, force[2] = {0, 0}, forces = 0;
    g_array_set_size(books->entries, 0);
    for (int32_t i = 0; i < tinker_scene_block_count(keeper->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(keeper->scene, i);
        const Account *account = &g_array_index(keeper->accounts, Account, block);
        if (account->entry.by != block) continue;
        g_array_append_val(books->entries, account->entry);
        sums[0] += account->work;
        sums[1] += account->impulse;
        sums[2] += account->angular;
        work += account->entry.work;
        if (account->entry.inner) continue;
        forces += hypot(account->entry.force[0], account->entry.force[1]);
        for (int axis = 0; axis < 2; axis++) {
            force[axis] += account->entry.force[axis];
            impulse[axis] += account->entry.impulse[axis];
        }
        angular += account->entry.angular;
    }
    const double px = books->momentum[1][0] - books->momentum[0][0] - impulse[0],
                 py = books->momentum[1][1] - books->momentum[0][1] - impulse[1];
    books->newton = (TinkerBookBalance){hypot(force[0] - books->rate[0], force[1] - books->rate[1]), forces};
    books->energy =
        (TinkerBookBalance){books->kinetic[1] - books->kinetic[0] - work, fmax(keeper->greatest[0], sums[0])};
    books->impulse = (TinkerBookBalance){hypot(px, py), fmax(keeper->greatest[1], sums[1])};
    books->moment =
        (TinkerBookBalance){books->angular[1] - books->angular[0] - angular, fmax(keeper->greatest[2], sums[2])};
}

/* How far the entries are from those of fewer panels, in units of the scales. */
static double change_of(const TinkerBooks *books, const GArray *before)
{
    if (before == NULL || before->len != books->entries->len) return INFINITY;
    double change = 0;
    for (guint i = 0; i < before->len; i++) {
        const TinkerBookEntry *a = &g_array_index(before, TinkerBookEntry, i),
                              *b = &g_array_index(books->entries, TinkerBookEntry, i);
        const double impulse = hypot(a->impulse[0] - b->impulse[0], a->impulse[1] - b->impulse[1]);
        change = fmax(change, fabs(a->work - b->work) / (books->energy.scale + 1e-300));
        change = fmax(change, impulse / (books->impulse.scale + 1e-300));
        change = fmax(change, fabs(a->angular - b->angular) / (books->moment.scale + 1e-300));
    }
    return change;
}

static gboolean keep(Keeper *keeper, const TinkerRunOptions *options, const GArray *cuts, GError **error)
{
    g_autoptr(GArray) before = NULL;
    for (int panels = FIRST_PANELS; panels <= MOST_PANELS; panels *= 2) {
        g_clear_pointer(&keeper->nodes, g_array_unref);
        keeper->nodes = tinker_book_nodes(keeper->books->from, keeper->books->to, cuts, panels);
        if (!run(keeper, options, NULL, error)) return FALSE;
        conclude(keeper);
        if (change_of(keeper->books, before) <= STANDS_STILL) return TRUE;
        g_clear_pointer(&before, g_array_unref);
        before = g_array_copy(keeper->books->entries);
    }
    return TRUE;
}

static void add_bodies(Keeper *keeper, const TinkerFrame *frame, const TinkerBlockId *bodies)
{
    for (; *bodies >= 0; bodies++) {
        const Body body = {.block = *bodies, .mass = tinker_frame_meaning(frame, *bodies, TINKER_MEANING_MASS, 0, 0)};
        g_array_append_val(keeper->bodies, body);
    }
}

TinkerBooks *tinker_books_new(TinkerScene *scene, const TinkerRunOptions *options, const TinkerBlockId *bodies,
                              double from, double to, const double about[2], GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL) return NULL;
    g_autoptr(TinkerBooks) books = g_new0(TinkerBooks, 1);
    *books = (TinkerBooks){.from = from, .to = to, .about = {about[0], about[1]}};
    books->entries = g_array_new(FALSE, TRUE, sizeof(TinkerBookEntry));
    books->impacts = g_array_new(FALSE, TRUE, sizeof(TinkerBookImpact));
    g_autoptr(GArray) held = g_array_new(FALSE, TRUE, sizeof(Body)), columns = tinker_model_state_columns(scene);
    g_autoptr(GArray) accounts = g_array_new(FALSE, TRUE, sizeof(Account)), cuts = NULL,
                      none = g_array_new(FALSE, FALSE, sizeof(double));
    g_array_set_size(accounts, (guint)tinker_scene_id_limit(scene));
    Keeper keeper = {.scene = scene, .books = books, .bodies = held, .accounts = accounts, .columns = columns};
    add_bodies(&keeper, frame, bodies);
    /* once for what happens, and then between that */
    g_autoptr(GPtrArray) instants = NULL;
    keeper.nodes = tinker_book_nodes(from, to, none, 1);
    gboolean done = run(&keeper, options, &instants, error);
    keeper.instants = instants;
    if (done) done = (cuts = cuts_of(scene, books, instants, error)) != NULL && keep(&keeper, options, cuts, error);
    g_array_unref(keeper.nodes);
    return done ? g_steal_pointer(&books) : NULL;
}

void tinker_books_free(TinkerBooks *books)
{
    g_array_unref(books->entries);
    g_array_unref(books->impacts);
    g_free(books);
}
