/* Expressions as trees: what laws are typeset, differentiated and checked from. A tree never changes and is shared by
 * counting references; any number of threads may use it. */
#ifndef TINKER_CORE_EXPRESSION_TREE_H
#define TINKER_CORE_EXPRESSION_TREE_H

#include <glib.h>

typedef enum {
    TINKER_EXPRESSION_NUMBER,
    TINKER_EXPRESSION_SYMBOL,
    TINKER_EXPRESSION_SUM,        /* of two parts or more */
    TINKER_EXPRESSION_PRODUCT,    /* likewise */
    TINKER_EXPRESSION_NEGATIVE,   /* of one part */
    TINKER_EXPRESSION_QUOTIENT,   /* of two */
    TINKER_EXPRESSION_POWER,      /* likewise */
    TINKER_EXPRESSION_COMPARISON, /* of two; the name is its sign */
    TINKER_EXPRESSION_FUNCTION,   /* "if" is one, of condition and two values */
} TinkerExpressionKind;

typedef struct _TinkerExpression TinkerExpression;

/* The members are read-only. */
struct _TinkerExpression {
    gatomicrefcount references;
    TinkerExpressionKind kind;
    double number;    /* of a number */
    const char *name; /* of a symbol, a comparison, a function; interned, so that equal names are equal pointers */
    int depth;        /* levels of parts below it */
    int count;
    TinkerExpression *parts[];
};

/* Reads a text of the grammar that waveforms have as well, in which the names (ended by NULL) may stand beside t;
 * `pi` becomes a number. Errors are those of tinker_waveform_new_expression. (transfer full) */
TinkerExpression *tinker_expression_parse(const char *text, const char *const *names, GError **error);

/* The first "=" between two expressions, which is no part of a comparison's sign nor of a name in braces; NULL. */
const char *tinker_expression_find_equals(const char *text);

/* Whether a name in braces, "{Mass 0.x}", with them, may stand in a text; `why` not, otherwise (transfer full). */
typedef gboolean (*TinkerReferenceFunc)(const char *symbol, void *data, char **why);

/* Reads a text in which names in braces may stand beside t. They become symbols, with their braces. (transfer full) */
TinkerExpression *tinker_expression_parse_quantities(const char *text, TinkerReferenceFunc refer, void *data,
                                                     GError **error);

/* Nodes as they are, not simplified. What `parts` hold is taken over. (transfer full) */
TinkerExpression *tinker_expression_number(double number);
TinkerExpression *tinker_expression_symbol(const char *name);
TinkerExpression *tinker_expression_node(TinkerExpressionKind kind, const char *name, TinkerExpression *const *parts,
                                         int count);

TinkerExpression *tinker_expression_ref(const TinkerExpression *expression);
void tinker_expression_unref(TinkerExpression *expression);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerExpression, tinker_expression_unref)

gboolean tinker_expression_equal(const TinkerExpression *a, const TinkerExpression *b);

/* The signs and functions of the grammar, worked out for numbers: what an evaluator of trees does at a node without
 * symbols of its own. `values` are those of the parts; of an `if` all three are wanted. */
double tinker_expression_apply(const TinkerExpression *node, const double *values);

/* The text with every t replaced by (t + shift). (transfer full) */
char *tinker_expression_shift_text(const char *text, double shift);

#endif
