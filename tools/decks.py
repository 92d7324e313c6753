"""Decks of inputs/, changed and run by studies."""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "release" / "mortise"


class Deck:
    """A deck of inputs/ without what it expects, to be changed and run."""

    def __init__(self, name):
        self.root = ElementTree.parse(ROOT / "inputs" / f"{name}.xml").getroot()
        self.remove("expected")

    def entry(self, path):
        """The list at a path, made where it is missing."""
        here = self.root
        for name in path.split("/"):
            inner = here.find(f"ParameterList[@name='{name}']")
            here = ElementTree.SubElement(here, "ParameterList", name=name) if inner is None else inner
        return here

    def put(self, path, name, kind, value):
        parameter = self.entry(path).find(f"Parameter[@name='{name}']")
        if parameter is None:
            parameter = ElementTree.SubElement(self.entry(path), "Parameter", name=name)
        parameter.set("type", kind)
        parameter.set("value", str(value))

    def get(self, path, name):
        return self.entry(path).find(f"Parameter[@name='{name}']").get("value")

    def drop(self, path, name):
        """Takes a parameter away."""
        self.entry(path).remove(self.entry(path).find(f"Parameter[@name='{name}']"))

    def remove(self, name):
        """Takes a list of the top level away, if it is there."""
        inner = self.root.find(f"ParameterList[@name='{name}']")
        if inner is not None:
            self.root.remove(inner)

    def set_steps(self, dt, n):
        for name in ("step", "smallest step"):
            self.put("time", name, "double", dt)
        self.put("time", "end", "double", dt * n)

    def run(self, allowed=(0,)):
        """Exit code, history as columns, summary. Ends the study with a code that is not allowed."""
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
                       "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "deck.xml").write_text(ElementTree.tostring(self.root, encoding="unicode"), encoding="utf-8")
            done = subprocess.run([PROGRAM, "run", "deck.xml", "-o", "out", "--quiet"], cwd=folder, env=environment, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if done.returncode not in allowed:
                sys.exit(f"a run ended with exit code {done.returncode}\n{done.stdout[-2000:]}")
            with open(folder / "out" / "history.csv", encoding="utf-8", newline="") as stream:
                rows = list(csv.reader(stream))
            history = {name: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}
            return done.returncode, history, json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
