#include "equations/balance/book-nodes-private.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define POINTS 8
#define BEFORE 64 /* last digits of a time before it */

/* Half of the points on [-1, 1]; the others mirror them. */
static const double places[POINTS / 2] = {0.1834346424956498049394761, 0.5255324099163289858177390,
                                          0.7966664774136267395915539, 0.9602898564975362316835609};
static const double weights[POINTS / 2] = {0.3626837833783619829651504, 0.3137066458778872873379622,
                                           0.2223810344533744705443560, 0.1012285362903762591525314};

/* Parts of a panel that a function is smooth in, and of one that it jumps in. Halves of the latter come nearer to the
 * jump by 2 a run, and each is a run of the whole simulation: 16 do so by as much as 4 runs, for 15 panels a jump. */
#define PARTS      2
#define PARTS_JUMP 16
/* From one pair of coefficients (of degrees 4 and 5) to the next: those of a function that is smooth well beyond the
 * panel, within Bernstein's ellipse of 2, fall by 1/4 or more; those of a jump by (5/7)^(1/2) = 0.85, and of a kink by
 * (5/7)^(3/2) = 0.6, alone. */
#define JUMPS 0.25
/* Of a panel: what lies beyond its last point, unseen: (1 - 0.9603) / 2. */
#define BEYOND 0.02
/* Last digits of a time: panels are not made narrower. */
#define NARROWEST 1024

GArray *tinker_book_panels(double from, double to, const GArray *cuts, int panels)
{
    GArray *made = g_array_new(FALSE, TRUE, sizeof(TinkerBookPanel));
    double begin = from;
    for (guint i = 0; i <= cuts->len; i++) {
        const TinkerBookCut cut = i < cuts->len ? g_array_index(cuts, TinkerBookCut, i) : (TinkerBookCut){to, to};
        const double whole = cut.first - begin;
        /* none in a piece whose points would not all lie before the look at what jumps at its end: what a force does
         * in so short a time is left out */
        const gboolean narrow = whole <= 2 * BEFORE * DBL_EPSILON * fabs(cut.first) / BEYOND;
        const int count = narrow ? 0 : (int)ceil(panels * whole / (to - from));
        for (int k = 0; k < count; k++) {
            const TinkerBookPanel panel = {
                .from = begin + whole * k / count, .to = begin + whole * (k + 1) / count, .piece = i};
            g_array_append_val(made, panel);
        }
        begin = cut.last;
    }
    return made;
}

static TinkerBookNode *add(GArray *nodes, double time, double weight, TinkerNodeKind kind)
{
    const TinkerBookNode node = {.time = time, .weight = weight, .kind = kind, .since = time};
    g_array_append_val(nodes, node);
    return &g_array_index(nodes, TinkerBookNode, nodes->len - 1);
}

/* The place of a point on [-1, 1], and its weight. */
static double place_of(int point, double *weight)
{
    const int k = point < POINTS / 2 ? POINTS / 2 - 1 - point : point - POINTS / 2;
    *weight = weights[k];
    return point < POINTS / 2 ? -places[k] : places[k];
}

static void add_panel(GArray *nodes, const GArray *panels, guint number)
{
    const TinkerBookPanel *panel = &g_array_index(panels, TinkerBookPanel, number);
    const double middle = panel->from + (panel->to - panel->from) / 2, half = (panel->to - panel->from) / 2;
    for (int point = 0; point < POINTS; point++) {
        double weight;
        const double place = place_of(point, &weight);
        TinkerBookNode *node = add(nodes, middle + place * half, weight * half, TINKER_NODE_INSIDE);
        node->panel = number;
        node->point = point;
    }
}

