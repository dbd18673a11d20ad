/* Newton's matrix I - gamma J, with
 *
 *     J = d(v, a)/d(q, v) = [ 0, I; -M^-1 K, -M^-1 C ],    K = -df/dq, C = -df/dv
 *
 * from the system's pattern and jacobian: dense for a handful of unknowns, else sparse and factored by KLU. K and C are
 * those of the applied forces; with rods they are not the derivatives of the accelerations, but Newton's iteration
 * needs these only in the rough, and differences of them cost more than the few iterations that they save. Where no
 * jacobian is offered, CVODE takes differences of a dense matrix. KLU allots memory when it analyses the matrix, in the
 * first step after a start; no other step allots any.
 */
#include "stepper-private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#define DENSE_UNKNOWNS 16 /* at most, with a jacobian */
#define ORDERING_AMD   0  /* of KLU */

static int offers_jacobian(const TinkerSystem *system)
{
    return system->struct_size >= offsetof(TinkerSystem, jacobian) + sizeof system->jacobian &&
           system->pattern != NULL && system->jacobian != NULL;
}

/* Evaluates K and C, and bounds the frequencies: the square of one is at most the largest row sum of |M^-1 K|. */
static TinkerStatus evaluate(Stepper *stepper, double t, const double *q, const double *v)
{
    const TinkerSystem *system = stepper->system;
    const TinkerPattern *pattern = system->pattern;
    TinkerStatus status = system->jacobian(system->context, t, q, v, stepper->stiffness, stepper->damping);
    if (status != TINKER_OK) return status;
    double most = 0.0;
    for (int32_t row = 0; row < pattern->size; row++) {
        double sum = 0.0;
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
            sum += fabs(stepper->stiffness[k]);
        most = fmax(most, sum / system->mass[row]);
    }
    stepper->fastest = isfinite(most) ? sqrt(most) : 0.0;
    return TINKER_OK;
}

/* The sparse matrix row by row. The upper rows hold a 0 on their diagonal, so that I has its place. */
static void fill_sparse(const Stepper *stepper, SUNMatrix matrix)
{
    const TinkerPattern *pattern = stepper->system->pattern;
    int32_t n = pattern->size;
    double *value = SM_DATA_S(matrix);
    memcpy(SM_INDEXPTRS_S(matrix), stepper->row_starts, (2 * (size_t)n + 1) * sizeof(sunindextype));
    memcpy(SM_INDEXVALS_S(matrix), stepper->columns, (size_t)stepper->row_starts[2 * n] * sizeof(sunindextype));
    for (int32_t row = 0; row < n; row++) {
        *value++ = 0.0;
        *value++ = 1.0;
    }
    for (int32_t row = 0; row < n; row++) {
        int32_t first = pattern->row_starts[row], count = pattern->row_starts[row + 1] - first;
        double scale = -1.0 / stepper->system->mass[row];
        for (int32_t k = 0; k < count; k++) {
            value[k] = scale * stepper->stiffness[first + k];
            value[count + k] = scale * stepper->damping[first + k];
        }
        value += 2 * count;
    }
}

static void fill_dense(const Stepper *stepper, SUNMatrix matrix)
{
    const TinkerPattern *pattern = stepper->system->pattern;
    int32_t n = pattern->size;
    for (int32_t row = 0; row < n; row++) {
        double scale = -1.0 / stepper->system->mass[row];
        SM_ELEMENT_D(matrix, row, n + row) = 1.0;
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++) {
            SM_ELEMENT_D(matrix, n + row, pattern->columns[k]) = scale * stepper->stiffness[k];
            SM_ELEMENT_D(matrix, n + row, n + pattern->columns[k]) = scale * stepper->damping[k];
        }
    }
}

static int jacobian(realtype t, N_Vector y, N_Vector derivative, SUNMatrix matrix, void *data, N_Vector work1,
                    N_Vector work2, N_Vector work3)
{
    Stepper *stepper = data;
    const double *q = N_VGetArrayPointer(y);
    TinkerStatus status = evaluate(stepper, t, q, q + stepper->system->size);
    if (status != TINKER_OK) return status == TINKER_RETRY_SMALLER ? 1 : -1;
    if (stepper->row_starts != NULL)
        fill_sparse(stepper, matrix);
    else
        fill_dense(stepper, matrix);
    return 0;
}

/* Where the entries of the sparse matrix stand. */
static int place_entries(Stepper *stepper)
{
    const TinkerPattern *pattern = stepper->system->pattern;
    int32_t n = pattern->size;
    stepper->row_starts = malloc((2 * (size_t)n + 1) * sizeof(sunindextype));
    stepper->columns = malloc(2 * ((size_t)n + (size_t)pattern->entries) * sizeof(sunindextype));
    if (stepper->row_starts == NULL || stepper->columns == NULL) return 0;
    sunindextype place = 0;
    for (int32_t row = 0; row < n; row++) {
        stepper->row_starts[row] = place;
        stepper->columns[place++] = row;
        stepper->columns[place++] = n + row;
    }
    for (int32_t row = 0; row < n; row++) {
        stepper->row_starts[n + row] = place;
        for (sunindextype shift = 0; shift <= n; shift += n)
            for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
                stepper->columns[place++] = shift + pattern->columns[k];
    }
    stepper->row_starts[2 * n] = place;
    return 1;
}

static int create_sparse(Stepper *stepper)
{
    sunindextype unknowns = stepper_unknowns(stepper->system);
    if (!place_entries(stepper)) return 0;
    stepper->matrix = SUNSparseMatrix(unknowns, unknowns, stepper->row_starts[unknowns], CSR_MAT, stepper->context);
    if (stepper->matrix == NULL) return 0;
    stepper->solver = SUNLinSol_KLU(stepper->y, stepper->matrix, stepper->context);
    return stepper->solver != NULL && SUNLinSol_KLUSetOrdering(stepper->solver, ORDERING_AMD) == SUNLS_SUCCESS;
}

static int create_dense(Stepper *stepper)
{
    sunindextype unknowns = stepper_unknowns(stepper->system);
    stepper->matrix = SUNDenseMatrix(unknowns, unknowns, stepper->context);
    if (stepper->matrix == NULL) return 0;
    stepper->solver = SUNLinSol_Dense(stepper->y, stepper->matrix, stepper->context);
    return stepper->solver != NULL;
}

int stepper_newton_create(Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    if (offers_jacobian(system)) {
        stepper->stiffness = malloc((size_t)system->pattern->entries * sizeof(double));
        stepper->damping = malloc((size_t)system->pattern->entries * sizeof(double));
        if (stepper->stiffness == NULL || stepper->damping == NULL) return 0;
    }
    int differences = stepper->stiffness == NULL, dense = differences || 2 * system->size <= DENSE_UNKNOWNS;
    if (!(dense ? create_dense(stepper) : create_sparse(stepper))) return 0;
    return CVodeSetLinearSolver(stepper->cvode, stepper->solver, stepper->matrix) == CVLS_SUCCESS &&
           CVodeSetJacFn(stepper->cvode, differences ? NULL : jacobian) == CVLS_SUCCESS;
}

void stepper_newton_destroy(Stepper *stepper)
{
    if (stepper->solver != NULL) SUNLinSolFree(stepper->solver);
    if (stepper->matrix != NULL) SUNMatDestroy(stepper->matrix);
    free(stepper->stiffness);
    free(stepper->damping);
    free(stepper->row_starts);
    free(stepper->columns);
}
