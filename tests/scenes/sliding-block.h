/* A rigid block on ground that moves sideways, by exact pieces: what a friction of constant size does to it. */
#ifndef TEST_SLIDING_BLOCK_H
#define TEST_SLIDING_BLOCK_H

#include <glib.h>

/* The ground starts at rest with an acceleration (m/s^2) that is linear between the `count` rows of a record; the block
 * lies on it and is carried along by at most `grip` (m/s^2, friction coefficient times gravity), sliding or not.
 * Answers the displacements (m) of both at the rising times `at`, which lie within the record. Between two events both
 * velocities are polynomials of degree 2, whose roots are those events: nothing here is stepped. */
void sliding_block_at(const double *times, const double *acceleration, gsize count, double grip, const double *at,
                      gsize at_count, double *block, double *ground);

#endif
