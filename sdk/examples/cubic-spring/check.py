"""The cubic spring against Duffing's oscillator and a published chain. Run by `meson test`."""
import csv
import io
import json
import math
import os
import subprocess
import unittest


def run(scene, columns, **options):
    """The rows of the record, as {time: {column: value}}."""
    command = [os.environ["TINKER"], "run", "-", "--plugins", os.environ["PLUGINS"], "--columns", columns, "--csv", "-"]
    command += [text for key, value in options.items() for text in ("--" + key, value)]
    done = subprocess.run(command, input=json.dumps(scene), capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    rows = csv.DictReader(io.StringIO(done.stdout))
    table = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in rows]
    return {row["time"]: row for row in table}


def cn(u, m):
    """Jacobi's elliptic function by descending Landen transformation (Abramowitz and Stegun, 16.4)."""
    a, b, c = [1.0], [math.sqrt(1.0 - m)], [math.sqrt(m)]
    while c[-1] > 1e-9:  # the next would be its square
        c.append((a[-1] - b[-1]) / 2)
        a, b = a + [(a[-1] + b[-1]) / 2], b + [math.sqrt(a[-1] * b[-1])]
    phi = 2 ** (len(a) - 1) * a[-1] * u
    for n in range(len(a) - 1, 0, -1):
        phi = (phi + math.asin(c[n] / a[n] * math.sin(phi))) / 2
    return math.cos(phi)


class Duffing(unittest.TestCase):
    def test_hardening(self):
        """m x'' = -k x - c x^3 from x = A at rest: x = A cn(W t, p), W^2 = (k + c A^2) / m, p = c A^2 / (2 (k + c A^2))."""
        with open("cubic-spring.tinker.json", encoding="utf-8") as file:
            scene = json.load(file)
        m, k, c, amplitude = 2.0, 5.0, 40.0, 0.6
        rate, p = math.sqrt((k + c * amplitude**2) / m), c * amplitude**2 / (2 * (k + c * amplitude**2))
        record = run(scene, "Mass.x,Spring.tension,Spring.energy,Spring.extension", tolerance="1e-12")
        self.assertEqual(len(record), 201)
        for t, row in record.items():
            x = amplitude * cn(rate * t, p)
            self.assertAlmostEqual(row["Mass.x"], 2 + x, delta=1e-9)
            self.assertAlmostEqual(row["Spring.extension"], x, delta=1e-9)
            self.assertAlmostEqual(row["Spring.tension"], k * x + c * x**3, delta=1e-7)
            self.assertAlmostEqual(row["Spring.energy"], k * x**2 / 2 + c * x**4 / 4, delta=1e-8)

    def test_linear(self):
        """Without the cube it is a spring, which the host steps exactly."""
        blocks = [{"type": "support", "name": "Wall", "solid": False},
                  {"type": "mass", "name": "Mass", "mass": 2, "position": [1.5, 0]},
                  {"type": "cubic-spring", "ends": ["Wall", "Mass"], "stiffness": 8, "cubic": 0, "rest_length": 1}]
        record = run({"tinker": 1, "run": {"duration": 100, "interval": 1}, "blocks": blocks}, "Mass.x", method="exact")
        for t, row in record.items():
            self.assertAlmostEqual(row["Mass.x"], 1 + 0.5 * math.cos(2 * t), delta=1e-12)


