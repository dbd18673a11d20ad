/* Impacts at an event. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/jolts.h"
#include "physics/contact/contacts.h"
#include "physics/contact/tolerances.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/force/forces.h"
#include "physics/model/model.h"
#include "physics/model/points.h"

/* Notes what a contact that no row stands for gives, each of the two by the other. */
static void note_touch(const TinkerContactChange *change, const TinkerContact *contact, double pn, double pt)
{
    const TinkerModel *model = change->model;
    const TinkerIslandRun *run = change->run->run;
    const TinkerPlate *plate = &change->contacts->plates[contact->plate];
    const double t = run->state.t, *n = plate->normal;
    if (plate->gap == NULL) {
        tinker_jolts_add(run->jolts, model, t, plate->block, 2 * contact->body, pn * n[0] + pt * n[1]);
        tinker_jolts_add(run->jolts, model, t, plate->block, 2 * contact->body + 1, pn * n[1] - pt * n[0]);
        return;
    }
    TinkerContactEntries entries;
    tinker_contact_gap_entries(change->contacts, contact->plate, &entries);
    const int32_t first = plate->pair->point[0];
    for (int32_t k = 0; k < entries.count; k++) {
        const gboolean is_first = tinker_model_moved_by(model, entries.coordinate[k]) == first;
        tinker_jolts_add(run->jolts, model, t, is_first ? plate->block : model->body_blocks[first],
                         entries.coordinate[k], pn * entries.row[0][k] + pt * entries.row[1][k]);
    }
}

/* Notes what contacts, ropes and the joints that answer to them give. */
static void note_jolts(const TinkerContactChange *change, const double *impulses)
{
    TinkerModel *model = change->model;
    TinkerConstraints *all = &model->constraints;
    const TinkerIslandRun *run = change->run->run;
    const gsize bytes = (gsize)model->coordinates * sizeof(double);
    g_autofree double *given = g_malloc0(bytes);
    tinker_contacts_begin_pushes(change->contacts);
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const double pn = impulses[2 * i], pt = impulses[2 * i + 1];
        if (pn == 0 && pt == 0) continue;
        if (at->row >= 0) {
            tinker_jolts_add_pull(run->jolts, model, run->state.t, at->row, -pn, given);
            continue;
        }
        note_touch(change, &at->contact, pn, pt);
        tinker_contacts_push_along(change->contacts, &at->contact, pn, pt, given);
    }
    if (all->rows == 0) return;
    memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
    memcpy(all->by_point, given, bytes);
    tinker_constraints_answer(model, given);
    tinker_jolts_add_rows(run->jolts, model, run->state.t);
}

/* Where supports move these give what contacts do not take, and else drives, which hold their speed against a blow;
 * without either it is rounding. */
static TinkerBook book_of_rest(const TinkerModel *model)
{
    if (model->moving_supports > 0) return TINKER_BOOK_SUPPORT_MOTION;
    return model->constraints.prescribed ? TINKER_BOOK_MOTORS : TINKER_BOOK_CONTACTS;
}

/* What contacts take goes into their book, the rest is by what moves. */
gboolean tinker_change_push_all(TinkerContactChange *change, const double *impulses)
{
    TinkerModel *model = change->model;
    TinkerContactRun *self = change->run;
    double *v = self->run->state.v, *work = self->run->system.impact_work;
    g_autofree double *before = g_memdup2(v, (gsize)model->coordinates * sizeof(double));
    g_autofree TinkerContactPlace *was = g_new(TinkerContactPlace, change->touches->len);
    for (guint i = 0; i < change->touches->len; i++)
        was[i] = tinker_touch(change, i)->place;
    tinker_change_push(change, impulses, v);
    if (self->run->jolts != NULL) note_jolts(change, impulses);
    if (tinker_change_set_state(change) != TINKER_OK) return FALSE;
    tinker_change_measure(change);
    double rest = tinker_model_kinetic_change(model, before, v);
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerContactPlace *is = &tinker_touch(change, i)->place;
        double taken = 0.5 * impulses[2 * i] * (was[i].normal_speed + is->normal_speed) +
                       0.5 * impulses[2 * i + 1] * (was[i].tangential_speed + is->tangential_speed);
        work[TINKER_BOOK_CONTACTS] += taken;
        rest -= taken;
    }
    work[book_of_rest(model)] += rest;
    self->last_impact = self->run->state.t;
    return TRUE;
}

