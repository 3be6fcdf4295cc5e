// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors

/**
 * What a screenshot shows, counted in the browser's own canvas (no image library): share of magenta
 * pixels, of pixels unlike the page's background, and of distinct colours (4 bits a channel) among these.
 */
export async function pixelFacts(page, png, background = [18, 22, 26]) {
  return page.evaluate(async ([base64, [r0, g0, b0]]) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const colours = new Map();
    let drawn = 0, magenta = 0;
    for (let at = 0; at < data.length; at += 4) {
      const [r, g, b] = [data[at], data[at + 1], data[at + 2]];
      if (Math.abs(r - r0) + Math.abs(g - g0) + Math.abs(b - b0) < 24) continue;
      ++drawn;
      if (r > 200 && b > 200 && g < 80) ++magenta;
      const key = (r >> 4 << 8) | (g >> 4 << 4) | (b >> 4);
      colours.set(key, (colours.get(key) ?? 0) + 1);
    }
    const total = data.length / 4;
    const commonest = Math.max(0, ...colours.values());
    return { drawn: drawn / total, magenta: magenta / total, colours: colours.size,
             commonest: drawn ? commonest / drawn : 1 };
  }, [png.toString("base64"), background]);
}

/** Sentences about what is wrong with a picture of terrain; none when it is good. */
export function pictureProblems(facts, { drawn, relief }) {
  const percent = (share) => `${(100 * share).toFixed(1)} %`;
  const problems = [];
  if (facts.drawn < drawn) problems.push(`only ${percent(facts.drawn)} of the picture is drawn`);
  if (facts.magenta > 0.0005) problems.push(`${percent(facts.magenta)} of the picture is magenta`);
  if (!relief) return problems;
  if (facts.colours < 12) problems.push(`only ${facts.colours} colours: no relief`);
  if (facts.commonest > 0.75) problems.push(`one colour fills ${percent(facts.commonest)} of what is drawn`);
  return problems;
}
