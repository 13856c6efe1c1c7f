import { describe, expect, test } from 'vitest';
import { systemViews } from '../../src/core/systems/registry.ts';
import { drawingOf } from '../drawings.ts';
import { glbOf } from '../../src/scene/export/gltf.ts';
import { readGlb, validateGlb } from '../browser/glb.ts';

/** The exporter reads its own blob as a page does; this is all of a page's reader that it uses. */
globalThis.FileReader ??= class {
  result: ArrayBuffer | null = null;
  onloadend: (() => void) | null = null;
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend?.();
    });
  }
} as unknown as typeof FileReader;

const FRAMES = 60;

/** A motion that turns everything, past full turns, in the system's own coordinates. */
function motionOf(id: string) {
  const { meta, poses, contacts } = systemViews[id]!;
  const parameters = Float64Array.from(meta.parameters, (p) => p.default);
  const { bodies, limbs } = drawingOf(meta, {});
  const stride = 12 * bodies.length;
  const all = new Float64Array(stride * FRAMES);
  const wheelAngles = new Float64Array(contacts.length * FRAMES);
  for (let k = 0; k < FRAMES; k++) {
    const q = Float64Array.from(meta.coordinates, (c, i) =>
      c.kind === 'angle' ? 0.15 * k * (i % 2 ? -1 : 1) : 0.01 * k * (i + 1),
    );
    const out = new Float64Array(stride);
    poses(q, parameters, out);
    limbs?.place(out);
    all.set(out, stride * k);
    for (let c = 0; c < contacts.length; c++) wheelAngles[contacts.length * k + c] = 0.9 * k;
  }
  return {
    poses: all,
    wheelAngles,
    wheels: contacts.length,
    times: Float64Array.from({ length: FRAMES }, (_, k) => 3 + k / 50),
  };
}

const write = (id: string, more: Partial<Parameters<typeof glbOf>[0]> = {}) => {
  const { meta } = systemViews[id]!;
  const drawing = drawingOf(meta, {});
  const motion = motionOf(id);
  const cast = { id, bodies: drawing.bodies, fixtures: drawing.fixtures, stage: drawing.stage };
  const { times, poses, wheelAngles, wheels } = motion;
  const stride = 12 * drawing.bodies.length;
  const at = (time: number) => {
    const k = times.indexOf(time);
    return {
      poses: poses.slice(stride * k, stride * (k + 1)),
      wheelAngles: wheelAngles.slice(wheels * k, wheels * (k + 1)),
    };
  };
  const blob = glbOf({
    title: meta.title,
    models: drawing.pairs,
    cast,
    theme: 'light',
    times,
    at,
    generator: 'RipStik Lab',
    extras: { start: 3, scenario: { version: 1, system: id } },
    ...more,
  });
  return { motion, cast, file: blob.then(async (file) => new Uint8Array(await file.arrayBuffer())) };
};

describe.each(Object.keys(systemViews))('%s as glTF', (id) => {
  test('validates without errors or warnings; every body has its keyframes', async () => {
    const { motion, cast, file } = write(id);
    const bytes = await file;
    const { issues } = await validateGlb(bytes);
    expect(issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
    const { json, track } = readGlb(bytes);
    expect(json.asset).toMatchObject({
      version: '2.0',
      generator: 'RipStik Lab',
      extras: { scenario: { system: id } },
    });
    expect(json.animations).toHaveLength(1);
    const stride = 12 * cast.bodies.length;
    cast.bodies.forEach(({ id: name }, body) => {
      const position = track(name, 'translation')!;
      const turn = track(name, 'rotation')!;
      expect(position.times).toEqual(Float32Array.from(motion.times, (t) => t - 3));
      let [away, turned, nearest] = [0, 0, 1];
      for (let k = 0; k < FRAMES; k++) {
        const pose = motion.poses.subarray(stride * k + 12 * body, stride * k + 12 * body + 12);
        for (let i = 0; i < 3; i++)
          away = Math.max(away, Math.abs(position.values[3 * k + i]! - Math.fround(pose[i]!)));
        const [x, y, z, w] = turn.values.subarray(4 * k, 4 * k + 4) as unknown as [number, number, number, number];
        const matrix = [
          1 - 2 * (y * y + z * z),
          2 * (x * y - w * z),
          2 * (x * z + w * y),
          2 * (x * y + w * z),
          1 - 2 * (x * x + z * z),
          2 * (y * z - w * x),
          2 * (x * z - w * y),
          2 * (y * z + w * x),
          1 - 2 * (x * x + y * y),
        ];
        turned = Math.max(turned, ...matrix.map((value, i) => Math.abs(value - pose[3 + i]!)));
        if (k > 0)
          nearest = Math.min(
            nearest,
            [0, 1, 2, 3].reduce((sum, i) => sum + turn.values[4 * k + i]! * turn.values[4 * k - 4 + i]!, 0),
          );
      }
      expect(away).toBe(0);
      expect(turned).toBeLessThan(1e-6);
      expect(nearest).toBeGreaterThanOrEqual(0);
    });
    const upright = json.nodes[json.scenes[0]!.nodes[0]!]!;
    expect(upright.rotation!.map((x) => Math.round(1e6 * x) / 1e6)).toEqual([-0.707107, 0, 0, 0.707107]);
  });
});

test('the board has five moving bodies and two wheels that spin', async () => {
  const { json } = readGlb(await write('ripstik').file);
  const moving = new Set(json.animations[0]!.channels.map(({ target }) => json.nodes[target.node]!.name));
  expect([...moving].filter((name) => !name.endsWith('-wheel'))).toHaveLength(5);
  expect([...moving].filter((name) => name.endsWith('-wheel'))).toHaveLength(2);
});

test('more keyframes than a part holds are written in order; the file is given up when the pause throws', async () => {
  const many = 9001;
  const { poses } = systemViews['ripstik']!;
  const parameters = Float64Array.from(systemViews['ripstik']!.meta.parameters, (p) => p.default);
  const out = new Float64Array(60);
  const at = (time: number) => {
    poses(Float64Array.of(time, 2 * time, 0.1, 0, 0, 0, 0, 0, 0, 0), parameters, out);
    return { poses: out, wheelAngles: Float64Array.of(time, time) };
  };
  const times = Float64Array.from({ length: many }, (_, k) => k / 1000);
  const seen: number[] = [];
  const bytes = await write('ripstik', {
    times,
    at,
    pause: (keys) => (seen.push(keys), keys % 1000 === 0 ? Promise.resolve() : null),
  }).file;
  expect((await validateGlb(bytes)).issues.messages.filter(({ severity }) => severity < 2)).toEqual([]);
  const { track } = readGlb(bytes);
  const { times: read, values } = track('rod', 'translation')!;
  expect(read).toEqual(Float32Array.from(times));
  expect(Float32Array.from({ length: many }, (_, k) => values[3 * k]!)).toEqual(Float32Array.from(times));
  expect(seen.at(-1)).toBe(many);
  await expect(
    write('ripstik', { times, at, pause: (keys) => (keys < 5000 ? null : Promise.reject(new Error('enough'))) }).file,
  ).rejects.toThrow('enough');
});
