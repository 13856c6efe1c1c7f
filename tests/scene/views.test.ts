import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { castOf } from '../../src/core/geometry/drawing.ts';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import { arrowLength, LONGEST, METRES_PER_NEWTON } from '../../src/scene/overlay/forces.ts';
import { labelStep, metreLabel } from '../../src/scene/overlay/labels.ts';
import { finishOf } from '../../src/scene/actors/materials.ts';
import { palettes } from '../../src/scene/palette.ts';
import { isSoftwareRenderer } from '../../src/scene/environment/device.ts';
import {
  FIELD_OF_VIEW,
  fitDistance,
  type Block,
  headingOf,
  placeView,
  subjectOf,
  type Triple,
} from '../../src/scene/camera/views.ts';

const minus = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

describe('named views', () => {
  const position: Triple = [3, -2, 0.12];
  const board: Block = { low: [-0.44, -0.11, -0.1], high: [0.44, 0.11, 0.05] };

  test('stand where their name says, relative to the heading', () => {
    for (const heading of [0, 0.7, -2.5]) {
      const seen = (name: 'front' | 'side' | 'top'): [ahead: number, left: number, up: number] => {
        const { camera, target } = placeView(name, board, position, heading, 1.6);
        const [x, y, z] = minus(camera, target);
        return [Math.cos(heading) * x + Math.sin(heading) * y, Math.cos(heading) * y - Math.sin(heading) * x, z];
      };
      const [front, side, top] = [seen('front'), seen('side'), seen('top')];
      expect(front[0]).toBeGreaterThan(1);
      expect(front[1]).toBeCloseTo(0, 9);
      expect(side[0]).toBeCloseTo(0, 9);
      expect(side[1]).toBeLessThan(-1); // from the right: forward is to the right on the screen
      expect(Math.hypot(top[0], top[1])).toBeLessThan(0.01 * top[2]);
    }
  });

  test('keep every corner in the picture on any frame, of whatever size and form', () => {
    const pole: Block = { low: [-0.1, -0.1, -1], high: [0.1, 0.1, 1.1] };
    const speck: Block = { low: [0, -0.01, 0], high: [0.03, 0.01, 0.02] };
    for (const block of [board, pole, speck])
      for (const name of ['orbit', 'front', 'side', 'top', 'caster'] as const)
        for (const aspect of [0.5, 1, 1.78, 3]) {
          const { camera, target } = placeView(name, block, position, 0.7, aspect);
          const eye = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI, aspect, 1e-3, 100);
          eye.up.set(0, 0, 1);
          eye.position.set(...camera);
          eye.lookAt(...target);
          eye.updateMatrixWorld();
          for (const x of [block.low[0], block.high[0]])
            for (const y of [block.low[1], block.high[1]])
              for (const z of [block.low[2], block.high[2]]) {
                const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
                const seen = new Vector3(
                  position[0] + c * x - s * y,
                  position[1] + s * x + c * y,
                  position[2] + z,
                ).project(eye);
                expect(Math.max(Math.abs(seen.x), Math.abs(seen.y)), `${name} at ${aspect}`).toBeLessThan(1);
              }
        }
    expect(fitDistance(1, 1, 0.5)).toBeCloseTo(2 * fitDistance(1, 1, 1), 9);
  });

  test('the close-up looks at the front caster where there is one', () => {
    const { stage: boardStage } = castOf(ripstikMeta, {});
    expect([
      subjectOf('caster', boardStage),
      subjectOf('caster', { ...boardStage, closeUp: null }),
      subjectOf('side', boardStage),
    ]).toEqual([3, 0, 0]);
  });

  test('heading is the yaw of the forward axis, whatever the roll', () => {
    const [c, s] = [Math.cos(0.4), Math.sin(0.4)];
    // Rz(0.4) Rx(0.9) by rows, after a position.
    const [cr, sr] = [Math.cos(0.9), Math.sin(0.9)];
    const rolled = [1, 2, 3, c, -s * cr, s * sr, s, c * cr, -c * sr, 0, sr, cr];
    expect(headingOf(rolled)).toBeCloseTo(0.4, 12);
    expect(headingOf(rolled, 0, 'axle')).toBeCloseTo(0.4, 12);
    expect(headingOf(rolled, 0, 'world')).toBe(0);
  });

  test('a rolling wheel faces across its axle, however far it has turned', () => {
    const [c, s] = [Math.cos(0.4), Math.sin(0.4)];
    // Rz(0.4) Ry(2.5) by rows.
    const [cy, sy] = [Math.cos(2.5), Math.sin(2.5)];
    expect(headingOf([0, 0, 1, c * cy, -s, c * sy, s * cy, c, s * sy, -sy, 0, cy], 0, 'axle')).toBeCloseTo(0.4, 12);
  });
});

test('materials are told apart by their names', () => {
  expect(finishOf('aluminium').kind).toBe('aluminium');
  expect(finishOf('brushed_Aluminum.001').kind).toBe('aluminium');
  expect(finishOf('steel').metalness).toBe(1);
  expect(finishOf('deck-rubber').roughness).toBeGreaterThan(0.8);
  expect(finishOf('urethane').glow).toBeGreaterThan(0);
  expect(finishOf('accent').kind).toBe('accent');
  expect(finishOf('no such material').kind).toBe('plastic');
  // Without an environment softboxes are all there is to mirror: metals keep some colour of their own.
  for (const name of ['steel', 'aluminium'])
    expect(finishOf(name).plainMetalness).toBeLessThan(finishOf(name).metalness - 0.1);
});

test('arrows are proportional to the force, then clamped, and absent for none', () => {
  expect(arrowLength(20)).toBeCloseTo(20 * METRES_PER_NEWTON, 12);
  expect(arrowLength(1e9)).toBe(LONGEST);
  expect(arrowLength(0)).toBe(0);
});

test('labels say the axis and metres with a true minus sign', () => {
  expect(metreLabel('x', -3)).toBe('x \u22123\u2009m');
  expect(metreLabel('y', 0)).toBe('y 0\u2009m');
  expect([1, 8, 20, 500].map((distance) => labelStep(distance))).toEqual([1, 2, 5, 10]);
  expect([0.5, 1].map((distance) => labelStep(distance, 0.1))).toEqual([0.1, 0.2]);
  expect(metreLabel('x', 3 * 0.1)).toBe('x 0.3\u2009m');
});

test('front and back differ from each other and from the ground in both themes', () => {
  const luminance = (css: string): number => {
    const [r, g, b] = [1, 3, 5].map((i) => (parseInt(css.slice(i, i + 2), 16) / 255) ** 2.2) as [
      number,
      number,
      number,
    ];
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (const { role, ground } of Object.values(palettes)) {
    expect(role.first).not.toBe(role.second);
    for (const colour of [role.first, role.second]) {
      const [a, b] = [luminance(colour), luminance(ground)].sort((p, q) => q - p) as [number, number];
      expect((a + 0.05) / (b + 0.05)).toBeGreaterThan(3); // WCAG, for graphics
    }
  }
});

test('renderers on the processor are known by their names', () => {
  expect(isSoftwareRenderer('ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)')).toBe(
    true,
  );
  expect(isSoftwareRenderer('llvmpipe (LLVM 15.0.6, 256 bits)')).toBe(true);
  expect(isSoftwareRenderer('ANGLE (Intel, Mesa Intel(R) UHD Graphics 620, OpenGL 4.6)')).toBe(false);
});
