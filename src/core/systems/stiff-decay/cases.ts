import type { Case } from '../../cases/case.ts';

/** Fig. 13: one run per curve; a row per step, as the figure marks them. */
function run(method: string, name: string, step: number, look: string, steps: readonly number[]): Case {
  return {
    id: `stiff-decay-${method}-${1 / step}`,
    title: `Stiff decay: ${name}, h = 1/${1 / step} (Fig. 13)`,
    among: { id: 'stiff-decay', value: `${name}, h = 1/${1 / step}` },
    source: 'Report, section 3.4.3, Fig. 13',
    figure: 'Fig. 13',
    chapter: '3.4.3',
    look,
    picture:
      step > 0.2 ? { time: 0.3, view: 'side', distance: 2.5 } : { time: method === 'euler' ? 0.8 : 0.3, view: 'side' },
    scenario: { version: 1, system: 'stiff-decay', method: { name: method, step }, duration: 1, outputStep: step },
    published: steps.map((value, k) => ({
      what: `y after ${k + 1} step${k === 0 ? '' : 's'}`,
      measure: { kind: 'at', column: 'y', time: (k + 1) * step },
      value,
      tolerance: 1e-12,
      source: 'the method applied by hand',
    })),
    plots: [
      {
        title: 'Fig. 13: a stiff equation',
        x: 't',
        y: ['y'],
        unit: '1',
        exact: { label: 'exact solution', expression: 'exp(-15*t)' },
      },
    ],
  };
}

export const stiffDecayCases: readonly Case[] = [
  run(
    'euler',
    'Euler',
    1 / 4,
    'Each step multiplies by −2.75: the values swing and grow without bound.',
    [-2.75, 7.5625],
  ),
  run(
    'euler',
    'Euler',
    1 / 8,
    'Each step multiplies by −0.875: the values swing about the exact ones and die away slowly.',
    [-0.875, 0.765625],
  ),
  run(
    'adams-moulton',
    'Adams–Moulton',
    1 / 8,
    'The trapezoidal rule multiplies by 1/31 with the same step, and is nearly exact.',
    [1 / 31, 1 / 961],
  ),
];
