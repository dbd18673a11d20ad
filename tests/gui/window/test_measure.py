#!/usr/bin/python3
"""Ruler and protractor on the canvas: a triangle of 3, 4 and 5 m, whose angles are known."""
import os

from harness import App, check, check_equal, colours, main, mass, scene, support, wait


def triangle():
    """The right angle is at A; B is 3 m to its right, C 4 m above it."""
    return scene(mass("A", -1.5, -2), mass("B", 1.5, -2), support("C", -1.5, 2, solid=False), width=10)


def reads(app, text):
    return wait(lambda: app.look(None, text) is not None, f"“{text}” to be read")


def keep(app, name):
    folder = os.environ.get("TINKER_PICTURES")
    if folder:
        app.picture().write_png(f"{folder}/{name}.png")


def test_ruler_snaps_and_is_kept(display):
    with App(display, triangle()) as app:
        app.show_width()
        app.press("ctrl+r")
        app.find(None, "Ruler")
        name = -1.8, 2.15, -1.2, 2.9  # of C, above it
        plain = app.still_picture(*name)
        app.drag((1.45, -2.03), (-1.46, 2.04))  # nearly from B to C
        app.xdotool("mousemove", *app.at(0.8, 1))
        reads(app, "5.000 m, Δx = -3.000 m, Δy = 4.000 m, 126.87°")
        wait(lambda: app.picture().cut(app.area(*name)) == plain, "the name of C, which nothing covers")
        line = app.area(-0.05, -0.05, 0.05, 0.05)  # its middle, where the distance stands
        check(colours.SELECTED not in set(app.picture().pixels(line)), "the distance is on the middle of the line")
        keep(app, "ruler")
        check_equal([block["type"] for block in app.saved()["blocks"]], ["mass", "mass", "support"], "blocks before")
        app.click("Keep as Dimension")
        wait(lambda: app.saved()["blocks"][-1]["type"] == "dimension", "the block")
        check_equal(app.saved()["blocks"][-1]["ends"], ["B", "C"], "its ends")
        app.gone("button", "Keep as Dimension")


def test_ruler_off_bodies_says_why_it_is_not_kept(display):
    with App(display, triangle()) as app:
        app.show_width()
        app.press("ctrl+r")
        app.find(None, "Ruler")
        button = app.find("button", "Keep as Dimension")
        check_equal(button.description, "Nothing is measured yet", "before anything is measured")
        app.drag((1.45, -2.03), (3, 2))
        wait(lambda: "second end is not on a body" in button.refreshed().description, "the reason")
        app.drag((3, 2), (1.45, -2.03))
        wait(lambda: "first end is not on a body" in button.refreshed().description, "the reason of the other way")


def test_protractor_by_drag_and_click(display):
    with App(display, triangle()) as app:
        app.show_width()
        app.click("Main Menu")
        app.choose("Measure", "Protractor")
        app.drag((1.5, -2), (-1.5, -2))  # from B, where the angle is, to A
        app.click_world(-1.5, 2)
        reads(app, "-53.13°")
        keep(app, "protractor")
        app.click("Keep as Angle Mark")
        wait(lambda: app.saved()["blocks"][-1]["type"] == "angle-mark", "the block")
        check_equal(app.saved()["blocks"][-1]["ends"], ["A", "B", "C"], "its ends, the corner in the middle")


def test_keys_measure_too_and_nothing_is_left(display):
    with App(display, triangle()) as app:
        app.show_width()
        app.xdotool("mousemove", *app.at(0.7, 1.3))  # which is not where the keys go
        app.press("ctrl+r")
        app.find(None, "Ruler")
        for key in ("Tab", "Return", "Tab", "Return"):
            app.press(key)
        reads(app, "3.000 m, Δx = 3.000 m, Δy = 0.000 m, 0.00°")
        app.press("Escape")
        app.gone("button", "Keep as Dimension")
        check(not app.is_enabled("undo"), "nothing to be undone")


def test_buttons_are_inside_of_a_small_window(display):
    """At 800 by 500 pixels, the least there may be: the hint is no column of letters, and both buttons can be pressed."""
    with App(display, triangle()) as app:
        widest = max(app.windows(), key=lambda window: window[1][2])  # others are tips
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: max(size[2] for _, size in app.windows()) == 800, "the window to be small")
        wait(lambda: app.canvas_box()[2] < 450, "the canvas to be small: symbols of blocks, canvas, and the panel")
        app.press("ctrl+shift+r")
        put_away = app.find("button", "Put Away")
        left, top, width, height = app.canvas_box()
        for button in (app.find("button", "Keep as Angle Mark"), put_away):
            x, y, across, down = app.settled(button)
            check(left <= x and x + across <= left + width and y + down <= top + height / 2, f"{button!r} is over the canvas")
        app.click(put_away)
        app.gone("button", "Put Away")


if __name__ == "__main__":
    main()
