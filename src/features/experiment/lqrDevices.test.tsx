// @vitest-environment happy-dom
// Sensors and motors of a regulator's computer, by fields.
import { act, cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { useUi } from '../../ui/context.ts';
import { LqrPanel } from './lqrPanel.tsx';

afterEach(cleanup);

function Panel() {
  const { control } = useUi().app.state.draft.value;
  return control?.type === 'lqr' ? <LqrPanel control={control} /> : null;
}

test('a sensor is chosen, given figures and removed; a motor gets its lag', () => {
  const { app } = draw(<Panel />);
  const control = { type: 'lqr' as const, inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, sample: 0.005 };
  void act(() => app.actions.edit('start', () => ({ version: 1, system: 'ripstik', control })));
  const now = () => app.state.draft.value.control as unknown as Record<string, unknown>;
  fireEvent.change(screen.getByTestId('sensor-add'), { target: { value: 'alpha + alpha_fp' } });
  expect(now()['sensors']).toEqual({ 'alpha + alpha_fp': { noise: 0.001 } });
  const type = (id: string, value: string) => {
    const field = screen.getByTestId(id);
    fireEvent.focus(field);
    fireEvent.input(field, { target: { value } });
    fireEvent.blur(field);
  };
  type('sensor-alpha + alpha_fp-bias', '0.002');
  type('sensor-alpha + alpha_fp-noise', '');
  type('sensor-alpha + alpha_fp-resolution', '0.01');
  expect(now()['sensors']).toEqual({ 'alpha + alpha_fp': { bias: 0.002, resolution: 0.01 } });
  type('actuator-tau_fc-lag', '0.02');
  expect(now()['actuators']).toEqual({ tau_fc: { lag: 0.02 } });
  fireEvent.click(screen.getByText('Remove'));
  expect(now()['sensors']).toBeUndefined();
});
