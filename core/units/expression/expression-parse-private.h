/* The state of reading an expression's text, and what is said where it cannot be read. */
#ifndef TINKER_CORE_EXPRESSION_PARSE_PRIVATE_H
#define TINKER_CORE_EXPRESSION_PARSE_PRIVATE_H

#include "units/expression/expression-program.h"
#include "units/expression/waveform-error.h"

typedef struct {
    const char *text;
    const char *at;
    const TinkerReader *reader;
    void *into;
    const char *const *names;  /* that the text may use beside t, pi and functions; NULL: none */
    TinkerReferenceFunc refer; /* says what may stand in braces; NULL: nothing */
    void *data;
    int depth;
    GError **error;
} Parser;

static inline void parser_skip_blanks(Parser *parser)
{
    while (*parser->at == ' ' || *parser->at == '\t' || *parser->at == '\n' || *parser->at == '\r')
        parser->at++;
}

/* expression-faults.c: each sets the error, at a column of the text, and answers TINKER_READER_FAILED. */

G_GNUC_PRINTF(4, 5)
int parser_fail(Parser *parser, TinkerWaveformError code, const char *place, const char *format, ...);
/* Something stands where none of the grammar's signs can: says what was probably meant. */
int parser_fail_unexpected(Parser *parser, const char *expected);
/* No name is known that begins at `start`. */
int parser_fail_name(Parser *parser, const char *start, const char *name);
/* Another number of arguments than the function takes ends or goes on at `place`. */
int parser_fail_arguments(Parser *parser, const TinkerFunction *function, const char *place);
/* Something is left behind a whole expression. */
int parser_fail_behind(Parser *parser);

/* How many bytes the name takes that stands there; 0: none does. */
gsize parser_name_length(const char *at);

#endif
