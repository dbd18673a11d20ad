#!/usr/bin/python3
"""Ends of connectors: taken, carried over bodies, put down; and the refusal to run where one is loose."""
from harness import App, check, check_equal, main, mass, scene, spring, support, wait
from harness import colours
from harness.scenes import connector


def loose(kind="spring"):
    return scene(support("Wall", 0, 3), mass("Ball", 0, 0), connector(kind, "Link", "Wall", (3, 1)))


def highlight(app):
    return app.fill_count(colours.halo(colours.HIGHLIGHTED), (-0.6, -0.6), (0.6, 0.6))


def test_end_over_a_mass_highlights_it_and_release_connects(display):
    with App(display, loose()) as app:
        app.show_width()
        check_equal(highlight(app), 0, "pixels of the highlight before")
        app.drag((3, 1), (1.5, 1), (0.1, 0.1), release=False)
        wait(lambda: highlight(app) > 50, "the highlight")
        app.release()
        wait(lambda: highlight(app) == 0, "the highlight to go")
        check_equal(app.blocks()["Link"]["ends"], ["Wall", "Ball"], "ends")
        app.wait_lines(colours.COMPRESSED, (-0.15, -0.15), (0.15, 0.15), least=5)  # the red ×
        app.press("ctrl+z")
        check_equal(app.blocks()["Link"]["ends"], ["Wall", [3, 1]], "ends after undo")
        app.press("ctrl+y")
        check_equal(app.blocks()["Link"]["ends"], ["Wall", "Ball"], "ends after redo")


def test_end_that_leaves_connects_nothing(display):
    with App(display, loose()) as app:
        app.show_width()
        app.drag((3, 1), (0.1, 0.1), release=False)
        wait(lambda: highlight(app) > 50, "the highlight")
        app.xdotool("mousemove", *app.at(-2, -1))
        wait(lambda: highlight(app) == 0, "the highlight to go")
        app.release()
        check_equal(app.blocks()["Link"]["ends"], ["Wall", [-2, -1]], "ends")


def test_support_is_highlighted_too(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), spring("Link", (3, 1), "Ball"))) as app:
        app.show_width()
        app.drag((3, 1), (1, 3), release=False)
        app.wait_fill(colours.halo(colours.HIGHLIGHTED), (-2.2, 2.6), (2.2, 3.4), least=50)
        app.release()
        check_equal(app.blocks()["Link"]["ends"], ["Wall", "Ball"], "ends")


def test_end_beside_a_body_on_the_same_support_lies_along_its_top(display):
    """The mass lies on the floor, so its centre is 0.4 m above the top, which is 0.2 m above the middle of the floor."""
    with App(display, scene(support("Floor", 0, 0, height=0.4, width=6), mass("Block", 2, 0.6),
                            connector("bumper", "Buffer", (0, 2), "Block"))) as app:
        app.show_width()
        app.drag((0, 2), (-1, 1), (-2, 0))
        check_equal(app.blocks()["Buffer"]["ends"], [{"block": "Floor", "at": [-2, 0.6]}, "Block"], "ends")


def test_connected_end_is_pulled_off(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), spring("Link", "Wall", "Ball"))) as app:
        app.show_width()
        app.click_world(0, 1.7)
        app.drag((0, 0), (2, 1))
        blocks = app.blocks()
        check_equal(blocks["Link"]["ends"], ["Wall", [2, 1]], "ends")
        check_equal(blocks["Ball"]["position"], [0, 0], "the mass stays")


def test_press_in_the_middle_of_a_mass_takes_the_mass(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), spring("Link", "Wall", "Ball"))) as app:
        app.show_width()
        app.drag((0, 0), (2, 1))
        blocks = app.blocks()
        check_equal(blocks["Link"]["ends"], ["Wall", "Ball"], "ends")
        check_equal(blocks["Ball"]["position"], [2, 1], "place of the mass")


def refuses(display, kind):
    ends = [(3, 1)] if kind in ("motor",) else ["Wall", (3, 1)]
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), connector(kind, "Link", *ends))) as app:
        app.show_width()
        app.click_world(-3, -1)
        app.press("space")
        app.find_text("Link is not connected")
        check(app.look("button", "Pause") is None, "it does not run")
        app.click("Close", inside=app.find("dialog"))
        app.press("Delete")
        check_equal(sorted(app.blocks()), ["Ball", "Wall"], "the link was selected, so that Delete takes it away")


def test_run_with_a_loose_spring_is_refused(display):
    refuses(display, "spring")


def test_run_with_a_loose_rod_is_refused(display):
    refuses(display, "rod")


def test_run_with_a_loose_motor_is_refused(display):
    refuses(display, "motor")


if __name__ == "__main__":
    main()
