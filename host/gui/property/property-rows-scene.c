/* Rows of the scene itself: title, units, canvas, and how it is run. They change a copy of its head, which the history
 * then takes over as a whole. */
#include <glib/gi18n.h>
#include <string.h>

#include "gui/property/property-rows.h"
#include "gui/text/number-text.h"
#include "gui/text/translate.h"
#include "measure/until.h"
#include "numerics/methods/integrators.h"

/* Members of the head, by what they hold. */
typedef struct {
    const char *group, *title, *description;
    TinkerDimension dimension;
    gsize offset;     /* in TinkerSceneHead */
    const char *part; /* what messages of the core begin with */
} HeadMember;

#define MEMBER(name) G_STRUCT_OFFSET(TinkerSceneHead, name)
static const HeadMember numbers[] = {
    {N_("Canvas"), N_("Grid"), N_("Distance of the grid’s lines"), {0, 1, 0, 0}, MEMBER(canvas_grid), "canvas"},
    {N_("Canvas"),
     N_("Width"),
     N_("How much of the scene is shown at first"),
     {0, 1, 0, 0},
     MEMBER(canvas_width),
     "canvas"},
    {N_("Run"), N_("Duration"), N_("How long it runs"), {0, 0, 1, 0}, MEMBER(run.duration), "run"},
    {N_("Computation"),
     N_("Interval"),
     N_("Time between two samples that are kept"),
     {0, 0, 1, 0},
     MEMBER(run.interval),
     "run"},
};
static const HeadMember step = {N_("Computation"), N_("Step"),       N_("Of methods with a fixed step"),
                                {0, 0, 1, 0},      MEMBER(run.step), "run"};
static const HeadMember tolerance = {
    N_("Computation"), N_("Tolerance"),       N_("Error that adaptive methods allow in a step, relative"),
    {0, 0, 0, 0},      MEMBER(run.tolerance), "run"};
static const HeadMember accuracy = {N_("Computation"),
                                    N_("Accuracy"),
                                    N_("How wrong the motion may be at the end, relative to its size; step and "
                                       "tolerance are chosen for it. Empty: they count"),
                                    {0, 0, 0, 0},
                                    MEMBER(run.accuracy),
                                    "run"};
static const HeadMember texts[] = {
    {N_("Scene"), N_("Title"), N_("What the window is called"), {0, 0, 0, 0}, MEMBER(title), NULL},
    {N_("Scene"), N_("Description"), N_("What the scene is about"), {0, 0, 0, 0}, MEMBER(description), NULL},
};

static const char *const contacts_ids[] = {"events", "impulse", NULL};

/* Setting ---------------------------------------------------------------------------------------------------------- */

/* One step that makes the head what the copy has become. */
static gboolean take_head(TinkerDocument *document, const char *title, const TinkerSceneHead *head, const char *part,
                          GError **error)
{
    GError *cause = NULL;
    g_autofree char *step_title = g_strdup_printf(_("Change %s"), title);
    tinker_document_begin(document, step_title, NULL);
    if (tinker_history_set_head(tinker_document_history(document), head, &cause)) {
        tinker_document_end(document);
        return TRUE;
    }
    tinker_document_abort(document);
    property_fail(error, cause, part, NULL);
    return FALSE;
}

static gboolean set_number(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    const HeadMember *member = row->data;
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    double value;
    if (!property_parse_number(text, member->dimension, row->unit, &value, error)) return FALSE;
    memcpy(G_STRUCT_MEMBER_P(&head, member->offset), &value, sizeof value);
    return take_head(document, row->title, &head, member->part, error);
}

/* None where nothing is typed. */
static gboolean set_accuracy(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    g_autofree char *typed = g_strstrip(g_strdup(text));
    return set_number(document, row, *typed == '\0' ? "0" : typed, error);
}

static gboolean set_text(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    const HeadMember *member = row->data;
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    memcpy(G_STRUCT_MEMBER_P(&head, member->offset), &text, sizeof text);
    return take_head(document, row->title, &head, member->part, error);
}

static gboolean set_until(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(TinkerUntil) until = tinker_until_new(scene, 0);
    g_autofree char *conditions = g_strstrip(g_strdup(text));
    GError *cause = NULL;
    if (!tinker_until_add_all(until, conditions, &cause)) {
        g_prefix_error(&cause, "%s", _("Condition "));
        property_fail(error, cause, NULL, NULL);
        return FALSE;
    }
    TinkerSceneHead head = *tinker_scene_head(scene);
    head.run.until = conditions;
    return take_head(document, row->title, &head, "run", error);
}

