import { describe, expect, it } from 'vitest';
import { feedbackOf } from '../../../../src/core/control/design/feedback.ts';
import { sampleUpTo, tell } from '../../../../src/core/scenario/ride.ts';
import { checkScenario } from '../../../../src/core/scenario/schema.ts';
import type { RideCommand, RideControl, Scenario, ScenarioFile } from '../../../../src/core/scenario/types.ts';
import { Simulation } from '../../../../src/core/simulation/simulation.ts';
import { loadSystem, systemMetas } from '../../../../src/core/systems/registry.ts';
import '../../../../src/core/simulation/everyMotion.ts';
import { seeded } from '../../../../src/cli/bench/states.ts';

const DRAG = 0.5;

function anyRide(system: string, commands: readonly RideCommand[], more: Partial<ScenarioFile> = {}): Scenario {
  const { control, ...rest } = more;
  return checkScenario(
    {
      version: 1,
      system,
      parameters: { wheelDrag: DRAG },
      control: { type: 'ride', commands, ...(control as object) } as RideControl,
      duration: 12,
      ...rest,
    },
    systemMetas,
  );
}

async function begun(scenario: Scenario): Promise<Simulation> {
  const system = (await loadSystem(scenario.system))!;
  return new Simulation(scenario, system, { feedback: feedbackOf(scenario, system), extras: ['inputs'] });
}

/** The whole run: its columns by name, the speed ahead, the end. */
async function ridden(scenario: Scenario) {
  const simulation = await begun(scenario);
  simulation.advance(() => false);
  const { columns } = simulation.takeChunk();
  const column = (name: string): Float64Array => columns[simulation.columns.indexOf(name)]!;
  const theta = column('theta');
  const speed = theta.map((h, i) => column('X_dot')[i]! * Math.cos(h) + column('Y_dot')[i]! * Math.sin(h));
  const at = (t: number): number => Math.round(t / scenario.outputStep);
  return { end: simulation.end!, columns, column, speed, at };
}

const FREE: Partial<ScenarioFile> = { release: ['crouch', 'twist'] };

describe.each<[string, string, Partial<ScenarioFile>]>([
  ['ripstik', 'ripstik', {}],
  ['ripstik-rider', 'ripstik-rider', {}],
  ['ripstik-rider who crouches and twists', 'ripstik-rider', FREE],
])('%s, told what to do with full help', (_, system, body) => {
  const rideOf: typeof anyRide = (id, commands, more) => anyRide(id, commands, { ...body, ...more });

  it('starts from rest to 1 m/s, coasts and stops', async () => {
    const { end, speed, at } = await ridden(
      rideOf(system, [
        [0.1, 'start', 1],
        [3, 'coast', 1],
        [8, 'stop', 1],
      ]),
    );
    expect(end.reason).toBe('end');
    expect(speed[at(3)]).toBeGreaterThan(1);
    expect(speed[at(8)]).toBeGreaterThan(0.3);
    expect(speed[at(8)]).toBeLessThan(speed[at(3)]!);
    expect(Math.abs(speed.at(-1)!)).toBeLessThan(0.02);
  });

  it.each(['left', 'right'])('turns %s on a circle', async (way) => {
    const { end, column, speed, at } = await ridden(
      rideOf(system, [
        [0, 'start', 1],
        [3, way, 0.6],
      ]),
    );
    expect(end.reason).toBe('end');
    const sense = way === 'left' ? 1 : -1;
    const bend = (t: number): number => (sense * column('theta_dot')[at(t)]!) / speed[at(t)]!;
    expect(bend(9)).toBeGreaterThan(0.1);
    expect(bend(11) / bend(9)).toBeCloseTo(1, 1);
    expect(speed[at(11)]).toBeGreaterThan(1);
  });

  it('takes up speed by pumping', async () => {
    const slow = { initial: { X_dot: 1.1 }, control: { speed: 1 } as RideControl };
    const [pumped, coasted] = await Promise.all([
      ridden(rideOf(system, [[0, 'pump', 1]], slow)),
      ridden(rideOf(system, [], slow)),
    ]);
    expect(pumped.end.reason).toBe('end');
    expect(pumped.speed.at(-1)! - coasted.speed.at(-1)!).toBeGreaterThan(0.3);
  });

  it('does the same to the last bit when commands come while it is computed', async () => {
    const random = seeded(20261128);
    const script: RideCommand[] = [];
    const live = rideOf(system, [], { duration: 6 });
    const control = live.control as RideControl;
    const simulation = await begun(live);
    const rows: Float64Array[][] = [];
    const names = ['start', 'twist', 'lean', 'pump', 'coast', 'help', ...(body.release ? ['crouch', 'hips'] : [])];
    for (let horizon = 0; !simulation.end;) {
      horizon += 0.05 * random();
      simulation.horizon = sampleUpTo(control, horizon);
      // Stops after any number of steps, as a worker does that looks at its mailbox.
      while (!simulation.end && !simulation.waits) simulation.advance(() => random() < 0.3);
      if (random() < 0.2) rows.push(simulation.takeChunk().columns);
      if (!simulation.end && random() < 0.1) {
        const name = names[Math.floor(random() * names.length)]!;
        const value = name === 'help' ? 0.8 + 0.2 * random() : name === 'twist' ? 2 * random() - 1 : random();
        script.push(tell(control, simulation.time, name, value));
      }
    }
    rows.push(simulation.takeChunk().columns);
    expect(script.length).toBeGreaterThan(5);
    // As a file has them: numbers as text and back.
    const replay = await ridden(rideOf(system, JSON.parse(JSON.stringify(script)) as RideCommand[], { duration: 6 }));
    expect(simulation.end).toEqual(replay.end);
    replay.columns.forEach((column, i) => {
      expect(Float64Array.from(rows.flatMap((chunk) => [...chunk[i]!]))).toEqual(column);
    });
  });
});

