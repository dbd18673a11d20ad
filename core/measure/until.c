/* A run is deterministic, and sampling it changes no step. So it is run once with samples at even spacing, up to the
 * first between which a condition came to hold; then again with samples between these two, until they are as near to
 * each other as wanted. Events have their exact times from the run. */
#include "measure/until.h"

#include <math.h>
#include <string.h>

#include "measure/formula.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"

#define POINTS_AN_INTERVAL 8
#define POINTS_A_ROUND     1000
#define MOST_POINTS        10000000
#define NARROW             1e-11 /* s, or of the time */
#define MOST_ROUNDS        8

typedef enum { ROOT, COMPARISON, EVENT } Kind;

typedef struct {
    Kind kind;
    TinkerFormula *left, *right; /* of a root; a comparison is `left` */
    char *event, *block;         /* block NULL: any */
    /* While a run goes on */
    int side;      /* sign of a root's difference when it was last not 0; 0: not yet */
    gboolean idle; /* a comparison has been false */
} Condition;

struct _TinkerUntil {
    TinkerScene *scene;
    GArray *columns;    /* of TinkerColumn */
    GArray *conditions; /* of Condition */
};

static void clear_condition(gpointer data)
{
    Condition *condition = data;
    g_clear_pointer(&condition->left, tinker_formula_free);
    g_clear_pointer(&condition->right, tinker_formula_free);
    g_free(condition->event);
    g_free(condition->block);
}

TinkerUntil *tinker_until_new(TinkerScene *scene)
{
    TinkerUntil *until = g_new0(TinkerUntil, 1);
    until->scene = scene;
    until->columns = tinker_columns_new();
    until->conditions = g_array_new(FALSE, FALSE, sizeof(Condition));
    g_array_set_clear_func(until->conditions, clear_condition);
    return until;
}

void tinker_until_free(TinkerUntil *until)
{
    if (until == NULL) return;
    g_array_unref(until->conditions);
    g_array_unref(until->columns);
    g_free(until);
}

/* Reading ---------------------------------------------------------------------------------------------------------- */

/* The "=" between two expressions, which is no part of a comparison's sign, nor within braces. */
static const char *find_equals(const char *text)
{
    gboolean inside = FALSE;
    for (const char *at = text; *at != '\0'; at++) {
        if (*at == '{' || *at == '}') inside = *at == '{';
        if (inside || *at != '=') continue;
        if (at[1] == '=' || (at > text && strchr("=<>!", at[-1]) != NULL)) continue;
        return at;
    }
    return NULL;
}

static gboolean fail(const char *text, GError **error, const char *why)
{
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME, "\"%s\": %s", text, why);
    return FALSE;
}

static TinkerFormula *read_formula(TinkerUntil *until, const char *whole, const char *text, GError **error)
{
    g_autoptr(GError) reason = NULL;
    TinkerFormula *formula = tinker_formula_new(until->scene, text, until->columns, &reason);
    if (formula == NULL) fail(whole, error, reason->message);
    return formula;
}

static gboolean read_event(TinkerUntil *until, const char *text, Condition *condition, GError **error)
{
    static const char *const kinds[] = {"impact", "rest", "take-off", "stick", "slip",           "reversal",    "end",
                                        "jam",    "taut", "slack",    "jerk",  "direction lost", "bifurcation", NULL};
    const gsize length = strlen(text);
    if (text[length - 1] != ')') return fail(text, error, "it must end with \")\", as in event(impact, Mass 0)");
    g_autofree char *inside = g_strndup(text + strlen("event("), length - strlen("event(") - 1);
    g_auto(GStrv) parts = g_strsplit(inside, ",", 2);
    condition->event = g_strdup(parts[0] != NULL ? g_strstrip(parts[0]) : "");
    if (!g_strv_contains(kinds, condition->event)) {
        const char *nearest = tinker_nearest_word(condition->event, kinds);
        g_autofree char *all = g_strjoinv(", ", (char **)kinds);
        g_autofree char *why =
            nearest != NULL
                ? g_strdup_printf("there is no event \"%s\"; did you mean \"%s\"?", condition->event, nearest)
                : g_strdup_printf("there is no event \"%s\" (there are %s)", condition->event, all);
        return fail(text, error, why);
    }
    if (parts[0] == NULL || parts[1] == NULL) return TRUE;
    condition->block = g_strdup(g_strstrip(parts[1]));
    if (tinker_scene_find_block(until->scene, condition->block) != TINKER_NO_BLOCK) return TRUE;
    g_autofree char *why = g_strdup_printf("the scene has no block \"%s\"", condition->block);
    return fail(text, error, why);
}

static gboolean read_condition(TinkerUntil *until, const char *text, Condition *condition, GError **error)
{
    const char *equals = find_equals(text);
    if (g_str_has_prefix(text, "event(")) {
        condition->kind = EVENT;
        return read_event(until, text, condition, error);
    }
    g_autofree char *left = equals != NULL ? g_strndup(text, (gsize)(equals - text)) : g_strdup(text);
    condition->kind = equals != NULL ? ROOT : COMPARISON;
    condition->left = read_formula(until, text, left, error);
    if (condition->left == NULL) return FALSE;
    if (condition->kind == ROOT) {
        condition->right = read_formula(until, text, equals + 1, error);
        return condition->right != NULL;
    }
    return tinker_formula_is_comparison(condition->left) ||
           fail(text, error, "it is no condition (as in \"{Mass 0.y} = 0\", \"{Mass 0.vx} < 1\" or event(impact))");
}