class StiffChain(unittest.TestCase):
    """Fermi, Pasta, Ulam as in Hairer, Lubich, Wanner, Geometric Numerical Integration, I.5.1: six unit masses, soft
    springs with the potential d^4 and stiff ones with omega^2 d^2 / 4 in turns."""

    # omega = 50: q and p at the times, by two high-precision integrations of different order that agree to 5e-21
    STATES = {
        1: ([5.1767820806882268094e-01, 5.3980860868328140544e-01, 3.8798827493728355889e-01, 3.8928064565270697814e-01,
             2.8547178339228209432e-03, 2.7624122992310114656e-03],
            [-1.5972474095060851122e+00, 7.4444303375163419357e-02, 5.7539580449479700400e-01, 5.5695000251938921199e-01,
             2.0227074819717517869e-02, 1.9695407923922264254e-02]),
        10: ([7.5633242161029198993e-01, 7.1735962155453710255e-01, 1.7269547871400404864e-01,
              1.7185724917012528968e-01, -7.5487532339260068285e-02, -7.4928841530288950349e-02],
             [7.1675705176588929232e-01, 5.5224985487144857289e-01, -5.9404130428571174851e-01,
              -2.7629054224827140612e-01, -9.2812075950010848061e-02, -8.9207147311143919213e-02]),
        50: ([-1.7569813712621199974e-01, -1.4724666720252465831e-01, -2.7805653193579215720e-02,
              -2.5016002370452350505e-02, -8.4234307023929014062e-01, -8.5268834266593892093e-01],
             [-1.0688009349880720537e-01, 3.5185304077132009278e-01, 6.2550748556764498053e-01,
              -5.7840486594339247951e-01, 1.7210374272380922380e-01, 6.5357483756990245331e-02]),
        200: ([3.8414412904511791181e-02, 4.1977721045518391404e-02, 5.5626518477580556556e-01,
               5.7215446876498210340e-01, 1.6918306393710106069e-01, 1.5541628710608735055e-01],
              [-6.1200692399145117171e-02, -1.5712687304602405074e-01, 2.6076399403312828509e-01,
               3.4943378263454109103e-01, -1.7377216549837272802e+00, -4.4753452326865332499e-02]),
    }
    COLUMNS = ",".join(f"M{i}.x,M{i}.vx" for i in range(1, 7))

    def scene(self, w=50.0):
        q = [(1 - 1 / w) / math.sqrt(2), (1 + 1 / w) / math.sqrt(2), 0, 0, 0, 0]
        blocks = [{"type": "support", "name": "M0", "solid": False, "position": [0, 0]},
                  {"type": "support", "name": "M7", "solid": False, "position": [7, 0]}]
        for i in range(1, 7):
            blocks.append({"type": "mass", "name": f"M{i}", "mass": 1, "position": [i + q[i - 1], 0],
                           "velocity": [math.sqrt(2) if i == 2 else 0, 0]})
        for i in range(7):
            stiff = i % 2 == 1
            blocks.append({"type": "cubic-spring", "name": f"S{i}", "ends": [f"M{i}", f"M{i + 1}"], "rest_length": 1,
                           "stiffness": w * w / 2 if stiff else 0, "cubic": 0 if stiff else 4})
        return {"tinker": 1, "run": {"duration": 200, "tolerance": 1e-13}, "blocks": blocks}

    def states(self, row):
        return [row[f"M{i}.x"] - i for i in range(1, 7)], [row[f"M{i}.vx"] for i in range(1, 7)]

    def test_states(self):
        record = run(self.scene(), self.COLUMNS, at=",".join(str(t) for t in self.STATES))
        for t, (q, p) in self.STATES.items():
            for mine, truth in zip(sum(self.states(record[t]), []), q + p):
                self.assertAlmostEqual(mine, truth, delta=1e-8 if t < 200 else 1e-7, msg=f"t = {t}")

    def oscillatory_energies(self, omega):
        """The energies of the three stiff springs and what swings on them, over time."""
        step = str(0.25 / omega)
        for row in run(self.scene(omega), self.COLUMNS, method="verlet6", step=step, duration="100", interval="0.1").values():
            q, p = self.states(row)
            yield [((p[i + 1] - p[i]) ** 2 + (omega * (q[i + 1] - q[i])) ** 2) / 4 for i in (0, 2, 4)]

    def test_adiabatic_invariant(self):
        """They change places, but their sum stays near its start: within O(1 / omega), so twice as near for twice omega."""
        off, least = [], []
        for omega in (50.0, 100.0):
            energies = list(self.oscillatory_energies(omega))
            off.append(max(abs(sum(each) - 1.0) for each in energies))
            least.append(min(each[0] for each in energies))
            self.assertLess(off[-1], 4 / omega)
        self.assertLess(least[0], 0.15)
        self.assertAlmostEqual(off[1] / off[0], 0.5, delta=0.1)


if __name__ == "__main__":
    unittest.main()
