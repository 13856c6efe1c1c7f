// @vitest-environment happy-dom
/** The tool for pumping gaits: what its sliders write into the experiment, and where there is nothing to pump with. */
import { act, cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { GaitsTool } from './gaitsTool.tsx';
import { words } from './words.ts';

afterEach(cleanup);

test('a slider writes the targets of both feet; the rest of the experiment stays', () => {
  const app = testApp();
  draw(<GaitsTool />, { app });
  void act(() => app.actions.edit('duration', (draft) => ({ ...draft, duration: 3, parameters: { wheelDrag: 0.5 } })));
  fireEvent.input(screen.getByTestId('gait-amplitude'), { target: { value: '20' } });
  fireEvent.input(screen.getByTestId('gait-phase'), { target: { value: '180' } });
  const draft = app.state.draft.peek();
  expect(draft).toMatchObject({ duration: 3, parameters: { wheelDrag: 0.5 }, control: { type: 'track', kp: 60 } });
  const reference = draft.control?.type === 'track' ? draft.control.reference : {};
  expect(reference).toMatchObject({
    tau_fp: `${(20 * Math.PI) / 180}*sin(2*pi*1*t)`,
    tau_bp: `${(20 * Math.PI) / 180}*sin(2*pi*1*t + ${Math.PI})`,
  });
});

test('a system without feet says so', () => {
  const app = testApp();
  draw(<GaitsTool />, { app });
  void act(() => app.actions.loadScenario({ version: 1, system: 'bicycle' }, 'A bicycle'));
  expect(screen.getByText(words.noFeet('Bicycle (Whipple)'))).toBeTruthy();
});
