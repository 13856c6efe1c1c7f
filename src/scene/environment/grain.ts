/** What keeps the ground from looking like paper: a small tile of clouds and specks, the same every time. */
import { DataTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping, RGFormat } from 'three';

const SIDE = 128;

/** Numbers from 0 to 1 out of a position: Wang's integer hash. */
function chance(x: number, y: number, octave: number): number {
  let n = Math.imul(x + 1, 73856093) ^ Math.imul(y + 1, 19349663) ^ Math.imul(octave + 1, 83492791);
  n = Math.imul(n ^ 61 ^ (n >>> 16), 9);
  n = Math.imul(n ^ (n >>> 4), 0x27d4eb2d);
  return ((n ^ (n >>> 15)) >>> 0) / 0xffffffff;
}

/** Smooth noise with `cells` cells a side, which repeats with the tile. */
function clouds(x: number, y: number, cells: number): number {
  const [u, v] = [(x * cells) / SIDE, (y * cells) / SIDE];
  const [i, j] = [Math.floor(u), Math.floor(v)];
  const ease = (s: number): number => s * s * (3 - 2 * s);
  const [a, b] = [ease(u - i), ease(v - j)];
  const at = (di: number, dj: number): number => chance((i + di) % cells, (j + dj) % cells, cells);
  return (at(0, 0) * (1 - a) + at(1, 0) * a) * (1 - b) + (at(0, 1) * (1 - a) + at(1, 1) * a) * b;
}

/** Red: clouds; green: specks. Both have a mean of one half, which is all that is left of them far away. */
export function grainTexture(): DataTexture {
  const data = new Uint8Array(2 * SIDE * SIDE);
  for (let y = 0; y < SIDE; y++)
    for (let x = 0; x < SIDE; x++) {
      const cloud = 0.4 * clouds(x, y, 8) + 0.3 * clouds(x, y, 16) + 0.2 * clouds(x, y, 32) + 0.1 * clouds(x, y, 64);
      const speck = 0.5 + 0.35 * (chance(x, y, 0) - 0.5) + 0.4 * (clouds(x, y, 64) - 0.5);
      data[2 * (y * SIDE + x)] = Math.round(255 * cloud);
      data[2 * (y * SIDE + x) + 1] = Math.round(255 * speck);
    }
  const texture = new DataTexture(data, SIDE, SIDE, RGFormat);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}
