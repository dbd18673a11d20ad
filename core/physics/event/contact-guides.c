/* A body between two tops that guide it: one of them presses, and passing from one to the other is no event. */
#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"

TinkerTouch *tinker_change_other_side(const TinkerContactChange *change, const TinkerTouch *at)
{
    const gboolean top = at->row < 0 && !tinker_contacts_is_gap(change->contacts, &at->contact);
    const gboolean guides = top && change->contacts->plate_count > 1;
    for (guint i = 0; guides && i < change->touches->len; i++) {
        TinkerTouch *other = tinker_touch(change, i);
        if (other != at && other->row < 0 && other->contact.body == at->contact.body &&
            other->contact.plate < change->contacts->plate_count &&
            tinker_contacts_are_guide(change->contacts, at->contact.body, at->contact.plate, other->contact.plate))
            return other;
    }
    return NULL;
}

/* A motion along one top as the other sees it. */
static TinkerContactMode mirrored(TinkerContactMode mode)
{
    if (mode == TINKER_CONTACT_SLIP_FORWARD) return TINKER_CONTACT_SLIP_BACKWARD;
    return mode == TINKER_CONTACT_SLIP_BACKWARD ? TINKER_CONTACT_SLIP_FORWARD : mode;
}

static gboolean has_let_go(const TinkerContactChange *change, const TinkerTouch *at)
{
    return tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_NORMAL && !at->struck;
}

/* Which of two sides of a guide presses: not the one whose force has just come to 0, else the one that is pressed
 * harder, else the one that was. */
static gboolean presses(const TinkerContactChange *change, const TinkerTouch *at, const TinkerTouch *other)
{
    if (has_let_go(change, at) != has_let_go(change, other)) return has_let_go(change, other);
    if (at->contact.base_normal != other->contact.base_normal)
        return at->contact.base_normal > other->contact.base_normal;
    if ((at->was != TINKER_CONTACT_OPEN) != (other->was != TINKER_CONTACT_OPEN)) return at->was != TINKER_CONTACT_OPEN;
    return at < other;
}

void tinker_change_choose_sides(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerTouch *at = tinker_touch(change, i), *other = tinker_change_other_side(change, at);
        if (other == NULL || !presses(change, at, other)) continue;
        TinkerContactMode along = has_let_go(change, other) && other->was != TINKER_CONTACT_STICK
                                      ? mirrored(other->was)
                                      : mirrored(other->contact.mode);
        if (at->contact.mode == TINKER_CONTACT_OPEN || has_let_go(change, other)) at->contact.mode = along;
        other->contact.mode = TINKER_CONTACT_OPEN;
    }
}

gboolean tinker_change_changes_side(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerTouch *other = tinker_change_other_side(change, at);
    gboolean was = at->was != TINKER_CONTACT_OPEN, is = at->contact.mode != TINKER_CONTACT_OPEN;
    return other != NULL && was != is && (other->was != TINKER_CONTACT_OPEN) == is &&
           (other->contact.mode != TINKER_CONTACT_OPEN) == was;
}
