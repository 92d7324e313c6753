"""Draws the table of `mortise tangents --study`: errors of numerical derivatives over the step size, as PNG.

Usage: study.py STUDY.csv OUT.png
"""

import csv
import sys

import matplotlib
from matplotlib.figure import Figure

from plots import COLOURS, STYLE

LINES = {"forward_differences": ("forward differences", "-"), "backward_differences": ("backward differences", "--"),
         "central_differences": ("central differences", "-"), "complex_step": ("complex step", "-"), "automatic": ("AD", ":")}
ROUND_OFF = 1e-17  # an error of zero is drawn here: below the unit round-off there is none other
SMALLEST_STEP = 1e-30


def main(table, picture):
    with open(table, encoding="utf-8", newline="") as stream:
        rows = [row for row in csv.DictReader(stream) if float(row["step"]) >= SMALLEST_STEP]
    with matplotlib.rc_context({**STYLE, "text.parse_math": True}):  # powers of ten
        figure = Figure(figsize=(6.4, 4.2), dpi=150, layout="constrained")
        axes = figure.add_subplot()
        for (name, (label, style)), colour in zip(LINES.items(), COLOURS):
            points = [(float(row["step"]), max(float(row[name]), ROUND_OFF)) for row in rows if row[name]]
            axes.loglog(*zip(*points), style, color=colour, label=label)
        axes.invert_xaxis()
        axes.set_xlabel("step h")
        axes.set_ylabel("relative error of f'(2), f = sin x + x^4")
        axes.legend(loc="upper right")
        figure.savefig(picture, metadata={"Software": None})


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
