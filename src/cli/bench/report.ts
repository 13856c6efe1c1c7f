import type { BenchReport } from './bench.ts';
import type { Times } from './measure.ts';
import { diagram, type Curve } from './plot.ts';
import type { RaceEntry } from './race.ts';
import type { LimitReport } from './limit.ts';
import type { RivalReport } from './rival.ts';
import type { RivalEntry } from './rivals.ts';
import type { SweepReport } from './sweep.ts';
import { costAt, type Problem, type WorkPoint, type WorkReport } from './workPrecision.ts';

/** Everything that one run of the bench measured. The points of the curves are kept apart, as CSV. */
export interface Results extends BenchReport {
  /** Processes that wanted the machine at the start: above the number of cores, processor times are stretched too. */
  load: number;
  rival: RivalReport;
  race: { duration: number; entries: RaceEntry[] };
  precision: Record<Problem, PrecisionSummary>;
  /** Older measurements have neither of these; the limit is null where there is no WebAssembly. */
  limit?: LimitReport | null;
  sweep?: SweepReport & { error: number; rivals: readonly RivalEntry[] };
}

export interface PrecisionSummary {
  floor: number;
  checksum: string;
  /** By method: evaluations and processor time (s) at each of `ERRORS`, null where no run gets there. */
  costs: { label: string; at: { evaluations: number | null; seconds: number | null }[] }[];
}

/** Errors at which the table compares costs. */
const ERRORS = [1e-3, 1e-5, 1e-7, 1e-9] as const;
/** Told apart on a light ground; a method that is not named here is drawn in the last. */
const COLORS: Readonly<Record<string, string>> = {
  dopri5: '#0b63b0',
  dop853: '#d1480b',
  tsit5: '#1b9ed6',
  bs23: '#8a5a3c',
  euler: '#7d8590',
  rk4: '#a07400',
  'adams-moulton': '#7a4fb5',
  gauss: '#00856a',
  radau: '#c2337f',
  bdf: '#26385f',
  ida: '#4e8a00',
};
const OTHER = '#1f2328';

export function summaryOf(work: WorkReport): PrecisionSummary {
  const costs = variantsOf(work.points).map(({ label, points }) => {
    const known = meaningful(points, work.floor);
    return {
      label,
      at: ERRORS.map((error) => ({
        evaluations: costAt(known, error, 'evaluations'),
        seconds: costAt(known, error, 'seconds'),
      })),
    };
  });
  return { floor: work.floor, checksum: work.checksum, costs };
}

function variantsOf(points: readonly WorkPoint[]): { label: string; points: WorkPoint[] }[] {
  const groups = new Map<string, WorkPoint[]>();
  for (const point of points) {
    const label =
      point.stages === null
        ? point.method
        : `${point.method}, ${point.stages} ${point.stages === 1 ? 'stage' : 'stages'}`;
    groups.set(label, [...(groups.get(label) ?? []), point]);
  }
  return [...groups].map(([label, list]) => ({ label, points: list }));
}

/** The pictures of one problem by name; of a method with several numbers of stages, 3 are drawn: its default. */
export function picturesOf(problem: Problem, work: WorkReport): Record<string, string> {
  const what = problem === 'coasting' ? 'Coasting board, 0.5 s' : 'Falling board, first second';
  const curves = (cost: (p: WorkPoint) => number): Curve[] =>
    [...new Set(work.points.map((p) => p.method))]
      .map((id) => ({
        label: id,
        color: COLORS[id] ?? OTHER,
        points: meaningful(
          work.points.filter((p) => p.method === id && (p.stages ?? 3) === 3),
          work.floor,
        ).map((p) => ({ x: p.error, y: cost(p) })),
      }))
      .filter((curve) => curve.points.length > 0);
  const xLabel = 'largest error at the end (m, rad, m/s, rad/s)';
  return {
    [`${problem}-evaluations.svg`]: diagram({
      title: `${what}: error against evaluations`,
      xLabel,
      yLabel: 'evaluations',
      curves: curves((p) => p.evaluations),
    }),
    [`${problem}-time.svg`]: diagram({
      title: `${what}: error against time`,
      xLabel,
      yLabel: 'processor time, ms',
      curves: curves((p) => 1000 * p.seconds),
    }),
  };
}

/** Points before the first that is as good as the truth is known, and without those of quite another motion. */
function meaningful(points: readonly WorkPoint[], floor: number): readonly WorkPoint[] {
  const last = points.findIndex((p) => p.error < 2 * floor);
  return (last < 0 ? points : points.slice(0, last)).filter((p) => p.error < 1);
}

const UNKNOWN = 'Not measured here.';

