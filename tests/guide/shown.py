"""What a page shows of a command's output, held against what the command prints.

The words are the same; a number that is shown stands for all that round to it; three dots stand
for anything. White space counts as one space."""

import decimal
import re

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?"
# Not the digits of a name (B.1, 02_sphere, first.h5), nor a sign between two words (x-2).
TOKEN = re.compile(rf"(?P<dots>\.\.\.)|(?P<number>(?<![\w.]){NUMBER}(?![\w]|\.\d))|(?P<space>\s+)")


def rounds_to(number, shown):
    """Whether a printed number is what is shown, with the digits that are shown."""
    try:
        value, claim = decimal.Decimal(number), decimal.Decimal(shown)
    except decimal.InvalidOperation:
        return number == shown
    step = decimal.Decimal(1).scaleb(claim.as_tuple().exponent)
    return abs(value - claim) <= step / 2


def pattern(shown):
    """A regular expression for the output, and the numbers of its groups in order."""
    parts, numbers, at = [], [], 0
    for token in TOKEN.finditer(shown):
        parts.append(re.escape(shown[at : token.start()]))
        if token["dots"]:
            parts.append(r".*?")
        elif token["number"]:
            parts.append(rf"({NUMBER})")
            numbers.append(token["number"])
        else:
            parts.append(r"\s+")
        at = token.end()
    return "".join(parts) + re.escape(shown[at:]), numbers


def difference(shown, printed, numbers_count=True):
    """None, or a sentence. numbers_count: false where a clock or the machine decides them."""
    expression, claims = pattern(shown.strip())
    found = re.fullmatch(expression, printed.strip(), re.DOTALL)
    if not found:
        return f"The words differ. Shown:\n{shown}\nPrinted:\n{printed[:1500]}"
    wrong = [
        f"{claim} is shown, {number} is printed"
        for claim, number in zip(claims, found.groups())
        if numbers_count and not rounds_to(number, claim)
    ]
    return "; ".join(wrong) or None
