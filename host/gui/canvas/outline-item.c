/* A block as an item of the outline's list. */
#include "gui/canvas/outline-private.h"
#include "gui/text/block-words.h"

G_DEFINE_FINAL_TYPE(OutlineItem, outline_item, G_TYPE_OBJECT)

static void outline_item_finalize(GObject *object)
{
    g_free(OUTLINE_ITEM(object)->name);
    g_free(OUTLINE_ITEM(object)->folded);
    G_OBJECT_CLASS(outline_item_parent_class)->finalize(object);
}

static void outline_item_class_init(OutlineItemClass *class)
{
    G_OBJECT_CLASS(class)->finalize = outline_item_finalize;
}

static void outline_item_init(OutlineItem *item) {}

OutlineItem *outline_item_new(TinkerScene *scene, TinkerBlockId block)
{
    OutlineItem *item = g_object_new(OUTLINE_TYPE_ITEM, NULL);
    item->block = block;
    item->name = g_strdup(tinker_scene_block_name(scene, block));
    g_autofree char *both = g_strdup_printf("%s %s", item->name, tinker_block_type_title(scene, block));
    item->folded = g_utf8_casefold(both, -1);
    return item;
}
