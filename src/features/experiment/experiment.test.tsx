// @vitest-environment happy-dom
// The panel edits the draft, says what is not in force, and runs only what can run.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { Experiment } from './experiment.tsx';
import { words } from './words.ts';

afterEach(cleanup);

const field = (name: string) => screen.getByTestId<HTMLInputElement>(name);
function type(name: string, text: string): void {
  fireEvent.input(field(name), { target: { value: text } });
  fireEvent.keyDown(field(name), { key: 'Enter' });
}

test('a field edits the draft, and Reset brings the case back', () => {
  const { app } = draw(<Experiment />);
  const before = app.state.draft.value;
  type('duration', '3');
  type('initial-alpha_fp', 'pi/8');
  expect(app.state.draft.value.duration).toBe(3);
  expect(app.state.draft.value.initial?.['alpha_fp']).toBe('pi/8');
  fireEvent.click(screen.getByTestId('reset'));
  expect(app.state.draft.value).toEqual(before);
  expect(field('initial-alpha_fp').value).not.toBe('pi/8');
});

test('what is refused stays in its field with its reason; the draft keeps the last good value', () => {
  const { app } = draw(<Experiment />);
  const before = app.state.draft.value;
  type('initial-alpha_fp', 'pi/(8');
  expect(field('initial-alpha_fp').getAttribute('aria-invalid')).toBe('true');
  expect(screen.getByText(words.wrongField)).toBeTruthy();
  expect(app.state.draft.value).toEqual(before);
  type('initial-alpha_fp', '-10');
  expect(screen.queryByText(words.wrongField)).toBeNull();
  expect(app.state.draft.value.initial?.['alpha_fp']).toBe('-10 deg');
});

test('another system brings its own coordinates, and going back what was edited', () => {
  const { app } = draw(<Experiment />);
  type('duration', '3');
  fireEvent.change(screen.getByTestId('system'), { target: { value: 'rolling-wheel' } });
  expect(app.state.draft.value.system).toBe('rolling-wheel');
  expect(screen.queryByTestId('initial-alpha_fp')).toBeNull();
  expect(field('initial-phi')).toBeTruthy();
  fireEvent.change(screen.getByTestId('system'), { target: { value: 'ripstik' } });
  expect(field('duration').value).toBe('3');
});
