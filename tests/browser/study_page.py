#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens a study page in headless Chromium, uses it by real input events, and checks what it shows.

Exit code: 0 all passed, 1 failures, 77 no browser.
"""
import argparse
import math
import pathlib
import re
import signal
import sys

from chromium import SECONDS_IN_ALL, Browser, BrowserError, Complaints, Deadline, Page, find_browser
from viewer_checks import VIEWER, check_viewer

SKIPPED = 77


class Report:
    def __init__(self):
        self.passed = 0
        self.failed = 0

    def check(self, holds, what, otherwise=""):
        if holds:
            self.passed += 1
            print(f"ok      {what}")
        else:
            self.failed += 1
            print(f"FAILED  {what}{': ' if otherwise else ''}{otherwise}")
        return holds


NUMBER = re.compile(r"([-+]?)(\d+)(?:\.(\d*))?(?:[eE]([-+]?\d+))?")


def plain_number_text(text):
    """With an ASCII minus and without spaces that part thousands."""
    return re.sub(r"(?<=\d)[\u00a0\u2009\u202f](?=\d{3})", "", text.replace("\u2212", "-"))


def is_rounding(text, value):
    """Whether the first number in a text is `value` within half a unit of its last digit."""
    found = NUMBER.search(plain_number_text(text))
    if not math.isfinite(value):
        return found is None
    if found is None:
        return False
    last_digit = 10.0 ** (int(found[4] or 0) - len(found[3] or ""))
    return abs(float(found[0]) - value) <= last_digit / 2 * (1 + 1e-9) + 1e-12 * abs(value)


def check_cells(page, report):
    cells = page.evaluate("""Array.from(document.querySelectorAll('td[data-value]'), (cell) =>
        [cell.textContent, cell.dataset.value, cell.dataset.scale || '1', cell.dataset.of || ''])""")
    wrong = [f"{of} shows \"{text}\", is {value} × {scale}" for text, value, scale, of in cells
             if not is_rounding(text, float(value) * float(scale))]
    report.check(not wrong, f"{len(cells)} cells are roundings of their values", "; ".join(wrong[:5]))


LEGEND = "document.querySelector('svg.plot .legend')"
SERIES = f"""{LEGEND}.closest('svg').querySelector(`.series[data-series="${{{LEGEND}.dataset.series}}"]`)"""
SHOWN = f"[getComputedStyle({SERIES}).display !== 'none', {LEGEND}.getAttribute('aria-pressed') === 'true']"


def check_legend(page, report):
    if not page.evaluate(f"{LEGEND} !== null"):
        print("none    no plot has a legend")
        return
    report.check(page.evaluate(SHOWN) == [True, True], "legend: the first series is shown at first")
    for how, act in (("a click", lambda: page.click(LEGEND)), ("Enter", lambda: page.press(LEGEND, "Enter")),
                     ("Space", lambda: page.press(LEGEND, " "))):
        act()
        report.check(page.evaluate(SHOWN) == [False, False], f"legend: {how} hides the series")
        act()
        report.check(page.evaluate(SHOWN) == [True, True], f"legend: {how} shows it again")


def check_width(page, report):
    over = page.evaluate("document.documentElement.scrollWidth - innerWidth")
    report.check(over <= 0, "the page is not wider than its window", f"by {over} pixels")


def check_page(page, report, complaints):
    check_width(page, report)
    check_cells(page, report)
    check_legend(page, report)
    check_viewer(page, report)
    report.check(not complaints.found, "no errors, no exceptions, no requests to other places",
                 "; ".join(complaints.found[:5]))


def run(program, options, report):
    complaints = Complaints()
    browser = Browser(program, Deadline(SECONDS_IN_ALL))
    try:
        browser.listeners.append(complaints)
        page = Page(browser)
        page.open(pathlib.Path(options.page).resolve().as_uri(), options.width, options.dark)
        if options.screenshot:
            page.wait_until(f"!{VIEWER} || {VIEWER}.dataset.ready === 'true'")
            page.screenshot(options.screenshot)
        check_page(page, report, complaints)
    except (BrowserError, OSError) as error:
        report.check(False, "the browser answers", "; ".join([str(error), *complaints.found[:5]]))
    finally:
        browser.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", metavar="PAGE.html")
    parser.add_argument("--screenshot", metavar="OUT.png", help="of the whole page, as it opens")
    parser.add_argument("--dark", action="store_true", help="as on a dark screen")
    parser.add_argument("--width", type=int, default=1280, help="of the window, in pixels")
    parser.add_argument("--chromium", metavar="PATH")
    options = parser.parse_args()
    program = find_browser(options.chromium)
    if program is None:
        print("skipped: no chromium")
        return SKIPPED
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # so that the browser is closed then too
    report = Report()
    run(program, options, report)
    print(f"{report.passed} passed, {report.failed} failed")
    return 1 if report.failed else 0


if __name__ == "__main__":
    sys.exit(main())