GArray *tinker_book_nodes(double from, double to, const GArray *panels, const GArray *cuts, gboolean jump)
{
    GArray *nodes = g_array_new(FALSE, FALSE, sizeof(TinkerBookNode));
    guint next = 0;
    add(nodes, from, 0, TINKER_NODE_START);
    for (guint i = 0; i <= cuts->len; i++) {
        for (; next < panels->len && g_array_index(panels, TinkerBookPanel, next).piece == i; next++)
            add_panel(nodes, panels, next);
        if (i == cuts->len) break;
        const TinkerBookCut cut = g_array_index(cuts, TinkerBookCut, i);
        if (!jump) continue;
        add(nodes, fmax(from, cut.first - BEFORE * DBL_EPSILON * fabs(cut.first)), 0, TINKER_NODE_BEFORE);
        add(nodes, cut.last, 0, TINKER_NODE_AFTER)->since = cut.first;
    }
    add(nodes, to, 0, TINKER_NODE_END);
    return nodes;
}

void tinker_book_panels_clear(GArray *panels)
{
    for (guint i = 0; i < panels->len; i++) {
        TinkerBookPanel *panel = &g_array_index(panels, TinkerBookPanel, i);
        memset(panel->top, 0, sizeof panel->top);
        memset(panel->end, 0, sizeof panel->end);
    }
}

/* The coefficient of P_k is (2 k + 1)/2 times the sum of w_i P_k(x_i) f(x_i); P_k by Bonnet's recurrence. P_k(1) is 1,
 * P_k(-1) is (-1)^k. */
void tinker_book_panel_take(TinkerBookPanel *panel, int point, const double values[TINKER_BOOK_FUNCTIONS])
{
    double weight, before = 0, polynomial = 1;
    const double x = place_of(point, &weight);
    for (int k = 0; k < POINTS; k++) {
        const double share = (k + 0.5) * weight * polynomial,
                     next = ((2 * k + 1) * x * polynomial - k * before) / (k + 1);
        const int top = k - (POINTS - TINKER_BOOK_TOPS);
        for (int f = 0; f < TINKER_BOOK_FUNCTIONS; f++) {
            if (top >= 0) panel->top[f][top] += share * values[f];
            panel->end[f][0] += (k % 2 == 0 ? 1 : -1) * share * values[f];
            panel->end[f][1] += share * values[f];
        }
        before = polynomial;
        polynomial = next;
    }
}

/* How far the rule is off, and in `ratio` how the coefficients go on. Gauss's rule of n points leaves out those from
 * P_2n on: as small as the last ones are, and that ratio from each pair to the next. */
static double left_out(const TinkerBookPanel *panel, int function, double *ratio)
{
    const double *top = panel->top[function];
    const double third = fmax(fabs(top[0]), fabs(top[1])), last = fmax(fabs(top[2]), fabs(top[3]));
    *ratio = last < third ? last / third : 1;
    return (panel->to - panel->from) * last * pow(*ratio, 0.5 * POINTS);
}

/* How far a jump that may lie between the last point of a panel and the first of the next one, where no point sees it,
 * puts integrals off, in units of what is allowed: what both come to there differs. */
static double jump_between(const TinkerBookPanel *panel, const TinkerBookPanel *next,
                           const double allowed[TINKER_BOOK_FUNCTIONS])
{
    const double width = BEYOND * fmax(panel->to - panel->from, next->to - next->from);
    double most = 0;
    for (int f = 0; f < TINKER_BOOK_FUNCTIONS && panel->piece == next->piece; f++) {
        const double off = width * fabs(next->end[f][0] - panel->end[f][1]);
        if (off > allowed[f]) most = fmax(most, off / (allowed[f] + DBL_MIN));
    }
    return most;
}

/* What a panel asks for: in how many parts it is to be taken, 1 where it is good as it is, and how far it is off in
 * units of what is allowed. */
typedef struct {
    guint panel;
    int parts;
    double off;
} Wish;

