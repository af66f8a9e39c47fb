# SPDX-License-Identifier: MIT
"""Which lines and branches of core and port the plain tests reach; called by `make coverage`.

    coverage.py BUILD ALLOWED

BUILD has the test programs, instrumented by clang, and in raw/ what each of them counted. ALLOWED lists what may
stay unreached, with reasons. Prints a table, leaves BUILD/lines.tsv (which test reaches which line, for
`make mutate`) and ends with 1 where something is unreached that is not listed, or listed and reached.
"""
import glob
import json
import os
import subprocess
import sys


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


def export(build, name, root):
    """The coverage of one test program, and of the command that it may have run."""
    raw = glob.glob(f"{build}/raw/{name}-*.profraw")
    if not raw:
        return []
    data = f"{build}/raw/{name}.profdata"
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", data] + raw, check=True)
    command = ["llvm-cov", "export", "-skip-expansions", "-skip-functions", f"-instr-profile={data}",
               f"{build}/tests/{name}", "-object", f"{build}/qtri"]
    text = subprocess.run(command, check=True, capture_output=True).stdout
    return [f for d in json.loads(text)["data"] for f in d["files"]
            if os.path.relpath(f["filename"], root).startswith(("core/", "port/"))]


def read_allowed(path):
    """`FILE: TEXT OF THE LINE: REASON`, blank lines and # apart; text that stands in a line, or `*` for the file."""
    allowed = []
    for number, line in enumerate(open(path), 1):
        line = line.rstrip("\n")
        if not line.strip() or line.startswith("#"):
            continue
        parts = line.split(" | ")
        if len(parts) != 3 or not parts[2].strip():
            sys.exit(f"{path}:{number}: not FILE | TEXT | REASON")
        allowed.append({"file": parts[0].strip(), "text": parts[1].strip(), "number": number, "met": False})
    return allowed


def main():
    build, allowed_path = sys.argv[1:3]
    root = os.getcwd()
    lines, branches, reached_by = {}, {}, {}
    names = sorted(os.path.basename(p) for p in glob.glob(f"{build}/tests/test_*") if not p.endswith(".log"))
    for name in names:
        for file in export(build, name, root):
            path = os.path.relpath(file["filename"], root)
            of_file = lines.setdefault(path, {})
            for line, count in lines_of(file["segments"]).items():
                of_file[line] = of_file.get(line, 0) + count
                if count:
                    reached_by.setdefault((path, line), []).append(name)
            for b in file.get("branches", []):
                key = (b[0], b[1], b[2], b[3])
                old = branches.setdefault(path, {}).get(key, (0, 0))
                branches[path][key] = (old[0] + b[4], old[1] + b[5])
    if not lines:
        sys.exit("coverage: no program was run")
    with open(f"{build}/lines.tsv", "w") as out:
        for (path, line), tests in sorted(reached_by.items()):
            out.write(f"{path}\t{line}\t{' '.join(tests)}\n")

    allowed = read_allowed(allowed_path)
    findings = []
    table = []
    total = [0, 0, 0, 0]
    for path in sorted(lines):
        source = open(path).read().split("\n")
        missing = {}
        for line, count in sorted(lines[path].items()):
            if not count:
                missing[line] = ["never runs"]
        sides = done = 0
        for (line, column, _, last), (yes, no) in sorted(branches.get(path, {}).items()):
            # A condition that the compiler knows, `while (0)` and the like, has no counts.
            sides += 2
            done += (yes > 0) + (no > 0)
            if line in missing and missing[line][0] == "never runs":
                continue
            text = source[line - 1][column - 1:last - 1]
            if not yes:
                missing.setdefault(line, []).append(f"`{text}` is never true")
            if not no:
                missing.setdefault(line, []).append(f"`{text}` is never false")
        ran = sum(1 for c in lines[path].values() if c)
        table.append((path, ran, len(lines[path]), done, sides))
        for i, n in enumerate((ran, len(lines[path]), done, sides)):
            total[i] += n
        for line, what in sorted(missing.items()):
            match = [a for a in allowed if a["file"] == path and (a["text"] == "*" or a["text"] in source[line - 1])]
            for a in match:
                a["met"] = True
            if not match:
                findings.append(f"{path}:{line}: {'; '.join(what)}: {source[line - 1].strip()}")
    width = max(len(t[0]) for t in table)
    print(f"{'file':{width}}       lines              branches")
    for path, ran, all_lines, done, sides in table + [("all", *total)]:
        share = f"{100 * ran / all_lines:6.2f} %" if all_lines else ""
        part = f"{100 * done / sides:6.2f} %" if sides else ""
        print(f"{path:{width}} {ran:5} of {all_lines:5} {share:>9} {done:5} of {sides:5} {part:>9}")
    for a in allowed:
        if not a["met"]:
            findings.append(f"{allowed_path}:{a['number']}: nothing is unreached there: {a['file']}: {a['text']}")
    for finding in findings:
        print(finding)
    print(f"coverage: {total[0]} of {total[1]} lines, {total[2]} of {total[3]} sides of branches; "
          f"{len(allowed)} exceptions in {allowed_path}, {len(findings)} findings")
    return 1 if findings else 0


sys.exit(main())
