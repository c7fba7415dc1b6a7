// SPDX-License-Identifier: MIT
// Signed differences of luminance, in a diverging palette.

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
