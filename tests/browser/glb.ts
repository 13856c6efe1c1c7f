/** Binary glTF read without any of the program's own code, and judged by Khronos' validator. */
import { createRequire } from 'node:module';

interface Accessor {
  bufferView: number;
  byteOffset?: number;
  componentType: number;
  count: number;
  type: 'SCALAR' | 'VEC3' | 'VEC4';
}

export interface Gltf {
  asset: { version: string; generator: string; extras: { start: number; scenario: unknown } };
  nodes: { name: string; mesh?: number; children?: number[]; rotation?: number[]; translation?: number[] }[];
  scenes: { nodes: number[] }[];
  meshes: unknown[];
  materials: { name: string }[];
  accessors: Accessor[];
  bufferViews: { byteOffset?: number }[];
  animations: {
    name: string;
    channels: { sampler: number; target: { node: number; path: string } }[];
    samplers: { input: number; output: number; interpolation?: string }[];
  }[];
}

/** Keyframes of one node. */
export interface Track {
  times: Float32Array;
  values: Float32Array;
}

export function readGlb(bytes: Uint8Array): { json: Gltf; track(name: string, path: string): Track | undefined } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67) throw new Error('not a GLB file');
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Gltf;
  const floats = (index: number): Float32Array => {
    const { bufferView, byteOffset = 0, componentType, count, type } = json.accessors[index]!;
    if (componentType !== 5126) throw new Error('keyframes are not 32-bit floats');
    const from = bytes.byteOffset + 28 + length + (json.bufferViews[bufferView]!.byteOffset ?? 0) + byteOffset;
    const size = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    return new Float32Array(bytes.buffer.slice(from, from + 4 * size * count) as ArrayBuffer);
  };
  return {
    json,
    track(name, path) {
      const node = json.nodes.findIndex((n) => n.name === name);
      const { channels, samplers } = json.animations[0]!;
      const channel = channels.find(({ target }) => target.node === node && target.path === path);
      if (!channel) return undefined;
      const { input, output } = samplers[channel.sampler]!;
      return { times: floats(input), values: floats(output) };
    },
  };
}

export interface Verdict {
  issues: {
    numErrors: number;
    numWarnings: number;
    messages: { code: string; message: string; severity: number; pointer?: string }[];
  };
}

export function validateGlb(bytes: Uint8Array): Promise<Verdict> {
  const { validateBytes } = createRequire(import.meta.url)('gltf-validator') as {
    validateBytes(data: Uint8Array): Promise<Verdict>;
  };
  return validateBytes(bytes);
}
