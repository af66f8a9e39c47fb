# SPDX-License-Identifier: MIT
"""Changes operators and constants of core, one at a time, and reports what no test notices; called by `make mutate`.

    mutate.py BUILD COUNT SEED [again]

Of all changes COUNT are drawn at random; `again` takes instead those that survived in BUILD/mutants.tsv and are not
explained. Most are compiled together: each is an expression that is the changed one where the environment's
QTRI_MUTANT has its number (mutants.py). Changes that overlap, and those in constants of the compiler, are in libraries
of their own. One run of all tests says for which tests a changed expression has another value at all; those run for
that change, the ones that are likely to notice it quickly first, until one fails, crashes or takes ten times as long.
Code that this machine leaves out is judged by the tests of core in a narrow build (core/bits/bits.h). What survives is
judged once more by the quickest of its tests of core under the sanitizers, which `make test` runs as well: they see a
bound that is off by one.

Not among the changes are those that are none wherever they stand: room for one more in an array whose size nothing asks
for, and < for <= where the greater or the lesser of two is chosen (mutants.py).

Settings, by environment: HUNT=30 draws 30 times as many random pictures and values as tests/pictures.tsv records, for
each survivor, and says which differ from those without it: BUILD/hunt.tsv. None is a hint that the change makes no
difference, no proof. BUDGET=20 ends the tests of a mutant after so many seconds, WIDE=1 leaves the narrow build out,
FILES="core/paint/*.c core/raster/cover.h" draws from these files alone (a COUNT of 99999: all that they have). A change
that leaves the objects as they were, as gcc -O2, gcc -O3 or clang -O2 makes them, is no mutant. BUILD/mutants.tsv has a
line for each mutant. Survivors that tests/mutants.equivalent explains, `FILE | LINE'S TEXT | CHANGE | REASON`, are told
apart; the CHANGE `0 -> 1 at 26` is that in column 26 of the text.
"""
import concurrent.futures
import filecmp
import glob
import os
import queue
import random
import re
import resource
import shutil
import subprocess
import sys
import threading
import time

from mutants import Source, check

FLAGS = "-std=c99 -O1 -fPIC -fwrapv -w -Werror=vla".split()
NARROW = ["-DQTRI_LONG_MULTIPLY=0", "-DQTRI_DIVIDE=0"]
SANITIZE = "-fno-wrapv -g -fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=address,undefined".split()
# Of two that behave differently no compiler makes the same, unless one is undefined: what the sanitizers see before.
OTHERS = [("gcc", ["-O3"]), ("clang", ["-O2"])]
RECORDED = ["test_core_corpus", "test_core_values", "test_core_pictures"]
JOBS = int(os.environ.get("JOBS") or 2)

# What says which mutant runs, and notes which expressions would have had another value: in memory that the processes
# of a test share. A failed assertion ends the program at once.
SWITCH = """
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
int qtri_mutant = -1;
unsigned char *qtri_seen;
__attribute__((constructor(101))) static void choose(void)
{
    const char *mutant = getenv("QTRI_MUTANT");
    qtri_mutant = mutant != NULL ? atoi(mutant) : -1;
    if (qtri_mutant == 0) {
        const int file = open(getenv("QTRI_SEEN"), O_RDWR);
        qtri_seen = mmap(NULL, 1 << 16, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
    }
}
void _fail(const char *file, int line);
void _fail(const char *file, int line)
{
    _exit(1);
}
"""
DECLARED = "extern int qtri_mutant; extern unsigned char *qtri_seen;\n#line 1\n"


class Mutant:
    def __init__(self, source, change):
        self.source, self.change, self.path = source, change, source.path
        at, old, new = change
        self.line = source.text.count("\n", 0, at) + 1
        self.column = at - source.text.rfind("\n", 0, at)
        self.text = source.text.split("\n")[self.line - 1].strip()
        self.what = f"{old} -> {new or 'nothing'}"
        self.layer = None  # of a library of many; None: alone
        self.tests = None  # those for which it makes a difference where it stands
        self.result = None

    def at_column(self):
        """In the text of the line, from 0."""
        line = self.source.text.split("\n")[self.line - 1]
        return self.column - (len(line) - len(line.lstrip())) - 1

    def at(self):
        return f"{self.what} at {self.at_column() + 1}"


def parallel(function, items):
    with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
        return list(pool.map(function, items))


