#!/usr/bin/python3
"""New blocks: by click and by drag from the palette, and where their ends go."""
from harness import App, check, check_close, check_equal, main, mass, scene, support, wait
from harness import colours


def ends(app, name):
    return app.blocks()[name]["ends"]


def test_click_places_where_there_is_room(display):
    with App(display, scene()) as app:
        app.place("Mass")
        app.place("Mass")
        first, second = (app.blocks()[name]["position"] for name in ("Mass 0", "Mass 1"))
        check(max(abs(a - b) for a, b in zip(first, second)) >= 0.8, f"Mass 0 at {first}, Mass 1 at {second} overlap")


def test_new_blocks_are_as_large_as_the_scene_wants(display):
    """On a table of 1 m a support is 0.4 m wide, on a bridge of 200 m 80 m; in both all is in view. A pivot goes with it."""
    for width, factor in ((1, 0.1), (200, 20)):
        with App(display, scene(width=width, grid=width / 50)) as app:
            for title in ("Support", "Mass", "Disc", "Plate"):
                app.place(title)
            blocks = app.blocks()
            check_close(blocks["Support 0"]["width"], 4 * factor, 1e-9 * factor, "width of a support (m)")
            check_close(blocks["Mass 0"]["height"], 0.8 * factor, 1e-9 * factor, "height of a mass (m)")
            check_close(blocks["Disc 0"]["radius"], 0.4 * factor, 1e-9 * factor, "radius of a disc (m)")
            first = float(blocks["Plate 0"]["corners"].split()[0]) if isinstance(blocks["Plate 0"]["corners"], str) \
                else blocks["Plate 0"]["corners"][0][0]
            check_close(first, -0.5 * factor, 1e-9 * factor, "first corner of a plate (m)")
            across, down, x, y = app.view()
            for name, block in blocks.items():
                place = block["position"]
                check(abs(place[0] - x) < across / 2 and abs(place[1] - y) < down / 2, f"{name} at {place} is in view")
            app.place("Spring")
            app.click("Add a support there")
            pivot = app.blocks()["Support 1"]
            check_close(pivot["height"], 0.4 * factor, 1e-9 * factor, "height of a pivot (m)")


def test_tooltip_says_the_law(display):
    with App(display, scene()) as app:
        for title, law in (("Spring", "T = k (L − L0)"), ("Mass", "m a = ΣF"), ("Rod", "L − l = 0")):
            told = app.palette_button(title).description
            check(law in told.split("\n"), f"{law} is in {told!r}")


def test_names_count_up(display):
    with App(display, scene()) as app:
        for name in ("Mass", "Mass", "Support", "Spring", "Damper", "Rod", "Motor"):
            app.place(name)
        check_equal(list(app.blocks()), ["Mass 0", "Mass 1", "Support 0", "Spring 0", "Damper 0", "Rod 0", "Motor 0"],
                    "names")


def test_drag_shows_block_on_its_way(display):
    with App(display, scene()) as app:
        start, target = app.middle(app.palette_button("Mass")), app.at(1.03, 1.98)
        app.drag_pixels(start, app.at(-2, 0), release=False)
        app.wait_fill(colours.BODY, (-2.4, -0.4), (-1.6, 0.4), least=500)
        app.xdotool("mousemove", *target)
        app.wait_fill(colours.BODY, (-2.4, -0.4), (-1.6, 0.4), most=0)
        app.wait_fill(colours.BODY, (0.6, 1.6), (1.4, 2.4), least=500)
        app.release()
        check_equal(app.blocks()["Mass 0"]["position"], [1, 2], "snapped place")


def test_drag_back_places_nothing(display):
    with App(display, scene()) as app:
        start = app.middle(app.palette_button("Mass"))
        app.drag_pixels(start, app.at(0, 0), release=False)
        app.wait_fill(colours.BODY, (-0.4, -0.4), (0.4, 0.4), least=500)
        app.xdotool("mousemove", *app.middle(app.palette_button("Support")))
        app.wait_fill(colours.BODY, (-0.4, -0.4), (0.4, 0.4), most=0)
        app.release()
        check_equal(app.blocks(), {}, "blocks")
        check(not app.is_enabled("undo"), "there is nothing to undo")


def test_palette_comes_back_to_what_was_dropped_last(display):
    """Also where it was dragged, and not where a drag came to nothing: Return places the same once more."""
    with App(display, scene()) as app:
        app.place("Spring")
        app.drag_pixels(app.middle(app.palette_button("Disc")), app.at(-2, 0), app.at(2, 1))
        app.drag_pixels(app.middle(app.palette_button("Box")), app.at(0, 0), app.middle(app.palette_button("Bar")))
        app.activate("place")
        wait(lambda: any(node.has("focused") and node.name == "Disc" for node in app.tree.refresh()), "the focus on it")
        app.press("Return")
        wait(lambda: "Disc 1" in app.blocks(), "another one")


