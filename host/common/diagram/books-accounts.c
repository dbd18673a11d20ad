/* What each account is made of, and what of it is rounding. */
#include "common/diagram/books-accounts.h"

#include <glib/gi18n.h>
#include <math.h>

#include "equations/state/model-state.h"

static void entry_clear(gpointer data)
{
    g_free(((TinkerAccountEntry *)data)->name);
}

static double given(const TinkerBookShare *share, TinkerAccountKind which)
{
    switch (which) {
    case TINKER_ACCOUNT_FORCE_X:
    case TINKER_ACCOUNT_FORCE_Y:
        return share->force[which - TINKER_ACCOUNT_FORCE_X];
    case TINKER_ACCOUNT_ENERGY:
        return share->work;
    case TINKER_ACCOUNT_ANGULAR:
        return share->angular;
    default:
        return share->impulse[which - TINKER_ACCOUNT_MOMENTUM_X];
    }
}

static void add_total(TinkerAccount *account, const char *name, double value)
{
    const TinkerAccountEntry entry = {g_strdup(name), value, TRUE, tinker_pointed_block(TINKER_NO_BLOCK)};
    g_array_append_val(account->entries, entry);
}

static void totals_of(const TinkerBooks *books, TinkerAccountKind which, double totals[2])
{
    const double first[TINKER_ACCOUNTS] = {
        0, 0, books->kinetic[0], books->angular[0], books->momentum[0][0], books->momentum[0][1]};
    const double last[TINKER_ACCOUNTS] = {books->rate[0],    books->rate[1],        books->kinetic[1],
                                          books->angular[1], books->momentum[1][0], books->momentum[1][1]};
    totals[0] = first[which];
    totals[1] = last[which];
}

char *tinker_books_about(const TinkerBooks *books, TinkerScene *scene)
{
    static const TinkerDimension metres = TINKER_DIMENSION_LENGTH;
    const TinkerUnitSystem units = tinker_scene_head(scene)->units;
    if (books->about[0] == 0 && books->about[1] == 0) return g_strdup(_("the origin"));
    g_autofree char *x = tinker_quantity_brief(books->about[0], metres, units);
    g_autofree char *y = tinker_quantity_brief(books->about[1], metres, units);
    return g_strdup_printf("(%s, %s)", x, y);
}

/* Of angular momentum with the point that it is about. (transfer full) */
static char *title_of_account(const TinkerBooksPicture *picture, TinkerAccountKind which)
{
    const char *const titles[TINKER_ACCOUNTS] = {
        _("Newton at the end, along x"),    _("Newton at the end, along y"),   _("Work and energy"), NULL,
        _("Impulse and momentum, along x"), _("Impulse and momentum, along y")};
    if (titles[which] != NULL) return g_strdup(titles[which]);
    g_autofree char *about = tinker_books_about(picture->books, picture->scene);
    return g_strdup_printf(_("Angular impulse and momentum about %s"), about);
}

TinkerPointed tinker_account_thing(const TinkerBooksPicture *picture, const TinkerBookEntry *entry, int part)
{
    TinkerPointed thing = tinker_pointed_block(entry->by);
    if (picture->bodies[0] >= 0 && picture->bodies[1] < 0) thing.on = picture->bodies[0];
    if (entry->rubs && thing.on >= 0) thing.part = part == 0 ? TINKER_POINTED_NORMAL : TINKER_POINTED_FRICTION;
    return thing;
}

/* What rounding alone may leave: of work, which may be 0 where forces are large, also by their moments. */
static double rounding_of(const TinkerBooks *books, TinkerAccountKind which, double scale)
{
    const double interval = books->to - books->from;
    if (which == TINKER_ACCOUNT_ENERGY && interval > 0) scale = fmax(scale, books->moment.scale / interval);
    return TINKER_FORCE_NOTHING * scale;
}