class Build:
    """Core, port, tests and their helpers as compiled with some flags, and copies of the sources to change."""

    def __init__(self, build, name, flags):
        self.build, self.here, self.flags = build, f"{build}/mutate/{name}", FLAGS + flags
        self.link_flags = [f for f in flags if f.startswith("-fsanitize")]
        self.src = f"{self.here}/src"
        shutil.rmtree(self.src, ignore_errors=True)
        os.makedirs(f"{self.here}/obj", exist_ok=True)
        for folder in ("core", "port/include", "port/panels", "tests", "host"):
            shutil.copytree(folder, f"{self.src}/{folder}")
        self.library = sorted(glob.glob("core/*/*.c") + glob.glob("port/panels/*.c"))
        self.helpers = sorted(glob.glob("tests/support/*.c"))
        self.tests = sorted(glob.glob("tests/test_core_*.c"))
        # Of those with pipelines of their own all but test_pipeline_random, whose pipelines are made.
        more = glob.glob("tests/test_scene_*.c") + glob.glob("tests/test_pipeline_[!r]*.c")
        self.tests += [] if flags else sorted(more + ["tests/test_verify_math.c"])
        self.needs = {}
        for file, names in zip(self.library + self.helpers + self.tests,
                               parallel(self.read_needs, self.library + self.helpers + self.tests)):
            for name in names:
                self.needs.setdefault(name, []).append(file)
        self.with_flags = bool(flags)
        parallel(lambda f: self.compile(f, self.object(f)), [f for f in self.library if self.is_old(f)])
        subprocess.run(["gcc", "-w", "-O1", "-fPIC", "-c", "-x", "c", "-o", f"{self.here}/switch.o", "-"],
                       input=SWITCH.encode(), check=True)

    def includes(self, src):
        return [f"-I{src}core/include", f"-I{src}port/include"]

    def own_includes(self, file, src):
        return [f"-I{src}core", f"-I{src}host"] if file.startswith("tests/") else []

    def read_needs(self, file):
        made = subprocess.run(["gcc", "-MM", "-w"] + self.flags + self.includes("") + self.own_includes(file, "") +
                              [file], capture_output=True, text=True, check=True).stdout
        return {os.path.normpath(n) for n in made.replace("\\\n", " ").split()[1:]}

    def object(self, file):
        if file.startswith("tests/") and not self.with_flags:
            return f"{self.build}/obj/{file[:-2]}.o"
        return f"{self.here}/obj/" + file.replace("/", "+")[:-2] + ".o"

    def is_old(self, file):
        out = self.object(file)
        return not (os.path.exists(out) and all(os.path.getmtime(n) < os.path.getmtime(out)
                                                for n, by in self.needs.items() if file in by))

    def compile(self, file, out, flags=(), compiler="gcc"):
        """What the compiler complains of, or nothing."""
        src = self.src + "/"
        return subprocess.run([compiler] + self.flags + list(flags) + self.includes(src) +
                              self.own_includes(file, src) + ["-c", "-o", out, src + file],
                              capture_output=True, text=True).stderr

    def users(self, paths):
        return sorted({file for path in paths for file in self.needs.get(path, [])})

    def link_library(self, out, changed):
        objects = [changed.get(f, self.object(f)) for f in self.library] + [f"{self.here}/switch.o"]
        return subprocess.run(["gcc", "-shared", "-Wl,-soname,libqtri.so", "-o", out] + self.link_flags + objects,
                              stderr=subprocess.DEVNULL).returncode == 0

    def link_ends(self):
        return ([f"{self.build}/libqtri-host.a", f"{self.here}/base/libqtri.so"] +
                os.environ.get("HOST_LIBS", "").split())

    def link_test(self, folder, file, changed):
        """Its name, or None."""
        name = os.path.basename(file)[:-2]
        command = ["gcc", "-o", f"{folder}/{name}", changed.get(file, self.object(file))] + self.link_flags
        command += [changed.get(f, self.object(f)) for f in self.helpers]
        command += [f"{self.build}/libqtri-verify.a"] if name == "test_verify_math" else []
        command += self.link_ends() + ["-lcmocka", "-lmpfr", "-lgmp", "-lm", "-pthread"]
        return name if subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0 else None

    def link_tests(self, folder, changed):
        """Programs in `folder`, or those of folder `base` where none of theirs changed."""
        os.makedirs(folder, exist_ok=True)
        names = parallel(lambda file: self.link_test(folder, file, changed), self.tests)
        subprocess.run(["gcc", "-o", f"{folder}/qtri", f"{self.build}/obj/host/tools/main.o"] + self.link_ends() +
                       ["-lm"], check=True)
        return [name for name in names if name]

    def link_base(self):
        if self.with_flags:
            own = self.helpers + self.tests
            parallel(lambda f: self.compile(f, self.object(f)), [f for f in own if self.is_old(f)])
        os.makedirs(f"{self.here}/base", exist_ok=True)
        self.link_library(f"{self.here}/base/libqtri.so", {})
        self.names = self.link_tests(f"{self.here}/base", {})


