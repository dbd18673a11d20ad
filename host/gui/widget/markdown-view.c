/* By lines: what a line begins with says what it is, and the paragraphs between are joined. */
#include "gui/widget/markdown-view.h"

#include <string.h>

#define MOST_COLUMNS 16

/* What is being made. */
typedef struct {
    GtkWidget *box;
    const char *folder;
    GCallback follow;
    gpointer data;
    GString *paragraph;
    GtkWidget *item; /* the label of a list's item that goes on, or NULL */
    GtkWidget *table;
    int table_rows;
} Maker;

/* Lines ------------------------------------------------------------------------------------------------------------ */

static void replace_all(GString *text, const char *pattern, const char *with)
{
    g_autoptr(GRegex) regex = g_regex_new(pattern, 0, 0, NULL);
    g_autofree char *replaced = g_regex_replace(regex, text->str, -1, 0, with, 0, NULL);
    g_string_assign(text, replaced);
}

/* Of a piece without code. */
static void append_plain(GString *markup, const char *piece)
{
    g_autofree char *escaped = g_markup_escape_text(piece, -1);
    g_autoptr(GString) text = g_string_new(escaped);
    replace_all(text, "\\*\\*([^*]+)\\*\\*", "<b>\\1</b>");
    replace_all(text, "(^|[^*\\w])\\*([^*\\s][^*]*)\\*", "\\1<i>\\2</i>");
    g_string_append(markup, text->str);
}

/* Whether the marks do not cross one another. */
static gboolean is_whole(const char *markup)
{
    static const GMarkupParser parser = {NULL, NULL, NULL, NULL, NULL};
    g_autoptr(GMarkupParseContext) context = g_markup_parse_context_new(&parser, 0, NULL, NULL);
    g_autofree char *whole = g_strdup_printf("<p>%s</p>", markup);
    return g_markup_parse_context_parse(context, whole, -1, NULL) && g_markup_parse_context_end_parse(context, NULL);
}

/* What Pango makes of a line with `code`, **bold**, *emphasis* and [links](to). (transfer full) */
static char *markup_of(const char *text)
{
    g_auto(GStrv) pieces = g_strsplit(text, "`", -1);
    g_autoptr(GString) markup = g_string_new(NULL);
    const guint count = g_strv_length(pieces);
    for (guint i = 0; i < count; i++) {
        g_autofree char *code = g_markup_escape_text(pieces[i], -1);
        if (i % 2 == 0 || i + 1 == count)
            append_plain(markup, pieces[i]);
        else
            g_string_append_printf(markup, "<tt>%s</tt>", code);
    }
    replace_all(markup, "!?\\[([^\\]]+)\\]\\(([^)\\s]+)\\)", "<a href=\"\\2\">\\1</a>");
    return is_whole(markup->str) ? g_strdup(markup->str) : g_markup_escape_text(text, -1);
}

/* Widgets ---------------------------------------------------------------------------------------------------------- */

static GtkWidget *label_new(const Maker *maker, const char *text, const char *css_class)
{
    g_autofree char *markup = markup_of(text);
    GtkWidget *label = gtk_label_new(NULL);
    gtk_label_set_markup(GTK_LABEL(label), markup);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_yalign(GTK_LABEL(label), 0);
    gtk_label_set_selectable(GTK_LABEL(label), TRUE);
    if (css_class != NULL) gtk_widget_add_css_class(label, css_class);
    g_signal_connect_data(label, "activate-link", maker->follow, maker->data, NULL, 0);
    return label;
}

static void end_paragraph(Maker *maker)
{
    if (maker->paragraph->len > 0 && maker->item != NULL) {
        g_autofree char *markup = markup_of(maker->paragraph->str);
        gtk_label_set_markup(GTK_LABEL(maker->item), markup);
    } else if (maker->paragraph->len > 0) {
        gtk_box_append(GTK_BOX(maker->box), label_new(maker, maker->paragraph->str, NULL));
    }
    g_string_truncate(maker->paragraph, 0);
    maker->item = NULL;
    maker->table = NULL;
}

