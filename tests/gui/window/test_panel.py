#!/usr/bin/python3
"""The panel of properties: what it shows, what is typed into it, and what becomes of wrong entries."""
import re

from harness import App, check, check_close, check_equal, main, mass, scene, spring, support, wait
from harness.scenes import connector

WRONG_NUMBERS = ("abc", "1 2", "1,5", "1 s", "--1", "1e999", "nan", "inf", "5 parsecs", "2 kg m", "0x10", "±1", "1/0")


def select(app, x, y):
    app.show_width()
    app.click_world(x, y)


def text_of(app, group, title):
    return wait(lambda: app.read(group, title), f"{title} of {group}")


def test_mass_shows_its_groups(display):
    ball = {"type": "mass", "name": "Mass 0", "position": [3.2, 2.4]}
    with App(display, scene(ball)) as app:
        select(app, 3.2, 2.4)
        for group, title, text in (
                ("Appearance", "Name", "Mass 0"), ("Global Position", "X", "3.20000 m"),
                ("Global Position", "Y", "2.40000 m"), ("Initial Velocity", "Vx", "0.00000 m/s"),
                ("Initial Velocity", "Vy", "0.00000 m/s"), ("Offset (Local Coordinates)", "X", "0.00000 m"),
                ("Offset (Local Coordinates)", "Y", "0.00000 m"), ("Properties", "Mass", "1.00000 kg"),
                ("Properties", "Orientation", "0.00000 deg"), ("Size", "Height", "0.80000 m"),
                ("Size", "Width", "0.80000 m")):
            app.wait_read(group, title, text)


def test_mass_in_english_units(display):
    ball = {"type": "mass", "name": "Mass 0", "position": [3.2, 2.4]}
    with App(display, {**scene(ball), "units": "English"}) as app:
        select(app, 3.2, 2.4)
        for group, title, text in (("Global Position", "X", "10.49869 ft"), ("Global Position", "Y", "7.87402 ft"),
                                   ("Properties", "Mass", "0.06852 slug"), ("Size", "Height", "2.62467 ft")):
            app.wait_read(group, title, text)
        check_close(app.blocks()["Mass 0"]["position"][0], 3.2, 1e-12, "X in the file, in m")


def test_units_are_switched_for_all(display):
    ball = {"type": "mass", "name": "Mass 0", "position": [3.2, 2.4]}
    with App(display, scene(ball)) as app:
        select(app, -3, -1)  # nothing: the scene itself
        app.field("Scene", "Units")
        app.choose_in("Scene", "Units", "English")
        app.click_world(3.2, 2.4)
        app.wait_read("Properties", "Mass", "0.06852 slug")
        check_equal(app.saved()["units"], "English", "units in the file")
        app.press("Escape")


def test_spring_shows_its_length_and_greys_it(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 1), spring("S", "Wall", "A"))) as app:
        select(app, 0, 2)
        app.wait_read("Spring Properties", "K", "25.00000 N/m")
        app.wait_read("Spring Properties", "Undeformed Length", "2.00000 m")
        app.wait_read("Spring Properties", "Length", "2.00000 m")
        check(not app.field("Spring Properties", "Length").has("sensitive"), "the length is greyed out")
        check(app.field("Spring Properties", "K").has("sensitive"), "the stiffness takes entries")


def test_typing_with_another_unit(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.enter("Size", "Width", "12 in")
        app.wait_read("Size", "Width", "0.30480 m")
        check_close(app.blocks()["A"]["width"], 0.3048, 1e-12, "width in the file")


def test_leaving_the_field_commits(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.enter("Properties", "Mass", "3", key="Tab")
        app.wait_read("Properties", "Mass", "3.00000 kg")
        check_equal(app.blocks()["A"]["mass"], 3, "mass in the file")


def test_entry_is_one_step_for_undo(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.enter("Properties", "Mass", "3")
        app.wait_read("Properties", "Mass", "3.00000 kg")
        app.click("Undo")
        app.wait_read("Properties", "Mass", "1.00000 kg")
        app.click("Redo")
        app.wait_read("Properties", "Mass", "3.00000 kg")


def test_offset_moves_the_mass(display):
    with App(display, scene(mass("A", 0, 1))) as app:
        select(app, 0.2, 1.2)
        app.enter("Offset (Local Coordinates)", "Y", "-1")
        app.wait_read("Global Position", "Y", "0.00000 m")
        block = app.blocks()["A"]
        check_close(block["position"][1], 0, 1e-12, "Y")


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
        wrong_entries(app, "Run", "Interval", ("0", "-1"))


def test_wrong_start(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 1), spring("S", "Wall", "A"))) as app:
        select(app, 0, 2)
        app.click("Start", role="tab")
        for entry in ("", "abc", "1 kg", "-9 m"):
            field = app.find("text", re.compile("^S stretched by"))
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


def test_change_while_paused_goes_on(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 0), spring("S", "Wall", "A", rest_length=2))) as app:
        select(app, 0, 1.7)
        for _ in range(3):
            app.click("One Sample Forward")
        wait(lambda: app.time() == 0.03, "three steps")
        app.enter("Spring Properties", "K", "50")
        app.wait_read("Spring Properties", "K", "50.00000 N/m")
        check_equal(app.time(), 0.03, "time after a change of the stiffness")


def test_change_of_the_start_goes_back(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.click("One Sample Forward")
        wait(lambda: app.time() > 0, "a step")
        app.enter("Initial Velocity", "Vx", "1")
        wait(lambda: app.time() == 0, "the start")
        app.wait_read("Initial Velocity", "Vx", "1.00000 m/s")


def test_outline_selects(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        app.show_width()
        app.click(app.find_starting("list item", "B, Mass"))
        app.wait_read("Appearance", "Name", "B")


if __name__ == "__main__":
    main()
