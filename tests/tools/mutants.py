# SPDX-License-Identifier: MIT
"""The changes that can be made to a source file, and the same as expressions that choose when they run."""
import functools
import glob
import re

# What is written by clang-format: binary operators stand between blanks.
SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "+": "-", "-": "+", "*": "+", "/": "*",
         "%": "/", "<<": ">>", ">>": "<<", "&": "|", "|": "&", "^": "|", "&&": "||", "||": "&&", "+=": "-=",
         "-=": "+=", "|=": "&=", "&=": "|=", ">>=": "<<="}
PRECEDENCE = {"||": 1, "&&": 2, "|": 3, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, "<=": 7, ">": 7, ">=": 7, "<<": 8,
              ">>": 8, "+": 9, "-": 9, "*": 10, "/": 10, "%": 10}
LOWEST = ["?", ":", "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="]
OPERATOR = re.compile(r"(?<=\s)(?:" + "|".join(re.escape(o) for o in sorted(list(PRECEDENCE) + LOWEST, key=len,
                                                                         reverse=True)) + r")(?=\s)")
NUMBER = re.compile(r"(?<![\w.])(0[xX][0-9a-fA-F]+|\d+)([uUlL]*)(?![\w.])")
OPENING = {")": "(", "]": "[", "}": "{"}
# A declaration as far as the first length of an array: of any of its variables or members, without one of parameters.
ARRAY = re.compile(r"\s*(?:(?:static|const) )*(?!(?:return|else|goto|case|typedef)\b)(?:struct )?[a-z]\w* "
                   r"(?:\**(?:const )?\w+(?:\[[^][]*\])*, )*\**(?:const )?(\w+)\[$")
PLAIN = r"[\w.>\[\] +*-]+"  # an expression without calls, assignments and comparisons (but for that of `->`)
# What chooses without an else: X = Y where they are compared, X = -X, or they change places.
CHOOSES = [re.compile(r"\) \{\s*(?P<x>%s) = (?P<y>%s);\s*\}(?!\s*else)" % (PLAIN, "-?" + PLAIN)),
           re.compile(r"\) \{\s*(?:const )?\w+ (?P<t>\w+) = (?P<x>%s);\s*(?P=x) = (?P<y>%s);\s*(?P=y) = (?P=t);\s*\}"
                      r"(?!\s*else)" % (PLAIN, PLAIN))]


def blank_comments(text):
    """The same length, without comments and directives; strings are as long words."""
    def blank(match):
        with_what = "_" if match.group(0)[0] in "\"'" else " "
        return re.sub(r"[^\n]", with_what, match.group(0))
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\n])*\"|'(?:\\.|[^'\n])*'", blank, text, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.M)


def is_zero(text):
    return re.fullmatch(r"0[uUlL]*", text) is not None


def without_cast(text):
    """`-x` of `(uint32_t)-x`, `0u - (uint32_t)x` and the like."""
    text = re.sub(r"^0[uUlL]* - ", "-", text)
    return re.sub(r"^\((?:u?int\d+_t|q16)\)(-?)", r"\1", re.sub(r"^-\((?:u?int\d+_t|q16)\)", "-", text))


@functools.lru_cache(maxsize=None)
def names_of_sizes():
    """What a sizeof asks for, anywhere in core: the last name of its operand, `b` of `sizeof a[i].b[0]`."""
    found = set()
    for path in glob.glob("core/**/*", recursive=True):
        if path.endswith((".c", ".h", ".inc")):
            for match in re.finditer(r"\bsizeof\b[ (]*[*&]*((?:\w+|\.|->|\[[^]]*\])+)", open(path).read()):
                found.add(re.findall(r"\w+", re.sub(r"\[[^]]*\]", "", match.group(1)))[-1])
    return found