/* As others make links to headings: in small letters, with - for blanks and without signs. (transfer full) */
static char *anchor_of(const char *heading)
{
    g_autofree char *small = g_utf8_strdown(heading, -1);
    GString *anchor = g_string_new(NULL);
    for (const char *at = small; *at != '\0'; at = g_utf8_next_char(at)) {
        const gunichar letter = g_utf8_get_char(at);
        if (letter == ' ' || letter == '-')
            g_string_append_c(anchor, '-');
        else if (g_unichar_isalnum(letter) || letter == '_')
            g_string_append_unichar(anchor, letter);
    }
    return g_string_free(anchor, FALSE);
}

static void add_heading(Maker *maker, const char *line)
{
    static const char *const classes[] = {"title-1", "title-2", "title-3", "title-4"};
    const gsize level = strspn(line, "#"), below = level > 0 ? level - 1 : 0;
    const char *text = line + level + strspn(line + level, " ");
    end_paragraph(maker);
    GtkWidget *label = label_new(maker, text, classes[MIN(below, G_N_ELEMENTS(classes) - 1)]);
    g_autofree char *anchor = anchor_of(text);
    gtk_label_set_selectable(GTK_LABEL(label), FALSE);
    gtk_widget_set_name(label, anchor);
    gtk_box_append(GTK_BOX(maker->box), label);
}

/* The words of an item come with the lines that follow. */
static void begin_item(Maker *maker, const char *mark, const char *text)
{
    end_paragraph(maker);
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8), *bullet = gtk_label_new(mark);
    gtk_widget_set_valign(bullet, GTK_ALIGN_START);
    maker->item = label_new(maker, "", NULL);
    gtk_widget_set_hexpand(maker->item, TRUE);
    gtk_box_append(GTK_BOX(line), bullet);
    gtk_box_append(GTK_BOX(line), maker->item);
    gtk_box_append(GTK_BOX(maker->box), line);
    g_string_assign(maker->paragraph, text);
}

static void add_code(Maker *maker, const char *code)
{
    end_paragraph(maker);
    GtkWidget *label = gtk_label_new(code);
    gtk_label_set_wrap(GTK_LABEL(label), TRUE);
    gtk_label_set_wrap_mode(GTK_LABEL(label), PANGO_WRAP_WORD_CHAR);
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_label_set_selectable(GTK_LABEL(label), TRUE);
    gtk_widget_add_css_class(label, "monospace");
    gtk_widget_add_css_class(label, "help-code");
    gtk_box_append(GTK_BOX(maker->box), label);
}

static void add_table_row(Maker *maker, const char *line)
{
    g_autofree char *kept = g_strdup(line + 1); /* a bar in code is written \| */
    g_autoptr(GRegex) bars = g_regex_new("(?<!\\\\)\\|", 0, 0, NULL);
    g_auto(GStrv) cells = g_regex_split(bars, g_strchomp(kept), 0);
    if (maker->table == NULL) {
        end_paragraph(maker);
        maker->table = gtk_grid_new();
        maker->table_rows = 0;
        gtk_grid_set_column_spacing(GTK_GRID(maker->table), 18);
        gtk_grid_set_row_spacing(GTK_GRID(maker->table), 6);
        gtk_box_append(GTK_BOX(maker->box), maker->table);
    }
    if (strspn(line, "|-: ") == strlen(line)) return;
    for (int i = 0; cells[i] != NULL && cells[i + 1] != NULL && i < MOST_COLUMNS; i++) {
        g_auto(GStrv) parts = g_strsplit(g_strstrip(cells[i]), "\\|", -1);
        g_autofree char *text = g_strjoinv("|", parts);
        GtkWidget *label = label_new(maker, text, maker->table_rows == 0 ? "heading" : NULL);
        gtk_label_set_max_width_chars(GTK_LABEL(label), i == 0 ? 36 : 72);
        gtk_widget_set_hexpand(label, i > 0);
        gtk_grid_attach(GTK_GRID(maker->table), label, i, maker->table_rows, 1, 1);
    }
    maker->table_rows++;
}