gboolean tinker_until_add(TinkerUntil *until, const char *text, GError **error)
{
    Condition condition = {0};
    g_autofree char *stripped = g_strstrip(g_strdup(text));
    if (read_condition(until, stripped, &condition, error)) {
        g_array_append_val(until->conditions, condition);
        return TRUE;
    }
    clear_condition(&condition);
    return FALSE;
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerUntil *until;
    double from, to; /* s: between these it came to hold; to INFINITY: not yet */
    int number;      /* of the condition; -1 */
    gboolean events; /* there are conditions that are events */
} Look;

static gboolean comes_to_hold(Condition *condition, double t, const double *values)
{
    const double left = tinker_formula_value(condition->left, t, values);
    if (condition->kind == COMPARISON) {
        const gboolean holds = left != 0, now = holds && condition->idle;
        condition->idle = condition->idle || !holds;
        return now;
    }
    const double difference = left - tinker_formula_value(condition->right, t, values);
    const int side = (difference > 0) - (difference < 0), before = condition->side;
    if (side != 0) condition->side = side;
    return before != 0 && side != before;
}

/* The first event of the kind after the start; INFINITY. */
static double time_of_event(const TinkerSummary *summary, const Condition *condition)
{
    for (guint i = 0; i < summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(summary->events, i);
        g_auto(GStrv) blocks = g_strsplit(event->blocks != NULL ? event->blocks : "", ", ", -1);
        if (event->time > 0 && strcmp(event->kind, condition->event) == 0 &&
            (condition->block == NULL || g_strv_contains((const char *const *)blocks, condition->block)))
            return event->time;
    }
    return INFINITY;
}

static gboolean look(TinkerSimulation *simulation, double t, const double *values, void *data, GError **error)
{
    Look *self = data;
    const TinkerSummary *summary = self->events ? tinker_simulation_summary(simulation) : NULL;
    double first = INFINITY;
    for (guint i = 0; i < self->until->conditions->len; i++) {
        Condition *condition = &g_array_index(self->until->conditions, Condition, i);
        const double at = condition->kind == EVENT              ? time_of_event(summary, condition)
                          : comes_to_hold(condition, t, values) ? t
                                                                : INFINITY;
        if (!(at <= t) || !(at < first)) continue;
        first = at;
        self->number = (int)i;
    }
    if (isinf(first)) {
        self->from = t;
        return TRUE;
    }
    /* an event lies before the sample that tells of it, and is exact */
    if (first < t) self->from = first;
    self->to = first;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, "found");
    return FALSE;
}

/* Runs with these samples, up to the first at which a condition holds. */
static gboolean run_once(Look *self, TinkerModel *model, TinkerRunOptions options, const GArray *times, GError **error)
{
    g_autoptr(GError) failure = NULL;
    options.at = (const double *)(gconstpointer)times->data;
    options.at_count = times->len;
    options.estimate = options.bands = FALSE;
    options.accuracy = 0;
    for (guint i = 0; i < self->until->conditions->len; i++) {
        Condition *condition = &g_array_index(self->until->conditions, Condition, i);
        condition->side = 0;
        condition->idle = FALSE;
    }
    self->number = -1;
    self->from = 0;
    self->to = INFINITY;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    (void)tinker_simulation_run(simulation, self->until->columns, look, self, &failure);
    if (self->number >= 0 || !g_error_matches(failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED)) return TRUE;
    g_propagate_error(error, g_steal_pointer(&failure));
    return FALSE;
}

/* 0, and points from `from` on to `to`. */
static GArray *spread(double from, double to, gsize count)
{
    GArray *times = g_array_new(FALSE, FALSE, sizeof(double));
    const double start = 0;
    g_array_append_val(times, start);
    for (gsize i = 0; i <= count; i++) {
        const double t = i == count ? to : from + (to - from) * ((double)i / (double)count);
        if (t > g_array_index(times, double, times->len - 1)) g_array_append_val(times, t);
    }
    return times;
}

gboolean tinker_until_find(TinkerUntil *until, TinkerModel *model, const TinkerRunOptions *options, double *time,
                           int *number, GError **error)
{
    Look found = {.until = until};
    const double duration = tinker_options_duration(options);
    gsize count = (gsize)fmin(ceil(POINTS_AN_INTERVAL * duration / options->interval), MOST_POINTS);
    double from = 0, to = duration;
    for (guint i = 0; i < until->conditions->len; i++)
        found.events |= g_array_index(until->conditions, Condition, i).kind == EVENT;
    for (int round = 0; round < MOST_ROUNDS; round++) {
        g_autoptr(GArray) times = spread(from, to, MAX(count, 1));
        if (!run_once(&found, model, *options, times, error)) return FALSE;
        *time = found.to;
        *number = found.number;
        from = found.from;
        to = found.to;
        count = POINTS_A_ROUND;
        if (!(to - from > NARROW * fmax(1, to)) || isinf(to)) break;
    }
    return TRUE;
}
