#!/usr/bin/env python3
"""workbench_soak.py TUBEPLAN CELLS-FOLDER [--minutes 15] [--rate 20]

Compresses a day's use of the served page: requests for pages, state, postures, signatures and exports all the time; a
comparison, a fit, a diagnosis or a reload of the readings every few seconds; at half time, 200 connections that send
only half a request.

Finally, each kind of request is repeated many times. Memory that then grows, after some first repetitions, is a leak.
Memory over the whole time does not show leaks, because it varies with the memory that the largest jobs leave free.

Fails if an answer is a server error, if a kind of request leaks, if files or threads are left open, or if the 200
connections stall other requests. Sends at most --rate requests per second, only to the program that it starts itself.
"""
import argparse
import collections
import http.client
import json
import os
import pathlib
import random
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.parse

from workbench_client import Workbench

HALF_OPEN = 200
MODELS = 5
LIMIT = 5.0  # longest accepted time for an answer of /api/state while half-open connections wait [s]
IN_A_ROW = {"look": 1000, "work": 24}
LEAK = 0.5  # largest accepted growth of memory during repeated requests of one kind [MiB]


def footprint(pid):
    """Returns the resident memory [MiB], the number of open files and the number of threads."""
    status = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines() if ":" in line)
    return int(status["VmRSS"].split()[0]) / 1024, len(os.listdir(f"/proc/{pid}/fd")), int(status["Threads"])


