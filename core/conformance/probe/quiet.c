/* quiet: what the contract forbids inside a step is noticed where the library calls it.
 *
 * The loader writes the address of every function of another object into a table of the calling object. In the child,
 * after the library is opened, the entries of functions that allot, lock, print or read are exchanged for counting
 * ones. So nothing is preloaded, the program's own allocations are not counted, and what the library brought with it (a
 * solver) is watched as well. What the C library allots for itself is not seen; the functions that do so are watched by
 * name. */
#include <link.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "conformance/probe/quiet.h"
#include "conformance/probe/state.h"

static const char *heard;
static gboolean listening;

static void note(const char *name)
{
    if (listening && heard == NULL) heard = name;
}

void kit_listen(void)
{
    heard = NULL;
    listening = TRUE;
}

const char *kit_heard(void)
{
    listening = FALSE;
    return heard;
}

#define WATCH(result, name, parameters, arguments)                                                                     \
    static result watched_##name parameters                                                                            \
    {                                                                                                                  \
        note(#name);                                                                                                   \
        return name arguments;                                                                                         \
    }

WATCH(void *, malloc, (size_t size), (size))
WATCH(void *, calloc, (size_t count, size_t size), (count, size))
WATCH(void *, realloc, (void *memory, size_t size), (memory, size))
WATCH(void *, aligned_alloc, (size_t alignment, size_t size), (alignment, size))
WATCH(int, posix_memalign, (void **memory, size_t alignment, size_t size), (memory, alignment, size))
WATCH(char *, strdup, (const char *text), (text))
WATCH(int, pthread_mutex_lock, (pthread_mutex_t * mutex), (mutex))
WATCH(int, puts, (const char *text), (text))
WATCH(int, putchar, (int c), (c))
WATCH(int, fputs, (const char *text, FILE *file), (text, file))
WATCH(size_t, fwrite, (const void *data, size_t size, size_t count, FILE *file), (data, size, count, file))
WATCH(int, fputc, (int c, FILE *file), (c, file))
WATCH(size_t, fread, (void *data, size_t size, size_t count, FILE *file), (data, size, count, file))
WATCH(FILE *, fopen, (const char *path, const char *mode), (path, mode))
WATCH(ssize_t, write, (int file, const void *data, size_t size), (file, data, size))
WATCH(ssize_t, read, (int file, void *data, size_t size), (file, data, size))
WATCH(char *, getenv, (const char *name), (name))

static void watched_free(void *memory)
{
    if (memory != NULL) note("free");
    free(memory);
}

#define WATCH_FORMATTED(name, told, place, parameters, print)                                                          \
    __attribute__((format(printf, place, 0))) static int watched_##name parameters                                     \
    {                                                                                                                  \
        va_list arguments;                                                                                             \
        va_start(arguments, format);                                                                                   \
        note(told);                                                                                                    \
        const int written = print;                                                                                     \
        va_end(arguments);                                                                                             \
        return written;                                                                                                \
    }

WATCH_FORMATTED(printf, "printf", 1, (const char *format, ...), vprintf(format, arguments))
WATCH_FORMATTED(fprintf, "fprintf", 2, (FILE * file, const char *format, ...), vfprintf(file, format, arguments))
/* What the two are compiled to with -D_FORTIFY_SOURCE, which some systems set for everything. */
WATCH_FORMATTED(__printf_chk, "printf", 2, (int flag, const char *format, ...), vprintf(format, arguments))
WATCH_FORMATTED(__fprintf_chk, "fprintf", 3, (FILE * file, int flag, const char *format, ...),
                vfprintf(file, format, arguments))

#define ROW(name)                                                                                                      \
    {                                                                                                                  \
#name, (uintptr_t)watched_##name                                                                               \
    }
static const struct {
    const char *name;
    uintptr_t address;
} watched[] = {
    ROW(malloc),       ROW(calloc),        ROW(realloc), ROW(free),   ROW(aligned_alloc), ROW(posix_memalign),
    ROW(strdup),       ROW(puts),          ROW(putchar), ROW(fputs),  ROW(fwrite),        ROW(fopen),
    ROW(write),        ROW(read),          ROW(getenv),  ROW(printf), ROW(fprintf),       ROW(pthread_mutex_lock),
    ROW(__printf_chk), ROW(__fprintf_chk), ROW(fputc),   ROW(fread)};

typedef struct {
    const GPtrArray *before; /* passed over */
    gboolean failed;
} Walk;

static gpointer key_of(const struct dl_phdr_info *info)
{
    return (gpointer)info->dlpi_phdr;
}

static int collect(struct dl_phdr_info *info, size_t size, void *data)
{
    g_ptr_array_add(data, key_of(info));
    return 0;
}

GPtrArray *kit_objects_now(void)
{
    GPtrArray *objects = g_ptr_array_new();
    dl_iterate_phdr(collect, objects);
    return objects;
}

/* What the dynamic section says; addresses as the loader has relocated them. */
typedef struct {
    const ElfW(Sym) * symbols;
    const char *strings;
    const ElfW(Rela) * tables[2];
    size_t sizes[2];
} Dynamic;

static uintptr_t address_in(const struct dl_phdr_info *info, uintptr_t address)
{
    return address < info->dlpi_addr ? info->dlpi_addr + address : address;
}

static void read_dynamic(const struct dl_phdr_info *info, const ElfW(Dyn) * entry, Dynamic *dynamic)
{
    gboolean with_addends = TRUE;
    for (; entry->d_tag != DT_NULL; entry++) {
        const uintptr_t address = address_in(info, entry->d_un.d_ptr);
        if (entry->d_tag == DT_SYMTAB) dynamic->symbols = (const ElfW(Sym) *)address;
        if (entry->d_tag == DT_STRTAB) dynamic->strings = (const char *)address;
        if (entry->d_tag == DT_RELA) dynamic->tables[0] = (const ElfW(Rela) *)address;
        if (entry->d_tag == DT_RELASZ) dynamic->sizes[0] = entry->d_un.d_val;
        if (entry->d_tag == DT_JMPREL) dynamic->tables[1] = (const ElfW(Rela) *)address;
        if (entry->d_tag == DT_PLTRELSZ) dynamic->sizes[1] = entry->d_un.d_val;
        if (entry->d_tag == DT_PLTREL) with_addends = entry->d_un.d_val == DT_RELA;
    }
    if (!with_addends) dynamic->sizes[1] = 0;
}

#if __SIZEOF_POINTER__ == 8
#define SYMBOL_OF(info) ELF64_R_SYM(info)
#else
#define SYMBOL_OF(info) ELF32_R_SYM(info)
#endif

static gboolean exchange_at(uintptr_t *slot, uintptr_t address)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    void *begin = (void *)((uintptr_t)slot / page * page);
    // Read-only once it is relocated: the page is opened for good, the child will not live long.
    if (mprotect(begin, page + sizeof *slot, PROT_READ | PROT_WRITE) != 0 &&
        mprotect(begin, page, PROT_READ | PROT_WRITE) != 0)
        return FALSE;
    *slot = address;
    return TRUE;
}

