/* Before a run the plan says what will be used and what to expect; from then on the run says what it does. */
#include "gui/document/status-text.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "common/words/plan-words.h"

#define LARGE_ERROR      1e-2 /* of the motion: to be seen in a picture */
#define UNPREDICTABLE    0.1  /* of the motion: what is beyond is not to be believed */
#define LARGE_IMBALANCE  1e-2 /* of the energy exchanged */
#define LARGE_CONSTRAINT 1e-4 /* of the lengths that are held */
#define SLOW_PACE        0.95
#define MOST_REASONS     4

char *tinker_status_size_text(double value, int digits)
{
    if (value == 0) return g_strdup("0");
    gboolean plain = value >= 0.01 && value < pow(10, digits);
    g_autofree char *text = g_strdup_printf(plain ? "%.*g" : "%.*e", plain ? digits : digits - 1, value);
    char *exponent = strchr(text, 'e');
    return exponent != NULL ? g_strdup_printf("%.*se%d", (int)(exponent - text), text, atoi(exponent + 1))
                            : g_steal_pointer(&text);
}

/* How it is run ---------------------------------------------------------------------------------------------------- */

static gboolean is_all_alike(const TinkerPlan *plan)
{
    const TinkerIslandPlan *first = g_ptr_array_index(plan->islands, 0);
    for (guint i = 1; i < plan->islands->len; i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->islands, i);
        if (island->choice.method != first->choice.method || island->choice.step != first->choice.step ||
            island->choice.tolerance != first->choice.tolerance)
            return FALSE;
    }
    return TRUE;
}

static char *planned_text(const TinkerPlanResult *plan)
{
    const TinkerIslandPlan *first = g_ptr_array_index(plan->plan->islands, 0);
    g_autofree char *method = is_all_alike(plan->plan) ? tinker_island_method_text(first)
                                                       : g_strdup_printf(_("%u parts, each by a method of its own"),
                                                                         plan->plan->islands->len);
    return plan->automatic ? g_strdup_printf(_("Automatic: %s"), method) : g_steal_pointer(&method);
}

/* Why, part by part. */
static void add_reasons(GString *text, const TinkerPlanResult *plan)
{
    guint count = plan->plan->islands->len;
    for (guint i = 0; i < MIN(count, MOST_REASONS); i++) {
        const TinkerIslandPlan *island = g_ptr_array_index(plan->plan->islands, i);
        g_autofree char *blocks = tinker_island_blocks_text(plan->scene, island);
        g_autofree char *method = tinker_island_method_text(island);
        g_string_append_printf(text, "\n• %s: %s (%s)", blocks, method, island->reason);
    }
    if (count > MOST_REASONS) g_string_append_printf(text, _("\nand %u more parts"), count - MOST_REASONS);
}

static char *method_tooltip(const TinkerPlanResult *plan)
{
    g_autoptr(GString) text =
        g_string_new(_("How the motion is computed: the method, and how long its steps are or how "
                       "small it keeps the error of each. The page “Accuracy” compares all "
                       "methods on this scene."));
    if (plan != NULL && plan->plan != NULL && plan->plan->islands->len > 0) add_reasons(text, plan);
    return g_string_free(g_steal_pointer(&text), FALSE);
}

static gboolean has_islands(const TinkerPlanResult *plan)
{
    return plan != NULL && plan->plan != NULL && plan->plan->islands->len > 0;
}

static void fill_method(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    const TinkerRunStatus *run = facts->run;
    const TinkerPlanResult *plan = facts->plan;
    gboolean known = run != NULL && run->method[0] != '\0';
    if (known && strcmp(run->method, "auto") != 0) {
        g_autofree char *setting =
            tinker_method_text(run->method, run->adaptive ? 0 : run->step, run->adaptive ? run->tolerance : 0);
        gboolean automatic = plan != NULL && plan->automatic;
        item->text = automatic ? g_strdup_printf(_("Automatic: %s"), setting) : g_steal_pointer(&setting);
    } else if (has_islands(plan)) {
        item->text = planned_text(plan);
    } else if (plan != NULL && plan->error != NULL) {
        item->text = g_strdup(_("Not ready to run"));
        item->tooltip = g_strdup(plan->error->message);
        return;
    }
    if (item->text != NULL) item->tooltip = method_tooltip(plan);
}

/* How well it goes ------------------------------------------------------------------------------------------------- */

static double expected_error(const TinkerPlanResult *plan)
{
    double worst = NAN;
    for (guint i = 0; i < plan->plan->islands->len; i++)
        worst = fmax(worst, ((TinkerIslandPlan *)g_ptr_array_index(plan->plan->islands, i))->expected_error);
    return worst;
}

/* "2e-9", "3 %". */
static char *share_text(double share)
{
    return share >= 0.01 ? g_strdup_printf("%.0f %%", 100 * share) : tinker_status_size_text(share, 1);
}

