import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { deriveSystem, faultOf, readSystem } from '../../src/core/description/index.ts';
import { templates } from '../../src/core/description/templates.ts';
import { StartError } from '../../src/core/mechanics/consistentStart.ts';
import { checkScenario } from '../../src/core/scenario/schema.ts';
import '../../src/core/simulation/everyMotion.ts';
import { Simulation } from '../../src/core/simulation/simulation.ts';
import { damaged } from './damage.ts';
import { runs, SEED, tally } from './tally.ts';

/** Descriptions of strangers: read or refused at a place, derived or refused by name, run or ended with a reason; nothing else. */

const texts = await Promise.all(templates.map(async ({ load }) => (await load()).default));
const count = tally('descriptions');
const settings = { seed: SEED };
const MOST_STEPS = 60;

const names = ['x', 'y', 'phi', 'm', 'k', 'A', 'P', 'rod', 'rolling', 'tau', 'e', 'gravity', 't', 'pi'];
const name = fc.constantFrom(...names);
const rate = fc.constantFrom("x'", "y'", "phi'", 'phi_dot');
const number = fc.constantFrom('0', '1', '2.5', '1e-3', '1e300', '90 deg', '1/3');
const { scalar } = fc.letrec<{ scalar: string; vector: string }>((tie) => ({
  scalar: fc.oneof(
    { maxDepth: 5, depthSize: 'small' },
    name,
    rate,
    number,
    fc
      .tuple(tie('scalar'), fc.constantFrom('+', '-', '*', '/', '^', ' ', '<', '=='), tie('scalar'))
      .map((p) => p.join('')),
    tie('scalar').map((x) => `(${x})`),
    fc
      .tuple(fc.constantFrom('sin', 'cos', 'exp', 'log', 'sqrt', 'abs', 'atan', 'rate'), tie('scalar'))
      .map(([f, x]) => `${f}(${x})`),
    fc.tuple(tie('vector'), tie('vector')).map(([a, b]) => `dot(${a}, ${b})`),
    fc.constantFrom('P.z', 'rod.x', 'rod.x.z', 'norm(P)'),
  ),
  vector: fc.oneof(
    { maxDepth: 4, depthSize: 'small' },
    fc.constantFrom('P', 'rod.y', 'world.z', 'velocity(P)', 'omega(rod)'),
    fc.tuple(tie('scalar'), tie('scalar'), tie('scalar')).map((p) => `(${p.join(', ')})`),
    fc.tuple(tie('scalar'), tie('scalar'), tie('scalar')).map((p) => `rod(${p.join(', ')})`),
    fc.tuple(tie('vector'), fc.constantFrom('+', '-'), tie('vector')).map((p) => p.join(' ')),
    fc.tuple(tie('vector'), tie('vector')).map(([a, b]) => `cross(${a}, ${b})`),
  ),
}));
const vector = fc.tuple(scalar, scalar, scalar).map((p) => `(${p.join(', ')})`);
/** The middle of a description, which begins with coordinates and a kinetic energy, so that much of it is a system. */
const statement = fc.oneof(
  scalar.map((x) => `potential ${x}`),
  scalar.map((x) => `kinetic (${x})^2`),
  fc.tuple(rate, scalar).map(([v, x]) => `kinetic (${v} - ${x})^2`),
  fc.tuple(name, scalar).map(([e, x]) => `parameter ${e} = ${x}`),
  scalar.map((x) => `velocity ${x} = 0 in rolling`),
  scalar.map((x) => `velocity ${x} = 0`),
  scalar.map((x) => `height ${x} = 0`),
  scalar.map((x) => `loss (${x})^2`),
  scalar.map((x) => `A = ${x}`),
  vector.map((x) => `point P = ${x}`),
  fc.tuple(fc.constantFrom('x', 'y', 'z'), scalar).map(([axis, x]) => `frame rod = world turned ${axis} ${x}`),
  fc.tuple(scalar, vector).map(([m, P]) => `body b mass ${m} inertia (1, 1, 1) at ${P}`),
  fc.tuple(scalar, scalar).map(([f, x]) => `force ${f} on ${x}`),
  fc.tuple(scalar, scalar).map(([k, x]) => `spring ${k} on ${x}`),
  fc.tuple(fc.constantFrom('x', 'y', 'phi'), scalar).map(([q, x]) => `drive ${q} = ${x}`),
  fc.tuple(fc.constantFrom('x', 'y', 'phi'), scalar).map(([q, x]) => `${q}' = ${x}`),
  scalar.map((x) => `input tau on ${x}`),
  scalar.map((x) => `event e "it" ${x}`),
  fc.tuple(name, rate).map(([x, v]) => `show ${x}, ${v}`),
  fc.tuple(name, scalar).map(([b, r]) => `shape ${b} sphere ${r}`),
);
const grown = fc
  .array(statement, { maxLength: 7 })
  .map((lines) =>
    [
      'coordinate x, y',
      'coordinate phi [rad]',
      'parameter m = 2 positive',
      'parameter k = 0.5',
      'parameter gravity = 9.81',
      "kinetic 1/2 m (x'^2 + y'^2) + 1/2 k phi'^2",
      'constraints rolling',
      ...lines,
    ].join('\n'),
  );

function tryOut(text: string): void {
  const { model, view, faults } = readSystem(text);
  const lines = text.split(/\r\n|\r|\n/);
  if (!model || !view) {
    expect(faults.length).toBeGreaterThan(0);
    for (const { line, column, message } of faults) {
      expect(line).toBeLessThanOrEqual(lines.length);
      expect(column).toBeGreaterThanOrEqual(1);
      expect(column).toBeLessThanOrEqual((lines[line - 1] ?? '').length + 1);
      expect(message.length).toBeLessThan(600);
    }
    return count('refused at a place');
  }
  let system;
  try {
    system = deriveSystem(model, view);
  } catch (error) {
    if (faultOf(error) === null) throw error;
    return count('refused by its equations');
  }
  const { id } = view.meta;
  try {
    const scenario = checkScenario({ version: 1, system: id, duration: 0.2 }, { [id]: view.meta });
    const simulation = new Simulation(scenario, system);
    for (let k = 0; k < MOST_STEPS && !simulation.end; k++) simulation.advance(() => true);
    for (const value of simulation.q) expect(Number.isNaN(value)).toBe(false);
    count(simulation.end && simulation.end.reason !== 'end' ? 'ended with a reason' : 'run');
  } catch (error) {
    if (!(error instanceof StartError)) throw error;
    count('refused at the start');
  }
}

describe('descriptions', () => {
  test('by grammar', () => {
    fc.assert(fc.property(grown, tryOut), { ...settings, numRuns: runs(300) });
  });

  test('the templates, damaged', () => {
    fc.assert(fc.property(damaged(fc.constantFrom(...texts)), tryOut), { ...settings, numRuns: runs(60) });
  });
});
