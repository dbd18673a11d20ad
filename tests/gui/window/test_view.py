#!/usr/bin/python3
"""Looking around on the canvas, and what is shown beside the blocks."""
import collections
import re

from harness import App, check, check_close, check_equal, main, mass, scene, support, wait
from harness import colours, scenes

BODY_EDGE = (0x27, 0x49, 0x6d)


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
        scale = app.canvas_box()[2] / 10  # the scene says 10 m
        window, (_, _, width, height) = app.windows()[0]
        app.xdotool("windowsize", window, width - 200, height - 100)
        after = changed(app, before)
        check_close(after[2], before[2], 1e-2, "x of the middle")
        check_close(app.canvas_box()[2] / after[0], scale, 1, "pixels per m")


def toggles(display, item, place0, place1, content, within=()):
    """What a switch of the main menu, or of the menus `within` it, shows."""
    with App(display, content) as app:
        app.show_width()
        area = app.area(*place0, *place1)
        before = app.picture().cut(area)
        app.click("Main Menu")
        app.choose(*within)
        app.click(item, role="check menu item")
        wait(lambda: app.picture().cut(area) != before, f"“{item}” to change the picture")
        app.click("Main Menu")
        app.choose(*within)
        app.click(item, role="check menu item")
        wait(lambda: app.picture().cut(area) == before, f"“{item}” to change it back")


def test_labels_on_and_off(display):
    toggles(display, "Show Labels", (-1, -1.2), (1, 1.2), scene(mass("Ball", 0, 0)))


def test_grid_on_and_off(display):
    toggles(display, "Show Grid", (-3, -2), (-1, 2), scene(mass("Ball", 0, 0)), within=["Canvas and Panels"])


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


def test_whole_scene_is_seen_above_docked_graphs(display):
    """Also of a scene that takes the place of one whose canvas was higher, and once a graph is docked later."""
    tall = {"blocks": [mass("A", -1, 8), mass("B", 1, -8)], "duration": 1}
    graphs = [{"block": "A", "quantity": "y"}]

    def build(graphs):
        return scene(*tall["blocks"], duration=1, graphs=graphs)

    def is_seen(app):
        left, top, width, height = app.canvas_box()
        places = [app.at(x, y) for x, y in ((-1.4, 8.4), (1.4, -8.4))]
        return all(left <= x <= left + width and top <= y <= top + height for x, y in places)

    with App(display, build([])) as app:
        wait(lambda: is_seen(app), "all to be seen")
        height = app.canvas_box()[3]
        app.press("ctrl+o")
        app.open_dialog("Open Scene", scenes.write(app.home, "docked.tinker.json", build(graphs)))
        wait(lambda: app.canvas_box()[3] < height, "the graph to be docked")
        wait(lambda: is_seen(app), "all to be seen above it")
        app.click(re.compile("^Float"))
        wait(lambda: app.canvas_box()[3] == height, "it to float")
        app.press("ctrl+z")
        wait(lambda: app.canvas_box()[3] < height and is_seen(app), "all to be seen when it is docked again")


def test_all_is_reached_on_a_screen_that_is_too_small(display):
    """At twice the size a screen of 1280 by 800 has 640 by 400: what does not fit is scrolled to, by the focus as well."""
    ball = scene(mass("Ball", 0, 0, velocity=[1, 0]), duration=0.5, graphs=[{"block": "Ball", "quantity": "x"}])
    with App(display, ball, environment={"GDK_SCALE": "2"}) as app:
        window = max(app.windows(), key=lambda size: size[1][2])[0]
        app.xdotool("windowsize", window, 1280, 800)

        def size():
            return next(place[2:] for number, place in app.windows() if number == window)

        wait(lambda: size() == (1280, 800), "the window to be as small as the screen")

        def is_inside(node):
            x, y, width, height = app.settled(node)
            return 0 <= x and x + width <= 1280 and 0 <= y and y + height <= 800

        play = app.find("button", "Play")
        check(not is_inside(play), "there is no room for the play bar")
        for part in ("Play", "Main Menu"):
            node = app.find(None, part)
            for _ in range(80):
                if any(other.has("focused") and other.name == part for other in app.tree.refresh()):
                    break
                app.press("Tab")
            wait(lambda: is_inside(node), f"“{part}” to be seen")
            if part == "Play":
                app.click(play)
                wait(lambda: app.time() == 0.5 and not app.is_playing(), "the end of the run")