def test_drag_is_one_step_for_undo(display):
    with App(display, scene()) as app:
        app.drag_pixels(app.middle(app.palette_button("Mass")), app.at(0, 0), app.at(1, 1), app.at(2, 2))
        check_equal(app.blocks()["Mass 0"]["position"], [2, 2], "place")
        app.press("ctrl+z")
        check_equal(app.blocks(), {}, "after undo")
        app.press("ctrl+y")
        check_equal(app.blocks()["Mass 0"]["position"], [2, 2], "after redo")


def test_connector_dropped_between_bodies_is_connected(display):
    with App(display, scene(mass("A", 0, 0), mass("B", 3, 0))) as app:
        app.drag_pixels(app.middle(app.palette_button("Spring")), app.at(1, 1), app.at(0.8, 0.0))
        place = ends(app, "Spring 0")
        check_equal(place[0], "A", "the end that lies on A")


def test_click_with_two_selected_connects_them(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0))) as app:
        app.click_world(1, 3)
        app.click_world(0, 0, keys=["shift"])
        app.place("Spring")
        check_equal(ends(app, "Spring 0"), ["Wall", "Ball"], "ends")


def test_rope_goes_over_all_that_is_selected(display):
    with App(display, scene(support("Wheel", 0, 3), mass("Load", -1, 0), mass("Weight", 1, 0))) as app:
        app.click_world(-1, 0)
        app.click_world(0, 3, keys=["shift"])
        app.click_world(1, 0, keys=["shift"])
        app.place("Rope")
        check_equal(ends(app, "Rope 0"), ["Load", "Wheel", "Weight"], "ends")
        app.press("ctrl+z")
        check("Rope 0" not in app.blocks(), "the rope is taken back")
        app.press("ctrl+y")
        check_equal(ends(app, "Rope 0"), ["Load", "Wheel", "Weight"], "ends after redo")


def test_click_with_one_selected_leaves_an_end_free(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        app.click_world(0, 0)
        app.place("Rod")
        first, second = ends(app, "Rod 0")
        check_equal(first, "Ball", "first end")
        check(isinstance(second, list), f"the second end is free: {second}")


def test_placing_goes_back_to_the_start(display):
    with App(display, scene(mass("Ball", 0, 0)), home=display.patient_home()) as app:
        app.click("One Sample Forward")
        wait(lambda: app.time() > 0, "a step")
        app.place("Mass")
        wait(lambda: app.time() == 0, "the start")
        app.find_text("Back at the start")
        check_close(app.blocks()["Ball"]["position"][1], 0, 0, "the ball as it was edited")


def shown_of(app, *names):
    return [name for name in names if app.look("button", name)]


def test_a_spring_to_run_into_is_found(display):
    """By what it does, not by its name: words of its tooltip find it, Return places what is first."""
    with App(display, scene(mass("Block", 0, 0))) as app:
        entry = app.find(None, "Find a Block")
        for words in ("spring", "buffer", "run into"):
            app.retype(entry, words)
            wait(lambda: shown_of(app, "Bumper", "Disc", "Gear") == ["Bumper"], f"what is found by “{words}”")
        app.press("Return")
        app.find_starting("list item", "Bumper 0")
        wait(lambda: shown_of(app, "Bumper", "Disc") == ["Bumper", "Disc"], "all of them again")
        app.retype(entry, "flywheel clock")
        app.find("label", "No block has all of these words")
        app.press("Escape")
        app.gone("label", "No block has all of these words")


def test_return_places_what_was_typed_at_once(display):
    """Also before the list shows what is found, which is a moment after the last key; and nothing where nothing is typed."""
    with App(display, scene(mass("Block", 0, 0))) as app:
        entry = app.find(None, "Find a Block")
        app.retype(entry, "spring")
        wait(lambda: shown_of(app, "Bumper", "Disc", "Gear") == ["Bumper"], "what is found by “spring”")
        app.xdotool("key", "ctrl+a", "type", "--delay", "1", "--args", "1", "gravity", "key", "Return")
        app.find_starting("list item", "Gravity 0")
        check_equal(sorted(app.blocks()), ["Block", "Gravity 0"], "blocks")
        app.click(entry)
        app.press("Return")
        check_equal(sorted(app.blocks()), ["Block", "Gravity 0"], "blocks after Return in the empty entry")


if __name__ == "__main__":
    main()
