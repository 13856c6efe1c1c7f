import { type Mesh, Scene } from 'three';
import { describe, expect, test } from 'vitest';
import { hubOf } from '../../src/core/systems/ripstik/drawing/layout.ts';
import { drawingOf } from '../drawings.ts';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import type { MeshPair } from '../../src/scene/contract.ts';
import { Bodies, parsePair } from '../../src/scene/actors/bodies.ts';
import { checkMaterials, checkMesh } from '../../src/scene/actors/meshText.ts';
import { palettes } from '../../src/scene/palette.ts';

const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n';
const { pairs, bodies: board } = drawingOf(ripstikMeta, {});
const models = pairs as Record<'rod' | 'front-plate' | 'back-plate' | 'caster', MeshPair>;

describe('mesh files that cannot be drawn are refused by file and line', () => {
  test.each([
    ['<!doctype html>', /rod\.mdl, line 1: .*not a statement/],
    ['v 0 0 0\nv 1 0\n', /rod\.mdl, line 2: “v” needs 3 numbers and has 2/],
    ['v 0 0 zero\n', /rod\.mdl, line 1: “zero” is not a number/],
    ['# none\n\nv 0 0 0\nf 1 2\n', /rod\.mdl, line 4: a face needs 3 points/],
    [`${TRIANGLE}f 1 2 4\n`, /rod\.mdl, line 5: “4” names point 4 of 3/],
    [`${TRIANGLE}f 1 2 -4\n`, /rod\.mdl, line 5/],
    [`${TRIANGLE}f 0 1 2\n`, /rod\.mdl, line 5: “0” does not name a point/],
    [`${TRIANGLE}f 1//9 2//9 3//9\n`, /rod\.mdl, line 5: .*\(vn\)/],
    ['v 0 0 0\n', /rod\.mdl: there are no faces/],
    ['', /rod\.mdl: there are no faces/],
  ])('%j', (text, message) => expect(() => checkMesh(text, 'rod.mdl')).toThrow(message));

  test.each([
    ['Kd 1 1 1', /rod\.mat, line 1: .*before the first/],
    ['newmtl a\nKd one 1 1', /rod\.mat, line 2/],
    ['newmtl', /rod\.mat, line 1/],
  ])('%j', (text, message) => expect(() => checkMaterials(text, 'rod.mat')).toThrow(message));
});

test('line ends, continued lines, negative indices and statements of no meaning here are read', () => {
  const text = 'mtllib x.mat\r\no a\r\nv 0 0 0\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\nbevel on\r\nf -3 -2 -1\r\n';
  const group = parsePair({ mdl: text, mat: '' }, 'rod');
  expect((group.children[0] as Mesh).geometry.getAttribute('position').count).toBe(3);
});

test('textures, which would ask the network, are left out', () => {
  expect(checkMaterials('newmtl a\nmap_Kd http://example.org/a.png\nKd 1 0 0\nbump b.png', 'a.mat')).toBe(
    'newmtl a\nKd 1 0 0',
  );
});

describe('the board', () => {
  const poses = new Float64Array(60);
  for (let body = 0; body < 5; body++) poses.set([body, 2, 3, 0, -1, 0, 1, 0, 0, 0, 0, 1], 12 * body);

  test('stands where the poses say, which may come before the meshes', () => {
    const bodies = new Bodies(new Scene(), palettes.light);
    bodies.place(poses, new Float64Array(0));
    expect(bodies.matrix(0)).toBeNull();
    bodies.setModels(models, board);
    expect(bodies.count).toBe(5);
    expect(bodies.matrix(4)!.toArray()).toEqual([0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 4, 2, 3, 1]);
    bodies.place(null, new Float64Array(0));
    expect(bodies.matrix(4)).toBeNull();
  });

  test('a wheel turns about its hub and stays in its place', () => {
    const scene = new Scene();
    const bodies = new Bodies(scene, palettes.light);
    bodies.setModels(models, board);
    const bounds = (angle: number): number[] => {
      bodies.place(poses, Float64Array.of(angle, 0));
      scene.updateMatrixWorld(true);
      return bodies.wheelCentre(3)!.toArray();
    };
    const [x, , z] = hubOf(Math.PI / 6, 0.04);
    const hub = [3, 2 + x, 3 + z];
    for (const angle of [0, 1, 2.5]) bounds(angle).forEach((x, i) => expect(x).toBeCloseTo(hub[i]!, 3));
  });

  test('a bad pair leaves the bodies that were there', () => {
    const bodies = new Bodies(new Scene(), palettes.light);
    bodies.setModels(models, board);
    bodies.place(poses, new Float64Array(0));
    expect(() => bodies.replace('rod', { mdl: 'nonsense', mat: '' })).toThrow(/rod\.mdl, line 1/);
    expect(() => bodies.setModels({ ...models, caster: { mdl: '', mat: '' } }, board)).toThrow(/caster\.mdl/);
    expect(() => bodies.setModels({ rod: models.rod }, board)).toThrow(/front-plate/);
    expect(() => bodies.replace('handlebar', models.rod)).toThrow(/no body “handlebar”.*rod/);
    expect(bodies.count).toBe(5);
    bodies.replace('caster', { mdl: TRIANGLE, mat: '' });
    expect(bodies.corners(3)).toHaveLength(8);
  });
});
