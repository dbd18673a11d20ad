#!/usr/bin/python3
"""Joints: where a pin goes, and what follows when a body that is joined is moved."""
import math
import re

from harness import App, check, check_close, check_equal, main, scene, spring, support, wait
from harness import colours


def bar(name, x, y, angle=0.0, length=1.0):
    return {"type": "bar", "name": name, "position": [x, y], "orientation": angle, "length": length}


def pin(name, *ends):
    return {"type": "pin", "name": name, "ends": list(ends)}


def at(block, x, y=0.0):
    return {"block": block, "at": [x, y]}


def end_of(app, name, along):
    """Where the place at `along` of a bar's axis is."""
    block = app.blocks()[name]
    angle = block.get("orientation", 0.0)
    x, y = block["position"]
    return x + along * math.cos(angle), y + along * math.sin(angle)


def check_meet(app, first, second, what):
    a, b = end_of(app, *first), end_of(app, *second)
    check(math.dist(a, b) < 1e-9, f"{what}: {a} and {b}")


def test_pin_dropped_on_two_bars_joins_them_there(display):
    with App(display, scene(bar("Lower", 0, 0), bar("Upper", 0.5, 0.5, math.pi / 2))) as app:
        app.drag_pixels(app.middle(app.palette_button("Pin")), app.at(2, 2), app.at(0.5, 0.02))
        lower, upper = app.blocks()["Pin 0"]["ends"]
        check_equal([lower["block"], upper["block"]], ["Lower", "Upper"], "what it joins")
        check_close(lower["at"][0], 0.5, 1e-12, "at the lower one's end")
        check_close(upper["at"][0], -0.5, 1e-12, "and at the upper one's")
        app.press("ctrl+z")
        check("Pin 0" not in app.blocks(), "one step for undo")


def test_pin_dropped_beside_ends_keeps_its_place(display):
    with App(display, scene(support("Wall", 0, 0), bar("Bar", 0, 0, length=3))) as app:
        app.drag_pixels(app.middle(app.palette_button("Pin")), app.at(2, 2), app.at(0.8, 0.0))
        wall, on_bar = app.blocks()["Pin 0"]["ends"]
        check_equal(wall["block"], "Wall", "the first end")
        check_close(wall["at"][0], 0.8, 1e-12, "on the wall")
        check_close(on_bar["at"][0], 0.8, 1e-12, "on the bar")


def test_bodies_follow_the_one_that_is_dragged(display):
    blocks = (support("Wall", -0.5, 0), bar("Crank", 0, 0), bar("Link", 1, 0),
              pin("A", at("Wall", 0), at("Crank", -0.5)), pin("B", at("Crank", 0.5), at("Link", -0.5)))
    with App(display, scene(*blocks)) as app:
        app.drag((0.2, 0), (-0.3, 0.5))
        check_meet(app, ("Crank", 0.5), ("Link", -0.5), "the pin between them")
        x, y = end_of(app, "Crank", -0.5)
        check(math.hypot(x + 0.5, y) < 1e-9, f"the crank left its pin: {x}, {y}")
        check(app.blocks()["Crank"]["orientation"] > 0.8, "it has turned")
        app.press("ctrl+z")
        check_equal(app.blocks()["Link"]["position"], [1, 0], "one step for undo")


def driven_slider_crank(drive_at):
    """A crank of 0.5 m that lies to the right, and a rod of 1.5 m to a piston on its line. The drive's circle covers what lies
    below it."""
    return scene(support("Bearing", 0, 0, width=0.3, height=0.2, solid=False), bar("Crank", 0.25, 0, length=0.5),
                 bar("Rod", 1.25, 0, length=1.5),
                 {"type": "box", "name": "Piston", "width": 0.3, "height": 0.3, "position": [2, 0]},
                 pin("A", "Bearing", at("Crank", -0.25)), pin("B", at("Crank", 0.25), at("Rod", -0.75)),
                 pin("C", at("Rod", 0.75), "Piston"), {"type": "slider", "name": "Guide", "ends": ["Bearing", "Piston"]},
                 {"type": "drive", "name": "Drive", "ends": [at("Crank", drive_at), "Bearing"], "speed": 5}, width=5)


def check_played(app, start, end):
    """Dragged from one place to another the crank points to where the hand is, and the piston is where the rod lets it."""
    app.drag(start, end)
    angle = math.atan2(end[1], end[0])
    blocks = app.blocks()
    pixel = 1 / (app.scale() * math.hypot(*start))  # what one is at the hand (rad); press and release are rounded to them
    check_close(blocks["Crank"].get("orientation", 0.0), angle, 1.5 * pixel, "the crank's angle")
    turned = blocks["Crank"].get("orientation", 0.0)
    check_close(blocks["Piston"]["position"][0], 0.5 * math.cos(turned) + math.sqrt(2.25 - 0.25 * math.sin(turned) ** 2),
                1e-6, "the piston")
    check_equal(blocks["Drive"]["ends"][1], "Bearing", "the drive stays where it is")
    app.press("ctrl+z")
    check_close(app.blocks()["Piston"]["position"][0], 2, 1e-12, "one step for undo")
    app.press("Escape")  # nothing is selected, so that no handle lies at the crank's end


def test_driven_crank_is_played_by_hand(display):
    """By its free end and by its pin, and where the circle of its drive lies over it."""
    for drive_at, starts in ((0, ((0.35, 0.0), (0.15, 0.0), (0.5, 0.0))), (-0.25, ((0.4, 0.0), (0.09, 0.0)))):
        with App(display, driven_slider_crank(drive_at)) as app:
            for start in starts:
                check_played(app, start, (0.7 * start[0], 0.7 * start[0]))


