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

/* The coordinate of a body; -1 for none. */
int tinker_matrix_coordinate_of(const TinkerMatrixBuilder *builder, TinkerBlockId body);

/* The equation of a body; NULL: the block is none. Borrowed. */
const TinkerBodyEquation *tinker_matrix_equation_of(const TinkerMatrixBuilder *builder, TinkerBlockId body);

/* The mass along coordinate i, and the forces along it but for those of connectors. */
void tinker_matrix_add_body(TinkerMatrixBuilder *builder, guint i);

/* The pull of a connector on the body at one of its ends. */
void tinker_matrix_add_pull(TinkerMatrixBuilder *builder, const TinkerLineEquation *line, int end);

#endif
