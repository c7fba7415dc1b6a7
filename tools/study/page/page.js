// SPDX-License-Identifier: MIT
// What a study page does in the browser: legends of plots that hide their series, and the viewer of pictures.
// From here down: decode, tone map, difference, draw, controls, legends. No library, no network, works from file://.
"use strict";

(() => {

// ---- Decode: shared-exponent bytes to linear light -----------------------------------------------------------------

const BYTES_PER_PIXEL = 4;  // mantissas of red, green and blue, then their exponent
const EXPONENT_BIAS = 136;

/// The factor of each exponent byte; 0 means black.
const exponentScale = Float64Array.from({ length: 256 }, (_, e) => (e === 0 ? 0 : 2 ** (e - EXPONENT_BIAS)));

function bytesOfBase64(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/// Red, green, blue of each pixel, in rows from the top. A layer that is not there is black.
function decodeLight(base64, pixelCount) {
  const light = new Float32Array(pixelCount * 3);
  if (base64 === undefined) return light;
  const bytes = bytesOfBase64(base64);
  if (bytes.length !== pixelCount * BYTES_PER_PIXEL) {
    throw new Error(`a picture of ${bytes.length} bytes where ${pixelCount * BYTES_PER_PIXEL} are due`);
  }
  for (let from = 0, to = 0; from < bytes.length; from += BYTES_PER_PIXEL, to += 3) {
    const scale = exponentScale[bytes[from + 3]];
    light[to] = bytes[from] * scale;
    light[to + 1] = bytes[from + 1] * scale;
    light[to + 2] = bytes[from + 2] * scale;
  }
  return light;
}

// ---- Tone map: the curve of src/core/tone_map.cpp, then the sRGB encoding ------------------------------------------

const MID_GREY = 0.18;
const HUE_KEPT = 0.5;     // share of the hue-preserving form
const BRIGHTEST = 1e12;   // shown as 1; keeps powers of it finite
const SRGB_STEPS = 65535; // so fine that the encoding is off by less than 0.06 of a code

/// The identity up to mid-grey, above it t / (1 + t^p)^(1/p) with p = 3/2.
function bend(x) {
  if (x <= MID_GREY) return x;
  const t = (x - MID_GREY) / (1 - MID_GREY);
  const root = Math.cbrt(1 + t * Math.sqrt(t));
  return Math.min(MID_GREY + (1 - MID_GREY) * t / (root * root), 1);
}

function srgbFromLinear(v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;
}

/// 8-bit codes of display light in [0, 1]. The PNG files are dithered in addition, by less than one code.
const srgbCode = Uint8Array.from({ length: SRGB_STEPS + 1 },
  (_, i) => Math.round(255 * srgbFromLinear(i / SRGB_STEPS)));

function codeOf(display) {
  return srgbCode[(display * SRGB_STEPS + 0.5) | 0];
}

/// The picture as it is shown at an exposure in stops.
function toneMap(light, exposure, width, height) {
  const image = new ImageData(width, height);
  const codes = image.data;
  const gain = 2 ** exposure;
  for (let from = 0, to = 0; from < light.length; from += 3, to += 4) {
    const r = Math.min(light[from] * gain, BRIGHTEST);
    const g = Math.min(light[from + 1] * gain, BRIGHTEST);
    const b = Math.min(light[from + 2] * gain, BRIGHTEST);
    const peak = Math.max(r, g, b);
    if (peak <= MID_GREY) {
      codes[to] = codeOf(r);
      codes[to + 1] = codeOf(g);
      codes[to + 2] = codeOf(b);
    } else {
      const bentR = bend(r);
      const bentG = bend(g);
      const bentB = bend(b);
      const scale = HUE_KEPT * Math.max(bentR, bentG, bentB) / peak;  // the curve rises: of the peak
      codes[to] = codeOf((1 - HUE_KEPT) * bentR + scale * r);
      codes[to + 1] = codeOf((1 - HUE_KEPT) * bentG + scale * g);
      codes[to + 2] = codeOf((1 - HUE_KEPT) * bentB + scale * b);
    }
    codes[to + 3] = 255;
  }
  return image;
}

// ---- Difference: signed, of luminance, in a diverging palette ------------------------------------------------------

const DIFFERENCE_FLOOR = 0.01;  // added to A, so that black pixels do not count without bound
const PALETTE_STEPS = 512;      // even, so that 0 has its own entry

/// Evenly spaced from -1 (blue) over 0 (near white) to +1 (red).
const PALETTE_STOPS = [
  [12, 44, 112], [40, 106, 190], [128, 180, 228], [240, 240, 240], [240, 164, 136], [204, 66, 52], [112, 12, 32],
];

function luminance(light, at) {
  return 0.2126 * light[at] + 0.7152 * light[at + 1] + 0.0722 * light[at + 2];
}

function relativeDifference(a, b) {
  return (b - a) / (DIFFERENCE_FLOOR + a);
}

/// The colour at a place in [0, 1] of the palette.
function paletteColor(place) {
  const scaled = place * (PALETTE_STOPS.length - 1);
  const first = Math.min(Math.floor(scaled), PALETTE_STOPS.length - 2);
  return PALETTE_STOPS[first].map((v, c) => Math.round(v + (scaled - first) * (PALETTE_STOPS[first + 1][c] - v)));
}

const palette = Array.from({ length: PALETTE_STEPS + 1 }, (_, i) => paletteColor(i / PALETTE_STEPS));

function differenceImage(lightA, lightB, gain, width, height) {
  const image = new ImageData(width, height);
  const codes = image.data;
  for (let from = 0, to = 0; from < lightA.length; from += 3, to += 4) {
    const d = gain * relativeDifference(luminance(lightA, from), luminance(lightB, from));
    const color = palette[Math.round((Math.max(-1, Math.min(d, 1)) + 1) / 2 * PALETTE_STEPS)];
    codes[to] = color[0];
    codes[to + 1] = color[1];
    codes[to + 2] = color[2];
    codes[to + 3] = 255;
  }
  return image;
}

function paletteGradient() {
  return `linear-gradient(to right, ${PALETTE_STOPS.map((stop) => `rgb(${stop})`).join(", ")})`;
}

// ---- Draw: what the canvas shows of a state ------------------------------------------------------------------------

/// The same function, which returns its last result again while its arguments stay the same.
function rememberLast(compute) {
  let last = null;
  let result;
  return (...given) => {
    if (last === null || given.some((argument, i) => argument !== last[i])) {
      result = compute(...given);
      last = given;
    }
    return result;
  };
}

/// One side, A or B, of the viewer: decodes and tone maps only what changed.
function makeSide(width, height) {
  const decode = rememberLast((base64) => decodeLight(base64, width * height));
  const show = rememberLast((light, exposure) => toneMap(light, exposure, width, height));
  const light = (picture, layer) => decode(picture.layers[layer]);
  return { light, image: (picture, layer, exposure) => show(light(picture, layer), exposure) };
}

/// Loads pictures from data URLs; `changed` is called when one that was asked for has arrived or turned out broken.
function makeLoader(changed) {
  const pictures = new Map();
  const load = (url) => {
    const entry = { image: new Image(), state: "loading" };
    const settle = (state) => () => {
      entry.state = state;
      changed();
    };
    entry.image.onload = settle("loaded");
    entry.image.onerror = settle("broken");
    entry.image.src = url;
    pictures.set(url, entry);
    return entry;
  };
  return (url) => pictures.get(url) || load(url);
}

function splitColumn(state, width) {
  return Math.round(state.divider / 100 * width);
}

function flipUrl(data, state) {
  const { flip } = data.pictures[state.b];
  return flip ? flip[state.layer] : undefined;
}

/// What draws each mode onto a canvas of the size of the pictures.
function makePainters(data, context, changed) {
  const { width, height, pictures } = data;
  const sideA = makeSide(width, height);
  const sideB = makeSide(width, height);
  const difference = rememberLast((a, b, gain) => differenceImage(a, b, gain, width, height));
  const loader = makeLoader(changed);
  const lightA = (state) => sideA.light(pictures[state.a], state.layer);
  const lightB = (state) => sideB.light(pictures[state.b], state.layer);
  const imageA = (state) => sideA.image(pictures[state.a], state.layer, state.exposure);
  const imageB = (state) => sideB.image(pictures[state.b], state.layer, state.exposure);
  const flipOf = (state) => {
    const url = flipUrl(data, state);
    return url === undefined ? { state: "none" } : loader(url);
  };
  const paint = {
    slider(state) {
      const split = splitColumn(state, width);
      context.putImageData(imageA(state), 0, 0, 0, 0, split, height);
      context.putImageData(imageB(state), 0, 0, split, 0, width - split, height);
    },
    A: (state) => context.putImageData(imageA(state), 0, 0),
    B: (state) => context.putImageData(imageB(state), 0, 0),
    difference: (state) => context.putImageData(difference(lightA(state), lightB(state), state.gain), 0, 0),
    FLIP(state) {
      context.clearRect(0, 0, width, height);
      const flip = flipOf(state);
      if (flip.state === "loaded") context.drawImage(flip.image, 0, 0, width, height);
    },
  };
  return { paint: (state) => paint[state.mode](state), lightA, lightB, flipOf };
}

// ---- Words: what the viewer says -----------------------------------------------------------------------------------

const MODES = ["slider", "A", "B", "difference", "FLIP"];
const MINUS = "\u2212";
const SPACE = "\u00a0";

function layerLabel(layer) {
  return layer.replace(/^type(\d+)$/, `Type${SPACE}$1`);
}

function signed(value, digits) {
  const text = Math.abs(value).toFixed(digits);
  if (Number(text) === 0) return text;
  return (value < 0 ? MINUS : "+") + text;
}

function stopsText(exposure) {
  return `${signed(exposure, 2)}${SPACE}stops`;
}

function colorText(light, at) {
  return [0, 1, 2].map((c) => (light[at + c] === 0 ? "0" : light[at + c].toPrecision(3))).join(`${SPACE}${SPACE}`);
}

function isLeftOut(picture, layer) {
  return picture.layers[layer] === undefined;
}

function pictureText(letter, picture, layer) {
  return `${letter}: ${picture.name}${isLeftOut(picture, layer) ? ` (${layerLabel(layer)} left out)` : ""}`;
}

/// Why there is a FLIP map to see, or why there is none.
function flipText(data, state, flip) {
  const { name } = data.pictures[state.b];
  if (flip.state === "none" && state.b === 0) return `No FLIP map: B is the reference itself`;
  if (flip.state === "none") return `No FLIP map of ${layerLabel(state.layer)} is stored for ${name}`;
  if (flip.state === "broken") return `The FLIP map of ${name} cannot be read`;
  return `FLIP of ${name} against ${data.pictures[0].name}`;
}

/// The line under the canvas: its left, middle and right part.
function seenText(data, state, flip) {
  const a = pictureText("A", data.pictures[state.a], state.layer);
  const b = pictureText("B", data.pictures[state.b], state.layer);
  const layer = layerLabel(state.layer);
  const shown = `${layer}, ${stopsText(state.exposure)}`;
  switch (state.mode) {
    case "A": return [a, shown, ""];
    case "B": return ["", shown, b];
    case "difference": return [a, `${layer}, luminance, (B ${MINUS} A) / (${DIFFERENCE_FLOOR} + A)`, b];
    case "FLIP": return [flipText(data, state, flip), layer, ""];
    default: return [a, shown, b];
  }
}

function percentText(value) {
  return `${signed(100 * value, 1)}${SPACE}%`;
}

/// The values at a pixel: its place, A, B, and how B differs.
function pixelText(data, state, painters, pixel) {
  if (pixel === null) return ["Point at the picture to read its values.", "", "", ""];
  const at = (pixel.y * data.width + pixel.x) * 3;
  const a = painters.lightA(state);
  const b = painters.lightB(state);
  const value = (picture, light) => (isLeftOut(picture, state.layer) ? "left out" : colorText(light, at));
  return [
    `x${SPACE}${pixel.x}, y${SPACE}${pixel.y}`,
    `A${SPACE}${SPACE}${value(data.pictures[state.a], a)}`,
    `B${SPACE}${SPACE}${value(data.pictures[state.b], b)}`,
    `difference${SPACE}${SPACE}${percentText(relativeDifference(luminance(a, at), luminance(b, at)))}`,
  ];
}

// ---- Controls: elements and their events ---------------------------------------------------------------------------

const MAX_STOPS = 6;
const STOPS_STEP = 0.25;
const GAINS = [1, 4, 16];
const ZOOMS = [1, 2, 3, 4];
const KEY_STEPS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 };

/// A new element; attributes that are functions are listeners, false ones are left out.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== false) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

function makeSelect(name, label, options, chosen, choose) {
  const items = options.map(([value, text]) => make("option", { value, selected: value === chosen && "" }, text));
  const select = make("select", { name, change: () => choose(select.value) }, ...items);
  return make("label", { class: "control" }, make("span", {}, label), select);
}

function makeModes(chosen, choose) {
  const radio = (mode) => {
    const change = () => choose(mode);
    const input = make("input", { type: "radio", name: "mode", value: mode, checked: mode === chosen && "", change });
    return make("label", {}, input, make("span", {}, mode));
  };
  return make("fieldset", { class: "control modes" }, make("legend", {}, "Show"),
    make("div", { class: "choices" }, ...MODES.map(radio)));
}

function makeExposure(exposure, choose) {
  const output = make("output", {}, stopsText(exposure));
  const range = make("input", {
    type: "range", name: "exposure", min: -MAX_STOPS, max: MAX_STOPS, step: STOPS_STEP, value: exposure,
    input: () => {
      output.textContent = stopsText(range.valueAsNumber);
      choose(range.valueAsNumber);
    },
  });
  return make("label", { class: "control" }, make("span", {}, "Exposure"),
    make("span", { class: "range" }, range, output));
}

/// The largest whole zoom at which the picture is seen without scrolling, "fit" if even the smallest is too large.
function defaultZoom(data, room) {
  const fits = (zoom) => zoom * data.width <= room && zoom * data.height <= 0.8 * window.innerHeight;
  const zoom = ZOOMS.filter(fits).pop();
  return zoom === undefined ? "fit" : String(zoom);
}

function layersOf(pictures) {
  return [...new Set(pictures.flatMap((picture) => Object.keys(picture.layers)))];
}

function makeControls(data, state, change) {
  const names = data.pictures.map((picture, i) => [String(i), picture.name]);
  const layers = layersOf(data.pictures).map((layer) => [layer, layerLabel(layer)]);
  const gains = GAINS.map((gain) => [String(gain), `\u00d7${gain}`]);
  const zooms = [...ZOOMS.map((zoom) => [String(zoom), `${zoom}\u00d7`]), ["fit", "fit"]];
  const gain = makeSelect("gain", "Gain", gains, String(state.gain), (value) => change({ gain: Number(value) }));
  gain.classList.add("gain");
  return make("div", { class: "controls" },
    makeSelect("a", "A", names, String(state.a), (value) => change({ a: Number(value) })),
    makeSelect("b", "B", names, String(state.b), (value) => change({ b: Number(value) })),
    makeSelect("layer", "Light", layers, state.layer, (layer) => change({ layer })),
    makeModes(state.mode, (mode) => change({ mode })),
    makeExposure(state.exposure, (exposure) => change({ exposure })),
    makeSelect("zoom", "Zoom", zooms, state.zoom, (zoom) => change({ zoom })),
    gain);
}

function makeDivider(state, change) {
  const move = (percent) => change({ divider: Math.max(0, Math.min(percent, 100)) });
  const press = (event) => {
    const ends = { Home: 0, End: 100 };
    const step = KEY_STEPS[event.key];
    if (event.key in ends) move(ends[event.key]);
    else if (step !== undefined) move(state.divider + step * (event.shiftKey ? 10 : 1));
    else return;
    event.preventDefault();
  };
  return make("div", {
    class: "divider", role: "slider", tabindex: 0, "aria-label": "Divider: A is left of it, B right",
    "aria-orientation": "horizontal", "aria-valuemin": 0, "aria-valuemax": 100, keydown: press,
  });
}

/// Where an event is on the canvas: from 0 to 1 in each direction, not clamped.
function placeOnCanvas(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
}

function pixelAt(data, place) {
  const x = Math.floor(place.x * data.width);
  const y = Math.floor(place.y * data.height);
  return x >= 0 && y >= 0 && x < data.width && y < data.height ? { x, y } : null;
}

/// In the mode of the slider a press anywhere on the picture takes the divider there, and holds it.
function followPointer(stage, canvas, divider, data, state, change) {
  let held = false;
  const percent = (place) => Math.round(1000 * Math.max(0, Math.min(place.x, 1))) / 10;
  const follow = (event) => {
    const place = placeOnCanvas(canvas, event);
    change({ pixel: pixelAt(data, place), ...(held && { divider: percent(place) }) });
  };
  const release = () => {
    held = false;
  };
  stage.addEventListener("pointerdown", (event) => {
    if (state.mode !== "slider" || event.button !== 0) return;
    held = true;
    stage.setPointerCapture(event.pointerId);
    divider.focus({ preventScroll: true });
    event.preventDefault();
    follow(event);
  });
  stage.addEventListener("pointermove", follow);
  stage.addEventListener("pointerup", release);
  stage.addEventListener("pointercancel", release);
  stage.addEventListener("pointerleave", () => change({ pixel: null }));
}

function makeParts(className, count) {
  return make("div", { class: className }, ...Array.from({ length: count }, () => make("span")));
}

function setParts(line, texts) {
  texts.forEach((text, i) => {
    line.children[i].textContent = text;
  });
}

/// The bar that says what the colours of a difference mean.
function makeScale() {
  const bar = make("span", { class: "bar" });
  bar.style.background = paletteGradient();
  return make("div", { class: "scale" }, make("span"), bar, make("span"));
}

function setScale(scale, gain) {
  const end = `${100 / gain}${SPACE}%`;
  scale.firstChild.textContent = `B darker, ${MINUS}${end}`;
  scale.lastChild.textContent = `+${end}, B brighter`;
}

function setZoom(viewer, data, zoom) {
  const fit = `min(100%, ${80 * data.width / data.height}vh)`;
  viewer.style.setProperty("--picture-width", zoom === "fit" ? fit : `${Number(zoom) * data.width}px`);
}

function setDivider(divider, percent) {
  divider.style.left = `${percent}%`;
  divider.setAttribute("aria-valuenow", Math.round(percent));
  divider.setAttribute("aria-valuetext", `${Math.round(percent)} % of the width shows A`);
}

/// The state as attributes of the viewer: the style sheet and tests read them.
function publish(viewer, state) {
  const { mode, a, b, layer, exposure, divider, gain, zoom } = state;
  Object.assign(viewer.dataset, { mode, a, b, layer, exposure, divider, gain, zoom });
}

function initialState(data, room) {
  const layers = layersOf(data.pictures);
  return {
    mode: "slider",
    a: 0,
    b: Math.min(1, data.pictures.length - 1),
    layer: layers.includes("whole") ? "whole" : layers[0],
    exposure: data.exposure || 0,
    divider: 50,
    gain: 4,
    zoom: defaultZoom(data, room),
    pixel: null,
  };
}

function buildViewer(viewer, data) {
  const state = initialState(data, viewer.clientWidth);
  const canvas = make("canvas", { width: data.width, height: data.height, role: "img" });
  let waiting = false;
  const redraw = () => {
    if (!waiting) requestAnimationFrame(draw);
    waiting = true;
  };
  const change = (changes) => {
    Object.assign(state, changes);
    redraw();
  };
  const painters = makePainters(data, canvas.getContext("2d"), redraw);
  const divider = makeDivider(state, change);
  const stage = make("div", { class: "stage" }, canvas, divider);
  const scale = makeScale();
  const seen = makeParts("seen", 3);
  const pixel = makeParts("pixel", 4);

  function draw() {
    waiting = false;
    painters.paint(state);
    setZoom(viewer, data, state.zoom);
    setDivider(divider, state.divider);
    setScale(scale, state.gain);
    const texts = seenText(data, state, painters.flipOf(state));
    setParts(seen, texts);
    canvas.setAttribute("aria-label", texts.filter(Boolean).join("; "));
    setParts(pixel, pixelText(data, state, painters, state.pixel));
    publish(viewer, state);
  }

  followPointer(stage, canvas, divider, data, state, change);
  const scroll = make("div", { class: "scroll" }, stage);
  viewer.replaceChildren(makeControls(data, state, change), scroll, seen, scale, pixel);
  draw();
  viewer.dataset.ready = "true";
}

function startViewer() {
  const viewer = document.getElementById("viewer");
  const source = document.getElementById("pictures-data");
  if (viewer && source) buildViewer(viewer, JSON.parse(source.textContent));
}

// ---- Legends: an entry hides and shows its series ------------------------------------------------------------------

function toggleSeries(plot, entry) {
  const off = !entry.classList.contains("off");
  for (const part of plot.querySelectorAll(".series, .legend")) {
    if (part.dataset.series === entry.dataset.series) part.classList.toggle("off", off);
  }
  entry.setAttribute("aria-pressed", String(!off));
}

function startLegendEntry(plot, entry) {
  entry.setAttribute("aria-pressed", String(!entry.classList.contains("off")));
  entry.addEventListener("click", () => toggleSeries(plot, entry));
  entry.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    if (!event.repeat) toggleSeries(plot, entry);
  });
}

function startLegends() {
  for (const plot of document.querySelectorAll("svg.plot")) {
    for (const entry of plot.querySelectorAll(".legend[data-series]")) startLegendEntry(plot, entry);
  }
}

startLegends();
startViewer();

})();
