"""Client of a served workbench for the studies: starts the server, runs jobs, and ends the server."""
import json
import signal
import subprocess
import time
import urllib.error
import urllib.request

POLL = 0.05  # interval at which the status of a job is polled [s]


class WorkbenchLost(Exception):
    """Raised if the program has ended or a job does not end in time."""


class Workbench:
    """`tubeplan serve` on a free port; if the start failed, `words()` is the message and `code` the exit code."""

    def __init__(self, program, words, folder, seconds=240):
        self.seconds = seconds
        self.errors = open(f"{folder}/serve.txt", "w+")
        own = ["--port", "0", "--state", f"{folder}/state", "--fresh"]
        self.process = subprocess.Popen([program, "serve"] + words + own, cwd=folder, stdout=subprocess.PIPE,
                                        stderr=self.errors, text=True)
        self.address = self.process.stdout.readline().strip()
        self.code = None if self.address else self.process.wait(seconds)

    def words(self):
        self.errors.seek(0)
        return self.errors.read()

    def ask(self, path, body=None):
        """Sends a request and returns (HTTP status, text of the answer)."""
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=self.seconds) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as refused:
            return refused.code, refused.read().decode()
        except OSError as error:
            raise WorkbenchLost(f"{path}: {error}; exit code {self.process.poll()}; {self.words()[-300:]}") from error

    def job(self, name, body=None):
        """Starts a job and waits for its end; returns the error message, or an empty string if the job succeeded."""
        status, text = self.ask(f"api/{name}", body or {})
        if status >= 400:
            return text
        number, until = json.loads(text)["id"], time.monotonic() + self.seconds
        while time.monotonic() < until:
            jobs = json.loads(self.ask("api/state")[1])["jobs"]
            job = next(job for job in jobs if job["id"] == number)
            if job["status"] != "running":
                return "" if job["status"] == "done" else json.dumps(job["error"] or job["status"])
            time.sleep(POLL)
        raise WorkbenchLost(f"{name}: not done after {self.seconds} s")

    def result(self, name):
        return self.ask(f"api/results/{name}")[1]

    def end(self):
        """Ends the program as Ctrl-C does and returns the exit code."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()
        finally:
            self.process.stdout.close()
            self.errors.close()
