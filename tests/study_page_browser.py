#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Opens a study page in headless Chromium, uses it by real input events, and checks what it shows.

Needs the standard library and a Chromium only: the browser is steered over --remote-debugging-pipe (it reads commands
from file descriptor 3 and writes to 4, JSON ended by a NUL byte). Exit code: 0 all passed, 1 failures, 77 no browser.
"""
import argparse
import base64
import fcntl
import json
import math
import os
import pathlib
import re
import select
import shutil
import signal
import sys
import tempfile
import time

SECONDS_IN_ALL = 30
SECONDS_FOR_A_CHANGE = 3
SKIPPED = 77
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--no-default-browser-check",
         "--disable-dev-shm-usage", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-extensions", "--hide-scrollbars", "--remote-debugging-pipe")


class BrowserError(Exception):
    """The browser did not do what every page must be able to rely on."""


class Deadline:
    def __init__(self, seconds):
        self.end = time.monotonic() + seconds

    def left(self):
        left = self.end - time.monotonic()
        if left <= 0:
            raise BrowserError(f"not done within {SECONDS_IN_ALL} s")
        return left


# ---- The browser -----------------------------------------------------------------------------------------------------

def above_standard_descriptors(fd):
    """A copy of a descriptor at 10 or more, so that none is in the way of 3 and 4; the original is closed."""
    copy = fcntl.fcntl(fd, fcntl.F_DUPFD_CLOEXEC, 10)
    os.close(fd)
    return copy


def pipe():
    return tuple(above_standard_descriptors(fd) for fd in os.pipe())


class Browser:
    """A process of its own group with a profile of its own; both are gone after `close`."""

    def __init__(self, program, deadline):
        self.deadline = deadline
        self.listeners = []
        self.last_id = 0
        self.buffer = b""
        self.profile = tempfile.mkdtemp(prefix="study_page_")
        command_read, self.command = pipe()
        self.answer, answer_write = pipe()
        quiet = os.open(os.devnull, os.O_RDWR | os.O_CLOEXEC)
        wiring = [(os.POSIX_SPAWN_DUP2, source, target)
                  for source, target in ((quiet, 0), (quiet, 1), (quiet, 2), (command_read, 3), (answer_write, 4))]
        arguments = [program, *FLAGS, f"--user-data-dir={self.profile}", "about:blank"]
        try:
            self.pid = os.posix_spawn(program, arguments, os.environ, file_actions=wiring, setpgroup=0)
        except OSError:
            self.pid = None
            self.close()
            raise
        finally:
            for fd in (command_read, answer_write, quiet):
                os.close(fd)

    def close(self):
        if self.pid is not None:
            try:
                os.killpg(self.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            os.waitpid(self.pid, 0)
            self.pid = None
        os.close(self.command)
        os.close(self.answer)
        remove_folder(self.profile)

    def send(self, message):
        data = json.dumps(message).encode() + b"\0"
        while data:
            if not select.select([], [self.command], [], self.deadline.left())[1]:
                continue
            data = data[os.write(self.command, data[:4096]):]

    def receive(self):
        while b"\0" not in self.buffer:
            if not select.select([self.answer], [], [], self.deadline.left())[0]:
                continue
            data = os.read(self.answer, 1 << 20)
            if not data:
                raise BrowserError("the browser ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, session=None, **params):
        """The result of a command; events that come before it go to the listeners."""
        self.last_id += 1
        command = {"id": self.last_id, "method": method, "params": params}
        self.send({**command, "sessionId": session} if session else command)
        while True:
            message = self.receive()
            if message.get("id") == self.last_id:
                if "error" in message:
                    raise BrowserError(f"{method}: {message['error'].get('message')}")
                return message["result"]
            if "method" in message:
                for listener in self.listeners:
                    listener(message["method"], message.get("params", {}))


def remove_folder(path):
    """Processes that are just ending may still write: try for a while."""
    for _ in range(20):
        shutil.rmtree(path, ignore_errors=True)
        if not os.path.exists(path):
            return
        time.sleep(0.1)


def find_browser(given):
    if given:
        return shutil.which(given)
    return next((path for path in map(shutil.which, BROWSERS) if path), None)


# ---- The page --------------------------------------------------------------------------------------------------------

class Complaints:
    """What the page must not do: errors, exceptions, requests beyond file: and data:."""

    def __init__(self):
        self.found = []

    def __call__(self, method, params):
        if method == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.found.append("exception: " + details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "assert"):
            self.found.append("console: " + " ".join(str(a.get("value", a.get("description"))) for a in params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.found.append("log: " + params["entry"]["text"])
        elif method == "Network.requestWillBeSent" and not params["request"]["url"].startswith(("file:", "data:")):
            self.found.append("request: " + params["request"]["url"])


KEY_CODES = {"ArrowLeft": 37, "ArrowRight": 39, "ArrowDown": 40, "Enter": 13, " ": 32}
KEY_TEXTS = {"Enter": "\r", " ": " "}


class Page:
    def __init__(self, browser):
        self.browser = browser
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method, **params):
        return self.browser.call(method, self.session, **params)

    def evaluate(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            details = result["exceptionDetails"]
            raise BrowserError(details.get("exception", {}).get("description", details["text"]))
        return result["result"].get("value")

    def wait_until(self, expression, seconds=SECONDS_FOR_A_CHANGE):
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            if time.monotonic() > end:
                return False
            time.sleep(0.02)
        return True

    def open(self, url, width, dark):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[scheme])
        failed = self.call("Page.navigate", url=url).get("errorText")
        if failed:
            raise BrowserError(f"{url}: {failed}")
        if not self.wait_until("location.href !== 'about:blank' && document.readyState === 'complete'", SECONDS_IN_ALL):
            raise BrowserError("the page does not finish loading")

    def settle(self):
        """Two frames: what was asked for is drawn."""
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")

    def box(self, element):
        """Left, top, width and height of an element (a JavaScript expression), scrolled into view."""
        return self.evaluate(f"""(() => {{
            const element = {element};
            element.scrollIntoView({{block: 'center', inline: 'nearest'}});
            const box = element.getBoundingClientRect();
            return [box.left, box.top, box.width, box.height];
        }})()""")

    def mouse(self, kind, x, y, buttons=0):
        button = "none" if kind == "mouseMoved" else "left"
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=1)

    def drag(self, points):
        self.mouse("mouseMoved", *points[0])
        self.mouse("mousePressed", *points[0], buttons=1)
        for point in points[1:]:
            self.mouse("mouseMoved", *point, buttons=1)
        self.mouse("mouseReleased", *points[-1])

    def click(self, element):
        left, top, width, height = self.box(element)
        self.drag([(left + width / 2, top + height / 2)])

    def press(self, element, key):
        self.evaluate(f"({element}).focus()")
        code = {"key": key, "code": "Space" if key == " " else key, "windowsVirtualKeyCode": KEY_CODES[key]}
        text = {"text": KEY_TEXTS[key]} if key in KEY_TEXTS else {}
        self.call("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", **code, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **code)

    def screenshot(self, path):
        self.evaluate("scrollTo(0, 0)")
        size = self.call("Page.getLayoutMetrics")["cssContentSize"]
        clip = {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}
        shot = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)
        pathlib.Path(path).write_bytes(base64.b64decode(shot["data"]))


# ---- What is found ---------------------------------------------------------------------------------------------------

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


# ---- Checks of tables ------------------------------------------------------------------------------------------------

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


# ---- Checks of plots -------------------------------------------------------------------------------------------------

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


# ---- Checks of the viewer --------------------------------------------------------------------------------------------

VIEWER = "document.getElementById('viewer')"
CANVAS = "document.querySelector('#viewer canvas')"
DIVIDER = "document.querySelector('#viewer [role=slider]')"
SETTINGS = ("mode", "a", "b", "layer", "exposure", "divider")
HELPERS = """
globalThis.studyTest = {
    data: JSON.parse(document.getElementById('pictures-data').textContent),
    hash() {  // FNV-1a over whole pixels
        const canvas = document.querySelector('#viewer canvas');
        const bytes = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        let hash = 0x811c9dc5;
        for (const pixel of new Uint32Array(bytes.buffer)) hash = Math.imul(hash ^ pixel, 0x01000193);
        return hash >>> 0;
    },
    layer(picture, name) {  // empty where it is black or left out
        const base64 = this.data.pictures[picture].layers[name] || '';
        return /[^A=]/.test(base64) ? base64 : '';
    },
    samples(picture, name, step) {  // [bytes of light, codes on the canvas] of pixels on a grid
        const canvas = document.querySelector('#viewer canvas');
        const codes = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        const light = atob(this.data.pictures[picture].layers[name]);
        const of = (at, get) => [0, 1, 2, 3].map((i) => get(4 * at + i));
        const found = [];
        for (let at = 0; at < codes.length / 4; at += step) {
            found.push([of(at, (i) => light.charCodeAt(i)), of(at, (i) => codes[i])]);
        }
        return found;
    },
};
"""


def viewer_select(name):
    return f"document.querySelector('#viewer select[name={name}]')"


def viewer_mode(mode):
    return f"document.querySelector('#viewer input[name=mode][value={mode}]')"


class Viewer:
    """The viewer of pictures in a page; its settings and what its canvas shows."""

    def __init__(self, page, report):
        self.page = page
        self.report = report
        page.evaluate(HELPERS)

    def setting(self, name):
        return self.page.evaluate(f"{VIEWER}.dataset.{name}")

    def settings(self):
        return {name: self.setting(name) for name in SETTINGS}

    def hash(self):
        return self.page.evaluate("studyTest.hash()")

    def pictures(self):
        return self.page.evaluate("studyTest.data.pictures.length")

    def same_light(self, one, other):
        """Of two pairs of a picture's number and a layer."""
        return self.page.evaluate(f"studyTest.layer(...{json.dumps(one)}) === studyTest.layer(...{json.dumps(other)})")

    def check_change(self, what, act, name, differs=True):
        """That an act changes a setting, and the canvas if what is shown differs."""
        setting, picture = self.setting(name), self.hash()
        act()
        changed = self.page.wait_until(f"{VIEWER}.dataset.{name} !== {json.dumps(setting)}")
        self.report.check(changed, f"viewer: {what} changes data-{name}", f"is still {setting}")
        if differs:
            drawn = self.page.wait_until(f"studyTest.hash() !== {picture}")
            self.report.check(drawn, f"viewer: {what} changes the canvas")
        else:
            self.page.settle()
            self.report.check(self.hash() == picture, f"viewer: {what} leaves the canvas, both pictures are the same")

    def set_mode(self, mode):
        self.page.click(viewer_mode(mode))
        return self.report.check(self.page.wait_until(f"{VIEWER}.dataset.mode === '{mode}'"),
                                 f"viewer: a click sets the mode {mode}", f"is {self.setting('mode')}")


