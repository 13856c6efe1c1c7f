import { withHeld } from '../../core/motion/heldColumns.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { attitudeOf } from '../names/vocabulary.ts';
import type { ImportChoices, ImportPlan, Question, TimeForm } from '../plan.ts';
import { orderOf } from '../time/order.ts';
import { doubtsOf } from '../units/doubts.ts';
import { anglesOf, quaternionsOf, unwrap } from './angles.ts';
import { ratesOf } from './rates.ts';
import { filled } from './sparse.ts';
import { missingRows } from './sentinels.ts';
import type { RowStore } from './rows.ts';
import type { CsvResult } from './result.ts';

/** Times that are counted from the first row. */
const EPOCHAL: ReadonlySet<TimeForm> = new Set([
  'epoch',
  'date-time',
  'date and clock',
  'compact clock',
  'clock',
  'parts',
  'frame',
] as const);

export interface Finishing {
  choices: ImportChoices;
  /** JSON of a scenario in the comments, or null. */
  scenario: unknown;
  notes: string[];
  system: SystemMeta | null;
}

/** Rows in order of time, attitudes as angles, angles without seams: what is left to do once all rows are there. */
export function finishMotion(
  store: RowStore,
  plan: ImportPlan,
  { choices, scenario, notes, system }: Finishing,
): CsvResult {
  // A run of this program has none.
  if (scenario === null) withoutSentinels(store, plan, notes);
  const { runs } = inOrder(store, plan.time.form, choices, notes);
  if (plan.sparse) betweenOwnValues(store, plan, notes);
  let columns = store.uses.map((use) => use.name);
  let data = store.columns();
  if (system && plan.columns.some((c) => c.role === 'attitude'))
    [columns, data] = withAngles(columns, data, system, plan.euler);
  if (system?.held) {
    const completed = withHeld(system, columns, data);
    [columns, data] = [completed.names, completed.data];
    if (completed.added.length > 0) notes.push(`${completed.added.join(', ')}: not in the file, so held at 0`);
  }
  // A computed angle is what it is; a recorded one may be within a turn.
  if (scenario === null) unwrapped(columns, data, plan, system, notes);
  if (system && plan.rates === 'savitzky-golay') [columns, data] = withRates(columns, data, system, notes);
  if (store.rows === 1) notes.push('one usable row only: it is shown as a still picture');
  return {
    kind: 'motion',
    systemId: plan.system,
    columns,
    data,
    rows: store.rows,
    skippedRows: store.skipped,
    issues: store.sortedIssues(),
    notes,
    questions: questionsOf(plan, columns, data, scenario !== null, runs, choices.run),
    plan: { ...plan, runs: runs.length, run: runs.length > 1 ? Math.min(choices.run ?? 1, runs.length) : null },
    scenario,
  };
}

/** Rows whose numbers stand for missing ones are left out, and named. */
function withoutSentinels(store: RowStore, plan: ImportPlan, notes: string[]): void {
  if (plan.system === null) return;
  const data = store.columns();
  const factors = new Map(plan.columns.filter((c) => c.role === 'coordinate').map((c) => [c.name!, c.factor] as const));
  const measured = store.uses.flatMap((use, i) =>
    factors.has(use.name) ? [{ data: data[i]!, factor: factors.get(use.name)! }] : [],
  );
  const found = missingRows(measured);
  if (!found) return;
  const out = new Set(found.rows);
  for (const row of out) store.skip(store.lineOf(row), '', `${found.value} stands for a missing value`);
  store.reorder(Int32Array.from({ length: store.rows }, (_, i) => i).filter((row) => !out.has(row)));
  notes.push(
    `${found.value} stands for a missing value: ${out.size} ${out.size === 1 ? 'row is' : 'rows are'} left out`,
  );
}

function inOrder(store: RowStore, form: TimeForm, choices: ImportChoices, notes: string[]): { runs: number[] } {
  const data = store.columns();
  const same = (a: number, b: number): boolean => data.every((column, c) => c === 0 || Object.is(column[a], column[b]));
  const order = orderOf(data[0]!, same, choices.run);
  const title = store.uses[0]!.title;
  for (const { row, message } of order.dropped) store.skip(store.lineOf(row), title, message);
  notes.push(...order.notes);
  if (order.rows) store.reorder(order.rows);
  // The first row may have moved.
  const t = store.columns()[0]!;
  const first = t[0]!;
  if (EPOCHAL.has(form) && first !== 0) for (let i = 0; i < t.length; i++) t[i]! -= first;
  return order;
}

