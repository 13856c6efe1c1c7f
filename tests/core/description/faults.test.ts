// What is wrong is told at its line and column, with what would be right.
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { deriveSystem, faultOf, readSystem } from '../../../src/core/description/index.ts';

/** The faults of a text, also those that only show in the equations. */
function faultsOf(text: string): string[] {
  const { model, view, faults } = readSystem(text);
  if (!model) return faults.map(({ message }) => message);
  try {
    deriveSystem(model, view!);
    return [];
  } catch (error) {
    const fault = faultOf(error);
    if (fault === null) throw error;
    return [fault];
  }
}

const PENDULUM = `coordinate theta [rad]
parameter m [kg] = 1
kinetic 1/2 m theta'^2
potential -m cos(theta)
`;

test('a right one has none', () => expect(faultsOf(PENDULUM)).toEqual([]));

describe.each([
  ['a misspelled name', "kinetic 1/2 m thata'^2", /^line 5, column 15: unknown name "thata'"; did you mean theta'\?$/],
  ['a misspelled word', 'potentail 3', /^line 5, column 1: "potentail" begins no statement; did you mean potential\?$/],
  ['a word of no language', 'gimble 3', /"gimble" begins no statement; there are system, coordinate/],
  [
    'a word of another one',
    'lagrangian theta',
    /begins no statement; did you mean kinetic and potential, a line each\?$/,
  ],
  [
    'a lost apostrophe',
    'kinetic 1/2 m theta^2',
    /^line 5, column 9: this has no rate in it: the rate of x is written x'/,
  ],
  ['a lost apostrophe in a loss', 'loss m theta^2', /this has no rate in it/],
  ['a lost apostrophe in a velocity', 'velocity theta = 0', /column 10: this has no rate in it: .*height x = 0$/],
  [
    'a rate as elsewhere',
    'loss thetadot^2',
    /^line 5, column 6: unknown name "thetadot"; the rate of theta is written theta'$/,
  ],
  ['a rate as a quotient', 'loss (dtheta/dt)^2', /the rate of theta is written theta'$/],
  [
    'a rate as a function',
    'loss diff(theta, t)',
    /unknown function "diff"; the rate of x is written x', of an expression/,
  ],
  ['a rate by dot', 'loss dot(theta)', /it takes 2, not 1; the rate of x is written x'/],
  ['two apostrophes', "theta'' = m", /^line 5, column 7: one apostrophe is a rate, x'; accelerations follow/],
  [
    'two names in one',
    'potential mtheta',
    /unknown name "mtheta"; a product has a space or \* between its factors: m theta$/,
  ],
  ['square brackets', 'potential m [theta]', /^line 5, column 13: square brackets hold the unit/],
  ['curly brackets', 'potential m {theta}', /formulas have round brackets$/],
  ['a comma for a point', 'parameter k = 0,5', /^line 5, column 16: .*decimals are written with a point$/],
  ['a unit behind the value', 'parameter k = 5 N/m', /^line 5, column 17: .*parameter k \[N\/m\] = 5$/],
  ['a unit without brackets', 'parameter k N/m = 5', /^line 5, column 13: "=" is expected here: .*\[kg\]/],
  ['a word with =', 'potential = theta', /^line 5, column 11: "potential" begins a statement and has no "=" behind it/],
  ['another comment', '// theta', /^line 5, column 1: a comment begins with #$/],
  [
    'a frame of itself',
    'frame a = a turned z theta',
    /^line 5, column 11: unknown name "a": it is this line that defines it/,
  ],
  [
    'a body with =',
    'body b mass = 2 at (0, 0, 0)',
    /^line 5, column 13: "=" has no place here; the value stands behind the word/,
  ],
  [
    'a misspelled function',
    'potential cosh2(theta)',
    /^line 5, column 11: unknown function "cosh2"; did you mean cosh\?$/,
  ],
  ['a bracket', 'potential (theta', /^line 5, column 11: a "\)" is missing$/],
  ['an end', 'potential 2 *', /^line 5, column 14: something is missing at the end of the line$/],
  ['two meanings', 'potential 1/2m', /^line 5, column 11: this can be read in two ways/],
  ['a vector for a number', 'potential (1, 2, 3)', /^line 5, column 11: a number is expected here, not a vector$/],
  ['a number for a point', 'point P = 3', /a point or vector is expected here, not a scalar$/],
  ['two components', 'point P = (1, 2)', /a vector has three components, not 2$/],
  ['a name twice', 'parameter m = 2', /^line 5, column 11: "m" is already the parameter of line 2$/],
  ['a name of the language', 'parameter sin = 2', /"sin" is a function; take another name$/],
  ['a rate as a name', 'parameter m_dot = 2', /"m_dot" is the rate of m$/],
  ['an acceleration', "loss rate(theta')^2", /this has a rate in it, and the rate of a rate is an acceleration/],
  ['a rate in a potential', "potential theta'", /this may have no rates in it/],
  ['a default out of its range', 'parameter k = -1 positive', /the default of k is outside its own range$/],
  ['no number', 'parameter k = m', /^line 5, column 15: a number is needed here, without names$/],
  ['an infinity', 'parameter k = 1/0', /a finite number is needed$/],
  ['an odd character', 'potential theta; 3', /^line 5, column 16: one statement a line/],
  ['a letter that is spelled out', 'potential θ', /"θ" is spelled out: theta$/],
  ['constraints that are not there', "velocity theta' = 0 in rolling", /write "constraints rolling" on a line above$/],
  ['a drive by a coordinate', 'drive theta = m*theta', /a driven coordinate is given by t and parameters alone/],
  ['a row that is not linear', "velocity theta'^2 = 0", /^line 5, column 1: this velocity is not linear in the rates/],
  [
    'a row that asks for nothing',
    "velocity theta' - theta' sin(theta)^2 - theta' cos(theta)^2 = 0",
    /^line 5, column 1: this constraint follows from those above it/,
  ],
  [
    'a coordinate without mass',
    'coordinate x',
    /^line 5, column 1: the mass matrix is singular: nothing gives x a mass/,
  ],
  ['an input on a product', 'input u on theta^2', /an input acts on a sum of coordinates, such as alpha - 2\*beta$/],
  ['a body nowhere', 'body rod mass 1', /where it is, is missing: at P, its centre of mass$/],
  ['a shape of no body', 'shape rod box (1, 1, 1)', /"rod" is no body$/],
  ['something left over', 'potential theta )', /^line 5, column 17: "\)" has no place here/],
  ['a nest', `potential ${'('.repeat(80)}theta${')'.repeat(80)}`, /nested deeper than 60$/],
])('%s', (_, line, expected) => {
  test(line.slice(0, 40), () => {
    const faults = faultsOf(PENDULUM + line);
    expect(faults).toHaveLength(1);
    expect(faults[0]).toMatch(expected);
  });
});

test('a row that follows from another is told by its own line', () => {
  const text = `coordinate x, y\nkinetic x'^2 + y'^2\nvelocity x' = y'\nvelocity 2 x' - 2 y' = 0`;
  expect(faultsOf(text)).toEqual([expect.stringMatching(/^line 4, column 1: this constraint follows/)]);
});

test('a name that is used above its line, and gravity by another name, are told', () => {
  expect(faultsOf("kinetic 1/2 m x'^2\nparameter m = 1")[0]).toMatch(
    /"m": it is defined below, on line 2; that line has to stand above/,
  );
  const text = 'coordinate z\nparameter g = 9.81\nbody b mass 1 at (0, 0, z)';
  expect(faultsOf(text)).toEqual([
    expect.stringMatching(/^line 2, column 1: nothing uses g; bodies weigh by .* gravity/),
  ]);
  expect(faultsOf(`${text}\npotential g z`)).toEqual([]);
  expect(faultsOf("coordinate x\nkinetic -x'^2")).toEqual([
    expect.stringMatching(/^line 1, .*kinetic energy of x is negative/),
  ]);
});

test('tau and e are what a description declares, from there on; pi, t and units stay', () => {
  const text = 'coordinate tau [rad]\nparameter e = 3\nkinetic 1/2 e tau_dot^2\nA = 2 pi';
  const { model } = readSystem(text);
  expect(model!.graph.depends(model!.kinetic, new Set([model!.p[0]!]))).toBe(true);
  expect(faultsOf(`${text}\ninput tau2 on tau\npotential e cos(tau)`)).toEqual([]);
  expect(faultsOf('A = 2 tau\ncoordinate tau\nkinetic tau_dot^2')).toEqual([
    expect.stringMatching(/^line 1, column 7: "tau" is declared on line 2, which has to stand above this one/),
  ]);
  expect(faultsOf(`${PENDULUM}input tau on theta\npotential tau theta`)).toEqual([
    expect.stringMatching(/^line 6, column 11: "tau" is the input of line 5/),
  ]);
  expect(faultsOf(`${PENDULUM}parameter pi = 3`)).toEqual([expect.stringMatching(/leave this line out$/)]);
  expect(faultsOf(`${PENDULUM}parameter t = 3`)).toEqual([expect.stringMatching(/is the time; take another name$/)]);
});

test('an input on what an equation of first order gives is refused', () => {
  const text = "coordinate x, i\nkinetic x'^2\ni' = -i\ninput u on i";
  expect(faultsOf(text)).toEqual([expect.stringMatching(/^line 4, column 1: i is given by its equation on line 3/)]);
});

test('every line has its own fault, and what misses a name of a wrong line has none', () => {
  const text = "coordinate x\nparameter a = 1/0\nkinetic 1/2 a x'^2\npotential b x\nspring 1 on";
  expect(readSystem(text).faults.map(({ line }) => line)).toEqual([2, 4, 5]);
});

test('what is too large is said so', () => {
  expect(faultsOf('#'.repeat(50_000))[0]).toMatch(/50000 characters are more than a description's 40000/);
  expect(faultsOf('\n'.repeat(2000))[0]).toMatch(/2001 lines are more than a description's 1000/);
});

test('growth is stopped by name', () => {
  // Each line squares the number of paths; equal parts are shared, so that only what differs grows.
  const lines = ['coordinate x, y', "kinetic x'^2 + y'^2", 'a0 = sin(x) + y'];
  for (let k = 1; k < 400; k++) lines.push(`a${k} = (a${k - 1} + ${k} x)^${k % 3 === 0 ? 62 : 63} + sin(a${k - 1} y)`);
  const faults = faultsOf([...lines, 'potential a399'].join('\n'));
  for (const fault of faults) expect(fault).toMatch(/grown beyond|singular|no value/);
});

test('comparisons make a chain, powers and signs are those of the whole program', () => {
  const { model } = readSystem(
    `coordinate x\nkinetic x'^2\na = 0 < 2 < 1\nb = 2 ** 3 ** 2\nc = -2²\nd = 1 < 2 < 3 ? 7 : 8`,
  );
  expect(model).not.toBeNull();
  expect(model!.graph.value).toEqual(expect.arrayContaining([512, -4, 7]));
});

describe('the examples of the documentation', () => {
  const document = readFileSync('docs/own-systems.md', 'utf8');
  const examples = [...document.matchAll(/```\n(system [\s\S]*?)```/g)].map((found) => found[1]!);
  test('are there', () => expect(examples.length).toBeGreaterThan(3));
  test.each(examples)('%#', (text) => expect(faultsOf(text)).toEqual([]));
});
