import { describe, expect, test } from 'vitest';
import { Box3, Vector3 } from 'three';
import { modelsOf } from '../../../src/core/model/system.ts';
import { along, ball, box, pipe, torus, tube } from '../../../src/core/geometry/solids.ts';
import type { Triangle } from '../../../src/core/geometry/shapes.ts';
import { spokedWheel } from '../../../src/core/geometry/wheels.ts';
import type { SystemMeta } from '../../../src/core/model/system.ts';
import { systemViews } from '../../../src/core/systems/registry.ts';
import { drawingOf } from '../../drawings.ts';
import { parsePair } from '../../../src/scene/actors/bodies.ts';
import { checkMaterials, checkMesh } from '../../../src/scene/actors/meshText.ts';

const defaults = (meta: SystemMeta): Record<string, number> =>
  Object.fromEntries(meta.parameters.map((p) => [p.name, p.default]));

/** Bounds of one body or fixture in its own frame, as the scene reads them; of one group if named. */
function boundsOf(id: string, changed: Readonly<Record<string, number>>, model: string, group?: string): Box3 {
  const { meta } = systemViews[id]!;
  const parsed = parsePair(drawingOf(meta, { ...defaults(meta), ...changed }).pairs[model]!, model);
  const box = new Box3();
  for (const child of parsed.children) if (group === undefined || child.name === group) box.expandByObject(child, true);
  expect(box.isEmpty(), `${model} ${group ?? ''}`).toBe(false);
  return box;
}

/** Six times the enclosed volume: positive when faces look outwards. */
const volume = (triangles: readonly Triangle[]): number =>
  triangles.reduce((sum, [a, b, c]) => sum + new Vector3(...a).dot(new Vector3(...b).cross(new Vector3(...c))), 0) / 6;

/** Edges that no other face runs the other way along: none where a solid is closed. */
function openEdges(triangles: readonly Triangle[]): number {
  const key = (p: readonly number[]): string => p.map((x) => (Math.round(1e7 * x) || 0).toString()).join(' ');
  const edges = new Map<string, number>();
  for (const [a, b, c] of triangles) {
    const corners = [key(a), key(b), key(c)];
    if (new Set(corners).size < 3) continue;
    corners.forEach((from, i) => {
      const to = corners[(i + 1) % 3]!;
      const [name, way] = from < to ? [`${from}|${to}`, 1] : [`${to}|${from}`, -1];
      edges.set(name, (edges.get(name) ?? 0) + way);
    });
  }
  return [...edges.values()].filter((n) => n !== 0).length;
}

describe('solids are closed, face outwards and have the size they are given', () => {
  const cases: readonly [string, Triangle[], number][] = [
    ['box', box([0, 0, 0], [1, 2, 3], 1e-6), 6],
    ['tube', tube([1, 2, 3], [1, 2, 5], 0.5, 256), 2 * Math.PI * 0.25],
    ['slanted tube', tube([0, 0, 0], [1, 2, 2], 0.5, 256), 3 * Math.PI * 0.25],
    ['cone', tube([0, 0, 0], [0, 0, 3], 1, 256, 0.5), (Math.PI * 3 * (1 + 0.5 + 0.25)) / 3],
    ['ball', ball([5, 5, 5], 1, 128), (4 / 3) * Math.PI],
    ['ring', torus(along([0, 1, 0], [3, 0, 0]), 1, 0.1, 128), 2 * Math.PI ** 2 * 0.01],
  ];
  test.each(cases)('%s', (_, triangles, expected) => {
    expect(openEdges(triangles)).toBe(0);
    expect(Math.abs(volume(triangles) / expected - 1)).toBeLessThan(0.06);
  });

  test('a pipe and every part of a wheel but the tread, which is in two pieces', () => {
    expect(
      openEdges(
        pipe(
          [
            [0, 0, 0],
            [1, 0, 0],
            [1, 1, 0],
          ],
          0.1,
        ),
      ),
    ).toBe(0);
    const wheel = spokedWheel({ radius: 1, halfWidth: 0.1, spokes: 5, spokeRadius: 0.02 });
    const whole = wheel.filter(({ group }) => group !== 'mark').flatMap((part) => part.triangles);
    expect(openEdges(whole)).toBe(0);
    expect(volume(whole)).toBeGreaterThan(0);
  });
});

