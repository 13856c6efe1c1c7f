// @vitest-environment happy-dom
/** A sweep's Parquet file in the page: what is shown of it, and a run of it put into the panel. */
import { act, cleanup, fireEvent, screen, waitFor } from '@testing-library/preact';
import { readFileSync } from 'node:fs';
import { afterEach, expect, test } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { StudyTool } from './studyTool.tsx';
import { words } from './words.ts';

afterEach(cleanup);

const basin = (): File => new File([readFileSync('public/studies/basin.parquet')], 'basin.parquet');

test('the basin that comes with the page: 10,000 runs of its study, each of which opens', async () => {
  const app = testApp();
  draw(<StudyTool />, { app });
  expect(screen.getByText(words.none)).toBeTruthy();
  app.actions.openFiles([basin()]);
  await waitFor(() => expect(screen.getByTestId('study-facts').textContent).toContain('10,000 runs'), {
    timeout: 20_000,
  });
  const { study } = app.state.study.peek()!;
  expect(study!.file).toEqual(JSON.parse(readFileSync('public/studies/basin.json', 'utf8')));
  fireEvent.click(screen.getByTestId('study-open-7'));
  expect(app.state.draft.peek()).toMatchObject(study!.scenario(7));
  expect(app.state.origin.peek().title).toBe('basin, run 7');
  fireEvent.change(screen.getByTestId('study-y'), { target: { value: '' } });
  expect(screen.getByText(words.hintBars)).toBeTruthy();
});

test('what is no sweep, or was cut off, is told, and what was open stays', async () => {
  const app = testApp();
  draw(<StudyTool />, { app });
  const whole = readFileSync('public/studies/basin.parquet');
  app.actions.openFiles([new File([whole.subarray(0, 5000)], 'cut.parquet')]);
  await waitFor(() => expect(app.state.messages.peek().length).toBe(1), { timeout: 20_000 });
  expect(app.state.messages.peek()[0]!.details[0]).toContain('damaged or was cut off');
  void act(() => {});
  expect(app.state.study.peek()).toBeNull();
});
