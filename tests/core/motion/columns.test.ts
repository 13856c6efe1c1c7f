import { expect, test } from 'vitest';
import { columnOf, columnsOf, shownFactor, shownUnit, symbolOf } from '../../../src/core/motion/columns.ts';
import { ColumnValues, everyRow, valuesOf } from '../../../src/core/motion/columnValues.ts';
import { plainText, symbolText } from '../../../src/core/motion/symbols.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { systemViews } from '../../../src/core/systems/registry.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const ripstik = systemViews['ripstik']!;
const SEED = 23;

/** A motion of random rows with every state and input recorded. */
function randomMotion(id: string, rows: number, random: () => number): Trajectory {
  const { meta } = systemViews[id]!;
  const names = meta.coordinates.map((c) => c.name);
  const columns = ['t', ...names, ...names.map((n) => `${n}_dot`), ...meta.inputs.map((i) => i.name)];
  return Trajectory.of(
    columns,
    columns.map((name) => Float64Array.from({ length: rows }, (_, i) => (name === 't' ? 0.01 * i : 2 * random() - 1))),
  );
}

test('every column of every system has a symbol, words and a unit that fits its kind', () => {
  expect(Object.keys(systemViews).length).toBeGreaterThan(5);
  for (const [id, view] of Object.entries(systemViews)) {
    const trajectory = randomMotion(id, 2, seeded(1));
    const columns = columnsOf(view, trajectory.columns);
    expect(new Set(columns.map((c) => c.name)).size, id).toBe(columns.length);
    for (const c of columns) {
      const where = `${id}.${c.name}`;
      expect(c.label, where).not.toBe('');
      expect(plainText(symbolOf(c)), where).not.toMatch(/alpha|theta|psi|phi|tau|lambda|_dot/);
      expect(c.degrees, where).toBe(/rad/.test(c.unit));
      expect(shownUnit(c, true), where).not.toMatch(/rad/);
      expect(shownFactor(c, false), where).toBe(1);
      // What is offered can be computed.
      expect(everyRow({ system: view, parameters: {}, trajectory }, c.name).length, where).toBe(2);
      expect(Number.isNaN(valuesOf({ system: view, parameters: {}, trajectory }, c.name).at(0)), where).toBe(false);
    }
  }
});

test('a rate wears a dot, a subscript stands below, words stay words', () => {
  expect(symbolText('α_fp', true)).toEqual([
    { text: 'α', math: true, dot: true },
    { text: 'fp', sub: true, math: true },
  ]);
  expect(symbolText('residual')).toEqual([{ text: 'residual' }]);
  expect(plainText(symbolOf(columnOf(ripstik.meta, 'alpha_fp_dot')))).toBe('α\u0307fp');
  expect(columnOf(ripstik.meta, 'rho_f_dot')).toMatchObject({
    symbol: 'ρ_f',
    rate: true,
    unit: 'rad/s',
    role: 'first',
  });
  expect(columnOf(ripstik.meta, 'lambda_2', ripstik.contacts).label).toBe('front wheel, vertical force');
  expect(columnOf(ripstik.meta, 'other')).toMatchObject({ symbol: 'other', unit: '' });
});

test('own rolls are the sums, power is u times its rate, work its integral, the path grows by its steps', () => {
  const random = seeded(SEED);
  const trajectory = randomMotion('ripstik', 300, random);
  const of = (name: string): Float64Array => everyRow({ system: ripstik, parameters: {}, trajectory }, name);
  const c = (name: string): Float64Array => trajectory.column(name)!;
  let [work, path] = [0, 0];
  for (let i = 0; i < 300; i++) {
    const where = `seed ${SEED}, row ${i}`;
    expect(of('rho_f')[i], where).toBe(c('alpha')[i]! + c('alpha_fp')[i]!);
    expect(of('rho_b_dot')[i], where).toBe(c('alpha_dot')[i]! + c('alpha_bp_dot')[i]!);
    expect(of('speed')[i], where).toBe(Math.hypot(c('X_dot')[i]!, c('Y_dot')[i]!));
    if (i > 0) {
      work += 0.5 * (c('t')[i]! - c('t')[i - 1]!) * (of('power')[i]! + of('power')[i - 1]!);
      path += Math.hypot(c('X')[i]! - c('X')[i - 1]!, c('Y')[i]! - c('Y')[i - 1]!);
    }
    expect(of('work')[i], where).toBeCloseTo(work, 12);
    expect(of('path')[i], where).toBeCloseTo(path, 12);
  }
});

test('a growing motion gives the same values as a finished one', () => {
  const whole = randomMotion('ripstik', 900, seeded(SEED + 1));
  const grown = new Trajectory(whole.columns);
  const source = { system: ripstik, parameters: {}, trajectory: grown };
  const made = ['path', 'rho_f', 'alpha', 'rod.z'].map((name) => new ColumnValues(source, name, true));
  for (let at = 0; at < 900; at += 150) {
    grown.append(
      whole.columns.map((name) => whole.column(name)!.subarray(at, at + 150)),
      150,
    );
    for (const column of made) column.get();
  }
  for (const column of made) {
    const other = new ColumnValues({ ...source, trajectory: whole }, column.name, true);
    expect([...column.get()], column.name).toEqual([...other.get()]);
  }
});

test('a wrapped angle stays within half a turn, between its rows too', () => {
  const trajectory = Trajectory.of(
    ['t', ...ripstik.meta.coordinates.map((c) => c.name)],
    ['t', ...ripstik.meta.coordinates.map((c) => c.name)].map((name) =>
      Float64Array.from({ length: 80 }, (_, i) => (name === 't' ? i : name === 'theta' ? 0.9 * i : 0)),
    ),
  );
  const theta = new ColumnValues({ system: ripstik, parameters: {}, trajectory }, 'theta', true);
  for (let time = 0; time < 79; time += 0.37) {
    expect(Math.abs(theta.at(time))).toBeLessThanOrEqual(Math.PI);
    expect(Math.cos(theta.at(time) - 0.9 * time)).toBeCloseTo(1, 10);
  }
});

test('kinetic and potential energy of a run add up to its energy', () => {
  const simulation = new Simulation(
    scenarioOf({ version: 1, system: 'ripstik', initial: { X_dot: 1 }, duration: 0.2 }),
    systems['ripstik']!,
    { extras: ['energy', 'energy-parts'] },
  );
  simulation.advance(() => false);
  const { columns } = simulation.takeChunk();
  const of = (name: string): Float64Array => columns[simulation.columns.indexOf(name)]!;
  expect(of('energy').length).toBe(21);
  of('energy').forEach((e, i) => expect(of('kinetic')[i]! + of('potential')[i]!).toBe(e));
});
