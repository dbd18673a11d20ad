/* Expressions of t, compiled. A program is a list of instructions, each of which uses results of earlier ones; the last
 * one is the value.
 *
 * All switching goes through one instruction. TINKER_OP_SWITCH looks into which *cell* its argument falls: for a single
 * level, cell -1 below 0 and cell 0 from there on; for periodic levels, floor(argument / period). The functions that
 * switch are smooth functions of their arguments and of cells: abs(x) chooses -x or x by the cell of x, mod(a, b) is
 * a - b * floor(a / b). Cells are decided once for a piece and are constants within it. A break is where a cell
 * changes.
 */
#ifndef TINKER_EXPRESSION_PROGRAM_H
#define TINKER_EXPRESSION_PROGRAM_H

#include <math.h>

#include <glib.h>

#include "units/expression/expression-tree.h"
#include "units/expression/interval.h"

typedef enum {
    TINKER_OP_CONSTANT, /* number */
    TINKER_OP_TIME,
    TINKER_OP_SWITCH, /* the cell of a; number is the period of the levels, 0 for the single level 0 */
    TINKER_OP_TRUTH,  /* 0 where a is not 0, else -1: the condition of an `if`. What a compares to has breaks, this none
                       */
    TINKER_OP_CHOOSE, /* a where the cell of c is negative, else b */
    TINKER_OP_PARITY, /* 1 where a is even, else -1 */
    TINKER_OP_NEGATE,
    TINKER_OP_ADD,
    TINKER_OP_SUBTRACT,
    TINKER_OP_MULTIPLY,
    TINKER_OP_DIVIDE,
    TINKER_OP_POWER,
    TINKER_OP_ATAN2, /* of a (y) and b (x); the cell of c, that of y, says which side of the cut is meant */
    TINKER_OP_SIN,   /* from here on functions of one argument, a */
    TINKER_OP_COS,
    TINKER_OP_TAN,
    TINKER_OP_ASIN,
    TINKER_OP_ACOS,
    TINKER_OP_ATAN,
    TINKER_OP_SINH,
    TINKER_OP_COSH,
    TINKER_OP_TANH,
    TINKER_OP_EXP,
    TINKER_OP_LOG,
    TINKER_OP_SQRT,
} TinkerOperation;

typedef struct {
    TinkerOperation operation;
    int a, b, c;   /* earlier instructions; -1 where there is none */
    int guard;     /* the branch of an `if` that it stands in; -1 outside of all */
    double number; /* see the operations */
} TinkerInstruction;

/* One branch of an `if`: entered where the TINKER_OP_TRUTH instruction `truth` is as `taken` says. */
typedef struct {
    int truth;
    int parent; /* the guard around this one; -1 for none */
    gboolean taken;
} TinkerGuard;

typedef struct {
    GArray *code;   /* of TinkerInstruction */
    GArray *guards; /* of TinkerGuard */
} TinkerProgram;

/* A function's value and its first and second derivative by time, and an enclosure of the three. */
typedef struct {
    double value, first, second;
} TinkerJet;

typedef struct {
    TinkerInterval value, first, second;
} TinkerRangeJet;

/* slope * t + offset, where `valid`. */
typedef struct {
    gboolean valid;
    double slope, offset;
} TinkerAffine;

/* A program in use: the cells of a piece, and which instructions matter for the value of one of them, `root`. */
typedef struct {
    const TinkerProgram *program;
    double *cells; /* by instruction; of those that switch */
    guint8 *marks; /* scratch of select */
    int *live;     /* the instructions behind `root` by these cells, in order */
    int live_count;
    int root;
    TinkerJet *jets;        /* scratch of evaluate, by instruction */
    TinkerRangeJet *ranges; /* scratch of enclose and of the search; NULL where the state is not used for searching */
    TinkerAffine *affine;
} TinkerProgramState;

/* Compiles; see tinker_waveform_new_expression. Where the text says t, the program takes t + shift. A text that was
 * compiled once can be compiled with any finite shift. (transfer full) */
TinkerProgram *tinker_program_parse(const char *text, double shift, GError **error);

/* Compiles a tree over these names, of `most` instructions at most; of a law of t alone the names are "t". What the
 * tree shares is worked out once; an `if` works out both its values. NULL: it is longer, or names something else.
 * (transfer full) */
TinkerProgram *tinker_program_of_tree(const TinkerExpression *expression, const char *const *names, int count,
                                      guint most);

/* Whether there is a switch in it, so that it may have breaks. */
gboolean tinker_program_switches(const TinkerProgram *program);

/* The compiler's hand: an empty program; adding an instruction, with constants folded (answers the index that holds the
 * result); throwing away what the last instruction, the value, does not need. */
TinkerProgram *tinker_program_new(void);
int tinker_program_emit(TinkerProgram *program, TinkerInstruction instruction);
int tinker_program_add_guard(TinkerProgram *program, TinkerGuard guard);
void tinker_program_finish(TinkerProgram *program, int value);
void tinker_program_free(TinkerProgram *program);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerProgram, tinker_program_free)

