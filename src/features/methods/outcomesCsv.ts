import type { Outcome } from '../../app/runs/comparison.ts';
import { download } from '../../app/files/download.ts';

const HEADINGS = [
  'method',
  'name',
  'formulation',
  'rtol',
  'atol',
  'step',
  'stages',
  'computing_s',
  'output_s',
  'steps',
  'rejected',
  'evaluations',
  'jacobians',
  'energy_drift',
  'residual',
  'ended',
];

/** The table as CSV. */
export function saveOutcomes(outcomes: readonly Outcome[]): void {
  const rows = outcomes.map(({ contender: { label, method }, seconds, reached, counts, reason, message, state }) =>
    [
      label,
      method.name,
      method.formulation ?? (method.name === 'ida' ? '' : 'multipliers'),
      method.rtol,
      method.atol,
      method.step,
      method.stages,
      seconds,
      reached,
      counts?.steps,
      counts?.rejected,
      counts?.evaluations,
      counts?.jacobians,
      counts?.energyDrift,
      counts?.residual,
      state === 'ended' ? reason : message || state,
    ]
      .map((cell) =>
        typeof cell === 'string' && /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : String(cell ?? ''),
      )
      .join(','),
  );
  download('methods.csv', [[HEADINGS.join(','), ...rows].join('\n') + '\n'], 'text/csv');
}
