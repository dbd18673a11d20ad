/* The equations of closed contacts: which there are, and which of them are solved together. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "numerics/solve/rank.h"
#include "physics/contact/contacts-private.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"

/* Up to so many equations W solves them: one on 79 rods takes 0.36 us so and 1.5 us by elimination, four 1.5 us either
 * way, eight 3.0 and 1.6 us, 64 take 52 and 2.6 us (bench-contact-chains). */
#define FEW_ROWS 8

static int by_body(const void *left, const void *right)
{
    const TinkerContact *l = left, *r = right;
    if (l->body != r->body) return l->body < r->body ? -1 : 1;
    return l->plate < r->plate ? -1 : l->plate > r->plate;
}

static gboolean stands_alone(const TinkerContacts *contacts, guint number)
{
    const GArray *closed = contacts->closed;
    int32_t body = g_array_index(closed, TinkerContact, number).body;
    if (contacts->held[body] || tinker_contacts_has_outline(contacts, body)) return FALSE;
    if (tinker_contacts_is_gap(contacts, tinker_contacts_closed(contacts, number))) return FALSE;
    if (number > 0 && g_array_index(closed, TinkerContact, number - 1).body == body) return FALSE;
    return number + 1 == closed->len || g_array_index(closed, TinkerContact, number + 1).body != body;
}

/* Entries of one more gap function. */
static int32_t add_entries(TinkerContacts *contacts)
{
    g_array_set_size(contacts->entries, contacts->entries->len + 1);
    return (int32_t)contacts->entries->len - 1;
}

/* What resists rolling holds as an equation of its own, or turns along with the normal force of what bears it. */
static void add_resistance(TinkerContacts *contacts, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)number);
    const double weight = sqrt(contacts->model->mass[contact->body]);
    const int32_t entries = add_entries(contacts);
    const gboolean pin = tinker_contacts_is_pin(contacts, contact);
    if (contact->mode == TINKER_CONTACT_SMOOTH) return;
    if (contact->mode == TINKER_CONTACT_STICK || pin) {
        TinkerContactRow row = {number, TRUE, {0, 0}, {0, 0}, weight, entries, 0, -1, -1, 0, 0};
        if (pin) row.pin_slope = tinker_contact_slip_share(contacts, contact);
        g_array_append_val(contacts->rows, row);
        return;
    }
    for (guint i = 0; i < contacts->rows->len; i++) {
        TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        if (row->contact != contact->bearer || row->tangential) continue;
        row->resisting = number;
        row->resisting_entries = entries;
        row->resisting_share = tinker_contact_slip_share(contacts, contact);
    }
}

static void add_rows(TinkerContacts *contacts, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)number);
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    if (tinker_contacts_resists(contacts, contact)) {
        add_resistance(contacts, number);
        return;
    }
    double nx = plate->normal[0], ny = plate->normal[1], share = tinker_contact_slip_share(contacts, contact);
    double weight = sqrt(contacts->model->mass[contact->body]);
    const int32_t entries = plate->gap != NULL ? add_entries(contacts) : -1;
    TinkerContactRow normal = {number, FALSE, {nx, ny}, {nx + share * ny, ny - share * nx}, weight, entries, share,
                               -1,     -1,    0};
    g_array_append_val(contacts->rows, normal);
    if (contact->mode != TINKER_CONTACT_STICK) return;
    TinkerContactRow tangential = {number, TRUE, {ny, -nx}, {ny, -nx}, weight, entries, 0, -1, -1, 0, 0};
    g_array_append_val(contacts->rows, tangential);
}

/* What constraints tie together and what touches: what acts on one of these bodies moves no other. */
static void find_touching(TinkerContacts *contacts)
{
    const TinkerModel *model = contacts->model;
    memcpy(contacts->touching, contacts->tied, (gsize)model->bodies * sizeof(int32_t));
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerTouchingPair *pair = contacts->plates[tinker_contacts_closed(contacts, i)->plate].pair;
        if (pair != NULL && pair->point[1] < model->bodies)
            tinker_sets_join(contacts->touching, pair->point[0], pair->point[1]);
    }
    tinker_sets_settle(contacts->touching, model->bodies);
}

static int32_t set_of(const TinkerContacts *contacts, const TinkerContactRow *row)
{
    return contacts->touching[tinker_contacts_closed(contacts, (guint)row->contact)->body];
}

static int by_set(const void *left, const void *right, void *data)
{
    const TinkerContactRow *l = left, *r = right;
    const int32_t of_l = set_of(data, l), of_r = set_of(data, r);
    if (of_l != of_r) return of_l < of_r ? -1 : 1;
    if (l->contact != r->contact) return l->contact < r->contact ? -1 : 1;
    return l->tangential - r->tangential;
}

/* Whether constraints tie all that a body may meet to it. */
static gboolean is_all_tied(const TinkerContacts *contacts, int32_t body)
{
    const int32_t group = contacts->group[body];
    for (int32_t i = 0; i < contacts->model->bodies; i++)
        if (contacts->group[i] == group && contacts->tied[i] != group) return FALSE;
    return TRUE;
}

