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
  fireEvent.click(screen.getByTestId('tests-shipped'));
  expect(text.value).toContain('10 m straight');
});

test('a test is added by fields; one that is wrong says what, and stays', async () => {
  draw(<TestsTool />, { app: testApp() });
  const type = (id: string, value: string) => fireEvent.input(screen.getByTestId(id), { target: { value } });
  await screen.findByTestId('add-test');
  type('add-name', 'Steers little');
  type('add-of', 'abs(theta_fc)');
  fireEvent.submit(screen.getByTestId('add-test'));
  expect(screen.getByRole('alert').textContent).toMatch(/^bound: must name a least or a most/);
  type('add-most', '5 deg');
  fireEvent.submit(screen.getByTestId('add-test'));
  expect(screen.queryByRole('alert')).toBeNull();
  const { tests } = JSON.parse(screen.getByTestId<HTMLTextAreaElement>('tests-text').value) as { tests: object[] };
  expect(tests.at(-1)).toEqual({ name: 'Steers little', measure: 'max(abs(theta_fc))', bound: [null, '5 deg'] });
  expect(localStorage.getItem('ripstik.tests')).toContain('Steers little');
  fireEvent.click(screen.getByTestId('tests-shipped'));
});

test('begun they wait, and can be stopped', async () => {
  draw(<TestsTool />, { app: testApp() });
  fireEvent.click(await screen.findByTestId('tests-run'));
  expect(screen.getByTestId('tests-summary').textContent).toMatch(/0 of \d+ runs computed/);
  expect(screen.getByTestId('tests-tool').dataset['state']).toBe('computing');
  fireEvent.click(screen.getByTestId('tests-run'));
  expect(screen.getByTestId('tests-tool').dataset['state']).toBe('cancelled');
});
