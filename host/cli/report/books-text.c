/* Three accounts, one below the other: what there was, what each force gave, what there is, and what is left over. */
#include <float.h>
#include <math.h>

#include "cli/report/books-report.h"
#include "cli/report/text-table.h"
#include "common/diagram/books-accounts.h"
#include "common/program/csv-writer.h"
#include "common/program/print.h"

static const TinkerBookEntry *entry_at(const TinkerBooks *books, guint number)
{
    return &g_array_index(books->entries, TinkerBookEntry, number);
}

/* A sum over an interval is rounded as often as there are terms, of which this is a part. */
#define ROUNDING (64 * DBL_EPSILON)

/* 0 where it is no more than the rounding of what was moved. */
static void add_number(TinkerTextTable *table, double value, double scale)
{
    g_autofree char *text = g_strdup_printf("%.6g", fabs(value) <= ROUNDING * scale ? 0 : value);
    tinker_text_table_add(table, text);
}

static void add_row(TinkerTextTable *table, const char *label, const double *values, const double *scales, int count)
{
    tinker_text_table_add(table, label);
    for (int i = 0; i < count; i++)
        add_number(table, values[i], scales[i]);
}

enum { FORCES, WORK, IMPULSES };

/* A row for each part of entry number `i`: of a contact two. */
static void add_parts(TinkerTextTable *table, const TinkerBooks *books, TinkerScene *scene, guint i, int what,
                      const double *scales)
{
    TinkerBookShare parts[2];
    const int count = tinker_book_parts(entry_at(books, i), parts);
    for (int k = 0; k < count; k++) {
        const double rows[][3] = {{parts[k].force[0], parts[k].force[1]},
                                  {parts[k].work},
                                  {parts[k].impulse[0], parts[k].impulse[1], parts[k].angular}};
        static const int columns[] = {2, 1, 3};
        g_autofree char *name = tinker_book_part_name(books, scene, entry_at(books, i), k);
        add_row(table, name, rows[what], scales, columns[what]);
    }
}

static void heading(FILE *file, const char *text)
{
    fputc('\n', file);
    tinker_print_line(file, "%s", text);
}

static void write_residual(FILE *file, const TinkerBookBalance *balance, const char *unit)
{
    tinker_print_line(file, "  left over: %.2g %s, %.1g of what was moved", balance->residual, unit,
                      balance->scale > 0 ? ABS(balance->residual) / balance->scale : 0.0);
}

static void write_newton(const TinkerBooks *books, TinkerScene *scene, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrr", 2);
    const double scales[] = {books->newton.scale, books->newton.scale};
    g_autofree char *title = g_strdup_printf("Newton, at t = %g s (N)", books->to);
    heading(file, title);
    for (guint i = 0; i < books->entries->len; i++)
        if (!entry_at(books, i)->inner) add_parts(table, books, scene, i, FORCES, scales);
    add_row(table, "= m a", books->rate, scales, 2);
    tinker_text_table_write(table, file);
    write_residual(file, &books->newton, "N");
}

static void write_energy(const TinkerBooks *books, TinkerScene *scene, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lr", 2);
    heading(file, "Work and energy (J)");
    add_row(table, "kinetic energy before", &books->kinetic[0], &books->energy.scale, 1);
    for (guint i = 0; i < books->entries->len; i++)
        add_parts(table, books, scene, i, WORK, &books->energy.scale);
    add_row(table, "= kinetic energy after", &books->kinetic[1], &books->energy.scale, 1);
    tinker_text_table_write(table, file);
    write_residual(file, &books->energy, "J");
}

