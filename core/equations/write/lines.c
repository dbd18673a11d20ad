/* Whichever form of the equations is given, as a text or line by line. */
#include "equations/write/lines.h"

#include <glib/gi18n-lib.h>

#include "equations/write/page-private.h"

static void put(TinkerPage *page, const TinkerMatrixForm *matrix, const TinkerAngleForm *angles,
                const TinkerEquationsShown *shown)
{
    if (matrix != NULL)
        tinker_equations_put_matrix(page, matrix, shown);
    else if (angles != NULL)
        tinker_equations_put_angles(page, angles, shown);
    else
        tinker_equations_put_newton(page, shown);
}

char *tinker_equations_write(const TinkerEquations *equations, const TinkerMatrixForm *matrix,
                             const TinkerAngleForm *angles, const TinkerEquationsShown *shown)
{
    TinkerPage page;
    const gboolean newton = matrix == NULL && angles == NULL; /* the others tell the time at each value */
    g_autofree char *title = newton && shown->values
                                 ? g_strdup_printf(C_("equations", "%s, at t = %g s"), shown->title, equations->time)
                                 : g_strdup(shown->title);
    tinker_page_begin(&page, shown->format, equations, title);
    put(&page, matrix, angles, shown);
    return tinker_page_end(&page);
}

GPtrArray *tinker_equations_lines(const TinkerEquations *equations, const TinkerMatrixForm *matrix,
                                  const TinkerAngleForm *angles, const TinkerEquationsShown *shown)
{
    TinkerPage page;
    tinker_page_begin(&page, shown->format, equations, "");
    page.lines = tinker_page_lines_new();
    put(&page, matrix, angles, shown);
    GPtrArray *lines = page.lines;
    g_free(tinker_page_end(&page));
    return lines;
}
