// SPDX-License-Identifier: MIT
// The viewer of pictures: its state, and what a change of it redraws.

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