class Visitor:
    def __init__(self, served, readings, seed):
        self.served, self.readings, self.random = served, readings, random.Random(seed)
        self.codes, self.slowest, self.events, self.bad = collections.Counter(), 0.0, 0, []

    def ask(self, path, body=None, text=None):
        begun = time.monotonic()
        address = urllib.parse.urlparse(self.served.address)
        connection = http.client.HTTPConnection(address.hostname, address.port, timeout=120)
        try:
            data = text if text is not None else None if body is None else json.dumps(body)
            kind = {"Content-Type": "text/csv" if text is not None else "application/json"}
            connection.request("POST" if data is not None else "GET", address.path + path, data, kind)
            answer = connection.getresponse()
            answer.read()
        finally:
            connection.close()
        self.slowest = max(self.slowest, time.monotonic() - begun)
        self.codes[answer.status] += 1
        if answer.status >= 500:
            self.bad.append((answer.status, path))
        return answer.status

    def looks(self):
        joints = [self.random.uniform(-60, 60), self.random.uniform(20, 120), self.random.uniform(-100, 0), self.random.uniform(-30, 30)]
        return [
            lambda: self.ask(""),
            lambda: self.ask("api/state"),
            lambda: self.ask("api/measurements"),
            lambda: self.ask("api/pose", {"joints": joints, "load": 20}),
            lambda: self.ask("api/signature?effect=joint-offset&at=theta3"),
            lambda: self.ask("api/catalogue"),
            lambda: self.ask("api/moments"),
            lambda: self.ask("api/files"),
            lambda: self.ask("api/export/cell.yaml"),
            lambda: self.ask("api/export/project.tubeplan"),
            lambda: self.ask("api/results/compare"),
            lambda: self.ask("api/live/encoders", {"joints": joints}),
        ]

    def look(self):
        self.random.choice(self.looks())()

    def work(self):
        """Starts a random job or change; jobs are refused while another job runs. Models are undone if there are more
        than MODELS, because each model keeps its results in memory."""
        if len(json.loads(self.served.ask("api/state")[1])["models"]) > MODELS:
            while self.ask("api/undo", {}) == 200:
                pass
        self.random.choice([
            lambda: self.ask("api/compare", {}),
            lambda: self.ask("api/identify", {}),
            lambda: self.ask("api/diagnose", {}),
            lambda: self.ask("api/undo", {}),
            lambda: self.ask("api/measurements?name=again.csv", text=self.readings),
            lambda: self.ask("api/measurements/set-aside", {"ids": ["1", "2"], "aside": self.random.random() < 0.5}),
        ])()


    def in_a_row(self):
        """Repeats each kind of request and returns the growth of memory for each kind [MiB]."""
        works = [lambda: self.served.job("compare"), lambda: (self.served.job("identify"), self.ask("api/undo", {})),
                 lambda: self.served.job("diagnose"), lambda: self.ask("api/measurements?name=again.csv", text=self.readings)]
        grown = []
        for kind, requests in (("look", self.looks()), ("work", works)):
            for request in requests:
                before = None
                for k in range(IN_A_ROW[kind] + IN_A_ROW[kind] // 3):
                    if k == IN_A_ROW[kind] // 3:
                        before = footprint(self.served.process.pid)[0]
                    request()
                grown.append(footprint(self.served.process.pid)[0] - before)
        return grown


def half_open(address):
    """Returns HALF_OPEN connections that have sent an incomplete request."""
    parts = urllib.parse.urlparse(address)
    made = []
    for _ in range(HALF_OPEN):
        connection = socket.create_connection((parts.hostname, parts.port), timeout=10)
        connection.sendall(b"GET / HTTP/1.1\r\nHost: ")
        made.append(connection)
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tubeplan", type=pathlib.Path)
    parser.add_argument("cells", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=15)
    parser.add_argument("--rate", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    program = str(options.tubeplan.resolve())
    with tempfile.TemporaryDirectory(prefix="tubeplan-soak-") as folder:
        shutil.copytree(options.cells, pathlib.Path(folder) / "cells")
        subprocess.run([program, "simulate", "cells/bench.yaml", "--design", "bench", "--readings", "60", "--hide", "joint-offset@theta3:0.1",
                        "--out", "made"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        readings = (pathlib.Path(folder) / "made/measurements.csv").read_text()
        served = Workbench(program, ["cells/bench.yaml", "made/measurements.csv"], folder)
        visitor, seen, stalled = Visitor(served, readings, options.seed), [], None
        try:
            for name in ("compare", "identify", "diagnose", "diagnose"):  # reach peak memory before it is measured
                served.job(name)
            begun = next_look = next_sample = next_work = time.monotonic()
            first = footprint(served.process.pid)
            end = begun + 60 * options.minutes
            held = None
            while (now := time.monotonic()) < end:
                if now >= next_sample:
                    seen.append((now - begun, *footprint(served.process.pid)))
                    next_sample += 5
                if now >= next_work:
                    visitor.work()
                    next_work = now + 6
                if held is None and now > begun + 30 * options.minutes:
                    held = half_open(served.address)
                    waits = []
                    for _ in range(20):
                        at = time.monotonic()
                        visitor.ask("api/state")
                        waits.append(time.monotonic() - at)
                    stalled = max(waits)
                    for connection in held:
                        connection.close()
                visitor.look()
                next_look = max(next_look + 1 / options.rate, time.monotonic() - 1)
                time.sleep(max(0.0, next_look - time.monotonic()))
            for _ in range(240):  # wait until the last job has ended
                if all(job["status"] != "running" for job in json.loads(served.ask("api/state")[1])["jobs"]):
                    break
                time.sleep(0.5)
            time.sleep(2)
            last = footprint(served.process.pid)
            grown = visitor.in_a_row()
        finally:
            code = served.end()
    quarter = len(seen) // 4
    memory = [statistics.median(entry[1] for entry in seen[k * quarter:(k + 1) * quarter]) for k in range(4)]
    print(f"{sum(visitor.codes.values())} requests in {options.minutes:g} min, by status {dict(visitor.codes)}, slowest {visitor.slowest:.2f} s")
    print("resident MiB, median by quarter of the time:", " ".join(f"{value:.1f}" for value in memory), f"; first {first[0]:.1f}, last {last[0]:.1f}")
    print("MiB that each kind of request grows by in a row:", " ".join(f"{value:+.2f}" for value in grown))
    print(f"open files {first[1]} -> {last[1]}, threads {first[2]} -> {last[2]}, exit code {code}")
    print(f"beside {HALF_OPEN} half-open connections /api/state took at most {stalled:.3f} s")
    problems = []
    if visitor.bad:
        problems.append(f"server errors: {visitor.bad[:5]}")
    if max(grown) > LEAK:
        problems.append("a kind of request leaks")
    if last[1] > first[1] + 2 or last[2] > first[2] + 4:
        problems.append("something is left open")
    if stalled > LIMIT:
        problems.append("half-open connections stall the server")
    print("; ".join(problems) or "all as it should be")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
