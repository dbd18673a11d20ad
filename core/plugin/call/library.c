/* Opening a library: the symbol, then the descriptor from its first word on, then what it declares, and only then init.
 * A library that the dynamic linker has mapped is never unmapped, so one record is kept for each path, passed or not.
 */
#include "plugin/call/library.h"

#include <gmodule.h>
#include <string.h>

#include "plugin/call/call.h"
#include "plugin/call/host-services-private.h"
#include "plugin/call/process-state.h"
#include "plugin/descriptor/class-build.h"
#include "plugin/descriptor/copy.h"
#include "plugin/descriptor/text-check.h"
#include "plugin/trust/refuse.h"

#define MOST_DESCRIPTOR 65536

typedef const TinkerPlugin *(*Entry)(void);

/* What is kept of a mapped library. */
typedef struct {
    TinkerLibrary library;
    TinkerPluginHost host;
    GPtrArray *arena; /* memory of the copies */
    char *refused;    /* why it did not pass, else NULL */
} Record;

static GMutex records_mutex;
static GHashTable *records; /* path to Record */

/* The libraries that have passed, the last first. Only ever prepended to. */
static const TinkerLibrary *passed; /* atomic */

/* The entry, whose name carries the major version: a plugin for another one exports another name. */
static Entry find_entry(GModule *module, GError **error)
{
    gpointer symbol = NULL;
    if (g_module_symbol(module, TINKER_ENTRY_SYMBOL, &symbol) && symbol != NULL) {
        Entry entry;
        memcpy(&entry, &symbol, sizeof entry);
        return entry;
    }
    for (int major = TINKER_ABI_MAJOR + 1; major <= TINKER_ABI_MAJOR + 9; major++) {
        g_autofree char *name = g_strdup_printf("tinker_plugin_v%d", major);
        if (g_module_symbol(module, name, &symbol)) {
            tinker_refuse(error, "it exports \"%s\" of ABI %d, this host needs \"%s\" of ABI %d", name, major,
                          TINKER_ENTRY_SYMBOL, TINKER_ABI_MAJOR);
            return NULL;
        }
    }
    tinker_refuse(error, "it exports no \"%s\", the entry of a plugin", TINKER_ENTRY_SYMBOL);
    return NULL;
}

static gboolean check_magic(const TinkerPlugin *own, GError **error)
{
    if (own == NULL) return tinker_refuse(error, "its entry answered NULL, a descriptor was expected");
    if (own->magic != TINKER_MAGIC)
        return tinker_refuse(error, "its magic number is 0x%08x, 0x%08x was expected", own->magic, TINKER_MAGIC);
    return TRUE;
}

static gboolean check_sizes(const TinkerPlugin *own, GError **error)
{
    /* What the first version had; members that are appended later are looked for one by one. */
    const gsize least = offsetof(TinkerPlugin, init) + sizeof(own->init);
    if (own->struct_size < least)
        return tinker_refuse(error, "its TinkerPlugin has %u bytes, this host needs at least %zu", own->struct_size,
                             least);
    if (own->struct_size > MOST_DESCRIPTOR)
        return tinker_refuse(error, "its TinkerPlugin has %u bytes, this host allows at most %d", own->struct_size,
                             MOST_DESCRIPTOR);
    if (own->size_of_double != (int32_t)sizeof(double) || own->size_of_index != (int32_t)sizeof(int32_t))
        return tinker_refuse(error, "its double has %d bytes and its index %d, this host's have %zu and %zu",
                             own->size_of_double, own->size_of_index, sizeof(double), sizeof(int32_t));
    return TRUE;
}

static gboolean check_minors(const TinkerPlugin *own, GError **error)
{
    if (own->abi_minor < 0 || own->least_host_minor < 0)
        return tinker_refuse(error, "its ABI minor is %d and the least one of the host %d, at least 0 was expected",
                             own->abi_minor, own->least_host_minor);
    if (own->least_host_minor > TINKER_ABI_MINOR)
        return tinker_refuse(error, "it needs a host of ABI %d.%d or newer, this host has ABI %d.%d", TINKER_ABI_MAJOR,
                             own->least_host_minor, TINKER_ABI_MAJOR, TINKER_ABI_MINOR);
    return TRUE;
}

