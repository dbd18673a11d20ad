/* The law is one line of the page Equations, which breaks between its terms. What is wider than the panel all the same
 * is drawn smaller: the panel keeps its width. */
#include "gui/property/law-preview.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/equation/equation-list.h"
#include "gui/equation/equation-row.h"
#include "gui/property/property-rows.h"
#include "gui/text/sentence.h"
#include "gui/widget/unparent.h"
#include "law/typed-law.h"
#include "law/typeset.h"

#define GAP 2 /* px: between the law and the note */

struct _TinkerLawPreview {
    GtkWidget parent_instance;
    TinkerDocument *document;
    GtkWidget *law, *note; /* NULL: there is none */
    char *shown;           /* what the law was made from */
};

G_DEFINE_FINAL_TYPE(TinkerLawPreview, tinker_law_preview, GTK_TYPE_WIDGET)

/* The law ---------------------------------------------------------------------------------------------------------- */

/* Arguments as the equations of a body have them; numbers by their own letters. */
static void look_of(const char *symbol, TinkerSymbolLook *look, void *data)
{
    static const struct {
        const char *name, *stem;
    } rates[] = {{"rate", "L"}, {"vx", "x"}, {"vy", "y"}};
    *look = (TinkerSymbolLook){.stem = symbol, .index = ""};
    for (gsize i = 0; i < G_N_ELEMENTS(rates); i++)
        if (g_str_equal(rates[i].name, symbol)) *look = (TinkerSymbolLook){rates[i].stem, "", 1, NULL};
}

/* What the law is of: "T", "F" with the index x. */
static TinkerSymbolLook name_of(const TinkerPropertyType *type)
{
    static const char forces[] = "force_";
    if (type->symbol != NULL) return (TinkerSymbolLook){.stem = type->symbol, .index = ""};
    if (g_str_has_prefix(type->id, forces))
        return (TinkerSymbolLook){.stem = "F", .index = "", .component = type->id + strlen(forces)};
    return (TinkerSymbolLook){.stem = g_str_equal(type->id, "potential") ? "V" : type->id, .index = ""};
}

static void term_clear(gpointer data)
{
    g_free(((TinkerLineTerm *)data)->text);
}

/* (transfer full) */
static TinkerEquationLine *line_new(const TinkerPropertyType *type, const TinkerExpression *law,
                                    TinkerTypesetFormat format)
{
    const TinkerSymbolLook name = name_of(type);
    const gboolean is_sum = law->kind == TINKER_EXPRESSION_SUM;
    GString *left = g_string_new(NULL);
    TinkerEquationLine *line = g_new0(TinkerEquationLine, 1);
    tinker_symbol_typeset(left, &name, format);
    *line = (TinkerEquationLine){.block = TINKER_NO_BLOCK, .component = -1, .left = g_string_free(left, FALSE)};
    line->terms = g_array_new(FALSE, TRUE, sizeof(TinkerLineTerm));
    g_array_set_clear_func(line->terms, term_clear);
    for (int i = 0; i < (is_sum ? law->count : 1); i++) {
        const TinkerExpression *part = is_sum ? law->parts[i] : law;
        const TinkerLineTerm term = {tinker_expression_typeset_term(part, i == 0, format, look_of, NULL),
                                     TINKER_NO_BLOCK, TINKER_TERM_FORCE};
        g_array_append_val(line->terms, term);
    }
    return line;
}

static void line_free(TinkerEquationLine *line)
{
    g_free(line->left);
    g_array_unref(line->terms);
    g_free(line);
}

static void clear(TinkerLawPreview *preview)
{
    tinker_unparent_children(GTK_WIDGET(preview));
    preview->law = preview->note = NULL;
    g_clear_pointer(&preview->shown, g_free);
}

/* The texts of a block, in one of which something else is typed by now. */
typedef struct {
    TinkerSceneTexts texts;
    int32_t property;
    const char *typed;
} Typed;

static const char *text_of(int32_t property, void *data)
{
    Typed *typed = data;
    return property == typed->property ? typed->typed : tinker_scene_text_of(property, &typed->texts);
}

static void show_law(TinkerLawPreview *preview, const TinkerBlockClass *block_class, int32_t property,
                     const TinkerExpression *law, const char *note)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    TinkerEquationLine *shown = line_new(type, law, TINKER_TYPESET_MATHML),
                       *spoken = line_new(type, law, TINKER_TYPESET_SPEECH);
    preview->law = tinker_equation_row_new(preview->document, shown, spoken);
    gtk_widget_set_parent(preview->law, GTK_WIDGET(preview));
    line_free(shown);
    line_free(spoken);
    if (note == NULL) return;
    g_autofree char *titled = tinker_with_titles(note, block_class), *sentence = tinker_sentence(titled);
    preview->note = tinker_equation_label(sentence, "caption");
    gtk_widget_add_css_class(preview->note, "warning");
    gtk_widget_set_parent(preview->note, GTK_WIDGET(preview));
}

