/* Six accounts in two columns, in a narrow picture in one: forces and momentum along x and y, energy, angular momentum.
 */
#include "common/diagram/books-picture.h"

#include <glib/gi18n.h>
#include <math.h>

#include "common/diagram/books-accounts.h"
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

#define FADED 0.3

typedef struct {
    const TinkerBooksPicture *picture;
    cairo_t *cairo;
    TinkerTextPen pen;
    double name_room, value_room; /* canvas units: of all accounts, so that their bars begin and end alike */
    gboolean some_lit;            /* others are faded */
} Drawing;

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

/* Where each bar begins and ends, and the range of all, with 0 in it. */
static double *bars_of(const TinkerAccount *account, double range[2])
{
    double *bars = g_new(double, 2 * account->entries->len), sum = 0;
    range[0] = range[1] = 0;
    for (guint i = 0; i < account->entries->len; i++) {
        const TinkerAccountEntry *entry = &g_array_index(account->entries, TinkerAccountEntry, i);
        bars[2 * i] = entry->total ? 0 : sum;
        sum = entry->total ? entry->value : sum + entry->value;
        bars[2 * i + 1] = sum;
        range[0] = fmin(range[0], fmin(bars[2 * i], sum));
        range[1] = fmax(range[1], fmax(bars[2 * i], sum));
    }
    return bars;
}

static const double *colour_of(const Drawing *drawing, const TinkerAccountEntry *entry)
{
    const TinkerTheme *theme = drawing->picture->theme;
    if (entry->total) return theme->colours[TINKER_COLOUR_DETACHED];
    return entry->value < 0 ? theme->colours[TINKER_COLOUR_COMPRESSED] : theme->colours[TINKER_COLOUR_STRETCHED];
}

static void draw_bar(Drawing *drawing, const TinkerAccountEntry *entry, const double ends[2], double y, double height)
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
static void add_spot(Drawing *drawing, const TinkerAccountEntry *entry, const char *value, const double at[4])
{
    const double box[] = {at[0], at[1] - at[3] / 2, at[2], at[1] + at[3] / 2};
    g_autofree char *text = g_strdup_printf("%s  %s", entry->name, value);
    tinker_spots_add_box(drawing->picture->spots, box, entry->what, text);
}

static void draw_entries(Drawing *drawing, const TinkerAccount *account, const double place[4], double row)
{
    double range[2];
    g_autofree double *bars = bars_of(account, range);
    const double from = place[0] + drawing->name_room, to = place[2] - drawing->value_room;
    const double unit = range[1] > range[0] ? (to - from) / (range[1] - range[0]) : 0;
    const double zero = from - unit * range[0];
    draw_step(drawing, zero, place[1], row * account->entries->len);
    for (guint i = 0; i < account->entries->len; i++) {
        const TinkerAccountEntry *entry = &g_array_index(account->entries, TinkerAccountEntry, i);
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

static void draw_account(Drawing *drawing, TinkerAccountKind which, const double place[4])
{
    g_auto(TinkerAccount) account = tinker_account_of(drawing->picture, which);
    const double room_across = fmax(place[2] - place[0], 1);
    const TinkerText title = {.text = account.title, .size = TEXT, .bold = TRUE, .limit = room_across, .lines = 2};
    double across, high;
    tinker_text_measure(&drawing->pen, &title, &across, &high);
    const double top = place[1] + (high > 1.8 * TEXT ? high / 2 : 0); /* lower where the title takes two lines */
    const double room = place[3] - top - HEADING;
    tinker_account_gather(&account, (guint)fmax(room / LEAST_ROW, 1));
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
}

static double width_of(Drawing *drawing, const char *text, gboolean bold)
{
    return tinker_text_width(&drawing->pen, &(TinkerText){.text = text, .size = TEXT, .bold = bold});
}

/* Values have the room that the longest takes, names as much as bars leave them. */
static void choose_rooms(Drawing *drawing, double width)
{
    double name = 0, value = 0;
    for (int which = 0; which < TINKER_ACCOUNTS; which++) {
        g_auto(TinkerAccount) account = tinker_account_of(drawing->picture, (TinkerAccountKind)which);
        for (guint i = 0; i < account.entries->len; i++) {
            const TinkerAccountEntry *entry = &g_array_index(account.entries, TinkerAccountEntry, i);
            g_autofree char *text = quantity(drawing, entry->value, account.dimension);
            name = fmax(name, width_of(drawing, entry->name, entry->total));
            value = fmax(value, width_of(drawing, text, entry->total));
        }
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
                tinker_account_thing(picture, &g_array_index(picture->books->entries, TinkerBookEntry, i), part);
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
                 line = (height - top) * columns / TINKER_ACCOUNTS;
    choose_rooms(&drawing, column);
    drawing.some_lit = any_is_lit(drawing.picture);
    for (int which = 0; which < TINKER_ACCOUNTS; which++) {
        const double left = EDGE + (which % columns) * (column + 2 * EDGE), above = top + (which / columns) * line;
        draw_account(&drawing, (TinkerAccountKind)which,
                     (double[]){left, above, left + column, above + line - EDGE / 2});
    }
    tinker_text_pen_clear(&drawing.pen);
}
