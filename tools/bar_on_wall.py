"""Runs the bar on a rigid wall (inputs/bar_on_wall) over schemes, ways of closing and step sizes, and prints the table of its README.

Usage: bar_on_wall.py OUT.csv      runs all cases, writes one row for each and prints them as Markdown

The exact bar touches from t = 0.5 to 1.16667 with the pressure 300, then flies back as it came.
"""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "release" / "mortise"
DECK = ROOT / "inputs" / "bar_on_wall" / "persistent.xml"

WAVE_STEP = 0.1 / 30  # [s] in which the wave crosses one element
TOUCH, LEAVE, PRESSURE, AREA, SIZE, SPEED = 0.5, 0.5 + 2 * 10 / 30, 300.0, 0.01, 0.1, 10.0
CASES = (
    ("newmark", "position", {"allow unstable": ("bool", "true")}),
    ("trapezoidal", "position", {}),
    ("backward euler", "position", {}),
    ("generalised alpha", "position", {"spectral radius": ("double", "0.8")}),
    ("generalised alpha", "persistent", {"spectral radius": ("double", "0.8")}),
    ("hht", "position", {"alpha": ("double", "0.1")}),
    ("midpoint", "position", {}),
    ("energy momentum", "position", {}),
    ("energy momentum", "modified", {}),
    ("energy momentum", "persistent", {}),
)


def deck(scheme, closing, parameters, step):
    tree = ElementTree.parse(DECK)

    def entry(path):
        here = tree.getroot()
        for name in path.split("/"):
            here = here.find(f"ParameterList[@name='{name}']")
        return here

    entry("time").find("Parameter[@name='scheme']").set("value", scheme)
    entry("time").find("Parameter[@name='step']").set("value", repr(step))
    for name, (kind, value) in parameters.items():
        ElementTree.SubElement(entry("time"), "Parameter", name=name, type=kind, value=value)
    entry("obstacles/wall").find("Parameter[@name='closing']").set("value", closing)
    tree.getroot().remove(entry("expected"))
    return ElementTree.tostring(tree.getroot(), encoding="unicode")


def history(text):
    """Rows of a run, or nothing if it did not reach its end."""
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "deck.xml").write_text(text, encoding="utf-8")
        done = subprocess.run([PROGRAM, "run", "deck.xml", "-o", "out", "--quiet"], cwd=folder, env=environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode == 4:
            return None
        if done.returncode != 0:
            sys.exit(f"bar_on_wall: a run ended with exit code {done.returncode}\n{done.stdout[-2000:]}")
        with open(folder / "out" / "history.csv", encoding="utf-8", newline="") as stream:
            return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(stream)]


def figures(rows, step):
    """Of the steps inside the exact contact: pressures against the exact one, and steps without contact."""
    inside = [row for row in rows if TOUCH + 2 * step < row["time"] < LEAVE - 2 * step]
    pressures = [row["contact_force_x.wall"] / AREA / PRESSURE for row in inside]
    means = [0.5 * (a + b) for a, b in zip(pressures, pressures[1:])]

    def rms(values):
        return math.sqrt(sum((value - 1) ** 2 for value in values) / len(values))

    energy = rows[0]["total_energy"]
    return {"greatest pressure": max(row["contact_force_x.wall"] for row in rows) / AREA / PRESSURE, "rms error": rms(pressures),
            "rms error of two-step means": rms(means), "openings": sum(row["active"] == 0 for row in inside), "steps inside": len(inside),
            "end energy": rows[-1]["total_energy"] / energy,
            "penetration / (v dt)": max(0.0, -min(row["gap.tip"] for row in rows)) / (SPEED * step)}


def main(file):
    names = None
    with open(file, "w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        for scheme, closing, parameters in CASES:
            for courant in (0.5, 1.0, 2.0):
                rows = history(deck(scheme, closing, parameters, courant * WAVE_STEP))
                found = figures(rows, courant * WAVE_STEP) if rows else {}
                if names is None:
                    names = list(found)
                    table.writerow(["scheme", "closing", "CFL", *names])
                    print("| scheme | closing | CFL | " + " | ".join(names) + " |\n|" + "---|" * (3 + len(names)))
                values = [f"{found[name]:.4g}" if found else "did not converge" for name in names]
                table.writerow([scheme, closing, courant, *values])
                print(f"| {scheme} | {closing} | {courant} | " + " | ".join(values) + " |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
