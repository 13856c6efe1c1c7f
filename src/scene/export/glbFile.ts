/** A binary glTF 2.0 file taken apart, and put together again with an animation behind its meshes. */
import type { BodyKeys, NodeTrack, TimeKeys, WheelKeys } from './keyframes.ts';

/** Khronos, glTF 2.0 Specification, section "GLB File Format Specification": magic, version, chunk types. */
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const FLOAT = 5126;
const TYPES = { time: 'SCALAR', translation: 'VEC3', rotation: 'VEC4' } as const;
const SIZES = { time: 1, translation: 3, rotation: 4 } as const;

interface Gltf {
  accessors?: object[];
  bufferViews?: object[];
  animations?: object[];
  buffers?: { byteLength: number }[];
}

export interface MovingNode {
  /** Index in the file. */
  node: number;
  keys: BodyKeys | WheelKeys;
}

/** @param still a GLB file with one buffer. @throws Error when the result would be too long for its format (4 GB). */
export function withAnimation(still: ArrayBuffer, name: string, times: TimeKeys, nodes: readonly MovingNode[]): Blob {
  const view = new DataView(still);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(still, 20, length))) as Gltf;
  const meshes = new Uint8Array(still, 28 + length, view.getUint32(20 + length, true));
  const parts: BlobPart[] = [meshes];
  let bytes = meshes.byteLength;
  const accessor = (kind: keyof typeof TYPES, { parts: own }: NodeTrack['floats'], limits: object = {}): number => {
    const byteLength = 4 * SIZES[kind] * times.count;
    const bufferView = (json.bufferViews ??= []).push({ buffer: 0, byteOffset: bytes, byteLength }) - 1;
    parts.push(...own);
    bytes += byteLength;
    return (
      (json.accessors ??= []).push({
        bufferView,
        componentType: FLOAT,
        count: times.count,
        type: TYPES[kind],
        ...limits,
      }) - 1
    );
  };
  times.floats.close();
  const input = accessor('time', times.floats, { min: [0], max: [times.last] });
  const [samplers, channels]: [object[], object[]] = [[], []];
  for (const { node, keys } of nodes) {
    for (const { path, floats } of keys.tracks) {
      floats.close();
      channels.push({
        sampler: samplers.push({ input, output: accessor(path, floats), interpolation: 'LINEAR' }) - 1,
        target: { node, path },
      });
    }
  }
  json.animations = [{ name, samplers, channels }];
  json.buffers = [{ byteLength: bytes }];
  return framed(json, parts, bytes);
}

function framed(json: object, parts: readonly BlobPart[], bytes: number): Blob {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = new Uint8Array(4 * Math.ceil(text.length / 4)).fill(0x20);
  padded.set(text);
  const total = 28 + padded.length + bytes;
  if (total >= 2 ** 32) throw new Error('So many keyframes are too long for a GLB file.');
  const head = Uint32Array.of(MAGIC, 2, total, padded.length, JSON_CHUNK);
  return new Blob([head, padded, Uint32Array.of(bytes, BINARY_CHUNK), ...parts], { type: 'model/gltf-binary' });
}
