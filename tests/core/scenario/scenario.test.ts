import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { checkScenario, collectScenarioErrors, parseScenario } from '../../../src/core/scenario/schema.ts';
import { ScenarioError } from '../../../src/core/scenario/types.ts';
import { metas, scenarioOf } from '../../helpers.ts';

const SEED = { seed: 20170613, numRuns: 200 };
const board = (more: object = {}): unknown => ({ version: 1, system: 'ripstik', ...more });

/** The refusal of a raw scenario. */
function refusal(raw: unknown): ScenarioError {
  try {
    scenarioOf(raw);
  } catch (error) {
    expect(error).toBeInstanceOf(ScenarioError);
    return error as ScenarioError;
  }
  throw new Error(`accepted: ${JSON.stringify(raw)}`);
}

function textRefusal(text: string): ScenarioError {
  try {
    parseScenario(text, metas);
  } catch (error) {
    expect(error).toBeInstanceOf(ScenarioError);
    return error as ScenarioError;
  }
  throw new Error(`accepted: ${text.slice(0, 80)}`);
}

/** The examples of the specification, section 6, as they stand there. */
const example = {
  version: 1,
  system: 'ripstik',
  parameters: { casterTrail: 0.04 },
  constraints: 'rolling',
  hold: [],
  initial: { X_dot: 1, alpha_fp: '10 deg', alpha_bp: '10 deg' },
  inputs: { tau_fc: '0.1*sin(2*pi*t)' },
  control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, Q: { alpha_fp: 10 }, R: { tau_fc: 1 } },
  method: { name: 'dopri5', formulation: 'multipliers', rtol: 1e-8, atol: 1e-10, step: 0.001 },
  duration: 10,
  outputStep: 0.01,
  events: { touchdown: 'stop' },
};
const track = {
  type: 'track',
  reference: { tau_fp: '20 deg * sin(2*pi*1.5*t)', tau_bp: '-20 deg * sin(2*pi*1.5*t)' },
  kp: 60,
  kd: 3,
};

describe('a scenario that is silent', () => {
  const scenario = scenarioOf(board());

  it('has the defaults of the specification', () => {
    expect(scenario).toMatchObject({
      version: 1,
      system: 'ripstik',
      parameterSet: null,
      constraints: 'rolling',
      hold: [],
      initial: {},
      inputs: {},
      control: null,
      at: {},
      duration: 10,
      outputStep: 0.01,
      events: {},
      columns: [],
      method: { name: 'dopri5', formulation: 'multipliers', rtol: 1e-8, atol: 1e-10, projection: true },
    });
  });

  it('has the parameters of the specification', () => {
    expect(scenario.parameters).toEqual({
      rodMass: 2,
      rodLength: 0.25,
      rodRadius: 0.02,
      plateMass: 1,
      plateLength: 0.36,
      plateWidth: 0.22,
      plateThickness: 0.05,
      plateOffset: 0.26,
      pivotDrop: 0.05,
      casterAngle: Math.PI / 6,
      casterTrail: 0.04,
      casterDrop: 0.06,
      casterMass: 0.5,
      wheelRadius: 0.04,
      gravity: 9.81,
      torsionStiffness: 0,
      torsionDamping: 0,
      jointDamping: 0,
      casterDamping: 0,
      wheelDrag: 0,
    });
  });

  it('stays the same when it is checked again', () => {
    for (const raw of [board(), example, board({ control: track, parameterSet: 'authors' })]) {
      const once = scenarioOf(raw);
      const { parameterSet, ...rest } = once;
      expect(scenarioOf(JSON.parse(JSON.stringify(parameterSet === null ? rest : once)))).toEqual(once);
    }
  });
});

