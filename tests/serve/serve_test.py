#!/usr/bin/python3
"""`floes serve` speaks UM-Bridge 1.0 over a real socket, keeps to its limits, and ends when it is told to.

    serve_test.py PROGRAM PAGE

PAGE is docs/serve.md, whose block of Python is run.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

PROGRAM, PAGE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))

# Six floes and three seconds: a member takes a fifth of a second.
CONFIGURATION = """
campaign = {seed = 1, arrangements = 2}
field = {floes = 6, concentration_percent = 60.0, begin_m = 2.0, half_width_m = 1.0, far_end = "ice_sheet"}
structure = {start_m = 1.38, speed_m_s = 0.2}
analysis = {steady_start_s = 1.0, window_s = 3.0, segments = 3}
design = {method = "sobol", points = 4, axis = [
  {key = "ice.thickness_m", from = 0.02, to = 0.05},
  {key = "contact.ice_structure_friction", from = 0.1, to = 0.4}]}
"""


class Server:
    """A server in a folder of its own, on a free port."""

    def __init__(self, folder, *options, **environment):
        (folder / "quick.toml").write_text(CONFIGURATION)
        self.process = subprocess.Popen([PROGRAM, "serve", "quick.toml", "--port", "0", *options], cwd=folder,
                                        stderr=subprocess.PIPE, text=True, env={**os.environ, **environment})
        self.said = ""
        while not (found := re.search(r"(http://127\.0\.0\.1:(\d+))", self.said)):
            line = self.process.stderr.readline()
            if not line:
                raise AssertionError(f"the server did not start: {self.said}")
            self.said += line
        self.url, self.port = found[1], int(found[2])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.stderr.close()
        self.process.wait()

    def end(self, by):
        """Exit status and seconds until then."""
        begin = time.monotonic()
        self.process.send_signal(by)
        self.said += self.process.communicate(timeout=100)[1]
        return self.process.returncode, time.monotonic() - begin

    def ask(self, path, body=None, timeout=60, headers=None):
        """(status, JSON) of a GET, or with a body of a POST."""
        data = json.dumps(body).encode() if isinstance(body, dict) else body
        request = urllib.request.Request(self.url + path, data, headers or {})
        try:
            with urllib.request.urlopen(request, timeout=timeout) as reply:
                return reply.status, json.load(reply)
        except urllib.error.HTTPError as error:
            with error:
                return error.code, json.load(error)

    def evaluate(self, *values, **config):
        status, reply = self.ask("/Evaluate", {"name": "forward", "input": [list(values)], "config": config})
        return reply["output"] if status == 200 else (status, reply["error"]["type"], reply["error"]["message"])


def evaluate_all(server, points, **config):
    """Each in a thread of its own."""
    with concurrent.futures.ThreadPoolExecutor(len(points)) as pool:
        return [one.result() for one in [pool.submit(server.evaluate, *point, **config) for point in points]]


class Serve(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_protocol(self):
        with Server(self.folder) as server:
            self.assertEqual(server.ask("/Info"), (200, {"protocolVersion": 1.0, "models": ["forward"]}))
            forward = {"name": "forward"}
            self.assertEqual(server.ask("/ModelInfo", forward), (200, {"support": {
                "Evaluate": True, "Gradient": False, "ApplyJacobian": False, "ApplyHessian": False}}))
            self.assertEqual(server.ask("/InputSizes", forward), (200, {"inputSizes": [2]}))
            self.assertEqual(server.ask("/OutputSizes", forward), (200, {"outputSizes": [2]}))

            [means, errors] = server.evaluate(0.03, 0.2, standard_errors=True)
            self.assertTrue(all(number > 0 for number in means + errors), (means, errors))
            self.assertEqual(server.evaluate(0.03, 0.2), [means])
            self.assertNotEqual(server.evaluate(0.04, 0.2), [means])
            self.assertNotEqual(server.evaluate(0.03, 0.2, seed=2), [means])
            three = server.evaluate(0.03, 0.2, arrangements=3)
            self.assertNotEqual(three, [means])
            self.assertEqual(server.evaluate(0.03, 0.2, arrangements=2), [means])

            self.assertEqual(server.evaluate(0.06, 0.2)[:2], (400, "InvalidInput"))
            self.assertEqual(server.evaluate(0.03)[:2], (400, "InvalidInput"))
            self.assertEqual(server.ask("/Evaluate", {"name": "other"})[1]["error"]["type"], "ModelNotFound")
            self.assertEqual(server.ask("/Gradient", forward)[1]["error"]["type"], "UnsupportedFeature")
            self.assertEqual(server.ask("/Evaluate", b"{\"name\": NaN}")[0], 400)
        # Computed afresh, and by floes run at the same point.
        self.assertEqual(server.process.returncode, -signal.SIGKILL)
        with Server(self.folder, "-o", "another", "--threads", "1") as server:
            self.assertEqual(server.evaluate(0.03, 0.2), [means])
        run = [PROGRAM, "run", "quick.toml", "-o", "run.h5", "--set", "design.method=list", "--set", "design.points=0"]
        text = CONFIGURATION.replace("from = 0.02, to = 0.05", "values = [0.03]").replace(
            "from = 0.1, to = 0.4", "values = [0.2]")
        (self.folder / "quick.toml").write_text(text)
        subprocess.run(run, cwd=self.folder, check=True, capture_output=True)
        shown = json.loads(subprocess.run([PROGRAM, "summarize", "run.h5", "--format", "json"], cwd=self.folder, check=True,
                                          capture_output=True, text=True).stdout)
        self.assertAlmostEqual(means[0], shown["cases"][0]["mean_load"], delta=1e-12 * means[0])

    def test_page(self):
        [block] = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.M | re.S)
        self.assertIn("http://localhost:4242/", block)
        with Server(self.folder) as server:
            done = subprocess.run([sys.executable, "-c", block.replace("localhost:4242", f"localhost:{server.port}")],
                                  check=True, capture_output=True, text=True)
            plain, with_errors = map(json.loads, done.stdout.splitlines())
            self.assertEqual(plain, server.evaluate(0.03, 0.2))
            self.assertEqual(with_errors, server.evaluate(0.03, 0.2, arrangements=8, standard_errors=True))

    def test_limits_of_a_request(self):
        with Server(self.folder) as server:
            self.assertEqual(server.ask("/Evaluate", b" " * 65537)[0], 413)
            self.assertEqual(server.ask("/Evaluate", b" " * 5_000_000)[0], 413)
            self.assertEqual(server.ask("/Info", headers={"X-Long": "x" * 9000})[0], 431)
            self.assertEqual(server.ask("/Info", headers={"Origin": "http://a.page"})[0], 403)
            with socket.create_connection(("127.0.0.1", server.port)) as one:
                one.sendall(b"neither GET nor POST\r\n\r\n")
                self.assertIn(b"400 Bad Request", one.recv(1000))
            self.assertEqual(server.ask("/Info")[0], 200)

    def test_limits_of_connections(self):
        with Server(self.folder) as server:
            idle = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(64)]
            with self.assertRaises((TimeoutError, urllib.error.URLError)):
                server.ask("/Info", timeout=1)
            for one in idle[:2]:  # one of them for the request above, which waits still
                one.close()
            self.assertEqual(server.ask("/Info", timeout=20)[0], 200)
            for one in idle:
                one.close()

    def test_evaluations_wait(self):
        for at_once in ("1", "2"):
            with Server(self.folder, "--waiting", "1", "--at-once", at_once, "-o", at_once) as server:
                answers = evaluate_all(server, [(0.02 + 0.001 * k, 0.2) for k in range(7)], arrangements=4)
            refused = [one for one in answers if isinstance(one, tuple)]
            self.assertTrue(1 <= len(refused) <= 6, answers)
            self.assertTrue(all(one[:2] == (503, "Unavailable") and "No more than 1 evaluation may wait" in one[2]
                                for one in refused), refused)

    def test_points_at_once_have_the_answers_of_points_in_sequence(self):
        points = [(0.02 + 0.003 * k, 0.2) for k in range(8)]
        with Server(self.folder, "--at-once", "8") as server:
            together = evaluate_all(server, points, standard_errors=True)
        with Server(self.folder, "--at-once", "1", "-o", "alone", "--threads", "1") as server:
            self.assertEqual(together, [server.evaluate(*point, standard_errors=True) for point in points])
        kept = {one.name for one in (self.folder / "quick.served").iterdir()}
        self.assertEqual(len([one for one in kept if one.endswith(".h5")]), 8)
        self.assertEqual(kept, {one.name for one in (self.folder / "alone").iterdir()})

    def test_a_point_asked_twice_is_computed_once(self):
        with Server(self.folder, "--at-once", "4") as server:
            answers = evaluate_all(server, [(0.03, 0.2)] * 6, arrangements=4)
            self.assertEqual(answers[1:], answers[:-1])
            self.assertNotIsInstance(answers[0], tuple)
            server.end(signal.SIGINT)
            self.assertEqual(server.said.count("4 members = 1 case x 4 arrangements"), 1, server.said)

    def test_a_signal_during_many_loses_nothing(self):
        points = [(0.02 + 0.004 * k, 0.3) for k in range(4)]
        with Server(self.folder, "--at-once", "4") as server, concurrent.futures.ThreadPoolExecutor() as pool:
            asked = pool.submit(evaluate_all, server, points, arrangements=12)
            while not any(one.stat().st_size > 10000 for one in (self.folder / "quick.served").glob("*.journal")):
                time.sleep(0.05)
            status, seconds = server.end(signal.SIGTERM)
            self.assertEqual(status, 0)
            self.assertLess(seconds, 60)
            stopped = asked.result()
            self.assertIn((503, "Unavailable"), [one[:2] for one in stopped])
        begun = [re.search(r"(\d+) of 12 members done and on the disk", line) for line in server.said.splitlines()]
        kept = sum(int(one[1]) for one in begun if one)
        self.assertGreater(kept, 0, server.said)
        with Server(self.folder, "--at-once", "4") as server:
            together = evaluate_all(server, points, arrangements=12)
            server.end(signal.SIGINT)
        reused = [re.search(r"resumed: (\d+) members? reused", line) for line in server.said.splitlines()]
        self.assertEqual(sum(int(one[1]) for one in reused if one), kept, server.said)
        with Server(self.folder, "-o", "afresh") as server:
            self.assertEqual(together, evaluate_all(server, points, arrangements=12))

    def test_token(self):
        secret = "never-printed-0123456789"
        (self.folder / "token").write_text(secret + "\n")
        for options, environment in ((["--token-file", "token"], {}), ([], {"FLOES_TOKEN": secret})):
            with Server(self.folder, *options, **environment) as server:
                for headers, sentence in (({}, "asks for a token"),
                                          ({"Authorization": f"Bearer {secret}0"}, "is not that of this server")):
                    status, reply = server.ask("/Info", headers=headers)
                    self.assertEqual(status, 401)
                    self.assertIn(sentence, reply["error"]["message"])
                self.assertEqual(server.ask("/Info", headers={"Authorization": f"Bearer {secret}"})[0], 200)
                server.end(signal.SIGINT)
                self.assertIn("requests need the token", server.said)
                self.assertNotIn(secret, server.said)

    def test_signals_end_it(self):
        for by in (signal.SIGINT, signal.SIGTERM):
            with Server(self.folder) as server:
                status, seconds = server.end(by)
                self.assertEqual(status, 0)
                self.assertLess(seconds, 20)
                self.assertIn(f"stopped by {by.name}", server.said)
        with Server(self.folder) as server, concurrent.futures.ThreadPoolExecutor() as pool:
            asked = pool.submit(server.evaluate, 0.03, 0.2, arrangements=500)
            journal = None
            while journal is None or journal.stat().st_size < 20000:  # until some members are kept
                time.sleep(0.1)
                journal = next((self.folder / "quick.served").glob("*.journal"), None)
            status, seconds = server.end(signal.SIGTERM)
            self.assertEqual(status, 0)
            self.assertLess(seconds, 60)
            self.assertEqual(asked.result()[:2], (503, "Unavailable"))
        kept = subprocess.run([PROGRAM, "status", str(journal.with_suffix(".h5")), "--format", "json"], check=True,
                              capture_output=True, text=True)
        self.assertGreater(json.loads(kept.stdout)["done"], 0)

    def test_refusals_at_the_start(self):
        (self.folder / "quick.toml").write_text(CONFIGURATION)
        for options, sentence in ((["--input", "ice.thicknes_m"], "did you mean ice.thickness_m?"),
                                  (["--output", "mean"], "--output mean: this is no quantity"),
                                  (["--case", "E30"], "there is no case E30"),
                                  (["--host", "example.org"], "--host example.org is no address"),
                                  (["--host", "0.0.0.0"], "at --host 0.0.0.0 other machines can ask"),
                                  (["--token-file", "quick.toml"], "the token of quick.toml is shorter than 16"),
                                  (["-o", "quick.toml"], "cannot be made a folder"),
                                  (["--set", "field.floes=-1"], "field.floes")):
            done = subprocess.run([PROGRAM, "serve", "quick.toml", "--port", "0", *options], cwd=self.folder,
                                  capture_output=True, text=True, timeout=30)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(sentence, done.stderr)


if __name__ == "__main__":
    unittest.main()