def check_divider(viewer):
    page = viewer.page
    now = viewer.settings()
    differs = not viewer.same_light([int(now["a"]), now["layer"]], [int(now["b"]), now["layer"]])
    left, top, width, height = page.box(DIVIDER)
    x, y = left + width / 2, top + height / 2
    _, _, stage_width, _ = page.box(CANVAS)
    goal = x - stage_width / 4
    viewer.check_change("dragging the divider", lambda: page.drag([(x, y), ((x + goal) / 2, y), (goal, y)]), "divider",
                        differs)
    divider = float(viewer.setting("divider"))
    viewer.report.check(abs(divider - 25) < 2, "viewer: the divider is where it was dragged to", f"{divider}, not 25")
    viewer.check_change("ArrowLeft at the divider", lambda: page.press(DIVIDER, "ArrowLeft"), "divider", differs)
    told = page.evaluate(f"{DIVIDER}.getAttribute('aria-valuenow')")
    follows = abs(float(told) - float(viewer.setting("divider"))) <= 0.5
    viewer.report.check(follows, "viewer: aria-valuenow follows it", told)


def check_picture_selects(viewer):
    """Another picture as A in mode A, as B in mode B, by ArrowDown at the select."""
    if viewer.pictures() < 2:
        print("none    one picture only: no other to select")
        return
    for side in ("a", "b"):
        if not viewer.set_mode(side.upper()):
            continue
        now, layer = int(viewer.setting(side)), viewer.setting("layer")
        if now + 1 == viewer.pictures():
            print(f"none    {side.upper()} is the last picture already")
            continue
        differs = not viewer.same_light([now, layer], [now + 1, layer])
        select_next = lambda: viewer.page.press(viewer_select(side), "ArrowDown")
        viewer.check_change(f"another {side.upper()}", select_next, side, differs)