describe('what the specification shows', () => {
  it('is accepted as it stands', () => {
    expect(parseScenario(JSON.stringify(example), metas)).toEqual(scenarioOf(example));
    expect(scenarioOf(example).initial).toEqual({ X_dot: 1, alpha_fp: Math.PI / 18, alpha_bp: Math.PI / 18 });
    expect(scenarioOf(board({ control: track })).control).toMatchObject(track);
    const pulses = '22*exp(-10*(t-8)^2) - 22*exp(-10*(t-12)^2)';
    expect(scenarioOf(board({ inputs: { f_X: pulses, tau_twist: 1 } })).inputs).toEqual({ f_X: pulses, tau_twist: 1 });
    expect(scenarioOf(board({ events: { touchdown: 'ignore' } })).events).toEqual({ touchdown: 'ignore' });
    expect(scenarioOf(board({ columns: ['lambda', 'energy', 'residual', 'inputs'] })).columns).toHaveLength(4);
    expect(scenarioOf(board({ at: { X_dot: 1 } })).at).toEqual({ X_dot: 1 });
    const coordinates = ['X', 'Y', 'Z', 'alpha', 'psi', 'theta', 'alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc'];
    expect(scenarioOf(board({ hold: coordinates })).hold).toEqual(coordinates);
    for (const name of coordinates)
      expect(scenarioOf(board({ inputs: { [`f_${name}`]: 1 } })).inputs).toEqual({ [`f_${name}`]: 1 });
  });

  it.each(['euler', 'rk4', 'adams-moulton', 'dopri5', 'dop853', 'gauss', 'radau', 'bdf'])(
    'knows the method %s',
    (name) => {
      for (const formulation of ['multipliers', 'nullspace-qr', 'blt']) {
        expect(
          scenarioOf(board({ method: { name, formulation, stages: 3, maxStep: 0.1, projection: false } })).method,
        ).toMatchObject({ name, formulation, stages: 3, maxStep: 0.1, projection: false });
      }
    },
  );

  it('knows the method ida, which has no formulation, and reads back what it made of it', () => {
    const { method } = scenarioOf(board({ method: { name: 'ida' } }));
    expect(method).toEqual({ name: 'ida', rtol: 1e-8, atol: 1e-10, projection: true });
    expect(scenarioOf(board({ method })).method).toEqual(method);
  });

  it.each(['rolling', 'report', 'none'])('knows the constraints %s', (constraints) => {
    expect(scenarioOf(board({ constraints })).constraints).toBe(constraints);
  });

  it('takes the named values of a parameter set, and what is written out before those', () => {
    expect(scenarioOf(board({ parameterSet: 'authors' })).parameters.casterTrail).toBe(-0.04);
    expect(scenarioOf(board({ parameterSet: 'street' })).parameters.casterTrail).toBe(0.04);
    expect(
      scenarioOf(board({ parameterSet: 'authors', parameters: { casterTrail: 0.01, casterAngle: '20 deg' } }))
        .parameters,
    ).toMatchObject({ casterTrail: 0.01, casterAngle: Math.PI / 9 });
  });
});