/* Whether something else that touches at the instant takes energy, by its restitution or by rubbing. */
static gboolean is_braked(const TinkerContactChange *change, guint number)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerSurface surface = tinker_touch_surface(change, i);
        if (i != number && (surface.restitution < 1 || surface.dynamic_friction > 0)) return TRUE;
    }
    return FALSE;
}

/* Rebounds below this (m/s) are none. Without any loss along the normal a bounce that leaves the top by more than
 * rounding never ends, but where something else takes energy: friction, to and fro between rough plates, a damper or
 * the air on the way, or what lies on the body that bounces, which presses it back ever sooner. */
static double least_rebound(const TinkerContactChange *change, guint number)
{
    const TinkerSurface surface = tinker_touch_surface(change, number);
    if (surface.restitution < 1 || is_braked(change, number))
        return fmax(TINKER_LEAST_REBOUND * change->speed, change->least_rise);
    gboolean between = change->run->neighbours.lists[tinker_touch(change, number)->contact.body]->len > 1;
    gboolean damped = change->model->lines.any_damping || change->model->field_drag != 0;
    const gboolean ends = damped || (between && surface.dynamic_friction > 0);
    return fmax(ends ? TINKER_LEAST_REBOUND * change->speed : 0, change->least_flight);
}

/* Parts, but too slowly to be seen. */
static gboolean lingers(const TinkerContactChange *change, guint number)
{
    double speed = tinker_touch(change, number)->place.normal_speed;
    return speed > TINKER_STILL * change->speed && speed < least_rebound(change, number);
}

static gboolean rests(const TinkerContactChange *change, guint number)
{
    return !tinker_touch_resists(change, number) &&
           tinker_touch(change, number)->place.normal_speed < least_rebound(change, number);
}

/* Rests, and slides too slowly to be seen: the impulse that stops it is told as the blow's. */
static gboolean creeps(const TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const gboolean moves = fabs(at->place.tangential_speed) > TINKER_STILL * change->speed;
    return at->row < 0 && moves && rests(change, number) && tinker_touch_surface(change, number).static_friction > 0 &&
           tinker_change_hardly_slides(change, at);
}

/* Marks the speeds that are to be taken away, two a contact; answers whether any of them is more than rounding. */
static gboolean mark_stopped(const TinkerContactChange *change, int8_t *stopped)
{
    gboolean any = FALSE;
    for (guint i = 0; i < change->touches->len; i++) {
        stopped[2 * i] = rests(change, i);
        stopped[2 * i + 1] = creeps(change, i);
        any |= lingers(change, i) || stopped[2 * i + 1];
    }
    return any;
}

/* The impulses that take the marked speeds away, in `answers`. FALSE: no memory. */
static gboolean stop_by_matrix(TinkerContactLaws *laws, const int8_t *stopped)
{
    const gsize width = 2 * laws->count;
    g_autofree double *matrix = g_try_new(double, width *width);
    TinkerDenseSolve *solve = tinker_dense_solve_new((int32_t)width);
    const gboolean enough = matrix != NULL && solve != NULL;
    for (gsize i = 0; enough && i < width * width; i++)
        matrix[i] = stopped[i / width] && stopped[i % width] ? laws->delassus[i] : i / width == i % width;
    for (gsize i = 0; enough && i < width; i++)
        laws->answers[i] = stopped[i] ? laws->pairs[i] : 0;
    if (enough) {
        tinker_dense_solve_factor(solve, matrix);
        tinker_dense_solve(solve, laws->answers);
    }
    tinker_dense_solve_free(solve);
    return enough;
}

