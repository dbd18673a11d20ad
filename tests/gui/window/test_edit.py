#!/usr/bin/python3
"""What is on the canvas: selecting, moving, deleting, copying, and taking all of it back."""
import math

from harness import App, check, check_close, check_equal, main, mass, scene, spring, support, wait
from harness import colours


def positions(app):
    return {name: tuple(block["position"]) for name, block in app.blocks().items() if "position" in block}


def two_masses():
    return scene(mass("A", -2, 0), mass("B", 2, 0))


def is_selected(app, x, y):
    return app.fill_count(colours.SELECTED, (x - 0.6, y - 0.6), (x + 0.6, y + 0.6)) > 100


def test_click_selects_and_empty_place_deselects(display):
    with App(display, two_masses()) as app:
        check(not app.is_enabled("delete"), "nothing is selected at first")
        app.click_world(-2, 0.2)
        wait(lambda: is_selected(app, -2, 0), "A to be marked")
        check(not is_selected(app, 2, 0), "B is not marked")
        check(app.is_enabled("delete"), "A can be deleted")
        app.click_world(0, 2)
        wait(lambda: not is_selected(app, -2, 0), "A not to be marked")
        check(not app.is_enabled("delete"), "nothing is selected")


def test_shift_and_control_click_add_and_take_away(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.click_world(2, 0.2, keys=["shift"])
        wait(lambda: is_selected(app, -2, 0) and is_selected(app, 2, 0), "both to be marked")
        app.click_world(-2, 0.2, keys=["ctrl"])
        wait(lambda: not is_selected(app, -2, 0) and is_selected(app, 2, 0), "B alone to be marked")


def test_drag_snaps_to_grid(display):
    with App(display, two_masses()) as app:
        app.drag((-2, 0.2), (-0.93, 1.28))
        check_equal(positions(app), {"A": (-1, 1), "B": (2, 0)}, "places")


def test_drag_with_alt_is_free(display):
    with App(display, two_masses()) as app:
        app.drag((-2, 0.2), (-0.93, 1.27), keys=["alt"])
        x, y = positions(app)["A"]
        pixel = 1 / app.scale()
        check_close(x, -0.93, 2 * pixel, "x")
        check_close(y, 1.07, 2 * pixel, "y")
        check(abs(x / 0.2 - round(x / 0.2)) > 0.1, f"x = {x} is on the grid")


def off_the_top(block, floor):
    """How far the side of a mass of height 0.8 is off the top of a support of height 0.4."""
    x, y = (a - b for a, b in zip(block["position"], floor["position"]))
    angle = floor["orientation"]
    return -math.sin(angle) * x + math.cos(angle) * y - 0.2 - 0.4


def test_mass_dropped_on_a_top_lies_on_it(display):
    incline = support("Floor", 0, -1, orientation=0.5, width=6)
    with App(display, scene(incline, mass("A", -2, 2))) as app:
        along, up = 1.0, 0.5  # a tenth of a metre too deep, and off by what the grid takes
        place = (along * math.cos(0.5) - up * math.sin(0.5), -1 + along * math.sin(0.5) + up * math.cos(0.5))
        app.drag((-2, 2), place)
        block = app.blocks()["A"]
        check_equal((block["on"], "position" in block, "orientation" in block), ("Floor", False, False), "A as it is saved")
        check_close(block["along"], along, 0.1, "place along the top")
        app.activate("undo")
        check_equal(positions(app)["A"], (-2, 2), "place")
        app.drag((-2, 2), place, keys=["alt"])
        blocks = app.blocks()
        check(abs(off_the_top(blocks["A"], blocks["Floor"])) > 0.05, "with Alt it stays where it was dropped")
        check("orientation" not in blocks["A"], "and is not turned")


def test_mass_on_a_top_is_kept_there_until_it_is_moved(display):
    lies = {"type": "mass", "name": "A", "on": "Floor", "along": 1}
    with App(display, scene(support("Floor", 0, -1, width=6), lies, mass("B", -2, 2))) as app:
        app.drag((0, -1), (1, 0))  # the support, and with it what lies on it
        block = app.blocks()["A"]
        check_equal((block.get("on"), block.get("along"), "position" in block), ("Floor", 1, False), "A")
        app.drag((2, 0.6), (3, 3))
        block = app.blocks()["A"]
        check_equal(("on" in block, "along" in block), (False, False), "A when it was moved")
        check_equal(tuple(round(x, 9) for x in block["position"]), (3, 3), "place")


def test_drop_is_as_near_as_it_looks(display):
    """11 px above a top is on it, 14 px are not, whatever a metre is on the screen."""
    for width in (4, 400):
        grid, half = width * 1e-4, width * 0.04
        block = {"type": "mass", "name": "A", "position": [0, 3 * half], "width": 2 * half, "height": 2 * half}
        floor = support("Floor", 0, -half, width=20 * half, height=2 * half)
        with App(display, scene(floor, block, width=width, grid=grid)) as app:
            app.show_width()
            pixel = 1 / app.scale()
            for pixels, lies in ((14, False), (11, True)):
                app.drag((half / 2, 3 * half), (half / 2, half + pixels * pixel))
                check_equal("on" in app.blocks()["A"], lies, f"whether it lies on the floor from {pixels} px above, {width} m wide")
                app.activate("undo")


def test_placed_on_a_top_goes_along(display):
    """By the button of the panel; the file says so."""
    with App(display, scene(support("Floor", 0, -1, width=6), mass("A", 1, 2))) as app:
        app.click_world(1.2, 2.2)
        app.click("Start", role="tab")
        app.click("Placed on Floor")
        block = app.blocks()["A"]
        check_equal((block["on"], block["along"], "position" in block), ("Floor", 1, False), "A")


def test_what_stays_when_its_support_turns_is_told_of(display):
    """A mass with a place of its own. Its notice lays it back; Ctrl+Z then takes that back, as the canvas has the focus."""
    with App(display, scene(support("Floor", 0, 0, width=6), mass("A", -1, 0.6))) as app:
        app.click_world(2, 0.1)
        app.enter("Properties", "Orientation", "20 deg")
        app.find("button", "A stayed where it was, and does not lie on Floor any more.")
        app.click("Place on Floor")
        wait(lambda: "on" in app.blocks()["A"], "A to be laid on the top")
        block = app.blocks()["A"]
        check_equal((block["on"], block["along"]), ("Floor", -1), "A on the turned top")
        app.press("ctrl+z")
        wait(lambda: app.blocks()["A"].get("position") == [-1, 0.6], "A to be back")
        app.click("Close Notice")
        app.press("ctrl+z")
        wait(lambda: "orientation" not in app.blocks()["Floor"], "the turn to be undone, too")


def test_friction_can_be_typed_in_either_order(display):
    """The static coefficient is never below the dynamic one: the one that was not typed follows, as one step for undo."""
    with App(display, scene(support("Floor", 0, 0))) as app:
        app.click_world(1, 0.1)
        for first, second in (("Static", "Dynamic"), ("Dynamic", "Static")):
            values = {"Static": "0.35", "Dynamic": "0.3"}
            for name in (first, second):
                app.enter("Friction", f"{name} coefficient", values[name])
            block = app.blocks()["Floor"]
            check_equal((block["static_friction"], block["dynamic_friction"]), (0.35, 0.3), f"{first} first")
            app.enter("Friction", "Dynamic coefficient", "0.9")
            app.wait_read("Friction", "Static coefficient", "0.90000")
            app.press("ctrl+z")
            app.wait_read("Friction", "Static coefficient", "0.35000")


def test_press_that_does_not_move_changes_nothing(display):
    with App(display, two_masses()) as app:
        x, y = app.at(-2, 0.2)
        app.xdotool("mousemove", x, y, "mousedown", 1, "mousemove", x + 2, y + 1, "mouseup", 1)
        app.saved()
        check(not app.is_enabled("undo"), "there is nothing to undo")


def test_drag_follows_pointer_and_escape_takes_it_back(display):
    with App(display, two_masses()) as app:
        app.drag((-2, 0.2), (-2, 2.2), release=False)
        app.wait_fill(colours.BODY, (-2.4, 1.6), (-1.6, 2.4), least=500)
        app.press("Escape")
        app.wait_fill(colours.BODY, (-2.4, 1.6), (-1.6, 2.4), most=0)
        app.release()
        check_equal(positions(app)["A"], (-2, 0), "place")
        check(not app.is_enabled("undo"), "there is nothing to undo")


def test_arrows_nudge_by_the_grid(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.press("Right", "Right", "Up", "Left", "Down", "Down")
        x, y = positions(app)["A"]
        check_close(x, -1.8, 1e-12, "x")
        check_close(y, -0.2, 1e-12, "y")


def test_arrows_with_alt_nudge_finely(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.press("alt+Right", "alt+Up")
        x, y = positions(app)["A"]
        check_close(x, -2 + 1 / app.scale(), 1e-5, "x")
        check_close(y, 1 / app.scale(), 1e-5, "y")


def test_arrows_without_selection_pan(display):
    with App(display, two_masses()) as app:
        app.click_world(0, 2)
        before = app.view()
        app.press("Right")
        wait(lambda: app.view()[2] > before[2], "the view to go to the right")
        check_equal(positions(app), {"A": (-2, 0), "B": (2, 0)}, "places")


def test_tab_goes_through_the_blocks(display):
    with App(display, two_masses()) as app:
        app.click_world(0, 2)
        app.press("Tab")
        wait(lambda: is_selected(app, -2, 0), "A to be marked")
        app.press("Tab")
        wait(lambda: is_selected(app, 2, 0), "B to be marked")
        app.press("shift+Tab")
        wait(lambda: is_selected(app, -2, 0), "A to be marked again")


def test_delete_and_undo(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.press("Delete")
        check_equal(list(app.blocks()), ["B"], "after Delete")
        app.press("ctrl+z")
        check_equal(positions(app), {"A": (-2, 0), "B": (2, 0)}, "after undo")
        app.press("ctrl+shift+z")
        check_equal(list(app.blocks()), ["B"], "after redo")


def test_deleting_a_mass_detaches_its_connectors(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 0), spring("S", "Wall", "A", stiffness=30))) as app:
        app.click_world(-0.3, -0.3)
        app.press("Delete")
        blocks = app.blocks()
        check_equal(sorted(blocks), ["S", "Wall"], "blocks")
        check_equal(blocks["S"]["ends"], ["Wall", [0, 0]], "ends of the spring")
        app.press("ctrl+z")
        check_equal(app.blocks()["S"]["ends"], ["Wall", "A"], "ends after undo")


def test_duplicate(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.press("ctrl+d")
        places = positions(app)
        check_equal(len(places), 3, "number of blocks")
        new = next(place for name, place in places.items() if name not in "AB")
        check(new != places["A"], "the copy lies beside what it was copied from")
        app.press("ctrl+z")
        check_equal(positions(app), {"A": (-2, 0), "B": (2, 0)}, "after undo")
        app.press("ctrl+y")
        check_equal(len(positions(app)), 3, "number of blocks after redo")


def test_order_of_drawing(display):
    """Two masses lie on each other; a click takes the one in front."""
    with App(display, scene(mass("A", 0, 0), mass("B", 0.2, 0))) as app:
        app.click_world(0.1, 0.1)
        app.press("shift+Next")
        check_equal(list(app.blocks()), ["B", "A"], "order after sending B to the back")
        app.press("Escape")
        app.click_world(0.1, 0.1)
        app.press("Delete")
        check_equal(list(app.blocks()), ["B"], "blocks after deleting what is in front")
        app.press("ctrl+z", "ctrl+z")
        check_equal(list(app.blocks()), ["A", "B"], "order after undo")
        app.click_world(-0.35, 0)
        app.press("shift+Prior")
        check_equal(list(app.blocks()), ["B", "A"], "order after bringing A to the front")


def test_copy_and_paste_keep_connections(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 0), spring("S", "Wall", "A", stiffness=30))) as app:
        app.click_world(1, 3)
        app.press("ctrl+a", "ctrl+c", "ctrl+v")
        blocks = wait(lambda: len(found := app.blocks()) == 6 and found, "six blocks")
        new = [block for name, block in blocks.items() if name not in ("Wall", "A", "S")]
        copy = next(block for block in new if block["type"] == "spring")
        check_equal(copy["stiffness"], 30, "stiffness of the copy")
        check_equal(sorted(copy["ends"]), sorted(block["name"] for block in new if block["type"] != "spring"),
                    "what the copy connects")
        app.press("ctrl+z")
        check_equal(list(app.blocks()), ["Wall", "A", "S"], "after undo")


def test_cut_and_paste(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.press("ctrl+x")
        check_equal(list(app.blocks()), ["B"], "after cut")
        app.click_world(0, 2)
        app.press("ctrl+v")
        wait(lambda: len(app.blocks()) == 2, "the pasted block")


def test_drag_undo_is_one_step(display):
    with App(display, two_masses()) as app:
        app.drag((-2, 0.2), (-1, 1.2), (0, 2.2), (1, 2.2))
        check_equal(positions(app)["A"], (1, 2), "place")
        app.press("ctrl+z")
        check_equal(positions(app)["A"], (-2, 0), "after undo")
        check(not app.is_enabled("undo"), "there is nothing more to undo")
        app.press("ctrl+y")
        check_equal(positions(app)["A"], (1, 2), "after redo")


def test_band_selects_and_group_drag_moves_all(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0), mass("C", 0, 3))) as app:
        app.show_width()
        app.drag((-3, -1), (3, 1))
        wait(lambda: is_selected(app, -2, 0) and is_selected(app, 2, 0), "A and B to be marked")
        check(not is_selected(app, 0, 3), "C is outside")
        app.drag((2.2, 0.2), (2.2, -1.03), (3.19, -1.83))
        check_equal(positions(app), {"A": (-1, -2), "B": (3, -2), "C": (0, 3)}, "places")
        app.press("ctrl+z")
        check_equal(positions(app), {"A": (-2, 0), "B": (2, 0), "C": (0, 3)}, "after undo")


