"""`brdftab bench` says what it measured, where and how, and leaves nothing behind. No test asserts a time."""

import json

from program import BAD_INPUT, DONE, FILE, InFolder, run

SMALL = ["--table", "0.01", "--file", "0.02", "--rounds", "2"]


class Bench(InFolder):
    def test_json(self):
        figures = self.folder / "figures.json"
        result = run("bench", *SMALL, "--folder", self.folder, "--json", figures, "--precision", "both")
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["figures.json"])
        measured = json.loads(figures.read_text())
        self.assertTrue(measured["program"].startswith("brdftab "))
        self.assertEqual({device["precision"] for device in measured["devices"]}, {"float32", "float64"})
        for device in measured["devices"]:
            self.assertIn(device["driver"], device["device"])
            self.assertIn("-cl-std=CL1.2", device["build_options"])
            node = 8 if device["precision"] == "float64" else 4
            works = {work["name"]: work for work in device["workloads"]}
            for name in ["dense", "dense rows", "store"]:
                self.assertEqual(works[name]["bytes"], node * works[name]["produced"])
            self.assertEqual(works["memset"]["bytes"], works["dense"]["bytes"])
            for work in works.values():
                self.assertLessEqual(work["seconds_min"], work["seconds_median"])
                self.assertLessEqual(work["seconds_median"], work["seconds_max"])
            self.assertGreater(device["ratios"]["dense / store"], 0)
            self.assertEqual(set(device["generate"]["stages_seconds"]), {"plan", "compute", "transfer", "write"})

    def test_refusals(self):
        figures = self.folder / "figures.json"
        figures.write_text("mine")
        refused = run("bench", *SMALL, "--json", figures)
        self.assertEqual(refused.returncode, FILE)
        self.assertIn("figures.json: exists", refused.stderr)
        self.assertEqual(figures.read_text(), "mine")
        self.assertEqual(run("bench", "--rounds", "0").returncode, BAD_INPUT)
        self.assertEqual(run("bench", "--folder", self.folder / "missing").returncode, BAD_INPUT)