def check_layer(viewer):
    layers = viewer.page.evaluate(f"Array.from({viewer_select('layer')}.options, (option) => option.value)")
    now, a = viewer.setting("layer"), int(viewer.setting("a"))
    if layers[-1] == now:
        print("none    one layer only: no other to select")
        return
    following = layers[layers.index(now) + 1]
    viewer.set_mode("A")
    viewer.check_change("another layer", lambda: viewer.page.press(viewer_select("layer"), "ArrowDown"), "layer",
                        not viewer.same_light([a, now], [a, following]))


def check_exposure(viewer):
    range_input = "document.querySelector('#viewer input[name=exposure]')"
    lit = viewer.page.evaluate(f"studyTest.layer({viewer.setting('a')}, {json.dumps(viewer.setting('layer'))}) !== ''")
    for key in ("ArrowRight", "ArrowLeft"):
        viewer.check_change(f"{key} at the exposure", lambda: viewer.page.press(range_input, key), "exposure", lit)


def check_difference(viewer):
    picture = viewer.hash()
    if viewer.set_mode("difference"):
        drawn = viewer.page.wait_until(f"studyTest.hash() !== {picture}")
        viewer.report.check(drawn, "viewer: the difference is drawn")


def check_flip(viewer):
    """A stored map is drawn; where there is none, words say so."""
    viewer.set_mode("FLIP")
    viewer.page.settle()
    b, layer = int(viewer.setting("b")), json.dumps(viewer.setting("layer"))
    if viewer.page.evaluate(f"!!(studyTest.data.pictures[{b}].flip || {{}})[{layer}]"):
        drawn = f"{CANVAS}.getContext('2d').getImageData(0, 0, 1, 1).data[3] === 255"
        viewer.report.check(viewer.page.wait_until(drawn), "viewer: the FLIP map is drawn")
    else:
        said = viewer.page.evaluate(f"{VIEWER}.innerText.includes('No FLIP map')")
        viewer.report.check(said, "viewer: says that there is no FLIP map")