static gboolean stop_by_solve(TinkerContactLaws *laws, const int8_t *stopped)
{
    const gsize width = 2 * laws->count;
    g_autofree double *left = g_try_new(double, 2 * width);
    if (left == NULL) return FALSE;
    laws->motion->solve(laws->motion->context, stopped, laws->first, laws->pairs, laws->answers, left, left + width);
    return TRUE;
}

/* Bodies that constraints couple may strike by turns, each blow throwing up the other less and less, infinitely often
 * in finite time: what parts too slowly to be seen does not part, and what slides so does not slide. Taking speeds away
 * takes energy only. */
static gboolean settle(TinkerContactChange *change)
{
    const gsize m = change->touches->len;
    g_auto(TinkerContactLaws) laws = {0};
    g_autofree int8_t *stopped = g_new0(int8_t, 2 * m);
    if (!mark_stopped(change, stopped)) return TRUE;
    if (tinker_contact_laws_init(&laws, change) != TINKER_OK) return FALSE;
    for (guint i = 0; i < m; i++) {
        laws.pairs[2 * i] = -tinker_touch(change, i)->place.normal_speed;
        laws.pairs[2 * i + 1] = -tinker_touch(change, i)->place.tangential_speed;
    }
    if (!(laws.motion != NULL ? stop_by_solve(&laws, stopped) : stop_by_matrix(&laws, stopped))) {
        tinker_contacts_lack_memory(change->contacts, m);
        return FALSE;
    }
    return tinker_change_push_all(change, laws.answers);
}

/* Whether something does so faster than this share of what speeds are measured by. */
static gboolean approaches(const TinkerContactChange *change, double share)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->place.normal_speed <
            -share * tinker_change_speed_scale(change, tinker_touch(change, i)))
            return TRUE;
    return FALSE;
}

/* A rebound that would be too slow to be seen is none: else infinitely many follow. Of blows that follow on one another
 * by turns each takes a share of what is left of the speeds that close: infinitely many leave none, as one without
 * rebound does, since all of them act along the same directions. */
static double seen_restitution(const TinkerContactChange *change, guint number, double approach)
{
    const double e = tinker_touch_surface(change, number).restitution;
    const gboolean unseen = e * approach < least_rebound(change, number);
    return unseen || (change->rattles && e < 1) ? 0 : e;
}

/* How fast the fastest approach. */
static double fastest_approach(const TinkerContactChange *change)
{
    double fastest = 0;
    for (guint i = 0; i < change->touches->len; i++)
        fastest = fmax(fastest, -tinker_touch(change, i)->place.normal_speed);
    return fastest;
}

/* Whether something goes on closing after the impact. */
static gboolean is_squeezed(const TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->place.normal_speed < -TINKER_SQUEEZED * change->speed) return TRUE;
    return FALSE;
}

static gboolean refuse_squeezed(TinkerContactChange *change, GError **error)
{
    TinkerScene *scene = change->model->scene;
    g_autofree char *why = g_strdup_printf(
        _("%s is squeezed: it is held from both sides by what closes on it, and no motion leaves it room (give the "
          "supports motions that do)"),
        tinker_scene_block_name(scene, change->model->body_blocks[tinker_touch(change, 0)->contact.body]));
    return tinker_change_refuse(change, why, error);
}

static void drop_leaving(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        at->dropped = at->leaves && !at->struck;
    }
    tinker_change_drop(change);
}

/* What was met at rounding below its plate while it parts from it, too slowly to be seen: met again at once. */
static gboolean is_met_parting(const TinkerContactChange *change)
{
    for (guint i = 0; change->trigger.kind == TINKER_TRIGGER_GAP && i < change->touches->len; i++)
        if (tinker_change_is_trigger(change, tinker_touch(change, i))) return lingers(change, i);
    return FALSE;
}

/* How well places are known behind a blow (m): what had just opened and is thrown back is put onto its plate from the
 * little that it was away, which moves what it touches by as much; that is met so far below its plate. */
