// SPDX-License-Identifier: MIT
// The elements of the viewer, and their events.

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