/* Where the compiler adds to a program: under this guard. */
typedef struct {
    TinkerProgram *program;
    int guard;
} TinkerBuilder;

int tinker_build(TinkerBuilder *builder, TinkerOperation operation, int a, int b, int c, double number);

/* In the order in which their signs are looked for, the longer ones first. */
typedef enum {
    TINKER_COMPARE_AT_MOST,
    TINKER_COMPARE_AT_LEAST,
    TINKER_COMPARE_EQUAL,
    TINKER_COMPARE_UNEQUAL,
    TINKER_COMPARE_BELOW,
    TINKER_COMPARE_ABOVE,
} TinkerComparison;

int tinker_build_comparison(TinkerBuilder *builder, TinkerComparison comparison, int a, int b);

/* A function: how many arguments, as it is written, and the code for it. */
#define TINKER_MOST_ARGUMENTS 3
typedef struct {
    const char *name;
    int arguments;
    const char *form;
    TinkerOperation operation; /* of a plain function of one argument */
    int (*build)(TinkerBuilder *builder, const int *arguments);
} TinkerFunction;

extern const TinkerFunction tinker_functions[]; /* ends with an entry without name */
const TinkerFunction *tinker_function_lookup(const char *name);
int tinker_build_function(TinkerBuilder *builder, const TinkerFunction *function, const int *arguments);

/* What a text is read into, in the order in which it is worked out: every function but the branches' answers a handle
 * of its own, at least 0. */
typedef struct {
    gboolean (*has_room)(void *into); /* FALSE: the text is too long */
    int (*number)(void *into, double value);
    int (*time)(void *into);
    int (*name)(void *into, const char *name);                             /* NULL where no names are given */
    int (*operation)(void *into, TinkerOperation operation, int a, int b); /* b is -1 where it has one argument */
    int (*comparison)(void *into, TinkerComparison comparison, int a, int b);
    int (*function)(void *into, const TinkerFunction *function, const int *arguments);
    int (*condition)(void *into, int value);                     /* what the first argument of an `if` becomes; */
    void (*enter_branch)(void *into, int truth, gboolean taken); /* its others stand in branches */
    void (*leave_branch)(void *into);
} TinkerReader;

/* What a text may name beside t, pi and functions. */
typedef struct {
    const char *const *names;  /* ended by NULL; NULL: none */
    TinkerReferenceFunc refer; /* of what stands in braces; NULL: nothing may */
    void *data;
} TinkerReadable;

/* Reads a text, which may use these names (NULL: none): the handle of its value, or TINKER_READER_FAILED. */
#define TINKER_READER_FAILED (-1)
int tinker_expression_read(const char *text, const TinkerReadable *names, const TinkerReader *reader, void *into,
                           GError **error);

const TinkerInstruction *tinker_program_code(const TinkerProgram *program, int *count);

void tinker_program_state_init(TinkerProgramState *state, const TinkerProgram *program, gboolean searching);
void tinker_program_state_clear(TinkerProgramState *state);

/* Decides all cells at the time `inside` and selects the program's value. */
void tinker_program_decide(TinkerProgramState *state, double inside);

/* Selects what instruction `root` needs by the cells as they stand. */
void tinker_program_select(TinkerProgramState *state, int root);

/* The selected instruction at t, and over [low, high]: by the cells as they stand. */
TinkerJet tinker_program_evaluate(const TinkerProgramState *state, double t);
TinkerRangeJet tinker_program_enclose(const TinkerProgramState *state, double low, double high);

/* ulp of t: places as near as this are one, to the searches for breaks and for poles. */
#define TINKER_MERGED 4

/* So many ulp of t, s. */
static inline double tinker_ulps(double t, int count)
{
    return count * (nextafter(fabs(t), INFINITY) - fabs(t));
}

/* As tinker_waveform_next_break; changes the state's cells and selection. */
double tinker_program_next_break(TinkerProgramState *state, double t, double horizon);

/* As tinker_waveform_next_pole; changes the state's cells and selection. */
double tinker_program_next_pole(TinkerProgramState *state, double t, double end);

/* The cell of an argument, by a SWITCH or TRUTH instruction. */
double tinker_instruction_cell(const TinkerInstruction *instruction, double argument);

/* The cell of a piece, from the argument at a time inside it. That time may happen to be one at which the argument
 * touches a level or passes through 0: the derivatives then tell what it is on both sides. */
double tinker_instruction_decide(const TinkerInstruction *instruction, const TinkerJet *argument);

/* A smooth operation on its arguments; b only where it has two, `cell` only for TINKER_OP_ATAN2. */
TinkerJet tinker_jet_apply(TinkerOperation operation, const TinkerJet *a, const TinkerJet *b, double cell);
TinkerRangeJet tinker_range_jet_apply(TinkerOperation operation, const TinkerRangeJet *a, const TinkerRangeJet *b,
                                      double cell);

#endif
