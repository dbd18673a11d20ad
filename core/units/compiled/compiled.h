/* Expressions of several arguments, compiled: what typed laws are worked out by. */
#ifndef TINKER_CORE_COMPILED_H
#define TINKER_CORE_COMPILED_H

#include <tinker/typed-law.h>

#include "units/expression/expression-tree.h"
#include "units/expression/interval.h"

typedef struct _TinkerCompiled TinkerCompiled;

/* Compiles an expression over these names. What the tree shares is worked out once. NULL where it has become too long.
 * (transfer full) */
TinkerCompiled *tinker_compiled_new(const TinkerExpression *expression, const char *const *names, int count);
void tinker_compiled_free(TinkerCompiled *compiled);

/* The value; needs no memory, and may be asked on any thread. */
double tinker_compiled_value(const TinkerCompiled *compiled, const double *arguments);

/* Many places at once. */
typedef struct {
    int count, first;
    const double *const *arguments; /* by argument, then by place, from the place `first` on; NULL: ... */
    const double *uniform;          /* ... it is this for all */
    const double *numbers; /* instead of the program's own: by number (tinker_compiled_numbers), then by place; ... */
    int stride;            /* ... from number to number. NULL: its own */
} TinkerColumns;

/* The values at many places, which do not overlap what they are made of; bit for bit those of tinker_compiled_value.
 * FALSE: the program is too large for that. */
gboolean tinker_compiled_values(const TinkerCompiled *compiled, const TinkerColumns *columns, double *results);

/* Whether there is a shorter way for so many places, which are to be few. */
gboolean tinker_compiled_has_row(const TinkerCompiled *compiled, int count);

/* It: as tinker_compiled_values of places that each have numbers of their own, all `count` of one number side by side.
 */
void tinker_compiled_row(const TinkerCompiled *compiled, const double *const *arguments, const double *uniform,
                         const double *numbers, int count, double *results);

/* Encloses the values over a box of arguments, one interval each. TRUE: it is gentle there, so that a few places tell
 * its course. FALSE: something switches, or runs through much of its course, or is nowhere a number. What argument
 * `decided_by` (-1: none) alone switches does not switch within the box: that is known otherwise. Numbers that are as
 * near to a switch as their own rounding are on one side of it. */
gboolean tinker_compiled_enclose(const TinkerCompiled *compiled, const TinkerInterval *arguments, int decided_by,
                                 TinkerInterval *result);

/* Whether it is made of sums, products and roots alone: gentle over any box. */
gboolean tinker_compiled_is_always_gentle(const TinkerCompiled *compiled);

/* The numbers that a program names, and whether two differ in them alone. */
const double *tinker_compiled_numbers(const TinkerCompiled *compiled, int *count);
gboolean tinker_compiled_alike(const TinkerCompiled *a, const TinkerCompiled *b);

/* Laws that differ in their numbers alone, one behind the other. */
typedef struct _TinkerTypedRow TinkerTypedRow;

typedef struct _TinkerTypedEnergy TinkerTypedEnergy;

/* What plugins know as a formula (tinker/typed-law.h): an expression, its slopes and its curvatures. */
struct TinkerTypedLaw {
    int count;  /* of arguments */
    int member; /* which one of its row it is */
    TinkerCompiled *value;
    TinkerCompiled **slopes;     /* by each argument */
    TinkerCompiled **curvatures; /* by two, row by row */
    TinkerTypedRow *row;         /* that it is a member of; NULL: none */
    TinkerTypedEnergy *energy;   /* that it stores (compiled/typed-energy.h); NULL: none that is known. Laws are looked
                                    through one by one where many are asked, so the rest of it is elsewhere */
    gboolean depends_on_time, depends_on_velocity;
};

/* Puts those that differ in their numbers alone and follow one another into rows: laws[i * stride], which are replaced;
 * NULLs stay. */
void tinker_typed_join(struct TinkerTypedLaw **laws, int stride, int count);
void tinker_typed_free(struct TinkerTypedLaw *law);

/* The questions of TinkerTypedLawService; by and and_by are -1 where it is not derived. */
void tinker_typed_ask(const struct TinkerTypedQuestion *question, int by, int and_by, double *results);

#endif