const rideOf = anyRide;

describe('legs and hips', () => {
  it('go where they are told, and back', async () => {
    const { end, column, at } = await ridden(
      rideOf(
        'ripstik-rider',
        [
          [0, 'start', 1],
          [3, 'crouch', 1],
          [4, 'hips', 1],
          [6, 'crouch', 0],
          [7, 'hips', -0.5],
        ],
        FREE,
      ),
    );
    expect(end.reason).toBe('end');
    const [crouch, twist] = [column('crouch'), column('twist')];
    expect(crouch[at(2.9)]).toBeCloseTo(0, 3);
    expect(crouch[at(5.5)]).toBeCloseTo(0.28 * 0.9, 2);
    expect(crouch[at(9)]).toBeCloseTo(0, 2);
    expect(twist[at(6)]).toBeCloseTo(0.6, 1);
    expect(twist[at(10)]).toBeCloseTo(-0.3, 1);
    for (const [name, most] of [
      ['f_crouch', 1500],
      ['tau_twist_rider', 80],
    ] as const)
      expect(Math.max(...column(name).map(Math.abs))).toBeLessThanOrEqual(most);
  });

  it('go ahead into a turn', async () => {
    const { column, at } = await ridden(
      rideOf(
        'ripstik-rider',
        [
          [0, 'start', 1],
          [3, 'left', 1],
        ],
        FREE,
      ),
    );
    expect(column('twist')[at(6)]).toBeGreaterThan(0.2);
  });

  it('swung to and fro, hips carry on where a ride coasts', async () => {
    const swing: RideCommand[] = Array.from({ length: 20 }, (_, k) => [3 + 0.4 * k, 'hips', k % 2 ? 1 : -1]);
    const coast: RideCommand[] = [
      [0, 'start', 1],
      [3, 'coast', 1],
    ];
    const [swung, coasted] = await Promise.all(
      [[...coast, ...swing], coast].map((commands) => ridden(rideOf('ripstik-rider', commands, FREE))),
    );
    expect(swung!.end.reason).toBe('end');
    expect(swung!.speed.at(-1)! - coasted!.speed.at(-1)!).toBeGreaterThan(0.5);
  });
});

describe('help', () => {
  const push: RideCommand[] = [
    [0, 'start', 1],
    [2.5, 'left', 0.3],
    [4, 'straight', 1],
  ];
  const start = { initial: { beta: 0.01 } };

  it('keeps a rider up, and without it the rider falls', async () => {
    const helped = await ridden(rideOf('ripstik-rider', push, start));
    const alone = await ridden(rideOf('ripstik-rider', push, { ...start, control: { help: 0 } as RideControl }));
    expect(helped.end.reason).toBe('end');
    expect(alone.end.reason).not.toBe('end');
    expect(Math.abs(alone.column('beta').at(-1)!)).toBeGreaterThan(0.3);
  });

  it('can be taken away on the way', async () => {
    const { end } = await ridden(rideOf('ripstik-rider', [...push, [5, 'help', 0], [6, 'left', 0.5]], start));
    expect(end.reason).not.toBe('end');
    expect(end.time).toBeGreaterThan(5.3);
  });
});

describe('a ride that can not be', () => {
  const refusal = (file: object): string => {
    try {
      checkScenario({ version: 1, system: 'ripstik-rider', ...file } as ScenarioFile, systemMetas);
    } catch (error) {
      return (error as Error).message;
    }
    return '';
  };
  const told = (commands: unknown): string => refusal({ control: { type: 'ride', commands } });

  it.each([
    [told('start'), 'control.commands: must be a list of [time, command, value], as [[0, "start"], [3, "twist", 0.5]]'],
    [told([[0]]), 'control.commands[0]: must be [time, command, value], as [3, "twist", 0.5]'],
    [told([[0, 'twist', 2]]), 'control.commands[0][2]: must be at most 1, not 2'],
    [told([[-1, 'twist']]), 'control.commands[0][0]: must be at least 0, not -1'],
    [
      told([
        [2, 'start'],
        [1, 'stop'],
      ]),
      'control.commands[1][0]: 1 s is before the command above it at 2 s: put them in order of time',
    ],
    [told([[1, 'crouch']]), 'control.commands[0][1]: "crouch" moves crouch, which is held: put it in "release"'],
    [
      refusal({ release: ['crouch'], control: { type: 'ride', commands: [[1, 'hips', -1]] } }),
      'control.commands[0][1]: "hips" moves twist, which is held: put it in "release"',
    ],
    [
      refusal({ system: 'ripstik', control: { type: 'ride', commands: [[1, 'hips', -1]] } }),
      'control.commands[0][1]: "hips" is for a rider who has twist; ripstik has none',
    ],
    [refusal({ control: { type: 'ride', help: 2 } }), 'control.help: must be at most 1, not 2'],
    [
      refusal({ system: 'bicycle', control: { type: 'ride' } }),
      'control.type: "ride" is for a board with feet, ripstik or ripstik-rider, not for bicycle',
    ],
  ])('is refused: %s', (said, right) => {
    expect(said).toBe(right);
  });

  it('names what it does not know', () => {
    expect(told([[0, 'jump']])).toMatch(/^control\.commands\[0\]\[1\]: unknown name "jump".*/);
    expect(refusal({ control: { type: 'ride', path: {} } })).toMatch(/^control\.path: unknown/);
  });
});