static void write_momentum(const TinkerBooks *books, TinkerScene *scene, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("lrrr", 2);
    g_autofree char *about = tinker_books_about(books, scene);
    g_autofree char *title = g_strdup_printf("Impulse and momentum (N s in x and y; N m s about %s)", about);
    heading(file, title);
    const double scales[] = {books->impulse.scale, books->impulse.scale, books->moment.scale};
    const double before[] = {books->momentum[0][0], books->momentum[0][1], books->angular[0]};
    const double after[] = {books->momentum[1][0], books->momentum[1][1], books->angular[1]};
    add_row(table, "momentum before", before, scales, 3);
    for (guint i = 0; i < books->entries->len; i++)
        if (!entry_at(books, i)->inner) add_parts(table, books, scene, i, IMPULSES, scales);
    add_row(table, "= momentum after", after, scales, 3);
    tinker_text_table_write(table, file);
    write_residual(file, &books->impulse, "N s");
    write_residual(file, &books->moment, "N m s");
}

static void write_impacts(const TinkerBooks *books, TinkerScene *scene, FILE *file)
{
    if (books->impacts->len > 0) heading(file, "Impacts");
    for (guint i = 0; i < books->impacts->len; i++) {
        const TinkerBookImpact *impact = &g_array_index(books->impacts, TinkerBookImpact, i);
        tinker_print_line(file, "  t = %.6g s: %s on %s gave (%.6g, %.6g) N s and %.6g J%s", impact->time,
                          impact->by >= 0 ? tinker_scene_block_name(scene, impact->by) : "several together",
                          tinker_scene_block_name(scene, impact->on), impact->impulse[0], impact->impulse[1],
                          impact->work, impact->by >= 0 ? "" : " (in none of the sums)");
    }
}

static void write_unsettled(const TinkerBooks *books, FILE *file)
{
    if (books->unsettled <= 0) return;
    tinker_print_line(file,
                      "The sums are right to about %.1g %% only, whatever is left over: forces swing too often between "
                      "these times. Take less time, with --from and --to.",
                      100 * books->unsettled);
}

void tinker_books_write_text(const TinkerBooks *books, TinkerScene *scene, const TinkerBlockId *bodies, FILE *file)
{
    g_autoptr(GString) names = g_string_new(NULL);
    for (; *bodies >= 0; bodies++)
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", tinker_scene_block_name(scene, *bodies));
    tinker_print_line(file, "Books of %s, from %g s to %g s", names->str, books->from, books->to);
    write_newton(books, scene, file);
    write_energy(books, scene, file);
    write_momentum(books, scene, file);
    write_impacts(books, scene, file);
    write_unsettled(books, file);
    gboolean first = TRUE;
    for (guint i = 0; i < books->entries->len; i++) {
        if (!entry_at(books, i)->inner) continue;
        if (first) heading(file, "Between the bodies: forces cancel, and only work counts");
        first = FALSE;
        tinker_print_line(file, "  %s", tinker_scene_block_name(scene, entry_at(books, i)->by));
    }
}

void tinker_books_write_csv(const TinkerBooks *books, TinkerScene *scene, FILE *file)
{
    static const char *const titles[] = {"block",
                                         "force_x [N]",
                                         "force_y [N]",
                                         "work [J]",
                                         "impulse_x [N s]",
                                         "impulse_y [N s]",
                                         "angular_impulse [N m s]"};
    g_auto(TinkerCsvWriter) writer = tinker_csv_writer_record(file);
    for (gsize i = 0; i < G_N_ELEMENTS(titles); i++)
        tinker_csv_text(&writer, titles[i]);
    tinker_csv_end_row(&writer);
    for (guint i = 0; i < books->entries->len; i++) {
        const TinkerBookEntry *entry = entry_at(books, i);
        const double outer = entry->inner ? 0 : 1; /* what cancels counts as nothing */
        const TinkerBookShare *all = &entry->all;
        const double values[] = {outer * all->force[0],   outer * all->force[1],   all->work,
                                 outer * all->impulse[0], outer * all->impulse[1], outer * all->angular};
        tinker_csv_text(&writer, tinker_scene_block_name(scene, entry->by));
        for (gsize k = 0; k < G_N_ELEMENTS(values); k++)
            tinker_csv_number(&writer, values[k]);
        tinker_csv_end_row(&writer);
    }
}
