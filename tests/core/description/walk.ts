/** Takes a description through everything that works on a system, and tells what did not. `npm run strangers` prints it. */
import { isDeepStrictEqual } from 'node:util';
import '../../../src/core/simulation/everyMotion.ts';
import { controlReport, type ControlReport } from '../../../src/core/control/design/report.ts';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { scenarioLocus } from '../../../src/core/control/locus/scenarioLocus.ts';
import { readSystem } from '../../../src/core/description/index.ts';
import { methods } from '../../../src/core/integrators/methods.ts';
import type { System } from '../../../src/core/model/system.ts';
import { decodeLink, encodeLink } from '../../../src/core/scenario/link.ts';
import { FORMULATION_NAMES } from '../../../src/core/scenario/defaults.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import type { Scenario, ScenarioFile } from '../../../src/core/scenario/types.ts';
import { Simulation, type RunCounts } from '../../../src/core/simulation/simulation.ts';
import { runOne } from '../../../src/core/sweep/runOne.ts';
import { checkStudy } from '../../../src/core/sweep/study.ts';
import { cases, learnSystem, loadSystem, loadTypeset, systemMetas } from '../../../src/core/systems/registry.ts';
import { readCsv, writeCsv } from '../../../src/csv/csv.ts';

export interface Plan {
  /** Of every run. */
  initial?: Record<string, number | string>;
  duration?: number;
  /** A steady motion, where there is one. */
  at?: Record<string, number | string>;
  /** A regulator: which inputs, and what it weighs. */
  lqr?: { inputs: string[]; Q?: Record<string, number>; from: Record<string, number | string>; holds: string[] };
  /** The reason with which a run ends, where that is not its duration. */
  ends?: string;
  /** The parameter over which roots go, where it is not the first; null: the steady motion is another for every value. */
  locus?: string | null;
  /** Dampers take energy, which no balance counts. */
  loses?: true;
  parameters?: Record<string, number>;
}

export interface Walked {
  id: string;
  system: System;
  scenario: ScenarioFile;
  /** What went wrong, a line each. */
  wrong: string[];
  /** Figures, in the order of the walk. */
  told: Record<string, number | string>;
  report: ControlReport | null;
}

export interface Finished {
  simulation: Simulation;
  counts: RunCounts;
  reason: string;
  end: Record<string, number>;
  columns: readonly string[];
  data: readonly Float64Array[];
}

const EXTRAS = ['lambda', 'energy', 'residual', 'inputs'];

/** Runs a scenario to its end. */
export function run(system: System, scenario: Scenario): Finished {
  const feedback = scenario.control ? feedbackOf(scenario, system) : null;
  const simulation = new Simulation(scenario, system, { feedback, extras: EXTRAS });
  while (!simulation.end) simulation.advance(() => false);
  const { columns: data, rows } = simulation.takeChunk();
  const end = Object.fromEntries(simulation.columns.map((name, k) => [name, data[k]![rows - 1]!]));
  const { columns, counts } = simulation;
  return { simulation, counts, reason: simulation.end.reason, end, columns, data };
}

/** Steps of methods that take one size: enough for four digits of what moves within tenths of a second. */
const FIXED: Record<string, number> = { euler: 1e-4, rk4: 1e-3, 'adams-moulton': 1e-3 };

/**
 * @param id for messages
 * @param text of the description
 * @param plan what of its experiment is its own
 */