describe.each(Object.values(systemViews).map((view) => [view.meta.id, view] as const))('%s', (_, { meta }) => {
  const parameters = defaults(meta);
  const standard = drawingOf(meta, parameters);
  const variants: Record<string, Record<string, number>> = {
    defaults: parameters,
    'all zero': Object.fromEntries(Object.keys(parameters).map((name) => [name, 0])),
    'all negative': Object.fromEntries(Object.entries(parameters).map(([name, x]) => [name, -x])),
    'three times as large': Object.fromEntries(Object.entries(parameters).map(([name, x]) => [name, 3 * x])),
    nothing: {},
    'not numbers': Object.fromEntries(
      Object.keys(parameters).map((name, i) => [name, [NaN, Infinity, -Infinity][i % 3]!]),
    ),
  };

  // The board's own tests try odd parameters.
  test.each(Object.entries(variants).slice(0, meta.id === 'ripstik' ? 1 : undefined))(
    'every pair can be read by the scene: %s',
    (__, values) => {
      const { pairs, bodies, fixtures } = drawingOf(meta, values);
      // Pieces without a mass stand behind the bodies.
      const massive = bodies.filter(({ limb }) => !limb);
      expect(massive.map(({ id, role }) => ({ id, role }))).toEqual(meta.bodies.map(({ id, role }) => ({ id, role })));
      expect(bodies.slice(0, massive.length)).toEqual(massive);
      for (const { model } of [...bodies, ...fixtures]) {
        const { mdl, mat } = pairs[model]!;
        checkMesh(mdl, `${model}.mdl`);
        checkMaterials(mat, `${model}.mat`);
        expect(`${mdl}${mat}`).not.toMatch(/NaN|Infinity|undefined/);
        const known = new Set([...mat.matchAll(/^newmtl (.+)$/gm)].map((m) => m[1]));
        for (const [, used] of mdl.matchAll(/^usemtl (.+)$/gm)) expect(known).toContain(used);
      }
    },
  );

  test('has a drawing of its own, whose models a person can replace by name', () => {
    const { pairs, bodies, fixtures, stage } = standard;
    expect(Object.keys(pairs).sort()).toEqual([...new Set([...bodies, ...fixtures].map((b) => b.model))].sort());
    expect(modelsOf(meta)).toEqual([...new Set(bodies.filter(({ limb }) => !limb).map((b) => b.model))]);
    expect(Object.values(pairs).some(({ mdl }) => mdl.startsWith('# Marker at the origin'))).toBe(false);
    expect(stage.subject).toBeLessThan(bodies.length);
  });

  test('keeps within what software WebGL can draw', () => {
    const faces = Object.values(standard.pairs).reduce((sum, { mdl }) => sum + (mdl.match(/^f /gm)?.length ?? 0), 0);
    expect(faces).toBeLessThan(20_000);
  });
});

