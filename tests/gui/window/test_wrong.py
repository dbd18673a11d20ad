#!/usr/bin/python3
"""Wrong entries, in every kind of field: each stays, is marked, says why, changes nothing, and is taken back by Escape."""
import re

from harness import App, check, check_equal, main, mass, scene, spring, support, wait
from harness.scenes import connector

WRONG_NUMBERS = ("", "abc", "1 2", "1 s", "1e999", "nan", "5 parsecs")  # tests/units has more


def select(app, x, y):
    app.show_width()
    app.click_world(x, y)


def is_red(app, field):
    """Whether red is in what is written and in what lies behind."""
    x, y, width, height = app.box(field)
    pixels = list(app.picture().pixels((x + 4, y + 4, x + width - 4, y + height - 4)))
    return sum(red > green + 8 and red > blue + 8 for red, green, blue in pixels) > 0.7 * len(pixels)


def wrong_entries(app, group, title, entries):
    """Each stays as it was typed, is marked, says why, and changes nothing; Escape takes it back."""
    shown = app.read(group, title)
    before = app.saved()
    for entry in entries:
        app.enter(group, title, entry)
        word = wait(lambda: app.look("alert", re.compile("...")), f"a word on {entry!r} in {title}")
        check(len(word.name) > 10, f"what is wrong with {entry!r} in {title}: {word.name!r}")
        field = app.field(group, title)
        check_equal(field.text(), entry, f"what stays in {title}")
        check_equal(field.description, word.name, f"what is read with {title}")
        wait(lambda: is_red(app, field), f"{title} to be marked")
        check(not app.is_enabled("undo"), f"{entry!r} in {title} changed the scene")
        app.xdotool("key", "Escape")
        wait(lambda: app.look("alert") is None, f"the word on {entry!r} to go")
        app.wait_read(group, title, shown)
    check_equal(app.saved(), before, f"the scene after all that was typed into {title}")


def test_wrong_numbers(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        wrong_entries(app, "Properties", "Mass", (*WRONG_NUMBERS, "0", "-1 kg"))
        wrong_entries(app, "Global Position", "X", ("abc", "1 kg", "1e400"))
        wrong_entries(app, "Properties", "Orientation", ("north", "1 m"))
        wrong_entries(app, "Size", "Width", ("-1",))


def test_escape_after_saving(display):
    """Saving by key takes over what is typed; where that is wrong, the field keeps the keys."""
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.enter("Properties", "Mass", "heavy")
        wait(lambda: app.look("alert", re.compile("...")), "a word on it")
        app.saved()
        check_equal(app.read("Properties", "Mass"), "heavy", "what stays in the field")
        app.xdotool("key", "Escape")
        app.wait_read("Properties", "Mass", "1.00000 kg")
        wait(lambda: app.look("alert") is None, "the word on it to go")


def test_wrong_names(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        select(app, -1.8, 0.2)
        wrong_entries(app, "Appearance", "Name", ("", "B"))


def test_wrong_ends(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 1), spring("S", "Wall", "A"))) as app:
        select(app, 0, 2)
        wrong_entries(app, "Connections", "End 1", ("Wal", "S", "nobody"))


def test_wrong_expression(display):
    motor = connector("motor", "M", "A", waveform={"expression": "sin(t)"})
    with App(display, scene(mass("A", 0, 0), motor)) as app:
        select(app, 0.2, 0.2)
        app.press("Tab")
        app.field("Force", "Expression")
        wrong_entries(app, "Force", "Expression", ("sin(", "foo(t)", "x", ""))


def test_wrong_settings_of_the_scene(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, -3, -1)
        wrong_entries(app, "Canvas", "Width", ("0", "-1", "wide", "1 s"))
        wrong_entries(app, "Canvas", "Grid", ("-1", "1 kg"))
        wrong_entries(app, "Run", "Duration", ("-1 s", "1 m", "long"))
        wrong_entries(app, "Run", "Stop When", ("{A.y}", "{A.q} = 1", "event(impct)", "y = 0", "event(slip, B)", "= 1"))
        app.click("Computation", role="label")
        wrong_entries(app, "Computation", "Interval", ("0", "-1"))


def test_wrong_start(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 1), spring("S", "Wall", "A"))) as app:
        select(app, 0, 2)
        app.click("Start", role="tab")
        for entry in ("", "abc", "1 kg", "9 m"):
            field = app.find("text", re.compile("^Stretched by"))
            app.retype(field, entry)
            app.xdotool("key", "Return")
            wait(lambda: is_red(app, field), f"{entry!r} to be marked")
            check_equal(field.text(), entry, "what stays")
            check(not app.is_enabled("undo"), f"{entry!r} changed the scene")
            app.xdotool("key", "Escape")
            wait(lambda: not is_red(app, field) and field.text().startswith("0.00000"), f"{entry!r} to be taken back")


def test_wrong_error_that_is_wished(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 1), spring("S", "Wall", "A"))) as app:
        app.click("Accuracy", role="tab")
        field, measure = (lambda: app.find("text", re.compile("rror"))), (lambda: app.find("button", "Measure"))
        for entry in ("", "abc", "0", "-1e-6", "1", "1 m", "nan"):
            app.retype(field(), entry)
            wait(lambda: is_red(app, field()), f"{entry!r} to be marked")
            check(not measure().has("sensitive"), f"it can be measured with {entry!r}")
            check_equal(field().text(), entry, "what stays")
        app.retype(field(), "1e-6")
        wait(lambda: measure().has("sensitive") and not is_red(app, field()), "a good entry to be taken")


if __name__ == "__main__":
    main()
