/** Pinned runs and a sweep as the browser stores them, and back: what was stored is read like a stranger's file. */
import type { SystemView } from '../../core/model/system.ts';
import { DATA, dataView } from '../../core/motion/dataView.ts';
import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import { Trajectory } from '../../core/motion/trajectory.ts';
import { settled, written } from '../../core/scenario/own.ts';
import { checkScenario, collectScenarioErrors } from '../../core/scenario/schema.ts';
import { MOST_SWEEP_RUNS, type SweepAxis } from '../../core/scenario/sweepAxes.ts';
import { ENGINE_NAMES, type EngineId, type Scenario, type ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import type { Motion } from '../runs/motion.ts';
import { bytesOf, MOST_PINNED, type PinnedRun } from '../runs/pinnedRuns.ts';
import { runsOf, type SweepPlan, type SweepResult } from '../runs/sweep.ts';
import { recordOf } from './settingsCodec.ts';

/** Bytes of the numbers of all pinned runs together that are stored; those beyond stay until the page is left. */
export const LARGEST_SAVED_RUNS = 40e6;
/** Of a file's notes. */
const MOST_ISSUES = 200;

export interface StoredRun extends Pick<PinnedRun, 'name' | 'style' | 'statistics' | 'ending' | 'visible' | 'ghost'> {
  motion: Omit<Motion, 'id' | 'system' | 'trajectory' | 'imported'>;
  system: string;
  /** Of data. */
  columns: SystemMeta['columns'];
  names: readonly string[];
  data: readonly Float64Array[];
  recorded: boolean;
}

/** The runs that fit, in their order, and the names of those that do not. A run still computing waits for its end. */
export function storedRuns(runs: readonly PinnedRun[]): { stored: StoredRun[]; left: string[] } {
  const stored: StoredRun[] = [];
  const left: string[] = [];
  let bytes = 0;
  for (const run of runs) {
    if (run.motion.source === 'run' && !run.ending) continue;
    bytes += bytesOf(run.motion);
    if (bytes <= LARGEST_SAVED_RUNS) stored.push(storedRun(run));
    else {
      bytes -= bytesOf(run.motion);
      left.push(run.name);
    }
  }
  return { stored, left };
}

function storedRun({ id: _, motion, ...run }: PinnedRun): StoredRun {
  const { id: __, system, trajectory, imported: ___, ...rest } = motion;
  return {
    ...run,
    motion: {
      ...rest,
      written: rest.written && (written(rest.written, { [system.meta.id]: system.meta }) as ScenarioFile),
      issues: rest.issues.slice(0, MOST_ISSUES),
    },
    system: system.meta.id,
    columns: system.meta.columns,
    names: trajectory.columns,
    data: trajectory.columns.map((name) => trajectory.column(name)!.slice(0, trajectory.length)),
    recorded: trajectory.recorded,
  };
}

type Views = Readonly<Record<string, SystemView>>;

/** What of it can be used; a run that can't is left out. Motions have ids of their own, below zero. */
export function runsFrom(value: unknown, views: Views): Omit<PinnedRun, 'id'>[] {
  if (!Array.isArray(value)) return [];
  return value.slice(0, MOST_PINNED).flatMap((item, i) => {
    try {
      return [runFrom(recordOf(item) as unknown as StoredRun, views, -1 - i)];
    } catch {
      return [];
    }
  });
}

function runFrom(stored: StoredRun, views: Views, id: number): Omit<PinnedRun, 'id'> {
  const { motion } = stored;
  const title = textOf(motion.title);
  const system = stored.system === DATA ? dataView(title, columnsFrom(stored.columns)) : views[stored.system];
  if (!system) throw new Error(`there is no system "${stored.system}"`);
  if (!['run', 'file'].includes(motion.source)) throw new Error('only runs and files are kept');
  return {
    name: textOf(stored.name),
    style: whole(stored.style),
    statistics: stored.statistics ? numbersOf(stored.statistics) : null,
    ending:
      stored.ending && typeof stored.ending.reason === 'string' && typeof stored.ending.time === 'number'
        ? {
            kind: 'ended',
            reason: stored.ending.reason,
            message: String(stored.ending.message),
            time: stored.ending.time,
          }
        : null,
    visible: stored.visible === true,
    ghost: stored.ghost === true,
    motion: {
      id,
      source: motion.source,
      title,
      system,
      parameters: numbersOf(motion.parameters),
      trajectory: trajectoryFrom(stored),
      constraints: typeof motion.constraints === 'string' ? motion.constraints : null,
      ...scenarioFrom(motion, stored.system, views),
      adjustments: listOf(motion.adjustments),
      issues: listOf(motion.issues),
      marks: listOf<Motion['marks'][number]>(motion.marks).filter(({ time }) => typeof time === 'number'),
      ...(Array.isArray(motion.pushes) ? { pushes: motion.pushes } : {}),
      ...(ENGINE_NAMES.some((name) => name === motion.engine) ? { engine: motion.engine as EngineId } : {}),
      judgement: motion.judgement ? numbersOf(motion.judgement) : null,
    },
  };
}

/** Without it the numbers stay, and can't be run again. */
function scenarioFrom(motion: StoredRun['motion'], system: string, views: Views): Pick<Motion, 'scenario' | 'written'> {
  const none = { scenario: null, written: null };
  if (!motion.written) return none;
  const metas = Object.fromEntries(Object.entries(views).map(([id, { meta }]) => [id, meta]));
  let scenario: Scenario;
  try {
    scenario = checkScenario(motion.written, metas);
  } catch {
    return none;
  }
  if (scenario.system !== system) return none;
  // A run that was pushed went on for longer than was written.
  const duration = Number(motion.scenario?.duration);
  return { written: settled(motion.written), scenario: duration > 0 ? { ...scenario, duration } : scenario };
}

function trajectoryFrom({ names, data, recorded }: StoredRun): Trajectory {
  const good =
    Array.isArray(names) &&
    names[0] === 't' &&
    names.every((name) => typeof name === 'string') &&
    Array.isArray(data) &&
    data.every((column) => column instanceof Float64Array && column.length > 0);
  if (!good) throw new Error('its numbers are not there');
  const trajectory = Trajectory.of(names, data);
  trajectory.recorded = recorded === true;
  return trajectory;
}

export interface StoredSweep {
  plan: SweepPlan;
  results: readonly (SweepResult | undefined)[];
}

/** @throws Error for what is no sweep of this page */
export function sweepFrom(value: unknown, metas: Readonly<Record<string, SystemMeta>>): StoredSweep {
  const { plan, results } = recordOf(value) as unknown as StoredSweep;
  const { title, axes, measures, form } = plan;
  const file = settled(plan.file);
  const meta = metas[file.system];
  if (!meta || collectScenarioErrors(file, metas).size > 0) throw new Error('its scenario can’t run');
  const clean: SweepPlan = {
    title: textOf(title),
    file: file as ScenarioFile,
    axes: listOf<SweepAxis>(axes).map((axis) => ({
      ...axis,
      values: listOf<SweepAxis['values'][number]>(axis.values),
    })),
    measures: listOf<SweepMeasure>(measures),
    ...(form === undefined ? {} : { form }),
  };
  const good =
    [1, 2].includes(clean.axes.length) &&
    clean.axes.every(({ path, label, unit }) => [path, label, unit].every((text) => typeof text === 'string')) &&
    clean.measures.length > 0 &&
    clean.measures.every(({ kind }) => typeof kind === 'string') &&
    runsOf(clean) > 0 &&
    runsOf(clean) <= MOST_SWEEP_RUNS;
  if (!good) throw new Error('it is not what this page stores');
  return {
    plan: clean,
    results: listOf<SweepResult | undefined>(results).slice(0, runsOf(clean)).map(resultFrom(clean)),
  };
}

const resultFrom =
  ({ measures }: SweepPlan) =>
  (result: SweepResult | undefined): SweepResult | undefined =>
    result && Array.isArray(result.values) && result.values.length === measures.length
      ? { values: result.values.map(Number), reason: String(result.reason), message: String(result.message) }
      : undefined;

const LONGEST = 200;

function textOf(value: unknown): string {
  if (typeof value !== 'string') throw new Error('a name is missing');
  return value.slice(0, LONGEST);
}

function whole(value: unknown): number {
  if (!Number.isSafeInteger(value) || (value as number) < 0) throw new Error('a number is missing');
  return value as number;
}

const listOf = <T>(value: readonly T[] | undefined): T[] => (Array.isArray(value) ? [...(value as T[])] : []);

/** Numbers, and null for what is not known. */
const numbersOf = <T extends object>(value: T): T =>
  Object.fromEntries(
    Object.entries(recordOf(value)).filter(([, entry]) => entry === null || typeof entry === 'number'),
  ) as T;

const columnsFrom = (columns: SystemMeta['columns']) =>
  listOf(columns).map(({ name, label, unit }) => ({ name: textOf(name), label: textOf(label), unit: textOf(unit) }));
