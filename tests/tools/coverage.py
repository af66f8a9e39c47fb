# SPDX-License-Identifier: MIT
"""Which lines and branches of core and port the plain tests reach; called by `make coverage`.

    coverage.py BUILD ALLOWED

BUILD has the test programs, instrumented by clang, and in raw/ what each of them counted. ALLOWED lists what may
stay unreached, with reasons. Prints a table, leaves BUILD/lines.tsv (which test reaches which line, for
`make mutate`) and ends with 1 where something is unreached that is not listed, or an entry of the list is of no use.
"""
import glob
import json
import os
import re
import subprocess
import sys

NEVER = "never runs"


def lines_of(segments):
    """Line -> how often it ran, as llvm-cov's own reports count it."""
    counts = {}
    wrapped = None
    at = 0
    last = segments[-1][0] if segments else 0
    for line in range(segments[0][0] if segments else 1, last + 1):
        own = []
        while at < len(segments) and segments[at][0] == line:
            own.append(segments[at])
            at += 1
        starts = [s for s in own if s[3] and s[4] and not s[5]]
        skipped = bool(own) and not own[0][3] and own[0][4]
        if not skipped and ((wrapped and wrapped[3]) or starts):
            counts[line] = max([wrapped[2] if wrapped and wrapped[3] else 0] + [s[2] for s in starts])
        if own:
            wrapped = own[-1]
    return counts


def skipped_by(segments):
    """Lines that the preprocessor left out."""
    lines = set()
    for own, following in zip(segments, segments[1:]):
        if not own[3] and own[4]:
            lines.update(range(own[0], following[0] + (following[1] > 1)))
    return lines


def export(build, name, root):
    """The coverage of one test program, and of the command where it ran that, too."""
    raw = glob.glob(f"{build}/raw/{name}-*.profraw")
    if not raw:
        return []
    data = f"{build}/raw/{name}.profdata"
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", data] + raw, check=True)
    command = ["llvm-cov", "export", "-skip-expansions", "-skip-functions", f"-instr-profile={data}",
               f"{build}/tests/{name}"]
    if len(raw) > 1:
        command += ["-object", f"{build}/qtri"]
    text = subprocess.run(command, check=True, capture_output=True).stdout
    return [f for d in json.loads(text)["data"] for f in d["files"]
            if os.path.relpath(f["filename"], root).startswith(("core/", "port/"))]


class Counts:
    """How often each line and each side of a branch ran: by file, the sums of all tests."""

    def __init__(self):
        self.lines, self.branches, self.reached_by, self.skipped = {}, {}, {}, {}

    def add(self, name, path, file):
        self.skipped.setdefault(path, set()).update(skipped_by(file["segments"]))
        of_file = self.lines.setdefault(path, {})
        for line, count in lines_of(file["segments"]).items():
            of_file[line] = of_file.get(line, 0) + count
            if count:
                self.reached_by.setdefault((path, line), []).append(name)
        sides = self.branches.setdefault(path, {})
        for b in file.get("branches", []):
            old = sides.get(tuple(b[:4]), (0, 0))
            sides[tuple(b[:4])] = (old[0] + b[4], old[1] + b[5])


def is_brace(text):
    """Whether a line is no code: a brace alone (one behind a return never runs), or a constant's definition."""
    return text.strip() in ("{", "}") or re.fullmatch(r"#define \w+ \w+", text.strip()) is not None