static gboolean check_services(const TinkerPlugin *own, GPtrArray *arena, GError **error)
{
    const char *const *services =
        tinker_span_copy(&own->services, "services", TINKER_SHAPE_PLAIN(const char *), arena, error);
    if (services == NULL) return FALSE;
    for (int32_t i = 0; i < own->services.count; i++) {
        if (!tinker_check_id(services[i], "the id of a service", "", error)) return FALSE;
        if (!tinker_host_offers(services[i]))
            return tinker_refuse(error, "it needs the service \"%s\", this host offers %s", services[i],
                                 tinker_host_service_names());
    }
    return TRUE;
}

/* An id of a plugin, reverse DNS: letters, digits, '.', '-' and '_'. */
static gboolean check_plugin_texts(const TinkerPlugin *own, GError **error)
{
    if (!tinker_check_id(own->id, "the plugin's id", "", error)) return FALSE;
    for (const char *p = own->id; *p != '\0'; p++) {
        if (!g_ascii_isalnum(*p) && strchr(".-_", *p) == NULL)
            return tinker_refuse(error, "the plugin's id \"%s\" may have letters, digits, '.', '-' and '_' alone",
                                 own->id);
    }
    return tinker_check_text(own->title, "the plugin's title", TRUE, error) &&
           tinker_check_text(own->version, "the plugin's version", TRUE, error) &&
           tinker_check_text(own->licence, "the plugin's licence", TRUE, error) &&
           tinker_check_text(own->home_page, "the plugin's home page", FALSE, error);
}

static gboolean check_block_ids(const TinkerBlockType *types, int32_t count, GError **error)
{
    for (int32_t i = 0; i < count; i++) {
        g_autofree char *what = g_strdup_printf("the id of block type %d", i);
        if (!tinker_check_id(types[i].id, what, ",", error)) return FALSE;
        for (int32_t earlier = 0; earlier < i; earlier++) {
            if (strcmp(types[earlier].id, types[i].id) == 0)
                return tinker_refuse(error, "its block types %d and %d both have the id \"%s\"", earlier, i,
                                     types[i].id);
        }
    }
    return TRUE;
}

static gboolean check_integrator(const TinkerIntegrator *integrators, int32_t number, GError **error)
{
    const TinkerIntegrator *integrator = &integrators[number];
    g_autofree char *what = g_strdup_printf("the id of integrator %d", number);
    if (!tinker_check_id(integrator->id, what, ",", error)) return FALSE;
    for (int32_t earlier = 0; earlier < number; earlier++) {
        if (strcmp(integrators[earlier].id, integrator->id) == 0)
            return tinker_refuse(error, "its integrators %d and %d both have the id \"%s\"", earlier, number,
                                 integrator->id);
    }
    if (integrator->create == NULL || integrator->destroy == NULL || integrator->restart == NULL ||
        integrator->step == NULL || integrator->interpolate == NULL)
        return tinker_refuse(error,
                             "integrator \"%s\": create, destroy, restart, step and interpolate are required, "
                             "one of them is NULL",
                             integrator->id);
    if (integrator->flags & ~TINKER_INTEGRATOR_FLAGS)
        return tinker_refuse(error, "integrator \"%s\": its flags 0x%x have bits that this version does not know",
                             integrator->id, integrator->flags);
    return tinker_check_text(integrator->title, "an integrator's title", TRUE, error) &&
           tinker_check_text(integrator->summary, "an integrator's summary", FALSE, error) &&
           tinker_check_text(integrator->source, "an integrator's source", FALSE, error);
}

