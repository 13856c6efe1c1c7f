import { describe, expect, it } from 'vitest';
import { Trajectory } from '../../core/motion/trajectory.ts';
import { Controls } from './controls.ts';
import { Passage, type Gate } from './course.ts';
import { Measure } from './measure.ts';
import { bestOf, ghostAt, rideScenario, rowsOf, upTo } from './rides.ts';

const course: Gate[] = [
  { x: 1, y: 0, heading: 0 },
  { x: 3, y: 1, heading: Math.PI / 2 },
];

describe('a passage', () => {
  it('counts gates in order, forwards, within their posts, and tells when it was through', () => {
    const passage = new Passage(course);
    passage.at(0, 0, 2);
    passage.at(1, 2, 2);
    expect(passage.passed).toBe(0);
    passage.at(2, 0, 0);
    expect(passage.passed).toBe(0);
    passage.at(3, 2, 0);
    expect(passage.passed).toBe(1);
    passage.at(4, 3, 0);
    passage.at(5, 3, 2);
    expect(passage.finished).toBeCloseTo(4.5, 12);
  });
});

describe('controls', () => {
  it('tell only what changes, and let go of all at once', () => {
    const told: [string, number][] = [];
    const controls = new Controls((name, value) => told.push([name, value]));
    controls.press({ key: 'ArrowLeft' });
    controls.press({ key: 'ArrowLeft' });
    controls.press({ key: 'ArrowRight' });
    controls.release({ key: 'ArrowLeft' });
    controls.press({ key: 'W' });
    controls.releaseAll();
    expect(controls.press({ key: 'q' })).toBe(false);
    expect(told).toEqual([
      ['twist', 1],
      ['twist', 0],
      ['twist', -1],
      ['push', 1],
      ['twist', 0],
      ['push', 0],
    ]);
  });

  it('move legs and hips where they are free, by keys, stick and shoulders', () => {
    const told: [string, number][] = [];
    const controls = new Controls((name, value) => told.push([name, value]));
    const button = (value: number) => ({ value });
    const pad = (axes: number[], buttons: number[]) =>
      ({ connected: true, axes, buttons: buttons.map(button) }) as unknown as Gamepad;
    controls.gamepads([pad([0, 0, 0, 0.5], [0, 0, 0, 0, 1, 0])]);
    expect([controls.press({ key: 'c' }), told]).toEqual([false, []]);
    controls.body = true;
    controls.gamepads([pad([0, 0, 0, 0.5], [0, 0, 0, 0, 1, 0])]);
    expect(told.splice(0)).toEqual([
      ['crouch', 0.5],
      ['hips', 1],
    ]);
    controls.gamepads([]);
    controls.press({ key: 'C' });
    controls.press({ key: 'e' });
    controls.releaseAll();
    expect(told).toEqual([
      ['crouch', 0],
      ['hips', 0],
      ['crouch', 1],
      ['hips', -1],
      ['crouch', 0],
      ['hips', 0],
    ]);
  });

  it('take a stick with a rest in its middle', () => {
    const told: [string, number][] = [];
    const controls = new Controls((name, value) => told.push([name, value]));
    const pad = { connected: true, axes: [0.05, 0, -0.5], buttons: [] as GamepadButton[] } as unknown as Gamepad;
    controls.gamepads([null, pad]);
    expect(told).toEqual([['lean', 0.5]]);
    controls.gamepads([null]);
    expect(told).toEqual([
      ['lean', 0.5],
      ['lean', 0],
    ]);
  });
});

it('the measure takes the picture in which a command is first seen, and counts pictures left out', () => {
  const measure = new Measure();
  const picture = (now: number, time: number): void => {
    measure.frame(now);
    measure.shown(now + 3, time);
  };
  for (const [now, time] of [
    [0, 0],
    [16, 0.016],
    [32, 0.032],
  ] as const)
    picture(now, time);
  measure.told(20, 0.04);
  // The row at which a command begins shows nothing of it yet.
  picture(48, 0.04);
  picture(98, 0.096);
  expect(measure.latency).toBe(81);
  expect([measure.dropped, measure.frames]).toEqual([2, 7]);
});

it('a ride of a free body releases what is held of it', () => {
  expect(rideScenario(true, 1).release).toBeUndefined();
  expect(rideScenario(true, 1, [], {}, true).release).toEqual(['crouch', 'twist']);
  expect(rideScenario(false, 1, [], {}, true).release).toBeUndefined();
});

it('a ride goes on from a moment with what was told up to there', () => {
  const file = rideScenario(true, 1, [
    [0, 'push', 1],
    [3, 'twist', 1],
  ]);
  expect(upTo(file, 2)?.control).toMatchObject({ commands: [[0, 'push', 1]] });
  expect(upTo({ version: 1, system: 'ripstik' }, 2)).toBeNull();
});

it('the best ride waits at its end', () => {
  const columns = ['t', 'X', 'Y', 'X_dot', 'Y_dot'];
  const rows = Trajectory.of(columns, [
    Float64Array.of(0, 0.1, 0.15, 0.2, 0.3),
    Float64Array.of(0, 1, 1.5, 2, 3),
    Float64Array.of(0, 0, 1, 2, 3),
    new Float64Array(5),
    new Float64Array(5),
  ]);
  const best = bestOf(rows, ['X', 'Y'], 0.2);
  expect(rowsOf(best).column('X')).toEqual(Float64Array.of(0, 1, 2));
  expect(ghostAt(best, 0.05)).toEqual({ x: 0.5, y: 0 });
  expect(ghostAt(best, 9)).toEqual({ x: 2, y: 2 });
});
