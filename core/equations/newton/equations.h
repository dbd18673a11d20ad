/* The equations of a scene: for each body, mass times acceleration = the sum of the forces on it, and for one that
 * turns inertia times angular acceleration = the sum of their moments, one term a block that acts, over symbols with
 * values. They say what is run: with the values of the symbols the terms are the forces of the
 * run at that time, and at any other state with the same active set those that it would have there.
 *
 * Constraint forces are unknown multipliers times the gradient of their function g; the multiplier is what makes the
 * second derivative of g by time 0. */
#ifndef TINKER_CORE_EQUATIONS_H
#define TINKER_CORE_EQUATIONS_H

#include "equations/state/model-state.h"
#include "law/typeset.h"
#include "units/expression/expression-tree.h"

typedef enum {
    TINKER_TERM_CONNECTOR,
    TINKER_TERM_CONSTRAINT,
    TINKER_TERM_FORCE,
    TINKER_TERM_FIELD,
    TINKER_TERM_NORMAL,
    TINKER_TERM_FRICTION,
} TinkerTermKind;

/* "connector", ...: static. */
const char *tinker_term_kind_name(TinkerTermKind kind);

/* How a name looks in print; both texts are owned. */
typedef struct {
    char *stem, *index;
    int dots;
    const char *component; /* static, or NULL */
} TinkerEquationLook;

/* The unit of a value in SI: of a torque "N m", which has the dimension of an energy. Borrowed. */
const char *tinker_equation_unit(TinkerDimension dimension, gboolean energy);

/* A number that is given: of a property, of the state, or a multiplier. */
typedef struct {
    char *name; /* unique */
    double value;
    TinkerDimension dimension;
    TinkerBlockId block;  /* -1: of none */
    char *property;       /* the scene's key, of a vector with " x" or " y" behind it; NULL: no property */
    const char *quantity; /* "x", "tension": static, or NULL */
} TinkerEquationSymbol;

/* A name for an expression of symbols and of definitions before it. */
typedef struct {
    char *name;
    TinkerBlockId block;
    TinkerDimension dimension;
    char *means;
    TinkerExpression *is;
    gboolean typed;  /* by the user, in plain SI numbers */
    gboolean energy; /* in J: all else of this dimension is a torque */
    int32_t span;    /* of a rope: the distance from its end of this number, from 1 on, to the next; 0: it is none */
    double value;    /* at the time of the state */
} TinkerEquationDefinition;

typedef struct {
    TinkerBlockId block;
    TinkerTermKind kind;
    TinkerExpression *x, *y;  /* N */
    TinkerExpression *torque; /* N m, about the centre; NULL of a body that does not turn */
} TinkerTerm;

typedef struct {
    TinkerBlockId block;
    TinkerExpression *mass;
    TinkerExpression *inertia; /* about the centre; NULL: it does not turn */
    GArray *terms;             /* of TinkerTerm */
} TinkerBodyEquation;

typedef struct {
    TinkerBlockId block;
    TinkerExpression *g;
    char *multiplier;
    TinkerExpression *limit;   /* N: as far as friction holds, |multiplier| <= limit; NULL: there is none */
    TinkerDimension dimension; /* of g */
    gboolean active;           /* FALSE: a slack rope, whose multiplier is 0 and whose g is not */
    gboolean redundant;        /* it depends on others: the multipliers are those of least norm */
} TinkerConstraintEquation;

/* What acts without a law that is stated: these symbols stand for its forces. */
typedef struct {
    TinkerBlockId block;
    GPtrArray *symbols; /* of char * */
    char *why;
} TinkerNotWritten;

/* A connector along a line: its tension over the length and its rate, which are definitions. */
typedef struct {
    TinkerBlockId block;
    TinkerBlockId ends[2];         /* bodies; -1 where an end is on none */
    TinkerExpression *length;      /* a symbol, */
    TinkerExpression *rate;        /* and another; NULL where the tension does not depend on it */
    TinkerExpression *tension;     /* N */
    TinkerExpression *place[2][2]; /* m: of its ends, x and y; */
    TinkerExpression *velocity[2][2];
    TinkerExpression *local[2][2]; /* m: where it is on a body that turns, in the body's axes from its centre; else 0 */
} TinkerLineEquation;

