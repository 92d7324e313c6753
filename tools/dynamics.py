"""Runs the dynamic scenes over materials, schemes, tolerances and step sizes, and tells what each kept and what it took.

Usage: dynamics.py tumbling OUT.csv     inputs/tumbling_block: energy momentum for thousands of steps, other schemes beside it
       dynamics.py tolerances OUT.csv   the same scene by the tolerance of Newton's method
       dynamics.py cost OUT.csv         the same scene, gently tossed: time per step of each scheme, evaluations of statics and dynamics
       dynamics.py impact OUT.csv       inputs/bars_impact: schemes and step sizes
       dynamics.py wall OUT.csv         inputs/bar_on_wall: schemes, ways of closing and step sizes
       dynamics.py table FILE.csv       any of these as Markdown
"""

import csv
import math
import statistics
import sys

from decks import Deck

ENDS = (0, 4)  # exit codes that a study goes on from; 4: no step converged

SCHEMES = ("midpoint", "trapezoidal", "backward euler", "generalised alpha", "energy momentum", "energy momentum midpoint contact")
MATERIALS = ("neo_hookean", "saint_venant_kirchhoff", "mooney_rivlin", "ogden")
TOLERANCES = ("1e-1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10")
REPEATS = 7  # of what is timed, the schemes by turns


def greatest(values):
    return max(abs(v) for v in values)


def greatest_length(history, vector):
    return max(math.hypot(*components) for components in zip(*(history[f"{vector}_{axis}"] for axis in "xyz")))


def kept(history, free_from):
    """What a body that is left to itself at a time kept: energies relative to E0, the energy then."""
    begin = next(k for k, t in enumerate(history["time"]) if t >= free_from - 1e-9)
    E0 = history["total_energy"][begin]
    iterations = history["newton_iterations"][1:]
    return {"steps": len(iterations), "E0": f"{E0:.6g}",
            "greatest_energy": f"{max(history['total_energy'][begin:]) / E0:.4g}", "last_energy": f"{history['total_energy'][-1] / E0:.4g}",
            "algorithmic_dissipation": f"{greatest(history['algorithmic_dissipation']) / E0:.1e}",
            "ledger_mismatch": f"{greatest(history['ledger_mismatch']) / E0:.1e}",
            "linear_mismatch": f"{greatest(history['linear_momentum_mismatch']) / greatest_length(history, 'linear_momentum'):.1e}",
            "angular_mismatch": f"{greatest(history['angular_momentum_mismatch']) / greatest_length(history, 'angular_momentum'):.1e}",
            "newton_most": f"{max(iterations):.0f}", "newton_mean": f"{statistics.mean(iterations):.2f}"}


def end_of_loads(deck):
    return float(deck.get("loads/pull on the leg", "end"))


def tumbling():
    runs = [(name, "energy momentum", 10000 if name == "neo_hookean" else 1000) for name in MATERIALS]
    runs += [("large_steps", "energy momentum", 10000)]
    runs += [(name, scheme, 1000) for name in ("neo_hookean", "large_steps") for scheme in ("midpoint", "trapezoidal")]
    for name, scheme, steps in runs:
        deck = Deck(f"tumbling_block/{name}")
        deck.put("time", "scheme", "string", scheme)
        deck.set_steps(float(deck.get("time", "step")), steps)
        code, history, _ = deck.run(ENDS)
        yield {"deck": name, "scheme": scheme, **kept(history, end_of_loads(deck)), "ended": "as asked" if code == 0 else "no step converged"}
    for name in MATERIALS[1:]:  # the other laws at the great step
        deck, gentle = Deck(f"tumbling_block/{name}"), Deck("tumbling_block/large_steps")
        for path in ("loads/pull on the leg", "loads/pull on the foot"):
            for component in "xyz":
                deck.put(path, component, "string", gentle.get(path, component))
            deck.put(path, "end", "double", gentle.get(path, "end"))
        deck.put("initial conditions/block", "velocity", "Array(double)", gentle.get("initial conditions/block", "velocity"))
        deck.set_steps(float(gentle.get("time", "step")), 1000)
        code, history, _ = deck.run(ENDS)
        yield {"deck": f"large_steps of {name}", "scheme": "energy momentum", **kept(history, end_of_loads(deck)),
               "ended": "as asked" if code == 0 else "no step converged"}