static Wish wish_of(const GArray *panels, guint number, const double allowed[TINKER_BOOK_FUNCTIONS])
{
    const TinkerBookPanel *panel = &g_array_index(panels, TinkerBookPanel, number);
    Wish wish = {number, 1, 0};
    if (panel->to - panel->from < NARROWEST * DBL_EPSILON * fmax(fabs(panel->from), fabs(panel->to))) return wish;
    for (int f = 0; f < TINKER_BOOK_FUNCTIONS; f++) {
        double ratio;
        const double off = left_out(panel, f, &ratio);
        if (!(off > allowed[f])) continue;
        wish.parts = MAX(wish.parts, ratio > JUMPS ? PARTS_JUMP : PARTS);
        wish.off = fmax(wish.off, off / (allowed[f] + DBL_MIN));
    }
    if (wish.parts > 1) return wish;
    if (number > 0) wish.off = jump_between(panel - 1, panel, allowed);
    if (number + 1 < panels->len) wish.off = fmax(wish.off, jump_between(panel, panel + 1, allowed));
    if (wish.off > 0) wish.parts = PARTS_JUMP;
    return wish;
}

static void add_parts(GArray *panels, const TinkerBookPanel *panel, int parts)
{
    const double whole = panel->to - panel->from;
    for (int k = 0; k < parts; k++) {
        const TinkerBookPanel part = {.from = panel->from + whole * k / parts,
                                      .to = k + 1 < parts ? panel->from + whole * (k + 1) / parts : panel->to,
                                      .piece = panel->piece};
        g_array_append_val(panels, part);
    }
}

/* Puts what `made` holds in the place of the panels, and frees it. */
static void replace(GArray *panels, GArray *made)
{
    g_array_set_size(panels, 0);
    g_array_append_vals(panels, made->data, made->len);
    g_array_unref(made);
}

static int by_off(gconstpointer left, gconstpointer right)
{
    const Wish *a = left, *b = right;
    if (a->off != b->off) return a->off > b->off ? -1 : 1;
    return a->panel < b->panel ? -1 : 1;
}

/* Grants wishes as long as there are not more than `most` panels, the worst first; FALSE: none was. */
static gboolean grant(GArray *panels, GArray *wishes, guint most)
{
    guint left = most > panels->len ? most - panels->len : 0;
    g_autofree int *parts = g_new(int, MAX(panels->len, 1));
    g_autoptr(GArray) sorted = g_array_copy(wishes);
    gboolean found = FALSE;
    g_array_sort(sorted, by_off);
    for (guint i = 0; i < sorted->len; i++) {
        const Wish *wish = &g_array_index(sorted, Wish, i);
        int *given = &parts[wish->panel];
        *given = (guint)wish->parts - 1 <= left ? wish->parts : left > 0 ? PARTS : 1;
        left -= (guint)*given - 1;
        found = found || *given > 1;
    }
    GArray *made = g_array_new(FALSE, TRUE, sizeof(TinkerBookPanel));
    for (guint i = 0; i < panels->len; i++)
        add_parts(made, &g_array_index(panels, TinkerBookPanel, i), parts[i]);
    replace(panels, made);
    return found;
}

double tinker_book_panels_off(const GArray *panels, const double allowed[TINKER_BOOK_FUNCTIONS])
{
    double off = 0;
    for (guint i = 0; i < panels->len; i++)
        off = fmax(off, wish_of(panels, i, allowed).off);
    return off;
}

gboolean tinker_book_panels_refine(GArray *panels, const double allowed[TINKER_BOOK_FUNCTIONS], guint most)
{
    g_autoptr(GArray) wishes = g_array_new(FALSE, FALSE, sizeof(Wish));
    for (guint i = 0; i < panels->len; i++) {
        const Wish wish = wish_of(panels, i, allowed);
        g_array_append_val(wishes, wish);
    }
    return grant(panels, wishes, most);
}

gboolean tinker_book_panels_halve(GArray *panels, double width, guint most)
{
    g_autoptr(GArray) wishes = g_array_new(FALSE, FALSE, sizeof(Wish));
    for (guint i = 0; i < panels->len; i++) {
        const TinkerBookPanel *panel = &g_array_index(panels, TinkerBookPanel, i);
        const double whole = panel->to - panel->from;
        const Wish wish = {i, whole > width ? PARTS : 1, whole};
        g_array_append_val(wishes, wish);
    }
    return grant(panels, wishes, most);
}
