// @vitest-environment happy-dom
// The tests that come with the system can be run, and what a person writes is read or refused in words.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { TestsTool } from './testsTool.tsx';

afterEach(cleanup);

test('those that come with the board are there; a wrong one is refused where it is wrong', async () => {
  draw(<TestsTool />, { app: testApp() });
  const run = await screen.findByTestId<HTMLButtonElement>('tests-run');
  expect(run.disabled).toBe(false);
  const text = screen.getByTestId<HTMLTextAreaElement>('tests-text');
  expect(text.value).toContain('10 m straight');
  fireEvent.input(text, {
    target: { value: '{"version": 1, "tests": [{"name": "x", "measure": "most(X)", "bound": [0, 1]}]}' },
  });
  expect(screen.getByRole('alert').textContent).toMatch(/tests\[0\]\.measure: "most\(X\)" is no measure/);
  expect(run.disabled).toBe(true);
});

test('begun they wait, and can be stopped', async () => {
  draw(<TestsTool />, { app: testApp() });
  fireEvent.click(await screen.findByTestId('tests-run'));
  expect(screen.getByTestId('tests-summary').textContent).toMatch(/0 of \d+ runs computed/);
  expect(screen.getByTestId('tests-tool').dataset['state']).toBe('computing');
  fireEvent.click(screen.getByTestId('tests-run'));
  expect(screen.getByTestId('tests-tool').dataset['state']).toBe('cancelled');
});