TinkerContactElimination *tinker_contacts_elimination(TinkerContacts *contacts, gboolean may_meet, int32_t body)
{
    const gboolean others = may_meet && !is_all_tied(contacts, body);
    const int32_t *sets = others ? contacts->group : contacts->tied;
    TinkerContactElimination **own = &contacts->eliminations[others][sets[body]];
    if (*own == NULL) *own = tinker_contact_elimination_new(contacts->model, sets, body, contacts->column);
    return *own;
}

/* Whether no body has more equations than elimination takes: those of one body stand together. */
static gboolean may_be_eliminated(const TinkerContacts *contacts, guint first, guint count)
{
    guint of_one = 0;
    int32_t body = -1;
    if (contacts->model->constraints.turn_count > 0) return FALSE;
    for (guint i = first; i < first + count; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const int32_t next = tinker_contacts_closed(contacts, (guint)row->contact)->body;
        if (row->entries >= 0) return FALSE;
        of_one = next == body ? of_one + 1 : 1;
        body = next;
        if (of_one > TINKER_MOST_EQUATIONS) return FALSE;
    }
    return TRUE;
}

/* The lightest of the bodies that meet at a row (kg), and the heaviest. */
static void find_masses(const TinkerContacts *contacts, const TinkerContactRow *row, double *lightest, double *heaviest)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
    const TinkerTouchingPair *pair = contacts->plates[contact->plate].pair;
    const int32_t points[] = {contact->body, pair != NULL ? pair->point[0] : contact->body,
                              pair != NULL ? pair->point[1] : contact->body};
    *lightest = INFINITY;
    *heaviest = 0;
    for (gsize k = 0; k < G_N_ELEMENTS(points); k++) {
        if (points[k] >= contacts->model->bodies) continue;
        *lightest = fmin(*lightest, contacts->model->mass[points[k]]);
        *heaviest = fmax(*heaviest, contacts->model->mass[points[k]]);
    }
}

/* Bodies whose masses differ so much that W loses digits: beside 1/m of a light one that of a heavy one that leans on
 * it counts for little. Then W is scaled by the light ones, to about 1, and what is left of a row may be as much
 * smaller as they are lighter without that it depends on others. */
static void note_unevenness(TinkerContacts *contacts, TinkerContactBlock *block)
{
    double least = INFINITY, most = 0, lightest, heaviest;
    for (int32_t i = block->first; i < block->first + block->count; i++) {
        find_masses(contacts, &g_array_index(contacts->rows, TinkerContactRow, (guint)i), &lightest, &heaviest);
        least = fmin(least, lightest);
        most = fmax(most, heaviest);
    }
    block->uneven = most > TINKER_UNEVEN * least;
    if (!(most > TINKER_VERY_UNEVEN * least)) return;
    for (int32_t i = block->first; i < block->first + block->count; i++) {
        TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, (guint)i);
        find_masses(contacts, row, &lightest, &heaviest);
        row->weight = sqrt(lightest);
    }
    for (int moves = FALSE; moves <= TRUE; moves++)
        tinker_dense_solve_set_dependent(block->solve[moves],
                                         fmax(TINKER_DEPENDENT * (least / most), TINKER_UNEVEN_DEPENDENT));
}

/* Rows that may be eliminated are of bodies that constraints alone join: what touches besides has entries. FALSE: no
 * memory. */
static gboolean add_block(TinkerContacts *contacts, guint first, guint count)
{
    const int32_t contact = g_array_index(contacts->rows, TinkerContactRow, first).contact;
    TinkerContactBlock block = {.first = (int32_t)first, .count = (int32_t)count};
    block.held = contacts->held[tinker_contacts_closed(contacts, (guint)contact)->body];
    for (guint i = first; i < first + count; i++)
        block.held |= g_array_index(contacts->rows, TinkerContactRow, i).entries >= 0;
    if (block.held && count > FEW_ROWS && may_be_eliminated(contacts, first, count)) {
        block.elimination =
            tinker_contacts_elimination(contacts, FALSE, tinker_contacts_closed(contacts, (guint)contact)->body);
        g_array_append_val(contacts->blocks, block);
        if (block.elimination != NULL) g_ptr_array_add(contacts->eliminated, block.elimination);
        return block.elimination != NULL && tinker_contact_elimination_make_room(block.elimination, count);
    }
    for (int moves = FALSE; moves <= TRUE; moves++)
        block.solve[moves] = tinker_dense_solve_new(block.count);
    const gboolean enough = block.solve[FALSE] != NULL && block.solve[TRUE] != NULL;
    if (enough && block.held) note_unevenness(contacts, &block);
    g_array_append_val(contacts->blocks, block);
    return enough;
}

/* Rows of one set stand together and are solved together. Answers the entries of all their matrices, at least 1; 0: no
 * memory. */
static gsize find_blocks(TinkerContacts *contacts)
{
    gsize entries = 0;
    find_touching(contacts);
    g_array_sort_with_data(contacts->rows, by_set, contacts);
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    for (guint first = 0, end; first < contacts->rows->len; first = end) {
        for (end = first + 1;
             end < contacts->rows->len && set_of(contacts, &rows[end]) == set_of(contacts, &rows[first]);)
            end++;
        if (!add_block(contacts, first, end - first)) return 0;
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, contacts->blocks->len - 1);
        block->matrix = entries;
        if (block->elimination == NULL) entries += (gsize)(end - first) * (end - first);
    }
    return MAX(entries, 1);
}