def check_pixel_values(viewer):
    left, top, width, height = viewer.page.box(CANVAS)
    viewer.page.mouse("mouseMoved", left + width / 3, top + height / 3)
    x, y = viewer.page.evaluate(f"[Math.floor({CANVAS}.width / 3), Math.floor({CANVAS}.height / 3)]")
    words = f"{VIEWER}.innerText.replaceAll('\\u00a0', ' ')"
    near = "|".join(f"x {x + i}, y {y + j}" for i in (-1, 0, 1) for j in (-1, 0, 1))
    viewer.report.check(viewer.page.wait_until(f"/{near}/.test({words})"), "viewer: tells the pixel under the mouse")


# The curve of src/core/tone_map.cpp and the sRGB encoding, written a second time.
def bend(x):
    t = (x - 0.18) / 0.82
    return x if x <= 0.18 else min(0.18 + 0.82 * t / (1 + t ** 1.5) ** (1 / 1.5), 1)


def srgb(v):
    return 12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055


def shown_codes(stored, exposure):
    light = [0 if stored[3] == 0 else min(m * 2.0 ** (stored[3] - 136) * 2 ** exposure, 1e12) for m in stored[:3]]
    peak = max(light)
    bent = light if peak <= 0.18 else [(bend(v) + v / peak * bend(peak)) / 2 for v in light]
    return [255 * srgb(v) for v in bent]


def check_colors(viewer):
    viewer.set_mode("A")
    viewer.page.settle()
    now = viewer.settings()
    if not viewer.page.evaluate(f"{json.dumps(now['layer'])} in studyTest.data.pictures[{now['a']}].layers"):
        print("none    A leaves this layer out: no colours to check")
        return
    step = viewer.page.evaluate(f"Math.max(1, Math.floor({CANVAS}.width * {CANVAS}.height / 997))")
    samples = viewer.page.evaluate(f"studyTest.samples({now['a']}, {json.dumps(now['layer'])}, {step})")
    error = max(abs(seen - due) for stored, codes in samples
                for seen, due in zip(codes, shown_codes(stored, float(now["exposure"]))))
    viewer.report.check(error < 0.6, f"viewer: colours of {len(samples)} pixels follow the tone curve",
                        f"off by {error:.2f} codes")


def check_viewer(page, report):
    if not page.evaluate(f"{VIEWER} !== null"):
        print("none    the page has no viewer")
        return
    ready = page.wait_until(f"{VIEWER}.dataset.ready === 'true'", SECONDS_IN_ALL / 3)
    if not report.check(ready, "viewer: ready"):
        return
    viewer = Viewer(page, report)
    report.check(viewer.setting("mode") == "slider", "viewer: starts with the slider")
    check_divider(viewer)
    check_colors(viewer)
    check_picture_selects(viewer)
    check_difference(viewer)
    check_flip(viewer)
    check_layer(viewer)
    check_exposure(viewer)
    check_colors(viewer)
    check_pixel_values(viewer)


# ---- All together ----------------------------------------------------------------------------------------------------

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
