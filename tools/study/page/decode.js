// SPDX-License-Identifier: MIT
// Shared-exponent bytes to linear light.

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