/** Raw scenario, path, and what the message has to say. */
const REFUSED: [string, unknown, string, RegExp][] = [
  ['no object', null, '', /object/],
  ['a list', [], '', /a list/],
  ['a text', 'ripstik', '', /"version" and "system"/],
  ['no version', { system: 'ripstik' }, 'version', /missing.*1/],
  ['another version', { version: 2, system: 'ripstik' }, 'version', /must be 1/],
  ['the version as text', { version: '1', system: 'ripstik' }, 'version', /must be 1/],
  ['no system', { version: 1 }, 'system', /missing.*ripstik/],
  ['an unknown system', { version: 1, system: 'ripstick' }, 'system', /did you mean "ripstik"/],
  ['a prototype as system', { version: 1, system: 'constructor' }, 'system', /unknown name "constructor".*ripstik/],
  ['an unknown key', board({ durration: 5 }), 'durration', /did you mean "duration"/],
  ['a misspelt state', board({ initial: { alhpa: 1 } }), 'initial.alhpa', /did you mean "alpha"/],
  ['a state in other case', board({ initial: { x: 1 } }), 'initial.x', /did you mean "X"/],
  ['an unknown state', board({ initial: { q: 1 } }), 'initial.q', /right would be X, Y, Z/],
  ['a state of the wrong type', board({ initial: { X: true } }), 'initial.X', /number or an expression/],
  ['a state that depends on t', board({ initial: { X: 'sin(t)' } }), 'initial.X', /"t".*character 5/],
  ['initial as list', board({ initial: [1, 2] }), 'initial', /object, not a list/],
  ['initial as null', board({ initial: null }), 'initial', /object, not null/],
  ['an infinite state', board({ initial: { X: Infinity } }), 'initial.X', /finite/],
  ['an expression that is infinite', board({ initial: { X: '1/0' } }), 'initial.X', /finite/],
  ['a state that is not a number', board({ initial: { X: NaN } }), 'initial.X', /finite/],
  ['a tolerance of the wrong type', board({ method: { rtol: 'small' } }), 'method.rtol', /must be a number/],
  ['no tolerance', board({ method: { rtol: 0 } }), 'method.rtol', /greater than 0/],
  ['a negative tolerance', board({ method: { atol: -1e-9 } }), 'method.atol', /greater than 0/],
  ['a tolerance without end', board({ method: { rtol: Infinity } }), 'method.rtol', /finite/],
  ['an unknown method', board({ method: { name: 'dopri' } }), 'method.name', /did you mean "dopri5"/],
  ['a method as text', board({ method: 'rk4' }), 'method', /object/],
  [
    'an unknown formulation',
    board({ method: { formulation: 'qr' } }),
    'method.formulation',
    /multipliers, nullspace-qr, blt/,
  ],
  ['an unknown key of the method', board({ method: { rtoll: 1 } }), 'method.rtoll', /did you mean "rtol"/],
  [
    'a formulation for the residual',
    board({ method: { name: 'ida', formulation: 'multipliers' } }),
    'method.formulation',
    /leave it out/,
  ],
  ['half a stage', board({ method: { stages: 2.5 } }), 'method.stages', /whole number/],
  ['a projection that is no yes or no', board({ method: { projection: 1 } }), 'method.projection', /true or false/],
  ['a step of zero', board({ method: { step: 0 } }), 'method.step', /greater than 0/],
  ['a second hold that is unknown', board({ hold: ['X', 'teta'] }), 'hold[1]', /did you mean "theta"/],
  ['a hold that is a number', board({ hold: ['X', 3] }), 'hold[1]', /not number 3/],
  ['hold as text', board({ hold: 'X' }), 'hold', /list of names/],
  ['an unknown input', board({ inputs: { tau_x: 1 } }), 'inputs.tau_x', /tau_fp/],
  ['a broken input', board({ inputs: { tau_fc: 'sin(' } }), 'inputs.tau_fc', /missing.*character/],
  ['an input with a foreign name', board({ inputs: { tau_fc: '2*x' } }), 'inputs.tau_fc', /"x".*character 3/],
  ['an input without end', board({ inputs: { tau_fc: Infinity } }), 'inputs.tau_fc', /finite/],
  ['control as text', board({ control: 'lqr' }), 'control', /object/],
  ['control without type', board({ control: {} }), 'control.type', /lqr, track/],
  ['control of another type', board({ control: { type: 'pid' } }), 'control.type', /lqr, track/],
  [
    'track of an unknown input',
    board({ control: { ...track, reference: { tau_x: 1 } } }),
    'control.reference.tau_x',
    /tau_fp/,
  ],
  ['track without reference', board({ control: { type: 'track', kp: 1, kd: 1 } }), 'control.reference', /missing/],
  [
    'track without gain',
    board({ control: { type: 'track', reference: { tau_fp: 0 }, kd: 1 } }),
    'control.kp',
    /missing.*number/,
  ],
  ['track with a negative gain', board({ control: { ...track, kd: -1 } }), 'control.kd', /at least 0/],
  ['track with the keys of lqr', board({ control: { ...track, Q: {} } }), 'control.Q', /unknown name "Q"/],
  ['lqr without inputs', board({ control: { type: 'lqr' } }), 'control.inputs', /at least one/],
  [
    'lqr with an unknown input',
    board({ control: { type: 'lqr', inputs: ['tau_fc', 'tau'] } }),
    'control.inputs[1]',
    /tau_bc/,
  ],
  [
    'lqr with a negative weight',
    board({ control: { type: 'lqr', inputs: ['tau_fc'], Q: { X: -1 } } }),
    'control.Q.X',
    /at least 0/,
  ],
  [
    'lqr with a free input',
    board({ control: { type: 'lqr', inputs: ['tau_fc'], R: { tau_fc: 0 } } }),
    'control.R.tau_fc',
    /greater than 0/,
  ],
  [
    'lqr at an unknown state',
    board({ control: { type: 'lqr', inputs: ['tau_fc'], at: { V: 1 } } }),
    'control.at.V',
    /right would be/,
  ],
  [
    'a limit of zero',
    board({ control: { ...track, limits: { tau_fc: 0 } } }),
    'control.limits.tau_fc',
    /greater than 0/,
  ],
  [
    'a negative limit',
    board({ control: { type: 'lqr', inputs: ['tau_fc'], limits: { tau_fc: -5 } } }),
    'control.limits.tau_fc',
    /greater than 0/,
  ],
  [
    'a limit that is no number',
    board({ control: { type: 'lqr', inputs: ['tau_fc'], limits: { tau_fc: NaN } } }),
    'control.limits.tau_fc',
    /finite/,
  ],
  [
    'an unknown parameter',
    board({ parameters: { casterTail: 1 } }),
    'parameters.casterTail',
    /did you mean "casterTrail"/,
  ],
  ['a negative mass', board({ parameters: { rodMass: -1 } }), 'parameters.rodMass', /at least 0/],
  ['an unknown parameter set', board({ parameterSet: 'road' }), 'parameterSet', /street, authors/],
  ['unknown constraints', board({ constraints: 'roll' }), 'constraints', /rolling, report, none/],
  ['no duration', board({ duration: 0 }), 'duration', /greater than 0/],
  ['a duration as text', board({ duration: '10 s' }), 'duration', /must be a number/],
  ['a negative output step', board({ outputStep: -0.01 }), 'outputStep', /greater than 0/],
  ['too many rows', board({ duration: 1000, outputStep: 1e-6 }), 'outputStep', /rows.*larger step/],
  ['a duration beyond all measure', board({ duration: 1e300, outputStep: 1e299 }), 'duration', /at most/],
  ['an unknown event', board({ events: { touchDown: 'stop' } }), 'events.touchDown', /did you mean "touchdown"/],
  ['an unknown reaction to an event', board({ events: { touchdown: 'pause' } }), 'events.touchdown', /stop, ignore/],
  ['an unknown extra column', board({ columns: ['lambda', 'energies'] }), 'columns[1]', /energy/],
  ['an unknown state of the operating point', board({ at: { X_dott: 1 } }), 'at.X_dott', /did you mean "X_dot"/],
];