static gboolean choose_units(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    head.units = choice == 0 ? TINKER_UNIT_SYSTEM_SI : TINKER_UNIT_SYSTEM_ENGLISH;
    return take_head(document, row->title, &head, NULL, error);
}

static gboolean choose_snap(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    head.canvas_snap = choice != 0;
    return take_head(document, row->title, &head, NULL, error);
}

/* Unless the run would be refused: impulses go with Newton's law of impact alone. */
static gboolean take_contacts(TinkerDocument *document, const char *title, const char *contacts, const char *law,
                              GError **error)
{
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    if (g_str_equal(contacts, "impulse") && !g_str_equal(law, "newton"))
        return property_refuse(error, _("Contacts as impulses know Newton’s law of impact alone."));
    g_autofree char *own_contacts = g_strdup(contacts), *own_law = g_strdup(law);
    head.run.contacts = own_contacts;
    head.run.impact_law = own_law;
    return take_head(document, title, &head, "run", error);
}

static gboolean choose_contacts(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    const TinkerRunSettings *run = &tinker_scene_head(tinker_document_scene(document))->run;
    return take_contacts(document, row->title, contacts_ids[choice], run->impact_law, error);
}

static gboolean choose_law(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    const TinkerRunSettings *run = &tinker_scene_head(tinker_document_scene(document))->run;
    return take_contacts(document, row->title, run->contacts, tinker_scene_impact_laws[choice], error);
}

/* Methods ---------------------------------------------------------------------------------------------------------- */

/* Ids of the methods there are: the automatic choice, those linked in, those of plugins, and at the end the one that
 * the scene has where nobody provides it. (transfer full) */
static GPtrArray *method_ids(TinkerDocument *document)
{
    GPtrArray *ids = tinker_method_ids(tinker_document_catalogue(document), NULL);
    const char *present = tinker_scene_head(tinker_document_scene(document))->run.method;
    if (!g_ptr_array_find_with_equal_func(ids, present, g_str_equal, NULL)) g_ptr_array_add(ids, g_strdup(present));
    return ids;
}

static gboolean choose_method(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error)
{
    g_autoptr(GPtrArray) ids = method_ids(document);
    TinkerSceneHead head = *tinker_scene_head(tinker_document_scene(document));
    if ((guint)choice >= ids->len) return property_refuse(error, _("There is no such method."));
    head.run.method = g_ptr_array_index(ids, choice);
    return take_head(document, row->title, &head, "run", error);
}

static char *method_title(const char *id)
{
    if (g_str_equal(id, "auto")) return g_strdup(_("Automatic"));
    const TinkerIntegrator *method = tinker_integrator_builtin(id);
    return g_strdup(method != NULL ? tinker_translate(method->title) : id);
}

/* Rows ------------------------------------------------------------------------------------------------------------- */

static TinkerPropertyRow *add_choice(PropertyBuilder *builder, const char *group, const char *title,
                                     const char *description, const char *const *choices, int chosen)
{
    TinkerPropertyRow *row = property_builder_add(builder, TINKER_ROW_CHOICE, group, title, description);
    row->choices = g_strdupv((char **)choices);
    row->chosen = chosen;
    return row;
}

static TinkerPropertyRow *add_number(PropertyBuilder *builder, const HeadMember *member)
{
    TinkerPropertyRow *row =
        property_builder_add(builder, TINKER_ROW_NUMBER, _(member->group), _(member->title), _(member->description));
    double value;
    memcpy(&value, G_STRUCT_MEMBER_P(tinker_scene_head(builder->scene), member->offset), sizeof value);
    row->unit = tinker_unit_for(member->dimension, builder->system);
    property_row_take_text(row, member == &tolerance ? tinker_number_short(value, "", PROPERTY_DIGITS)
                                                     : tinker_number_write(value, member->dimension, NULL,
                                                                           builder->system, builder->trims));
    row->data = member;
    row->set = set_number;
    return row;
}

static void add_text(PropertyBuilder *builder, const HeadMember *member)
{
    TinkerPropertyRow *row =
        property_builder_add(builder, TINKER_ROW_TEXT, _(member->group), _(member->title), _(member->description));
    const char *text;
    memcpy(&text, G_STRUCT_MEMBER_P(tinker_scene_head(builder->scene), member->offset), sizeof text);
    property_row_take_text(row, g_strdup(text));
    row->data = member;
    row->set = set_text;
}