static void fill_error(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    const char *meaning = _("How far the bodies may be from where they should be, compared with the size of the whole "
                            "motion: 0.01 is one part in a hundred. Smaller steps or tolerances make it smaller.");
    gboolean estimated = facts->run != NULL && !isnan(facts->run->error_estimate);
    gboolean expected = facts->run == NULL && has_islands(facts->plan);
    if (facts->run != NULL && facts->run->estimate_due) {
        item->text = g_strdup(_("error being estimated"));
        item->tooltip = g_strdup(_("While a control is turned, runs go without an estimate of their error, which takes "
                                   "as long again. It is made as soon as the control rests."));
        return;
    }
    if (!estimated && !expected) return;
    double error = estimated ? facts->run->error_estimate : expected_error(facts->plan);
    if (isnan(error)) return;
    g_autofree char *size = share_text(error);
    if (error < TINKER_ROUNDING)
        item->text = g_strdup(_("no error but rounding"));
    else if (estimated && error > UNPREDICTABLE && facts->run->predictable_until < facts->duration)
        item->text = g_strdup_printf(_("predictable up to %.3g s"), facts->run->predictable_until);
    else if (error >= 1)
        item->text =
            g_strdup(estimated ? _("error as large as the motion") : _("error as large as the motion expected"));
    else if (estimated)
        item->text = g_strdup_printf(_("error about %s of the motion"), size);
    else
        item->text = g_strdup_printf(_("error of about %s of the motion expected"), size);
    item->tooltip = g_strdup(meaning);
    item->warning = error > LARGE_ERROR;
}

static void fill_energy(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    if (facts->run == NULL || facts->run->method[0] == '\0') return;
    double error = facts->run->energy_balance_error;
    g_autofree char *size = share_text(error);
    item->text = error < TINKER_ROUNDING ? g_strdup(_("energy balanced"))
                 : isfinite(error)       ? g_strdup_printf(_("energy off by %s"), size)
                                         : g_strdup(_("energy beyond all bounds"));
    item->tooltip =
        g_strdup(_("What enters the system, less what leaves it, should be what it holds. This is how far the "
                   "books are off, compared with the largest energy exchanged: an error that the motion "
                   "has, too."));
    item->warning = !(error <= LARGE_IMBALANCE);
}

static void fill_constraints(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    if (facts->run == NULL || !(facts->run->constraint_error > 0)) return;
    g_autofree char *size = tinker_status_size_text(facts->run->constraint_error, 1);
    item->text = g_strdup_printf(_("lengths held to %s"), size);
    item->tooltip =
        g_strdup(_("What keeps a distance fixed should keep it exactly. This is the largest departure so far, "
                   "compared with the length."));
    item->warning = facts->run->constraint_error > LARGE_CONSTRAINT;
}

/* How far it has got ----------------------------------------------------------------------------------------------- */

static void fill_event(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    if (facts->event == NULL) return;
    g_autofree char *time = tinker_status_size_text(facts->event->time, 4);
    item->text = g_strdup_printf(_("%s s: %s"), time, facts->event->text);
    item->tooltip =
        g_strdup_printf(_("%s\nWhat happened last before the time that is shown. The marks on the time line "
                          "are all such instants."),
                        item->text);
}

static void fill_pace(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    double real = facts->pace * facts->speed;
    if (facts->run == NULL || facts->pace >= SLOW_PACE) return;
    item->text = real < 1 ? g_strdup_printf(_("slower than real time: %.2g×"), real)
                          : g_strdup_printf(_("slower than asked: %.2g×"), real);
    item->tooltip =
        g_strdup(_("The motion takes longer to compute than to happen. It is as accurate as it would be; once "
                   "it is recorded, it plays at any speed."));
    item->warning = TRUE;
}

static void fill_recorded(const TinkerStatusFacts *facts, TinkerStatusItem *item)
{
    if (facts->run == NULL || facts->run->finished) return;
    if (facts->run->looks) {
        item->text =
            g_strdup_printf(_("looking for where it stops: %.1f s of %.4g s"), facts->run->looked, facts->duration);
        item->tooltip =
            g_strdup(_("The scene says when to stop. Where that is has to be found before anything is shown; "
                       "going back to the start gives it up."));
        return;
    }
    item->text = g_strdup_printf(_("recorded to %.1f s of %.4g s"), facts->run->reached, facts->duration);
    item->tooltip =
        g_strdup(_("The motion is computed ahead of what is shown; what is recorded can be looked at again on "
                   "the time line."));
}

void tinker_status_fill(const TinkerStatusFacts *facts, TinkerStatusItem items[TINKER_STATUS_COUNT])
{
    memset(items, 0, TINKER_STATUS_COUNT * sizeof *items);
    fill_method(facts, &items[TINKER_STATUS_METHOD]);
    fill_error(facts, &items[TINKER_STATUS_ERROR]);
    fill_energy(facts, &items[TINKER_STATUS_ENERGY]);
    fill_constraints(facts, &items[TINKER_STATUS_CONSTRAINTS]);
    fill_event(facts, &items[TINKER_STATUS_EVENT]);
    fill_pace(facts, &items[TINKER_STATUS_PACE]);
    fill_recorded(facts, &items[TINKER_STATUS_RECORDED]);
}

void tinker_status_clear(TinkerStatusItem items[TINKER_STATUS_COUNT])
{
    for (int i = 0; i < TINKER_STATUS_COUNT; i++) {
        g_clear_pointer(&items[i].text, g_free);
        g_clear_pointer(&items[i].tooltip, g_free);
    }
}

char *tinker_status_line_text(const TinkerStatusItem items[TINKER_STATUS_COUNT])
{
    GString *line = g_string_new(NULL);
    for (int i = 0; i < TINKER_STATUS_COUNT; i++)
        if (items[i].text != NULL) g_string_append_printf(line, "%s%s", line->len > 0 ? "; " : "", items[i].text);
    return g_string_free(line, FALSE);
}