class Source:
    """A file, and where its changes begin and end."""

    def __init__(self, path, text=None):
        self.path = path
        self.text = open(path).read() if text is None else text
        self.code = blank_comments(self.text)
        self.pairs = self.match_brackets()

    def match_brackets(self):
        pairs, open_ones = {}, []
        for at, char in enumerate(self.code):
            if char in "([{":
                open_ones.append(at)
            elif char in ")]}" and open_ones:
                other = open_ones.pop()
                pairs[at], pairs[other] = other, at
        return pairs

    def mutants(self):
        """(offset, old, new) of every change."""
        found = []
        for match in OPERATOR.finditer(self.code):
            if match.group(0) in SWAPS and not self.is_of_equals(match.start(), match.end()):
                found.append((match.start(), match.group(0), SWAPS[match.group(0)]))
        for match in re.finditer(r"\+\+|--|\btrue\b|\bfalse\b|!(?![=\s])", self.code):
            new = {"++": "--", "--": "++", "true": "false", "false": "true", "!": ""}[match.group(0)]
            found.append((match.start(), match.group(0), new))
        for match in NUMBER.finditer(self.code):
            if re.search(r"\benum\b[^;]*$", self.code[max(0, match.start() - 40):match.start()]):
                continue
            digits, suffix = match.groups()
            value = int(digits, 0)
            for other in sorted({value + 1, max(value - 1, 0)} - {value, self.same_number(match, value)}):
                text = (hex(other) if digits[:2] in ("0x", "0X") else str(other)) + suffix
                found.append((match.start(), match.group(0), text))
        return found

    def same_number(self, match, value):
        """The neighbour of a number that makes no difference where it stands, or None.

        Room for one more in an array: no program that is defined without it reaches it. What would have such a room
        in the middle, lengths but the first, is a change. Of whole numbers x < 1 is x <= 0, x >= 1 is x > 0, x > 4 is
        x >= 5 and x <= 4 is x < 5: where the swap of the comparison makes no difference, neither does the number."""
        if self.is_array_alone(match.start(), match.end()):
            return value + 1
        compared = re.search(r" (<|<=|>|>=) $", self.code[max(0, match.start() - 4):match.start()])
        if not compared or value > 0x7ffffffe:
            return None
        begin = match.start() - 1 - len(compared.group(1))
        if self.code[match.start():self.right(match.end(), 7)].strip() != match.group(0):
            return None
        if not self.is_of_equals(begin, match.start() - 1):
            return None
        return value + 1 if compared.group(1) in ("<", ">=") else value - 1

    def is_of_equals(self, begin, end):
        """Whether a comparison only chooses between what it compares, or a sign: of equal ones either is the same.

        So it is with ?:, where both ways give one of the two, or x and -x where x is compared with 0, converted alike
        or not: of 0 any is 0. So it is with an if that does no more than set one of the two to the other, or x to -x,
        or let the two change places. None has a call or an assignment within."""
        if self.code[begin:end] not in ("<", "<=", ">", ">="):
            return False
        ends = [self.left(begin, 7), self.right(end, 7)]
        a, b = self.code[ends[0]:begin].strip(), self.code[end:ends[1]].strip()
        if re.search(r"\w\(|\+\+|--", a + " " + b):
            return False
        if self.code[ends[1]:ends[1] + 1] != "?":
            return self.is_if_of_equals(ends, a, b)
        parts = []
        for mark in "?:":
            if self.code[ends[1]:ends[1] + 1] != mark:
                return False
            at, ends[1] = ends[1] + 1, self.right(ends[1] + 1, 0)
            parts.append(self.code[at:ends[1]].strip())
        return sorted([a, b]) == sorted(parts) or (is_zero(b) and {a, "-" + a} == set(map(without_cast, parts)))

    def is_if_of_equals(self, ends, a, b):
        """`ends`: of the comparison, which has to be all of the condition."""
        if not re.search(r"\bif \($", self.code[max(0, ends[0] - 8):ends[0]]):
            return False
        for pattern in CHOOSES:
            match = pattern.match(self.code, ends[1])
            if match and (sorted([a, b]) == sorted([match["x"], match["y"]]) or
                          (is_zero(b) and match["x"] == a and match["y"] == "-" + a)):
                return True
        return False

    def is_array_alone(self, begin, end):
        """Whether a length is the first of an array whose size nothing asks for, here or elsewhere."""
        after = re.match(r"\](?:\[[^][]*\])*(?:;|,| =)", self.code[end:end + 80])
        if after is None:
            return False
        start = max(self.code.rfind(char, 0, begin) for char in ";{}") + 1
        array = ARRAY.match(self.code, start, begin)
        return array is not None and array.group(1) not in names_of_sizes()

    def changed(self, change):
        at, old, new = change
        return self.text[:at] + new + self.text[at + len(old):]

    # Extents of operands, by precedence ------------------------------------------------------------

    def right(self, at, precedence):
        """Where the operand that begins at `at` ends."""
        while at < len(self.code):
            char = self.code[at]
            if char in "([{":
                at = self.pairs.get(at, len(self.code))
            elif char in ")]};,":
                return at
            else:
                match = OPERATOR.match(self.code, at)
                if match and PRECEDENCE.get(match.group(0), 0) <= precedence:
                    return at
                if match:
                    at = match.end() - 1
            at += 1
        return at

    def left(self, at, precedence):
        """Where the operand that ends before `at` begins."""
        at -= 1
        while at >= 0:
            char = self.code[at]
            if char in ")]":
                opening = self.pairs.get(at, 0)
                if char == ")" and re.search(r"\b(if|while|for|switch)\s*$", self.code[max(0, opening - 8):opening]):
                    return at + 1
                at = opening
            elif char in "([{};,":
                return at + 1
            elif char == ":" and not self.code[at - 1].isspace():
                return at + 1
            elif self.code[at + 1].isspace():
                begin = max(self.code.rfind(" ", 0, at + 1), self.code.rfind("\n", 0, at + 1)) + 1
                word = self.code[begin:at + 1]
                if word in LOWEST or PRECEDENCE.get(word, 99) < precedence:
                    return at + 1
                if re.search(r"\b(return|case|else|do)$", self.code[max(0, at - 6):at + 1]):
                    return at + 1
            at -= 1
        return at + 1

    def lvalue_left(self, at):
        """Where `a.b[c]->d` begins that ends before `at`."""
        while at > 0:
            before = self.code[at - 1]
            if before in ")]":
                at = self.pairs[at - 1]
                if before == ")":
                    return at
                continue
            word = re.search(r"(\w+|\.|->)$", self.code[max(0, at - 60):at])
            if not word:
                return at
            at -= len(word.group(0))
        return at

    def unary_right(self, at):
        """Where the unary expression ends that begins at `at`."""
        while self.code[at] in "!~-+*&":
            at += 1
        while True:
            if self.code[at] in "([":
                at = self.pairs[at] + 1
                cast = re.match(r"[\w(]", self.code[at:at + 1])
                if cast:
                    return self.unary_right(at)
                continue
            word = re.match(r"\w+|\.|->|\+\+|--", self.code[at:])
            if not word:
                return at
            at += len(word.group(0))

    def schema(self, change, number):
        """(begin, end, text): the change where qtri_mutant is `number`. None where it is not of that kind."""
        at, old, new = change
        end = at + len(old)
        here = (f"static char qtri_site_{number} __attribute__((used)); (void)qtri_site_{number};")
        seen = f"(void)(qtri_mutant == 0 && (qtri_seen[{number}] = 1));"
        chosen = f"qtri_mutant == {number}"
        if old in PRECEDENCE:
            begin, stop = self.left(at, PRECEDENCE[old]), self.right(end, PRECEDENCE[old])
        elif old in ("++", "--"):
            before = re.match(r"[\w)\]]", self.code[at - 1])
            begin = self.lvalue_left(at) if before else at
            stop = end if before else self.unary_right(end)
        elif old in SWAPS:
            begin, stop = self.left(at, 0), self.right(end, -1)
        elif old == "!":
            begin, stop = at, self.unary_right(end)
        else:
            begin, stop = at, end
        begin += len(self.code[begin:at]) - len(self.code[begin:at].lstrip())
        stop = begin + len(self.code[begin:stop].rstrip())
        if re.search(r"^[ \t]*#", self.text[begin:stop], flags=re.M):
            return None
        first, second = self.text[begin:at].strip(), self.text[end:stop].strip()
        if re.search(r"//", first + second) or (old in SWAPS and not (first and second)):
            return None
        if old in ("&&", "||"):
            mark = f"(qtri_mutant == 0 ? (void)(qtri_seen[{number}] = 1) : (void)0)"
            one, two = (("1", f"({mark}, 0)") if old == "&&" else (f"({mark}, 1)", "0"))
            plain = (f"(({first}) ? (({second}) ? 1 : ({mark}, 0)) : ({mark}, 0))" if old == "&&" else
                     f"(({first}) ? ({mark}, 1) : (({second}) ? ({mark}, 1) : 0))")
            del one, two
            text = f"(__extension__({{{here} {chosen} ? (({first}) {new} ({second})) : {plain};}}))"
        elif old in PRECEDENCE:
            a, b, r = f"qtri_a{number}", f"qtri_b{number}", f"qtri_r{number}"
            text = (f"(__extension__({{{here} __auto_type {a} = ({first}); __auto_type {b} = ({second}); "
                    f"__auto_type {r} = {a} {old} {b}; if (qtri_mutant == 0 && {r} != ({a} {new} {b})) "
                    f"qtri_seen[{number}] = 1; {chosen} ? {a} {new} {b} : {r};}}))")
        else:
            if old in SWAPS:
                plain, other = f"({first} {old} ({second}))", f"({first} {new} ({second}))"
            else:
                plain, other = f"({first}{old}{second})", f"({first}{new}{second})"
            text = f"(__extension__({{{here} {seen} {chosen} ? {other} : {plain};}}))"
        return begin, stop, text


