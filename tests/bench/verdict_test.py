"""A wrong verdict, of patchproof or of a peer, has to end the benchmarks with an error."""

import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench"))

import claims  # noqa: E402
import processes  # noqa: E402
import run  # noqa: E402
import runners  # noqa: E402
from table import exponent  # noqa: E402
from workloads import Workload  # noqa: E402

OURS = 'import sys; print("5000 9000 1000", "{}" if "true" in sys.argv[-1] else "{}")'


class Verdicts(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        (self.folder / "bench").mkdir()

    def ours(self, true, mutant):
        """A patchproof_bench that says this."""
        program = self.folder / "bench/patchproof_bench"
        program.write_text(f"#!{sys.executable}\n" + OURS.format(true, mutant))
        program.chmod(0o755)

    def code(self, said, limit="5"):
        """The exit code of a run with one peer that says this."""
        peer = lambda *_: ([sys.executable, "-c", said], "")
        command = ["run.py", "--build", str(self.folder), "--output", str(self.folder),
                   "--limit", limit]
        workloads = {"W1": Workload("one", (3,), (3,), ("peer",))}
        with mock.patch.dict(runners.COMMANDS, {"peer": peer}), \
                mock.patch.object(run, "WORKLOADS", workloads), \
                mock.patch.object(sys, "argv", command), \
                contextlib.redirect_stdout(io.StringIO()) as out, \
                contextlib.redirect_stderr(io.StringIO()), \
                self.assertRaises(SystemExit) as ended:
            run.main()
        self.table = out.getvalue()
        return ended.exception.code

    def test_right_verdicts_are_good(self):
        self.ours("PROVED", "REFUTED")
        self.assertEqual(self.code("print('true 10000 1\\nmutant 9 0')"), 0)
        self.assertIn("2×", self.table)
        kept = json.loads((self.folder / "bench.json").read_text())
        self.assertEqual(kept["workloads"]["W1"]["peer"]["sizes"]["3"]["ratio"], 2)

    def test_a_peer_that_proves_the_mutant_is_wrong(self):
        self.ours("PROVED", "REFUTED")
        self.assertEqual(self.code("print('true 1 1\\nmutant 1 1')"), 1)
        self.assertIn("WRONG", self.table)

    def test_a_peer_that_does_not_prove_the_claim_is_wrong(self):
        self.ours("PROVED", "REFUTED")
        self.assertEqual(self.code("print('true 1 0\\nmutant 1 0')"), 1)

    def test_a_peer_that_ends_early_has_failed(self):
        self.ours("PROVED", "REFUTED")
        self.assertEqual(self.code("print('true 1 1')"), 1)
        self.assertEqual(self.code("raise SystemExit(3)"), 1)

    def test_patchproof_must_prove_the_one_and_refute_the_other(self):
        good = "print('true 1 1\\nmutant 1 0')"
        for verdicts in (("PROVED", "PROVED"), ("REFUTED", "REFUTED"), ("PROVED IF", "REFUTED")):
            self.ours(*verdicts)
            self.assertEqual(self.code(good), 1, verdicts)

    def test_unknown_is_said_and_is_not_wrong(self):
        self.ours("UNKNOWN: limit", "REFUTED")
        self.assertEqual(self.code("print('true 1 1\\nmutant 1 0')"), 0)
        self.assertIn("UNKNOWN", self.table)

    def test_a_slow_peer_is_no_error(self):
        self.ours("PROVED", "REFUTED")
        self.assertEqual(self.code("import time; time.sleep(9)", limit="0.5"), 0)
        self.assertIn("> 0.5 s", self.table)
        self.assertEqual(self.code("while True: pass", limit="0.5"), 0)
        self.assertIn("> 0.5 s", self.table)

    def test_each_small_claim_has_its_verdict(self):
        small = [("a", "a", True), ("a", "b", False)]
        self.assertTrue(processes.verdicts_right("PARI", small, 0, "1 0\n"))
        self.assertFalse(processes.verdicts_right("PARI", small, 0, "1 1\n"))
        self.assertFalse(processes.verdicts_right("PARI", small, 0, "1\n"))
        self.assertFalse(processes.verdicts_right("patchproof", small, 1, "2 claims"))

    def test_a_program_tells_by_its_exit_code(self):
        options = mock.Mock(limit=5, seconds=0)
        command = lambda n, mutant, _: [sys.executable, "-c", f"raise SystemExit({int(mutant)})"]
        stubborn = lambda n, mutant, _: [sys.executable, "-c", ""]
        with mock.patch.dict(processes.PROGRAMS, {"good": command, "bad": stubborn}):
            self.assertEqual(processes.run_program("good", 5, options).status, "ok")
            self.assertEqual(processes.run_program("bad", 5, options).status, "wrong")

    def test_mutants_differ_from_what_they_come_from(self):
        for workload in ("W1", "W2", "W3", "W4", "W5", "W6"):
            self.assertNotEqual(claims.text(workload, 5, 0), claims.text(workload, 5, 1))

    def test_growth_is_the_exponent(self):
        self.assertAlmostEqual(exponent([(n, 7 * n**3) for n in (2, 5, 9)]), 3)


if __name__ == "__main__":
    unittest.main()