def tolerances():
    for tolerance in TOLERANCES:
        deck = Deck("tumbling_block/neo_hookean")
        deck.put("solver", "tolerance", "double", tolerance)
        code, history, _ = deck.run(ENDS)
        found = kept(history, end_of_loads(deck))
        yield {"tolerance": tolerance, **found, "residual_work": f"{greatest(history['residual_work']) / float(found['E0']):.1e}"}


def gentle_block(scheme):
    """The block tossed with a tenth of the forces, which every scheme survives."""
    deck = Deck("tumbling_block/neo_hookean")
    for path in ("loads/pull on the leg", "loads/pull on the foot"):
        for component in "xyz":
            deck.put(path, component, "string", f"0.1*({deck.get(path, component)})")
    deck.put("time", "scheme", "string", scheme)
    return deck


def held_block(scheme):
    """The same, clamped at rest, so that statics can be beside dynamics."""
    deck = gentle_block(scheme)
    deck.remove("initial conditions")
    for axis in "xyz":
        deck.put("supports/bottom", axis, "string", "0")
    deck.put("supports/bottom", "set", "string", "block/bottom")
    deck.put("time", "end", "double", end_of_loads(deck))
    return deck


def cost():
    seconds = {scheme: [] for scheme in SCHEMES}
    summaries = {}
    for _ in range(REPEATS):
        for scheme in SCHEMES:
            _, _, summary = gentle_block(scheme).run(ENDS)
            stages = summary["seconds"]
            seconds[scheme].append((stages["cpu_of_rank_0"] / summary["steps"], stages["elements"] / summary["newton_iterations"]))
            summaries[scheme] = summary
    of_midpoint = [run[0] for run in seconds["midpoint"]]
    elements_of_midpoint = [run[1] for run in seconds["midpoint"]]
    for scheme in SCHEMES:
        per_step, elements = zip(*seconds[scheme])
        yield {"scene": "tossed block", "scheme": scheme, **counts(summaries[scheme]),
               "ms_per_step": f"{1e3 * statistics.median(per_step):.2f}",
               "of_midpoint": f"{statistics.median(a / b for a, b in zip(per_step, of_midpoint)):.2f}",
               "elements_per_iteration_of_midpoint": f"{statistics.median(a / b for a, b in zip(elements, elements_of_midpoint)):.2f}"}
    for scheme in ("static", *SCHEMES):
        _, _, summary = held_block(scheme).run(ENDS)
        yield {"scene": "held block", "scheme": scheme, **counts(summary), "ms_per_step": "", "of_midpoint": "",
               "elements_per_iteration_of_midpoint": ""}


def counts(summary):
    steps, iterations = summary["steps"], summary["newton_iterations"]
    return {"newton_per_step": f"{iterations / steps:.2f}", "residuals_per_iteration": f"{summary['counts']['residuals'] / iterations:.2f}",
            "residuals_per_step": f"{summary['counts']['residuals'] / steps:.2f}",
            "tangents_per_step": f"{summary['counts']['tangents'] / steps:.2f}"}


STRESS, DURATION, MEETING, SECTION = 20.30e6, 386.68e-6, 10e-6, 1e-4  # of the waves in the bars [Pa], [s], [s], [m^2]


def impact():
    for dt in (1e-6, 2e-6, 4e-6):
        for scheme in ("backward euler", "generalised alpha", "midpoint", "energy momentum midpoint contact"):
            deck = Deck("bars_impact/energy_momentum")
            deck.put("time", "scheme", "string", scheme)
            deck.set_steps(dt, round(5e-4 / dt))
            _, history, _ = deck.run(ENDS)
            time, force = history["time"], [abs(f) for f in history["contact_force_x.ends"]]
            E0, closed = history["total_energy"][0], [k for k, f in enumerate(force) if f > 0]
            begin, end = time[closed[0] - 1], time[closed[-1]]
            plateau = [f for t, f in zip(time, force) if 0.1 < (t - MEETING) / DURATION < 0.9]
            yield {"scheme": scheme, "dt_us": f"{1e6 * dt:g}", "mean_stress": f"{statistics.mean(plateau) / SECTION / STRESS:.4f}",
                   "greatest_stress": f"{max(force) / SECTION / STRESS:.2f}",
                   "longer_by_steps": f"{(end - begin - DURATION) / dt:+.1f}",
                   "openings": sum(f == 0 and MEETING + 2 * dt < t < MEETING + DURATION - 2 * dt for t, f in zip(time, force)),
                   "energy_kept": f"{history['total_energy'][-1] / E0:.5f}",
                   "at_closing": f"{history['contact_work_closing'][-1] / E0:.1e}",
                   "contact_work": f"{history['contact_work'][-1] / E0:.1e}",
                   "algorithmic_dissipation": f"{history['algorithmic_dissipation'][-1] / E0:.1e}",
                   "linear_mismatch": f"{greatest(history['linear_momentum_mismatch']) / greatest_length(history, 'linear_momentum'):.1e}"}