/** The tables, by the name of their place on the page; Markdown, which a terminal shows as well. */
export function tables(results: Results): Record<string, string> {
  return {
    machine: machineTable(results),
    acceleration: accelerationTable(results),
    rival: rivalTable(results.rival),
    steps: stepsTable(results),
    'precision-coasting': precisionTable(results.precision.coasting),
    'precision-falling': precisionTable(results.precision.falling),
    race: raceTable(results.race),
    limit: results.limit ? limitTable(results.limit) : UNKNOWN,
    sweep: results.sweep ? sweepTable(results.sweep, results.limit) : UNKNOWN,
  };
}

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  const widths = head.map((cell, c) => Math.max(3, cell.length, ...rows.map((row) => row[c]!.length)));
  const line = (cells: readonly string[]): string =>
    `| ${cells.map((cell, c) => (c === 0 ? cell.padEnd(widths[c]!) : cell.padStart(widths[c]!))).join(' | ')} |`;
  const rule = `|${widths.map((w, c) => (c === 0 ? '-'.repeat(w + 2) : `${'-'.repeat(w + 1)}:`)).join('|')}|`;
  return [line(head), rule, ...rows.map(line)].join('\n');
}

function machineTable({ machine, load, rival }: Results): string {
  const { processor, cores, platform, node, v8 } = machine;
  return `${processor}, ${cores} cores (load ${load.toFixed(1)}), ${platform}, Node ${node} (V8 ${v8}), MuJoCo ${rival.mujocoVersion} from mujoco-js.`;
}

const timesHead = ['µs', 'median', 'quartiles', 'least', 'wall median'];

function timesRow(name: string, { median, quartiles, least, wallMedian }: Times): string[] {
  return [
    name,
    median.toFixed(2),
    quartiles.map((x) => x.toFixed(2)).join(' to '),
    least.toFixed(2),
    wallMedian.toFixed(2),
  ];
}

function accelerationTable({ acceleration: a }: Results): string {
  const rows = [
    timesRow('constrained acceleration', a.acceleration),
    ...(a.general ? [timesRow('the general way', a.general)] : []),
    ...Object.entries(a.formulations).map(([id, times]) => timesRow(`derivative, ${id}`, times)),
  ];
  const total = (a.general ?? a.acceleration).median;
  const parts = Object.entries(a.parts).map(
    ([name, part]) => `${name} ${part.toFixed(2)} µs (${((100 * part) / total).toFixed(0)} %)`,
  );
  return `${table(timesHead, rows)}

Of the general way: ${parts.join(', ')}.
${a.states} states from seed ${a.seed}; checksum \`${a.checksum}\`; formulations differ by ${a.disagreement.toExponential(1)} at the most.`;
}

function rivalTable(r: RivalReport): string {
  const rows = [
    timesRow('constrained acceleration, 4 rows', r.constrained),
    timesRow('free acceleration', r.free),
    timesRow('mj_forward, hinges', r.mjForward.hinges),
    timesRow('mj_forward, free joint', r.mjForward.free),
  ];
  return `${table(timesHead, rows)}

Ratio of medians to the faster \`mj_forward\`: **${r.ratio.toFixed(2)}** with constraints, **${r.ratioFree.toFixed(2)}** without.
An empty call into the module takes ${r.border.toFixed(3)} µs. Free accelerations at ${r.states} states differ by ${r.disagreement.toExponential(1)} at the most; checksums \`${r.checksums.ours}\`, \`${r.checksums.theirs}\`.`;
}

function stepsTable({ stepping }: Results): string {
  const head = [
    'steps per second',
    'hanging',
    'quartiles',
    'coasting',
    'quartiles',
    'evaluations per step',
    'checksums',
  ];
  const thousands = (x: number): string => Math.round(x).toLocaleString('en-US');
  const rows = Object.keys(stepping.coasting).map((id) => {
    const [h, c] = [stepping.hanging[id]!, stepping.coasting[id]!];
    const spread = (q: readonly number[]): string => q.map(thousands).join(' to ');
    return [
      id,
      thousands(h.stepsPerSecond),
      spread(h.quartiles),
      thousands(c.stepsPerSecond),
      spread(c.quartiles),
      (c.evaluations / c.steps).toFixed(1),
      `${h.checksum} ${c.checksum}`,
    ];
  });
  return table(head, rows);
}

function precisionTable({ floor, checksum, costs }: PrecisionSummary): string {
  const head = ['evaluations, time at an error of', ...ERRORS.map((e) => e.toExponential(0))];
  const cell = (at: { evaluations: number | null; seconds: number | null }): string =>
    at.evaluations === null || at.seconds === null
      ? '–'
      : `${Math.round(at.evaluations).toLocaleString('en-US')}, ${milliseconds(1000 * at.seconds)} ms`;
  return `${table(
    head,
    costs.map(({ label, at }) => [label, ...at.map(cell)]),
  )}

The truth is known to ${floor.toExponential(1)}; checksum \`${checksum}\`.`;
}

