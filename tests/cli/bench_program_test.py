#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt-bench from outside: its table, its files, being interrupted, children and peers that fail.

Usage: bench_program_test.py MGDT-BENCH MGDT [unittest arguments]
"""

import csv
import json
import os
import pathlib
import pty
import resource
import select
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test  # noqa: E402  (its tests do not run here)

COLUMNS = ("library,version,distribution,points,seed,scheme,threads,run,status,np,nr,created,"
           "order_seconds,insert_seconds,total_seconds,bytes_per_point,peak_rss_bytes,inserted,"
           "duplicates,tetrahedra,levels,rounds,system_seconds,user_seconds,alone_percent")
# The random order walks from end to end of the line at each point, which takes some 700 times as long
# as the second run: on every machine there is time to interfere with the first.
QUICK = ["--distributions", "line", "--sizes", "500000", "--schemes", "auto", "--runs", "1"]
SLOW = ["random,auto" if word == "auto" else word for word in QUICK]


def wait_for(condition, what, seconds=120):
    end = time.monotonic() + seconds
    while not (result := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"waited in vain for {what}")
        time.sleep(0.02)
    return result


def children(pid):
    try:
        with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as f:
            return [int(child) for child in f.read().split()]
    except FileNotFoundError:
        return []


def lives(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as f:
            return f.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except (FileNotFoundError, ProcessLookupError):
        return False


MGDT = ""


class BenchTest(cli_test.CliTest):
    def bench(self, *arguments, **options):
        return self.mgdt(*arguments, **options).decode()

    def rows(self, name="t.csv"):
        with open(self.path(name), encoding="ascii", newline="") as f:
            self.assertEqual(f.readline(), COLUMNS + "\n")
            f.seek(0)
            return list(csv.DictReader(f))

    def start(self, *arguments, **options):
        process = subprocess.Popen([cli_test.MGDT, *map(str, arguments)],
                                   cwd=self.directory, stderr=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, **options)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def long_child(self, process):
        """A child that is there for a while: not the one that makes the points."""
        def same_after_a_while():
            before = children(process.pid)
            time.sleep(0.3)
            return [pid for pid in children(process.pid) if pid in before]
        return wait_for(same_after_a_while, "a run")[0]


class Tables(BenchTest):
    def test_processor_times(self):
        # 110 MB of fresh pages are more than a tick.
        self.bench("--distributions", "uniform", "--sizes", "3e5", "--schemes", "auto",
                   "--threads", "1,2", "--runs", 1, "--csv", "t.csv")
        for row in self.rows():
            user, system = float(row["user_seconds"]), float(row["system_seconds"])
            self.assertGreater(system, 0)
            # The points are not made, nor read, in the time that is measured.
            self.assertLess(user + system, int(row["threads"]) * float(row["total_seconds"]) + 0.02)
        # The first rounds are too small for two.
        self.assertEqual(self.rows()[0]["alone_percent"], "")
        alone = float(self.rows()[1]["alone_percent"])
        self.assertTrue(0 < alone < 50, alone)
        # A thread is not idle while it inserts; another process may take the processor from it.
        self.assertGreater(float(self.rows()[0]["user_seconds"]), 0.05)

    def test_rows_and_files(self):
        text = self.bench("--distributions", "uniform,galaxy,mild-line", "--sizes", "2000,3e3",
                          "--schemes", "multi-grid,hilbert", "--threads", "1,2", "--runs", 2,
                          "--seed", 7, "--csv", "t.csv", "--json", "t.json")
        self.assertEqual(self.err, "", "a bar where nobody looks")
        rows = self.rows()
        self.assertEqual(len(rows), 3 * 2 * 2 * 2 * 2)
        for title in ["NP", "NR", "created", "order s", "insert s", "total s", "user s",
                      "alone %", "bytes/pt"]:
            self.assertIn(title, text)
        # In turns: everyone's first run before anyone's second.
        self.assertEqual([(r["scheme"], r["threads"], r["run"]) for r in rows[:8]],
                         [(s, t, r) for r in "12" for s in ("multi-grid", "hilbert") for t in "12"])
        for r in rows:
            self.assertEqual((r["library"], r["status"], r["seed"]), ("mgdt", "ok", "7"))
            self.assertGreaterEqual(float(r["np"]), 1)
            self.assertGreater(float(r["nr"]), 10)
            self.assertGreater(float(r["created"]), float(r["nr"]))
            spent = float(r["order_seconds"]) + float(r["insert_seconds"])
            self.assertGreater(spent, 0)
            self.assertLessEqual(spent, float(r["total_seconds"]))
            # Of all threads, and counted in ticks.
            self.assertGreaterEqual(float(r["system_seconds"]), 0)
            self.assertGreaterEqual(float(r["user_seconds"]), 0)
            self.assertLess(float(r["system_seconds"]) + float(r["user_seconds"]),
                            int(r["threads"]) * float(r["total_seconds"]) + 0.02)
            self.assertGreater(float(r["bytes_per_point"]), 300)
            self.assertGreater(float(r["peak_rss_bytes"]), 300 * int(r["points"]))
            self.assertEqual(int(r["inserted"]) + int(r["duplicates"]), int(r["points"]))
            self.assertGreater(int(r["tetrahedra"]), 5 * int(r["points"]))
            self.assertGreaterEqual(int(r["rounds"]), 1)
        with open(self.path("t.json"), encoding="ascii") as f:
            document = json.load(f)
        self.assertEqual(sorted(document["machine"]), ["cores", "cpu", "memory_bytes"])
        self.assertIn("--seed 7", document["command"])
        self.assertEqual(document["version"], rows[0]["version"])
        self.assertEqual([",".join(r) for r in document["rows"]], [COLUMNS] * len(rows))
        for r, j in zip(rows, document["rows"]):
            for name, value in j.items():
                field = r[name] if isinstance(value, str) else float(r[name]) if r[name] else None
                self.assertEqual(field, value, name)

    def test_compact(self):
        plan = ["--distributions", "uniform", "--sizes", 20000, "--runs", 2, "--csv", "t.csv"]
        self.bench(*plan)
        text = self.bench(*plan, "--compact")
        self.assertIn("auto+compact", text)
        rows = self.rows()
        self.assertEqual([(r["scheme"], r["run"]) for r in rows],
                         [("auto", "1"), ("auto", "2"), ("auto+compact", "1"), ("auto+compact", "2")])
        self.assertEqual(len({(r["status"], r["tetrahedra"], r["np"]) for r in rows}), 1)
        for kept, compact in (rows[0], rows[2]), (rows[1], rows[3]):
            self.assertLess(float(compact["bytes_per_point"]), float(kept["bytes_per_point"]) - 100)
        self.assertIn("4 of 4", self.bench(*plan, "--compact") + self.err)

    def test_same_run_as_triangulate(self):
        def mgdt(*arguments):
            return subprocess.run([MGDT, *arguments], cwd=self.directory, check=True, timeout=300,
                                  stdout=subprocess.PIPE, text=True).stdout
        mgdt("generate", "spiral", "2000", "--seed", "5", "-o", "p.npy")
        text = mgdt("triangulate", "p.npy", "--stats", "--scheme", "random", "--seed", "5")
        stats = dict(line.rsplit(None, 1) for line in text.splitlines())
        self.bench("--distributions", "spiral", "--sizes", 2000, "--schemes", "random", "--seed", 5,
                   "--runs", 1, "--csv", "t.csv")
        row = self.rows()[0]
        self.assertEqual(row["tetrahedra"], stats["tetrahedra"])
        for name, stat in (("np", "walk steps per point"), ("nr", "removed per point"),
                           ("created", "created per point")):
            self.assertEqual(f"{float(row[name]):.3f}", stats[stat])

    def test_threads_are_used(self):
        # Rounds are dealt along the curve only where there are threads for them.
        self.bench("--distributions", "uniform", "--sizes", 40000, "--schemes", "hilbert",
                   "--threads", "1,2", "--runs", 1, "--csv", "t.csv")
        one, two = (int(r["rounds"]) for r in self.rows())
        self.assertLess(one, two)

    def test_mild_sets_are_wider(self):
        self.bench("--distributions", "line,mild-line", "--sizes", 3000, "--runs", 1, "--csv",
                   "t.csv", "--schemes", "random")
        narrow, mild = (float(r["np"]) for r in self.rows())
        self.assertLess(mild, narrow)

    def test_quiet_and_json_on_standard_output(self):
        text = self.bench("-q", "--distributions", "uniform", "--sizes", 1000, "--runs", 3)
        self.assertEqual(text.count("uniform"), 1)
        self.assertIn("medians", text)
        text = self.bench("--distributions", "uniform", "--sizes", 1000, "--json", "-")
        self.assertEqual(len(json.loads(text)["rows"]), 3)
        self.assertIn("medians", self.err)

    def test_paper(self):
        text = self.bench("--paper", "--distributions", "uniform", "--largest", "4e5", "--schemes",
                          "auto", "--csv", "t.csv")
        self.assertEqual([r["points"] for r in self.rows()], ["400000"])
        self.assertIn("left out, larger than --largest: uniform 800000", text)
        self.fails(2, "--paper", "--largest", 10, says=["nothing to run", "--largest"])
        self.fails(2, "--paper", "--sizes", 10, says="--sizes")
        self.fails(2, "--paper", "--distributions", "lattice", says=["'lattice'", "galaxy"])

    def test_wrong_usage(self):
        self.fails(2, "--distributions", "best", says=["'best'", "uniform", "mild-line"])
        self.fails(2, "--schemes", "best", says=["'best'", "multi-grid"])
        self.fails(2, "--sizes", "many", says=["--sizes", "'many'"])
        self.fails(2, "--sizes", "0", says="--sizes")
        self.fails(2, "--threads", "-1", says="--threads")
        self.fails(2, "--runs", "0", says="--runs")
        self.fails(2, "--time-limit", "0", says="--time-limit")
        self.fails(2, "--largest", "5", says="--paper")
        self.fails(2, "--peers", "best", says=["'best'", "cgal"])
        self.fails(2, "--csv", "-", says="--csv")
        self.fails(3, "--distributions", "church", "--data", "nowhere", "--csv", "t.csv",
                   says=["nowhere", "--data"])

    def test_bar_on_a_terminal(self):
        master, slave = pty.openpty()
        process = subprocess.Popen([cli_test.MGDT, *SLOW], cwd=self.directory,
                                   stderr=slave, stdout=subprocess.DEVNULL)
        os.close(slave)
        seen = b""
        while b"%" not in seen or b"1/2 line 500000 random [" not in seen:
            self.assertTrue(select.select([master], [], [], 60)[0], "no progress bar")
            seen += os.read(master, 4096)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        os.close(master)


class Churn(BenchTest):
    def test_table(self):
        lines = self.bench("--churn", "--distributions", "uniform,lattice-repeats", "--sizes", "1000,3000",
                           "--runs", 2, "--compact").splitlines()
        self.assertEqual(lines[0].split()[:4], ["distribution", "points", "insert", "out"])
        self.assertEqual([line.split()[0] for line in lines[1:]],
                         ["uniform"] * 2 + ["lattice-repeats"] * 2)
        for line in lines[1:]:
            for figure in line.split()[2:10]:
                self.assertGreater(float(figure), 0)
            self.assertLess(abs(float(line.split()[10].rstrip("%"))), 30)

    def test_what_it_does_not_take(self):
        for options in (["--csv", "t.csv"], ["--json", "t.json"], ["--peers", "cgal"],
                        ["--schemes", "auto"], ["--threads", "1,2"], ["--time-limit", "5"]):
            self.fails(2, "--churn", *options, says="--churn takes")
        self.fails(2, "--churn", "--paper", says="churn")
        self.fails(2, "--churn", "--sizes", "0", says="at least 1")
        self.fails(2, "--churn", "--sizes", "99", says="100 points are needed")


class GoingOn(BenchTest):
    PLAN = ["--distributions", "uniform,line", "--sizes", "2000", "--runs", "2", "--csv", "t.csv"]

    def test_after_the_program_is_killed(self):
        plan = ["--distributions", "uniform", "--sizes", "100", "--schemes", "auto,hilbert",
                "--runs", "500", "--csv", "t.csv"]
        process = self.start(*plan)
        wait_for(lambda: os.path.exists(self.path("t.csv")) and self.get("t.csv").count(b"\n") > 20,
                 "rows")
        process.kill()
        process.wait()
        before = self.get("t.csv")
        self.assertLess(before.count(b"\n"), 1001)
        plan[plan.index("500")] = "20"
        text = self.bench(*plan)
        self.assertIn("of 40 runs are in t.csv already", text)
        self.assertTrue(self.get("t.csv").startswith(before))
        keys = [(r["scheme"], r["run"]) for r in self.rows()]
        self.assertEqual(len(set(keys)), len(keys))
        self.assertTrue({(s, str(r)) for s in ("auto", "hilbert") for r in range(1, 21)} <= set(keys))

    def test_children_end_with_the_program(self):
        for number, code in (signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGKILL, -9):
            process = self.start(*SLOW, "--csv", "t.csv")
            child = self.long_child(process)
            process.send_signal(number)
            self.assertEqual(process.wait(timeout=60), code)
            wait_for(lambda: not lives(child), "the end of the child", 10)
            if number != signal.SIGKILL:
                message = process.stderr.read().decode()
                self.assertIn("cancelled", message)
                self.assertIn("t.csv", message)
            self.assertEqual(self.rows(), [])

    def test_a_child_does_not_hold_the_table(self):
        """It may outlive the program for a moment, and the next one must not find the file locked."""
        process = self.start(*SLOW, "--csv", "t.csv")
        child = self.long_child(process)

        def locks(number):
            folder = f"/proc/{number}/fdinfo"
            texts = [pathlib.Path(folder, name).read_text() for name in os.listdir(folder)]
            return sum(text.count("lock:") for text in texts)

        self.assertEqual((locks(process.pid), locks(child)), (1, 0))
        process.kill()
        process.wait()

    def test_torn_lines(self):
        self.bench(*self.PLAN)
        whole = self.get("t.csv")
        lines = whole.splitlines(keepends=True)
        self.assertEqual(len(lines), 5)
        for torn, kept in ((whole[:-1], 3), (whole[:-40], 3), (b"".join(lines[:2]) + b"m", 1),
                           (lines[0], 0), (lines[0][:-1], 0), (b"libr", 0), (b"", 0)):
            self.put("t.csv", torn)
            text = self.bench(*self.PLAN)
            self.assertEqual(f"{kept} of 4 runs" in text, kept > 0, text)
            self.assertTrue(self.get("t.csv").startswith(b"".join(lines[:kept + 1])))
            self.assertEqual([line.split(",")[:9] for line in self.get("t.csv").decode().split()],
                             [line.decode().split(",")[:9] for line in lines])

    def test_done_is_done(self):
        self.bench(*self.PLAN)
        before = self.get("t.csv")
        text = self.bench(*self.PLAN, "--json", "t.json")
        self.assertIn("4 of 4 runs", text)
        self.assertEqual(self.get("t.csv"), before)
        self.assertEqual(len(json.loads(self.get("t.json"))["rows"]), 4)

    def test_another_file_is_refused(self):
        self.bench(*self.PLAN)
        good = self.get("t.csv").decode()
        lines = good.splitlines(keepends=True)
        version = lines[1].split(",")[1]
        for content, reason in (
                ("x,y,z\n1,2,3\n", "first line"),
                ("no newline", "first line"),
                (good.replace("peak_rss_bytes", "rss", 1), "first line"),
                (good + "mgdt,1\n", "line 6"),
                (good + lines[1], "line 6 is a run that an earlier line has"),
                (good.replace(f"mgdt,{version},line", "mgdt,0.1,line", 1), ["line 4", "0.1", version]),
                (good.replace(",ok,", ",ok,nan", 1), "line 2"),
                (good.replace(",2000,", ",many,", 1), "line 2")):
            self.assertNotEqual(content, good)
            self.put("t.csv", content)
            self.fails(3, *self.PLAN, says=["t.csv", "name another file"])
            for part in [reason] if isinstance(reason, str) else reason:
                self.assertIn(part, self.err)
            self.assertEqual(self.get("t.csv").decode(), content)

    def test_two_at_once(self):
        process = self.start(*SLOW, "--csv", "t.csv")
        self.long_child(process)
        self.fails(4, *self.PLAN, says=["t.csv", "another mgdt-bench"])

    def test_tetrahedra_that_differ(self):
        plan = [*self.PLAN, "--schemes", "auto,hilbert"]
        self.bench(*plan)
        rows = self.rows()
        count = rows[0]["tetrahedra"]
        lines = self.get("t.csv").decode().splitlines(keepends=True)
        lines[2] = lines[2].replace(f",{count},", f",{int(count) - 1},")
        self.put("t.csv", "".join(lines))
        self.fails(6, *plan, says=["differ", "uniform 2000", count, "hilbert"])


class BadPlaces(BenchTest):
    def test_places_that_cannot_be_written(self):
        os.mkdir(self.path("d"))
        for option in "--csv", "--json":
            self.fails(4, option, "no/t", says=["no/t", "directory"])
            self.fails(4, option, "d", says="d: cannot write")
        self.fails(4, "--csv", "/dev/full", says="/dev/full")
        self.fails(4, "--sizes", 10, "--json", "/dev/full", says="/dev/full")

    def test_full_file(self):
        self.bench("--sizes", 10, "--csv", "t.csv", "--runs", 1)
        size = os.path.getsize(self.path("t.csv")) + 50

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        self.fails(4, "--sizes", 10, "--csv", "t.csv", "--runs", 2, preexec_fn=limit,
                   says=["t.csv", "File too large"])
        self.bench("--sizes", 10, "--csv", "t.csv", "--runs", 2)
        self.assertEqual(len(self.rows()), 14)

    def test_no_place_for_points(self):
        self.fails(4, "--sizes", 10, env={**os.environ, "TMPDIR": self.path("no")},
                   says="TMPDIR")


class Failures(BenchTest):
    def test_killed_child(self):
        process = self.start(*SLOW, "--csv", "t.csv", "--json", "t.json")
        os.kill(self.long_child(process), signal.SIGKILL)
        self.assertEqual(process.wait(timeout=120), 5)
        message = process.stderr.read().decode()
        self.assertIn("1 run of mgdt failed; the first on line 500000 with random: signal 9", message)
        self.assertEqual([r["status"] for r in self.rows()], ["signal 9", "ok"])
        self.assertEqual([r["np"] == "" for r in self.rows()], [True, False])
        self.assertIsNone(json.loads(self.get("t.json"))["rows"][0]["total_seconds"])

    def test_crashed_child(self):
        process = self.start(*SLOW, "--csv", "t.csv")
        os.kill(self.long_child(process), signal.SIGSEGV)
        self.assertEqual(process.wait(timeout=120), 6)
        self.assertEqual([r["status"] for r in self.rows()], ["signal 11", "ok"])

    def test_time_limit(self):
        self.bench(*QUICK, "--csv", "auto.csv")
        limit = 1 + 10 * float(self.rows("auto.csv")[0]["total_seconds"])
        text = self.bench(*SLOW, "--time-limit", limit, "--csv", "t.csv")
        self.assertEqual([r["status"] for r in self.rows()], ["timeout", "ok"])
        self.assertIn("failed: random on line 500000, 1 of 1 runs: timeout", text)
        # A row that is there is not run again, whatever it says.
        self.assertIn("2 of 2", self.bench(*SLOW, "--csv", "t.csv"))

    def test_out_of_memory(self):
        limit = 130 << 20
        self.mgdt("--distributions", "uniform", "--sizes", "400000,1000", "--runs", 1,
                  "--csv", "t.csv", code=5,
                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        self.assertEqual([r["status"] for r in self.rows()], ["out-of-memory", "ok"])
        self.assertIn("uniform 400000 with auto: out-of-memory", self.err)

    def test_no_memory_for_points(self):
        limit = 100 << 20
        self.mgdt("--distributions", "uniform", "--sizes", "1e7,1000", "--runs", 1, "--csv",
                  "t.csv", code=5,
                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        self.assertEqual([r["status"] for r in self.rows()], ["out-of-memory", "ok"])

    def test_points_that_are_refused(self):
        self.mgdt("--distributions", "nan,coplanar,one-point", "--sizes", 100, "--runs", 1,
                  "--csv", "t.csv", code=6)
        rows = self.rows()
        self.assertRegex(rows[0]["status"], "^error: .*point")
        self.assertEqual([r["status"] for r in rows[1:]], ["ok", "ok"])
        self.assertEqual([r["tetrahedra"] for r in rows[1:]], ["0", "0"])


class Peers(BenchTest):
    def runner(self, peer, script):
        path = self.put("mgdt-peer-" + peer, "#!/bin/sh\n" + script)
        os.chmod(path, 0o755)

    def compare(self, *arguments, **options):
        return self.bench("--peer-directory", ".", "--csv", "t.csv", "--peers", *arguments,
                          "--distributions", "uniform", "--sizes", "1000", **options)

    def test_ratios_of_medians(self):
        # What it takes for the number of tetrahedra shows that it got all the points in each run.
        self.runner("cgal", 'n=$(wc -c)\nread k <count || k=0\necho $((k + 1)) >count\n'
                            'echo "chatter"\necho "9.9 $((k + 1)).5 $n 4000 0.25"\n')
        self.put("count", "0\n")
        text = self.compare("cgal", "--schemes", "auto,hilbert", "--runs", 3, "--json", "t.json")
        rows = self.rows()
        self.assertEqual([r["scheme"] or r["library"] for r in rows],
                         ["auto", "hilbert", "cgal"] * 3)
        peer = [r for r in rows if r["library"] == "cgal"]
        self.assertEqual([float(r["total_seconds"]) for r in peer], [1.5, 2.5, 3.5])
        for r in peer:
            self.assertEqual((r["tetrahedra"], r["version"], r["status"]), ("24000", "9.9", "ok"))
            self.assertEqual((r["bytes_per_point"], r["np"], r["levels"]), ("4", "", ""))
            self.assertEqual(r["user_seconds"], "0.25")
            self.assertGreater(int(r["peak_rss_bytes"]), 100000)
        summary = text[text.index("medians"):]
        self.assertIn("cgal/mgdt", summary)
        for scheme in "auto", "hilbert":
            seconds = sorted(float(r["total_seconds"]) for r in rows if r["scheme"] == scheme)[1]
            line = [w for w in map(str.split, summary.splitlines()) if scheme in w[2:3]][0]
            self.assertEqual(line[-1], f"{2.5 / seconds:.2f}")
            self.assertRegex(summary, f"cgal/mgdt, {scheme}, 1 thread: geometric mean "
                                      f"{2.5 / seconds:.2f}, least {2.5 / seconds:.2f}, 1 set")
        self.assertIn("differs: cgal has 24000 tetrahedra on uniform 1000, mgdt", summary)
        self.assertEqual(len(json.loads(self.get("t.json"))["rows"]), 9)

    def test_failures_of_peers_are_rows(self):
        self.runner("cgal", "echo 'it says, \"no\"'; exit 1\n")
        self.runner("tetgen", "kill -SEGV $$\n")
        self.runner("qhull", "exit 5\n")
        text = self.compare("--runs", 1)
        self.assertEqual([r["status"] for r in self.rows()],
                         ["ok", "error: it says; 'no'", "signal 11", "out-of-memory"])
        self.assertIn("failed: tetgen on uniform 1000, 1 of 1 runs: signal 11", text)
        for name in "cgal", "tetgen", "qhull":
            self.assertNotIn(f"{name}/mgdt, ", text)

    def test_peers_without_an_end_or_a_sense(self):
        self.runner("cgal", "echo $$ >pid; sleep 1000\n")
        self.runner("tetgen", "echo $$ >pid2; sleep 1000 & echo done\n")
        self.runner("qhull", "")
        os.chmod(self.path("mgdt-peer-qhull"), 0o755)
        self.put("mgdt-peer-qhull", "#!/no/such/interpreter\n")
        os.chmod(self.path("mgdt-peer-qhull"), 0o755)
        self.compare("--runs", 1, "--time-limit", 2)
        statuses = [r["status"] for r in self.rows()]
        self.assertEqual(statuses[:3], ["ok", "timeout", "error: not a runner's line: done"])
        self.assertRegex(statuses[3], "^error: cannot run ")
        for name in "pid", "pid2":
            with self.assertRaises(ProcessLookupError):
                wait_for(lambda: os.killpg(int(self.get(name)), 0), "the end of its children", 10)

    def test_a_missing_runner_is_named(self):
        self.runner("qhull", "echo 1 1 1 1\n")
        self.compare("--runs", 1)
        self.assertEqual([r["library"] for r in self.rows()], ["mgdt", "qhull"])
        for part in "mgdt-peer-cgal", "libcgal-dev", "mgdt-peer-tetgen", "libtet1.5-dev":
            self.assertIn(part, self.err)
        self.assertNotIn("mgdt-peer-qhull", self.err)
        # With the runner there, the same table is filled up; the folder can be in the environment.
        self.runner("cgal", "echo 1 1 1 1\n")
        self.bench("--csv", "t.csv", "--peers", "cgal", "--distributions", "uniform", "--sizes",
                   1000, "--runs", 1, env={**os.environ, "MGDT_PEERS": self.directory})
        self.assertEqual([r["library"] for r in self.rows()], ["mgdt", "qhull", "cgal"])
        self.assertEqual([r["user_seconds"] for r in self.rows()[1:]], ["", ""])


class Names(BenchTest):
    """Files that are named twice, and words that a terminal must not see."""

    def test_data_of_generated_points(self):
        data = pathlib.Path(__file__).parents[2] / "docs" / "data" / "machine.msh"
        self.put("machine.msh", data.read_bytes())
        os.symlink("machine.msh", self.path("points.xyz"))
        self.refuses("--distributions", "machine", "--sizes", "1000", "--runs", "1", "--data", ".",
                     "--json", "points.xyz", says="points.xyz: would overwrite the input")

    def test_two_outputs(self):
        self.refuses("--sizes", "10", "--csv", "a", "--json", "./a",
                     says="./a: the same file as another output, a")

    def test_words(self):
        word, shown = b"\x1b[2J\xff", "\\x1b[2J\\xff"
        for option in ("--distributions", "--sizes"):
            self.assertIn(shown, self.run_mgdt(2, option, word))
        plan = ["--distributions", "uniform", "--sizes", "10", "--runs", "1", "--csv"]
        self.run_mgdt(0, *plan, word)
        self.assertIn(shown, self.run_mgdt(0, *plan, word))
        # A status that somebody has put into a table.
        self.run_mgdt(0, *plan, "t.csv")
        self.put("t.csv", self.get("t.csv").replace(b",ok,", b",\x1b[2J,"))
        self.assertIn("\\x1b[2J", self.run_mgdt(6, *plan, "t.csv"))

    def test_what_mgdt_says(self):
        self.assertIn(b"--peers", self.mgdt("--help"))
        self.assertIn(b"mgdt-bench 1.", self.mgdt("--version"))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))  # the program that is tested
    MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