static double place_noise(const TinkerContactChange *change)
{
    double noise = fmax(change->tolerance, tinker_contact_run_place_noise(change->run));
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->leaves || tinker_change_is_trigger(change, at)) noise = fmax(noise, fabs(at->place.gap));
    }
    return noise;
}

/* What rises to no more than the tolerance, or than the method resolves, by the accelerations that act. */
static gboolean note_least_rise(TinkerContactChange *change, double *pairs)
{
    double scale;
    if (!tinker_change_accelerations(change, pairs, &scale)) return FALSE;
    change->least_flight = 2 * sqrt(scale * change->tolerance);
    change->least_rise = 2 * sqrt(scale * place_noise(change));
    return TRUE;
}

/* Whether the impulse on a touch is more than rounding. */
static gboolean is_struck(const TinkerContactChange *change, guint number, const double *impulses)
{
    const double by_mass = change->model->inverse_mass[tinker_touch(change, number)->contact.body];
    return !tinker_touch_resists(change, number) && impulses[2 * number] * by_mass > TINKER_STILL * change->speed;
}

/* Sets of bodies that joints tie together, and contacts and ropes that are struck. */
static void find_sets(const TinkerContactChange *change, const double *impulses, int32_t *sets)
{
    const TinkerModel *model = change->model;
    const gboolean *unilateral = model->constraints.unilateral;
    tinker_sets_begin(sets, model->bodies);
    for (int32_t row = 0; row < model->constraints.rows; row++)
        if (unilateral == NULL || !unilateral[row]) tinker_contacts_tie(model, row, sets);
    for (guint i = 0; impulses != NULL && i < change->touches->len; i++) {
        if (!is_struck(change, i, impulses)) continue;
        const TinkerTouch *at = tinker_touch(change, i);
        const TinkerTouchingPair *pair = at->row < 0 ? tinker_touch_plate(change, i)->pair : NULL;
        if (at->row >= 0) tinker_contacts_tie(model, at->row, sets);
        if (pair != NULL && pair->point[1] < model->bodies) tinker_sets_join(sets, pair->point[0], pair->point[1]);
    }
}

/* Tells, once, of the first pin that a blow passes without its friction: one of what is tied to what blocks or contacts
 * strike. `impulses`: of contacts; NULL: there are none. */
static void warn_of_pins(TinkerContactChange *change, const double *impulses)
{
    const TinkerModel *model = change->model;
    TinkerIslandRun *run = change->run->run;
    if (change->contacts->pin_count == 0 || change->run->warned_pins) return;
    g_autofree int32_t *sets = g_new(int32_t, model->bodies);
    g_autofree gboolean *struck = g_new0(gboolean, model->bodies);
    find_sets(change, impulses, sets);
    for (guint i = 0; impulses != NULL && i < change->touches->len; i++)
        if (is_struck(change, i, impulses))
            struck[tinker_sets_first(sets, tinker_touch(change, i)->contact.body)] = TRUE;
    for (int32_t c = 0; change->run->given != NULL && c < model->coordinates; c++)
        if (change->run->given[c] != 0) struck[tinker_sets_first(sets, tinker_model_moved_by(model, c))] = TRUE;
    for (guint i = 0; i < change->touches->len && !change->run->warned_pins; i++) {
        if (!tinker_touch_is_pin(change, i) || !struck[tinker_sets_first(sets, tinker_touch(change, i)->contact.body)])
            continue;
        const int32_t row = tinker_touch_plate(change, i)->joint_row;
        change->run->warned_pins = TRUE;
        tinker_summary_warn_of_scene(
            &run->summary,
            g_strdup_printf(_("%s: its friction takes no part in the blow at %.6g s, which passes it as "
                              "if it were smooth: what follows is the motion without that"),
                            tinker_scene_block_name(model->scene, model->constraints.blocks[row]), run->state.t));
    }
}

/* Notes, once, which side of a line is touched where bodies strike, whether that takes an impulse or not. A corner is
 * on one side alone, the one noted first, until it is clear of the line. */