def field_arrow(app, x, y):
    """How long the arrow of gravity is that starts at a body's centre (px)."""
    left, top, right, bottom = app.area(x - 0.3, y - 4, x + 0.3, y)
    across = collections.Counter(
        place[1] for place in colours.places(app.picture(), (left, top, right, bottom), colours.FIELD))
    rows = [row for row, pixels in across.items() if pixels > 1]  # the line to its label is one wide
    return max(rows) - min(rows) + 1 if rows else 0


def show_forces(app):
    app.show_width()
    app.activate("show-forces")


def test_force_arrows_have_one_scale(display):
    """Ten times the mass is ten times the arrow, whatever is selected."""
    light, heavy = mass("Light", -3, 3, mass=1), mass("Heavy", 3, 3, mass=10)
    with App(display, scene(light, heavy, {"type": "gravity", "name": "Gravity"})) as app:
        show_forces(app)
        wait(lambda: field_arrow(app, 3, 3) > 40, "the arrow of the heavy one")
        together = field_arrow(app, 3, 3)
        app.click_world(2.8, 3.2)
        wait(lambda: field_arrow(app, -3, 3) == 0, "the arrows of the other to go")
        alone = field_arrow(app, 3, 3)
        check_close(alone, together, 2, "length of the arrow with the heavy one selected")
        app.click_world(-3.2, 3.2)
        wait(lambda: field_arrow(app, 3, 3) == 0 and field_arrow(app, -3, 3) > 0, "the arrow of the light one")
        check_close(field_arrow(app, -3, 3), alone / 10, 4, "length of the arrow of a tenth of the mass")
        app.press("bracketright", "bracketright")  # four times as long
        wait(lambda: field_arrow(app, -3, 3) > 0.3 * alone, "a longer arrow")
        check_close(field_arrow(app, -3, 3), 0.4 * alone, 4, "length of the arrow by a factor of 4")


def test_mark_at_the_edge_is_not_beneath_the_key(display):
    """A ball far below on the left, where the key of the forces stands."""
    with App(display, scene(mass("Ball", 0, 0), mass("Low", -400, -400), {"type": "gravity", "name": "Gravity"})) as app:
        app.show_width()
        left, top, width, height = app.canvas_box()
        corner = (left, top + height - 40, left + 40, top + height)
        wait(lambda: colours.fill_count(app.picture(), corner, BODY_EDGE) > 40, "a mark in the corner")
        before = colours.fill_count(app.picture(), corner, BODY_EDGE)
        show_forces(app)
        wait(lambda: field_arrow(app, 0, 0) > 20, "the arrow of gravity, and with it the key")
        check_equal(colours.fill_count(app.picture(), corner, BODY_EDGE), before, "pixels of the mark")


def test_forces_on_the_selected_body_only(display):
    floor, box = support("Floor", 0, 0), mass("Box", 0, 0.6)
    with App(display, scene(floor, box, {"type": "gravity", "name": "Gravity"})) as app:
        show_forces(app)
        above, below = ((-0.4, 0.9), (0.4, 2)), ((-0.4, -1.5), (0.4, -0.5))  # what pushes ends where it acts
        app.wait_lines(colours.NORMAL, *below, least=30)
        app.click_world(-0.2, 0.7)
        app.wait_lines(colours.NORMAL, *below, least=30)
        app.wait_lines(colours.NORMAL, *above, most=0)
        app.activate("forces-on-this-body-only")
        app.wait_lines(colours.NORMAL, *above, least=30)  # what it exerts on the floor


def test_body_that_leaves_the_view_has_a_mark(display):
    ball = mass("Ball", 0, 0, velocity=[20, 0])
    with App(display, scene(ball, duration=2)) as app:
        app.show_width()
        left, top, width, height = app.canvas_box()
        edge = (left + width - 16, top + height / 2 - 12, left + width - 2, top + height / 2 + 12)
        wait(lambda: colours.fill_count(app.picture(), edge, BODY_EDGE) == 0, "there is no mark while the ball is in view")
        app.click("Play")
        wait(lambda: app.time() == 2 and not app.is_playing(), "the end of the run, 40 m to the right")
        wait(lambda: colours.fill_count(app.picture(), edge, BODY_EDGE) > 40, "a mark at the right edge")
        app.click(app.find_starting("list item", "Ball, Mass"))
        app.activate("follow")  # out of view: it is brought into the middle
        wait(lambda: abs(app.view()[2] - 40) < 0.1, "the ball in the middle")
        wait(lambda: colours.fill_count(app.picture(), edge, BODY_EDGE) == 0, "the mark to go")
        entry = app.find("text", "Time")
        app.retype(entry, "1")
        app.press("Return")
        wait(lambda: abs(app.view()[2] - 20) < 0.1, "the view to go along with the ball")


if __name__ == "__main__":
    main()
