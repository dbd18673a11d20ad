/* Pictures of what a task found about the model: the free-body diagram and the books, in which what is pointed at
 * stands out. */
#ifndef TINKER_GUI_MODEL_PICTURE_H
#define TINKER_GUI_MODEL_PICTURE_H

#include <gtk/gtk.h>

#include "gui/equation/model-task.h"

/* Hidden at first. They take references; whoever sees a new result has them drawn again. */
GtkWidget *tinker_model_diagram_new(TinkerDocument *document, TinkerModelTask *task);
GtkWidget *tinker_model_books_new(TinkerDocument *document, TinkerModelTask *task);

#endif