static void list_equations(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const int32_t body = tinker_contacts_closed(contacts, (guint)row->contact)->body;
        TinkerContactEquation equation = {body, {row->row[0], row->row[1]}, {row->force[0], row->force[1]}, 0};
        contacts->equations[FALSE][i] = equation;
        memcpy(equation.force, equation.row, sizeof(equation.force));
        contacts->equations[TRUE][i] = equation;
    }
}

static gboolean make_equations(TinkerContacts *contacts, gsize count)
{
    for (int moves = FALSE; moves <= TRUE; moves++) {
        g_free(contacts->equations[moves]);
        contacts->equations[moves] = g_try_new(TinkerContactEquation, count);
    }
    return contacts->equations[FALSE] != NULL && contacts->equations[TRUE] != NULL;
}

/* What it held is not kept. FALSE: no memory. */
static gboolean make_room(double **array, gsize count)
{
    g_free(*array);
    *array = g_try_new(double, count);
    return *array != NULL;
}

/* FALSE: no memory. `entries`: of all blocks' matrices. */
static gboolean allot_pins(TinkerContacts *contacts, gsize rows, gsize entries)
{
    TinkerContactPins *pins = &contacts->pins;
    return make_room(&pins->free, 2 * rows) && make_room(&pins->answers, 2 * entries) &&
           make_room(&pins->found, rows) && make_room(&pins->before, rows);
}

/* FALSE: no memory. */
static gboolean allot_rows(TinkerContacts *contacts)
{
    const gsize rows = contacts->rows->len, entries = rows > 0 ? find_blocks(contacts) : 1;
    if (rows == 0) return TRUE;
    if (entries == 0 || !make_room(&contacts->delassus, entries) || !make_room(&contacts->demand, rows) ||
        !make_room(&contacts->base, rows) || !make_room(&contacts->found, rows) || !make_room(&contacts->asked, rows) ||
        !make_equations(contacts, rows))
        return FALSE;
    if (contacts->pin_count > 0 && !allot_pins(contacts, rows, entries)) return FALSE;
    list_equations(contacts);
    tinker_contacts_take_shares(contacts);
    return TRUE;
}

void tinker_contacts_take_shares(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
        contacts->base[i] = (row->tangential ? contact->base_friction : contact->base_normal) / row->weight;
    }
}

static void clear_rows(TinkerContacts *contacts)
{
    g_array_set_size(contacts->rows, 0);
    g_array_set_size(contacts->entries, 0);
    g_array_set_size(contacts->simple, 0);
    g_array_set_size(contacts->blocks, 0);
    g_ptr_array_set_size(contacts->eliminated, 0);
    contacts->any_slip_friction = FALSE;
    contacts->model->book_power[TINKER_BOOK_FRICTION] = 0;
}

/* Of one body, what resists comes behind all that touches. */
static void find_bearers(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        contact->bearer = -1;
        for (guint k = i; tinker_contacts_resists(contacts, contact) && k-- > 0;)
            if (tinker_contacts_closed(contacts, k)->plate == contacts->plates[contact->plate].bearer)
                contact->bearer = (int32_t)k;
    }
}

/* One that closes or opens leaves most of them in order. */
static void sort_closed(TinkerContacts *contacts)
{
    for (guint i = 1; i < contacts->closed->len; i++) {
        if (by_body(tinker_contacts_closed(contacts, i - 1), tinker_contacts_closed(contacts, i)) <= 0) continue;
        g_array_sort(contacts->closed, by_body);
        return;
    }
}

TinkerStatus tinker_contacts_list_rows(TinkerContacts *contacts)
{
    sort_closed(contacts);
    clear_rows(contacts);
    find_bearers(contacts);
    g_array_set_size(contacts->simple, contacts->closed->len);
    int32_t *simple = (int32_t *)(void *)contacts->simple->data, alone = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (tinker_contact_slip_share(contacts, contact) != 0) contacts->any_slip_friction = TRUE;
        if (stands_alone(contacts, i))
            simple[alone++] = (int32_t)i;
        else
            add_rows(contacts, (int32_t)i);
    }
    g_array_set_size(contacts->simple, (guint)alone);
    if (allot_rows(contacts)) return TINKER_OK;
    const gsize count = contacts->closed->len;
    tinker_contacts_open_all(contacts);
    return tinker_contacts_lack_memory(contacts, count);
}

void tinker_contacts_open_all(TinkerContacts *contacts)
{
    g_array_set_size(contacts->closed, 0);
    clear_rows(contacts);
}

TinkerStatus tinker_contacts_lack_memory(const TinkerContacts *contacts, gsize count)
{
    TinkerModel *model = contacts->model;
    model->lacks_memory = TRUE;
    tinker_model_tell_failure(model, _("there is no memory for the equations of %zu contacts at once"), count);
    return TINKER_FAILED;
}
