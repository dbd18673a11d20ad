#!/usr/bin/python3
"""Laws that are typed: shown typeset as they are typed, with what is wrong with them."""
import re

from harness import App, check, check_equal, main, mass, scene, support, wait

LAW = {"type": "law-connector", "name": "Law", "ends": ["Wall", "Bob"], "tension": "a*(L - b)", "a": "20 N/m", "b": "1 m",
       "c": "3 kg"}


def typed(display):
    return App(display, scene(support("Wall", 0, 3, solid=False), mass("Bob", 0, 0), LAW))


def begin(app):
    app.click(app.find("list item", re.compile("^Law, ")))
    app.find("image", "T equals")
    app.find("image", "a times, L minus b")
    entry = app.field("Law", "Tension")
    app.click(entry)
    wait(lambda: app._has_focus(entry), "the entry to have the focus")


def replace(app, text):
    app._replace_text(text)


def test_law_is_typeset_as_it_is_typed(display):
    """And taken by Return, not before."""
    with typed(display) as app:
        begin(app)
        replace(app, "a*L^2/b")
        app.find("image", re.compile("a.* L to the power 2|^a.*L.*"))
        app.press("Return")
        wait(lambda: app.look("image", "a times, L minus b") is None, "the new law")
        app.press("ctrl+s")
        wait(lambda: app.blocks()["Law"]["tension"] == "a*L^2/b", "the law in the file")


def test_what_is_wrong_is_told_and_the_last_law_stays(display):
    with typed(display) as app:
        begin(app)
        replace(app, "a*(L - q)")
        app.find("alert", re.compile("q"))
        app.find("image", "T equals")
        app.press("Return")
        check_equal(app.blocks()["Law"]["tension"], "a*(L - b)", "the law in the file")
        app.press("Escape")
        wait(lambda: app.look("alert", re.compile("q")) is None, "nothing to be wrong")
        check(app.look("image", "a times, L minus b") is not None, "the law of the scene is there")


def test_note_on_units(display):
    """kg m is no N: the law is taken all the same."""
    with typed(display) as app:
        begin(app)
        replace(app, "c*L")
        app.find_text("taken in SI")
        replace(app, "a*L")
        wait(lambda: app.look("label", re.compile("taken in SI")) is None, "the note to go")


if __name__ == "__main__":
    main()
