/* SUNDIALS: explicit Runge-Kutta methods of ARKODE, and CVODE's of Adams and of backward differences. On the stiff
 * problem the latter go to order 2 alone, where they are stable on the imaginary axis: with their own order 5 they
 * creep along at the period of the lightly damped stiff modes. */
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <string.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "peers.h"

#define MOST_STEPS       300000
#define ABSOLUTE_SHARE   1e-2 /* absolute tolerance over relative */
#define STIFF_MOST_ORDER 2

static SUNContext context;

static int rates(realtype t, N_Vector y, N_Vector f, void *problem)
{
    ((const PeerProblem *)problem)->rates(t, NV_DATA_S(y), NV_DATA_S(f));
    return 0;
}

static void quiet(int code, const char *module, const char *function, char *message, void *data) {}

static gboolean solve_explicit(const Peer *peer, const PeerProblem *problem, double tolerance, double *y, PeerLook look,
                               void *data)
{
    N_Vector state = N_VMake_Serial(problem->size, y, context);
    memcpy(y, problem->start, (gsize)problem->size * sizeof *y);
    void *memory = ERKStepCreate(rates, 0, state, context);
    ERKStepSetErrHandlerFn(memory, quiet, NULL);
    ERKStepSetTableNum(memory, *(const ARKODE_ERKTableID *)peer->kind);
    ERKStepSStolerances(memory, tolerance, tolerance * ABSOLUTE_SHARE);
    ERKStepSetUserData(memory, (void *)problem);
    ERKStepSetMaxNumSteps(memory, MOST_STEPS);
    ERKStepSetStopTime(memory, problem->duration);
    double t = 0;
    int status = 0;
    while (status >= 0 && t < problem->duration) {
        status = ERKStepEvolve(memory, problem->duration, state, &t, look != NULL ? ARK_ONE_STEP : ARK_NORMAL);
        if (look != NULL) look(t, y, data);
    }
    ERKStepFree(&memory);
    N_VDestroy(state);
    return status >= 0;
}

/* What CVODE solves its implicit equations with. */
typedef struct {
    SUNMatrix matrix;
    SUNLinearSolver linear;
    SUNNonlinearSolver nonlinear;
} Solvers;

static Solvers attach_solvers(void *memory, const PeerProblem *problem, int kind, N_Vector state)
{
    Solvers solvers = {NULL};
    if (kind == CV_ADAMS) {
        solvers.nonlinear = SUNNonlinSol_FixedPoint(state, 0, context);
        CVodeSetNonlinearSolver(memory, solvers.nonlinear);
        return solvers;
    }
    if (problem->half_band > 0) {
        solvers.matrix = SUNBandMatrix(problem->size, problem->half_band, problem->half_band, context);
        solvers.linear = SUNLinSol_Band(state, solvers.matrix, context);
        CVodeSetMaxOrd(memory, STIFF_MOST_ORDER);
    } else {
        solvers.matrix = SUNDenseMatrix(problem->size, problem->size, context);
        solvers.linear = SUNLinSol_Dense(state, solvers.matrix, context);
    }
    CVodeSetLinearSolver(memory, solvers.linear, solvers.matrix);
    return solvers;
}

static void free_solvers(const Solvers *solvers)
{
    if (solvers->nonlinear != NULL) SUNNonlinSolFree(solvers->nonlinear);
    if (solvers->linear != NULL) SUNLinSolFree(solvers->linear);
    if (solvers->matrix != NULL) SUNMatDestroy(solvers->matrix);
}

static gboolean solve_multistep(const Peer *peer, const PeerProblem *problem, double tolerance, double *y,
                                PeerLook look, void *data)
{
    int kind = *(const int *)peer->kind, status = 0;
    N_Vector state = N_VMake_Serial(problem->size, y, context);
    memcpy(y, problem->start, (gsize)problem->size * sizeof *y);
    void *memory = CVodeCreate(kind, context);
    CVodeInit(memory, rates, 0, state);
    CVodeSetErrHandlerFn(memory, quiet, NULL);
    CVodeSStolerances(memory, tolerance, tolerance * ABSOLUTE_SHARE);
    CVodeSetUserData(memory, (void *)problem);
    CVodeSetMaxNumSteps(memory, MOST_STEPS);
    CVodeSetStopTime(memory, problem->duration);
    Solvers solvers = attach_solvers(memory, problem, kind, state);
    double t = 0;
    while (status >= 0 && t < problem->duration) {
        status = CVode(memory, problem->duration, state, &t, look != NULL ? CV_ONE_STEP : CV_NORMAL);
        if (look != NULL) look(t, y, data);
    }
    CVodeFree(&memory);
    free_solvers(&solvers);
    N_VDestroy(state);
    return status >= 0;
}

const Peer *peer_sundials(void)
{
    static const ARKODE_ERKTableID dormand_prince = ARKODE_DORMAND_PRINCE_7_4_5, verner = ARKODE_VERNER_8_5_6,
                                   fehlberg = ARKODE_FEHLBERG_13_7_8;
    static const int adams = CV_ADAMS, differences = CV_BDF;
    static const Peer peers[] = {
        {"SUNDIALS", "DP5", TRUE, TRUE, &dormand_prince, solve_explicit},
        {"SUNDIALS", "Verner6(5)", FALSE, TRUE, &verner, solve_explicit},
        {"SUNDIALS", "Fehlberg8(7)", FALSE, TRUE, &fehlberg, solve_explicit},
        {"SUNDIALS", "Adams", FALSE, TRUE, &adams, solve_multistep},
        {"SUNDIALS", "BDF", TRUE, TRUE, &differences, solve_multistep},
        {NULL},
    };
    if (context == NULL && SUNContext_Create(NULL, &context) != 0) g_error("SUNDIALS gives no context");
    return peers;
}
