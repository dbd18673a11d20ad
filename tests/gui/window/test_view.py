#!/usr/bin/python3
"""Looking around on the canvas, and what is shown beside the blocks."""
from harness import App, check, check_close, check_equal, main, mass, scene, wait
from harness import colours


def changed(app, before):
    return wait(lambda: (view := app.view()) != before and view, "another view")


def test_first_view_is_as_wide_as_the_scene_says(display):
    for width in (4, 10, 25):
        with App(display, scene(width=width)) as app:
            across, _, x, y = app.view()
            check_close(across, width, 1e-9, "m from left to right")
            check_equal((x, y), (0, 0), "middle")


def test_keys_zoom_about_the_middle(display):
    with App(display, scene(mass("A", 1, 1))) as app:
        before = app.show_width()
        app.click_world(3, 3)
        app.press("ctrl+plus")
        after = changed(app, before)
        check_close(after[0], before[0] / 1.25, 1e-4, "m from left to right")
        check_close(after[2], before[2], 1e-5, "x of the middle")
        app.press("ctrl+minus")
        check_close(changed(app, after)[0], before[0], 1e-4, "m from left to right")


def test_control_and_wheel_zoom_about_the_pointer(display):
    with App(display, scene(mass("A", 1, 1))) as app:
        before = app.show_width()
        place = app.at(2, 1)
        app.xdotool("mousemove", *place, "keydown", "ctrl", "click", 4, "keyup", "ctrl")
        after = changed(app, before)
        check(after[0] < before[0], "it shows less")
        for now, then in zip(app.at(2, 1), place):
            check_close(now, then, 1.5, "the place under the pointer")


def test_wheel_pans(display):
    with App(display, scene(mass("A", 1, 1))) as app:
        before = app.show_width()
        app.xdotool("mousemove", *app.at(0, 0), "click", 5)
        after = changed(app, before)
        check(after[3] < before[3] and after[2] == before[2], "down")
        app.xdotool("keydown", "shift", "click", 5, "keyup", "shift")
        check(changed(app, after)[2] > after[2], "to the right")


def test_middle_button_pans(display):
    with App(display, scene(mass("A", 1, 1))) as app:
        before = app.show_width()
        start, way = app.at(0, 0), app.at(2, 1)
        app.drag_pixels(start, way, button=2)
        changed(app, before)
        wait(lambda: max(abs(a - b) for a, b in zip(app.at(0, 0), way)) < 1.5, "the origin under the pointer")


def test_fit_shows_everything(display):
    with App(display, scene(mass("A", 100, 50), mass("B", -100, -50))) as app:
        app.show_width()
        before = app.view()
        app.press("ctrl+0")
        across, down, x, y = changed(app, before)
        check(across > 200 and down > 100, f"it shows {across} m by {down} m")
        check_close(x, 0, 5, "x of the middle")
        app.reachable(100.4, 50.4), app.reachable(-100.4, -50.4)  # not under the bar either, nor far from it:
        check(down < 250 and across < 300, f"it shows {across} m by {down} m")


def test_window_keeps_its_middle_when_sized(display):
    with App(display, scene(mass("A", 1, 1))) as app:
        before = app.show_width()
        window, (_, _, width, height) = app.windows()[0]
        app.xdotool("windowsize", window, width - 200, height - 100)
        after = changed(app, before)
        check_close(after[2], before[2], 1e-2, "x of the middle")
        check_close(app.canvas_box()[2] / after[0], 789 / 10, 1, "pixels per m")


def toggles(display, item, place0, place1, content):
    with App(display, content) as app:
        app.show_width()
        area = app.area(*place0, *place1)
        before = app.picture().cut(area)
        app.click("Main Menu")
        app.click(item, role="check menu item")
        wait(lambda: app.picture().cut(area) != before, f"“{item}” to change the picture")
        app.click("Main Menu")
        app.click(item, role="check menu item")
        wait(lambda: app.picture().cut(area) == before, f"“{item}” to change it back")


def test_labels_on_and_off(display):
    toggles(display, "Show Labels", (-1, -1.2), (1, 1.2), scene(mass("Ball", 0, 0)))


def test_grid_on_and_off(display):
    toggles(display, "Show Grid", (-3, -2), (-1, 2), scene(mass("Ball", 0, 0)))


def test_dark_theme(display):
    with App(display, scene(mass("Ball", 0, 0)), environment={"ADW_DEBUG_COLOR_SCHEME": "prefer-dark"}) as app:
        app.show_width()
        app.wait_fill((0x33, 0x49, 0x5f), (-0.4, -0.4), (0.4, 0.4), least=500)
        check_equal(app.fill_count(colours.BACKGROUND, (-3, -2), (-1, 2)), 0, "white pixels of the background")


def test_twice_as_many_pixels(display):
    with App(display, scene(mass("Ball", 0, 0)), environment={"GDK_SCALE": "2"}) as app:
        app.show_width()
        app.drag((0.2, 0.2), (1.2, 0.2))
        check_equal(app.blocks()["Ball"]["position"], [1, 0], "place")
        app.wait_fill(colours.BODY, (0.6, -0.4), (1.4, 0.4), least=300)


if __name__ == "__main__":
    main()
