/* Six accounts in two columns, in a narrow picture in one: forces and momentum along x and y, energy, angular momentum.
 */
#include "common/diagram/books-picture.h"

#include <glib/gi18n.h>
#include <math.h>

#include "render/draw/text.h"

/* Canvas units. */
#define EDGE       14.0
#define TITLE      15.0
#define TEXT       11.5
#define HEADING    34.0
#define MOST_ROW   22.0
#define LEAST_ROW  15.0
#define BAR        0.62 /* of a row */
#define VALUE_GAP  12.0 /* between bars and values */
#define LEAST_BARS 90.0 /* that names leave to the bars */

#define NARROW 600.0 /* canvas units: below it accounts stand in one column */

#define FADED   0.3
#define NOTHING 1e-12 /* of what was moved: below it a bar is none */

typedef struct {
    char *name;
    double value;
    gboolean total; /* it stands by itself: what was there, what came of it */
    TinkerPointed what;
} Entry;

typedef struct {
    char *title;
    TinkerDimension dimension;
    GArray *entries; /* of Entry */
    const TinkerBookBalance *balance;
} Account;

typedef struct {
    const TinkerBooksPicture *picture;
    cairo_t *cairo;
    TinkerTextPen pen;
    double name_room, value_room; /* canvas units: of all accounts, so that their bars begin and end alike */
    gboolean some_lit;            /* others are faded */
} Drawing;

static void entry_clear(gpointer data)
{
    g_free(((Entry *)data)->name);
}

static void set_colour(const Drawing *drawing, const double colour[4], double share)
{
    const double *ground = drawing->picture->theme->background;
    double mixed[3];
    for (int k = 0; k < 3; k++)
        mixed[k] = ground[k] + share * (colour[k] - ground[k]);
    cairo_set_source_rgba(drawing->cairo, mixed[0], mixed[1], mixed[2], colour[3]);
}

static void write_text(Drawing *drawing, TinkerText text, double x, double y)
{
    set_colour(drawing, drawing->picture->theme->colours[TINKER_COLOUR_TEXT], 1);
    tinker_text_draw(&drawing->pen, drawing->cairo, &text, x, y);
}

static char *quantity(const Drawing *drawing, double value, TinkerDimension dimension)
{
    g_autofree char *size =
        tinker_quantity_brief(fabs(value), dimension, tinker_scene_head(drawing->picture->scene)->units);
    return g_strconcat(value < 0 ? "−" : "", size, NULL);
}

/* Accounts --------------------------------------------------------------------------------------------------------- */

/* Which of the numbers an account is of. */
typedef enum { FORCE_X, FORCE_Y, ENERGY, ANGULAR, MOMENTUM_X, MOMENTUM_Y, ACCOUNTS } Which;

static double given(const TinkerBookShare *entry, Which which)
{
    switch (which) {
    case FORCE_X:
    case FORCE_Y:
        return entry->force[which - FORCE_X];
    case ENERGY:
        return entry->work;
    case ANGULAR:
        return entry->angular;
    default:
        return entry->impulse[which - MOMENTUM_X];
    }
}

static void add_total(Account *account, const char *name, double value)
{
    const Entry entry = {g_strdup(name), value, TRUE, tinker_pointed_block(TINKER_NO_BLOCK)};
    g_array_append_val(account->entries, entry);
}

