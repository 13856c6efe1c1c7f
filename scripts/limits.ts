// npm run limits: the largest lean and push from which the balanced board recovers, against speed, into docs/limits/ as CSV and SVG.
import { mkdirSync, writeFileSync } from 'node:fs';
import { degrees, largest, leanTest, pushTest, type Balance } from '../src/cli/bench/recovery.ts';
import { plotSheet, type Line } from '../src/charts/sheet.ts';
import { words } from '../src/core/motion/symbols.ts';

const SPEEDS = [0.5, 0.75, 1, 1.5, 2, 3, 4, 5];
const BOTH = ['tau_fc', 'tau_bc'];
/** N·m on each motor. */
const LIMITS = [null, 2, 1, 0.5];
/** Bisected until what is survived and what is not are this close. */
const RATIO = 1.01;
/** Where the search begins, rad or N·m. */
const START = 0.2;

const folder = new URL('../docs/limits/', import.meta.url);
mkdirSync(folder, { recursive: true });

interface Row {
  speed: number;
  motors: string;
  limit: number | null;
  survived: number;
  failed: number;
}

function row(kind: 'lean' | 'push', balance: Balance): Row {
  const most = kind === 'lean' ? 1.2 : 20;
  const found = largest((kind === 'lean' ? leanTest : pushTest)(balance), START, most, RATIO);
  const unit = kind === 'lean' ? degrees : (x: number): number => x;
  return {
    speed: balance.speed,
    limit: balance.limit,
    motors: balance.inputs.join(' '),
    survived: unit(found.survived),
    failed: unit(found.failed),
  };
}

const short = (x: number): string => (Number.isFinite(x) ? String(Number(x.toPrecision(4))) : '');

function write(name: string, unit: string, rows: readonly Row[]): void {
  const lines = rows.map((r) => [r.speed, r.motors, r.limit ?? '', short(r.survived), short(r.failed)].join(','));
  const head = `# ${name}: written by npm run limits; both ends of the last bisection\n`;
  writeFileSync(
    new URL(`${name}.csv`, folder),
    `${head}speed [m/s],motors,limit [N·m],survived [${unit}],not survived [${unit}]\n${lines.join('\n')}\n`,
  );
}

/** One line per value of a key, over speed. */
function linesBy(rows: readonly Row[], key: (r: Row) => string, y: (survived: number) => number = (s) => s): Line[] {
  return [...new Set(rows.map(key))].map((label) => {
    const chosen = rows.filter((r) => key(r) === label && r.survived > 0);
    return { label: words(label), x: chosen.map((r) => r.speed), y: chosen.map((r) => y(r.survived)) };
  });
}

const sweep = (kind: 'lean' | 'push'): Row[] =>
  LIMITS.flatMap((limit) => SPEEDS.map((speed) => row(kind, { speed, inputs: BOTH, limit })));
const [lean, push] = [sweep('lean'), sweep('push')];
const single = [BOTH, ['tau_fc'], ['tau_bc']].flatMap((inputs) =>
  SPEEDS.map((speed) => row('lean', { speed, inputs, limit: null })),
);
write('lean', 'deg', lean);
write('push', 'N·m', push);
write('single-motor', 'deg', single);

const limited = ({ limit }: Row): string => (limit === null ? 'no limit' : `${limit} N·m`);
const names: Record<string, string> = { 'tau_fc tau_bc': 'both', tau_fc: 'front alone', tau_bc: 'back alone' };
writeFileSync(
  new URL('limits.svg', folder),
  plotSheet([
    {
      title: 'Largest lean it recovers from, by limit of each motor',
      xLabel: words('speed, m/s'),
      yLabel: words('lean of both plates, °'),
      lines: linesBy(lean, limited),
    },
    {
      title: 'Largest push, N·m on each plate',
      xLabel: words('speed, m/s'),
      yLabel: words('two Gaussians of opposite sign, N·m'),
      lines: linesBy(push, limited),
    },
    {
      title: 'Largest lean, by motor (no limit)',
      xLabel: words('speed, m/s'),
      yLabel: words('log10 of the lean in °'),
      lines: linesBy(single, (r) => names[r.motors]!, Math.log10),
    },
  ]),
);
