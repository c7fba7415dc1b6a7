// SPDX-License-Identifier: MIT
// What the viewer says.

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
