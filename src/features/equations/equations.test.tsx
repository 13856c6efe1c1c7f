// @vitest-environment happy-dom
// The equations come with the system on the stage; values stand beside their letters.
import { cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { EquationsTool } from './equationsTool.tsx';

afterEach(cleanup);

test('coordinates with their values at the time on the stage', async () => {
  const app = testApp();
  const { trajectory } = putOnStage(app, app.cases.find(({ id }) => id === 'released')!.scenario);
  draw(<EquationsTool />, { app });
  const panel = await screen.findByTestId('equations', {}, { timeout: 20_000 });
  expect(panel.dataset['system']).toBe('ripstik');
  const value = screen.getByTestId('equations-value-Z').textContent!;
  expect(parseFloat(value)).toBeCloseTo(trajectory.column('Z')![0]!, 3);
});
