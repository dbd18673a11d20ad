/* While a run is under way, a timer looks after it: it applies what waits, and has the window look at the record. Runs
 * of a hand that turns have no companion; once it rests, the player makes the last one again with it. */
#include "gui/instrument/hand.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/text/sentence.h"

#define PATIENCE 0.25 /* s that a run has before the next may take its place */
#define LOOK     5    /* ms */
#define REST     0.3  /* s without a turn: then the hand rests */

struct _TinkerHand {
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerBlockId block; /* of what was set last */
    char *name;
    double value;
    double partner; /* what belongs to it was before the number was turned; NAN: nothing */
    double given;   /* what the hand made of that last */
    gboolean waits, shown_whole;
    gboolean begins; /* it has let go since */
    guint steps;     /* of undo, so far */
    gint64 began_us; /* the run; 0: none is looked after */
    gint64 set_us;   /* when a value was set last */
    double rate;
    char *problem;
    guint timer;
};

/* Friction where it slides is at most that at rest, whatever is turned of the two. The column of the other one, and
 * which way it has to give; -1 of any other number. */
static int32_t find_partner(const TinkerBlockClass *block_class, const TinkerNumber *number, int32_t *property,
                            gboolean *is_lower)
{
    const gboolean slides = number->type->meaning == TINKER_MEANING_DYNAMIC_FRICTION;
    if (!slides && number->type->meaning != TINKER_MEANING_STATIC_FRICTION) return -1;
    *is_lower = !slides;
    *property = block_class->meanings[slides ? TINKER_MEANING_STATIC_FRICTION : TINKER_MEANING_DYNAMIC_FRICTION];
    return *property >= 0 ? block_class->first_columns[*property] : -1;
}

/* What belongs to the number that was turned last, or -1: its column and property. */
static int32_t partner_of(TinkerHand *hand, int32_t *property)
{
    TinkerScene *scene = tinker_document_scene(hand->document);
    TinkerNumber number;
    gboolean is_lower;
    if (hand->name == NULL || !tinker_scene_has_block(scene, hand->block) ||
        !tinker_scene_find_number(scene, hand->block, hand->name, &number))
        return -1;
    return find_partner(tinker_scene_block_class(scene, hand->block), &number, property, &is_lower);
}

/* A hand that lets go and takes the same control again still brings the partner back to where it was at first, unless
 * something else has set it since. */
static void note_partner(TinkerHand *hand, gboolean same)
{
    int32_t property;
    const int32_t column = partner_of(hand, &property);
    const double now = column >= 0 ? tinker_scene_get(tinker_document_scene(hand->document), hand->block, column) : NAN;
    if (same && now == hand->given) return;
    hand->partner = hand->given = now;
}

static gboolean set_number(TinkerHand *hand, TinkerScene *scene, const TinkerNumber *number, GError **error)
{
    double values[2] = {hand->value, hand->value};
    if (number->type->kind == TINKER_KIND_VECTOR)
        values[1 - number->component] =
            tinker_scene_get(scene, hand->block, number->column + (number->component == 0 ? 1 : -1));
    return tinker_history_set(tinker_document_history(hand->document), hand->block, number->property, values, error);
}

/* The partner goes along as far as it has to, and comes back as far as it was: before the number or after it, so that
 * neither is ever on the wrong side of the other. */
static gboolean set_both(TinkerHand *hand, TinkerScene *scene, const TinkerNumber *number, GError **error)
{
    int32_t property;
    gboolean is_lower;
    const int32_t column = find_partner(tinker_scene_block_class(scene, hand->block), number, &property, &is_lower);
    if (column < 0 || isnan(hand->partner)) return set_number(hand, scene, number, error);
    TinkerHistory *history = tinker_document_history(hand->document);
    const double before = tinker_scene_get(scene, hand->block, column);
    const double wanted = is_lower ? fmin(hand->partner, hand->value) : fmax(hand->partner, hand->value);
    const gboolean gives_way = is_lower ? wanted < before : wanted > before;
    hand->given = wanted;
    if (gives_way && !tinker_history_set(history, hand->block, property, &wanted, error)) return FALSE;
    return set_number(hand, scene, number, error) &&
           (wanted == before || gives_way || tinker_history_set(history, hand->block, property, &wanted, error));
}

static void apply(TinkerHand *hand)
{
    TinkerScene *scene = tinker_document_scene(hand->document);
    TinkerNumber number;
    g_autoptr(GError) error = NULL;
    hand->waits = FALSE;
    if (!tinker_scene_has_block(scene, hand->block) ||
        !tinker_scene_find_number(scene, hand->block, hand->name, &number))
        return;
    g_autofree char *title = g_strdup_printf(_("Turn %s"), tinker_scene_block_name(scene, hand->block));
    g_autofree char *merge = g_strdup_printf("hand %u", hand->steps);
    g_clear_pointer(&hand->problem, g_free);
    tinker_document_begin(hand->document, title, merge);
    if (!set_both(hand, scene, &number, &error)) {
        tinker_document_abort(hand->document);
        hand->problem = tinker_with_titles(error->message, tinker_scene_block_class(scene, hand->block));
        return;
    }
    tinker_player_begin_trial(hand->player);
    hand->began_us = g_get_monotonic_time();
    hand->shown_whole = FALSE;
    tinker_document_end(hand->document);
    tinker_player_end_trial(hand->player);
}

