/* The books, kept while the scene runs. */
#include "equations/balance/books.h"

#include <math.h>
#include <string.h>

#include "equations/balance/book-keeper-private.h"
#include "physics/compile/compile.h"
#include "physics/model/breaks.h"
#include "physics/record/sample-times.h"
#include "physics/run/accurate-run.h"
#include "scene/frame/frame.h"

#define FIRST_PANELS 8
#define MOST_PANELS  4096
#define MOST_RUNS    32
#define MOST_STEPS   32768 /* each a piece of its own; of more the panels average */
#define STANDS_STILL 1e-11 /* of the scales, from one number of panels to twice as many */
#define CLOSEST_CUTS 1e-9  /* of the interval: cuts that are nearer are one */

static void begin_again(void *data)
{
    TinkerBookKeeper *keeper = data;
    keeper->next = 0;
    for (guint i = 0; i < keeper->accounts->len; i++)
        g_array_index(keeper->accounts, TinkerBookAccount, i) = (TinkerBookAccount){.entry = {.by = -1}};
    g_array_set_size(keeper->books->impacts, 0);
    memset(keeper->greatest, 0, sizeof keeper->greatest);
    memset(keeper->books->rate, 0, sizeof keeper->books->rate);
    tinker_book_panels_clear(keeper->panels);
}

static gboolean look(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    TinkerBookKeeper *keeper = data;
    if (keeper->next >= keeper->nodes->len) return TRUE;
    const TinkerBookNode *node = &g_array_index(keeper->nodes, TinkerBookNode, keeper->next++);
    g_autoptr(TinkerModelState) state =
        tinker_model_state_take(simulation, keeper->model, keeper->scene, time, values, error);
    if (state == NULL) return FALSE;
    const gboolean start = node->kind == TINKER_NODE_START, end = node->kind == TINKER_NODE_END;
    if (start && time == 0)
        tinker_book_begin_before_blows(keeper, state);
    else
        tinker_book_add_motion(keeper, state, start ? 0 : end ? 1 : -1);
    if (node->kind == TINKER_NODE_INSIDE || end) {
        double judged[TINKER_BOOK_FUNCTIONS];
        tinker_book_add_forces(keeper, state, node->weight, end, judged);
        if (!end)
            tinker_book_panel_take(&g_array_index(keeper->panels, TinkerBookPanel, node->panel), node->point, judged);
    }
    if (node->kind == TINKER_NODE_BEFORE || node->kind == TINKER_NODE_AFTER)
        tinker_book_look_for_jumps(keeper, state, node->kind == TINKER_NODE_AFTER ? node->since : INFINITY);
    for (guint i = 0; end && i < state->bodies->len; i++) {
        const TinkerBodyState *at = &g_array_index(state->bodies, TinkerBodyState, i);
        const TinkerBookBody *body = tinker_book_body(keeper, at->block);
        for (int axis = 0; body != NULL && axis < 2; axis++)
            keeper->books->rate[axis] += body->mass * at->acceleration[axis];
    }
    return TRUE;
}

static void instant_free(void *data)
{
    g_free(((TinkerBookInstant *)data)->blocks);
    g_free(data);
}

/* (transfer full) */
static GPtrArray *instants_of(TinkerSimulation *simulation)
{
    const GPtrArray *events = tinker_simulation_summary(simulation)->events;
    GPtrArray *instants = g_ptr_array_new_with_free_func(instant_free);
    for (guint i = 0; i < events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(events, i);
        TinkerBookInstant *instant = g_new(TinkerBookInstant, 1);
        *instant = (TinkerBookInstant){event->time, g_strdup(event->blocks)};
        g_ptr_array_add(instants, instant);
    }
    return instants;
}

/* Runs to the last node; what happened is left in `instants` (transfer full), and the step in `step`, 0 where there is
 * no one step (both NULL: nobody asks). */
static gboolean run(TinkerBookKeeper *keeper, const TinkerRunOptions *options, GPtrArray **instants, double *step,
                    GError **error)
{
    TinkerRunOptions with = *options;
    g_autofree double *times = g_new(double, keeper->nodes->len);
    for (guint i = 0; i < keeper->nodes->len; i++)
        times[i] = g_array_index(keeper->nodes, TinkerBookNode, i).time;
    with.at = times;
    with.at_count = keeper->nodes->len;
    with.estimate = with.accuracy > 0;
    with.jolts = keeper->jolts;
    begin_again(keeper);
    keeper->model = tinker_model_new(keeper->scene, error);
    TinkerSimulation *simulation = keeper->model != NULL ? tinker_simulation_new(keeper->model, &with, error) : NULL;
    const TinkerSampleTaker taker = {.sample = look, .begin_again = begin_again, .data = keeper};
    const gboolean done = simulation != NULL && tinker_accurate_run(&simulation, keeper->columns, &taker, error);
    if (done && instants != NULL) *instants = instants_of(simulation);
    if (done && step != NULL) {
        const TinkerSummary *summary = tinker_simulation_summary(simulation);
        *step = summary->adaptive ? 0 : summary->step;
    }
    g_clear_pointer(&simulation, tinker_simulation_free);
    g_clear_pointer(&keeper->model, tinker_model_free);
    return done;
}

