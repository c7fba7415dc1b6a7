# SPDX-License-Identifier: MIT
"""Checks of the viewer of pictures on a study page, by real input events."""
import json
import select
import time

from chromium import SECONDS_IN_ALL

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