static gboolean add_picture(Maker *maker, const char *line)
{
    g_autoptr(GRegex) regex = g_regex_new("^!\\[([^\\]]*)\\]\\(([^)]+)\\)$", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    if (!g_regex_match(regex, line, 0, &match)) return FALSE;
    g_autofree char *words = g_match_info_fetch(match, 1), *to = g_match_info_fetch(match, 2);
    g_autofree char *path = g_build_filename(maker->folder, to, NULL);
    end_paragraph(maker);
    GtkWidget *picture = gtk_picture_new_for_filename(path);
    gtk_picture_set_alternative_text(GTK_PICTURE(picture), words);
    gtk_picture_set_can_shrink(GTK_PICTURE(picture), TRUE);
    gtk_widget_set_size_request(picture, -1, 360);
    gtk_widget_set_halign(picture, GTK_ALIGN_START);
    gtk_box_append(GTK_BOX(maker->box), picture);
    return TRUE;
}

/* Text ------------------------------------------------------------------------------------------------------------- */

static void add_words(Maker *maker, const char *line)
{
    if (maker->paragraph->len > 0) g_string_append_c(maker->paragraph, ' ');
    g_string_append(maker->paragraph, line + strspn(line, " "));
}

static void add_line(Maker *maker, const char *line)
{
    const gsize digits = strspn(line, "0123456789");
    g_autofree char *number = g_strndup(line, digits + 1);
    if (line[0] == '\0' || g_str_has_prefix(line, "<!--"))
        end_paragraph(maker);
    else if (line[0] == '#')
        add_heading(maker, line);
    else if (line[0] == '|')
        add_table_row(maker, line);
    else if (g_str_has_prefix(line, "* ") || g_str_has_prefix(line, "- "))
        begin_item(maker, "•", line + 2);
    else if (digits > 0 && g_str_has_prefix(line + digits, ". "))
        begin_item(maker, number, line + digits + 2);
    else if (line[0] != '!' || !add_picture(maker, line))
        add_words(maker, line);
}

/* The code that begins at this line, fenced or set in; NULL: it is none. `*line` goes to its last one. (transfer full)
 */
static char *take_code(char **lines, guint *line, gboolean in_text)
{
    const gboolean fenced = g_str_has_prefix(lines[*line], "```");
    if (!fenced && (in_text || !g_str_has_prefix(lines[*line], "    "))) return NULL;
    GString *code = g_string_new(NULL);
    guint at = fenced ? *line + 1 : *line;
    for (; lines[at] != NULL; at++) {
        if (fenced ? g_str_has_prefix(lines[at], "```") : !g_str_has_prefix(lines[at], "    ")) break;
        g_string_append_printf(code, "%s%s", code->len > 0 ? "\n" : "", fenced ? lines[at] : lines[at] + 4);
    }
    *line = fenced && lines[at] != NULL ? at : at - 1;
    return g_string_free(code, FALSE);
}

GtkWidget *tinker_markdown_view_new(const char *text, const char *folder, GCallback follow, gpointer data)
{
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    Maker maker = {gtk_box_new(GTK_ORIENTATION_VERTICAL, 12), folder, follow, data, g_string_new(NULL), NULL, NULL, 0};
    for (guint i = 0; lines[i] != NULL; i++) {
        g_autofree char *code = take_code(lines, &i, maker.paragraph->len > 0);
        if (code != NULL)
            add_code(&maker, code);
        else
            add_line(&maker, lines[i]);
    }
    end_paragraph(&maker);
    g_string_free(maker.paragraph, TRUE);
    return maker.box;
}
