"""command.py - runs the command sheen in a folder of its own and judges what it says."""
import os
import subprocess
import sys
import tempfile
import unicodedata


def measured(program, *words):
    """Exit status, what it said on standard error, seconds of the processor, and the most memory, B."""
    with tempfile.TemporaryFile() as said, open(os.devnull, "wb") as nowhere:
        child = os.fork()
        if child == 0:
            os.dup2(nowhere.fileno(), 1)
            os.dup2(said.fileno(), 2)
            os.execv(program, ["sheen", *words])
        _, status, used = os.wait4(child, 0)  # of the command and of the reader that it waited for
        said.seek(0)
        return (os.waitstatus_to_exitcode(status), said.read().decode(errors="replace"), used.ru_utime + used.ru_stime,
                used.ru_maxrss * 1024)


class Command:
    def __init__(self, program):
        self.program = os.path.abspath(program)
        self.folder = tempfile.TemporaryDirectory(prefix="sheen_cli_")
        self.cases = self.refusals = 0
        os.chdir(self.folder.name)

    def run(self, *words, **more):
        return subprocess.run([self.program, *words], capture_output=True, timeout=900, **more)

    def refuse(self, *what):
        self.refusals += 1
        print(*what, file=sys.stderr)

    def good(self, *words, **more):
        """Must succeed without a word on standard error; returns standard output."""
        self.cases += 1
        run = self.run(*words, **more)
        if run.returncode or run.stderr:
            self.refuse("sheen", *words, "- status", run.returncode, run.stderr.decode(errors="replace"))
        return run.stdout.decode()

    @staticmethod
    def line(said):
        """What is wrong with the bytes as one line for a person: [] for nothing."""
        try:
            text = said.decode()
        except UnicodeDecodeError:
            return ["not UTF-8"]
        why = []
        if not text.startswith("sheen: ") or not text.endswith("\n") or text.count("\n") != 1:
            why.append("not one line")
        if len(text) > 211:
            why.append(f"{len(text) - 1} characters")
        if any(unicodedata.category(c) in ("Cc", "Zl", "Zp") for c in text[:-1]):
            why.append("holds control characters")
        return why

    def bad(self, status, parts, *words, **more):
        """
        Must fail with that status, nothing on standard output, no new file, and one
        line of UTF-8, of at most 210 characters, on standard error that begins with "sheen: " and holds each of parts.
        """
        self.cases += 1
        before = sorted(os.listdir("."))
        run = self.run(*words, **more)
        said = run.stderr.decode(errors="replace")
        why = self.line(run.stderr)
        if run.returncode != status:
            why.append(f"status {run.returncode}, not {status}")
        why += [f"does not say '{part}'" for part in parts if part not in said]
        if run.stdout:
            why.append("writes on standard output")
        if sorted(os.listdir(".")) != before:
            why.append("leaves files: " + " ".join(set(os.listdir(".")) ^ set(before)))
        if why:
            self.refuse("sheen", *words, "-", "; ".join(why) + ":", said)

    def is_true(self, what, *of):
        self.cases += 1
        if not what:
            self.refuse(*of)

    def close(self):
        print(f"{self.cases} command lines, {self.refusals} refusals")
        os.chdir("/")
        self.folder.cleanup()
        return 1 if self.refusals or not self.cases else 0
