import '../../core/simulation/everyMotion.ts';
import { branchIf, f64, F64, get, i32, I32, Module, set } from '../../core/engine/assembler.ts';
import { instantiate } from '../../core/engine/host.ts';
import { machineFor } from '../../core/engine/machine.ts';
import { reached } from '../../core/engine/tape.ts';
import { dopri5 } from '../../core/integrators/runge-kutta/tableaus/dopri5.ts';
import type { Tape } from '../../core/model/tape.ts';
import { SEED } from './accelerations.ts';
import type { Caller, Job } from './apart.ts';
import { measureTogether, type MeasureOptions, type Work } from './measure.ts';
import { consistentStates, dynamicsOf, scenarioOf } from './states.ts';
import { caseNamed, timedRun } from './stepping.ts';
import { TOLERANCES } from './sweep.ts';

/** Of one angle's sine and cosine together, as derivation/trigonometry.py writes them out. */
const OF_AN_ANGLE = 52;
/** Sums that do not wait for each other, enough to fill every unit; and multiplications and additions of one round. */
const CHAINS = 12;
const STATES = 16;
const REPEATS = 5;

export interface LimitReport {
  /** Floating-point operations of one acceleration, with multipliers and what the projection needs. */
  operations: number;
  /** Multiplications and additions of doubles in a second, one at a time, as many as the machine can. */
  peak: number;
  /** Microseconds of one acceleration in WebAssembly. */
  acceleration: number;
  /** Of the falling board: its length (s), evaluations and steps; with rows every 0.01 s, and with two rows in all, s. */
  duration: number;
  evaluations: number;
  steps: number;
  withRows: number;
  withoutRows: number;
}

/** What the falling board would take at the machine's peak, and where the rest of the time goes. */
export const limit = (duration: number, options: MeasureOptions, call: Caller): LimitReport | null =>
  call(limitJob, duration, options);

export const limitJob: Job<[number, MeasureOptions], LimitReport | null> = {
  module: import.meta.url,
  name: 'limitJob',
  run: (duration, options) => {
    const raw = { ...caseNamed('falling-report'), columns: [], duration, method: { name: 'dopri5', ...TOLERANCES } };
    const scenario = scenarioOf(raw);
    const dynamics = dynamicsOf(scenario);
    const { direct, constraints, n } = dynamics;
    const tape = direct!.direct.tape!;
    const machine = machineFor(tape, constraints!.id, dopri5, constraints!.contact, n, false);
    if (!machine) return null;
    const { memory, layout, run } = machine;
    memory.set(direct!.constants, layout.constants);
    const at = (k: number): number => layout.steps + 2 * n * k;
    consistentStates(dynamics, STATES, SEED).forEach(({ q, v }, k) => memory.set([...q, ...v], at(k)));
    const works: Record<'acceleration' | 'peak', Work> = {
      acceleration: (count) => {
        for (let i = 0; i < count; i++) run.accelerations(8 * at(i % STATES), 8 * at(STATES));
        return memory[at(STATES)]!;
      },
      peak: peakWork(),
    };
    const times = measureTogether(works, options);
    const runs = [{}, { outputStep: duration }].map((rows) =>
      Array.from({ length: REPEATS }, () => timedRun({ ...raw, ...rows })),
    );
    const [withRows, withoutRows] = runs.map((list) => Math.min(...list.map(({ seconds }) => seconds)));
    const { evaluations, steps } = runs[1]![0]!.simulation.counts;
    return {
      operations: operationsOf(tape, constraints!.id),
      peak: (2e6 * CHAINS) / times.peak.least,
      acceleration: times.acceleration.least,
      duration,
      evaluations,
      steps,
      withRows: withRows!,
      withoutRows: withoutRows!,
    };
  },
};

function operationsOf({ ops, prepare, sets }: Tape, id: string): number {
  const { rate, lambda, factors, larger, smaller } = sets[id]!;
  const wanted = [rate, lambda, factors, larger, smaller].flat();
  const angles = new Set<number>();
  let count = 0;
  for (const i of reached(ops, wanted, new Map(prepare.map((p) => [p, true])))) {
    const [kind, first] = ops[i]!;
    if (kind === 'sin' || kind === 'cos') angles.add(first as number);
    else if (kind !== 'input' && kind !== 'const') count++;
  }
  return count + OF_AN_ANGLE * angles.size;
}

/** Rounds of x = a x + b on independent x, which stay where they are, in WebAssembly. */
function peakWork(): Work {
  const module = new Module();
  const rounds = module.func([I32], [F64], 'rounds');
  const chains = Array.from({ length: CHAINS }, () => rounds.local());
  const [a, b] = [rounds.local(), rounds.local()];
  rounds.body = [
    set(a, f64.const(0.5)),
    set(b, f64.const(0.75)),
    [0x03, 0x40],
    chains.map((x) => set(x, f64.add(f64.mul(get(x), get(a)), get(b)))),
    set(0, i32.add(get(0), i32.const(-1))),
    branchIf(0, i32.lt(i32.const(0), get(0))),
    0x0b,
    chains.map((x) => get(x)).reduce((sum, x) => f64.add(sum, x)),
  ];
  const exports = instantiate(module.bytes(8)) as { rounds(count: number): number };
  return (count) => exports.rounds(count);
}
