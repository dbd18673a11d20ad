/* What touches or is driven, and does not count where a model is made linear. */
#include "physics/linearise/left-out.h"

#include "physics/constraint/constraints.h"
#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

static void add(GArray *list, TinkerLeftOutKind kind, TinkerBlockId block, TinkerBlockId other)
{
    const TinkerLeftOut out = {kind, block, other};
    for (guint i = 0; i < list->len; i++) {
        const TinkerLeftOut *before = &g_array_index(list, TinkerLeftOut, i);
        if (before->kind == kind && before->block == block && before->other == other) return;
    }
    g_array_append_val(list, out);
}

static void add_contacts(TinkerModel *model, GArray *list)
{
    TinkerContacts *contacts = model->contacts;
    for (int32_t i = 0; contacts != NULL && i < contacts->pair_count; i++) {
        TinkerTouchingPair *pair = &contacts->pairs[i];
        if (!tinker_contact_pair_is_apart(contacts, pair) &&
            tinker_contact_pair_overlap(contacts, pair) >= -TINKER_TOUCHING)
            add(list, TINKER_LEFT_OUT_CONTACT, tinker_model_block_of(model, pair->point[0]),
                tinker_model_block_of(model, pair->point[1]));
    }
}

static void add_motions(const TinkerModel *model, GArray *list)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->prescribed && row < all->rows; row++)
        if (all->rate[row] != 0) add(list, TINKER_LEFT_OUT_MOTION, all->blocks[row], TINKER_NO_BLOCK);
}

void tinker_linearise_add_left_out(TinkerModel *model, const double *q, GArray *list)
{
    g_autofree double *still = g_new0(double, MAX(model->coordinates, 1));
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return;
    tinker_model_set_state(model, q, still);
    add_contacts(model, list);
    if (model->constraints.rows > 0 && tinker_constraints_evaluate(model) == TINKER_OK) add_motions(model, list);
}
