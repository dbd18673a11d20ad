/* Programs as steps of a machine with registers: what the compiler hands to the two ways of working them out. */
#ifndef TINKER_COMPILED_PRIVATE_H
#define TINKER_COMPILED_PRIVATE_H

#include "units/compiled/compiled.h"
#include "units/expression/expression-program.h"

#define TINKER_MOST_ENTRIES 2048 /* they stand on the stack */

#define TINKER_USUAL_NUMBERS 4 /* few programs have more, and there is always room for so many */

/* What a step does with what it reads, a to d; the operations of waveforms follow from TINKER_STEP_OTHER on. */
typedef enum {
    TINKER_STEP_ADD,              /* a + b */
    TINKER_STEP_SUBTRACT,         /* a - b */
    TINKER_STEP_MULTIPLY,         /* a b */
    TINKER_STEP_DIVIDE,           /* a / b */
    TINKER_STEP_SQUARE,           /* a a */
    TINKER_STEP_CUBE,             /* (a a) a */
    TINKER_STEP_TIMES_ADD,        /* a b + c, rounded twice */
    TINKER_STEP_TIMES_SQUARE_ADD, /* a (b b) + c */
    TINKER_STEP_TIMES_CUBE_ADD,   /* a ((b b) b) + c */
    TINKER_STEP_TIMES_LESS,       /* a b - c */
    TINKER_STEP_LESS_TIMES,       /* c - a b */
    TINKER_STEP_PRODUCTS,         /* a b + c d */
    TINKER_STEP_PRODUCTS_SQUARE,  /* a b + c (d d) */
    TINKER_STEP_PRODUCTS_CUBE,    /* a b + c ((d d) d) */
    TINKER_STEP_NEGATE,
    TINKER_STEP_SQRT,
    TINKER_STEP_CHOOSE, /* a where c is negative, else b */
    TINKER_STEP_CELL,   /* of a; b is the period */
    TINKER_STEP_OTHER,
} TinkerStepKind;

/* Of what a step reads, what the one before it answered: it need not wait for the memory. */
typedef enum {
    TINKER_LATEST_NONE,
    TINKER_LATEST_A,
    TINKER_LATEST_B,
    TINKER_LATEST_C,
    TINKER_LATEST_D,
    TINKER_LATEST_COUNT
} TinkerLatest;

/* Entries are counted through: first the arguments, then the numbers, then the registers. */
typedef struct {
    guint16 code; /* TINKER_LATEST_COUNT times its kind, and a TinkerLatest */
    guint16 to, a, b, c, d;
} TinkerStep;

struct _TinkerCompiled {
    int arguments; /* up to the last one that it reads */
    int numbers, registers, steps;
    int answer;           /* an entry: what the last step answered, where there is one */
    const double *number; /* as many, and 0 up to TINKER_USUAL_NUMBERS */
    TinkerStep step[];
};

#endif