def test_band_is_drawn(display):
    with App(display, scene(mass("A", 0, 3))) as app:
        app.show_width()
        app.drag((-3, -2), (3, 1), release=False)
        inside = colours.mixed(colours.SELECTED, 0.15)
        app.wait_fill(inside, (-3.1, -2.1), (3.1, 1.1), least=10000)
        app.release()
        app.wait_fill(inside, (-3.1, -2.1), (3.1, 1.1), most=0)


def test_menu_of_the_canvas(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2, button=3)
        app.find("menu item", "Delete")
        wait(lambda: is_selected(app, -2, 0), "A to be marked")
        app.press("Escape")


def test_note_is_moved_and_comes_back(display):
    note = {"type": "note", "name": "Note 0", "position": [2, 2], "text": "MMMM"}
    with App(display, scene(mass("A", -3, -2), note)) as app:
        app.show_width()
        app.drag((2, 2), (-1, 1))
        check_equal(app.saved()["blocks"][1]["position"], [-1, 1], "its place in the file")
    with App(display, app.file) as app:
        app.show_width()
        seen = app.still_picture(-2, 0.7, 0, 1.3), app.still_picture(1, 1.7, 3, 2.3)
        dark = [sum(1 for at in range(0, len(cut), 4) if max(cut[at:at + 3]) < 100) for cut in seen]
        check(dark[0] > 20 and dark[1] == 0, f"{dark} pixels of its text where it was put, and where it was")