static void totals_of(const TinkerBooks *books, Which which, double totals[2])
{
    const double first[ACCOUNTS] = {
        0, 0, books->kinetic[0], books->angular[0], books->momentum[0][0], books->momentum[0][1]};
    const double last[ACCOUNTS] = {books->rate[0],    books->rate[1],        books->kinetic[1],
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
static char *title_of_account(const TinkerBooksPicture *picture, Which which)
{
    const char *const titles[ACCOUNTS] = {
        _("Newton at the end, along x"),    _("Newton at the end, along y"),   _("Work and energy"), NULL,
        _("Impulse and momentum, along x"), _("Impulse and momentum, along y")};
    if (titles[which] != NULL) return g_strdup(titles[which]);
    g_autofree char *about = tinker_books_about(picture->books, picture->scene);
    return g_strdup_printf(_("Angular impulse and momentum about %s"), about);
}

/* Of the books of one body the forces on it alone, and a part of an entry by itself. */
static TinkerPointed thing_of(const TinkerBooksPicture *picture, const TinkerBookEntry *entry, int part)
{
    TinkerPointed thing = tinker_pointed_block(entry->by);
    if (picture->bodies[0] >= 0 && picture->bodies[1] < 0) thing.on = picture->bodies[0];
    if (entry->rubs && thing.on >= 0) thing.part = part == 0 ? TINKER_POINTED_NORMAL : TINKER_POINTED_FRICTION;
    return thing;
}

/* What rounding alone may leave: of work, which may be 0 where forces are large, also by their moments. */
static double rounding_of(const TinkerBooks *books, Which which, double scale)
{
    const double interval = books->to - books->from;
    if (which == ENERGY && interval > 0) scale = fmax(scale, books->moment.scale / interval);
    return NOTHING * scale;
}

static void drop_rounding(Account *account, double rounding)
{
    for (guint i = 0; i < account->entries->len; i++) {
        Entry *entry = &g_array_index(account->entries, Entry, i);
        if (fabs(entry->value) <= rounding) entry->value = 0;
    }
}

/* What stood at the beginning, and what came of it. */
static const char *total_name(Which which, gboolean before)
{
    if (which <= FORCE_Y) return _("= m a");
    if (which == ENERGY) return before ? _("kinetic energy before") : _("= kinetic energy after");
    if (which == ANGULAR) return before ? _("angular momentum before") : _("= angular momentum after");
    return before ? _("momentum before") : _("= momentum after");
}

static Account account_of(const TinkerBooksPicture *picture, Which which)
{
    static const TinkerDimension dimensions[ACCOUNTS] = {TINKER_DIMENSION_FORCE,  TINKER_DIMENSION_FORCE,
                                                         TINKER_DIMENSION_ENERGY, {1, 2, -1, 0},
                                                         {1, 1, -1, 0},           {1, 1, -1, 0}};
    const TinkerBooks *books = picture->books;
    const TinkerBookBalance *const balances[ACCOUNTS] = {&books->newton, &books->newton,  &books->energy,
                                                         &books->moment, &books->impulse, &books->impulse};
    Account account = {title_of_account(picture, which), dimensions[which], g_array_new(FALSE, TRUE, sizeof(Entry)),
                       balances[which]};
    double totals[2];
    g_array_set_clear_func(account.entries, entry_clear);
    totals_of(books, which, totals);
    if (which > FORCE_Y) add_total(&account, total_name(which, TRUE), totals[0]);
    for (guint i = 0; i < books->entries->len; i++) {
        const TinkerBookEntry *entry = &g_array_index(books->entries, TinkerBookEntry, i);
        if (entry->inner && which != ENERGY) continue; /* it cancels */
        TinkerBookShare parts[2];
        const int count = tinker_book_parts(entry, parts);
        for (int k = 0; k < count; k++) {
            const Entry one = {tinker_book_part_name(books, picture->scene, entry, k), given(&parts[k], which), FALSE,
                               thing_of(picture, entry, k)};
            g_array_append_val(account.entries, one);
        }
    }
    add_total(&account, total_name(which, FALSE), totals[1]);
    drop_rounding(&account, rounding_of(books, which, account.balance->scale));
    return account;
}

/* Where there is no room for all, the least become one. */
static void gather(Account *account, guint most)
{
    double rest = 0;
    guint gathered = 0;
    while (account->entries->len + (gathered > 0) > MAX(most, 4)) {
        guint least = 0;
        for (guint i = 0; i < account->entries->len; i++) {
            const Entry *entry = &g_array_index(account->entries, Entry, i);
            const Entry *best = &g_array_index(account->entries, Entry, least);
            if (!entry->total && (best->total || fabs(entry->value) < fabs(best->value))) least = i;
        }
        rest += g_array_index(account->entries, Entry, least).value;
        g_array_remove_index(account->entries, least);
        gathered++;
    }
    if (gathered == 0) return;
    const Entry others = {g_strdup_printf(_("%u others"), gathered), rest, FALSE,
                          tinker_pointed_block(TINKER_NO_BLOCK)};
    g_array_insert_val(account->entries, account->entries->len - 1, others);
}

/* The bars --------------------------------------------------------------------------------------------------------- */

/* Where each bar begins and ends, and the range of all, with 0 in it. */
static double *bars_of(const Account *account, double range[2])
{
    double *bars = g_new(double, 2 * account->entries->len), sum = 0;
    range[0] = range[1] = 0;
    for (guint i = 0; i < account->entries->len; i++) {
        const Entry *entry = &g_array_index(account->entries, Entry, i);
        bars[2 * i] = entry->total ? 0 : sum;
        sum = entry->total ? entry->value : sum + entry->value;
        bars[2 * i + 1] = sum;
        range[0] = fmin(range[0], fmin(bars[2 * i], sum));
        range[1] = fmax(range[1], fmax(bars[2 * i], sum));
    }
    return bars;
}

static const double *colour_of(const Drawing *drawing, const Entry *entry)
{
    const TinkerTheme *theme = drawing->picture->theme;
    if (entry->total) return theme->colours[TINKER_COLOUR_DETACHED];
    return entry->value < 0 ? theme->colours[TINKER_COLOUR_COMPRESSED] : theme->colours[TINKER_COLOUR_STRETCHED];
}

static void draw_bar(Drawing *drawing, const Entry *entry, const double ends[2], double y, double height)
{
    const double share = !drawing->some_lit || tinker_pointed_lights(drawing->picture->lit, &entry->what) ? 1 : FADED;
    const double left = fmin(ends[0], ends[1]), width = fabs(ends[1] - ends[0]);
    set_colour(drawing, colour_of(drawing, entry), share);
    cairo_rectangle(drawing->cairo, left, y - height / 2, fmax(width, 1), height);
    cairo_fill(drawing->cairo);
}

/* What hangs down from a bar's end to the next one's beginning. */
static void draw_step(Drawing *drawing, double x, double y, double row)
{
    set_colour(drawing, drawing->picture->theme->axis, 1);
    cairo_set_line_width(drawing->cairo, 1);
    cairo_move_to(drawing->cairo, x, y);
    cairo_line_to(drawing->cairo, x, y + row);
    cairo_stroke(drawing->cairo);
}

/* What a row says; it reaches from `at` to the right end, so high. */
static void add_spot(Drawing *drawing, const Entry *entry, const char *value, const double at[4])
{
    const double box[] = {at[0], at[1] - at[3] / 2, at[2], at[1] + at[3] / 2};
    g_autofree char *text = g_strdup_printf("%s  %s", entry->name, value);
    tinker_spots_add_box(drawing->picture->spots, box, entry->what, text);
}

static void draw_entries(Drawing *drawing, const Account *account, const double place[4], double row)
{
    double range[2];
    g_autofree double *bars = bars_of(account, range);
    const double from = place[0] + drawing->name_room, to = place[2] - drawing->value_room;
    const double unit = range[1] > range[0] ? (to - from) / (range[1] - range[0]) : 0;
    const double zero = from - unit * range[0];
    draw_step(drawing, zero, place[1], row * account->entries->len);
    for (guint i = 0; i < account->entries->len; i++) {
        const Entry *entry = &g_array_index(account->entries, Entry, i);
        const double y = place[1] + row * (i + 0.5),
                     ends[2] = {zero + unit * bars[2 * i], zero + unit * bars[2 * i + 1]};
        g_autofree char *value = quantity(drawing, entry->value, account->dimension);
        if (entry->value != 0) draw_bar(drawing, entry, ends, y, BAR * row);
        if (i + 1 < account->entries->len) draw_step(drawing, ends[1], y, row);
        write_text(drawing,
                   (TinkerText){.text = entry->name,
                                .size = TEXT,
                                .bold = entry->total,
                                .limit = fmax(drawing->name_room - EDGE / 2, 1),
                                .keeps_end = TRUE,
                                .anchor_y = 0.5},
                   place[0], y);
        write_text(drawing,
                   (TinkerText){.text = value, .size = TEXT, .bold = entry->total, .anchor_x = 1, .anchor_y = 0.5},
                   place[2], y);
        if (entry->what.block != TINKER_NO_BLOCK)
            add_spot(drawing, entry, value, (double[]){place[0], y, place[2], row});
    }
}

static void draw_account(Drawing *drawing, Which which, const double place[4])
{
    Account account = account_of(drawing->picture, which);
    const double room_across = fmax(place[2] - place[0], 1);
    const TinkerText title = {.text = account.title, .size = TEXT, .bold = TRUE, .limit = room_across, .lines = 2};
    double across, high;
    tinker_text_measure(&drawing->pen, &title, &across, &high);
    const double top = place[1] + (high > 1.8 * TEXT ? high / 2 : 0); /* lower where the title takes two lines */
    const double room = place[3] - top - HEADING;
    gather(&account, (guint)fmax(room / LEAST_ROW, 1));
    const double row = fmin(MOST_ROW, room / account.entries->len);
    g_autofree char *left = quantity(drawing, account.balance->residual, account.dimension);
    g_autofree char *off =
        quantity(drawing, drawing->picture->books->unsettled * account.balance->scale, account.dimension);
    g_autofree char *over = drawing->picture->books->unsettled > 0
                                ? g_strdup_printf(_("left over: %s; sums are off by about %s"), left, off)
                                : g_strdup_printf(_("left over: %s"), left);
    write_text(drawing, title, place[0], place[1]);
    write_text(drawing, (TinkerText){.text = over, .size = TEXT - 1, .limit = room_across}, place[0],
               top + HEADING / 2 - 1);
    draw_entries(drawing, &account, (double[]){place[0], top + HEADING, place[2], place[3]}, row);
    g_free(account.title);
    g_array_unref(account.entries);
}

static double width_of(Drawing *drawing, const char *text, gboolean bold)
{
    return tinker_text_width(&drawing->pen, &(TinkerText){.text = text, .size = TEXT, .bold = bold});
}

/* Values have the room that the longest takes, names as much as bars leave them. */
static void choose_rooms(Drawing *drawing, double width)
{
    double name = 0, value = 0;
    for (int which = 0; which < ACCOUNTS; which++) {
        Account account = account_of(drawing->picture, (Which)which);
        for (guint i = 0; i < account.entries->len; i++) {
            const Entry *entry = &g_array_index(account.entries, Entry, i);
            g_autofree char *text = quantity(drawing, entry->value, account.dimension);
            name = fmax(name, width_of(drawing, entry->name, entry->total));
            value = fmax(value, width_of(drawing, text, entry->total));
        }
        g_free(account.title);
        g_array_unref(account.entries);
    }
    drawing->value_room = value + VALUE_GAP;
    drawing->name_room = fmin(name + EDGE, fmax(width - drawing->value_room - LEAST_BARS, width / 4));
}

static char *title_of(const Drawing *drawing)
{
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    const TinkerBooksPicture *picture = drawing->picture;
    g_autoptr(GString) names = g_string_new(NULL);
    for (const TinkerBlockId *body = picture->bodies; *body >= 0; body++)
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "",
                               tinker_scene_block_name(picture->scene, *body));
    g_autofree char *from = quantity(drawing, picture->books->from, seconds);
    g_autofree char *to = quantity(drawing, picture->books->to, seconds);
    return g_strdup_printf(_("Books of %s, from %s to %s"), names->str, from, to);
}

static gboolean any_is_lit(const TinkerBooksPicture *picture)
{
    for (guint i = 0; i < picture->books->entries->len; i++) {
        for (int part = 0; part < 2; part++) {
            const TinkerPointed thing =
                thing_of(picture, &g_array_index(picture->books->entries, TinkerBookEntry, i), part);
            if (tinker_pointed_lights(picture->lit, &thing)) return TRUE;
        }
    }
    return FALSE;
}

/* Names and the interval, in two lines where one is too short; answers how high it is. */
static double draw_title(Drawing *drawing, double width)
{
    g_autofree char *title = title_of(drawing);
    const TinkerText text = {
        .text = title, .size = TITLE, .bold = TRUE, .limit = fmax(width - 2 * EDGE, 1), .lines = 2};
    double across, height;
    tinker_text_measure(&drawing->pen, &text, &across, &height);
    write_text(drawing, text, EDGE, EDGE / 2);
    return fmax(height, TITLE);
}

void tinker_books_draw(cairo_t *cairo, double width, double height, void *data)
{
    Drawing drawing = {.picture = data, .cairo = cairo, .pen = TINKER_TEXT_PEN_INIT};
    const int columns = width < NARROW ? 1 : 2;
    set_colour(&drawing, drawing.picture->theme->background, 1);
    cairo_paint(cairo);
    const double top = 1.5 * EDGE + draw_title(&drawing, width), column = (width - 2 * EDGE * columns) / columns,
                 line = (height - top) * columns / ACCOUNTS;
    choose_rooms(&drawing, column);
    drawing.some_lit = any_is_lit(drawing.picture);
    for (int which = 0; which < ACCOUNTS; which++) {
        const double left = EDGE + (which % columns) * (column + 2 * EDGE), above = top + (which / columns) * line;
        draw_account(&drawing, (Which)which, (double[]){left, above, left + column, above + line - EDGE / 2});
    }
    tinker_text_pen_clear(&drawing.pen);
}
