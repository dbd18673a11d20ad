/* Motions without contacts. */
#include "random-draft.h"

#include <math.h>

/* Masses in a row along a line, with springs and dampers between them and an anchor at one end or both. */
static void write_row(RandomDraft *draft, double turn, double velocity_across)
{
    int count = g_rand_int_range(draft->dice, 1, 5);
    double c = cos(turn), s = sin(turn);
    double least = 0.3, stiffness = draft_about(draft, 5, 2000);
    draft_add_anchor(draft, 0, 0);
    for (int i = 0; i < count; i++) {
        double along = 1.0 * (i + 1), v = draft_between(draft, -1.5, 1.5),
               u = velocity_across * draft_between(draft, -1, 1);
        draft_add_mass(draft, draft_about(draft, least, 3), along * c, along * s, v * c - u * s, v * s + u * c);
    }
    for (int i = 0; i < count; i++) {
        const char *from = i == 0 ? draft_anchors[0] : draft_masses[i - 1];
        draft_add_spring(draft, from, draft_masses[i], stiffness * draft_between(draft, 0.3, 1), least);
        if (draft_happens(draft, 0.4))
            draft_add_damper(draft, from, draft_masses[i], draft_about(draft, 0.05, 2), least);
    }
    if (!draft_happens(draft, 0.4)) return;
    draft_add_anchor(draft, (count + 1) * c, (count + 1) * s);
    draft_add_spring(draft, draft_masses[count - 1], draft_anchors[1], stiffness, least);
}

void draft_write_straight(RandomDraft *draft)
{
    write_row(draft, draft_happens(draft, 0.5) ? 0 : draft_between(draft, -1, 1), 0);
}

void draft_write_passing(RandomDraft *draft)
{
    draft_add_anchor(draft, 0, 0);
    draft_add_some_mass(draft, 0.2, 1, 1, 0, draft_between(draft, -9, 0), 0);
    draft_add_some_mass(draft, 0.2, 2, 2, 0, draft_between(draft, -2, 2), 0);
    double rest = draft_happens(draft, 0.5) ? 0 : 0.5;
    draft_add_tense_spring(draft, "A0", "m0", draft_about(draft, 10, 300), 0.2, rest);
    rest = draft_between(draft, 0.2, 1.2);
    draft_add_tense_spring(draft, "m0", "m1", draft_about(draft, 10, 300), 0.2, rest);
    draft->scene->duration = fmin(draft->scene->duration, 4);
}

void draft_write_plane(RandomDraft *draft)
{
    if (draft_happens(draft, 0.6)) draft_add_gravity(draft);
    write_row(draft, draft_between(draft, -3, 3), 1.5);
}

void draft_write_pendulum(RandomDraft *draft)
{
    int count = draft_happens(draft, 0.5) ? 1 : g_rand_int_range(draft->dice, 2, 4);
    draft_add_gravity(draft);
    draft_add_chain(draft, count, count == 1 ? -2.9 : -1.2, count == 1 ? 2.9 : 1.2);
}

void draft_write_linkage(RandomDraft *draft)
{
    int count = g_rand_int_range(draft->dice, 1, 4);
    draft_add_gravity(draft);
    draft_add_chain(draft, count, -1.5, 1.5);
    double y = draft_between(draft, -1, 2);
    draft_add_anchor(draft, draft_between(draft, -3, 3), y);
    draft_add_spring(draft, draft_masses[count - 1], "A1", draft_about(draft, 2, 200), 0.3);
    if (draft_happens(draft, 0.6))
        draft_add_damper(draft, draft_masses[count - 1], "A1", draft_about(draft, 0.05, 3), 0.3);
}

void draft_write_driven(RandomDraft *draft)
{
    if (draft_happens(draft, 0.4)) {
        draft_add_gravity(draft);
        draft_add_chain(draft, 1, -1.5, 1.5);
    } else {
        draft_write_plane(draft);
    }
    double frequency = draft_about(draft, 0.5, 12), amplitude = draft_about(draft, 0.02, 0.4);
    draft_add_support_motion(draft, "A0", draft_between(draft, -3, 3), amplitude, frequency);
}

void draft_write_motors(RandomDraft *draft)
{
    draft_write_plane(draft);
    draft_add_motor(draft, "m0", draft_between(draft, -3, 3));
    if (draft->scene->bodies > 1 && draft_happens(draft, 0.5))
        draft_add_motor(draft, "m1", draft_between(draft, -3, 3));
}

void draft_write_wind(RandomDraft *draft)
{
    if (draft_happens(draft, 0.3)) {
        draft_add_gravity(draft);
        double vy = draft_between(draft, -2, 8), vx = draft_between(draft, -8, 8);
        draft_add_some_mass(draft, 0.3, 3, 0, 0, vx, vy);
    } else {
        draft_write_plane(draft);
    }
    draft_add_wind(draft);
}

/* Fast springs and strong dampers beside slow ones, in the plane, on anchors that may move. */
void draft_write_stiff(RandomDraft *draft)
{
    int count = g_rand_int_range(draft->dice, 1, 3);
    if (draft_happens(draft, 0.7)) draft_add_gravity(draft);
    for (int i = 0; i < 3; i++) {
        double y = draft_between(draft, 2, 4);
        draft_add_anchor(draft, draft_between(draft, -2, 2), y);
    }
    for (int i = 0; i < count; i++) {
        double vy = draft_between(draft, -2, 2), vx = draft_between(draft, -2, 2), y = draft_between(draft, -1, 1);
        draft_add_some_mass(draft, 0.3, 2, 1.5 * i, y, vx, vy);
    }
    for (int i = 0; i < count; i++) {
        const char *to = i == 0 ? draft_anchors[0] : draft_masses[i - 1];
        draft_add_spring(draft, draft_masses[i], to, draft_about(draft, 1e3, 2e5), 0.3);
        draft_add_damper(draft, draft_masses[i], to, draft_about(draft, 1, 1000), 0.3);
    }
    draft_add_spring(draft, "m0", "A1", draft_about(draft, 5, 50), 0.3);
    draft_add_damper(draft, "m0", "A2", draft_about(draft, 1, 500), 0.3);
    if (draft_happens(draft, 0.5)) {
        double rest = draft_between(draft, 0.3, 1);
        draft_add_tense_spring(draft, "m0", "A2", draft_about(draft, 1e3, 2e5), 0.3, rest);
    }
    for (int i = 0; i < 3; i++) {
        if (!draft_happens(draft, 0.5)) continue;
        double frequency = draft_about(draft, 0.5, 8), amplitude = draft_about(draft, 0.02, 0.3);
        draft_add_support_motion(draft, draft_anchors[i], draft_between(draft, -3, 3), amplitude, frequency);
    }
    draft->scene->duration = draft_between(draft, 1, 3);
}
