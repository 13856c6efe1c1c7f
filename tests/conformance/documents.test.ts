// What documents and captions say of runs is what the shipped cases give.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { caseColumns, measured } from '../../src/core/motion/caseMeasures.ts';
import { DigitsMeter, secondScenario } from '../../src/core/simulation/trust.ts';
import { systems } from '../../src/core/systems/all.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { runOf, scenarioOf } from '../helpers.ts';

const caseOf = (id: string) => cases.find((c) => c.id === id)!;

test('docs/casterboard-robot.md: the table is what the cases give, to its last digit', () => {
  const text = readFileSync('docs/casterboard-robot.md', 'utf8');
  const rows = [...text.matchAll(/^\| `([\w-]+)`.*\| ([\d.]+) m \| ([\d.]+) m \|$/gm)];
  expect(rows).toHaveLength(cases.filter(({ scenario }) => scenario.system === 'casterboard-robot').length);
  for (const [, id, known, here] of rows) {
    const { scenario, published } = caseOf(id!);
    const { columns } = runOf(scenario);
    const { parameters } = scenarioOf(scenario);
    const column = caseColumns(systems['casterboard-robot']!, parameters, (name) => columns.get(name));
    const [{ measure, value }] = published as [NonNullable<typeof published>[number]];
    expect(value, `${id}, known`).toBe(Number(known));
    expect(measured(measure, column).toFixed(here!.split('.')[1]!.length), `${id}, here`).toBe(here);
  }
});

test('the caption of the falling board says to when its run is right, as --verify does', () => {
  const { look, scenario: file } = caseOf('falling-report');
  const [, four, none] = /right to 4 digits until ([\d.]+) s, to none after ([\d.]+) s/.exec(look)!;
  const second = secondScenario(scenarioOf(file));
  const [a, b] = [runOf(file), runOf({ ...file, method: second.method })];
  const meter = new DigitsMeter(systems['ripstik']!.meta, second.method);
  meter.take('first', [...a.columns.values()], a.rows);
  meter.take('second', [...b.columns.values()], b.rows);
  const { until } = meter.finish(a.end, b.end);
  // Never more than what was compared, and no less than a tenth of a second of it.
  expect(Number(four)).toBeLessThanOrEqual(until[4]);
  expect(Number(four)).toBeGreaterThan(until[4] - 0.1);
  expect(Number(none)).toBeGreaterThanOrEqual(until[1]);
  expect(Number(none)).toBeLessThan(until[1] + 0.1);
});
