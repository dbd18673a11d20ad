/* One thread at a time looks over one copy. Edits meanwhile make what it finds outdated; then it is looked again. */
#include "gui/accuracy/advice-list.h"

#include "gui/document/background.h"

#define PAUSE_IN_EDITING 200 /* ms */

/* A look in progress. */
typedef struct {
    TinkerAdviceList *owner; /* borrowed; of the main thread */
    TinkerScene *scene;
    GPtrArray *findings;
} Look;

struct _TinkerAdviceList {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerPlayer *player;
    GPtrArray *findings;
    gboolean outdated; /* edited since the copy was taken that the findings are of */
    guint timer;
    TinkerBackground *look; /* or NULL */
};

G_DEFINE_FINAL_TYPE(TinkerAdviceList, tinker_advice_list, G_TYPE_OBJECT)

static guint changed_signal;

/* Takes other findings over. (transfer full) */
static void set_findings(TinkerAdviceList *list, GPtrArray *findings)
{
    gboolean both_empty = list->findings->len == 0 && findings->len == 0;
    g_ptr_array_unref(list->findings);
    list->findings = findings;
    if (!both_empty) g_signal_emit(list, changed_signal, 0);
}

/* Looking ---------------------------------------------------------------------------------------------------------- */

static void look_over(TinkerBackground *background, void *data)
{
    Look *look = data;
    look->findings = tinker_advice_new(look->scene);
}

static void look_free(void *data)
{
    Look *look = data;
    tinker_scene_free(look->scene);
    g_clear_pointer(&look->findings, g_ptr_array_unref);
    g_free(look);
}

static gboolean at_start(TinkerAdviceList *list)
{
    return tinker_player_state(list->player) == TINKER_PLAYER_SETUP;
}

static void look_after(TinkerAdviceList *list, guint milliseconds);

static void on_looked(void *data)
{
    Look *look = data;
    g_autoptr(TinkerAdviceList) list = g_object_ref(look->owner);
    g_clear_pointer(&list->look, tinker_background_let_go);
    if (!list->outdated && at_start(list)) set_findings(list, g_steal_pointer(&look->findings));
    if (list->outdated && at_start(list) && list->timer == 0) look_after(list, 0);
}

static gboolean on_timer(gpointer data)
{
    static const TinkerBackgroundWork look_work = {"advice", look_over, on_looked, look_free};
    TinkerAdviceList *list = data;
    list->timer = 0;
    if (!at_start(list) || list->look != NULL) return G_SOURCE_REMOVE; /* on_looked goes on from there */
    list->outdated = FALSE;
    Look *look = g_new0(Look, 1);
    look->owner = list;
    look->scene = tinker_scene_copy(tinker_document_scene(list->document));
    list->look = tinker_background_start(&look_work, look);
    return G_SOURCE_REMOVE;
}

static void look_after(TinkerAdviceList *list, guint milliseconds)
{
    g_clear_handle_id(&list->timer, g_source_remove);
    list->timer = g_timeout_add(milliseconds, on_timer, list);
}

/* What happens
 * ---------------------------------------------------------------------------------------------------------- */

static void on_changed(TinkerAdviceList *list)
{
    list->outdated = TRUE;
    if (at_start(list)) look_after(list, PAUSE_IN_EDITING);
}

static void on_replaced(TinkerAdviceList *list)
{
    list->outdated = TRUE;
    set_findings(list, g_ptr_array_new());
}

static void on_state_changed(TinkerAdviceList *list)
{
    if (at_start(list))
        look_after(list, 0);
    else
        set_findings(list, g_ptr_array_new());
}

/* Public
 * ---------------------------------------------------------------------------------------------------------------- */

TinkerAdviceList *tinker_advice_list_new(TinkerDocument *document, TinkerPlayer *player)
{
    TinkerAdviceList *list = g_object_new(TINKER_TYPE_ADVICE_LIST, NULL);
    list->document = g_object_ref(document);
    list->player = g_object_ref(player);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), list, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), list, G_CONNECT_SWAPPED);
    g_signal_connect_object(player, "state-changed", G_CALLBACK(on_state_changed), list, G_CONNECT_SWAPPED);
    on_changed(list);
    return list;
}

const GPtrArray *tinker_advice_list_findings(TinkerAdviceList *list)
{
    return list->findings;
}

static gboolean is_same(const TinkerAdvice *a, const TinkerAdvice *b)
{
    return a->kind == b->kind && a->end == b->end && a->blocks->len > 0 && b->blocks->len > 0 &&
           g_array_index(a->blocks, TinkerBlockId, 0) == g_array_index(b->blocks, TinkerBlockId, 0);
}

/* A finding as the scene has it now; NULL where there is none any more. */
static const TinkerAdvice *find_again(const GPtrArray *now, const TinkerAdvice *advice)
{
    for (guint i = 0; i < now->len; i++)
        if (is_same(g_ptr_array_index(now, i), advice)) return g_ptr_array_index(now, i);
    return NULL;
}

gboolean tinker_advice_list_repair(TinkerAdviceList *list, guint finding, GError **error)
{
    g_return_val_if_fail(finding < list->findings->len, FALSE);
    tinker_document_interrupt(list->document);
    TinkerScene *scene = tinker_document_scene(list->document);
    const TinkerAdvice *advice = g_ptr_array_index(list->findings, finding);
    g_autoptr(GPtrArray) now = list->outdated ? tinker_advice_new(scene) : NULL;
    if (now != NULL) advice = find_again(now, advice);
    if (advice == NULL) {
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                            "the scene has changed since this was found (look at what is said now)");
        look_after(list, 0);
        return FALSE;
    }
    if (!tinker_advice_repair(tinker_document_history(list->document), scene, advice, error)) return FALSE;
    tinker_document_touch(list->document);
    look_after(list, 0);
    return TRUE;
}

/* Life
 * ------------------------------------------------------------------------------------------------------------------ */

static void tinker_advice_list_dispose(GObject *object)
{
    TinkerAdviceList *list = TINKER_ADVICE_LIST(object);
    g_clear_handle_id(&list->timer, g_source_remove);
    g_clear_pointer(&list->look, tinker_background_let_go);
    g_clear_object(&list->player);
    g_clear_object(&list->document);
    G_OBJECT_CLASS(tinker_advice_list_parent_class)->dispose(object);
}

static void tinker_advice_list_finalize(GObject *object)
{
    g_ptr_array_unref(TINKER_ADVICE_LIST(object)->findings);
    G_OBJECT_CLASS(tinker_advice_list_parent_class)->finalize(object);
}

static void tinker_advice_list_class_init(TinkerAdviceListClass *class)
{
    G_OBJECT_CLASS(class)->dispose = tinker_advice_list_dispose;
    G_OBJECT_CLASS(class)->finalize = tinker_advice_list_finalize;
    changed_signal =
        g_signal_new("changed", TINKER_TYPE_ADVICE_LIST, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void tinker_advice_list_init(TinkerAdviceList *list)
{
    list->findings = g_ptr_array_new();
}