static void note_side(TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerGapFunction *gap = at->row < 0 ? tinker_touch_plate(change, number)->gap : NULL;
    GArray *struck = change->run->struck;
    if (gap == NULL || gap->reverse == 0) return;
    for (guint i = 0; i < struck->len; i++) {
        const int32_t plate = g_array_index(struck, int32_t, i);
        if (plate == at->contact.plate || plate == at->contact.plate + gap->reverse) return;
    }
    g_array_append_val(struck, at->contact.plate);
}

/* The impact itself; `again`: what is left of it, without any rebound. */
static gboolean strike(TinkerContactChange *change, gboolean again, GError **error)
{
    g_auto(TinkerContactLaws) laws = {0};
    if (tinker_contact_laws_init(&laws, change) != TINKER_OK)
        return tinker_change_refuse(change, change->model->failure, error);
    const double fastest = fastest_approach(change);
    /* what closes then did not approach before, and does not rebound by Newton's law */
    const gboolean driven_by_block = change->trigger.kind == TINKER_TRIGGER_BLOW;
    g_autofree double *driven = g_new(double, MAX(laws.count, 1)); /* as fast as anything approaches, at most */
    for (guint i = 0; i < laws.count; i++) {
        const TinkerContactPlace *place = &tinker_touch(change, i)->place;
        laws.pairs[2 * i] = place->normal_speed;
        laws.pairs[2 * i + 1] = place->tangential_speed;
        laws.first[i] = again || driven_by_block ? 0 : seen_restitution(change, i, -place->normal_speed);
        driven[i] = again ? 0 : seen_restitution(change, i, fastest);
        /* the friction of a pin is left out of blows */
        laws.second[i] = tinker_touch_is_pin(change, i) ? 0 : tinker_touch_surface(change, i).dynamic_friction;
    }
    TinkerImpact impact = {(int32_t)laws.count, laws.delassus, laws.pairs, laws.first, laws.second, NULL,
                           laws.motion,         laws.bearer,   driven};
    g_autofree int32_t *pair = g_new(int32_t, laws.count);
    const int32_t pairs = tinker_change_number_pairs(change, pair);
    const TinkerContactResult result = tinker_impact_by_law(change->contacts->impact_law, &impact, pair, laws.answers);
    if (result != TINKER_CONTACT_SOLVED)
        return tinker_change_refuse_laws(
            change, result, _("no impulses satisfy the laws of impact for all bodies that touch there"), error);
    if (pairs > 1 && !again) tinker_change_note_alternatives(change, &impact, pair, laws.answers);
    for (guint i = 0; i < laws.count; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        const guint bearer = tinker_touch_bearer(change, i);
        at->struck |= laws.answers[2 * bearer] > 0;
        if (laws.answers[2 * i] > 0) at->contact.normal = laws.answers[2 * i];
        note_side(change, i);
    }
    warn_of_pins(change, laws.answers);
    if (!tinker_change_push_all(change, laws.answers))
        return tinker_change_refuse(change, change->model->failure, error);
    return !is_squeezed(change) || refuse_squeezed(change, error);
}

gboolean tinker_change_strike(TinkerContactChange *change, GError **error)
{
    const gboolean blow = approaches(change, TINKER_STILL);
    if (!blow && change->trigger.kind == TINKER_TRIGGER_BLOW) warn_of_pins(change, NULL);
    if (blow || change->trigger.kind == TINKER_TRIGGER_GAP) {
        g_autofree double *pairs = g_new(double, 2 * change->touches->len + 1);
        if (!note_least_rise(change, pairs)) return tinker_change_refuse(change, change->model->failure, error);
    }
    if (blow && !strike(change, FALSE, error)) return FALSE;
    if ((blow || is_met_parting(change)) && !settle(change))
        return tinker_change_refuse(change, change->model->failure, error);
    if (blow && approaches(change, TINKER_SAME_SPEED) && !strike(change, TRUE, error)) return FALSE;
    drop_leaving(change);
    return TRUE;
}