def test_click_on_a_pin_selects_it(display):
    """A pin has nothing else to be clicked at; a drag that begins there takes the body, see above."""
    with App(display, driven_slider_crank(-0.25)) as app:
        app.click_world(0.5, 0)
        app.wait_read("Connections", "End 1", "Crank")
        check_equal(app.read("Connections", "End 1 X"), "0.25000 m", "where on the crank")


def test_typed_angle_takes_the_others_along(display):
    blocks = (support("Wall", -0.5, 0), bar("Crank", 0, 0), pin("A", at("Wall", 0), at("Crank", -0.5)))
    with App(display, scene(*blocks)) as app:
        app.click_world(0, 0)
        app.enter("Properties", "Orientation", "90 deg")
        check_close(app.blocks()["Crank"]["orientation"], math.pi / 2, 1e-12, "the angle that was typed")
        check_close(app.blocks()["Crank"]["position"][0], -0.5, 1e-9, "the crank stands over its pin")


def test_typed_length_keeps_pins_at_the_ends(display):
    blocks = (support("Wall", -0.5, 0), bar("Crank", 0, 0), bar("Link", 1, 0),
              pin("A", at("Wall", 0), at("Crank", -0.5)), pin("B", at("Crank", 0.5), at("Link", -0.5)))
    with App(display, scene(*blocks)) as app:
        app.click_world(0.2, 0)
        app.enter("Size", "Length", "1.4 m")
        check_equal(app.blocks()["A"]["ends"][1], at("Crank", -0.7), "the pin at the wall")
        check_close(app.blocks()["Crank"]["position"][0], 0.2, 1e-9, "the crank begins at the wall")
        check_close(app.blocks()["Link"]["position"][0], 1.4, 1e-9, "the link was pushed on")
        app.press("ctrl+z")
        check_equal(app.blocks()["Link"]["position"], [1, 0], "one step for undo")


def test_turned_by_its_handle_it_snaps(display):
    with App(display, scene(bar("Bar", 0, 0))) as app:
        app.click_world(0, 0)
        handle = wait(lambda: app.middle_of_colour(colours.SELECTED, (-0.1, 0.1), (0.1, 0.6)), "the handle")
        app.drag(handle, (-1.0, 1.05))
        check_close(app.blocks()["Bar"]["orientation"], math.pi / 4, 1e-12, "45 degrees")


def test_pin_is_offered_where_ends_meet(display):
    with App(display, scene(bar("Base", 0, 0), bar("Arm", 2, 1))) as app:
        app.drag((2, 1), (1.0, 0))
        app.find_text("Arm and Base meet there.")
        app.click("Add Pin")
        check_equal(app.blocks()["Pin 0"]["ends"], [at("Base", 0.5), at("Arm", -0.5)], "what it joins")


def test_pin_for_one_bar_and_a_support_for_it(display):
    """A pendulum in three clicks: the pin goes to an end of the bar, and the notice adds what it hangs on."""
    with App(display, scene(bar("Arm", 1, 1), {"type": "gravity", "name": "Gravity"}, duration=1)) as app:
        app.click_world(1.2, 1)
        app.place("Pin")
        app.click("Add a support there")
        app.find_starting("list item", "Support 0")
        blocks = app.blocks()
        check_equal(blocks["Pin 0"]["ends"], [at("Arm", -0.5), "Support 0"], "what the pin joins")
        check_equal(blocks["Support 0"]["position"], [0.5, 1], "where it hangs")
        app.click("Play")
        wait(lambda: app.time() == 1, "the run")


def test_selected_crank_is_played_by_its_end(display):
    """The handle there would make a bar longer that no joint is on."""
    with App(display, driven_slider_crank(0)) as app:
        app.click_world(0.2, 0)
        wait(lambda: app.read("Appearance", "Name") == "Crank", "the crank to be selected")
        app.drag((0.5, 0), (0.35, 0.35))
        crank = app.blocks()["Crank"]
        check_equal(crank["length"], 0.5, "its length")
        check_close(crank["orientation"], math.pi / 4, 0.02, "its angle")


def test_ladder_leans_at_floor_and_wall(display):
    """Its ends go where they are dragged, and it is offered to be solid; then it stands."""
    blocks = (support("Floor", 1, -0.2, width=6, static_friction=0.8, dynamic_friction=0.8),
              support("Wall", -1.2, 1.8, orientation="-90 deg", width=4), {"type": "gravity", "name": "Gravity"},
              bar("Ladder", 1, 2, length=2))
    with App(display, scene(*blocks, duration=1)) as app:
        app.click_world(1, 2)
        app.drag((2, 2), (0.42, 0.03))
        app.find_text("Ladder is not solid, and passes through Floor.")
        app.drag((0, 2), (-0.97, 2.8))
        app.click("Make It Solid")
        ladder = app.blocks()["Ladder"]
        check_equal(ladder["solid"], True, "solid")
        check_close(ladder["length"], math.hypot(1.4, 2.8), 0.05, "its length")
        app.click("Play")
        wait(lambda: app.time() == 1 and not app.is_playing(), "the run")
        height = re.search(r"at \(\S+ m, (\S+) m\)", app.outline_item("Ladder").name)
        check_close(float(height.group(1)), 1.4, 0.03, "the height at which it stands (m)")


def test_pin_for_a_spring_is_on_nothing(display):
    """No pin can be on one: it does not go onto the bar beneath with its other end alone."""
    with App(display, scene(bar("Bar", 0, 0), spring("Link", (-2, 0), (2, 0)))) as app:
        app.click(app.find_starting("list item", "Link, Spring"))
        app.place("Pin")
        first, second = app.blocks()["Pin 0"]["ends"]
        check_equal(first, second, "where both its ends lie")


if __name__ == "__main__":
    main()
