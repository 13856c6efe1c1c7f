import { readFileSync, writeFileSync } from 'node:fs';
import { feedbackOf } from '../core/control/design/feedback.ts';
import { computerReport } from '../core/control/sampled/computerReport.ts';
import { unstableLoop } from '../core/control/sampled/unstableLoop.ts';
import '../core/simulation/everyMotion.ts';
import { shippedTests } from '../core/manoeuvres/shipped.ts';
import { junitOf, outcomeOf, reportOf, type Outcome } from '../core/manoeuvres/report.ts';
import { measureRun, runsOf, type Measured } from '../core/manoeuvres/run.ts';
import { checkTests, parseTests, type CheckedTest } from '../core/manoeuvres/testFile.ts';
import { StartError } from '../core/mechanics/consistentStart.ts';
import type { System } from '../core/model/system.ts';
import { checkScenario } from '../core/scenario/schema.ts';
import { ScenarioError, type ScenarioFile } from '../core/scenario/types.ts';
import { systemMetas as metas } from '../core/systems/registry.ts';
import { cannotWrite } from './output.ts';
import { pathOf, UsageError } from './usage.ts';

export interface TestOptions {
  tests: string | undefined;
  report: string | undefined;
  junit: string | undefined;
}

/**
 * Puts a scenario through its tests, one line each on standard output.
 * @returns 0 when all passed, 1 otherwise
 */
export function test(file: ScenarioFile, system: System, { tests, report, junit }: TestOptions): number {
  const list = testsFrom(tests, system);
  const outcomes: Outcome[] = [];
  for (const one of list) {
    const outcome = carriedOut(one, file, system);
    outcomes.push(outcome);
    process.stdout.write(`${outcome.passed ? 'pass' : 'FAIL'}  ${one.name}: ${outcome.message}\n`);
  }
  const all = reportOf(system.meta.id, outcomes, notesOn(file, system));
  process.stdout.write(`${all.passed} of ${outcomes.length} passed\n`);
  for (const note of all.notes) process.stdout.write(`${note}\n`);
  if (report) write(report, `${JSON.stringify(all, null, 2)}\n`);
  if (junit) write(junit, junitOf(all));
  return all.failed === 0 ? 0 : 1;
}

/** What can be said of a regulator before it is run; a scenario that has no design says so in its tests. */
function notesOn(file: ScenarioFile, system: System): string[] {
  try {
    const scenario = checkScenario(file, metas);
    if (scenario.control?.type !== 'lqr') return [];
    const why = unstableLoop(scenario.control, computerReport(scenario, system).sampled);
    return why ? [why] : [];
  } catch (error) {
    if (error instanceof ScenarioError) return [];
    throw error;
  }
}

function testsFrom(name: string | undefined, { meta }: System): CheckedTest[] {
  if (name === undefined) {
    const shipped = shippedTests(meta.id);
    if (!shipped) throw new UsageError(`no tests come with ${meta.id}; give your own with --tests FILE.json`);
    return checkTests(shipped);
  }
  let text: string;
  try {
    text = readFileSync(pathOf(name), 'utf8');
  } catch (error) {
    throw new UsageError(`${name} can't be read: ${(error as Error).message}`);
  }
  try {
    return parseTests(text);
  } catch (error) {
    if (error instanceof ScenarioError) throw new UsageError(`${name}: ${error.message}`);
    throw error;
  }
}

/** A run that can't begin (no design, no consistent start) fails its test, with the reason. A patch that is wrong is a bad file. */
function carriedOut(one: CheckedTest, file: ScenarioFile, system: System): Outcome {
  const from = performance.now();
  const runs = runsOf(one, file).map((run): Measured | string => {
    let scenario;
    let designed;
    try {
      scenario = checkScenario(run.file, metas);
      designed = run.designedFor === run.file ? scenario : checkScenario(run.designedFor, metas);
    } catch (error) {
      if (error instanceof ScenarioError) throw new UsageError(`test "${one.name}": ${error.message}`);
      throw error;
    }
    let feedback;
    try {
      feedback = feedbackOf(designed, system);
    } catch (error) {
      if (error instanceof ScenarioError) return error.message;
      throw error;
    }
    try {
      return measureRun(one, scenario, system, feedback);
    } catch (error) {
      if (error instanceof StartError) return error.message;
      throw new UsageError(`test "${one.name}": ${(error as Error).message}`);
    }
  });
  return outcomeOf(one, runs, (performance.now() - from) / 1000);
}

function write(name: string, text: string): void {
  try {
    writeFileSync(pathOf(name), text);
  } catch (error) {
    throw cannotWrite(name, error);
  }
}
