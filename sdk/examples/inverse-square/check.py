"""Attraction against the Pleiades and Kepler's ellipse. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest


def tinker(scene, *options):
    command = [os.environ["TINKER"], "run", "-", "--plugins", os.environ["PLUGINS"], *options]
    return subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    done = tinker(scene, "--columns", columns, "--csv", "-",
                  *(text for key, value in options.items() for text in ("--" + key, value)))
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def body(name, mass, position, velocity):
    return {"type": "mass", "name": name, "mass": mass, "position": position, "velocity": velocity}


class Pleiades(unittest.TestCase):
    # x, y, vx, vy of the seven at t = 3: Test Set for IVP Solvers, problem PLEI
    PUBLISHED = [
        0.3706139143970502, 3.237284092057233, -3.222559032418324, 0.6597091455775310, 0.3425581707156584,
        1.562172101400631, -0.7003092922212495, -3.943437585517392, -3.271380973972550, 5.225081843456543,
        -2.590612434977470, 1.198213693392275, -0.2429682344935824, 1.091449240428980, 3.417003806314313,
        1.354584501625501, -2.590065597810775, 2.025053734714242, -1.155815100160448, -0.8072988170223021,
        0.5952396354208710, -3.741244961234010, 0.3773459685750630, 0.9386858869551074, 0.3667922227200571,
        -0.3474046353808490, 2.344915448180937, -1.947020434263292]

    def test_end(self):
        with open("inverse-square.tinker.json", encoding="utf-8") as file:
            scene = json.load(file)
        names = [f"Star {i}.{of}" for of in ("x", "y", "vx", "vy") for i in range(1, 8)]
        end = run(scene, ",".join(names), at="3", tolerance="1e-13")[3.0]
        for name, published in zip(names, self.PUBLISHED):
            self.assertAlmostEqual(end[name], published, delta=1e-10, msg=name)


class Kepler(unittest.TestCase):
    def test_ellipse(self):
        """Two bodies with G (m + M) = 1 on ellipses of e = 0.6 about their common centre, by Kepler's equation."""
        e, m, other = 0.6, 0.25, 0.75
        speed = math.sqrt((1 + e) / (1 - e))
        scene = {"tinker": 1, "run": {"duration": 20, "interval": 0.5, "tolerance": 1e-13}, "blocks": [
            {"type": "inverse-square", "name": "Attraction", "constant": 1},
            body("A", m, [(1 - e) * other, 0], [0, speed * other]),
            body("B", other, [-(1 - e) * m, 0], [0, -speed * m])]}
        record = run(scene, "A.x,A.y,B.x,B.y,Attraction.energy")
        for t, row in record.items():
            anomaly = t
            for _ in range(60):
                anomaly -= (anomaly - e * math.sin(anomaly) - t) / (1 - e * math.cos(anomaly))
            x, y = math.cos(anomaly) - e, math.sqrt(1 - e * e) * math.sin(anomaly)
            self.assertAlmostEqual(row["A.x"], other * x, delta=1e-9)
            self.assertAlmostEqual(row["A.y"], other * y, delta=1e-9)
            self.assertAlmostEqual(row["B.x"], -m * x, delta=1e-9)
            self.assertAlmostEqual(row["B.y"], -m * y, delta=1e-9)
            self.assertAlmostEqual(row["Attraction.energy"], -m * other / math.hypot(x, y), delta=1e-9)

    def test_same_place(self):
        done = tinker({"tinker": 1, "blocks": [{"type": "inverse-square"}, body("A", 1, [0, 0], [0, 0]),
                                               body("B", 1, [0, 0], [0, 0])]})
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("two bodies are in the same place", done.stderr)


if __name__ == "__main__":
    unittest.main()
