import { describe, expect, it } from 'vitest';
import { ripstikMeta } from '../../../src/core/systems/ripstik/meta.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import {
  parameterDefault,
  sameContent,
  withEntry,
  withKey,
  withMethod,
  withParameterSet,
} from '../../../src/app/state/draft.ts';
import { fraction, timelineOf } from '../../../src/ui/stage/timeline.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import type { Motion } from '../../../src/app/runs/motion.ts';

const bare: ScenarioFile = { version: 1, system: 'ripstik' };

describe('edits of the draft', () => {
  it('make a new object and leave the old one alone', () => {
    const next = withEntry(bare, 'initial', 'X_dot', 1);
    expect(next).toEqual({ ...bare, initial: { X_dot: 1 } });
    expect(bare).toEqual({ version: 1, system: 'ripstik' });
  });

  it('take out the section with its last entry', () => {
    expect(withEntry(withEntry(bare, 'initial', 'X', 1), 'initial', 'X', undefined)).toEqual(bare);
    expect(withMethod(withMethod(bare, 'rtol', 1e-6), 'rtol', undefined)).toEqual(bare);
    expect(withKey({ ...bare, duration: 3 }, 'duration', undefined)).toEqual(bare);
  });

  it('know what a parameter is in each set', () => {
    expect(parameterDefault(ripstikMeta, undefined, 'casterTrail')).toBe(0.04);
    expect(parameterDefault(ripstikMeta, 'authors', 'casterTrail')).toBe(-0.04);
    expect(parameterDefault(ripstikMeta, 'authors', 'rodMass')).toBe(2);
  });

  it('drop parameters that the new set already holds', () => {
    const draft = { ...bare, parameters: { casterTrail: -0.04, rodMass: 3 } };
    expect(withParameterSet(draft, ripstikMeta, 'authors')).toEqual({
      ...bare,
      parameterSet: 'authors',
      parameters: { rodMass: 3 },
    });
  });

  it('compare by content', () => {
    expect(sameContent({ a: 1, b: [1, 2] }, { b: [1, 2], a: 1 })).toBe(true);
    expect(sameContent({ a: 1 }, { a: 1, b: undefined })).toBe(false);
    expect(sameContent([1], { 0: 1 })).toBe(false);
  });
});

describe('the time line', () => {
  const trajectory = new Trajectory(['t', 'X']);
  trajectory.append([Float64Array.of(1, 2, 3), Float64Array.of(0, 0, 0)], 3);
  const motion = { source: 'run', trajectory, scenario: { duration: 10 } } as unknown as Motion;

  it('runs to the planned end while rows come, then to the last row', () => {
    expect(timelineOf(motion, { kind: 'computing', progress: 0.3 })).toEqual({ start: 1, end: 10, available: 3 });
    expect(timelineOf(motion, { kind: 'ended', reason: 'touchdown', message: '', time: 3 })).toEqual({
      start: 1,
      end: 3,
      available: 3,
    });
    expect(timelineOf(null, null)).toEqual({ start: 0, end: 0, available: 0 });
  });

  it('places times between 0 and 1', () => {
    const line = { start: 1, end: 3, available: 3 };
    expect([0, 1, 2, 9].map((t) => fraction(t, line))).toEqual([0, 0, 0.5, 1]);
    expect(fraction(1, { start: 1, end: 1, available: 1 })).toBe(0);
  });
});
