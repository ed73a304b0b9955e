#!/usr/bin/env python3
"""prose.py TREE [--table | --comments | --phrases]: measures the documents, and fails above the limits stated here.

A sentence has at most 40 words, and the median of a document is at most 18. A code span counts as one word. Table cells
are measured too, without their code spans; each part between semicolons counts as a sentence. `--table` prints every document.
`--comments` lists comments whose first sentence is a clause about the name below. `--phrases` fails on phrases of
tests/phrases.txt and on doubled words. It uses Debian's diction, the only packaged linter whose list of
phrases is a plain text file: proselint has a fixed list of literary style, vale is not packaged, and npm linters need a
configuration in code.
"""
import collections
import re
import statistics
import subprocess
import sys
from pathlib import Path

LONGEST, MEDIAN = 40, 18
SOURCES = {".hpp", ".cpp", ".js", ".ts", ".tsx", ".mjs"}
FOLDERS = ["tubesheets", "deflection", "calibration", "planner", "app", "studies", "tests"]
# A sentence ends before a capital, a code span, a figure, a quotation or an opening bracket.
END = re.compile(r"""(?<=[.!?])["')*\]]*\s+(?=["'(*\[`]*[A-Z0-9§])|(?<=[.!?])["')*]*\s+(?=§)""")
ABBREVIATION = re.compile(r"\b(e\.g|i\.e|cf|vs|Fig|No|[A-Z])\.\s")
CLAUSE = re.compile(r"(Whether|What|Which|Who|How|Why|Where|When|That|So that|Of|As)\b")


def documents(tree):
    return [tree / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted((tree / "docs").glob("*.md"))


def bare(text, code="§"):
    """Returns the text without Markdown marks; a code span becomes the argument `code`."""
    text = re.sub(r"``.+?``|`[^`]+`", code, text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"\*\*|(?<!\w)[*_](?=\w)|(?<=\w)[*_](?!\w)", "", text)


def blocks(text):
    """Yields (line, is_cell, text) of every paragraph, list item and table cell, without code blocks and headings."""
    paragraph, begin, fenced = [], 0, False
    for number, line in enumerate([*text.splitlines(), ""], 1):
        fence = line.lstrip().startswith("```")
        item = re.match(r"\s*([-*]|\d+\.) ", line)
        plain = line.strip() and not fence and not fenced and not line.startswith(("#", "|")) and (
            not line.startswith("    ") or paragraph)
        if paragraph and (not plain or item):
            yield begin, False, " ".join(paragraph)
            paragraph = []
        fenced ^= fence
        if line.startswith("|") and not fenced and not re.fullmatch(r"[|\s:-]+", line):
            yield from ((number, True, cell) for cell in re.split(r"(?<!\\)\|", line.strip().strip("|")))
        elif plain:
            begin = begin if paragraph else number
            paragraph.append(line.strip() if not item else line[item.end():].strip())


def sentences(text):
    """Yields (line, number of words, sentence) of a document; omits parts of table cells with at most five words."""
    for line, is_cell, block in blocks(text):
        prose = ABBREVIATION.sub(lambda found: found[0].replace(".", ""), bare(block))
        for sentence in END.split(prose):
            for part in sentence.split("; ") if is_cell else [sentence]:
                words = [word for word in part.split() if re.search(r"\w" if is_cell else r"[\w§]", word)]
                if len(words) > (5 if is_cell else 0):
                    yield line, len(words), part


def first_lines(tree):
    """Yields (place, first line) of every comment of the sources."""
    for folder in FOLDERS:
        for path in sorted((tree / folder).rglob("*")):
            if path.suffix not in SOURCES or "node_modules" in path.parts:
                continue
            inside = False
            for number, line in enumerate(path.read_text().splitlines(), 1):
                comment = re.match(r"\s*(?://+!?|/\*\*?|\*)\s+(.*)", line)
                if comment and not inside:
                    yield f"{path.relative_to(tree)}:{number}", comment[1]
                inside = bool(comment)


def phrases(tree):
    """Prints the phrases that diction finds, and doubled words, with their document and line; returns the number of both."""
    text, found = "", []
    for path in documents(tree):
        for line, _, block in blocks(path.read_text()):
            prose, place = bare(block, "x1").strip(), f"{path.relative_to(tree)}:{line}"
            text += f'#line {line} "{path.relative_to(tree)}"\n{prose[:1].upper()}{prose[1:]}.\n\n'  # else diction skips the sentence
            found += [f"{place}: {twice[0]}" for twice in re.finditer(r"\b([a-z]+) \1\b", prose)]
    said = subprocess.run(["diction", "-d", "-n", "-s", "-f", str(tree / "tests/phrases.txt")], input=text,
                          capture_output=True, text=True, check=True).stdout
    found += [line for line in said.splitlines() if " -> " in line]
    print("\n".join(found) or f"no phrase of tests/phrases.txt in {len(documents(tree))} documents")
    return len(found)


def comments(tree):
    """Prints the comments that begin as a clause, and their number among all comments."""
    lines = list(first_lines(tree))
    found = [(place, words) for place, words in lines if CLAUSE.match(words)]
    openings = collections.Counter(CLAUSE.match(words)[0] for _, words in found)
    print(*(f"{place}: {words}" for place, words in found), sep="\n")
    print(f"{len(found)} of {len(lines)} comments begin as a clause:", ", ".join(f"{word} {n}" for word, n in openings.most_common()))
    return 0


def measured(tree):
    """Yields (name, median, longer sentences, all lengths) of every document."""
    for path in documents(tree):
        rows = list(sentences(path.read_text()))
        counts = [count for _, count, _ in rows] or [0]
        yield path.relative_to(tree), statistics.median(counts), [row for row in rows if row[1] > LONGEST], counts


def table(tree):
    for name, median, long, counts in measured(tree):
        print(f"{str(name):26} {len(counts):5} sentences, median {median:4.1f}, longest {max(counts):3}, {len(long):3} above {LONGEST}")
    return 0


def lengths(tree):
    """Prints sentences and documents above the limits; returns their number."""
    above = 0
    for name, median, long, _ in measured(tree):
        if median > MEDIAN:
            print(f"{name}: the median sentence has {median} words, more than {MEDIAN}")
        for line, count, sentence in long:
            print(f"{name}:{line}: {count} words, more than {LONGEST}: {sentence[:90]}...")
        above += len(long) + (median > MEDIAN)
    return above


CHECKS = {"": lengths, "--table": table, "--comments": comments, "--phrases": phrases}

if __name__ == "__main__":
    sys.exit(bool(CHECKS[sys.argv[2] if len(sys.argv) > 2 else ""](Path(sys.argv[1]))))
