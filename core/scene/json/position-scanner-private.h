/* The state of the position scanner, and what reads and judges single tokens. */
#ifndef TINKER_CORE_POSITION_SCANNER_PRIVATE_H
#define TINKER_CORE_POSITION_SCANNER_PRIVATE_H

#include "scene/json/position-scanner.h"

typedef struct {
    gboolean object;
    guint first_key; /* in Scanner.keys */
    JsonPart part;   /* of this container in the one around it */
} Frame;

typedef struct {
    gsize start, length; /* without the quotes */
    gboolean escaped;
} Key;

typedef struct {
    JsonScan *scan;
    const char *text;
    gsize length, at;
    GArray *keys;       /* of Key: those of all open objects */
    gboolean in_blocks; /* the member of the top level that is being read is "blocks" */
    gsize key_at;       /* of the member that is being read */
    int depth;
    Frame frames[JSON_MOST_DEPTH];
} Scanner;

static inline int scanner_peek(const Scanner *s)
{
    return s->at < s->length ? (guchar)s->text[s->at] : -1;
}

static inline void scanner_skip_space(Scanner *s)
{
    while (s->at < s->length) {
        char c = s->text[s->at];
        if (c != ' ' && c != '\n' && c != '\r' && c != '\t') return;
        s->at++;
    }
}

/* scanner-faults.c: what is wrong at a place; FALSE. */
gboolean scanner_fail(Scanner *s, gsize at, const char *format, ...) G_GNUC_PRINTF(3, 4);
/* "expected X, Y found" with the word or character that is there. */
gboolean scanner_fail_expected(Scanner *s, const char *expected);
/* Of what stands where a key should. */
gboolean scanner_fail_key(Scanner *s);

/* scanner-tokens.c: each stands on the token's first character and passes over it. */
gboolean scanner_string(Scanner *s, gboolean *escaped);
gboolean scanner_number(Scanner *s);
gboolean scanner_word(Scanner *s, const char *word);

/* scanner-keys.c: notes the keys from `first` on, those of one object, that it had already. */
void scanner_find_duplicates(Scanner *s, guint first);

#endif
