/* Memory that cannot be had, when the environment says so:
 *     TEST_FAULT          "NUMBER KIND": the NUMBERth request for memory (from 1) since main began finds none; KIND is
 * "once", or "later" where all that come after it find none either TEST_FAULT_REACHED  a file that gets two numbers
 * when main has returned: how many requests there were, and how many pieces of memory were not given back Children of
 * the program have all the memory that there is. */
#include <dlfcn.h>
#include <errno.h>
#include <malloc.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VISIBLE __attribute__((visibility("default")))

typedef int (*Main)(int, char **, char **);
typedef int (*StartMain)(Main, int, char **, Main, void (*)(void), void (*)(void), void *);

/* The C library's own names for its functions, for those who put others before them. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t alignment, size_t size);
void __libc_free(void *memory);

static atomic_long requests, pieces;
static atomic_int counting;
static long failing; /* the number of the first request that fails; 0: none */
static int later;
static Main program;

static int is_refused(void)
{
    if (!counting) return 0;
    const long number = ++requests;
    const int refused = failing > 0 && (number == failing || (later && number > failing));
    if (refused) errno = ENOMEM;
    return refused;
}

static void *counted(void *memory)
{
    if (memory != NULL) pieces++;
    return memory;
}

VISIBLE void *malloc(size_t size)
{
    return is_refused() ? NULL : counted(__libc_malloc(size));
}

VISIBLE void *calloc(size_t count, size_t size)
{
    return is_refused() ? NULL : counted(__libc_calloc(count, size));
}

VISIBLE void *realloc(void *memory, size_t size)
{
    if (memory == NULL) return malloc(size);
    if (is_refused()) return NULL;
    if (size == 0) pieces--; // as free() does
    return __libc_realloc(memory, size);
}

VISIBLE void *memalign(size_t alignment, size_t size)
{
    return is_refused() ? NULL : counted(__libc_memalign(alignment, size));
}

VISIBLE void *aligned_alloc(size_t alignment, size_t size)
{
    return memalign(alignment, size);
}

VISIBLE int posix_memalign(void **memory, size_t alignment, size_t size)
{
    void *got = memalign(alignment, size);
    if (got != NULL) *memory = got;
    return got == NULL ? ENOMEM : 0;
}

VISIBLE void free(void *memory)
{
    if (memory != NULL) pieces--;
    __libc_free(memory);
}

/* A function of GLib, where the program has it. */
#define FIND(function, name)                                                                                           \
    void *symbol_##function = dlsym(RTLD_DEFAULT, name);                                                               \
    memcpy(&(function), &symbol_##function, sizeof(function))

/* What GLib sets up once for the words of errors, and the names of files in them, is there before anything is counted.
 */
static void prepare_words(void)
{
    const char *(*words)(int);
    char *(*shown)(const char *);
    FIND(words, "g_strerror");
    FIND(shown, "g_filename_display_name");
    if (words == NULL || shown == NULL) return;
    words(ENOMEM);
    free(shown("file"));
}

static int counted_main(int argc, char **argv, char **environment)
{
    char kind[8] = "", *told = NULL;
    const char *text = getenv("TEST_FAULT"), *reached = getenv("TEST_FAULT_REACHED");
    if (text != NULL && sscanf(text, "%ld %7s", &failing, kind) != 2) abort();
    later = strcmp(kind, "later") == 0;
    if (reached != NULL) told = strdup(reached);
    prepare_words();
    unsetenv("TEST_FAULT");
    unsetenv("LD_PRELOAD");
    counting = 1;
    const int status = program(argc, argv, environment);
    counting = 0;
    FILE *file = told != NULL ? fopen(told, "w") : NULL;
    if (file != NULL) {
        fprintf(file, "%ld %ld\n", requests, pieces);
        fclose(file);
    }
    free(told);
    return status;
}

VISIBLE int __libc_start_main(Main main, int argc, char **argv, Main init, void (*fini)(void),
                              void (*loader_fini)(void), void *stack_end);

VISIBLE int __libc_start_main(Main main, int argc, char **argv, Main init, void (*fini)(void),
                              void (*loader_fini)(void), void *stack_end)
{
    void *symbol = dlsym(RTLD_NEXT, "__libc_start_main");
    StartMain start;
    memcpy(&start, &symbol, sizeof start);
    program = main;
    return start(counted_main, argc, argv, init, fini, loader_fini, stack_end);
}
