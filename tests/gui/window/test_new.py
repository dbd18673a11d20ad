#!/usr/bin/python3
"""New: the dialog about units and width; and what there is at a first start."""
import re

from harness import App, check, check_close, check_equal, main, mass, scene, wait


def test_new_asks_for_units_and_width(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        app.press("ctrl+n")
        dialog = app.find(None, "New Scene")
        width = app.find("text", "Maximum Canvas Width", inside=dialog)
        app.retype(width, "24 m")
        app.click("Create", inside=dialog)
        app.find("button", "Undo")
        wait(lambda: abs(app.view()[0] - 24) < 1e-3, "a view 24 m wide")
        app.find_starting("list item", "Gravity")


def test_new_after_graphs_and_instruments(display):
    """What stood on the canvas of the scene before is gone with it."""
    graph = {"block": "A", "quantity": "y", "place": [-4, 3], "size": [3, 2]}
    meter = {"block": "A", "quantity": "y", "kind": "number", "place": [2, 2]}
    with App(display, scene(mass("A", 0, 0), graphs=[graph, dict(graph, quantity="x", place=[0, 3])], meters=[meter])) as app:
        app.find(None, "Meter of A: Y Position")
        app.press("ctrl+n")
        app.click("Create", inside=app.find(None, "New Scene"))
        app.gone(None, "Meter of A: Y Position")
        app.gone(None, re.compile("^Graph of "))
        app.place("Mass")


def test_new_in_english_units(display):
    with App(display) as app:
        app.press("ctrl+n")
        dialog = app.find(None, "New Scene")
        app.choose_from(app.find("combo box", "Units", inside=dialog), "English (ft, slug, lbf)")
        app.retype(app.find("text", "Maximum Canvas Width", inside=dialog), "30 ft")
        app.click("Create", inside=dialog)
        wait(lambda: abs(app.view()[0] - 30 * 0.3048) < 1e-3, "a view 30 ft wide")
        app.place("Mass")
        app.wait_read("Properties", "Mass", "0.06852 slug")


def word(app, dialog):
    """What the dialog says is wrong."""
    return app.look("alert", re.compile("..."), inside=dialog)


def test_wrong_widths_are_refused(display):
    with App(display) as app:
        app.press("ctrl+n")
        dialog = app.find(None, "New Scene")
        for text in ("", "0", "-3 m", "abc", "5 kg", "1e999 m"):
            app.retype(app.find("text", "Maximum Canvas Width", inside=dialog), text)
            wait(lambda: word(app, dialog), f"a word on {text!r}")
            app.press("Return")
            app.click("Create", inside=dialog)
            check_equal(app.find("text", "Maximum Canvas Width", inside=dialog).text(), text, "what stays in the dialog")
        app.click("Cancel", inside=dialog)
        app.gone("text", "Maximum Canvas Width")


def test_cancel_keeps_the_scene(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        app.press("ctrl+n")
        app.click("Cancel", inside=app.find(None, "New Scene"))
        app.gone("text", "Maximum Canvas Width")
        check_equal(sorted(app.blocks()), ["A"], "blocks")


def test_first_start_offers_examples(display):
    with App(display) as app:
        x, y, width, height = app.settled(app.find("label", "Build Something That Moves"))
        heading = x, y, x + width, y + height
        before = app.picture().cut(heading)
        app.click("Double pendulum", inside=app.find(None, "First Steps"))
        wait(lambda: app.title() == "Double pendulum", "the example")
        wait(lambda: app.picture().cut(heading) != before, "the first steps to go")


if __name__ == "__main__":
    main()
