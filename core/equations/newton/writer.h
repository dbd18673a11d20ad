/* What the files that write equations share. */
#ifndef TINKER_CORE_EQUATIONS_WRITER_H
#define TINKER_CORE_EQUATIONS_WRITER_H

#include "equations/newton/equations.h"
#include "law/block-law.h"
#include "scene/frame/frame.h"

extern const TinkerDimension tinker_length_dimension, tinker_velocity_dimension, tinker_force_dimension,
    tinker_pure_dimension, tinker_torque_dimension, tinker_angle_dimension;

typedef struct {
    TinkerEquations *equations;
    TinkerScene *scene;
    const TinkerModelState *state;
    TinkerFrame *frame;   /* at the state's time, for the columns of blocks and supports that nobody describes */
    TinkerFrame *start;   /* as placed */
    gboolean constrained; /* there are constraints: bodies may get angles, those of rods and arms */
    GHashTable *indices;  /* block to char *: its number among those of its group */
    GHashTable *stems;    /* stem to how many blocks use it */
    GHashTable *by_name;  /* name to TinkerEquationDefinition */
    GHashTable *points;   /* block of a support to its TinkerPointSymbols */
    GHashTable *body_of;  /* block of a body to its TinkerBodyEquation */
    GHashTable *places;   /* names of definitions that say where points of bodies are: slopes by a place or an angle
                             take these as they stand */
    GHashTable *sampled;  /* name of a symbol of a table, or of its rate, to TinkerSampledSymbol */
    GArray *slopes;       /* of TinkerRowSlope */
    double time_behind;   /* s: the state's, behind what switches there */
    double extent;        /* m: how far from the origin bodies are */
} TinkerEquationWriter;

/* A function of time that only its table knows, or a plugin that does not tell: it and its first derivatives are
 * symbols with values. */
typedef struct {
    TinkerBlockId block;
    const char *stem;      /* static, or interned */
    const char *component; /* "x", "y", "φ"; static; NULL: none */
    double values[3];      /* its own, and those of its derivatives */
    int dots;              /* derivatives that this symbol stands for */
    TinkerDimension dimension;
    const char *why;  /* it is not written */
    const char *rate; /* name of its derivative; NULL: nothing has asked for it yet */
} TinkerSampledSymbol;

/* What a constraint row does to a body: its slopes by x, y and angle, each over the root of what is moved. */
typedef struct {
    guint row; /* number of the constraint equation */
    TinkerBlockId body;
    double slope[3];
} TinkerRowSlope;

/* A place and its velocity; each is owned. */
typedef struct {
    TinkerBlockId block; /* of a body that can move; -1: of none */
    TinkerExpression *x, *y, *vx, *vy;
    TinkerExpression *angle, *rate;      /* of what it is on; 0 of a point mass */
    TinkerExpression *arm_x, *arm_y;     /* from the centre of a body that turns; NULL at the centre, and of others */
    TinkerExpression *local_x, *local_y; /* likewise, in the body's own axes */
} TinkerPointSymbols;

void tinker_point_symbols_clear(TinkerPointSymbols *point);

/* The law of a block: that which its type states, or which is typed into it. NULL: none, or with an error one that
 * cannot be read. (transfer full) */
TinkerBlockLaw *tinker_writer_law_of(const TinkerEquationWriter *writer, TinkerBlockId block, GError **error);

/* Names ----------------------------------------------------------------------------------------------------------- */

/* Counts which stems are used by whom, and numbers the blocks. */
void tinker_writer_number_blocks(TinkerEquationWriter *writer);

/* A free name for a block's symbol, "k" or "k_1", with its look. Borrowed from the equations. */
const char *tinker_writer_name(TinkerEquationWriter *writer, TinkerBlockId block, const char *stem, int dots,
                               const char *component);

/* The number of a body among bodies; "" where it is the only one. Borrowed. */
const char *tinker_writer_index(const TinkerEquationWriter *writer, TinkerBlockId block);

/* Symbols --------------------------------------------------------------------------------------------------------- */

/* A new symbol, of which the value is known. (transfer full) */
TinkerExpression *tinker_writer_symbol(TinkerEquationWriter *writer, const char *name, TinkerBlockId block,
                                       double value, TinkerDimension dimension, const char *property,
                                       const char *quantity);

/* Says what a symbol or a definition is worth at the time: a name without a value counts as 0. */
void tinker_equations_set_value(TinkerEquations *equations, const char *name, double value);

/* Says how exact a value is that is not rounded to its own last digit, as of a coordinate beside a larger one. */
void tinker_equations_set_rounding(TinkerEquations *equations, const char *name, double rounding);

/* Works out how exact definitions and unknown forces are, when all is written. */
void tinker_equations_bound_roundings(TinkerEquations *equations);

/* One with a value and no more. (transfer full) */
TinkerExpression *tinker_writer_valued(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means);

/* A new symbol of what is known by values alone, of which rates are taken; `means` is static. (transfer full) */
TinkerExpression *tinker_writer_sampled(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means);

/* The symbol that a property has already; NULL. (transfer full) */
TinkerExpression *tinker_writer_known_property(const TinkerEquationWriter *writer, TinkerBlockId block,
                                               const char *key);

/* What a property's column stands for: a symbol of this stem, the same for each call; 0 where its value is 0. (transfer
 * full) */
TinkerExpression *tinker_writer_property(TinkerEquationWriter *writer, TinkerBlockId block, int32_t property,
                                         int32_t component, const char *stem);

/* The property that carries a meaning. */
TinkerExpression *tinker_writer_meaning(TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning,
                                        int32_t component, const char *stem);

