// @vitest-environment happy-dom
// Which methods are compared is chosen by row; what cannot run says why; a run of them can be cancelled.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { Methods } from './methodsView.tsx';
import { words } from './words.ts';

afterEach(cleanup);

test('rows are chosen, run and cancelled', () => {
  const app = testApp();
  draw(<Methods comparison={app.comparison} saveTable={() => {}} />, {
    app,
  });
  const row = (id: string) => screen.getByTestId(`method-row-${id}`);
  const box = (id: string) => row(id).querySelector<HTMLInputElement>('input[type=checkbox]')!;
  for (const id of ['qr', 'collocation', 'ida', 'blt']) expect(box(id).checked).toBe(true);
  expect(box('rk4').checked).toBe(false);
  fireEvent.click(box('rk4'));
  expect(box('rk4').checked).toBe(true);
  const cancel = screen.getByTestId<HTMLButtonElement>('methods-cancel');
  expect(cancel.disabled).toBe(true);
  fireEvent.click(screen.getByTestId('methods-run'));
  expect(cancel.disabled).toBe(false);
  expect(row('rk4').querySelector('.why')!.textContent).toMatch(
    new RegExp(`${words.states.waiting}|${words.states.computing}`),
  );
  fireEvent.click(cancel);
  expect(cancel.disabled).toBe(true);
});

test('each of the report’s four stands beside the report’s own time', () => {
  const app = testApp();
  const { container } = draw(<Methods comparison={app.comparison} saveTable={() => {}} />, { app });
  const told = [...container.querySelectorAll('tbody small')].filter((cell) => cell.textContent !== '');
  expect(told).toHaveLength(4);
});