class Layer:
    """A library of many mutants that do not overlap."""

    def __init__(self, number):
        self.number = number
        self.mutants = []
        self.taken = {}

    def take(self, mutant, schema):
        begin, end, text = schema
        taken = self.taken.setdefault(mutant.path, [])
        if any(begin < b[1] and b[0] < end for b in taken):
            return False
        taken.append((begin, end, text, mutant))
        mutant.layer = self
        self.mutants.append(mutant)
        return True

    def drop(self, mutant):
        self.taken[mutant.path] = [t for t in self.taken[mutant.path] if t[3] is not mutant]
        self.mutants.remove(mutant)
        mutant.layer = None

    def write(self, bench):
        for path, taken in self.taken.items():
            text = open(path).read()
            for begin, end, new, _ in sorted(taken, key=lambda t: t[0], reverse=True):
                old = text[begin:end]  # as many lines: the compiler's complaints are told by line
                line = "\\\n" if "\\\n" in old else "\n"
                text = text[:begin] + new + line * (old.count("\n") - new.count("\n")) + text[end:]
            with open(f"{bench.src}/{path}", "w") as out:
                out.write((DECLARED if taken else "") + text)

    def make(self, bench):
        """Compiles it. What the compiler takes only as a constant is left out."""
        self.folder = f"{bench.here}/layer-{self.number}"
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)
        self.changed = {f: f"{self.folder}/" + f.replace("/", "+")[:-2] + ".o" for f in bench.users(self.taken)}
        todo = list(self.changed)
        while todo:
            self.write(bench)
            failed, broken = {}, []
            for file, errors in zip(todo, parallel(lambda f: bench.compile(f, "-", flags=["-fsyntax-only"]), todo)):
                for path, line in re.findall(r"^(\S+?):(\d+):\d+: (?:error|note: in \w+ of macro)", errors, flags=re.M):
                    path = os.path.relpath(os.path.normpath(path), bench.src) if bench.src in path else path
                    failed.setdefault(path, set()).add(int(line))
                broken += [file] if errors else []
            wrong = [t for path, lines in failed.items() for t in self.taken.get(path, []) if any(
                t[3].source.text.count("\n", 0, t[0]) + 1 <= l <= t[3].source.text.count("\n", 0, t[1]) + 1
                for l in lines)]
            if broken and not wrong:
                sys.exit(f"mutate: {broken} {failed}")
            for t in wrong:
                self.drop(t[3])
            todo = sorted(set(bench.users({t[3].path for t in wrong}) + broken) & set(self.changed))
        for file, errors in zip(self.changed, parallel(lambda f: bench.compile(f, self.changed[f]), self.changed)):
            if errors:
                sys.exit(f"mutate: {file}: {errors}")
        for path in self.taken:
            shutil.copyfile(path, f"{bench.src}/{path}")
        print(f"mutate: {len(self.mutants)} compiled in {len(self.changed)} files", flush=True)
        bench.link_library(f"{self.folder}/libqtri.so", self.changed)
        self.programs = f"{bench.here}/base"
        if any(f.startswith("tests/") for f in self.changed):
            self.programs = f"{self.folder}/tests"
            bench.link_tests(self.programs, self.changed)
        # What only this copy of code for narrow cores has is judged in the narrow build: no test here draws by it.
        listed = "".join(subprocess.run(["nm", out], capture_output=True, text=True).stdout
                         for file, out in self.changed.items() if file != "tests/support/small_narrow.c")
        there = {int(n) for n in re.findall(r"qtri_site_(\d+)", listed)}
        return [m for m in self.mutants if m.number not in there]


