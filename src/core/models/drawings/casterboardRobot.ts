import { type Sketch, sizeOf, type Value } from '../drawing.ts';
import { ball, box, drum, tube } from '../solids.ts';
import { along } from '../solids.ts';
import type { Part } from '../wavefront.ts';

/** An arm on its axis along x: the mass on its upper end. */
function arm(length: number, mass: number): Part[] {
  const rod = 0.05 * length;
  return [
    { group: 'joint', material: 'steel', triangles: drum(along([1, 0, 0], [0, 0, 0]), 3 * rod, 2.4 * rod, 28) },
    { group: 'arm', material: 'aluminium', triangles: tube([0, 0, 0], [0, 0, length], rod, 18) },
    { group: 'mass', material: 'accent', triangles: ball([0, 0, length], mass, 28) },
  ];
}

/** A caster on the ground below the axis at `height`: wheel and fork. */
function caster(height: number): Part[] {
  const radius = 0.45 * height;
  return [
    { group: 'wheel', material: 'grip', triangles: drum(along([0, 1, 0], [0, 0, radius]), radius, 0.3 * radius, 28) },
    { group: 'fork', material: 'aluminium', triangles: tube([0, 0, 1.05 * radius], [0, 0, height], 0.2 * radius, 16) },
  ];
}

/** A bar with an arm and a caster at each end. */
export function casterboardRobot(p: Value): Sketch {
  const [half, length] = [sizeOf(p('l1', 0.095)), sizeOf(p('l2', 0.115))];
  const mass = 0.24 * length * Math.cbrt(p('m2', 0.29) / 0.29);
  const bar = 0.2 * half;
  return {
    bodies: {
      body: { about: 'Body: origin at its centre, bar along x.', parts: [{ group: 'bar', material: 'paint', triangles: box([-half, -bar, -bar], [half, bar, bar], 0.12 * bar) }] },
      'front-arm': { about: 'Front arm: origin on the bar.', parts: arm(length, mass) },
      'rear-arm': { about: 'Rear arm: origin on the bar.', parts: arm(length, mass) },
      'front-wheel': { about: 'Front caster: origin on the ground, heading along x.', parts: caster(half / 2) },
      'rear-wheel': { about: 'Rear caster: origin on the ground, heading along x.', parts: caster(half / 2) },
    },
    stage: { subject: 'body' },
  };
}
