#!/usr/bin/python3
"""The gallery: examples as pictures, in groups, searched, opened by mouse and keys."""
import re

from harness import App, main, wait


def gallery(app):
    """What the entry for words is in."""
    entry = app.find("entry", "Search titles and descriptions")
    return [node for node in entry.ancestors() if node.has_place()][-1]


def test_first_start_leads_to_it(display):
    with App(display) as app:
        app.find("button", "Double pendulum")  # the last of the card, which is in its place then
        app.click("All Examples…")
        app.find("label", "Vibration", inside=gallery(app))
        app.find("button", re.compile("^Stick and slip"), inside=gallery(app))
        app.press("Escape")
        app.gone("entry", "Search titles and descriptions")


def test_search_and_open(display):
    """A word of the description finds it, too; what is opened says what it is about."""
    with App(display) as app:
        app.press("ctrl+shift+o")
        inside = gallery(app)
        app.find("button", re.compile("^Stick and slip"), inside=inside)
        app.focus_window()
        app.type("earthquake")
        wait(lambda: app.look("label", "Vibration", inside=inside) is None, "the others to go")
        app.click(app.find("button", re.compile("^Blocks in the El Centro"), inside=inside))
        wait(lambda: "El Centro" in app.title(), "the example")
        app.find_text("What Is Modelled")


if __name__ == "__main__":
    main()