describe('what is refused', () => {
  it.each(REFUSED)('%s', (_, raw, path, message) => {
    const error = refusal(raw);
    expect(error.path).toBe(path);
    expect(error.message).toMatch(message);
    expect(error.message).not.toMatch(/undefined|\[object/);
    expect(collectScenarioErrors(raw, metas).has(path)).toBe(true);
  });

  it('is named all at once where a page asks for it', () => {
    const raw = board({ duration: -1, initial: { alhpa: 1, X: 'x' }, method: { rtol: 0 } });
    expect([...collectScenarioErrors(raw, metas).keys()].sort()).toEqual([
      'duration',
      'initial.X',
      'initial.alhpa',
      'method.rtol',
    ]);
  });

  it.each(['', '"initial"', '"parameters"', '"inputs"', '"method"', '"events"', '"at"', '"control"'])(
    'a key __proto__ in %s',
    (where) => {
      const hostile = '"__proto__": {"duration": 5, "X": 1, "rtol": 1}';
      const inner = where === '"control"' ? `"type": "lqr", "inputs": ["tau_fc"], ${hostile}` : hostile;
      const error = textRefusal(`{"version": 1, "system": "ripstik", ${where ? `${where}: {${inner}}` : inner}}`);
      expect(error.path.split('.').at(-1)).toBe('__proto__');
      expect(({} as Record<string, unknown>).duration).toBeUndefined();
    },
  );

  it.each(['constructor', 'toString', 'hasOwnProperty', 'valueOf'])('the inherited name %s', (name) => {
    for (const key of ['initial', 'parameters', 'inputs', 'method', 'events', 'at']) {
      expect(refusal(board({ [key]: { [name]: 1 } })).path).toBe(`${key}.${name}`);
    }
    for (const key of ['parameterSet', 'constraints']) expect(refusal(board({ [key]: name })).path).toBe(key);
    expect(refusal(board({ hold: [name] })).path).toBe('hold[0]');
  });
});

describe('text that is not JSON', () => {
  it.each([
    ['', 1, 1],
    ['{', 1, 2],
    ['nan', 1, 1],
    ['{"version": 1,\n "system": }', 2, 12],
    ['{"version": 1,\r\n"system": "ripstik",}', 2, 21],
    ['{"version": tru}', 1, 13],
    ['{"version": 01}', 1, 13],
    ['{"version": 1 "system": 2}', 1, 15],
    ["{'version': 1}", 1, 2],
    ['{"version": "1\n"}', 1, 13],
    ['{"version": 1} x', 1, 16],
    ['\ufeff{"version":\n\n]', 3, 1],
    ['[1, 2', 1, 6],
    ['{"a": [1, 2}', 1, 12],
    ['{"a": NaN}', 1, 7],
    ['{"a": 1,}', 1, 9],
    ['[1,]', 1, 4],
    ['{"a"}', 1, 5],
    ['// a comment\n{}', 1, 1],
    ['{"a": "\\x"}', 1, 7],
  ])('%j is refused with its line and column', (text, line, column) => {
    const error = textRefusal(text);
    expect(error.path).toBe('');
    expect(error.message).toMatch(/^not JSON: /);
    expect(error.message).toContain(`line ${line}, column ${column}:`);
  });

  it('is found at the place where it was spoilt', () => {
    const good = JSON.stringify(example, null, 1);
    fc.assert(
      fc.property(fc.nat(good.length - 1), (at) => {
        const cut = good.slice(0, at);
        const error = textRefusal(cut);
        const place = /line (\d+), column (\d+):/.exec(error.message);
        expect(place).not.toBeNull();
        // The end of the text, or the beginning of the word or text that was cut.
        const [line, column] = [Number(place![1]), Number(place![2])];
        const lines = cut.split('\n');
        expect(line).toBe(lines.length);
        expect(column).toBeLessThanOrEqual(lines.at(-1)!.length + 1);
        expect(lines.at(-1)!.slice(column - 1)).toMatch(/^("([^"]*)|[\w.+-]+)?$/);
      }),
      SEED,
    );
  });

  it('is refused when it is huge or deep', () => {
    expect(textRefusal(`{"version": 1, ${' '.repeat(300_000)}`).message).toMatch(/characters are more than/);
    expect(textRefusal('['.repeat(1e5)).message).toMatch(/not JSON: line 1, column 100001/);
    expect(textRefusal('{"a":'.repeat(39_000)).message).toMatch(/not JSON/);
    expect(textRefusal('['.repeat(9e4) + ']'.repeat(9e4)).message).toMatch(/a list/);
    expect(
      textRefusal(`{"version":1,"system":"ripstik","initial":{"X":${'['.repeat(5e4)}${']'.repeat(5e4)}}}`).path,
    ).toBe('initial.X');
    expect(textRefusal(`{"version":1,"system":"ripstik","hold":[${'"X_",'.repeat(2e4)}"X"]}`).path).toMatch(/^hold/);
    const long = textRefusal(`{"version":1,"system":"ripstik","${'k'.repeat(1e5)}":1}`);
    expect(long.message.length).toBeLessThan(1000);
  });
});

