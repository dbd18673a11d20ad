/* symbols: what the file exports and asks for, read from its own tables (System V ABI, "Symbol Table", "Dynamic
 * Section"). */
#include <elf.h>
#include <link.h>
#include <string.h>

#include "conformance/probe/kit.h"

typedef struct {
    const char *bytes;
    gsize size;
    const ElfW(Shdr) * sections;
    gsize count;
} File;

static gconstpointer bytes_at(const File *file, guint64 offset, guint64 size)
{
    return offset <= file->size && size <= file->size - offset ? file->bytes + offset : NULL;
}

static gboolean find_sections(File *file)
{
    const ElfW(Ehdr) *header = bytes_at(file, 0, sizeof *header);
    if (header == NULL || header->e_shentsize != sizeof(ElfW(Shdr))) return FALSE;
    file->count = header->e_shnum;
    file->sections = bytes_at(file, header->e_shoff, file->count * sizeof(ElfW(Shdr)));
    return file->sections != NULL && file->count > 0;
}

/* A text of the string table that the section is linked to; NULL where it is not one. */
static const char *text_of(const File *file, const ElfW(Shdr) * section, guint64 at)
{
    if (section->sh_link >= file->count) return NULL;
    const ElfW(Shdr) *strings = &file->sections[section->sh_link];
    const char *begin = bytes_at(file, strings->sh_offset, strings->sh_size);
    if (begin == NULL || at >= strings->sh_size) return NULL;
    return memchr(begin + at, '\0', strings->sh_size - at) != NULL ? begin + at : NULL;
}

static void look_at_exports(KitCheck *check, const File *file, const ElfW(Shdr) * section)
{
    const gsize count = section->sh_size / sizeof(ElfW(Sym));
    const ElfW(Sym) *symbols = bytes_at(file, section->sh_offset, count * sizeof *symbols);
    for (gsize i = 0; symbols != NULL && i < count; i++) {
        const int bind = symbols[i].st_info >> 4, visibility = symbols[i].st_other & 3;
        if (symbols[i].st_shndx == SHN_UNDEF || (bind != STB_GLOBAL && bind != STB_WEAK)) continue;
        if (visibility == STV_HIDDEN || visibility == STV_INTERNAL) continue;
        const char *name = text_of(file, section, symbols[i].st_name);
        // A sanitizer's compiler exports marks of its own.
        if (name == NULL || strcmp(name, TINKER_ENTRY_SYMBOL) == 0 || g_str_has_prefix(name, "__")) continue;
        kit_fail(check, "it exports \"%s\"; \"%s\" alone was expected (compile with -fvisibility=hidden)", name,
                 TINKER_ENTRY_SYMBOL);
    }
}

static void look_at_needs(KitCheck *check, const File *file, const ElfW(Shdr) * section, GString *others)
{
    static const char *const usual[] = {"libc.so", "libm.so", "libasan.so", "libubsan.so", "ld-linux", NULL};
    const gsize count = section->sh_size / sizeof(ElfW(Dyn));
    const ElfW(Dyn) *entries = bytes_at(file, section->sh_offset, count * sizeof *entries);
    for (gsize i = 0; entries != NULL && i < count; i++) {
        if (entries[i].d_tag != DT_NEEDED) continue;
        const char *name = text_of(file, section, entries[i].d_un.d_val);
        gboolean known = name == NULL;
        for (int k = 0; usual[k] != NULL && !known; k++)
            known = g_str_has_prefix(name, usual[k]);
        if (known) continue;
        if (g_str_has_prefix(name, "libtinker"))
            kit_fail(check, "it links to %s; a plugin links to nothing of Tinker's", name);
        g_string_append_printf(others, "%s%s", others->len > 0 ? ", " : "", name);
    }
}

void kit_try_symbols(KitCheck *check)
{
    g_autofree char *bytes = NULL;
    File file = {0};
    g_autoptr(GString) others = g_string_new(NULL);
    if (!g_file_get_contents(check->path, &bytes, &file.size, NULL)) return;
    file.bytes = bytes;
    if (!find_sections(&file)) {
        kit_skip(check, "the file has no table of sections to read");
        return;
    }
    for (gsize i = 0; i < file.count; i++) {
        if (file.sections[i].sh_type == SHT_DYNSYM) look_at_exports(check, &file, &file.sections[i]);
        if (file.sections[i].sh_type == SHT_DYNAMIC) look_at_needs(check, &file, &file.sections[i], others);
    }
    if (others->len > 0) kit_tell(check, "beyond the C library it needs %s, and so do its users", others->str);
}
