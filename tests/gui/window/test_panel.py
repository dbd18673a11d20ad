#!/usr/bin/python3
"""The panel of properties: what it shows, and what is typed into it."""
import time

from harness import App, check, check_close, check_equal, main, mass, scene, spring, support, wait

RECORD = "time,push\n0,0\n1,2\n3,6\n"


def wait_a_double_click():
    """Until another click is no second one of the same."""
    time.sleep(0.6)


def select(app, x, y):
    app.show_width()
    app.click_world(x, y)


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


def test_undo_in_a_field_takes_back_what_was_set_there(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.enter("Properties", "Mass", "3")
        app.wait_read("Properties", "Mass", "3.00000 kg")
        app.press("ctrl+z")
        app.wait_read("Properties", "Mass", "1.00000 kg")
        app.press("ctrl+shift+z")
        app.wait_read("Properties", "Mass", "3.00000 kg")
        app.press("ctrl+a")
        app.type("7")
        app.wait_read("Properties", "Mass", "7")
        app.press("ctrl+z")  # what is being typed comes first
        app.wait_read("Properties", "Mass", "3.00000 kg")
        check_equal(app.blocks()["A"]["mass"], 3, "mass in the file")


def test_click_into_a_number_selects_it(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.bring_into_view(app.field("Properties", "Mass"))
        app.click(app.field("Properties", "Mass"))
        app.type("3")
        app.press("Return")
        app.wait_read("Properties", "Mass", "3.00000 kg")
        check_equal(app.blocks()["A"]["mass"], 3, "mass in the file")


def test_second_click_into_a_number_sets_the_cursor(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.bring_into_view(app.field("Properties", "Mass"))
        x, y, _, height = app.settled(app.field("Properties", "Mass"))
        for _ in range(2):
            app._click_at(x + 3, y + height / 2)
            wait_a_double_click()
        app.type("4")
        app.press("Return")
        app.wait_read("Properties", "Mass", "41.00000 kg")


def test_offset_moves_the_mass(display):
    with App(display, scene(mass("A", 0, 1))) as app:
        select(app, 0.2, 1.2)
        app.enter("Offset (Local Coordinates)", "Y", "-1")
        app.wait_read("Global Position", "Y", "0.00000 m")
        block = app.blocks()["A"]
        check_close(block["position"][1], 0, 1e-12, "Y")


def test_change_while_paused_goes_on(display):
    with App(display, scene(support("Wall", 0, 3), mass("A", 0, 0), spring("S", "Wall", "A", rest_length=2))) as app:
        select(app, 0, 1.7)
        for _ in range(3):
            app.click("One Sample Forward")
        wait(lambda: app.time() == 0.03, "three steps")
        app.enter("Spring Properties", "K", "50")
        app.wait_read("Spring Properties", "K", "50.00000 N/m")
        check_equal(app.time(), 0.03, "time after a change of the stiffness")
        app.find_text("The change counts from t = 0.03 s on")
        app.click("Run From the Start")
        app.wait_read("Spring Properties", "Length", "2.97758 m")  # 2 + cos(sqrt(50) t)
        check_equal(app.time(), 0.03, "time after all of it was run anew")


def test_change_of_the_start_goes_back(display):
    with App(display, scene(mass("A", 0, 0))) as app:
        select(app, 0.2, 0.2)
        app.click("One Sample Forward")
        wait(lambda: app.time() > 0, "a step")
        app.enter("Initial Velocity", "Vx", "1")
        wait(lambda: app.time() == 0, "the start")
        app.wait_read("Initial Velocity", "Vx", "1.00000 m/s")


def weight(label):
    return int(label.call("org.a11y.atspi.Text", "GetDefaultAttributes")["weight"])


def test_groups_close_and_have_bold_titles(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        select(app, -1.8, 0.2)
        app.wait_read("Appearance", "Name", "A")
        check(weight(app.find("label", "Appearance")) >= 700, "the title of a group is bold")
        check(weight(app.find("label", "Name")) < 700, "the name of a property is not")

        app.click("Appearance", role="label")
        app.gone(None, "Name")
        app.wait_read("Global Position", "X", "-2.00000 m")
        app.click_world(2.2, 0.2)  # another mass: it stays closed
        app.wait_read("Global Position", "X", "2.00000 m")
        check(app.look(None, "Name") is None, "the group stays closed")

        app.click("Appearance", role="label")
        app.wait_read("Appearance", "Name", "B")


def test_outline_selects(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        app.show_width()
        app.click(app.find_starting("list item", "B, Mass"))
        app.wait_read("Appearance", "Name", "B")


def test_keys_of_the_outline(display):
    with App(display, scene(mass("A", -2, 0), mass("B", 2, 0))) as app:
        app.click(app.find_starting("list item", "A, Mass"))
        app.press("ctrl+c")
        app.press("Delete")
        check_equal(list(app.blocks()), ["B"], "blocks after Delete in the outline")
        app.press("ctrl+v")
        check_equal(len(app.blocks()), 2, "blocks with the copy")


def test_return_selects_what_was_searched_for_at_once(display):
    """Also before the outline shows what is found, which is a moment after the last key; and nothing where nothing is typed."""
    with App(display, scene(*(mass(f"M{i}", i, 0) for i in range(9)))) as app:
        entry = app.find(None, "Search Blocks")
        app.click(entry)
        app.press("Return")
        app.xdotool("type", "--delay", "1", "--args", "1", "m7", "key", "Return")
        app.wait_read("Appearance", "Name", "M7")


def pushed_ball(display):
    motor = {"type": "motor", "name": "F", "ends": ["A"]}
    return App(display, scene(mass("A", 0, 0), motor))


def choose_table(app, file, item="Table…"):
    app.choose_in("Force", "Type", item)
    app.open_dialog("Choose a Table", file)


def test_table_is_chosen(display):
    with pushed_ball(display) as app:
        record = app.home / "record.csv"
        record.write_text(RECORD)
        app.click(app.find_starting("list item", "F, Motor"))
        choose_table(app, record)
        app.find("label", "record.csv")
        app.find("label", "3")
        app.wait_read("Force", "Column", "1")
        check_equal(app.blocks()["F"]["waveform"], {"table": "record.csv"}, "waveform in the file")
        app.enter("Force", "Scale", "0.5")
        app.wait_read("Force", "Scale", "0.5")
        check_equal(app.blocks()["F"]["waveform"], {"table": "record.csv", "scale": 0.5}, "waveform in the file")
        app.click("Undo")
        app.click("Undo")
        app.gone("label", "record.csv")


def test_table_from_elsewhere_is_copied(display):
    with pushed_ball(display) as app:
        record = app.home / "elsewhere" / "record.csv"
        record.parent.mkdir()
        record.write_text("0,1\n1,one\n")
        scenes_folder = app.home / "scenes"
        scenes_folder.mkdir()
        app.click(app.find_starting("list item", "F, Motor"))
        app.press("ctrl+shift+s")
        app.save_dialog("Save Scene", scenes_folder / "pushed.tinker.json")
        wait(lambda: app.title() == "pushed.tinker.json", "the title")

        choose_table(app, record)  # which is none
        dialog = app.find("dialog", "The Table Was Not Taken")
        app.find_text("record.csv:2:3: ")
        app.click("Close", inside=dialog)
        app.gone("dialog")
        check_equal(sorted(file.name for file in scenes_folder.iterdir()), ["pushed.tinker.json"], "files")

        record.write_text(RECORD)
        choose_table(app, record)
        app.click("Cancel", inside=app.find("dialog", "Copy the Table?"))
        app.gone("dialog")
        check(not (scenes_folder / "record.csv").exists(), "there is no copy without a yes")
        choose_table(app, record)
        app.click("Copy", inside=app.find("dialog", "Copy the Table?"))
        app.find("label", "record.csv")
        check_equal((scenes_folder / "record.csv").read_text(), RECORD, "the copy")


def test_table_needs_a_saved_scene(display):
    with App(display) as app:
        app.place("Motor")
        app.choose_in("Force", "Type", "Table…")
        app.click("Save", inside=app.find("dialog", "Save the Scene First"))
        app.save_dialog("Save Scene", app.home / "pushed.tinker.json")
        wait(lambda: app.title() == "pushed.tinker.json", "the title")
        (app.home / "record.csv").write_text(RECORD)
        choose_table(app, app.home / "record.csv")
        app.find("label", "record.csv")


def test_zeros_behind_the_digits_are_left_out_and_stay_so(display):
    ball = {"type": "mass", "name": "Mass 0", "position": [3.2, 2.4]}
    with App(display, scene(ball)) as app:
        select(app, 3.2, 2.4)
        app.wait_read("Global Position", "X", "3.20000 m")
        app.click("Main Menu")
        app.choose("Canvas and Panels")
        app.click("Trim Decimals of Values", role="check menu item")
        app.wait_read("Global Position", "X", "3.2 m")
        app.enter("Properties", "Mass", "2.50")
        app.wait_read("Properties", "Mass", "2.5 kg")
        app.click("Start", role="tab")
        wait(lambda: app.find("text", "Thrown at speed").text() == "0 m/s", "the speed without zeros")
        home = app.home
    with App(display, scene(ball), home=home) as app:
        select(app, 3.2, 2.4)
        app.wait_read("Global Position", "X", "3.2 m")


if __name__ == "__main__":
    main()