static gint by_value(gconstpointer a, gconstpointer b)
{
    const double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* Every instant at which a force may jump, behind the start of the interval up to its end: breaks of waveforms and
 * laws, events. What happens at the end itself is of the interval, whose last state is the one behind it. Element:
 * TinkerBookCut. (transfer full) */
static GArray *cuts_of(TinkerScene *scene, const TinkerBooks *books, const GPtrArray *instants, GError **error)
{
    g_autoptr(TinkerModel) model = tinker_model_new(scene, error);
    if (model == NULL) return NULL;
    g_autoptr(GArray) cuts = g_array_new(FALSE, FALSE, sizeof(double));
    for (guint i = 0; i < instants->len; i++)
        g_array_append_val(cuts, ((TinkerBookInstant *)g_ptr_array_index(instants, i))->time);
    for (double t = tinker_model_next_break(model, books->from, books->to); isfinite(t);
         t = tinker_model_next_break(model, t, books->to))
        g_array_append_val(cuts, t);
    g_array_sort(cuts, by_value);
    const double least = CLOSEST_CUTS * (books->to - books->from);
    GArray *kept = g_array_new(FALSE, FALSE, sizeof(TinkerBookCut));
    for (guint i = 0; i < cuts->len; i++) {
        const double time = g_array_index(cuts, double, i);
        if (time <= books->from || time > books->to) continue;
        TinkerBookCut *last = kept->len > 0 ? &g_array_index(kept, TinkerBookCut, kept->len - 1) : NULL;
        if (last != NULL && time - last->first <= least)
            last->last = time;
        else
            g_array_append_val(kept, ((TinkerBookCut){time, time}));
    }
    return kept;
}

/* Contact as impulses has one force from each step's start to its end, and velocities that go straight between them.
 * (transfer full) */
static GArray *steps_of(const TinkerBooks *books, double step)
{
    GArray *cuts = g_array_new(FALSE, FALSE, sizeof(TinkerBookCut));
    const TinkerTimeGrid grid = tinker_time_grid(step);
    const double least = CLOSEST_CUTS * (books->to - books->from);
    for (gint64 k = (gint64)floor(books->from / step);; k++) {
        const double time = tinker_time_grid_at(&grid, k);
        if (!(books->to - time > least)) return cuts;
        if (time - books->from > least) g_array_append_val(cuts, ((TinkerBookCut){time, time}));
    }
}

/* How far the entries are from those of fewer panels, in units of the scales. */
static double change_of(const TinkerBooks *books, const GArray *before)
{
    if (before == NULL || before->len != books->entries->len) return INFINITY;
    double change = 0;
    for (guint i = 0; i < before->len; i++) {
        const TinkerBookEntry *a = &g_array_index(before, TinkerBookEntry, i),
                              *b = &g_array_index(books->entries, TinkerBookEntry, i);
        const double impulse = hypot(a->all.impulse[0] - b->all.impulse[0], a->all.impulse[1] - b->all.impulse[1]);
        change = fmax(change, fabs(a->all.work - b->all.work) / (books->energy.scale + 1e-300));
        change = fmax(change, impulse / (books->impulse.scale + 1e-300));
        change = fmax(change, fabs(a->all.angular - b->all.angular) / (books->moment.scale + 1e-300));
    }
    return change;
}

/* What the integrals are allowed to be off by, of each of the functions. */
static void allow(const TinkerBooks *books, double allowed[TINKER_BOOK_FUNCTIONS])
{
    allowed[0] = STANDS_STILL * books->energy.scale;
    allowed[1] = allowed[2] = STANDS_STILL * books->impulse.scale;
    allowed[3] = STANDS_STILL * books->moment.scale;
}

/* Where there may be no more panels: how far the integrals do not stand still, by those of fewer panels, or where there
 * were none, by the panels themselves. */
static double unsettled(const TinkerBookKeeper *keeper, const GArray *before)
{
    if (keeper->panels->len < MOST_PANELS) return 0;
    double allowed[TINKER_BOOK_FUNCTIONS];
    allow(keeper->books, allowed);
    const double change = before != NULL ? change_of(keeper->books, before)
                                         : STANDS_STILL * tinker_book_panels_off(keeper->panels, allowed);
    return change > STANDS_STILL ? change : 0;
}

/* Whether panels were made smaller: those whose integrals are off, or, where there are none but the integrals do not
 * stand still from fewer panels to these, all that are wide. */
static gboolean refine(const TinkerBookKeeper *keeper, const GArray *before, int *wide)
{
    const TinkerBooks *books = keeper->books;
    double allowed[TINKER_BOOK_FUNCTIONS];
    allow(books, allowed);
    if (tinker_book_panels_refine(keeper->panels, allowed, MOST_PANELS)) return TRUE;
    if (change_of(books, before) <= STANDS_STILL) return FALSE;
    while (*wide < MOST_PANELS) {
        *wide *= 2;
        if (tinker_book_panels_halve(keeper->panels, (books->to - books->from) / *wide, MOST_PANELS)) return TRUE;
    }
    return FALSE;
}

static gboolean keep(TinkerBookKeeper *keeper, const TinkerRunOptions *options, const GArray *cuts, gboolean jump,
                     GError **error)
{
    const double from = keeper->books->from, to = keeper->books->to;
    g_autoptr(GArray) before = NULL;
    int wide = FIRST_PANELS;
    for (int runs = 0; runs < MOST_RUNS; runs++) {
        g_clear_pointer(&keeper->nodes, g_array_unref);
        keeper->nodes = tinker_book_nodes(from, to, keeper->panels, cuts, jump);
        if (!run(keeper, options, NULL, NULL, error)) return FALSE;
        tinker_book_conclude(keeper);
        keeper->books->unsettled = unsettled(keeper, before);
        if (!refine(keeper, before, &wide)) return TRUE;
        g_clear_pointer(&before, g_array_unref);
        before = g_array_copy(keeper->books->entries);
    }
    return TRUE;
}

static void add_bodies(TinkerBookKeeper *keeper, const TinkerFrame *frame, const TinkerBlockId *bodies)
{
    for (; *bodies >= 0; bodies++) {
        const int32_t block = *bodies;
        const gboolean turns = tinker_block_class_turns(tinker_scene_block_class(keeper->scene, block));
        const TinkerBookBody body = {.block = block,
                                     .mass = tinker_frame_meaning(frame, block, TINKER_MEANING_MASS, 0, 0),
                                     .inertia =
                                         turns ? tinker_frame_meaning(frame, block, TINKER_MEANING_INERTIA, 0, 0) : 0};
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
    g_autoptr(GArray) held = g_array_new(FALSE, TRUE, sizeof(TinkerBookBody)),
                      columns = tinker_model_state_columns(scene);
    g_autoptr(GArray) accounts = g_array_new(FALSE, TRUE, sizeof(TinkerBookAccount)), cuts = NULL,
                      none = g_array_new(FALSE, FALSE, sizeof(TinkerBookCut)), jolts = tinker_jolts_new();
    g_array_set_size(accounts, (guint)tinker_scene_id_limit(scene));
    TinkerBookKeeper keeper = {
        .scene = scene, .books = books, .bodies = held, .accounts = accounts, .columns = columns, .jolts = jolts};
    add_bodies(&keeper, frame, bodies);
    /* once for what happens, and then between that */
    g_autoptr(GPtrArray) instants = NULL;
    double step = 0;
    keeper.panels = tinker_book_panels(from, to, none, 1);
    keeper.nodes = tinker_book_nodes(from, to, keeper.panels, none, FALSE);
    gboolean done = run(&keeper, options, &instants, &step, error);
    keeper.instants = instants;
    const gboolean by_steps = done && options->impulses && step > 0 && (to - from) / step <= MOST_STEPS;
    if (done) cuts = by_steps ? steps_of(books, step) : cuts_of(scene, books, instants, error);
    if (cuts != NULL) {
        g_array_unref(keeper.panels);
        keeper.panels = tinker_book_panels(from, to, cuts, FIRST_PANELS);
    }
    done = cuts != NULL && keep(&keeper, options, cuts, !by_steps, error);
    g_array_unref(keeper.panels);
    g_array_unref(keeper.nodes);
    return done ? g_steal_pointer(&books) : NULL;
}

void tinker_books_free(TinkerBooks *books)
{
    g_array_unref(books->entries);
    g_array_unref(books->impacts);
    g_free(books);
}
