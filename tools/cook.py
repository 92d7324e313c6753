"""Runs Cook's membrane (inputs/cook) over elements and Poisson's ratios, and draws what was found.

Usage: cook.py reference OUT.json                     deflections of Q2P1 on refined meshes, and how far they have converged
       cook.py study OUT.csv                          deflections of every element
       cook.py table REFERENCE.json OUT.csv           the study with its errors as Markdown
       cook.py plot REFERENCE.json OUT.csv PICTURE    the same as a picture; needs python3-matplotlib
"""

import csv
import json
import pathlib
import sys

from decks import Deck

RATIOS = ("0.3", "0.49", "0.499", "0.4999", "0.5")
# Name -> element type, formulation, and one element of it on how many nodes' distances along a side.
ELEMENTS = {
    "hex8": ("hex8", "standard", 1),
    "hex8 f-bar": ("hex8", "f-bar", 1),
    "hex8 enhanced strain": ("hex8", "enhanced strain", 1),
    "hex8 mixed": ("hex8", "mixed", 1),
    "hex20": ("hex20", "standard", 2),
    "hex27": ("hex27", "standard", 2),
    "hex27 mixed": ("hex27", "mixed", 2),
    "tet10": ("tet10", "standard", 2),
}
SIDES = (8, 16, 32)  # nodes' distances along a side in the study
REFINED = "0.4999"   # the Poisson's ratio at which it takes all of them
REFERENCE_SIDES = (8, 16, 32)  # elements along a side of the reference


def deflection(element, formulation, ratio, n):
    """Displacement of the tip along y at the end of a run with n elements along each side of the panel."""
    deck = Deck("cook/f_bar")  # the others differ by what is put here
    deck.put("meshes/panel", "elements", "Array(int)", f"{{{n}, {n}, 1}}")
    deck.put("meshes/panel", "element type", "string", element)
    deck.put("bodies/panel", "formulation", "string", formulation)
    if ratio == "0.5":
        deck.put("materials/rubber", "model", "string", "neo-hookean incompressible")
        deck.drop("materials/rubber", "poissons ratio")
    else:
        deck.put("materials/rubber", "poissons ratio", "double", ratio)
    _, history, _ = deck.run()
    return history["displacement_y.tip"][-1]


def make_reference(file):
    values = {}
    for ratio in RATIOS:
        found = [deflection("hex27", "mixed", ratio, n) for n in REFERENCE_SIDES]
        values[ratio] = {"deflection": found[-1], "change": abs(found[-1] / found[-2] - 1), "deflections": found}
        print(f"nu = {ratio}: {found}, last change {values[ratio]['change']:.1e}", flush=True)
    record = {"what": "displacement along y of (48, 52), the middle of the sheared side, of inputs/cook, by hex27 with a linear pressure (Q2P1)",
              "command": "/usr/bin/python3 tools/cook.py reference inputs/cook/reference.json",
              "elements along each side": list(REFERENCE_SIDES), "by Poisson's ratio": values}
    pathlib.Path(file).write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")


def study(file):
    with open(file, "w", encoding="utf-8", newline="") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(["element", "poissons_ratio", "distances_per_side", "deflection"])
        for name, (element, formulation, distances) in ELEMENTS.items():
            for ratio in RATIOS:
                if ratio == "0.5" and formulation != "mixed":
                    continue  # only a pressure of its own holds the volume exactly
                for side in SIDES if ratio == REFINED else SIDES[-1:]:
                    table.writerow([name, ratio, side, f"{deflection(element, formulation, ratio, side // distances):.8f}"])
                    stream.flush()


def rows_of(reference, file):
    """Rows of the study, with the relative error of each."""
    exact = json.loads(pathlib.Path(reference).read_text(encoding="utf-8"))["by Poisson's ratio"]
    with open(file, encoding="utf-8", newline="") as stream:
        rows = [{"element": row["element"], "ratio": row["poissons_ratio"], "side": int(row["distances_per_side"]),
                 "deflection": float(row["deflection"])} for row in csv.DictReader(stream)]
    for row in rows:
        row["error"] = row["deflection"] / exact[row["ratio"]]["deflection"] - 1
    return rows


def print_table(reference, file):
    rows = {(row["element"], row["ratio"]): row for row in rows_of(reference, file) if row["side"] == SIDES[-1]}
    print("| Element | " + " | ".join(f"nu = {ratio}" for ratio in RATIOS) + " |\n|---|" + "---|" * len(RATIOS))
    for name in ELEMENTS:
        cells = [rows.get((name, ratio)) for ratio in RATIOS]
        words = [f"{cell['deflection']:.4f} ({100 * cell['error']:+.2f} %)" if cell else "-" for cell in cells]
        print(f"| {name} | " + " | ".join(words) + " |")


def plot(reference, file, picture):
    import matplotlib
    from matplotlib.figure import Figure

    from plots import COLOURS, STYLE
    rows = rows_of(reference, file)
    with matplotlib.rc_context({**STYLE, "text.parse_math": True}):  # powers of ten
        figure = Figure(figsize=(8.4, 4.4), dpi=150)
        left, right = figure.subplots(1, 2)
        for k, (name, (_, _, distances)) in enumerate(ELEMENTS.items()):
            # Those that find the same lie on each other: the first is the wider one.
            look = {"linewidth": 3 if name == "hex8 f-bar" else 1.5, "color": COLOURS[k], "label": name, "marker": "o" if distances == 1 else "s",
                    "linestyle": "-" if distances == 1 else "--"}
            refined = [row for row in rows if row["element"] == name and row["ratio"] == REFINED]
            left.plot([row["side"] for row in refined], [row["deflection"] for row in refined], **look)
            finest = [row for row in rows if row["element"] == name and row["side"] == SIDES[-1]]
            right.plot([RATIOS.index(row["ratio"]) for row in finest], [100 * abs(row["error"]) for row in finest], **look)
        left.set_xscale("log", base=2)
        left.set_xticks(SIDES, [str(side) for side in SIDES])
        left.set_xlabel("distances of nodes per side")
        left.set_ylabel(f"deflection, Poisson's ratio {REFINED}")
        right.set_yscale("log")
        right.axhline(1, color="#333333", linewidth=0.8)
        right.set_xticks(range(len(RATIOS)), RATIOS)
        right.set_xlabel("Poisson's ratio")
        right.set_ylabel(f"error of the deflection at {SIDES[-1]} distances per side [%]")
        figure.legend(*left.get_legend_handles_labels(), loc="upper center", ncol=4)
        figure.tight_layout(rect=(0, 0, 1, 0.88))
        figure.savefig(picture, metadata={"Software": None})


if __name__ == "__main__":
    commands = {"reference": (make_reference, 1), "study": (study, 1), "table": (print_table, 2), "plot": (plot, 3)}
    function, n_words = commands.get(sys.argv[1] if len(sys.argv) > 1 else "", (None, 0))
    if function is None or len(sys.argv) != 2 + n_words:
        sys.exit(__doc__)
    function(*sys.argv[2:])