typedef struct {
    TinkerScene *scene; /* borrowed */
    double time;        /* s */
    GPtrArray *bodies;  /* of TinkerBodyEquation */
    GPtrArray *symbols; /* of TinkerEquationSymbol */
    GPtrArray *definitions;
    GPtrArray *constraints;
    GPtrArray *not_written;
    GPtrArray *lines;   /* of TinkerLineEquation */
    GPtrArray *pins;    /* of TinkerLineEquation, without length and tension: what holds two places together */
    GPtrArray *rods;    /* of TinkerLineEquation: what keeps two places apart, with that length in place of a tension */
    GHashTable *looks;  /* name to TinkerEquationLook */
    GHashTable *taken;  /* the looks, as stem, component, dots and index in one text: no two names look the same */
    GHashTable *values; /* name to double: of symbols and definitions */
    GHashTable *roundings; /* name to double: of those that are not rounded to the last digit of their value */
} TinkerEquations;

/* The equations of a scene at a state of it. The scene is borrowed and must not change as long as they live. Errors are
 * those of placing the scene. (transfer full) */
TinkerEquations *tinker_equations_new(TinkerScene *scene, const TinkerModelState *state, GError **error);
void tinker_equations_free(TinkerEquations *equations);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerEquations, tinker_equations_free)

/* A name of these: "k_1", "x_d_2"; `component`, or NULL, stands behind the stem. (transfer full) */
char *tinker_equations_name(const char *stem, const char *index, int dots, const char *component);
/* How a name looks from here on; no free name gets that look. The texts are copied. */
void tinker_equations_add_look(TinkerEquations *equations, const char *name, const char *stem, const char *index,
                               int dots, const char *component);
/* No free name gets this look. */
void tinker_equations_reserve(TinkerEquations *equations, const char *stem, const char *index);
/* An index for a block's symbol, "" for none: this one, or where another name looks so the block's name. (transfer
 * full) */
char *tinker_equations_free_index(const TinkerEquations *equations, TinkerBlockId block, const char *stem,
                                  const char *index, int dots, const char *component);
/* A free name with that index, and its look. Borrowed from the equations. */
const char *tinker_equations_free_name(TinkerEquations *equations, TinkerBlockId block, const char *stem,
                                       const char *index, int dots, const char *component);

/* Adds the names that an expression needs (const char *, interned). */
void tinker_equations_mark(const TinkerEquations *equations, const TinkerExpression *expression, GHashTable *needed);
/* Adds the symbols of the definitions of those that are needed, and of theirs. */
void tinker_equations_mark_definitions(const TinkerEquations *equations, GHashTable *needed);

/* Of a TinkerEquationDefinition. */
void tinker_equation_definition_free(void *definition);

/* The look of a name; for tinker_expression_typeset, with the equations as its data. */
void tinker_equations_look(const char *symbol, TinkerSymbolLook *look, void *equations);

/* What has this name; NULL where nothing has. Borrowed. */
const TinkerEquationDefinition *tinker_equations_definition(const TinkerEquations *equations, const char *name);
const TinkerEquationSymbol *tinker_equations_symbol(const TinkerEquations *equations, const char *name);

/* The text of a number that a typed law names, with its unit as it was typed; NULL: the symbol is none. Borrowed. */
const char *tinker_equations_typed_text(const TinkerEquations *equations, const TinkerEquationSymbol *symbol);

/* Whether numbers alone are known of a symbol, as of what a table moves. */
gboolean tinker_equations_is_not_written(const TinkerEquations *equations, const char *symbol);

/* An expression worked out with the values at the time. */
double tinker_equations_value(const TinkerEquations *equations, const TinkerExpression *expression);

/* How far rounding alone can have moved that value: of numbers that are given and of every step of working it out. */
double tinker_equations_rounding(const TinkerEquations *equations, const TinkerExpression *expression);

/* The value as people read it: 0 where it is no larger than its rounding. */
double tinker_equations_shown_value(const TinkerEquations *equations, const TinkerExpression *expression);

#endif
