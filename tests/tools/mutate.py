# SPDX-License-Identifier: MIT
"""Changes operators and constants of core, one at a time, and reports what no test notices; called by `make mutate`.

    mutate.py BUILD COUNT SEED [FILE...]

Of all changes COUNT are drawn at random. For each, the file is compiled again, and those test programs run that
reach the line (BUILD/coverage/lines.tsv, by `make coverage`) or are newer than that, the quickest first, until one fails. A change that
leaves the object as it was is no mutant. BUILD/mutants.tsv has a line for each. Survivors that
tests/mutants.equivalent explains, `FILE | LINE'S TEXT | CHANGE | REASON`, are told apart.
"""
import filecmp
import glob
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import time

FLAGS = "-std=c99 -O1 -fPIC -w".split()

# In code as clang-format writes it, binary operators stand between blanks.
SWAPS = [(" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
         (" + ", " - "), (" - ", " + "), (" * ", " + "), (" / ", " * "), (" % ", " / "), (" << ", " >> "),
         (" >> ", " << "), (" & ", " | "), (" | ", " & "), (" ^ ", " | "), (" && ", " || "), (" || ", " && "),
         (" += ", " -= "), (" -= ", " += "), (" |= ", " &= "), (" &= ", " |= "), (" >>= ", " <<= "),
         ("++", "--"), ("--", "++"), ("true", "false"), ("false", "true"), ("!", "")]
NUMBER = re.compile(r"(?<![\w.])(0[xX][0-9a-fA-F]+|\d+)([uUlL]*)(?![\w.])")


def blank_comments(text):
    """The same length, without comments, strings and directives."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\n])*\"|'(?:\\.|[^'\n])*'", blank, text, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, text, flags=re.M)


def sites(path):
    """(offset, old, new) of every change."""
    code = blank_comments(open(path).read())
    found = []
    for old, new in SWAPS:
        at = code.find(old)
        while at >= 0:
            around = code[max(0, at - 1):at + len(old) + 1]
            word = old.isalpha() and re.search(r"\w" + old + r"|" + old + r"\w", around)
            if not word and not (old == "!" and around.endswith("=")):
                found.append((at, old, new))
            at = code.find(old, at + len(old))
    for match in NUMBER.finditer(code):
        digits, suffix = match.groups()
        if re.search(r"\b(include|enum)\b[^;]*$", code[max(0, match.start() - 40):match.start()]):
            continue
        value = int(digits, 0)
        for other in {value + 1, value - 1 if value > 0 else value + 1}:
            text = (hex(other) if digits[:2] in ("0x", "0X") else str(other)) + suffix
            found.append((match.start(), match.group(0), text))
    return found


class Bench:
    def __init__(self, build):
        self.root = os.getcwd()
        self.build = build
        self.here = f"{build}/mutate"
        self.src = f"{self.here}/src"
        shutil.rmtree(self.src, ignore_errors=True)
        os.makedirs(f"{self.here}/obj", exist_ok=True)
        os.makedirs(f"{self.here}/tests", exist_ok=True)
        os.makedirs(f"{self.here}/tmp", exist_ok=True)
        for folder in ("core", "port/include", "port/panels"):
            shutil.copytree(folder, f"{self.src}/{folder}")
        self.files = sorted(glob.glob("core/*/*.c") + glob.glob("port/panels/*.c"))
        self.needs = {}
        for file in self.files:
            made = subprocess.run(["gcc", "-MM", "-Icore/include", "-Iport/include", file], capture_output=True,
                                  text=True, check=True).stdout
            for name in made.replace("\\\n", " ").split()[1:]:
                self.needs.setdefault(os.path.normpath(name), []).append(file)
        for file in self.files:
            out = self.object(file)
            if not (os.path.exists(out) and all(os.path.getmtime(n) < os.path.getmtime(out)
                                                for n, by in self.needs.items() if file in by)):
                self.compile(file, out)
        self.library = f"{self.here}/libqtri.so"
        self.link()
        self.programs = self.link_tests()
        self.reach = {}
        self.reach_file = {}
        seen = set()
        for line in open(f"{build}/coverage/lines.tsv"):
            path, number, tests = line.rstrip("\n").split("\t")
            self.reach[path, int(number)] = tests.split()
            self.reach_file.setdefault(path, set()).update(tests.split())
            seen.update(tests.split())
        self.new = [name for name in self.programs if name not in seen]
        self.environment = dict(os.environ, QTRI_TMP=os.path.abspath(f"{self.here}/tmp"), MALLOC_PERTURB_="165",
                                QTRI_COMMAND=os.path.abspath(f"{self.here}/qtri"))

    def object(self, file):
        return f"{self.here}/obj/" + file.replace("/", "+")[:-2] + ".o"

    def compile(self, file, out):
        return subprocess.run(["gcc"] + FLAGS + [f"-I{self.src}/core/include", f"-I{self.src}/port/include", "-c",
                              "-o", out, f"{self.src}/{file}"], stderr=subprocess.DEVNULL).returncode == 0

    def link(self, changed=None):
        objects = [(changed or {}).get(f, self.object(f)) for f in self.files]
        return subprocess.run(["gcc", "-shared", "-o", self.library] + objects,
                              stderr=subprocess.DEVNULL).returncode == 0

    def link_tests(self):
        names = []
        end = [f"{self.build}/libqtri-host.a", self.library, f"-Wl,-rpath,{os.path.abspath(self.here)}"]
        end += os.environ.get("HOST_LIBS", "").split()
        subprocess.run(["gcc", "-o", f"{self.here}/qtri", f"{self.build}/obj/host/tools/main.o"] + end + ["-lm"],
                       check=True)
        for source in sorted(glob.glob("tests/test_*.c")):
            name = os.path.basename(source)[:-2]
            command = ["gcc", "-o", f"{self.here}/tests/{name}", f"{self.build}/obj/tests/{name}.o"]
            command += [f"{self.build}/libqtri-verify.a"] if name == "test_verify_math" else []
            command += [f"{self.build}/libqtri-test.a"] + end + ["-lcmocka", "-lmpfr", "-lgmp", "-lm", "-pthread"]
            program = command[2]
            own = f"{self.build}/obj/tests/{name}.o"
            if os.path.exists(program) and os.path.getmtime(program) > os.path.getmtime(own):
                names.append(name)
            elif subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0:
                names.append(name)
            else:
                print(f"mutate: {name} is linked of more than the others, and is left out", flush=True)
        return names

    def run(self, name, seconds):
        """(passed, seconds of CPU)"""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            status = subprocess.run([f"{self.here}/tests/{name}"], stdin=subprocess.DEVNULL, preexec_fn=limit,
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=self.environment,
                                    timeout=40 * seconds).returncode
        except subprocess.TimeoutExpired:
            status = -1
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return status == 0, after.ru_utime - before.ru_utime

    def judge(self, path, change):
        """None: no mutant. Else what happened."""
        at, old, new = change
        text = open(path).read()
        with open(f"{self.src}/{path}", "w") as out:
            out.write(text[:at] + new + text[at + len(old):])
        try:
            changed = {}
            for file in self.needs.get(path, []):
                out = f"{self.here}/changed-{len(changed)}.o"
                if not self.compile(file, out):
                    return None
                if not filecmp.cmp(out, self.object(file), shallow=False):
                    changed[file] = out
            if not changed or not self.link(changed):
                return None
        finally:
            shutil.copyfile(path, f"{self.src}/{path}")
        line = text.count("\n", 0, at) + 1
        tests = self.reach.get((path, line)) or self.reach_file.get(path) or self.programs
        for name in sorted((t for t in set(tests) | set(self.new) if t in self.seconds), key=self.seconds.get):
            passed, _ = self.run(name, int(4 * self.seconds[name]) + 3)
            if not passed:
                return name
        return "survived"

    def measure(self):
        self.seconds = {}
        for name in self.programs:
            passed, seconds = self.run(name, 120)
            if passed:
                self.seconds[name] = seconds
            else:
                print(f"mutate: {name} fails without a change here, and is left out", flush=True)


def main():
    build, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    files = sys.argv[4:] or sorted(glob.glob("core/*/*.[ch]"))
    bench = Bench(build)
    bench.measure()
    everything = [(f, s) for f in files if bench.needs.get(f) for s in sites(f)]
    random.Random(seed).shuffle(everything)
    explained = []
    if os.path.exists("tests/mutants.equivalent"):
        explained = [[p.strip() for p in l.split(" | ")] for l in open("tests/mutants.equivalent")
                     if l.strip() and not l.startswith("#")]
    tried = killed = known = 0
    start = last = time.time()
    survivors = []
    with open(f"{build}/mutants.tsv", "w") as table:
        for path, change in everything:
            if tried == count:
                break
            result = bench.judge(path, change)
            if result is None:
                continue
            tried += 1
            text = open(path).read()
            line = text.count("\n", 0, change[0]) + 1
            source = text.split("\n")[line - 1].strip()
            column = change[0] - text.rfind("\n", 0, change[0])
            what = f"{change[1].strip()} -> {change[2].strip() or 'nothing'}"
            table.write(f"{path}\t{line}\t{column}\t{what}\t{result}\t{source}\n")
            table.flush()
            if result != "survived":
                killed += 1
            elif any(e[0] == path and e[1] in source and e[2] == what for e in explained):
                known += 1
            else:
                survivors.append(f"{path}:{line}:{column}: {what}: {source}")
                print(survivors[-1], flush=True)
            if time.time() - last > 25:
                last = time.time()
                print(f"mutate: {tried} of {count}, {killed} noticed, {time.time() - start:.0f} s", flush=True)
    bench.link()
    print(f"mutate: of {tried} mutants (seed {seed}, {len(everything)} possible) {killed} were noticed, {known} are "
          f"explained in tests/mutants.equivalent, {len(survivors)} survived: {build}/mutants.tsv")
    return 1 if 50 * len(survivors) > tried else 0


sys.exit(main())
