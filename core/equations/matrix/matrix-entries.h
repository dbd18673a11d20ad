/* The entries of an island's matrices, body by body and connector by connector. */
#ifndef TINKER_CORE_MATRIX_ENTRIES_H
#define TINKER_CORE_MATRIX_ENTRIES_H

#include "equations/matrix/matrix.h"

typedef struct {
    const TinkerEquations *equations;
    TinkerMatrixIsland *island;
    const char *why; /* it cannot be written; NULL so far */
} TinkerMatrixBuilder;

/* A coordinate of a body along a unit vector. All are there before an entry is. */
void tinker_matrix_add_coordinate(TinkerMatrixBuilder *builder, TinkerBlockId body, double ux, double uy);

/* That a body turns by, likewise. */
void tinker_matrix_add_angle(TinkerMatrixBuilder *builder, TinkerBlockId body);

/* The coordinate of a body; -1 for none. */
int tinker_matrix_coordinate_of(const TinkerMatrixBuilder *builder, TinkerBlockId body);

/* The equation of a body; NULL: the block is none. Borrowed. */
const TinkerBodyEquation *tinker_matrix_equation_of(const TinkerMatrixBuilder *builder, TinkerBlockId body);

/* The mass along coordinate i, and the forces along it but for those of connectors. */
void tinker_matrix_add_body(TinkerMatrixBuilder *builder, guint i);

/* The pull of a connector on the body at one of its ends. */
void tinker_matrix_add_pull(TinkerMatrixBuilder *builder, const TinkerLineEquation *line, int end);

/* Bodies on fixed axes (matrix-shafts.c): adds the coordinates of what turns, and answers how all of them turn with
 * these; sets `why` where that cannot be told. (transfer full) */
GArray *tinker_matrix_shafts(TinkerMatrixBuilder *builder);
/* The inertias of all of them, and the torques on them. */
void tinker_matrix_add_shafts(TinkerMatrixBuilder *builder, const GArray *shafts);

/* A quantity of a body's state. (transfer full) */
TinkerExpression *tinker_matrix_state_symbol(const TinkerMatrixBuilder *builder, TinkerBlockId body,
                                             const char *quantity);
/* With definitions written out, so that it speaks of the state itself; functions of time alone keep their names.
 * (transfer full) */
TinkerExpression *tinker_matrix_written_out(const TinkerMatrixBuilder *builder, const TinkerExpression *expression);
gboolean tinker_matrix_uses_state(const TinkerMatrixBuilder *builder, const TinkerExpression *expression);

/* Adds to an entry, or to the load of a coordinate; uses the expression up. */
void tinker_matrix_add(TinkerMatrixBuilder *builder, TinkerMatrixKind kind, guint row, guint column,
                       TinkerExpression *more);
void tinker_matrix_add_load(TinkerMatrixBuilder *builder, guint number, TinkerExpression *more);

#endif
