/* Manifests: what is accepted has all that the catalogue goes by. */
#include <string.h>

#include "fuzz-target.h"
#include "plugin/catalogue/manifest-private.h"

static void require(const char *text, const char *what)
{
    if (text == NULL) g_error("a manifest without %s was accepted", what);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    g_autofree char *text = g_strndup((const char *)data, size);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerManifest) manifest = tinker_manifest_parse(text, &error);
    if (manifest == NULL) {
        if (error == NULL || !g_utf8_validate(error->message, -1, NULL))
            g_error("no message, or one that is not UTF-8");
        return 0;
    }
    require(manifest->id, "an id");
    require(manifest->title, "a title");
    require(manifest->version, "a version");
    require(manifest->licence, "a licence");
    require(manifest->home_page, "a home page");
    for (guint i = 0; i < manifest->types->len; i++) {
        const TinkerTypeEntry *entry = g_ptr_array_index(manifest->types, i);
        require(entry->id, "the id of a type");
        require(entry->title, "the title of a type");
        require(entry->category, "the category of a type");
        require(entry->summary, "the summary of a type");
    }
    for (guint i = 0; i < manifest->integrators->len; i++)
        require(g_ptr_array_index(manifest->integrators, i), "the id of an integrator");
    const TinkerIdentity other = {manifest->identity.size, manifest->identity.mtime_ns + 1};
    tinker_manifest_matches(manifest, "/dev/null", &other);
    return 0;
}
