import { describe, expect, it } from 'vitest';
import { bodyOf, crouchOf, riderOf } from '../../../src/core/systems/ripstik-rider/person.ts';

/** Distance from the middle to a foot of somebody who stands at ease, m. */
const AT_EASE = 0.09;

describe('a rider by height and mass', () => {
  it('weighs what the person weighs, the centre at 56 to 58 % of the height, upright', () => {
    const { mass, centre } = bodyOf({ height: 1.75, mass: 75 }, 0, AT_EASE);
    expect(mass).toBeCloseTo(75, 9);
    expect(centre / 1.75).toBeGreaterThan(0.56);
    expect(centre / 1.75).toBeLessThan(0.58);
  });

  it('has moments of inertia as whole bodies are measured: about 12, 13 and 1.1 kg·m² at 75 kg', () => {
    const { inertia } = bodyOf({ height: 1.75, mass: 75 }, 0, AT_EASE);
    const [front, side, up] = inertia;
    expect(front).toBeGreaterThan(side);
    expect(front).toBeLessThan(14.5);
    expect(side).toBeGreaterThan(10.5);
    expect(up).toBeGreaterThan(0.9);
    expect(up).toBeLessThan(1.4);
  });

  it('goes with mass and with the square of height', () => {
    const [one, two] = [bodyOf({ height: 1.5, mass: 50 }, 0.4, 0.15), bodyOf({ height: 3, mass: 50 }, 0.4, 0.3)];
    expect(two.centre / one.centre).toBeCloseTo(2, 12);
    two.inertia.forEach((moment, i) => expect(moment / one.inertia[i]!).toBeCloseTo(4, 12));
    const heavy = bodyOf({ height: 1.5, mass: 100 }, 0.4, 0.15);
    expect(heavy.inertia[0] / one.inertia[0]).toBeCloseTo(2, 12);
  });

  it('has a good half of the inertia about the vertical in hips and above, feet together, whatever the legs do', () => {
    const person = { height: 1.75, mass: 75 };
    const { inertia, hips } = bodyOf(person, 0, AT_EASE);
    expect(hips / inertia[2]).toBeGreaterThan(0.5);
    expect(hips / inertia[2]).toBeLessThan(0.8);
    expect(bodyOf(person, 1, 0.3).hips).toBeCloseTo(hips, 9);
    expect(riderOf(person)['hipIzz']).toBeCloseTo(hips, 3);
  });

  it('crouches by 28 to 30 % of the height of the centre of mass', () => {
    const person = { height: 1.75, mass: 75 };
    const share = crouchOf(person) / riderOf(person)['riderHeight']!;
    expect(share).toBeGreaterThan(0.28);
    expect(share).toBeLessThan(0.3);
  });

  it('stands lower on a board than upright, near the default rider', () => {
    const rider = riderOf({ height: 1.7, mass: 70 });
    expect(rider['riderMass']).toBe(70);
    expect(Math.abs(rider['riderHeight']! - 0.9)).toBeLessThan(0.01);
  });
});