# Of a text, the changes of the operator or number in between that are drawn.
DRAWN = [
    ("void f(void)\n{\n    uint32_t a[@2@], b[3];\n}", ["1"]), ("{\n    uint32_t a[2], *b[@3@];\n}", ["2"]),
    ("{\n    int a, b[@3@][4];\n}", ["2"]), ("{\n    int b[3][@4@];\n}", ["3", "5"]),
    ("static const int t[@2@] = {1, 2};", ["1"]), ("void f(int a[@2@]);", ["1", "3"]),
    ("{\n    a = b[@2@];\n}", ["1", "3"]), ("{\n    return b[@2@];\n}", ["1", "3"]),
    ("{\n    int a = c, d = b[@2@];\n}", ["1", "3"]), ("typedef char check[@1@];", ["0", "2"]),
    ("{\n    m = x @<@ 0 ? -x : x;\n}", []), ("{\n    m = x < @0@ ? -x : x;\n}", []),
    ("{\n    m = x @>=@ 0 ? x : -x;\n}", []), ("{\n    m = x < @0@ ? -1 : 1;\n}", ["1"]),
    ("{\n    m = x @<@ 0 ? 0u - (uint32_t)x : (uint32_t)x;\n}", []), ("{\n    m = x @<@ 1 ? -x : x;\n}", ["<="]),
    ("{\n    m = x > @255@ ? 255 : x;\n}", ["256"]), ("{\n    m = x > 255 ? @255@ : x;\n}", ["254", "256"]),
    ("{\n    m = x < @3@ ? 3 : x;\n}", ["2"]), ("{\n    m = x < 3 ? @4@ : x;\n}", ["3", "5"]),
    ("{\n    m = x > @254@ ? 255 : x;\n}", ["253", "255"]), ("{\n    m = x @>@ y ? y : z;\n}", [">="]),
    ("{\n    if (x @<@ y) {\n        x = y;\n    }\n}", []), ("{\n    if (x < @9@) {\n        x = 9;\n    }\n}", ["8"]),
    ("{\n    if (x @<@ y) {\n        x = y;\n    } else {\n        z = 1;\n    }\n}", ["<="]),
    ("{\n    if (x @<@ y) {\n        x = y;\n        z = 1;\n    }\n}", ["<="]),
    ("{\n    if (x @<@ y && z) {\n        x = y;\n    }\n}", ["<="]),
    ("{\n    if (x @<@ y) {\n        x = z;\n    }\n}", ["<="]),
    ("{\n    if (x @<@ 0) {\n        x = -x;\n    }\n}", []),
    ("{\n    if (a @>@ b) {\n        const int t = a;\n        a = b;\n        b = t;\n    }\n}", []),
    ("{\n    if (a @>@ b) {\n        const int t = c;\n        c = b;\n        b = t;\n    }\n}", [">="]),
    ("{\n    if (f() @>@ b) {\n        b = f();\n    }\n}", [">="]),
]

# Of a text, what is chosen as a whole where the operator in between changes.
CHOSEN = [
    ("{\n    a @+=@ b > c ? d : e;\n}", "a += b > c ? d : e"), ("{\n    a[i] @|=@ b == c;\n}", "a[i] |= b == c"),
    ("{\n    for (;; a @>>=@ 1, b++) {\n    }\n}", "a >>= 1"), ("{\n    a = b @+@ c * d > e ? f : g;\n}", "b + c * d"),
    ("{\n    a = b + c @-@ d << e;\n}", "b + c - d"), ("{\n    a = f ? b @>>@ c - d : e;\n}", "b >> c - d"),
]


def check():
    """What is left out is no more, and no less, than what makes no difference."""
    for text, expected in DRAWN:
        before, old, _ = text.split("@")
        found = [new for at, what, new in Source("", text.replace("@", "")).mutants() if at == len(before)]
        assert found == expected, (text, old, found)
    for text, expected in CHOSEN:
        before, old, _ = text.split("@")
        source = Source("", text.replace("@", ""))
        begin, end, _ = source.schema((len(before), old, SWAPS[old]), 1)
        assert source.text[begin:end] == expected, (text, source.text[begin:end])
