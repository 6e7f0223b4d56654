"""Markdown with generated pieces, and the figures that stand outside of them.

A table is between lines `<!-- figures: NAME -->` and `<!-- end -->`; a figure in a sentence in `<!--f:NAME-->…<!--/-->`.
"""

import itertools
import math
import re

TABLE = re.compile(r"(<!-- figures: (\S+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
SPAN = re.compile(r"(<!--f:(\S+?)-->)(.*?)(<!--/-->)")
MARK = re.compile(r"<!-- *(?:figures?:|f:|end|/)[^>]*-->")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`|(?<=\])\([^)\s]*\)", re.DOTALL | re.MULTILINE)  # and the targets of links

NUMBER = r"(?<![\w.,^/-])[-−+]?\d[\d., ]*?"
UNITS = (r"%|percent|(?:[µnm]s|s|min|minutes|hours|seconds|ulp)\b|[kKMGT]i?B\b|bytes\b|times\b|of \d+\b|"
         r"(?:samples|values|directions|nodes)/s\b")
# A decimal without a unit is a figure too, unless it is an angle or a version: PoCL 3.1.
VERSION = r"\b[A-Z]\w*[a-z0-9]\w* \d+\.[\d.]+"
FIGURE = re.compile(rf"{NUMBER}(?:e[-−+]?\d+\b|[  ]?(?:{UNITS}))|(?<![\w.])\d+\.\d+(?![\w.°]| degrees)")


def generated(name, blocks, results):
    if name not in blocks:
        raise SystemExit(f"{name}: a text asks for a block that no section has")
    return blocks[name](results)


def pieces(text):
    return [at[2] for pattern in (TABLE, SPAN) for at in pattern.finditer(text)]


def render(text, blocks, results):
    """The text with every generated piece made anew."""
    text = TABLE.sub(lambda at: f"{at[1]}{generated(at[2], blocks, results)}\n{at[4]}", text)
    return SPAN.sub(lambda at: at[1] + generated(at[2], blocks, results) + at[4], text)


def differences(text, blocks, results):
    """(line, name of the piece, what stands there, what it should be), line by line."""
    for pattern in (TABLE, SPAN):
        for at in pattern.finditer(text):
            first = text.count("\n", 0, at.start(3)) + 1
            there, given = at[3].splitlines(), generated(at[2], blocks, results).splitlines()
            for k, (is_there, is_given) in enumerate(itertools.zip_longest(there, given, fillvalue="no line")):
                if is_there != is_given:
                    yield first + k, at[2], is_there, is_given
    for mark in MARK.finditer(blank(blank(text, TABLE), SPAN)):
        yield text.count("\n", 0, mark.start()) + 1, mark[0], "a mark of a generated piece", "one that opens and closes"


def blank(text, pattern):
    """What matches becomes spaces, and lines stay lines."""
    return pattern.sub(lambda at: re.sub(r"[^\n]", " ", at[0]), text)


def by_hand(text):
    return blank(blank(blank(text, TABLE), SPAN), CODE)


def occurrences(text, phrase):
    """A phrase may go over the end of a line."""
    return re.compile(r"\s+".join(re.escape(word) for word in phrase.split())).finditer(text)


def strays(text, phrases):
    """(line, figure) of every number with a unit, and of every decimal, that is neither generated nor within a phrase."""
    prose = by_hand(text)
    allowed = [at.span() for phrase in phrases for at in occurrences(prose, phrase)]
    allowed += [at.span() for at in re.finditer(VERSION, prose)]
    for figure in FIGURE.finditer(prose):
        if not any(start <= figure.start() and figure.end() <= end for start, end in allowed):
            yield prose.count("\n", 0, figure.start()) + 1, figure[0]


def stale_phrases(texts, phrases):
    prose = [by_hand(text) for text in texts]
    return [phrase for phrase in phrases if not any(next(occurrences(text, phrase), None) for text in prose)]


def table(head, rows):
    """A Markdown table from lists of cells."""
    def line(cells):
        return "|" + "|".join(f" {cell} " if cell else " " for cell in cells) + "|"
    return "\n".join([line(head), "|---" * len(head) + "|", *map(line, rows)])


def plain(value, digits=2):
    """Rounded to significant digits, without an exponent: 0.057, 1.0, 120, 14 000."""
    value = float(f"{value:.{digits}g}")
    decimals = digits - 1 - math.floor(math.log10(abs(value))) if value else 0
    return f"{value:,.{max(0, decimals)}f}".replace(",", " ")


def percent(share, digits=2):
    return f"{plain(100 * share, digits)} %"


def power(value):
    """2.5e-7"""
    mantissa, exponent = f"{value:.1e}".split("e")
    return f"{mantissa}e{int(exponent)}"


def megabytes(size):
    return f"{plain(size / 1e6, 3 if size > 1e8 else 2)} MB"
