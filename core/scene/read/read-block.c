/* Reading one block: its type, name and keys. What names another block is in read-ends.c. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "scene/frame/tops.h"
#include "scene/json/text-hash.h"
#include "scene/value/reader.h"

/* The members that every block has. */
typedef struct {
    const cJSON *type, *name, *ends;
    int type_step, name_step, ends_step;
} BlockMembers;

static BlockMembers find_members(const cJSON *json)
{
    BlockMembers members = {0};
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        if (g_str_equal(member->string, "type")) {
            members.type = member;
            members.type_step = step;
        } else if (g_str_equal(member->string, "name")) {
            members.name = member;
            members.name_step = step;
        } else if (g_str_equal(member->string, "ends")) {
            members.ends = member;
            members.ends_step = step;
        }
    }
    return members;
}

static void type_free(ReaderType *type)
{
    g_free(type->message);
    g_free(type);
}

static ReaderType *find_type(SceneReader *reader, const char *id)
{
    if (reader->types == NULL)
        reader->types = g_hash_table_new_full(tinker_text_hash, g_str_equal, g_free, (GDestroyNotify)type_free);
    ReaderType *type = g_hash_table_lookup(reader->types, id);
    if (type != NULL) return type;
    g_autoptr(GError) error = NULL;
    type = g_new0(ReaderType, 1);
    type->block_class = tinker_catalogue_type(reader->catalogue, id, &error);
    if (type->block_class == NULL) type->message = g_strdup(error->message);
    g_hash_table_insert(reader->types, g_strdup(id), type);
    return type;
}

/* The block's name where it has a good one, else NULL with an error where it has a bad one. */
static const char *read_name(SceneReader *reader, const BlockMembers *members, JsonAt at)
{
    if (members->name == NULL) return NULL;
    JsonAt name_at = at_child(at, members->name_step);
    const char *name = reader_text(reader, members->name, name_at, "name");
    if (name == NULL) return NULL;
    g_autofree char *fault = scene_name_fault(reader->scene, name);
    if (fault == NULL) return name;
    reader_error(reader, name_at, TINKER_SCENE_ERROR_NAME, "%s", fault);
    return NULL;
}

static void name_block(SceneReader *reader, TinkerBlockId id, const char *name)
{
    if (name == NULL) {
        g_array_append_val(reader->unnamed, id);
        return;
    }
    scene_assign_name(reader->scene, id, name);
}

static void keep_placeholder(SceneReader *reader, const char *type, const char *name, const JsonPart *part)
{
    ScenePlaceholder *placeholder = g_new0(ScenePlaceholder, 1);
    GString *text = g_string_new(NULL);
    json_append_compact(text, reader->text, part->start, part->end);
    placeholder->text = g_string_free(text, FALSE);
    placeholder->type = g_strdup(type);
    placeholder->name = g_strdup(name);
    placeholder->named = name != NULL;
    name_block(reader, scene_append(reader->scene, NULL, 0, placeholder), name);
}

/* "a spring has 2 ends, 1 given" */
static gboolean check_end_count(SceneReader *reader, const BlockMembers *members, JsonAt at,
                                const TinkerBlockType *type, int given)
{
    if (given >= type->least_ends && (type->most_ends < 0 || given <= type->most_ends)) return TRUE;
    g_autofree char *wanted = NULL;
    if (type->most_ends == type->least_ends)
        wanted = g_strdup_printf("%d", type->least_ends);
    else if (type->most_ends < 0)
        wanted = g_strdup_printf(_("at least %d"), type->least_ends);
    else
        wanted = g_strdup_printf(_("%d to %d"), type->least_ends, type->most_ends);
    const gboolean one = type->least_ends == 1 && (type->most_ends == 1 || type->most_ends < 0);
    g_autofree char *block = g_strdup_printf(strchr("aeiou", type->id[0]) != NULL ? _("an %s") : _("a %s"), type->id);
    JsonAt place = members->ends == NULL ? at : at_child(at, members->ends_step);
    if (type->most_ends == 0)
        return reader_error(reader, place, TINKER_SCENE_ERROR_END, _("ends: %s has no ends, %d given"), block, given);
    return reader_error(reader, place, TINKER_SCENE_ERROR_END,
                        ngettext("ends: %s has %s end, %d given", "ends: %s has %s ends, %d given", one ? 1 : 2), block,
                        wanted, given);
}