static gboolean add_integrators(Record *record, GError **error)
{
    const TinkerSpan *span = &record->library.plugin->integrators;
    TinkerIntegrator *copies = tinker_span_copy(
        span, "integrators", TINKER_SHAPE_THROUGH(TinkerIntegrator, interpolate), record->arena, error);
    if (copies == NULL) return FALSE;
    record->library.integrators = copies;
    record->library.integrator_count = span->count;
    for (int32_t i = 0; i < span->count; i++) {
        if (!check_integrator(copies, i, error)) return FALSE;
        copies[i].id = tinker_arena_text(record->arena, copies[i].id);
    }
    return TRUE;
}

static gboolean add_blocks(Record *record, GError **error)
{
    TinkerLibrary *library = &record->library;
    const TinkerSpan *span = &library->plugin->blocks;
    TinkerBlockType *types =
        tinker_span_copy(span, "block types", TINKER_SHAPE_THROUGH(TinkerBlockType, interfaces), record->arena, error);
    if (types == NULL || !check_block_ids(types, span->count, error)) return FALSE;
    const TinkerBlockClass **classes =
        tinker_arena_allocate(record->arena, (gsize)span->count * sizeof(const TinkerBlockClass *));
    for (int32_t i = 0; i < span->count; i++) {
        types[i].id = tinker_arena_text(record->arena, types[i].id);
        classes[i] = tinker_block_class_build(&types[i], library->plugin, library->path, record->arena, error);
        if (classes[i] == NULL) return FALSE;
    }
    library->classes = classes;
    library->class_count = span->count;
    if (span->count == 0 && library->integrator_count == 0)
        return tinker_refuse(error, "it declares neither block types nor integrators");
    return TRUE;
}

/* The ids of plugin, types and methods are copied too: the message about a crash names them, also where the crash came
 * of the library's file being overwritten, which takes away what is mapped from it. */
static void copy_descriptor(Record *record, const TinkerPlugin *own)
{
    TinkerPlugin *copy = tinker_arena_allocate(record->arena, sizeof *copy);
    memcpy(copy, own, MIN(own->struct_size, sizeof *copy)); // what an older one has not got stays 0
    copy->struct_size = sizeof *copy;
    copy->id = tinker_arena_text(record->arena, own->id);
    if (copy->home_page == NULL) copy->home_page = "";
    record->library.plugin = copy;
}

static gboolean call_init(Record *record, GError **error)
{
    const TinkerPlugin *plugin = record->library.plugin;
    tinker_plugin_host_init(&record->host, plugin->id);
    const TinkerStatus status = plugin->init == NULL ? TINKER_OK
                                                     : TINKER_CALL(plugin->init(&record->host.host), .phase = "init",
                                                                   .path = record->library.path);
    if (status == TINKER_OK) return TRUE;
    return tinker_refuse(error, "its init answered %d, %d (ready) was expected", status, TINKER_OK);
}

/* All checks, in the order that the contract promises. */
static gboolean check_descriptor(Record *record, const TinkerPlugin *own, GError **error)
{
    if (!check_magic(own, error) || !check_sizes(own, error) || !check_minors(own, error) ||
        !check_services(own, record->arena, error) || !check_plugin_texts(own, error))
        return FALSE;
    copy_descriptor(record, own);
    return add_integrators(record, error) && add_blocks(record, error) && call_init(record, error);
}

static gboolean check_library(Record *record, GModule *module, GError **error)
{
    const Entry entry = find_entry(module, error);
    if (entry == NULL) return FALSE;
    const TinkerPlugin *own;
    TINKER_CALL_VOID(own = entry(), .phase = TINKER_ENTRY_SYMBOL, .path = record->library.path);
    return check_descriptor(record, own, error);
}

gboolean tinker_library_check_descriptor(const TinkerPlugin *plugin, GError **error)
{
    g_autoptr(GPtrArray) arena = g_ptr_array_new_with_free_func(g_free);
    Record record = {.arena = arena};
    return check_descriptor(&record, plugin, error);
}

