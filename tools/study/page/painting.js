// SPDX-License-Identifier: MIT
// What the canvas shows of a state.

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