/* Makes the block's row with as many ends as are given, where that many are allowed. `read_ends` says whether they are
 * to be read. */
static TinkerBlockId add_row(SceneReader *reader, const BlockMembers *members, JsonAt at,
                             const TinkerBlockClass *block_class, gboolean *read_ends)
{
    const TinkerBlockType *type = block_class->type;
    int given = cJSON_IsArray(members->ends) ? cJSON_GetArraySize(members->ends) : 0;
    if (members->ends != NULL && !cJSON_IsArray(members->ends))
        *read_ends =
            reader_wrong_kind(reader, members->ends, at_child(at, members->ends_step), "ends", _("an array of ends"));
    else
        *read_ends = check_end_count(reader, members, at, type, given) && given > 0;
    return scene_append(reader->scene, block_class, *read_ends ? given : MAX(type->least_ends, 0), NULL);
}

static const char **property_keys(const TinkerBlockClass *block_class)
{
    const char **keys = g_new0(const char *, (gsize)block_class->property_count + 6);
    gsize count = 0;
    for (int32_t p = 0; p < block_class->property_count; p++)
        keys[count++] = block_class->properties[p].id;
    keys[count++] = "type";
    keys[count++] = "name";
    if (block_class->type->most_ends != 0) keys[count++] = "ends";
    if (tinker_class_can_be_put(block_class)) {
        keys[count++] = "on";
        keys[count++] = "along";
    }
    return keys;
}

/* A key that is the symbol of a property, as "k" is that of the stiffness, is meant for that. */
static void keep_unknown(SceneReader *reader, JsonAt at, const char *key, const TinkerBlockClass *block_class,
                         GString **unknown)
{
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const char *symbol = block_class->properties[p].symbol;
        if (symbol == NULL || g_ascii_strcasecmp(symbol, key) != 0) continue;
        g_autofree char *meant = g_strdup_printf(_(" (did you mean \"%s\"?)"), block_class->properties[p].id);
        reader_keep_member(reader, at, key, meant, unknown);
        return;
    }
    g_autofree const char **keys = property_keys(block_class);
    reader_keep_unknown(reader, at, key, keys, unknown);
}

static void read_properties(SceneReader *reader, const cJSON *json, JsonAt at, const BlockMembers *members,
                            TinkerBlockId id)
{
    SceneTable *table = scene_table_of(reader->scene, id);
    int32_t row = scene_slot(reader->scene, id)->row;
    GString *unknown = NULL;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        if (member == members->type || member == members->name || member == members->ends) continue;
        int32_t property = tinker_block_class_property(table->block_class, member->string);
        if (property >= 0) {
            reader_property(reader, member, at_child(at, step), table, row, property);
            continue;
        }
        if (reader_is_place_on(table->block_class, member->string)) continue;
        keep_unknown(reader, at_child(at, step), member->string, table->block_class, &unknown);
    }
    if (unknown != NULL) g_hash_table_insert(reader->scene->extras, GINT_TO_POINTER(id), g_string_free(unknown, FALSE));
    scene_table_resolve(table, row);
}

/* The step of the member of this name, or -1. */
static int step_of(const cJSON *json, const char *key)
{
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++)
        if (g_str_equal(member->string, key)) return step;
    return -1;
}

static void check_row(SceneReader *reader, const cJSON *json, JsonAt at, TinkerBlockId id)
{
    const SceneTable *table = scene_table_of(reader->scene, id);
    g_autofree char *fault = scene_row_fault(table, scene_slot(reader->scene, id)->row);
    if (fault == NULL) return;
    const TinkerBlockClass *block_class = table->block_class;
    int step = step_of(json, block_class->properties[block_class->meanings[TINKER_MEANING_DYNAMIC_FRICTION]].id);
    if (step < 0)
        step = step_of(json, block_class->properties[block_class->meanings[TINKER_MEANING_STATIC_FRICTION]].id);
    reader_error(reader, step < 0 ? at : at_child(at, step), TINKER_SCENE_ERROR_VALUE, "%s", fault);
}