static GModule *map_library(const char *path, GError **error)
{
    // Bound at once and for itself alone: a missing symbol is found now, and plugins cannot see one another's.
    GModule *module;
    TINKER_CALL_VOID(module = g_module_open(path, G_MODULE_BIND_LOCAL), .phase = "dlopen", .path = path);
    if (module != NULL) return module;
    const char *reason = g_module_error();
    if (reason != NULL && g_str_has_prefix(reason, path)) reason += strlen(path) + strspn(reason + strlen(path), ": ");
    // What it lacks, a library or memory, may be there the next time.
    tinker_fail_file(error, "it cannot be opened: %s", reason == NULL ? "no reason was given" : reason);
    return NULL;
}

static Record *map_and_check(const char *path, const TinkerIdentity *identity, GError **error)
{
    GModule *module = map_library(path, error);
    if (module == NULL) return NULL;
    Record *record = g_new0(Record, 1);
    record->library.path = g_strdup(path);
    record->library.identity = *identity;
    record->arena = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GError) reason = NULL;
    if (!check_library(record, module, &reason)) {
        record->refused = g_strdup(reason->message);
        g_ptr_array_set_size(record->arena, 0);
    } else {
        record->library.next = passed;
        g_atomic_pointer_set(&passed, &record->library);
    }
    return record;
}

/* What the library changes of the process as it is mapped and started is put back. */
static Record *open_record(const char *path, GError **error)
{
    TinkerIdentity identity;
    if (!tinker_identity_read(path, &identity, error) || !tinker_elf_check(path, error)) return NULL;
    TinkerProcessState *state = tinker_process_state_save();
    Record *record = map_and_check(path, &identity, error);
    g_autofree char *changed = tinker_process_state_restore(state);
    if (record != NULL) record->library.changed = g_steal_pointer(&changed);
    return record;
}

/* The record of a library that is open already, unless its file was replaced since. */
static gboolean check_unchanged(const Record *record, GError **error)
{
    TinkerIdentity now;
    if (!tinker_identity_read(record->library.path, &now, error)) return FALSE;
    if (tinker_identity_same_file_time(&now, &record->library.identity)) return TRUE;
    return tinker_refuse(error, "it was changed after this program opened it; the new one is used after a restart");
}

static const TinkerLibrary *open_locked(const char *path, GError **error)
{
    if (records == NULL) records = g_hash_table_new(g_str_hash, g_str_equal);
    Record *record = g_hash_table_lookup(records, path);
    if (record != NULL) {
        if (!check_unchanged(record, error)) return NULL;
    } else {
        record = open_record(path, error);
        if (record == NULL) return NULL;
        g_hash_table_insert(records, record->library.path, record);
    }
    if (record->refused == NULL) return &record->library;
    tinker_refuse(error, "%s", record->refused);
    return NULL;
}

const TinkerLibrary *tinker_library_open(const char *path, GError **error)
{
    g_mutex_lock(&records_mutex);
    const TinkerLibrary *library = open_locked(path, error);
    g_mutex_unlock(&records_mutex);
    return library;
}

/* The first that has passed of which `is_it` says so; the handler of crashes asks, too. */
static const TinkerLibrary *find_passed(gboolean (*is_it)(const TinkerLibrary *library, const void *what),
                                        const void *what)
{
    const TinkerLibrary *library = g_atomic_pointer_get(&passed);
    while (library != NULL && !is_it(library, what))
        library = library->next;
    return library;
}

static gboolean has_method(const TinkerLibrary *library, const void *method)
{
    for (int32_t i = 0; i < library->integrator_count; i++)
        if (&library->integrators[i] == method) return TRUE;
    return FALSE;
}

static gboolean is_at(const TinkerLibrary *library, const void *path)
{
    return strcmp(library->path, path) == 0;
}

const TinkerPlugin *tinker_library_plugin_of_method(const TinkerIntegrator *method)
{
    const TinkerLibrary *library = find_passed(has_method, method);
    return library != NULL ? library->plugin : NULL;
}

const TinkerLibrary *tinker_library_passed(const char *path)
{
    return find_passed(is_at, path);
}

const char *tinker_library_changed_process(const char *path)
{
    const TinkerLibrary *library = tinker_library_passed(path);
    return library != NULL ? library->changed : NULL;
}
