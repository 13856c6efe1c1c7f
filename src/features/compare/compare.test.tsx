// @vitest-environment happy-dom
// Runs are pinned once, named, removed and brought back; the status line says the same.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { compare } from './manifest.tsx';
import { PinnedList } from './pinnedList.tsx';
import { PinRun } from './pinRun.tsx';
import { firstWords } from './firstWords.ts';

afterEach(cleanup);

function bench() {
  const app = testApp();
  putOnStage(app, app.cases.find(({ id }) => id === 'released')!.scenario);
  draw(
    <>
      <PinnedList />
      <PinRun />
    </>,
    { app, features: [compare] },
  );
  return { app };
}

test('pinning is offered once for a motion', () => {
  bench();
  fireEvent.click(screen.getByTestId('status-keep'));
  expect(screen.getByTestId<HTMLButtonElement>('compare-keep').disabled).toBe(true);
  expect(screen.queryByTestId('status-keep')).toBeNull();
  expect(screen.getByText(firstWords.pinned, { exact: true })).toBeTruthy();
});

test('a name given stays through removing and undoing', () => {
  const { app } = bench();
  fireEvent.click(screen.getByTestId('compare-keep'));
  const name = screen.getByTestId<HTMLInputElement>('kept-name-1');
  fireEvent.input(name, { target: { value: 'slow' } });
  fireEvent.change(name, { target: { value: 'slow' } });
  fireEvent.click(screen.getByTestId('kept-remove-1'));
  expect(screen.queryByTestId('kept-1')).toBeNull();
  fireEvent.click(screen.getByTestId('kept-undo'));
  expect(screen.getByTestId<HTMLInputElement>('kept-name-1').value).toBe('slow');
  expect(app.pinned.ofStage()).toBeTruthy();
});