def look_at(counts, path, source):
    """(lines that ran, lines, sides that ran, sides) of a file, and [(line, what)] of those that did not."""
    # A function that nobody calls counts as a whole, with what is left out of it elsewhere.
    lines = {line: count for line, count in counts.lines[path].items()
             if (count or line not in counts.skipped[path]) and not is_brace(source[line - 1])}
    missing = []
    last, ran = 0, True
    for line, count in sorted(lines.items()):
        if not count and (ran or not all(is_brace(text) for text in source[last:line - 1])):
            missing.append((line, NEVER))  # lines in a row that never run are one
        last, ran = line, count > 0
    sides = done = 0
    for (line, column, _, last), (yes, no) in sorted(counts.branches.get(path, {}).items()):
        text = source[line - 1][column - 1:last - 1]
        # A constant is known when it is compiled: one side is not there.
        if re.fullmatch(r"!?[A-Z][A-Z0-9_]+( == [0-9]+)?", text):
            continue
        sides += 2
        done += (yes > 0) + (no > 0)
        if lines.get(line) != 0:
            missing += [(line, f"`{text}` is never {side}")
                        for side, count in (("true", yes), ("false", no)) if not count]
    return (sum(1 for c in lines.values() if c), len(lines), done, sides), sorted(missing)


def read_allowed(path):
    """`FILE :: LINE :: WHAT :: REASON`; blank lines and # apart."""
    allowed = []
    for number, line in enumerate(open(path), 1):
        if not line.strip() or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split(" :: ")]
        if len(parts) != 4 or not all(parts):
            sys.exit(f"{path}:{number}: not FILE :: LINE :: WHAT :: REASON")
        allowed.append({"key": tuple(parts[:3]), "at": f"{path}:{number}", "met": False})
    return allowed


def take(allowed, path, line, what):
    """Whether an entry allows it. Each allows one place, or all of a file."""
    for entry in allowed:
        file, text, side = entry["key"]
        if file == path and (text == "*" or ((text, side) == (line, what) and not entry["met"])):
            entry["met"] = True
            return True
    return False


def useless(entry):
    """Why an entry that allows nothing does not."""
    file, text, what = entry["key"]
    if not os.path.exists(file):
        return f"{file} is not there"
    if text != "*" and text not in [line.strip() for line in open(file)]:
        return f"{file} has no line `{text}`"
    return f"{file}: nothing is unreached there: {text}: {what}"


def main():
    build, allowed_path = sys.argv[1:3]
    root = os.getcwd()
    counts = Counts()
    names = sorted(os.path.basename(p) for p in glob.glob(f"{build}/tests/test_*") if not p.endswith(".log"))
    for name in names:
        for file in export(build, name, root):
            counts.add(name, os.path.relpath(file["filename"], root), file)
    if not counts.lines:
        sys.exit("coverage: no program was run")
    with open(f"{build}/lines.tsv", "w") as out:
        for (path, line), tests in sorted(counts.reached_by.items()):
            out.write(f"{path}\t{line}\t{' '.join(tests)}\n")

    allowed = read_allowed(allowed_path)
    findings = []
    table = []
    total = {"core": [0] * 4, "port": [0] * 4, "all": [0] * 4}
    for path in sorted(counts.lines):
        source = open(path).read().split("\n")
        figures, missing = look_at(counts, path, source)
        table.append((path, figures))
        for part in (path.split("/")[0], "all"):
            total[part] = [a + b for a, b in zip(total[part], figures)]
        for line, what in missing:
            text = source[line - 1].strip()
            if not take(allowed, path, text, what):
                findings.append(f"{path}:{line}: {text} :: {what}")
    width = max(len(path) for path, _ in table)
    print(f"{'file':{width}}       lines              branches")
    for path, (ran, lines, done, sides) in table + sorted(total.items(), key=lambda t: len(t[0]), reverse=True):
        share = f"{100 * ran / lines:6.2f} %" if lines else ""
        part = f"{100 * done / sides:6.2f} %" if sides else ""
        print(f"{path:{width}} {ran:5} of {lines:5} {share:>9} {done:5} of {sides:5} {part:>9}")
    findings += [f"{entry['at']}: {useless(entry)}" for entry in allowed if not entry["met"]]
    print("\n".join(findings))
    for part in ("core", "port"):
        ran, lines, done, sides = total[part]
        print(f"coverage of {part}: {ran} of {lines} lines ({100 * ran / max(lines, 1):.2f} %), "
              f"{done} of {sides} sides of branches ({100 * done / max(sides, 1):.2f} %)")
    print(f"coverage: {len(allowed)} exceptions in {allowed_path}, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
