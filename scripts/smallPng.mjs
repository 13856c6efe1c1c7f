// Makes a screenshot a third of its size: 256 colours, chosen where they are used, and the best compression.
// PNG as in the W3C Recommendation, 3rd ed.; plain Node, since no other part of the project needs an image library.
import { Buffer } from 'node:buffer';
import { crc32, deflateSync, inflateSync } from 'node:zlib';

const SIGNATURE = Buffer.from('89504e470d0a1a0a', 'hex');
const COLOURS = 256;

/** A palette PNG of an 8-bit RGB or RGBA one (alpha is dropped: screenshots are opaque). */
export function smallPng(png) {
  const { width, height, pixels } = decode(png);
  const { palette, indices } = quantise(pixels);
  const rows = Buffer.alloc(height * (width + 1)); // each row begins with its filter, 0: none
  for (let y = 0; y < height; y++) rows.set(indices.subarray(y * width, (y + 1) * width), y * (width + 1) + 1);
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 3], 8); // 8 bits, palette
  const data = deflateSync(rows, { level: 9, memLevel: 9 });
  return Buffer.concat([
    SIGNATURE,
    chunk('IHDR', head),
    chunk('PLTE', palette),
    chunk('IDAT', data),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  whole.set(body, 4);
  whole.writeUInt32BE(crc32(body), body.length + 4);
  return whole;
}

/** Pixels as 0xRRGGBB, one per entry. */
function decode(png) {
  const parts = [];
  let width = 0,
    height = 0,
    channels = 0;
  for (let at = SIGNATURE.length; at < png.length;) {
    const length = png.readUInt32BE(at);
    const type = png.toString('latin1', at + 4, at + 8);
    const data = png.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') {
      [width, height] = [data.readUInt32BE(0), data.readUInt32BE(4)];
      channels = { 2: 3, 6: 4 }[data[9]];
      if (data[8] !== 8 || !channels || data[12] !== 0) throw new Error('only 8-bit RGB or RGBA, not interlaced');
    }
    if (type === 'IDAT') parts.push(data);
    at += length + 12;
  }
  const raw = inflateSync(Buffer.concat(parts));
  const stride = width * channels;
  const pixels = new Uint32Array(width * height);
  let above = new Uint8Array(stride);
  for (let y = 0; y < height; y++) {
    const row = raw.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1));
    unfilter(raw[y * (stride + 1)], row, above, channels);
    for (let x = 0; x < width; x++)
      pixels[y * width + x] = (row[x * channels] << 16) | (row[x * channels + 1] << 8) | row[x * channels + 2];
    above = row;
  }
  return { width, height, pixels };
}

function unfilter(filter, row, above, channels) {
  for (let i = 0; i < row.length; i++) {
    const left = i < channels ? 0 : row[i - channels];
    const up = above[i];
    if (filter === 1) row[i] += left;
    else if (filter === 2) row[i] += up;
    else if (filter === 3) row[i] += (left + up) >> 1;
    else if (filter === 4) row[i] += paeth(left, up, i < channels ? 0 : above[i - channels]);
  }
}

function paeth(left, up, corner) {
  const guess = left + up - corner;
  const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

const channel = (colour, c) => (colour >> (16 - 8 * c)) & 255;

/** Boxes of colours are split at their mean where that removes most error (Wu's idea, without his tables). */
function quantise(pixels) {
  const counts = new Map();
  for (const pixel of pixels) counts.set(pixel, (counts.get(pixel) ?? 0) + 1);
  const boxes = [boxOf([...counts])];
  while (boxes.length < COLOURS) {
    const worst = boxes.reduce((a, b) => (b.error > a.error ? b : a));
    if (!(worst.error > 0)) break;
    const side = (below) =>
      worst.colours.filter(([colour]) => channel(colour, worst.axis) <= worst.mean[worst.axis] === below);
    boxes.splice(boxes.indexOf(worst), 1, boxOf(side(true)), boxOf(side(false)));
  }
  const index = new Map();
  boxes.forEach((box, i) => box.colours.forEach(([colour]) => index.set(colour, i)));
  return {
    palette: Buffer.from(boxes.flatMap((box) => box.mean.map(Math.round))),
    indices: Uint8Array.from(pixels, (pixel) => index.get(pixel)),
  };
}

/** Mean, and the axis along which the squared error is largest. */
function boxOf(colours) {
  const total = colours.reduce((sum, [, count]) => sum + count, 0);
  const mean = [0, 1, 2].map(
    (c) => colours.reduce((sum, [colour, count]) => sum + count * channel(colour, c), 0) / total,
  );
  const errors = mean.map((m, c) =>
    colours.reduce((sum, [colour, count]) => sum + count * (channel(colour, c) - m) ** 2, 0),
  );
  const axis = errors.indexOf(Math.max(...errors));
  return { colours, mean, axis, error: colours.length > 1 ? errors[axis] : 0 };
}