/** Each column between its own values; rows that then still lack one are left out. */
function betweenOwnValues(store: RowStore, plan: ImportPlan, notes: string[]): void {
  const needed = new Map(
    plan.columns
      .filter((c) => c.role === 'coordinate' || c.role === 'rate' || c.role === 'attitude')
      .map((c) => [c.name, c.kind] as const),
  );
  const data = store.columns();
  const used = data.filter((column, i) => {
    const kind = needed.get(store.uses[i]!.name);
    if (kind === 'angle') unwrap(column);
    if (kind !== undefined) filled(data[0]!, column);
    return kind !== undefined;
  });
  const rows = Int32Array.from({ length: store.rows }, (_, i) => i).filter((i) => used.every((x) => x[i] === x[i]));
  const out = store.rows - rows.length;
  notes.push(
    `columns have values at different times: each is interpolated between its own${out > 0 ? `; ${out} rows without a value on both sides are left out` : ''}`,
  );
  store.skipped += out;
  if (out > 0) store.reorder(rows);
}

/** Puts the system's angles in place of a quaternion's four columns, or of three angles in another order. */
function withAngles(
  names: string[],
  data: Float64Array[],
  system: SystemMeta,
  euler: string | null,
): [string[], Float64Array[]] {
  const attitude = attitudeOf(system)!;
  const part = (name: string): Float64Array => data[names.indexOf(name)]!;
  const made = [0, 1, 2].map(() => new Float64Array(data[0]!.length)) as [Float64Array, Float64Array, Float64Array];
  const quaternions = euler
    ? quaternionsOf(euler, { X: part('rx'), Y: part('ry'), Z: part('rz') })
    : ([part('qx'), part('qy'), part('qz'), part('qw')] as const);
  anglesOf(quaternions, ...made);
  const columns = new Map(
    names.flatMap((name, i) => (/^(?:q[xyzw]|r[xyz])$/.test(name) ? [] : [[name, data[i]!] as const])),
  );
  for (const [i, name] of [attitude.yaw, attitude.pitch, attitude.roll].entries())
    if (name !== null && !columns.has(name)) columns.set(name, made[i]!);
  const canon = ['t', ...system.coordinates.map((q) => q.name)];
  const rank = (name: string): number => (canon.includes(name) ? canon.indexOf(name) : canon.length);
  const order = [...columns.keys()].sort((a, b) => rank(a) - rank(b));
  return [order, order.map((name) => columns.get(name)!)];
}

/** Adds the rates that the file does not hold. */
function withRates(
  columns: string[],
  data: Float64Array[],
  system: SystemMeta,
  notes: string[],
): [string[], Float64Array[]] {
  const names = system.coordinates.map((q) => q.name);
  const made = new Map<string, Float64Array>();
  for (const name of names) {
    const rates = columns.includes(`${name}_dot`) ? null : ratesOf(data[columns.indexOf(name)]!, data[0]!);
    if (rates) made.set(`${name}_dot`, rates);
  }
  if (made.size === 0) return [columns, data];
  notes.push(`rates by differentiation (Savitzky-Golay): ${[...made.keys()].join(', ')}`);
  const all = new Map([...columns.map((name, c) => [name, data[c]!] as const), ...made]);
  const states = ['t', ...names, ...names.map((name) => `${name}_dot`)].filter((name) => all.has(name));
  const order = [...states, ...columns.filter((name) => !states.includes(name))];
  return [order, order.map((name) => all.get(name)!)];
}

function unwrapped(
  columns: readonly string[],
  data: readonly Float64Array[],
  plan: ImportPlan,
  system: SystemMeta | null,
  notes: string[],
): void {
  const angles = new Set(
    plan.columns.filter((c) => c.kind === 'angle' && (system !== null || c.unit !== '')).map((c) => c.name),
  );
  const turned = columns.filter((name, c) => angles.has(name) && unwrap(data[c]!) > 0);
  if (turned.length > 0) notes.push(`${turned.join(', ')}: jumps of a whole turn are taken out`);
}

/** What the first rows left open, with what all rows show of it. */
function questionsOf(
  plan: ImportPlan,
  columns: readonly string[],
  data: readonly Float64Array[],
  known: boolean,
  runs: readonly number[],
  run: number | undefined,
): Question[] {
  const questions = plan.questions.filter(
    (q) => q.id !== 'degrees' && q.id !== 'lengths' && !(known && q.id === 'time-unit'),
  );
  if (plan.system !== null && !known) {
    const unsaid = plan.columns
      .filter((c) => c.role === 'coordinate' && c.unit === '' && c.unitFrom === 'none')
      .map((c) => ({ name: c.name!, kind: c.kind as 'length' | 'angle', data: data[columns.indexOf(c.name!)]! }));
    questions.push(...doubtsOf(unsaid, data[0]!));
  }
  if (runs.length > 1 && run === undefined)
    questions.push({
      id: 'several-runs',
      text: `The file holds ${runs.length} runs: which one?`,
      answers: runs.slice(0, 20).map((_, i) => ({ label: `run ${i + 1}`, choices: { run: i + 1 } })),
      safest: 0,
      first: false,
    });
  return questions;
}