static gboolean exchange(const struct dl_phdr_info *info, const Dynamic *dynamic, const ElfW(Rela) * entry)
{
    const ElfW(Sym) *symbol = &dynamic->symbols[SYMBOL_OF(entry->r_info)];
    if (SYMBOL_OF(entry->r_info) == 0 || symbol->st_shndx != SHN_UNDEF) return TRUE;
    const char *name = dynamic->strings + symbol->st_name;
    for (gsize i = 0; i < G_N_ELEMENTS(watched); i++)
        if (strcmp(watched[i].name, name) == 0)
            return exchange_at((uintptr_t *)(info->dlpi_addr + entry->r_offset), watched[i].address);
    return TRUE;
}

static int watch_object(struct dl_phdr_info *info, size_t size, void *data)
{
    Walk *walk = data;
    if (g_ptr_array_find((GPtrArray *)walk->before, key_of(info), NULL)) return 0;
    for (int i = 0; i < info->dlpi_phnum; i++) {
        if (info->dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
        Dynamic dynamic = {0};
        read_dynamic(info, (const ElfW(Dyn) *)(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr), &dynamic);
        for (int table = 0; table < 2; table++)
            for (size_t k = 0; k < dynamic.sizes[table] / sizeof(ElfW(Rela)); k++)
                walk->failed |= !exchange(info, &dynamic, &dynamic.tables[table][k]);
    }
    return 0;
}

gboolean kit_watch_calls(const GPtrArray *objects)
{
    Walk walk = {.before = objects};
    dl_iterate_phdr(watch_object, &walk);
    return !walk.failed;
}

void kit_try_quiet(KitCheck *check)
{
    g_autoptr(GArray) functions = kit_functions(check->block_class);
    g_autoptr(KitState) state = functions->len == 0 ? NULL : kit_state_new(check, KIT_COUNT);
    int tried = 0;
    if (state != NULL && !kit_watch_calls(check->objects)) kit_skip(check, "its calls cannot be watched here");
    for (guint i = 0; state != NULL && i < functions->len && !kit_decided(check); i++) {
        const KitFunction *function = &g_array_index(functions, KitFunction, i);
        if (!function->hot) continue;
        kit_listen();
        g_autoptr(KitAnswer) answer =
            kit_call(check, function, state); // what the kit allots is not called by the library
        const char *name = kit_heard();
        if (name != NULL) kit_fail(check, "%s calls %s; the host calls it inside steps", function->name, name);
        tried++;
    }
    if (tried == 0) kit_skip(check, "it offers no function that is called inside a step");
}