describe('what is shown is what is simulated', () => {
  test('wheels stand on the ground and have their radius all round', () => {
    for (const [id, name] of [
      ['rolling-wheel', 'rho'],
      ['wheel-pendulum', 'rho'],
    ] as const)
      for (const radius of [0.3, 1.7]) {
        const { min, max } = boundsOf(id, { [name]: radius }, 'wheel', 'tyre');
        for (const reach of [-min.x, max.x, -min.z, max.z]) expect(Math.abs(reach / radius - 1)).toBeLessThan(2e-3);
        expect(min.y).toBeCloseTo(-max.y, 5);
        expect(max.y).toBeLessThan(0.2 * radius);
      }
  });

  test('rods are as long as their parameters, along their own x', () => {
    for (const L of [0.4, 2]) {
      expect(boundsOf('cart-pendulum', { L }, 'pendulum', 'bob').getCenter(new Vector3()).x).toBeCloseTo(L, 4);
      expect(boundsOf('cart-pendulum', { L }, 'pendulum', 'joint').getCenter(new Vector3()).x).toBeCloseTo(0, 4);
      expect(boundsOf('wheel-pendulum', { L }, 'pendulum', 'rod').max.x).toBeCloseTo(2 * L, 4);
      expect(boundsOf('wheel-pendulum', { L }, 'pendulum', 'centre').getCenter(new Vector3()).x).toBeCloseTo(L, 4);
    }
  });

  test('eight times the mass is twice as large', () => {
    const side = (m2: number): number => boundsOf('cart-pendulum', { m2 }, 'pendulum', 'bob').getSize(new Vector3()).x;
    expect(side(0.8) / side(0.1)).toBeCloseTo(2, 3);
  });

  test('the pendulum falls past its rail, and its floor lies below the swing', () => {
    const { min, max } = boundsOf('cart-pendulum', {}, 'rail');
    const rod = boundsOf('cart-pendulum', {}, 'pendulum');
    expect(rod.max.y).toBeLessThan(min.y);
    expect(max.z).toBeLessThan(0);
    const { stage } = drawingOf(systemViews['cart-pendulum']!.meta, { L: 2 });
    expect(stage.floor).toBeLessThan(-2);
  });

  test("the skate point's circle has the trail for its radius and lies across the axis", () => {
    for (const [casterAngle, casterTrail] of [
      [0, 0.05],
      [0.5, -0.05],
      [0.5, 0.02],
    ] as const) {
      const size = boundsOf('caster-rotation', { casterAngle, casterTrail, casterDrop: 0.1 }, 'axis', 'circle').getSize(
        new Vector3(),
      );
      const radius = Math.abs(casterTrail);
      expect(size.y / 2).toBeCloseTo(radius, 2);
      expect(size.x / 2).toBeCloseTo(radius * Math.cos(casterAngle), 2);
      expect(size.z / 2).toBeCloseTo(radius * Math.sin(casterAngle), 2);
    }
  });

  test("the robot's weights stand l2 above the axis, its casters on the ground below the bar's ends", () => {
    for (const [l1, l2] of [
      [0.095, 0.115],
      [0.3, 0.1],
    ] as const) {
      expect(boundsOf('casterboard-robot', { l1, l2 }, 'front-arm', 'weight').getCenter(new Vector3()).z).toBeCloseTo(
        l2,
        4,
      );
      const bar = boundsOf('casterboard-robot', { l1, l2 }, 'body', 'bar');
      expect([bar.min.x, bar.max.x].map((x) => x / l1)).toEqual([expect.closeTo(-1, 3), expect.closeTo(1, 3)]);
      const wheel = boundsOf('casterboard-robot', { l1, l2 }, 'rear-wheel');
      expect(Math.abs(wheel.min.z)).toBeLessThan(1e-3 * l1);
      expect(wheel.max.z).toBeLessThanOrEqual(l1 / 2);
    }
  });

  test("the sleigh's blade stands on the ground at the origin, its mass a ahead of it (behind, if a is negative)", () => {
    for (const a of [0.1, 0.5, -0.2]) {
      const blade = boundsOf('chaplygin-sleigh', { a }, 'sleigh', 'blade');
      expect(Math.abs(blade.min.z)).toBeLessThan(1e-4);
      expect(blade.min.x).toBeCloseTo(-blade.max.x, 4);
      expect(boundsOf('chaplygin-sleigh', { a }, 'sleigh', 'mass').getCenter(new Vector3()).x).toBeCloseTo(a, 4);
      expect(Math.abs(boundsOf('chaplygin-sleigh', { a }, 'sleigh', 'feet').min.z)).toBeLessThan(1e-4);
    }
  });

  test('the bicycle: wheels of their radii, the fork from the hub to over its tyre, on the steering axis, the frame as long as the wheelbase', () => {
    const variants: Record<string, number>[] = [
      {},
      { rearRadius: 0.2, frontRadius: 0.4 },
      { wheelbase: 1.4, trail: 0.2, steerAxisTilt: 0.5 },
    ];
    for (const changed of variants) {
      const p = { ...defaults(systemViews['bicycle']!.meta), ...changed };
      for (const [wheel, radius] of [
        ['rear-wheel', p['rearRadius']!],
        ['front-wheel', p['frontRadius']!],
      ] as const) {
        const { min, max } = boundsOf('bicycle', changed, wheel, 'tyre');
        for (const reach of [-min.x, max.x, -min.z, max.z]) expect(Math.abs(reach / radius - 1)).toBeLessThan(2e-3);
      }
      expect(boundsOf('bicycle', changed, 'front-frame', 'axle').getCenter(new Vector3()).length()).toBeLessThan(1e-4);
      const fork = boundsOf('bicycle', changed, 'front-frame', 'fork');
      expect(fork.max.z).toBeGreaterThan(p['frontRadius']!);
      // Where the axis passes at the height of the grips, the bar is.
      const stem = boundsOf('bicycle', changed, 'front-frame', 'stem');
      const axisAt = (z: number): number => p['trail']! - (z + p['frontRadius']!) * Math.tan(p['steerAxisTilt']!);
      expect(axisAt(stem.max.z)).toBeLessThan(stem.max.x + 0.02 * p['wheelbase']!);
      expect(axisAt(stem.min.z)).toBeGreaterThan(stem.min.x);
      expect(boundsOf('bicycle', changed, 'rear-frame', 'frame').max.x).toBeLessThan(p['wheelbase']! + p['trail']!);
    }
  });

  test('the upper body that leans sits on the saddle, whatever the height of its hinge', () => {
    for (const hingeZ of [-1.011, -0.6]) {
      const body = boundsOf('bicycle-rider', { hingeZ }, 'rider', 'rider');
      // From the axis: up to the shoulders, and down to the hips around the saddle.
      const saddle = boundsOf('bicycle-rider', { hingeZ }, 'rear-frame', 'saddle');
      const p: Record<string, number> = { ...defaults(systemViews['bicycle-rider']!.meta), hingeZ };
      const onFrame = body.min.z - hingeZ - p['rearRadius']!;
      expect(Math.abs(onFrame - saddle.max.z)).toBeLessThan(0.1);
    }
  });

  test('one mark of the scale is the height 1, one is 0', () => {
    const { min, max } = boundsOf('stiff-decay', {}, 'scale', 'marks');
    expect([min.z, max.z]).toEqual([expect.closeTo(-1, 1), expect.closeTo(1, 1)]);
  });
});
