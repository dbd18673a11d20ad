/* When a row, a column or a pivot counts as dependent on others: one threshold for all of the program, so that what
 * plans, steps, modes and contacts call the rank of one mechanism is one number. */
#ifndef TINKER_NUMERICS_RANK_H
#define TINKER_NUMERICS_RANK_H

/* No unit: what is left of a row of J M^-1 J^T, or of a singular value, beside what it was, or beside the largest. It
 * is a mechanism within 1e-5 rad of a singular place. Smaller, and what is left is mostly rounding, which a solve would
 * magnify; larger, and chains of masses in the ratio 1e9 would be taken for singular. Bodies that touch and whose
 * masses differ by more have one of their own (TINKER_UNEVEN_DEPENDENT). */
#define TINKER_DEPENDENT 1e-10

#endif