/* What a block of the type cannot do without. Something that lies on a top has its place from there. */
static void check_required(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerBlockClass *block_class)
{
    for (int32_t p = 0; p < block_class->property_count; p++) {
        const TinkerPropertyType *property = &block_class->properties[p];
        if ((property->flags & TINKER_REQUIRED) == 0 || step_of(json, property->id) >= 0) continue;
        if (property->meaning == TINKER_MEANING_POSITION && reader_is_place_on(block_class, "on") &&
            step_of(json, "on") >= 0)
            continue;
        if (property->kind == TINKER_KIND_VECTOR)
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                         _("the key \"%s\" is missing: it has no default (give \"%s\": [x, y])"), property->id,
                         property->id);
        else
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("the key \"%s\" is missing"), property->id);
    }
}

static void read_known(SceneReader *reader, const cJSON *json, JsonAt at, const BlockMembers *members, const char *name,
                       const TinkerBlockClass *block_class)
{
    gboolean read_ends;
    TinkerBlockId id = add_row(reader, members, at, block_class, &read_ends);
    name_block(reader, id, name);
    read_properties(reader, json, at, members, id);
    check_required(reader, json, at, block_class);
    check_row(reader, json, at, id);
    reader_place_on(reader, json, at, id);
    if (read_ends) reader_ends(reader, members->ends, at_child(at, members->ends_step), id);
}

static void read_object(SceneReader *reader, const cJSON *json, const JsonPart *part, int number)
{
    JsonAt at = at_root(part->start);
    BlockMembers members = find_members(json);
    const char *type_id = cJSON_IsString(members.type) ? members.type->valuestring : NULL;
    if (cJSON_IsString(members.name) && *members.name->valuestring != '\0')
        reader_label(reader, members.name->valuestring);
    else
        reader_label_entry(reader, "blocks", number, type_id);
    if (reader->scan.duplicates->len > 0) reader_report_duplicates(reader, part->start, part->end);

    const char *name = read_name(reader, &members, at);
    if (members.type == NULL)
        reader_error(reader, at, TINKER_SCENE_ERROR_SYNTAX, _("the key \"type\" is missing"));
    else if (type_id == NULL)
        reader_text(reader, members.type, at_child(at, members.type_step), "type");
    ReaderType *type = type_id == NULL ? NULL : find_type(reader, type_id);
    if (type != NULL && type->block_class != NULL) {
        read_known(reader, json, at, &members, name, type->block_class);
        return;
    }
    if (type != NULL && type->blocks++ == 0) {
        type->finding = reader->findings->len;
        reader_warning(reader, at_child(at, members.type_step), TINKER_SCENE_ERROR_TYPE, "%s", type->message);
    }
    keep_placeholder(reader, type_id == NULL ? "" : type_id, name, part);
}

void reader_count_missing(SceneReader *reader)
{
    if (reader->types == NULL) return;
    GHashTableIter iter;
    gpointer value;
    g_hash_table_iter_init(&iter, reader->types);
    while (g_hash_table_iter_next(&iter, NULL, &value)) {
        const ReaderType *type = value;
        if (type->blocks < 2) continue;
        ReaderFinding *finding = &g_array_index(reader->findings, ReaderFinding, type->finding);
        char *whole = g_strdup_printf(
            ngettext("%s; %d more block is of it", "%s; %d more blocks are of it", (gulong)type->blocks - 1),
            finding->message, type->blocks - 1);
        g_free(finding->message);
        finding->message = whole;
    }
}

void reader_block(SceneReader *reader, int number)
{
    const JsonPart *part = &g_array_index(reader->scan.blocks, JsonPart, number);
    reader_label_entry(reader, "blocks", number, NULL);
    cJSON *json = reader_parse(reader, part);
    if (json == NULL) return;
    if (cJSON_IsObject(json))
        read_object(reader, json, part, number);
    else
        reader_error_at(reader, part->start, TINKER_SCENE_ERROR_VALUE, _("a block is an object, {\"type\": ...}"));
    cJSON_Delete(json);
}
