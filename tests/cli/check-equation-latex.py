#!/usr/bin/env python3
"""The LaTeX of all bundled scenes' equations: brackets that belong to each other stand in one line, and where a LaTeX is
installed every page compiles and no line runs off the paper by more than a point.

check-equation-latex.py TINKER SCENES, a program and the folder of the bundled scenes."""
import concurrent.futures
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

FORMS = ["newton", "matrix", "angles"]

# Letters of any script, and all that LaTeX takes for signs of its own.
LETTERS = {"tinker": 1, "title": "Größe 50% — Δx ≤ 3·µ_m: 中文 ~ ^ \\ {a} #1 & Привет ✓ −5 f₁²",
           "blocks": [{"type": "gravity", "name": "θ₀² → ∞"}, {"type": "support", "name": "Decke_$5", "position": [0, 4]},
                      {"type": "mass", "name": "中文 Łódź"}, {"type": "spring", "ends": ["Decke_$5", "中文 Łódź"]}]}


def unpaired(source):
    """Rows in which \\left and \\right do not come in pairs: LaTeX stops there."""
    lines = [line for block in re.findall(r"\\begin\{align\*\}\n(.*?)\\end\{align\*\}", source, re.S)
             for line in block.split(" \\\\\n")]
    return [line for line in lines if len(re.findall(r"\\left\b", line)) != len(re.findall(r"\\right\b", line))]


def compiled(folder, name):
    """What LaTeX says against it."""
    subprocess.run(["pdflatex", "-interaction=nonstopmode", name + ".tex"], cwd=folder, stdout=subprocess.DEVNULL,
                   stdin=subprocess.DEVNULL, timeout=60, check=False)
    with open(os.path.join(folder, name + ".log"), encoding="utf-8", errors="replace") as file:
        log = file.read()
    wide = [f"{points} pt too wide" for points in re.findall(r"Overfull \\hbox \(([\d.]+)pt too wide\)", log)
            if float(points) > 1]
    return re.findall(r"^! .*", log, re.M) + re.findall(r"^Missing character.*", log, re.M) + wide


def check(tinker, folder, scene, form):
    name = f"{os.path.basename(scene).split('.')[0]}-{form}"
    path = os.path.join(folder, name + ".tex")
    subprocess.run([tinker, "equations", scene, "--form", form, "--as", "latex", "-o", path], check=True)
    with open(path, encoding="utf-8") as file:
        faults = [f"unpaired brackets in {line}" for line in unpaired(file.read())]
    if shutil.which("pdflatex"):
        faults += compiled(folder, name)
    return [f"{name}: {fault}" for fault in faults]


def main():
    tinker, scenes = sys.argv[1], sorted(glob.glob(os.path.join(sys.argv[2], "*.tinker.json")))
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        letters = os.path.join(folder, "letters.tinker.json")
        with open(letters, "w", encoding="utf-8") as file:
            json.dump(LETTERS, file)
        scenes.append(letters)
        jobs = [(tinker, folder, scene, form) for scene in scenes for form in FORMS]
        faults = [fault for found in pool.map(lambda job: check(*job), jobs) for fault in found]
    seen = "compiled" if shutil.which("pdflatex") else "read (no pdflatex here)"
    print("\n".join(faults + [f"{len(jobs)} pages of {len(scenes)} scenes {seen}, {len(faults)} faults"]))
    return 1 if faults or len(scenes) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