class Runs:
    """Test programs, their times, and what each has noticed."""

    def __init__(self, bench):
        self.bench, self.seconds, self.noticed, self.tried, self.failed = bench, {}, {}, {}, set()
        self.places = queue.Queue()
        for i in range(JOBS):
            os.makedirs(f"{bench.here}/tmp-{i}", exist_ok=True)
            self.places.put(os.path.abspath(f"{bench.here}/tmp-{i}"))

    def run(self, name, library, programs, mutant, seen=None, more=()):
        """(passed, seconds of a processor)"""
        limit = int(10 * self.seconds.get(name, 12)) + 2

        def limits():
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            if not self.bench.link_flags:  # a sanitizer maps more
                resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
        place = self.places.get()
        environment = dict(os.environ, QTRI_TMP=place, MALLOC_PERTURB_="165", CMOCKA_MESSAGE_OUTPUT="TAP",
                           ASAN_OPTIONS="detect_leaks=0",
                           QTRI_COMMAND=os.path.abspath(f"{programs}/qtri"), QTRI_MUTANT=str(mutant),
                           LD_LIBRARY_PATH=os.path.abspath(library))
        environment.update(more)
        if seen:
            environment["QTRI_SEEN"] = seen
        program = subprocess.Popen([f"{programs}/{name}"], stdin=subprocess.DEVNULL, preexec_fn=limits,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
        hangs = threading.Timer(20 * limit, program.kill)
        hangs.start()
        _, status, used = os.wait4(program.pid, 0)
        program.returncode = status
        hangs.cancel()
        self.places.put(place)
        return status == 0, used.ru_utime + used.ru_stime

    def look(self, layer, names):
        """For which of these tests each mutant of a layer makes a difference where it stands; how long they take."""
        def one(name):
            seen = os.path.abspath(f"{self.bench.here}/seen-{name}")
            with open(seen, "wb") as out:
                out.write(bytes(1 << 16))
            passed, seconds = self.run(name, layer.folder, layer.programs, 0, seen)
            with open(seen, "rb") as file:
                return name, passed, seconds, file.read()
        for m in layer.mutants:
            m.tests = []
        for name, passed, seconds, seen in parallel(one, [n for n in names if n not in self.failed]):
            if not passed:
                print(f"mutate: {name} fails without a change here, and is left out", flush=True)
                self.failed.add(name)
                continue
            self.seconds.setdefault(name, seconds)
            for m in layer.mutants:
                if seen[m.number]:
                    m.tests.append(name)

    def judge(self, mutant, library, programs, number):
        """The test that notices it first, or "survived"."""
        names = list(self.seconds) if mutant.tests is None else mutant.tests
        folder = mutant.path

        def cost(name):
            for_all = self.noticed.get(name, 0) / (1 + self.tried.get(name, 0))
            here = (self.noticed.get((name, folder), 0) + for_all + .05) / (1 + self.tried.get((name, folder), 0))
            return (self.seconds[name] + .01) / here
        end = time.time() + float(os.environ.get("BUDGET") or 1e9)
        for name in sorted(names, key=cost):
            if time.time() > end:
                break
            passed, _ = self.run(name, library, programs, number)
            for key in (name, (name, folder)):
                self.tried[key] = self.tried.get(key, 0) + 1
                self.noticed[key] = self.noticed.get(key, 0) + (not passed)
            if not passed:
                return name
        return "survived"


class Hunt:
    """Looks for a random picture or value that a survivor makes otherwise.

    A run that notes which expressions would have had another value draws what is usual at the same time: of a seed and
    a program, only those survivors run that differ there, each for BUDGET seconds. What `make test` draws says nothing
    of other seeds."""

    def __init__(self, rounds, folder):
        self.rounds, self.folder, self.found, self.differed, self.spent = rounds, folder, {}, {}, {}
        self.budget = float(os.environ.get("BUDGET") or 1e9)

    def lines(self, runs, name, library, programs, number, seed):
        """(what it records, whether each mutant would have differed)"""
        out, seen = (os.path.abspath(f"{self.folder}/hunt-{kind}-{name}") for kind in ("lines", "seen"))
        with open(out, "w"), open(seen, "wb") as file:
            file.write(bytes(1 << 16))
        runs.run(name, library, programs, number, seen, {"QTRI_RECORD": out, "QTRI_SEED": str(seed)})
        with open(out) as lines, open(seen, "rb") as file:
            return lines.read().split("\n"), file.read()

    def is_left(self, mutant):
        return mutant not in self.found and self.spent.get(mutant, 0) < self.budget

    def compare(self, mutant, usual, runs, library, programs, name, seed):
        start = time.time()
        lines, _ = self.lines(runs, name, library, programs, mutant.number if mutant.layer else -1, seed)
        self.spent[mutant] = self.spent.get(mutant, 0) + time.time() - start
        self.differed[mutant] = self.differed.get(mutant, 0) + 1
        if lines != usual:
            differ = [a for a, b in zip(usual, lines + [""] * 999) if a != b]
            self.found[mutant] = f"{name} {seed}: {differ[0].split(chr(9))[0] if differ else 'end'}"
            print(f"mutate: {mutant.path}:{mutant.line}: {mutant.what}: {self.found[mutant]}", flush=True)

    def all(self):
        """Each seed of each program."""
        return [(seed, name) for seed in range(1, self.rounds + 1) for name in RECORDED]

    def in_layer(self, runs, layer, mutants):
        for seed, name in self.all():
            left = [m for m in mutants if self.is_left(m)]
            if not left:
                return
            usual, seen = self.lines(runs, name, layer.folder, layer.programs, 0, seed)
            for m in left:
                if seen[m.number]:
                    self.compare(m, usual, runs, layer.folder, layer.programs, name, seed)

    def by_itself(self, judge, mutant):
        """A library of its own: nothing says where it differs."""
        library, base = build_alone(judge.bench, mutant), f"{judge.bench.here}/base"
        for seed, name in self.all() if library else []:
            if self.is_left(mutant):
                usual, _ = self.lines(judge.runs, name, base, base, -1, seed)
                self.compare(mutant, usual, judge.runs, library, base, name, seed)

    def find(self, judges, mutants):
        """What is found, or in how many runs nothing is, by mutant. One after the other: they share files."""
        layers = {}
        for m in mutants:
            if self.rounds and m.layer is not None:
                layers.setdefault(m.layer, []).append(m)
        for layer, of_layer in layers.items():
            self.in_layer(judges[of_layer[0].number].runs, layer, of_layer)
        for m in mutants:
            if self.rounds and m.layer is None:
                self.by_itself(judges[m.number], m)
        return {m: self.found.get(m, f"none of {self.differed.get(m, 0)} runs in which it differs") for m in mutants}


def same_objects(bench, mutant, flags, compiler="gcc"):
    """Whether the compiler makes the same of the changed source."""
    with open(f"{bench.src}/{mutant.path}", "w") as out:
        out.write(mutant.source.changed(mutant.change))
    try:
        for file in bench.users([mutant.path]):
            one, two = f"{bench.here}/changed.o", f"{bench.here}/unchanged.o"
            if bench.compile(file, one, flags, compiler):
                return True
            shutil.copyfile(mutant.path, f"{bench.src}/{mutant.path}")
            bench.compile(file, two, flags, compiler)
            if not filecmp.cmp(one, two, shallow=False):
                return False
            with open(f"{bench.src}/{mutant.path}", "w") as out:
                out.write(mutant.source.changed(mutant.change))
    finally:
        shutil.copyfile(mutant.path, f"{bench.src}/{mutant.path}")
    return True


def build_alone(bench, mutant):
    """A library with this one change: its folder. None where it does not compile, or is no change."""
    folder = f"{bench.here}/alone"
    os.makedirs(folder, exist_ok=True)
    with open(f"{bench.src}/{mutant.path}", "w") as out:
        out.write(mutant.source.changed(mutant.change))
    try:
        users = [f for f in bench.users([mutant.path]) if f in bench.library]
        changed = {f: f"{folder}/{i}.o" for i, f in enumerate(users)}
        if any(parallel(lambda f: bench.compile(f, changed[f]), users)):
            return None
    finally:
        shutil.copyfile(mutant.path, f"{bench.src}/{mutant.path}")
    if all(filecmp.cmp(changed[f], bench.object(f), shallow=False) for f in users):
        return None
    return folder if bench.link_library(f"{folder}/libqtri.so", changed) else None


def judge_alone(bench, runs, mutant):
    """A change of what the compiler takes only as a constant."""
    folder = build_alone(bench, mutant)
    return runs.judge(mutant, folder, f"{bench.here}/base", -1) if folder else None


def read_explained():
    if not os.path.exists("tests/mutants.equivalent"):
        return []
    return [[p.strip() for p in re.split(r"(?<!->) \| ", line)] for line in open("tests/mutants.equivalent")
            if line.strip() and not line.startswith("#")]


def is_explained(mutant, explained):
    return any(e[0] == mutant.path and e[1] in mutant.text and e[2] in (mutant.what, mutant.at()) for e in explained)


def draw(build, count, seed, again):
    """The mutants to judge, in random order; more than are asked for, as some are none."""
    files = (os.environ.get("FILES") or "core/*/*.[ch]").split()
    sources = {path: Source(path) for path in sorted(path for pattern in files for path in glob.glob(pattern))}
    if again:
        wanted = [line.rstrip("\n").split("\t") for line in open(f"{build}/mutants.tsv")]
        wanted = {(w[0], w[5], w[3]) for w in wanted if w[4] == "survived"}
        everything = [Mutant(s, c) for s in sources.values() for c in s.mutants()]
        explained = read_explained()
        return [m for m in everything if (m.path, m.text, m.what) in wanted and not is_explained(m, explained)], \
            len(everything)
    everything = [(s, c) for s in sources.values() for c in s.mutants()]
    random.Random(seed).shuffle(everything)
    return [Mutant(s, c) for s, c in everything[:count + count // 3 + 5]], len(everything)


def make_layers(bench, mutants):
    """(layers, mutants to be compiled alone, mutants in code that is left out)"""
    layers, alone, absent = [], [], []
    for mutant in mutants:
        schema = mutant.source.schema(mutant.change, mutant.number)
        if schema is None:
            alone.append(mutant)
        elif not any(layer.take(mutant, schema) for layer in layers):
            layers.append(Layer(len(layers)))
            layers[-1].take(mutant, schema)
    for layer in layers:
        before = list(layer.mutants)
        gone = layer.make(bench)
        alone += [m for m in before if m.layer is None]
        for m in gone:
            layer.mutants.remove(m)
        absent += gone
    return layers, alone, absent


class Judge:
    """Judges a list of mutants in one build."""

    def __init__(self, build, name, flags, mutants):
        self.bench = Build(build, name, flags)
        self.bench.link_base()
        self.runs = Runs(self.bench)
        self.layers, alone, self.absent = make_layers(self.bench, mutants)
        for layer in self.layers:  # of what overlaps in the first, few: by tests that reach the file
            paths = {m.path for m in layer.mutants}
            near = {t for m in mutants if m.path in paths for t in m.tests or []}
            self.runs.look(layer, sorted(near) if layer.number else self.bench.names)
        # Those that are compiled alone are judged by the tests that reach another one of the file.
        self.alone = {m.number for m in alone}
        of_file = {}
        for m in mutants:
            of_file.setdefault(m.path, set()).update(m.tests or [])
        for m in alone:
            m.tests = sorted(of_file[m.path]) or None

    def judge(self, mutant):
        if mutant.number in self.alone:
            return judge_alone(self.bench, self.runs, mutant)
        return self.runs.judge(mutant, mutant.layer.folder, mutant.layer.programs, mutant.number)


class Sanitized:
    """Judges survivors by the tests of core under the sanitizers; those are built as they are needed."""

    def __init__(self, build):
        self.bench = Build(build, "sanitized", SANITIZE)
        self.runs = Runs(self.bench)
        self.base = f"{self.bench.here}/base"
        os.makedirs(self.base, exist_ok=True)
        self.bench.link_library(f"{self.base}/libqtri.so", {})
        parallel(self.compile, self.bench.helpers)
        self.files = {os.path.basename(f)[:-2]: f for f in self.bench.tests}

    def compile(self, file):
        if self.bench.is_old(file):
            self.bench.compile(file, self.bench.object(file))

    def passes(self, name):
        """Whether the test does without a change."""
        if name not in self.runs.seconds and name not in self.runs.failed:
            self.compile(self.files[name])
            self.bench.link_test(self.base, self.files[name], {})
            passed, seconds = self.runs.run(name, self.base, self.base, -1)
            self.runs.seconds.update({name: seconds} if passed else {})
            self.runs.failed.update(set() if passed else {name})
        return name in self.runs.seconds

    def judge(self, mutant, seconds):
        """`seconds`: what tests take without sanitizers; ten of them in all."""
        names, rest = [], 10.0
        for name in sorted((mutant.tests or []), key=lambda n: seconds.get(n, 99)):
            rest -= seconds.get(name, 99)
            if rest > 0 and name in self.files and self.passes(name):
                names.append(name)
        if not names:
            return "survived"
        every, mutant.tests = mutant.tests, names
        result = judge_alone(self.bench, self.runs, mutant)
        mutant.tests = every
        return "survived" if result in (None, "survived") else f"{result} sanitized"


def main():
    check()
    build, count, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    mutants, possible = draw(build, count, seed, sys.argv[4:] == ["again"])
    for number, mutant in enumerate(mutants):
        mutant.number = number + 1
    start = time.time()

    def say(what):
        print(f"mutate: {what}, {time.time() - start:.0f} s", flush=True)
    wide = Judge(build, "wide", [], mutants)
    say(f"{len(mutants)} drawn, {len(wide.alone)} to be compiled alone, {len(wide.absent)} not compiled here")
    judges = {m.number: wide for m in mutants if m not in wide.absent}
    if wide.absent and not os.environ.get("WIDE"):
        narrow = Judge(build, "narrow", NARROW, wide.absent)
        judges.update({m.number: narrow for m in wide.absent if m not in narrow.absent})
        say(f"{len(wide.absent) - len(narrow.absent)} of them in the narrow build")

    def judge(mutant):
        if mutant.number not in judges or mutant.number in judges[mutant.number].alone:
            return
        mutant.result = judges[mutant.number].judge(mutant)
        if mutant.result == "survived":
            print(f"{mutant.path}:{mutant.line}:{mutant.column}: {mutant.what}: {mutant.text} "
                  f"(differs in {len(mutant.tests or [])} tests)", flush=True)

    last = [time.time()]

    def told(mutant):
        judge(mutant)
        if time.time() - last[0] > 25:
            last[0] = time.time()
            say(f"{sum(m.result is not None for m in mutants)} judged, "
                f"{sum(m.result == 'survived' for m in mutants)} survived")
    parallel(told, mutants)
    for m in mutants:
        if m.number in judges and m.number in judges[m.number].alone:
            m.result = judges[m.number].judge(m)
        if m.result == "survived":
            bench = judges[m.number].bench
            if same_objects(bench, m, ["-O2"]):
                m.result = None
    judged = [m for m in mutants if m.result is not None][:count]
    explained = read_explained()
    left = [m for m in judged if m.result == "survived" and not is_explained(m, explained) and m.tests]
    sanitized = Sanitized(build) if left else None
    for m in left:
        m.result = sanitized.judge(m, judges[m.number].runs.seconds)
    for m in left:
        if m.result == "survived" and any(same_objects(judges[m.number].bench, m, flags, compiler)
                                          for compiler, flags in OTHERS if shutil.which(compiler)):
            m.result = None
    judged = [m for m in judged if m.result is not None]
    hunt = Hunt(int(os.environ.get("HUNT") or 0), build)
    left = [m for m in judged if m.result == "survived" and not is_explained(m, explained)]
    found = hunt.find(judges, left)
    with open(f"{build}/hunt.tsv", "w") as table:
        for m, where in found.items():
            table.write(f"{m.path}\t{m.line}\t{m.column}\t{m.what}\t{where}\t{m.text}\n")
    known, survivors = 0, []
    with open(f"{build}/mutants.tsv", "w") as table:
        for m in judged:
            table.write(f"{m.path}\t{m.line}\t{m.column}\t{m.what}\t{m.result}\t{m.text}\n")
            if m.result != "survived":
                continue
            if is_explained(m, explained):
                known += 1
                continue
            survivors.append(m)
            print(f"survived: {m.path}:{m.line}:{m.column}: {m.what}: {m.text}")
    print(f"mutate: of {len(judged)} mutants (seed {seed}, {possible} possible) {len(judged) - known - len(survivors)} "
          f"were noticed, {known} are explained in tests/mutants.equivalent, {len(survivors)} survived: "
          f"{build}/mutants.tsv, {time.time() - start:.0f} s")
    return 1 if 50 * len(survivors) > len(judged) else 0


sys.exit(main())