gboolean tinker_law_preview_show(TinkerLawPreview *preview, const TinkerPropertyRow *row, const char *text, int *column,
                                 GError **error)
{
    TinkerScene *scene = tinker_document_scene(preview->document);
    const TinkerBlockId block = g_array_index(row->blocks, TinkerBlockId, 0);
    const TinkerBlockClass *block_class =
        tinker_scene_has_block(scene, block) ? tinker_scene_block_class(scene, block) : NULL;
    g_autofree char *typed = g_strchomp(g_strdup(text));
    GError *cause = NULL;
    *column = 0;
    if (block_class == NULL || typed[0] == '\0') {
        clear(preview);
        return TRUE;
    }
    g_autoptr(TinkerExpression) law = tinker_typed_parse(block_class, row->property, typed, &cause);
    if (law == NULL) {
        tinker_without_column(cause->message, column);
        property_fail(error, cause, NULL, NULL);
        gtk_widget_add_css_class(GTK_WIDGET(preview), "dim-label");
        return FALSE;
    }
    gtk_widget_remove_css_class(GTK_WIDGET(preview), "dim-label");
    Typed texts = {{scene, block}, row->property, typed};
    g_autofree char *note = tinker_typed_note(block_class, row->property, text_of, &texts);
    g_autofree char *key = g_strdup_printf("%d %s\n%s", row->property, typed, note != NULL ? note : "");
    if (g_strcmp0(key, preview->shown) == 0) return TRUE;
    clear(preview);
    preview->shown = g_steal_pointer(&key);
    show_law(preview, block_class, row->property, law, note);
    return TRUE;
}

/* Layout ----------------------------------------------------------------------------------------------------------- */

/* How wide the law is laid out, and how high it is there, before it is drawn smaller by `scale`. */
static void measure_law(TinkerLawPreview *preview, int width, int size[2], double *scale)
{
    int least = 0;
    size[0] = size[1] = 0;
    *scale = 1;
    if (preview->law == NULL) return;
    gtk_widget_measure(preview->law, GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL, NULL, NULL);
    size[0] = MAX(width, least);
    gtk_widget_measure(preview->law, GTK_ORIENTATION_VERTICAL, size[0], NULL, &size[1], NULL, NULL);
    *scale = size[0] > 0 ? (double)width / size[0] : 1;
}

static int note_height(TinkerLawPreview *preview, int width)
{
    int height = 0;
    if (preview->note == NULL) return 0;
    gtk_widget_measure(preview->note, GTK_ORIENTATION_VERTICAL, width, NULL, &height, NULL, NULL);
    return height + GAP;
}

static GtkSizeRequestMode tinker_law_preview_mode(GtkWidget *widget)
{
    return GTK_SIZE_REQUEST_HEIGHT_FOR_WIDTH;
}

static void tinker_law_preview_measure(GtkWidget *widget, GtkOrientation orientation, int for_size, int *minimum,
                                       int *natural, int *minimum_baseline, int *natural_baseline)
{
    TinkerLawPreview *preview = TINKER_LAW_PREVIEW(widget);
    int size[2], least = 0;
    double scale;
    *minimum_baseline = *natural_baseline = -1;
    if (preview->note != NULL)
        gtk_widget_measure(preview->note, GTK_ORIENTATION_HORIZONTAL, -1, &least, NULL, NULL, NULL);
    *minimum = *natural = least;
    if (orientation == GTK_ORIENTATION_HORIZONTAL) return;
    measure_law(preview, for_size > 0 ? for_size : G_MAXINT16, size, &scale);
    *minimum = *natural = (int)ceil(scale * size[1]) + note_height(preview, for_size > 0 ? for_size : G_MAXINT16);
}

static void tinker_law_preview_size_allocate(GtkWidget *widget, int width, int height, int baseline)
{
    TinkerLawPreview *preview = TINKER_LAW_PREVIEW(widget);
    int size[2];
    double scale;
    measure_law(preview, width, size, &scale);
    if (preview->law != NULL)
        gtk_widget_allocate(preview->law, size[0], size[1], -1, gsk_transform_scale(NULL, (float)scale, (float)scale));
    if (preview->note == NULL) return;
    const GtkAllocation box = {0, (int)ceil(scale * size[1]) + GAP, width, note_height(preview, width) - GAP};
    gtk_widget_size_allocate(preview->note, &box, -1);
}

/* Life ------------------------------------------------------------------------------------------------------------- */

GtkWidget *tinker_law_preview_new(TinkerDocument *document)
{
    TinkerLawPreview *preview = g_object_new(TINKER_TYPE_LAW_PREVIEW, NULL);
    preview->document = g_object_ref(document);
    return GTK_WIDGET(preview);
}

static void tinker_law_preview_dispose(GObject *object)
{
    clear(TINKER_LAW_PREVIEW(object));
    g_clear_object(&TINKER_LAW_PREVIEW(object)->document);
    G_OBJECT_CLASS(tinker_law_preview_parent_class)->dispose(object);
}

static void tinker_law_preview_class_init(TinkerLawPreviewClass *class)
{
    GtkWidgetClass *widget_class = GTK_WIDGET_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = tinker_law_preview_dispose;
    widget_class->get_request_mode = tinker_law_preview_mode;
    widget_class->measure = tinker_law_preview_measure;
    widget_class->size_allocate = tinker_law_preview_size_allocate;
    gtk_widget_class_set_css_name(widget_class, "lawpreview");
    gtk_widget_class_set_accessible_role(widget_class, GTK_ACCESSIBLE_ROLE_GROUP);
}

static void tinker_law_preview_init(TinkerLawPreview *preview)
{
    gtk_widget_set_overflow(GTK_WIDGET(preview), GTK_OVERFLOW_HIDDEN);
    gtk_accessible_update_property(GTK_ACCESSIBLE(preview), GTK_ACCESSIBLE_PROPERTY_LABEL, _("Law"), -1);
}
