// SPDX-License-Identifier: MIT
// The curve of src/core/tone_map.cpp, then the sRGB encoding.

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