/* Whether the run that was begun last is over, or has had its time. */
static gboolean may_run(TinkerHand *hand, gboolean *over)
{
    TinkerRunStatus status;
    const double elapsed = 1e-6 * (double)(g_get_monotonic_time() - hand->began_us);
    *over = !tinker_player_status(hand->player, &status) || status.finished;
    if (hand->began_us == 0) return TRUE;
    if (*over || elapsed >= PATIENCE) hand->rate = 1 / MAX(elapsed, 1e-3);
    return *over || elapsed >= PATIENCE;
}

static gboolean is_turning(const TinkerHand *hand)
{
    return 1e-6 * (double)(g_get_monotonic_time() - hand->set_us) < REST;
}

static gboolean look(gpointer data)
{
    TinkerHand *hand = data;
    gboolean over;
    const gboolean may = may_run(hand, &over);
    if (over) hand->began_us = 0;
    if (hand->waits && may) {
        apply(hand);
        over = FALSE;
    }
    if (!over || hand->waits) {
        tinker_player_refresh(hand->player);
        return G_SOURCE_CONTINUE;
    }
    if (!hand->shown_whole) tinker_player_refresh(hand->player);
    hand->shown_whole = TRUE;
    if (is_turning(hand) || tinker_player_estimate(hand->player)) return G_SOURCE_CONTINUE;
    hand->timer = 0;
    return G_SOURCE_REMOVE;
}

void tinker_hand_set(TinkerHand *hand, TinkerBlockId block, const char *name, double value)
{
    gboolean over;
    const gboolean other = hand->name == NULL || block != hand->block || !g_str_equal(name, hand->name);
    if (other) {
        hand->steps++;
        g_free(hand->name);
        hand->name = g_strdup(name);
    }
    hand->block = block;
    if (other || hand->begins) note_partner(hand, !other);
    hand->begins = FALSE;
    hand->value = value;
    hand->waits = TRUE;
    hand->set_us = g_get_monotonic_time();
    if (hand->timer != 0) return; /* which will see to it */
    if (may_run(hand, &over)) apply(hand);
    hand->timer = g_timeout_add(LOOK, look, hand);
}

void tinker_hand_let_go(TinkerHand *hand)
{
    if (hand->waits) apply(hand);
    hand->steps++;
    hand->begins = TRUE;
}

gboolean tinker_hand_wanted(TinkerHand *hand, TinkerBlockId block, const char *name, double *value)
{
    if (!hand->waits || block != hand->block || !g_str_equal(name, hand->name)) return FALSE;
    *value = hand->value;
    return TRUE;
}

double tinker_hand_rate(TinkerHand *hand)
{
    return hand->rate;
}

const char *tinker_hand_problem(TinkerHand *hand)
{
    return hand->problem;
}

gboolean tinker_hand_carried(TinkerHand *hand, TinkerBlockId block, const char *name, TinkerCarried *carried)
{
    if (block != hand->block || g_strcmp0(name, hand->name) != 0 || hand->waits) return FALSE;
    const int32_t column = partner_of(hand, &carried->property);
    if (column < 0) return FALSE;
    carried->before = hand->partner;
    carried->now = tinker_scene_get(tinker_document_scene(hand->document), block, column);
    return carried->now == hand->given && carried->now != carried->before;
}

/* Another scene: what waits was for the last one. */
static void on_replaced(TinkerHand *hand)
{
    hand->waits = FALSE;
    hand->rate = 0;
    g_clear_pointer(&hand->name, g_free);
    g_clear_pointer(&hand->problem, g_free);
}

TinkerHand *tinker_hand_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerHand *hand = g_new0(TinkerHand, 1);
    hand->document = g_object_ref(document);
    hand->player = g_object_ref(player);
    hand->block = TINKER_NO_BLOCK;
    g_signal_connect_swapped(document, "replaced", G_CALLBACK(on_replaced), hand);
    return hand;
}

void tinker_hand_free(TinkerHand *hand)
{
    if (hand == NULL) return;
    g_clear_handle_id(&hand->timer, g_source_remove);
    g_signal_handlers_disconnect_by_data(hand->document, hand);
    g_object_unref(hand->document);
    g_object_unref(hand->player);
    g_free(hand->name);
    g_free(hand->problem);
    g_free(hand);
}
