/* Bodies and contacts of chance, and the laws of contact worked out by themselves. */
#ifndef TINKER_TESTS_CONTACT_CASE_H
#define TINKER_TESTS_CONTACT_CASE_H

#include <glib.h>

enum { CASE_CONTACTS = 10, CASE_WIDTH = 2 * CASE_CONTACTS };

/* Solves n equations, the right side in column n, by partial pivoting; the solution is left there. FALSE where the
 * system is singular. */
gboolean contact_case_eliminate(int32_t n, long double a[CASE_WIDTH][CASE_WIDTH + 1]);

typedef struct {
    int32_t count;
    double delassus[CASE_WIDTH * CASE_WIDTH], before[CASE_WIDTH];
    double friction[CASE_CONTACTS];
    int8_t sliding[CASE_CONTACTS];
} ContactCase;

/* W = J M^-1 J^T for a random J over `freedoms` coordinates, of whole numbers or not, and masses that differ by up to
 * 10^spread; before = J v. */
void contact_case_fill(ContactCase *self, GRand *random, int32_t count, int32_t freedoms, gboolean whole,
                       double spread);

/* A chain of masses and rods on a plane and beside a wall, rods often level, upright or in line: W = J P M^-1 J^T with
 * P that keeps the rods' lengths. Velocities keep them too, often those of a single blow, and miss by up to `noise`. */
void contact_case_fill_chain(ContactCase *self, GRand *random, double noise);

/* before + W p, and what is rounding in it. */
void contact_case_after(const ContactCase *self, const double *p, double *after, double *rounding);

/* Whether any of all combinations of open, sticking and sliding solves, with v = before + W p, what contact-private.h
 * says. */
gboolean contact_case_has_solution(const ContactCase *self);

#endif