export async function walk(id: string, text: string, plan: Plan): Promise<Walked> {
  const { faults } = readSystem(text);
  if (faults.length > 0) throw new Error(`${id}: ${faults.map(({ message }) => message).join('; ')}`);
  const { meta } = await learnSystem(text);
  const system = await loadSystem(meta.id)!;
  const { initial = {}, duration = 1, parameters = {} } = plan;
  const file: ScenarioFile = {
    version: 1,
    system: meta.id,
    duration,
    outputStep: duration / 50,
    ...(plan.initial ? { initial } : {}),
    ...(plan.parameters ? { parameters } : {}),
  };
  const wrong: string[] = [];
  const told: Walked['told'] = {};
  const walked: Walked = { id, system, scenario: file, wrong, told, report: null };
  const check = (raw: object = {}): Scenario => checkScenario({ ...file, ...raw }, systemMetas);
  const attempt = <T>(what: string, act: () => T): T | null => {
    try {
      return act();
    } catch (error) {
      wrong.push(`${what}: ${error instanceof Error ? error.message : String(error)}`);
      return null;
    }
  };

  attempt('start', () => {
    const { simulation } = run(system, check({ duration: duration / 1000 }));
    told['adjusted'] = simulation.adjustments.map(({ name }) => name).join(' ');
  });

  // One answer by a tight method, to which all others come.
  const best = attempt('run', () =>
    run(system, check({ method: { name: 'gauss', stages: 4, rtol: 1e-12, atol: 1e-13 } })),
  );
  if (best) {
    if (best.reason !== (plan.ends ?? 'end')) wrong.push(`run: ended with ${best.reason}`);
    told['residual'] = best.counts.residual;
    if (!(best.counts.residual < 1e-10)) wrong.push(`residual ${best.counts.residual}`);
    const { energyDrift, energyChange, work } = best.counts;
    told['drift'] = energyDrift ?? 'none';
    if (work !== null) told['unbalanced'] = energyChange - work;
    if (!plan.loses && energyDrift !== null && !(Math.abs(energyDrift) < 1e-9)) wrong.push(`drift ${energyDrift}`);
    const states = meta.coordinates.map(({ name }) => name);
    const { duration: _, ...others } = file;
    const short = { ...others, duration: duration / 10 };
    const goal = run(
      system,
      checkScenario({ ...short, method: { name: 'gauss', stages: 4, rtol: 1e-12, atol: 1e-13 } }, systemMetas),
    );
    for (const { id: name, adaptive } of methods)
      for (const formulation of name === 'ida' || system.firstOrder ? [undefined] : FORMULATION_NAMES) {
        const method = {
          name,
          ...(formulation ? { formulation } : {}),
          ...(adaptive ? { rtol: 1e-9, atol: 1e-11 } : { step: FIXED[name] }),
        };
        const other = attempt(`${name} ${formulation ?? ''}`, () =>
          run(system, checkScenario({ ...short, method }, systemMetas)),
        );
        if (!other) continue;
        if (other.reason !== goal.reason) wrong.push(`${name} ${formulation}: ended with ${other.reason}`);
        const far = Math.max(
          ...states.map((s) => Math.abs(other.end[s]! - goal.end[s]!) / (1 + Math.abs(goal.end[s]!))),
        );
        if (!(far < (adaptive ? 1e-5 : name === 'euler' ? 1e-2 : 1e-3)))
          wrong.push(`${name} ${formulation}: ${far.toPrecision(2)} away`);
        if (!(other.counts.residual < 1e-8)) wrong.push(`${name} ${formulation}: residual ${other.counts.residual}`);
      }
    attempt('events', () => {
      for (const event of meta.events ?? []) {
        const { reason } = run(system, check({ events: { [event.id]: 'ignore' } }));
        if (reason === event.id) wrong.push(`event ${event.id} is not ignored`);
      }
    });
    attempt('csv', () => {
      const written = writeCsv(best.columns, best.data, [
        `scenario: ${JSON.stringify({ ...file, system: { description: text } })}`,
      ]);
      const read = readCsv(written, { systems: systemMetas, preferred: meta.id });
      if (read.kind !== 'motion') return void wrong.push(`csv: ${read.kind}`);
      if (read.systemId !== meta.id) wrong.push(`csv: read as ${read.systemId}`);
      for (const [k, name] of best.columns.entries()) {
        const at = read.columns.indexOf(name);
        if (at < 0) wrong.push(`csv: ${name} is missing`);
        else if (best.data[k]!.some((x, i) => !Object.is(x, read.data[at]![i]) && !Number.isNaN(x)))
          wrong.push(`csv: ${name} differs`);
      }
    });
  }

  if (plan.at) {
    const { at } = plan;
    walked.report = attempt('linearize', () => controlReport(check({ at }), system));
    if (walked.report) {
      const { orders, eigenvalues, reachability } = walked.report;
      const size = Math.max(1, ...eigenvalues.map(([re, im]) => Math.hypot(re, im)));
      told['orders'] = orders.difference;
      told['reachable'] = `${reachability.dimension}/${eigenvalues.length}`;
      if (!(orders.difference < 1e-8 * size * size)) wrong.push(`orders differ by ${orders.difference}`);
    }
    const parameter = meta.parameters.find(({ name }, k) => (plan.locus === undefined ? k === 0 : name === plan.locus));
    if (parameter)
      attempt('locus', () => {
        const value = parameters[parameter.name] ?? parameter.default;
        const request = {
          vary: 'parameter',
          name: parameter.name,
          from: 0.9 * value,
          to: 1.1 * value,
          count: 5,
          closed: false,
        } as const;
        const locus = scenarioLocus(check({ at }), system, request, () => {});
        if (locus.skipped.length > 0) wrong.push(`locus: ${locus.skipped[0]!.reason}`);
      });
  }
  if (plan.lqr) {
    const { inputs, Q, from, holds } = plan.lqr;
    const control = { type: 'lqr', inputs, ...(Q ? { Q } : {}), ...(plan.at ? { at: plan.at } : {}) };
    attempt('lqr', () => {
      const { careResidual, closedLoopEigenvalues } = controlReport(check({ control }), system);
      told['care'] = careResidual!;
      if (!(careResidual! < 1e-8)) wrong.push(`lqr: residual ${careResidual}`);
      if (closedLoopEigenvalues!.some(([re]) => re > 1e-9)) wrong.push('lqr: it grows');
      const { end, reason } = run(system, check({ control, initial: { ...initial, ...from }, duration: 10 }));
      if (reason !== 'end' && reason !== plan.ends) wrong.push(`lqr: ended with ${reason}`);
      for (const name of holds)
        if (!(Math.abs(end[name]! - Number(plan.at?.[name] ?? 0)) < 1e-2))
          wrong.push(`lqr: ${name} ends at ${end[name]}`);
    });
  }

  const [parameter] = meta.parameters;
  if (parameter)
    attempt('sweep', () => {
      const value = parameters[parameter.name] ?? parameter.default;
      const study = checkStudy(
        {
          version: 1,
          scenario: { ...file, duration: duration / 10 },
          vary: { [`parameters.${parameter.name}`]: { grid: [0.9 * value, 1.1 * value, 3] } },
          measures: [`final.${meta.coordinates[0]!.name}`, 'drift', ...meta.inputs.map(({ name }) => `max.${name}`)],
        },
        systemMetas,
      );
      for (let k = 0; k < 3; k++) {
        const row = runOne(study, k, system, systemMetas, feedbackOf);
        if (row.reason === 'refused' || [row.measures[0], ...row.measures.slice(2)].some((x) => !Number.isFinite(x)))
          wrong.push(`sweep: ${row.reason} ${row.message}`);
      }
    });
  attempt('link', () => {
    const known = { cases, systems: systemMetas };
    const link = encodeLink({ caseId: null, title: id, scenario: file }, known);
    told['link'] = link.length;
    const opened = decodeLink(link, known);
    if (opened.altered || !isDeepStrictEqual(opened.scenario, file)) wrong.push('link: another scenario came back');
  });
  const typeset = await loadTypeset(meta.id)!.catch((error: unknown) => void wrong.push(`typeset: ${String(error)}`));
  if (typeset && JSON.stringify(typeset).includes('undefined')) wrong.push('typeset: undefined');
  return walked;
}
