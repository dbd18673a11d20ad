/* One step after another; whatever fails says why. */
#include "analysis/modes/mode-analysis.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"

static gboolean analyse(TinkerModeAnalysis *analysis, gboolean rest, GError **error)
{
    const int32_t coordinates = tinker_model_sizes(analysis->model).coordinates;
    // Before anything is worked out: what is too large takes much time and memory until it is refused.
    if (!tinker_modal_basis_fits(coordinates, error)) return FALSE;
    analysis->q = g_new0(double, MAX(coordinates, 1));
    tinker_model_start_places(analysis->model, analysis->q);
    analysis->contacts = tinker_still_contacts_new(analysis->model);
    if (tinker_model_hold(analysis->model) != TINKER_OK) {
        g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                            "its supports have no place at the start");
        return FALSE;
    }
    /* on the way to rest a body may pass through what it touches at the start */
    analysis->left_out = g_array_new(FALSE, FALSE, sizeof(TinkerLeftOut));
    tinker_linearise_add_left_out(analysis->model, analysis->q, analysis->left_out);
    TinkerStillContacts *contacts = analysis->contacts;
    if (rest && !tinker_equilibrium_find(analysis->model, contacts, analysis->q, &analysis->rest, error)) return FALSE;
    analysis->about_rest = rest && analysis->rest.found;
    if (contacts != NULL && !rest && !tinker_still_contacts_decide(contacts, analysis->q, error)) return FALSE;
    tinker_linearise_add_left_out(analysis->model, analysis->q, analysis->left_out);
    analysis->linear = tinker_linearise(analysis->model, analysis->q, error);
    if (analysis->linear == NULL) return FALSE;
    tinker_linearise_add_varying(analysis->model, analysis->q, analysis->linear->extent, analysis->left_out);
    analysis->basis = tinker_modal_basis_new(analysis->linear, error);
    if (analysis->basis == NULL) return FALSE;
    analysis->modes = tinker_modes_of(analysis->basis, error);
    return analysis->modes != NULL;
}

TinkerModeAnalysis *tinker_mode_analysis_new(TinkerScene *scene, gboolean rest, GError **error)
{
    g_autoptr(TinkerModeAnalysis) analysis = g_new0(TinkerModeAnalysis, 1);
    analysis->model = tinker_model_new(scene, error);
    if (analysis->model == NULL || !analyse(analysis, rest, error)) return NULL;
    return g_steal_pointer(&analysis);
}

void tinker_mode_analysis_free(TinkerModeAnalysis *analysis)
{
    if (analysis == NULL) return;
    g_clear_pointer(&analysis->modes, g_ptr_array_unref);
    g_clear_pointer(&analysis->left_out, g_array_unref);
    tinker_modal_basis_free(analysis->basis);
    tinker_linearisation_free(analysis->linear);
    tinker_still_contacts_free(analysis->contacts);
    g_free(analysis->q);
    tinker_model_free(analysis->model);
    g_free(analysis);
}
