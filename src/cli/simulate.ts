import { feedbackOf } from '../core/control/design/feedback.ts';
import type { Scenario } from '../core/scenario/types.ts';
import '../core/simulation/everyMotion.ts';
import { Simulation } from '../core/simulation/simulation.ts';
import { DigitsMeter, secondScenario, trustSentence, type Trust } from '../core/simulation/trust.ts';
import type { System } from '../core/model/system.ts';
import { csvComments, writeCsv } from '../csv/csv.ts';
import { openOutput, type Output } from './output.ts';
import { progressLine } from './progress.ts';

/** Rows between writes: the file grows while the run computes, and memory does not. */
const ROWS_PER_WRITE = 4096;
/** Between looks at the clock and at signals, ms. */
const TURN_MS = 100;

export interface SimulateOptions {
  /** As typed, `-` for standard input. */
  name: string;
  out: string | undefined;
  /** The scenario's JSON as it was given. */
  written: unknown;
  /** Computes a second time and tells how many digits agree. */
  verify: boolean;
}

/**
 * Runs a scenario into a CSV file (or standard output); the scenario stands behind the table, so that it can be run again.
 * @returns 0, or 3 when the run stopped before its duration (the reason goes to standard error)
 */
export async function simulate(scenario: Scenario, system: System, options: SimulateOptions): Promise<number> {
  const feedback = feedbackOf(scenario, system);
  const simulation = new Simulation(scenario, system, { feedback });
  const second = options.verify ? new SecondRun(scenario, system, feedback) : null;
  const output = openOutput(options.out, options.name);
  for (const { name, from, to } of simulation.adjustments) process.stderr.write(`start: ${name} ${from} -> ${to}\n`);
  for (const note of simulation.notes) process.stderr.write(`start: ${note}\n`);
  for (const warning of simulation.warnings) process.stderr.write(`warning: ${warning}\n`);
  const interrupted = (signal: NodeJS.Signals): void => {
    output.discard();
    process.removeListener(signal, interrupted);
    process.kill(process.pid, signal);
  };
  process.on('SIGINT', interrupted).on('SIGTERM', interrupted);
  let trust: Trust | null = null;
  try {
    await table(simulation, scenario, output, second, options.out !== undefined);
    trust = second ? await second.finish(simulation) : null;
    // Behind the table, where a program that knows no comments has read all numbers.
    output.write(
      csvComments([
        `scenario: ${JSON.stringify(options.written)}`,
        `engine: ${simulation.engine}`,
        ...simulation.warnings.map((w) => `warning: ${w}`),
      ]),
    );
    if (trust) output.write(`# trust: ${trustSentence(trust)}\n`);
    output.finish();
  } catch (error) {
    output.discard();
    throw error;
  } finally {
    process.removeListener('SIGINT', interrupted).removeListener('SIGTERM', interrupted);
  }
  if (trust) (options.out === undefined ? process.stderr : process.stdout).write(`${JSON.stringify(trust)}\n`);
  const { reason, message } = simulation.end!;
  if (reason === 'end') return 0;
  process.stderr.write(`ripstik: stopped early: ${message}\n`);
  return 3;
}

/** Writes the rows as they come. */
async function table(
  simulation: Simulation,
  { duration }: Scenario,
  output: Output,
  second: SecondRun | null,
  toFile: boolean,
): Promise<void> {
  const progress = progressLine(toFile || !process.stdout.isTTY);
  let header = true;
  let written = 0;
  while (!simulation.end) {
    const turn = performance.now() + TURN_MS;
    simulation.advance(() => simulation.rows >= ROWS_PER_WRITE || performance.now() > turn);
    const { columns, rows } = simulation.takeChunk();
    if (rows > 0 || header) {
      const text = writeCsv(simulation.columns, columns);
      output.write(header ? text : text.slice(text.indexOf('\n') + 1));
      header = false;
    }
    second?.follow(columns, rows, simulation.time);
    written += rows;
    progress.tell(simulation.time, duration, written);
    await turnOfOthers();
  }
  progress.clear();
}

/** The second run, beside the first and never more than a chunk of rows behind it. */
class SecondRun {
  private readonly simulation: Simulation;
  private readonly meter: DigitsMeter;

  constructor(scenario: Scenario, system: System, feedback: ReturnType<typeof feedbackOf>) {
    const second = secondScenario(scenario);
    this.simulation = new Simulation(second, system, { extras: [], feedback });
    this.meter = new DigitsMeter(system.meta, second.method);
  }

  /** The first run's next rows; it is at `time`. */
  follow(columns: readonly Float64Array[], rows: number, time: number): void {
    this.meter.take('first', columns, rows);
    const { simulation, meter } = this;
    while (!simulation.end && simulation.time < time && !meter.over) {
      simulation.advance(() => simulation.rows >= ROWS_PER_WRITE || simulation.time >= time);
      this.take();
    }
  }

  /** The first run is over. */
  async finish(first: Simulation): Promise<Trust> {
    const { simulation, meter } = this;
    // An event of the second run may come a little later.
    const enough = (): boolean => simulation.time > first.time && first.end!.reason !== 'end';
    while (!simulation.end && !meter.over) {
      const turn = performance.now() + TURN_MS;
      simulation.advance(() => enough() || performance.now() > turn);
      this.take();
      if (enough()) break;
      await turnOfOthers();
    }
    return meter.finish(first.end!, simulation.end ?? { reason: 'going' });
  }

  private take(): void {
    const { columns, rows } = this.simulation.takeChunk();
    this.meter.take('second', columns, rows);
  }
}

/** Signals are heard between two chunks. */
const turnOfOthers = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));