/** Two digits, or all whole ones. */
function milliseconds(ms: number): string {
  return ms < 10 ? ms.toPrecision(2) : Math.round(ms).toLocaleString('en-US');
}

function raceTable({ duration, entries }: Results['race']): string {
  const head = [
    `${duration} s of the falling board`,
    'CPU s',
    'first run',
    'times the report',
    'steps',
    'evaluations',
    'energy drift',
    'residual',
    'checksum',
  ];
  const rows = entries.map((e) => [
    e.reached < duration ? `${e.label} (${e.end} at ${e.reached.toFixed(2)} s)` : e.label,
    e.seconds.toFixed(2),
    e.firstSeconds.toFixed(2),
    e.ratio.toFixed(0),
    e.steps.toLocaleString('en-US'),
    e.evaluations.toLocaleString('en-US'),
    `${(100 * e.energyDrift).toPrecision(2)} %`,
    e.residual.toExponential(1),
    e.checksum,
  ]);
  return table(head, rows);
}

/** Where the time of the falling board goes, as if its parts were done one after another. */
function limitTable(r: LimitReport): string {
  const atPeak = (r.evaluations * r.operations) / r.peak;
  const accelerations = (r.evaluations * r.acceleration) / 1e6;
  const parts: [string, number][] = [
    ['accelerations, if every operation went at the peak', atPeak],
    ['what they take beyond that: operations that wait for others, loads and stores', accelerations - atPeak],
    ['stage sums, error, projection, choice of steps, events', r.withoutRows - accelerations],
    [`rows: dense output, projection, energy`, r.withRows - r.withoutRows],
    ['the whole run', r.withRows],
  ];
  const row = ([what, seconds]: [string, number]): string[] => [
    what,
    (1000 * seconds).toFixed(1),
    `${((100 * seconds) / r.withRows).toFixed(0)} %`,
  ];
  return `${table([`${r.duration} s of the falling board, dopri5`, 'CPU ms', 'share'], parts.map(row))}

One acceleration has ${r.operations.toLocaleString('en-US')} operations and takes ${r.acceleration.toFixed(3)} µs; the run has ${r.steps.toLocaleString('en-US')} steps and ${r.evaluations.toLocaleString('en-US')} evaluations.
The peak, ${(r.peak / 1e9).toPrecision(2)} billion multiplications and additions a second, is measured in WebAssembly on sums that do not wait for each other, one double at a time.`;
}

function sweepTable(r: NonNullable<Results['sweep']>, limits: LimitReport | null | undefined): string {
  const ms = (x: number): string => x.toPrecision(2);
  const error = (x: number | null): string => (x === null ? '–' : x.toExponential(1));
  const own = [
    ['ours, WebAssembly', ms(r.perRun.wasm), error(r.error)],
    ['ours, TypeScript', ms(r.perRun.typescript), error(r.error)],
  ];
  const [runs, loops] = [r.rivals.filter(({ name }) => name !== 'mujoco'), r.rivals.filter((x) => x.name === 'mujoco')];
  const others = runs.map((x) =>
    'skipped' in x ? [`${x.name}, skipped: ${x.skipped}`, '–', '–'] : [x.label, ms(x.milliseconds), error(x.error)],
  );
  const loop = loops.map((x) =>
    'skipped' in x
      ? `MuJoCo’s own loop is skipped: ${x.skipped}.`
      : `${x.label}: ${(1000 * x.milliseconds).toFixed(2)} µs, without constraints${
          limits
            ? `; a constrained acceleration of ours in WebAssembly is **${ms(limits.acceleration / (1000 * x.milliseconds))}** of that`
            : ''
        }.`,
  );
  return [
    table(
      [`ms per run and core, ${r.runs.toLocaleString('en-US')} runs of 1 s`, 'CPU ms', 'error'],
      [...own, ...others],
    ),
    '',
    `${r.steps.toFixed(0)} steps a run; checksum \`${r.checksum}\`.`,
    ...loop,
  ].join('\n');
}

const MARK = (name: string): [string, string] => [`<!-- bench: ${name} -->`, '<!-- end -->'];

/** The page with the tables between their marks; an unknown or missing place is an error. */
export function fillPage(page: string, parts: Readonly<Record<string, string>>): string {
  let text = page;
  for (const [name, part] of Object.entries(parts)) {
    const [open, close] = MARK(name);
    const from = text.indexOf(open);
    const to = text.indexOf(close, from);
    if (from < 0 || to < 0) throw new Error(`the page has no place for ${name}`);
    text = `${text.slice(0, from)}${open}\n${part}\n${text.slice(to)}`;
  }
  return text;
}
