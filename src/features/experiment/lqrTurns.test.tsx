// @vitest-environment happy-dom
// A regulator that starts a full turn from its point: said before the run, and mended at a press; which weights are in force.
import { act, cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { useUi } from '../../ui/context.ts';
import { LqrPanel } from './lqrPanel.tsx';
import { lqrWords } from './lqrWords.ts';

afterEach(cleanup);

function Panel() {
  const { control } = useUi().app.state.draft.value;
  return control?.type === 'lqr' ? <LqrPanel control={control} /> : null;
}

const regulated = (alpha: number | string, Q?: Record<string, number>) => ({
  version: 1 as const,
  system: 'ripstik',
  initial: { alpha },
  control: { type: 'lqr' as const, inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, ...(Q && { Q }) },
});

test('a turn away is said, and taken back at a press', () => {
  const { app } = draw(<Panel />);
  void act(() => app.actions.edit('start', () => regulated('370 deg')));
  expect(screen.getByTestId('lqr-turn-alpha').textContent).toContain(lqrWords.turnAway);
  fireEvent.click(screen.getByTestId('lqr-same-alpha'));
  expect(app.state.draft.value.initial?.['alpha']).toBeCloseTo((10 * Math.PI) / 180, 12);
  expect(screen.queryByTestId('lqr-turn-alpha')).toBeNull();
});

test('half a turn away is a start like any other', () => {
  const { app } = draw(<Panel />);
  void act(() => app.actions.edit('start', () => regulated('-180 deg')));
  expect(screen.getByTestId('lqr')).toBeTruthy();
  expect(screen.queryByTestId('lqr-turn-alpha')).toBeNull();
});

test('what states without a weight of their own weigh is said', () => {
  const { app } = draw(<Panel />);
  void act(() => app.actions.edit('start', () => regulated(0)));
  expect(screen.getByTestId('lqr-used').textContent).toBe(lqrWords.usedOnes);
  void act(() => app.actions.edit('start', () => regulated(0, { alpha_fp: 1 })));
  expect(screen.getByTestId('lqr-used').textContent).toBe(lqrWords.usedNamed);
});
