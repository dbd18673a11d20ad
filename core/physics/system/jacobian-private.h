/* What the two halves of a jacobian share: its layout, in blocks of two by two, a body by a body. The rows 2 i and 2 i
 * + 1 have the same places, so a block is known by where its first entry is. Where bodies turn, the columns of turns
 * stand behind those blocks and their rows behind all others; such a model goes by coordinates one by one. */
#ifndef TINKER_CORE_JACOBIAN_PRIVATE_H
#define TINKER_CORE_JACOBIAN_PRIVATE_H

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/system/jacobian.h"

/* Where a line's two off-diagonal blocks begin; -1 where an end is on a support. */
typedef struct {
    int32_t ab, ba;
} TinkerLineSlots;

struct _TinkerJacobian {
    TinkerModel *model;
    TinkerPattern pattern;
    int32_t *row_starts, *columns;
    int32_t *diagonal; /* of each body: where its block begins */
    TinkerLineSlots *merged;
    TinkerLineSlots **asked; /* by batch of asked lines */
    double *force;           /* of one element or body, twice: with a coordinate lowered and raised */

    /* the evaluation in progress */
    double *stiffness, *damping;
    double distance, speed; /* that differences reach: m, m/s */
};

/* Adds sign * block to the block of `row` that begins at `slot`. */
static inline void tinker_jacobian_add(const TinkerJacobian *self, double *values, int32_t row, int32_t slot,
                                       double sign, const double block[4])
{
    int32_t below = slot + self->row_starts[2 * row + 1] - self->row_starts[2 * row];
    values[slot] += sign * block[0];
    values[slot + 1] += sign * block[1];
    values[below] += sign * block[2];
    values[below + 1] += sign * block[3];
}

/* jacobian-turns.c: adds sign * block, of what acts on one point by the place of another, to the coordinates that both
 * depend on. */
void tinker_jacobian_spread(const TinkerJacobian *jacobian, double *values, int32_t on, int32_t of, double sign,
                            const double block[4]);
/* Where the entry of two coordinates is. */
int32_t tinker_jacobian_find_entry(const TinkerJacobian *jacobian, int32_t row, int32_t column);
/* The part of what forces at arms do that comes of the arms' turning. */
TinkerStatus tinker_jacobian_add_turned_arms(TinkerJacobian *jacobian);
/* mass J^T J of a row. */
void tinker_jacobian_add_row_mass(const TinkerJacobian *jacobian, int32_t row, double mass, double *values);
/* mass J^T J of a closed gap function: of its normal and, where it sticks, of its tangential row. */
void tinker_jacobian_add_gap_mass(const TinkerJacobian *jacobian, const TinkerContact *contact, double *values);
/* Where the block of two bodies begins. */
int32_t tinker_jacobian_find(const TinkerJacobian *jacobian, int32_t row, int32_t column);

/* jacobian-asked.c: chooses how far differences reach, and adds what force elements and fields give, for the state in
 * the points. */
void tinker_jacobian_choose_differences(TinkerJacobian *jacobian);
TinkerStatus tinker_jacobian_add_elements(TinkerJacobian *jacobian, const TinkerAskedBatch *asked);
TinkerStatus tinker_jacobian_add_field(TinkerJacobian *jacobian, const TinkerAskedBatch *asked);

#endif
