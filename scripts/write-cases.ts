// npm run cases: runs every built-in case and writes docs/cases.md with its numbers and docs/cases/<id>.svg with its plots.
import { mkdirSync, writeFileSync } from 'node:fs';
import { cases } from '../src/core/systems/registry.ts';
import type { Case, CasePlot } from '../src/core/cases/case.ts';
import { caseColumns, measured } from '../src/core/motion/caseMeasures.ts';
import { feedbackOf } from '../src/core/control/design/feedback.ts';
import { compileExpression } from '../src/core/scenario/expressions.ts';
import { axisText, columnOf, symbolOf } from '../src/core/motion/columns.ts';
import { words } from '../src/core/motion/symbols.ts';
import { checkScenario } from '../src/core/scenario/schema.ts';
import '../src/core/simulation/everyMotion.ts';
import { Simulation } from '../src/core/simulation/simulation.ts';
import type { System } from '../src/core/model/system.ts';
import { systems } from '../src/core/systems/all.ts';
import { plotSheet, type LinePlotSpec } from '../src/charts/sheet.ts';

const metas = Object.fromEntries(Object.entries(systems).map(([id, system]) => [id, system.meta]));
/** Points of a curve in closed form. */
const EXACT_POINTS = 400;
const PER_DEGREE = 180 / Math.PI;

type Column = (name: string) => Float64Array;

function finished({ scenario: file }: Case): { column: Column; simulation: Simulation } {
  const scenario = checkScenario(file, metas);
  const system = systems[scenario.system]!;
  const simulation = new Simulation(scenario, system, {
    extras: ['lambda', 'energy', 'residual', 'inputs'],
    feedback: feedbackOf(scenario, system),
  });
  simulation.advance(() => false);
  const { columns } = simulation.takeChunk();
  const recorded = new Map(simulation.columns.map((name, i) => [name, columns[i]!]));
  return { column: caseColumns(system, scenario.parameters, (name) => recorded.get(name)), simulation };
}

function plotOf(plot: CasePlot, column: Column, { meta, contacts }: System): LinePlotSpec {
  const factor = plot.unit === 'deg' ? PER_DEGREE : 1;
  const x = column(plot.x);
  const infos = plot.y.map((name) => columnOf(meta, name, contacts));
  const lines = plot.y.map((name, i) => ({ label: symbolOf(infos[i]!), x, y: column(name).map((v) => factor * v) }));
  if (plot.exact) {
    const { evaluate } = compileExpression(plot.exact.expression, { variables: ['t'] });
    const end = Math.min(plot.to ?? Infinity, x.at(-1)!);
    const t = Float64Array.from({ length: EXACT_POINTS + 1 }, (_, i) => (i * end) / EXACT_POINTS);
    lines.push({ label: words(plot.exact.label), x: t, y: t.map((time) => factor * evaluate(time)) });
  }
  return {
    title: plot.title,
    lines,
    to: plot.to,
    equal: plot.equal,
    xLabel: axisText([columnOf(meta, plot.x, contacts)], true),
    yLabel: axisText(infos, plot.unit === 'deg'),
  };
}

function section(one: Case): string {
  const { column, simulation } = finished(one);
  const { id, title, source, look, published = [], plots = [], figures = [] } = one;
  writeFileSync(
    new URL(`${id}.svg`, folder),
    plotSheet(plots.map((plot) => plotOf(plot, column, systems[one.scenario.system]!))),
  );
  const { reason, time } = simulation.end!;
  const numbers = published.map(
    ({ what, measure, value, unit = '', tolerance, source: from }) =>
      `| ${what} | ${short(measured(measure, column))} ${unit} | ${short(value)} ${unit} | ${tolerance.toExponential().replace('e', ' × 10^').replace('+', '')} | ${from} |`,
  );
  return [
    `## ${title}`,
    '',
    `\`${id}\` · ${systems[one.scenario.system]!.meta.title}${source ? ` · ${source}` : ''}`,
    '',
    look,
    '',
    `![${title}, the scene](cases/${id}.webp)`,
    '',
    `Ends: ${reason === 'end' ? 'complete' : reason} at ${short(time)} s.`,
    '',
    ...(numbers.length > 0 ? ['| what | here | known | within | from |', '|---|---|---|---|---|', ...numbers, ''] : []),
    `![${title}: ${plots.map((p) => p.title).join('; ')}](cases/${id}.svg)`,
    '',
    ...figures.flatMap((figure, i) => [
      `${figure.title}, at ${short(figure.time ?? 0)} s:`,
      '',
      `![${figure.title}](cases/${id}-${i + 1}.webp)`,
      '',
    ]),
  ].join('\n');
}

const short = (x: number): string => String(Number(x.toPrecision(6)));
const folder = new URL('../docs/cases/', import.meta.url);
mkdirSync(folder, { recursive: true });
const head = [
  '# Cases',
  '',
  'Every built-in case, run by `npm run cases`, which writes this page: what to look at, what is known about it beside what came out, its scene (`npm run pictures -- cases`) and its plots.',
  'The same cases are in the page, `npm run ripstik -- cases`, and `tests/conformance/cases.test.ts`.',
  '',
  '',
].join('\n');
writeFileSync(new URL('../docs/cases.md', import.meta.url), head + cases.map(section).join('\n'));
console.log(`${cases.length} cases written to docs/cases.md and docs/cases/`);