static void add_until(PropertyBuilder *builder)
{
    TinkerPropertyRow *row = property_builder_add(
        builder, TINKER_ROW_TEXT, _("Run"), _("Stop When"),
        _("The run stops exactly where this first holds: an equation as in {Mass 0.y} = 1, a comparison as in {Mass "
          "0.vx} < 0.5 that becomes true, or event(impact) or event(impact, Mass 0). Of several, with semicolons "
          "between them, the first counts. Empty: it runs to its end"));
    property_row_take_text(row, g_strdup(tinker_scene_head(builder->scene)->run.until));
    row->set = set_until;
}

static void add_accuracy(PropertyBuilder *builder)
{
    TinkerPropertyRow *row = add_number(builder, &accuracy);
    double value = tinker_scene_head(builder->scene)->run.accuracy;
    property_row_take_text(row, value > 0 ? tinker_number_short(value, "", PROPERTY_DIGITS) : g_strdup(""));
    row->set = set_accuracy;
}

/* The method, and whether step and tolerance mean anything to it and are not chosen for an accuracy. */
static void add_method(PropertyBuilder *builder)
{
    const char *present = tinker_scene_head(builder->scene)->run.method;
    g_autoptr(GPtrArray) ids = method_ids(builder->document), titles = g_ptr_array_new_with_free_func(g_free);
    guint chosen = 0;
    for (guint i = 0; i < ids->len; i++)
        g_ptr_array_add(titles, method_title(g_ptr_array_index(ids, i)));
    g_ptr_array_add(titles, NULL);
    g_ptr_array_find_with_equal_func(ids, present, g_str_equal, &chosen);
    add_choice(builder, _("Computation"), _("Method"), _("How the motion is worked out"),
               (const char *const *)titles->pdata, (int)chosen)
        ->choose = choose_method;
    const TinkerIntegrator *method = tinker_integrator_builtin(present);
    if (method == NULL && chosen > 0)
        method = tinker_catalogue_integrator(tinker_document_catalogue(builder->document), present, NULL);
    guint32 flags = method != NULL ? method->flags : 0;
    gboolean count = !(tinker_scene_head(builder->scene)->run.accuracy > 0);
    add_number(builder, &step)->sensitive =
        count && chosen > 0 && !(flags & (TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_LINEAR));
    add_number(builder, &tolerance)->sensitive =
        count && (method == NULL || ((flags & TINKER_INTEGRATOR_ADAPTIVE) && !(flags & TINKER_INTEGRATOR_LINEAR)));
    add_accuracy(builder);
}

const char *tinker_property_group_folded(void)
{
    return _("Computation");
}

const char *property_law_of_impact(void)
{
    return _("Law of Impact");
}

/* How contacts are stepped, and what several do that close at once. */
static void add_contacts(PropertyBuilder *builder)
{
    const TinkerRunSettings *run = &tinker_scene_head(builder->scene)->run;
    const char *const contacts[] = {_("Events"), _("Impulses"), NULL};
    const char *const laws[] = {_("Newton"), _("Poisson"), _("One After the Other"), NULL};
    add_choice(
        builder, _("Computation"), _("Contacts"),
        _("Events: each is found at its very time. Impulses: all that fall in a step are solved at once, for many "
          "contacts."),
        contacts, g_str_equal(run->contacts, contacts_ids[1]))
        ->choose = choose_contacts;
    int chosen = 0;
    while (tinker_scene_impact_laws[chosen] != NULL && !g_str_equal(run->impact_law, tinker_scene_impact_laws[chosen]))
        chosen++;
    add_choice(builder, _("Computation"), property_law_of_impact(),
               _("Of several contacts that close at once. Newton: each parts with its restitution times the speed of "
                 "approach. Poisson: with its restitution times the impulse that stopped it. One after the other: as "
                 "in a row of balls, of which the last flies off"),
               laws, chosen)
        ->choose = choose_law;
}

void property_rows_add_scene(PropertyBuilder *builder)
{
    const TinkerSceneHead *head = tinker_scene_head(builder->scene);
    const char *const units[] = {_("SI"), _("English"), NULL};
    for (gsize i = 0; i < G_N_ELEMENTS(numbers); i++)
        add_number(builder, &numbers[i]);
    add_until(builder);
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        add_text(builder, &texts[i]);
    add_choice(builder, _("Scene"), _("Units"), _("In which all values are shown; the scene stays the same"), units,
               head->units == TINKER_UNIT_SYSTEM_ENGLISH)
        ->choose = choose_units;
    add_contacts(builder);
    TinkerPropertyRow *snap = property_builder_add(builder, TINKER_ROW_SWITCH, _("Canvas"), _("Snap"),
                                                   _("Whether blocks that are moved keep to the grid"));
    snap->chosen = head->canvas_snap != 0;
    snap->choose = choose_snap;
    add_method(builder);
}
