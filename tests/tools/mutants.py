# SPDX-License-Identifier: MIT
"""The changes that can be made to a source file, and the same as expressions that choose when they run."""
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
# An array of a function or a member, without values, as far as one of its lengths.
ARRAY = re.compile(r"\n +(?!return\b)(?:const )?[a-z]\w* (?:\*const )?\**(\w+)(?:\[\w+\])*\[$")


def blank_comments(text):
    """The same length, without comments and directives; strings are as long words."""
    def blank(match):
        with_what = "_" if match.group(0)[0] in "\"'" else " "
        return re.sub(r"[^\n]", with_what, match.group(0))
    text = re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\n])*\"|'(?:\\.|[^'\n])*'", blank, text, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.M)


class Source:
    """A file, and where its changes begin and end."""

    def __init__(self, path):
        self.path = path
        self.text = open(path).read()
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
            roomier = value + 1 if self.is_array_alone(match.start(), match.end()) else None
            for other in sorted({value + 1, max(value - 1, 0)} - {value, roomier}):
                text = (hex(other) if digits[:2] in ("0x", "0X") else str(other)) + suffix
                found.append((match.start(), match.group(0), text))
        return found

    def is_of_equals(self, begin, end):
        """Whether a comparison only chooses between what it compares, or a sign: of equal ones either is the same."""
        if self.code[begin:end] not in ("<", "<=", ">", ">="):
            return False
        ends = [self.left(begin, 7), self.right(end, 7)]
        parts = [self.code[ends[0]:begin].strip(), self.code[end:ends[1]].strip()]
        for mark in "?:":
            if self.code[ends[1]:ends[1] + 1] != mark:
                return False
            begin, ends[1] = ends[1] + 1, self.right(ends[1] + 1, 0)
            parts.append(self.code[begin:ends[1]].strip())
        return sorted(parts[:2]) == sorted(parts[2:]) or parts[1:] == ["0", "-" + parts[0], parts[0]]

    def is_array_alone(self, begin, end):
        """Whether a length is that of an array whose size nothing asks for: room for one more is no change."""
        array = ARRAY.search(self.code, max(0, begin - 200), begin)
        return (array is not None and re.match(r"\](?:\[\w+\])*;", self.code[end:end + 40]) is not None and
                re.search(rf"\bsizeof[ (]\(?{array.group(1)}\b", self.code) is None)

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
            begin, stop = self.left(at, 0), self.right(end, 0)
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