def test_local_origin_is_dragged_without_the_body(display):
    with App(display, scene(mass("A", 0, 0, local_origin=[1, 1]), mass("B", 2, 0))) as app:
        app.click_world(0, 0.2)
        app.drag((1, 1), (-1.03, 1.42))
        block = app.blocks()["A"]
        check_equal(block["position"], [0, 0], "place")
        check_close(block["local_origin"][0], -1, 1e-9, "x of the origin")
        check_close(block["local_origin"][1], 1.4, 1e-9, "y of the origin")
        app.press("ctrl+z")
        check_equal(app.blocks()["A"]["local_origin"], [1, 1], "origin after undo")


def test_local_origin_waits_beyond_a_corner(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        app.click_world(0, 0.2)
        wait(lambda: is_selected(app, 0, 0), "A to be marked")
        handle = app.middle_of_colour(colours.SELECTED, (-0.8, -0.8), (-0.46, -0.46))
        app.drag(handle, (-1, -1))
        block = app.blocks()["A"]
        check_equal((block["position"], block["local_origin"]), ([0, 0], [-1, -1]), "place and origin")


def test_body_is_sized_by_its_corner(display):
    with App(display, two_masses()) as app:
        app.click_world(-2, 0.2)
        app.drag((-1.6, 0.4), (-1.42, 0.81))
        block = app.blocks()["A"]
        check_equal(block["position"], [-2, 0], "place")
        check_close(block["width"], 1.2, 1e-9, "width")
        check_close(block["height"], 1.6, 1e-9, "height")


def test_handles_are_of_the_start_alone(display):
    with App(display, scene(mass("A", 0, 3), {"type": "gravity", "name": "Gravity"}, duration=0.7)) as app:
        app.show_width()
        app.click_world(0.2, 3.2)
        origin, start = ((-0.8, 2.2), (-0.44, 2.56)), ((-0.3, 2.7), (0.3, 3.3))
        app.wait_lines(colours.SELECTED, *origin, least=10)
        app.click("Play")
        wait(lambda: app.time() == 0.7 and not app.is_playing(), "the end of the run")
        app.wait_lines(colours.SELECTED, *start, most=0)
        app.wait_lines(colours.SELECTED, *origin, most=0)
        app.click("Reset to the Start")
        app.wait_lines(colours.SELECTED, *origin, least=10)


def test_support_is_turned_by_its_handle(display):
    with App(display, scene(support("Plate", 0, 0))) as app:
        app.show_width()
        app.click_world(1, 0)
        handle = wait(lambda: app.middle_of_colour(colours.SELECTED, (-0.2, 0.3), (0.2, 1)), "the handle")
        app.drag(handle, (-1, 1))
        check_close(app.blocks()["Plate"]["orientation"], 0.785398163, 0.02, "orientation (rad)")


def test_width_of_a_bar_is_dragged(display):
    """On the grid, with Alt freely, down to none and up again; the length stays, and the middle still drags the whole."""
    bar = {"type": "bar", "name": "Bar", "position": [0, 0], "mass": 1, "length": 4, "width": 0.2}
    with App(display, scene(bar)) as app:
        app.show_width()
        app.click_world(-0.8, 0)
        app.drag((1, 0.1), (1, 0.39))
        check_equal([app.saved()["blocks"][0][key] for key in ("length", "width")], [4, 0.8], "length and width, on the grid")
        app.drag((1, 0.4), (1, 0.25), keys=("alt",))
        width = app.saved()["blocks"][0]["width"]
        check_close(width, 0.5, 2.5 / app.scale(), "width, freely")
        app.drag((1, 0.25), (1, 0), keys=("alt",))
        check_equal(app.saved()["blocks"][0]["width"], 0, "width near the middle, freely")
        app.drag((1, 0), (1, 0.39))
        check_equal(app.saved()["blocks"][0]["width"], 0.8, "width out of none")
        for _ in range(4):
            app.click("Undo")
        check_equal(app.saved()["blocks"][0]["width"], 0.2, "width after undo")
        app.drag((0, 0), (0.4, 0.6))
        moved = app.saved()["blocks"][0]
        check_equal(([round(at, 9) for at in moved["position"]], moved["width"]), ([0.4, 0.6], 0.2), "the whole, by its middle")


def test_corners_of_a_plate(display):
    square = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    plate = {"type": "plate", "name": "P", "position": [0, 0], "corners": square}
    with App(display, scene(plate)) as app:

        def corners():
            block = app.blocks()["P"]
            x, y = block["position"]
            around = block["corners"]
            turns = list(zip(around, around[1:] + around[:1]))
            area = sum(a[0] * b[1] - b[0] * a[1] for a, b in turns) / 2
            centre = [sum((a[k] + b[k]) * (a[0] * b[1] - b[0] * a[1]) for a, b in turns) / (6 * area) for k in (0, 1)]
            return [[round(x + a - centre[0], 6), round(y + b - centre[1], 6)] for a, b in around]

        app.click_world(0.5, 0.2)
        app.drag((1, 1), (2, 2))
        check_equal(corners(), [[-1, -1], [1, -1], [2, 2], [-1, 1]], "corners, one of them dragged")
        app.click_world(0, -1, button=3)
        app.choose("Add Corner Here")
        wait(lambda: len(corners()) == 5, "a corner more")
        x, y = corners()[1]
        check_close(x, 0, 0.05, "x of the new corner")
        check_close(y, -1, 0.05, "y of the new corner")
        app.click_world(2, 2, button=3)
        app.choose("Remove Corner")
        wait(lambda: len(corners()) == 4, "a corner less")
        check([2, 2] not in corners(), "the corner that was clicked is gone")
        for _ in range(3):
            app.activate("undo")
        wait(lambda: corners() == square, "the square again")


if __name__ == "__main__":
    main()
