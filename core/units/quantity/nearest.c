/* The word that was probably meant: the candidate at the smallest edit distance, where insertions, deletions,
 * substitutions and swaps of neighbours cost 2 and a letter in the wrong case costs 1 (the "optimal string alignment"
 * variant of Damerau's distance, CACM 7, 1964). */
#include <string.h>

#include "units/quantity/units.h"

#define LONGEST 64 /* bytes; longer words are nobody's typing error */
#define EDIT    2

static int substitution(char a, char b)
{
    if (a == b) return 0;
    return g_ascii_tolower(a) == g_ascii_tolower(b) ? 1 : EDIT;
}

static int distance(const char *a, size_t a_length, const char *b, size_t b_length)
{
    int rows[3][LONGEST + 1];
    for (size_t j = 0; j <= b_length; j++)
        rows[0][j] = EDIT * (int)j;
    for (size_t i = 1; i <= a_length; i++) {
        const int *before_last = rows[(i + 1) % 3];
        const int *last = rows[(i + 2) % 3];
        int *row = rows[i % 3];
        row[0] = EDIT * (int)i;
        for (size_t j = 1; j <= b_length; j++) {
            row[j] = MIN(last[j], row[j - 1]) + EDIT;
            row[j] = MIN(row[j], last[j - 1] + substitution(a[i - 1], b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = MIN(row[j], before_last[j - 2] + EDIT);
        }
    }
    return rows[a_length % 3][b_length];
}

/* One edit for every three letters, at most three; a single letter only in the other case. */
static int tolerated(size_t length)
{
    return MAX(1, EDIT * (int)MIN((length + 1) / 3, 3));
}

const char *tinker_nearest_word(const char *word, const char *const *candidates)
{
    const size_t length = strlen(word);
    if (length == 0 || length > LONGEST) return NULL;

    const char *nearest = NULL;
    int smallest = tolerated(length) + 1;
    for (; *candidates != NULL; candidates++) {
        const size_t candidate_length = strlen(*candidates);
        if (candidate_length > LONGEST) continue;
        const int cost = distance(word, length, *candidates, candidate_length);
        if (cost < smallest) {
            smallest = cost;
            nearest = *candidates;
        }
    }
    return nearest;
}