describe('whatever is given', () => {
  const anything = fc.anything({
    maxDepth: 3,
    withNullPrototype: true,
    withBigInt: true,
    withDate: true,
    withMap: true,
  });

  it('is accepted or refused by ScenarioError, and nothing else', () => {
    fc.assert(
      fc.property(anything, (raw) => {
        expect(() => checkScenario(raw, metas)).toThrow(ScenarioError);
      }),
      SEED,
    );
  });

  it('is so in every place of a scenario', () => {
    const keys = [
      'parameterSet',
      'parameters',
      'constraints',
      'hold',
      'initial',
      'inputs',
      'control',
      'at',
      'method',
      'duration',
      'outputStep',
      'events',
      'columns',
    ];
    fc.assert(
      fc.property(fc.constantFrom(...keys), anything, (key, value) => {
        const errors = collectScenarioErrors(board({ [key]: value }), metas);
        for (const path of errors.keys()) expect(path.startsWith(key) || path === 'outputStep').toBe(true);
        if (errors.size > 0) expect(() => scenarioOf(board({ [key]: value }))).toThrow(ScenarioError);
        else expect(() => scenarioOf(board({ [key]: value }))).not.toThrow();
      }),
      SEED,
    );
  });

  it('reads any JSON text alike', () => {
    fc.assert(
      fc.property(fc.json(), fc.nat(), fc.string({ maxLength: 2 }), (json, at, noise) => {
        const place = at % (json.length + 1);
        expect(() => parseScenario(json.slice(0, place) + noise + json.slice(place), metas)).toThrow(ScenarioError);
      }),
      SEED,
    );
  });

  it('keeps numbers to the last bit', () => {
    const finite = fc.double({ noNaN: true, noDefaultInfinity: true });
    fc.assert(
      fc.property(finite, finite, (X, Y) => {
        expect(
          parseScenario(`{"version":1,"system":"ripstik","initial":{"X":${X},"Y":"${Y}"}}`, metas).initial,
        ).toEqual({ X: X === 0 && !Object.is(X, 0) ? 0 : X, Y: Y === 0 ? 0 : Y });
      }),
      SEED,
    );
  });
});
