/* Listing what differs between two tables; see the header. */
#include "net-compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "net-difference.h"
#include "net-table.h"

typedef struct {
    const char *store;
    guint same, only_old, only_new;
    guint differ[NET_COLUMNS]; /* runs whose column differs */
    NetDifference worst[NET_COLUMNS];
    char worst_run[NET_COLUMNS][128];
    GArray *shares[NET_COLUMNS]; /* of double: of_unit of each run that differs */
} Tally;

static gboolean is_hash(int column)
{
    return column == NET_RECORD || column == NET_ESTIMATE || column == NET_SUMMARY;
}

static void keep_worst(Tally *tally, int column, char *const *line, const NetDifference *difference)
{
    const double before = tally->worst[column].of_unit.share;
    g_array_append_val(tally->shares[column], difference->of_unit.share);
    if (!isnan(before) && !(difference->of_unit.share > before)) return;
    tally->worst[column] = *difference;
    g_snprintf(tally->worst_run[column], sizeof tally->worst_run[column], "%s, %s", line[NET_SCENE], line[NET_METHOD]);
}

/* By how much a stored record or estimate differs. */
static void tell_difference(Tally *tally, int column, char *const *old, char *const *new)
{
    g_autoptr(GError) error = NULL;
    NetDifference difference;
    if (tally->store == NULL || (column != NET_RECORD && column != NET_ESTIMATE)) return;
    if (g_str_equal(old[column], "-") || g_str_equal(new[column], "-")) return;
    if (!net_difference(tally->store, old[column], new[column], &difference, &error))
        printf(" (%s)", error->message);
    else if (!difference.comparable)
        printf(" (has other columns)");
    else if (!isnan(difference.of_unit.share)) {
        printf(" by %.2g of its unit (%s at %.6g), %.2g of its column (%s)", difference.of_unit.share,
               difference.of_unit.column, difference.of_unit.at, difference.of_column.share,
               difference.of_column.column);
        keep_worst(tally, column, old, &difference);
    } else {
        printf(" in its length or in signs of zeros alone");
    }
}

static void compare_lines(Tally *tally, char *const *old, char *const *new)
{
    gboolean same = TRUE;
    for (int column = NET_STATUS; column < NET_COLUMNS; column++) {
        if (g_str_equal(old[column], new[column])) continue;
        if (same) printf("%s, %s:", old[NET_SCENE], old[NET_METHOD]);
        printf("%s %s", same ? "" : ";", net_column_names[column]);
        if (!is_hash(column)) printf(" %s -> %s", old[column], new[column]);
        tell_difference(tally, column, old, new);
        tally->differ[column]++;
        same = FALSE;
    }
    if (!same) printf("\n");
    tally->same += same;
}

static void tell_alone(char *const *line, const char *which, guint *count)
{
    printf("%s, %s: only in the %s one\n", line[NET_SCENE], line[NET_METHOD], which);
    ++*count;
}

static int by_size(gconstpointer left, gconstpointer right)
{
    const double l = *(const double *)left, r = *(const double *)right;
    return (l > r) - (l < r);
}

/* Where a motion is chaotic the least difference grows to any: the middle one tells more than the largest. */
static double median(GArray *shares)
{
    g_array_sort(shares, by_size);
    return g_array_index(shares, double, shares->len / 2);
}

static void sum_up(const Tally *tally, guint of)
{
    printf("%u of %u runs are the same; %u only in the old one, %u only in the new one\n", tally->same, of,
           tally->only_old, tally->only_new);
    for (int column = NET_STATUS; column < NET_COLUMNS; column++) {
        const NetDifference *worst = &tally->worst[column];
        if (tally->differ[column] == 0) continue;
        printf("%-11s %5u differ", net_column_names[column], tally->differ[column]);
        if (tally->worst_run[column][0] != '\0')
            printf(", half of them by %.2g of the unit or less, at most by %.2g (%s at %.6g of %s)",
                   median(tally->shares[column]), worst->of_unit.share, worst->of_unit.column, worst->of_unit.at,
                   tally->worst_run[column]);
        printf("\n");
    }
}

gboolean net_compare(const GPtrArray *old, const GPtrArray *new, const char *store)
{
    Tally tally = {.store = store};
    for (int column = 0; column < NET_COLUMNS; column++) {
        tally.worst[column].of_unit.share = NAN;
        tally.shares[column] = g_array_new(FALSE, FALSE, sizeof(double));
    }
    guint i = 0, k = 0;
    while (i < old->len || k < new->len) {
        char **left = i < old->len ? g_ptr_array_index(old, i) : NULL;
        char **right = k < new->len ? g_ptr_array_index(new, k) : NULL;
        const int order = left == NULL ? 1 : right == NULL ? -1 : net_line_compare(left, right);
        if (order < 0) tell_alone(left, "old", &tally.only_old);
        if (order > 0) tell_alone(right, "new", &tally.only_new);
        if (order == 0) compare_lines(&tally, left, right);
        i += order <= 0;
        k += order >= 0;
    }
    sum_up(&tally, new->len);
    for (int column = 0; column < NET_COLUMNS; column++)
        g_array_unref(tally.shares[column]);
    return tally.same == old->len && tally.same == new->len;
}