/* What a definition means that is an energy. */
#define TINKER_STORED_ENERGY "stored energy"

/* A new definition; takes `is` over and answers its symbol; what is a number or one symbol needs none, and is
 * answered itself. (transfer full) */
TinkerExpression *tinker_writer_define(TinkerEquationWriter *writer, const char *name, TinkerBlockId block,
                                       TinkerDimension dimension, const char *means, TinkerExpression *is,
                                       gboolean typed);

/* Takes back all definitions from this number on. */
void tinker_writer_drop_definitions(TinkerEquationWriter *writer, guint from);

/* The derivative of an expression by time, through definitions. (transfer full) */
TinkerExpression *tinker_writer_rate(TinkerEquationWriter *writer, const TinkerExpression *expression);

/* The derivative of an expression by a symbol, through definitions. (transfer full) */
TinkerExpression *tinker_writer_derivative(TinkerEquationWriter *writer, const TinkerExpression *expression,
                                           const char *symbol);

/* The slope of a potential by a symbol, or minus that where `sign` is -1, as a textbook has it. (transfer full) */
TinkerExpression *tinker_writer_slope(TinkerEquationWriter *writer, const TinkerExpression *potential,
                                      const char *symbol, int sign);

/* A law with the names of one block: definitions of its steps are added, and what `wanted` says is answered (transfer
 * full); NULL where the law does not say it. */
typedef struct {
    TinkerBlockId block;
    const TinkerBlockLaw *law;
    GHashTable *meanings; /* symbol of the law to TinkerExpression: what stands for it; those of the role are put in by
                             the caller, others are added */
    const char *index;    /* of definitions; NULL: the block's */
} TinkerLawUse;

void tinker_law_use_init(TinkerLawUse *use, TinkerBlockId block, const TinkerBlockLaw *law);
/* Gives the symbols of ends that the law names their meaning. */
void tinker_law_use_set_ends(TinkerEquationWriter *writer, TinkerLawUse *use, const GArray *points);
void tinker_law_use_clear(TinkerLawUse *use);
void tinker_law_use_set(TinkerLawUse *use, const char *symbol, const TinkerExpression *meaning);
TinkerExpression *tinker_law_use_equation(TinkerEquationWriter *writer, TinkerLawUse *use, const char *wanted);

/* Places ---------------------------------------------------------------------------------------------------------- */

/* For TinkerEquationWriter.points. (transfer full) */
GHashTable *tinker_writer_points_new(void);

/* The centre of a support, or of a body. */
void tinker_writer_centre(TinkerEquationWriter *writer, TinkerBlockId block, TinkerPointSymbols *point);

/* Of an end of a block. */
void tinker_writer_end(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number,
                       TinkerPointSymbols *point);

/* Of all ends. Element: TinkerPointSymbols. (transfer full) */
GArray *tinker_writer_ends(TinkerEquationWriter *writer, TinkerBlockId block);

/* What an end had at the start, as a symbol: its 'x', 'y', or its 't'urn. (transfer full) */
TinkerExpression *tinker_writer_start(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number,
                                      char quantity);

/* Terms ----------------------------------------------------------------------------------------------------------- */

/* Adds to the equation of the body at a point; takes x, y and torque (NULL: none beside that of the force) over.
 * Nothing where all are 0, or where the point is on no body. */
void tinker_writer_add_term(TinkerEquationWriter *writer, const TinkerPointSymbols *at, TinkerBlockId by,
                            TinkerTermKind kind, TinkerExpression *x, TinkerExpression *y, TinkerExpression *torque);
void tinker_term_clear(void *term);

/* A block acts and does not say how: symbols for its forces on each body. */
void tinker_writer_add_unwritten(TinkerEquationWriter *writer, TinkerBlockId block, TinkerTermKind kind,
                                 const char *why);
/* That a symbol stands for what is not written. */
void tinker_writer_note_unwritten(TinkerEquationWriter *writer, TinkerBlockId block, const char *symbol,
                                  const char *why);

/* What a block of each role does. FALSE with the reason where its law does not say. */
gboolean tinker_writer_add_line(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law);
gboolean tinker_writer_add_force(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law);
gboolean tinker_writer_add_field(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law);
gboolean tinker_writer_add_constraint(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law);
void tinker_writer_add_contacts(TinkerEquationWriter *writer);

/* L, the sum of the distances along the ends, as a definition. (transfer full) */
TinkerExpression *tinker_writer_length(TinkerEquationWriter *writer, TinkerBlockId block,
                                       const TinkerPointSymbols *points, int32_t count);

/* Adds a constraint with its multiplier, whose value is what fits the forces that the run has. Answers the multiplier's
 * symbol. (transfer full) */
void tinker_writer_add_row(TinkerEquationWriter *writer, TinkerBlockId block, TinkerExpression *g,
                           TinkerDimension dimension, const char *multiplier, gboolean active);

/* What the row that was added last can hold at most, which is taken over. */
void tinker_writer_limit_row(TinkerEquationWriter *writer, TinkerExpression *limit);

/* Says of the row that was added last what it does to a body. */
void tinker_writer_note_slope(TinkerEquationWriter *writer, TinkerBlockId body, const double slope[3]);

/* Marks the active rows that depend on each other. */
void tinker_writer_mark_redundant(TinkerEquationWriter *writer);

/* For who writes equations of another form: a line between the two ends. */
void tinker_writer_keep_line(GPtrArray *list, TinkerBlockId block, const GArray *points, const TinkerExpression *length,
                             const TinkerExpression *rate, const TinkerExpression *tension);

#endif