static void drop_rounding(TinkerAccount *account, double rounding)
{
    for (guint i = 0; i < account->entries->len; i++) {
        TinkerAccountEntry *entry = &g_array_index(account->entries, TinkerAccountEntry, i);
        if (fabs(entry->value) <= rounding) entry->value = 0;
    }
}

/* What stood at the beginning, and what came of it. */
static const char *total_name(TinkerAccountKind which, gboolean before)
{
    if (which <= TINKER_ACCOUNT_FORCE_Y) return _("= m a");
    if (which == TINKER_ACCOUNT_ENERGY) return before ? _("kinetic energy before") : _("= kinetic energy after");
    if (which == TINKER_ACCOUNT_ANGULAR) return before ? _("angular momentum before") : _("= angular momentum after");
    return before ? _("momentum before") : _("= momentum after");
}

TinkerAccount tinker_account_of(const TinkerBooksPicture *picture, TinkerAccountKind which)
{
    static const TinkerDimension dimensions[TINKER_ACCOUNTS] = {TINKER_DIMENSION_FORCE,  TINKER_DIMENSION_FORCE,
                                                                TINKER_DIMENSION_ENERGY, {1, 2, -1, 0},
                                                                {1, 1, -1, 0},           {1, 1, -1, 0}};
    const TinkerBooks *books = picture->books;
    const TinkerBookBalance *const balances[TINKER_ACCOUNTS] = {&books->newton, &books->newton,  &books->energy,
                                                                &books->moment, &books->impulse, &books->impulse};
    TinkerAccount account = {title_of_account(picture, which), dimensions[which],
                             g_array_new(FALSE, TRUE, sizeof(TinkerAccountEntry)), balances[which]};
    double totals[2];
    g_array_set_clear_func(account.entries, entry_clear);
    totals_of(books, which, totals);
    if (which > TINKER_ACCOUNT_FORCE_Y) add_total(&account, total_name(which, TRUE), totals[0]);
    for (guint i = 0; i < books->entries->len; i++) {
        const TinkerBookEntry *entry = &g_array_index(books->entries, TinkerBookEntry, i);
        if (entry->inner && which != TINKER_ACCOUNT_ENERGY) continue; /* it cancels */
        TinkerBookShare parts[2];
        const int count = tinker_book_parts(entry, parts);
        for (int k = 0; k < count; k++) {
            const TinkerAccountEntry one = {tinker_book_part_name(books, picture->scene, entry, k),
                                            given(&parts[k], which), FALSE, tinker_account_thing(picture, entry, k)};
            g_array_append_val(account.entries, one);
        }
    }
    add_total(&account, total_name(which, FALSE), totals[1]);
    drop_rounding(&account, rounding_of(books, which, account.balance->scale));
    return account;
}

void tinker_account_clear(TinkerAccount *account)
{
    g_free(account->title);
    g_array_unref(account->entries);
}

void tinker_account_gather(TinkerAccount *account, guint most)
{
    double rest = 0;
    guint gathered = 0;
    while (account->entries->len + (gathered > 0) > MAX(most, 4)) {
        guint least = 0;
        for (guint i = 0; i < account->entries->len; i++) {
            const TinkerAccountEntry *entry = &g_array_index(account->entries, TinkerAccountEntry, i);
            const TinkerAccountEntry *best = &g_array_index(account->entries, TinkerAccountEntry, least);
            if (!entry->total && (best->total || fabs(entry->value) < fabs(best->value))) least = i;
        }
        rest += g_array_index(account->entries, TinkerAccountEntry, least).value;
        g_array_remove_index(account->entries, least);
        gathered++;
    }
    if (gathered == 0) return;
    const TinkerAccountEntry others = {g_strdup_printf(_("%u others"), gathered), rest, FALSE,
                                       tinker_pointed_block(TINKER_NO_BLOCK)};
    g_array_insert_val(account->entries, account->entries->len - 1, others);
}
