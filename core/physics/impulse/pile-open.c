/* What a pile consists of: the shapes that meet others, and the bodies that constraints tie to them. */
#include "physics/impulse/pile.h"
#include "physics/model/points.h"

static int32_t list_members(TinkerPile *pile)
{
    int32_t count = 0;
    for (int32_t i = 0; i < pile->model->bodies; i++)
        if (tinker_contacts_has_outline(pile->contacts, i)) pile->members[count++] = i;
    pile->body_count = count;
    for (int32_t i = pile->model->bodies; i < pile->shapes; i++)
        pile->members[count++] = i;
    return count;
}

/* What meets others, then what constraints tie to it. */
static void list_solved(TinkerPile *pile)
{
    const TinkerContacts *contacts = pile->contacts;
    g_autofree gboolean *tied = g_new0(gboolean, (gsize)pile->model->bodies);
    for (int32_t i = 0; i < pile->body_count; i++) {
        const int32_t body = pile->solved[pile->solved_count++] = pile->members[i];
        pile->has[body] = TRUE;
        tied[contacts->group[body]] |= contacts->held[body];
    }
    for (int32_t i = 0; i < pile->model->bodies; i++) {
        if (pile->has[i] || !contacts->held[i] || !tied[contacts->group[i]]) continue;
        pile->solved[pile->solved_count++] = i;
        pile->has[i] = TRUE;
    }
}

static void allot(TinkerPile *pile)
{
    const gsize shapes = (gsize)pile->shapes, expected = 4 * shapes;
    pile->members = g_new0(int32_t, shapes);
    pile->solved = g_new0(int32_t, shapes);
    pile->has = g_new0(gboolean, shapes);
    pile->shape = g_new0(TinkerPlacedShape, shapes);
    pile->first_corner = g_new0(gsize, shapes + 1);
    pile->bodies = g_new0(TinkerPileBody, shapes);
    pile->without = g_new0(TinkerPileBody, shapes);
    pile->moves = g_new0(TinkerPileBody, shapes);
    pile->by_gyration = g_new0(double, shapes);
    pile->before = g_new0(double, 3 * shapes);
    pile->pull = g_new0(double, 3 * shapes);
    pile->listed = g_new0(double, 2 * shapes);
    pile->margin = g_new0(double, shapes);
    pile->sorted = g_new0(double, shapes);
    pile->near = g_array_sized_new(FALSE, TRUE, sizeof(TinkerPileNear), (guint)expected);
    pile->near_was = g_array_sized_new(FALSE, TRUE, sizeof(TinkerPileNear), (guint)expected);
    pile->cells = g_array_sized_new(FALSE, TRUE, sizeof(TinkerPileCell), (guint)shapes);
}

static void open_shape(TinkerPile *pile, int32_t shape)
{
    const TinkerOutline *outline = &pile->contacts->outlines[shape];
    double *corners = pile->corners + pile->first_corner[shape];
    pile->shape[shape] = (TinkerPlacedShape){.kind = outline->kind,
                                             .count = outline->count,
                                             .radius = outline->radius,
                                             .corners = corners,
                                             .normals = corners + 2 * outline->count};
    tinker_shape_corners(outline, pile->local + pile->first_corner[shape]);
}

TinkerPile *tinker_pile_new(const TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    gboolean any = FALSE;
    for (int32_t i = 0; i < model->bodies; i++)
        any |= tinker_contacts_has_outline(contacts, i);
    if (!any) return NULL;
    TinkerPile *pile = g_new0(TinkerPile, 1);
    pile->contacts = contacts;
    pile->model = contacts->model;
    pile->shapes = model->bodies + contacts->plate_count;
    allot(pile);
    pile->member_count = list_members(pile);
    list_solved(pile);
    for (int32_t i = 0; i < pile->shapes; i++)
        pile->first_corner[i + 1] = pile->first_corner[i] + 4 * (gsize)contacts->outlines[i].count;
    pile->corners = g_new0(double, MAX(pile->first_corner[pile->shapes], 1));
    pile->local = g_new0(double, MAX(pile->first_corner[pile->shapes], 1));
    for (int32_t i = 0; i < pile->member_count; i++)
        open_shape(pile, pile->members[i]);
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i];
        const TinkerTurn *turn = tinker_model_turn(model, body);
        pile->bodies[body].inverse_mass = model->inverse_mass[body];
        pile->by_gyration[body] = turn != NULL ? turn->by_gyration : 0;
    }
    pile->joined = tinker_contacts_joined_blocks(model);
    pile->joints = tinker_pile_joints_new(pile);
    pile->direct = tinker_pile_direct_new(pile);
    pile->wedged = tinker_pile_wedged_new(pile);
    if (pile->joints != NULL) pile->direct->tied = tinker_pile_tied_new(pile);
    return pile;
}

void tinker_pile_free(TinkerPile *pile)
{
    if (pile == NULL) return;
    GArray *lists[] = {pile->near, pile->near_was, pile->cells};
    for (gsize i = 0; i < G_N_ELEMENTS(lists); i++)
        g_array_unref(lists[i]);
    gpointer arrays[] = {pile->members, pile->shape,       pile->first_corner, pile->bodies, pile->without,
                         pile->moves,   pile->by_gyration, pile->before,       pile->pull,   pile->listed,
                         pile->margin,  pile->sorted,      pile->touches,      pile->points, pile->marks,
                         pile->local,   pile->corners,     pile->along,        pile->solved, pile->has};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_hash_table_unref(pile->joined);
    tinker_pile_joints_free(pile->joints);
    tinker_pile_direct_free(pile->direct);
    tinker_pile_wedged_free(pile->wedged);
    g_free(pile);
}
