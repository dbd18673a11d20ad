/* Applied forces of a model, their energies and their derivatives. */
#ifndef TINKER_CORE_FORCES_H
#define TINKER_CORE_FORCES_H

#include "physics/model/model-data.h"

/* Asking plugins for forces, for the state in the points. What is answered lies in the model's chunk until the next
 * call. A force that is not finite is a failure, which is recorded. */

/* Of lines: lengths (m), their rates (m/s), tensions (N), and unit vectors from the first ends to the second, 0 at
 * length 0; with room for one more column. */
typedef struct {
    double *length, *rate, *tension, *still, *x, *y;
} TinkerLineChunk;

/* Of the lines of a view, at most TINKER_CHUNK of them; `points` are those of their ends. */
TinkerStatus tinker_model_ask_lines(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                    TinkerBatch *view, TinkerLineChunk *chunk);
/* Of `count` force elements from `first` on, at most TINKER_CHUNK: the force (N) on each of their ends, which lie on
 * `points`, and the torque (N m) on what each end is on. */
typedef struct {
    const double *force;  /* two an end */
    const double *torque; /* NULL where they give none, ... */
    const int32_t *turns; /* ... and so this: the points that torques act on */
} TinkerElementForces;
TinkerStatus tinker_model_ask_element(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                      int32_t first, int32_t count, TinkerElementForces *answer);
/* What those on ends without angles do where no end moves: the force on each end, 0 where that is no number. */
TinkerStatus tinker_model_ask_element_at_rest(TinkerModel *model, const TinkerBlockBatch *batch, const int32_t *points,
                                              int32_t first, int32_t count, const double **answer);
/* Of `count` fields from `first` on: the force (N) of all of them on each body. */
TinkerStatus tinker_model_ask_field(TinkerModel *model, const TinkerBlockBatch *batch, int32_t first, int32_t count,
                                    const double **force);
/* Records why a plugin gave no `what`, where `status` is a failure; answers the status to go on with. */
TinkerStatus tinker_model_refuse_forces(TinkerModel *model, const TinkerBlockBatch *batch, const TinkerBatch *view,
                                        TinkerStatus status, const char *what);

/* Adds up all applied forces by point, for the state in the points; a = M^-1 f. With `books` also the power that each
 * book gives, into model->book_power. */
TinkerStatus tinker_model_applied(TinkerModel *model, double *a, gboolean books);

/* Whether any force depends on velocities: what is asked may, and is taken to. */
gboolean tinker_model_feels_velocities(const TinkerModel *model);

/* Energies (J), for the state in the points. */
typedef struct {
    double kinetic;
    double potential;        /* of all blocks, relative to the origin */
    double in_fields;        /* part of it: of bodies in fields of any kind */
    double stored_in_forces; /* part of it: of force elements that are asked */
    double stored_in_fields; /* and of fields that are asked */
} TinkerEnergy;
TinkerStatus tinker_model_energy(TinkerModel *model, TinkerEnergy *energy);

/* What a change of velocities gives (J); 2 entries a body each. */
double tinker_model_kinetic_change(const TinkerModel *model, const double *before, const double *after);

/* out = d(M^-1 f)/dv dv and d(M^-1 f)/dq dq of the line laws and fields, for the state in the points. */
TinkerStatus tinker_model_damping_product(TinkerModel *model, const double *dv, double *out);
TinkerStatus tinker_model_stiffness_product(TinkerModel *model, const double *dq, double *out);

/* Kernels over merged lines: forces added up by point, and the power that dampers take (NULL: not asked). */
void tinker_lines_add_forces(const TinkerMergedLines *lines, const TinkerPoint *points, double *force, double *taken);
/* The lines from first to end - 1, with the forces on their second ends added up at `slots` in place of the points b;
 * answers the power that dampers take. */
double tinker_lines_add_range(const TinkerMergedLines *lines, const int32_t *slots, int32_t first, int32_t end,
                              const TinkerPoint *points, double *force);

#endif
