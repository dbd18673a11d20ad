/* What is told of bodies that overlap as they are placed. */
#include <glib/gi18n-lib.h>

#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/warning.h"

void tinker_contacts_tell_overlap(const TinkerContacts *contacts, const int32_t point[2], double overlap, guint *told,
                                  GPtrArray *warnings)
{
    TinkerModel *model = contacts->model;
    if (!(overlap > TINKER_TOUCHING) || ++*told > TINKER_OVERLAPS_TOLD) return;
    const char *first = tinker_scene_block_name(model->scene, tinker_model_block_of(model, point[0]));
    const char *second = tinker_scene_block_name(model->scene, tinker_model_block_of(model, point[1]));
    tinker_warnings_add(warnings, TINKER_WARNING_SCENE,
                        g_strdup_printf(_("%s and %s overlap at the start, by %.4g m: they pass through each other "
                                          "until they have parted (place them apart, and they meet)"),
                                        first, second, overlap));
}

void tinker_contacts_tell_more_overlaps(guint told, GPtrArray *warnings)
{
    if (told <= TINKER_OVERLAPS_TOLD) return;
    tinker_warnings_add(warnings, TINKER_WARNING_SCENE,
                        g_strdup_printf(_("and %u more pairs overlap at the start (mend the first ones, and these "
                                          "are told of)"),
                                        told - TINKER_OVERLAPS_TOLD));
}

void tinker_contacts_tell_overlaps(TinkerContacts *contacts, GPtrArray *warnings)
{
    guint told = 0;
    for (int32_t i = 0; i < contacts->pair_count; i++) {
        TinkerTouchingPair *pair = &contacts->pairs[i];
        if (tinker_contact_pair_is_apart(contacts, pair)) continue;
        tinker_contacts_tell_overlap(contacts, pair->point, tinker_contact_pair_overlap(contacts, pair), &told,
                                     warnings);
    }
    tinker_contacts_tell_more_overlaps(told, warnings);
}
