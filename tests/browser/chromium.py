# SPDX-License-Identifier: MIT
"""A headless Chromium, steered over --remote-debugging-pipe: it reads commands from file descriptor 3 and writes to 4, JSON
ended by a NUL byte. Needs the standard library only.
"""
import base64
import fcntl
import json
import os
import pathlib
import select
import shutil
import signal
import tempfile
import time

SECONDS_IN_ALL = 30
SECONDS_FOR_A_CHANGE = 3
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