WAVE_STEP = 0.1 / 30  # of the bar on a wall: in which the wave crosses one element [s]
TOUCH, LEAVE, PRESSURE, AREA, SPEED = 0.5, 0.5 + 2 * 10 / 30, 300.0, 0.01, 10.0
WALL_CASES = (("newmark", "position", {"allow unstable": ("bool", "true")}), ("trapezoidal", "position", {}),
              ("backward euler", "position", {}), ("generalised alpha", "position", {"spectral radius": ("double", "0.8")}),
              ("generalised alpha", "persistent", {"spectral radius": ("double", "0.8")}),
              ("hht", "position", {"alpha": ("double", "0.1")}), ("midpoint", "position", {}),
              ("energy momentum", "position", {}), ("energy momentum", "modified", {}), ("energy momentum", "persistent", {}),
              ("energy momentum", "velocity update", {}), ("midpoint", "velocity update", {}), ("backward euler", "velocity update", {}),
              ("newmark", "position", {"mass": "lumped off contact"}), ("trapezoidal", "position", {"mass": "lumped off contact"}),
              ("energy momentum", "position", {"mass": "lumped off contact"}))


def rms(values):
    return f"{math.sqrt(statistics.mean((v - 1) ** 2 for v in values)):.3f}"


def wall():
    for scheme, closing, parameters in WALL_CASES:
        for courant in (0.5, 1.0, 2.0):
            deck, dt = Deck("bar_on_wall/persistent"), courant * WAVE_STEP
            deck.put("time", "scheme", "string", scheme)
            for name, value in parameters.items():
                if name == "mass":
                    deck.put("bodies/bar", name, "string", value)
                else:
                    deck.put("time", name, *value)
            deck.put("obstacles/wall", "closing", "string", closing)
            deck.set_steps(dt, round(1.6 / dt))
            code, history, _ = deck.run(ENDS)
            inside = [k for k, t in enumerate(history["time"]) if TOUCH + 2 * dt < t < LEAVE - 2 * dt]
            pressure = [history["contact_force_x.wall"][k] / AREA / PRESSURE for k in inside]
            yield {"scheme": scheme, "closing": closing, "mass": parameters.get("mass", "lumped"), "CFL": f"{courant:g}",
                   "greatest_pressure": f"{max(history['contact_force_x.wall']) / AREA / PRESSURE:.2f}", "rms_error": rms(pressure),
                   "rms_error_of_two_step_means": rms([0.5 * (a + b) for a, b in zip(pressure, pressure[1:])]),
                   "openings": f"{sum(history['active'][k] == 0 for k in inside)} of {len(inside)}",
                   "energy_kept": f"{history['total_energy'][-1] / history['total_energy'][0]:.4f}",
                   "penetration_over_v_dt": f"{max(0.0, -min(history['gap.tip'])) / (SPEED * dt):.2f}",
                   "ended": "as asked" if code == 0 else "no step converged"}


def write(study, file):
    with open(file, "w", encoding="utf-8", newline="") as stream:
        table = None
        for row in study():
            if table is None:
                table = csv.DictWriter(stream, list(row), lineterminator="\n")
                table.writeheader()
            table.writerow(row)
            stream.flush()


def print_table(file):
    with open(file, encoding="utf-8", newline="") as stream:
        for number, row in enumerate(csv.reader(stream)):
            print("| " + " | ".join(word.replace("_", " ") for word in row) + " |")
            if number == 0:
                print("|" + "---|" * len(row))


if __name__ == "__main__":
    studies = {"tumbling": tumbling, "tolerances": tolerances, "cost": cost, "impact": impact, "wall": wall}
    if len(sys.argv) != 3 or sys.argv[1] not in (*studies, "table"):
        sys.exit(__doc__)
    if sys.argv[1] == "table":
        print_table(sys.argv[2])
    else:
        write(studies[sys.argv[1]], sys.argv[2])
