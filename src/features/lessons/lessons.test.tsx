// @vitest-environment happy-dom
// A lesson beside the stage: its live parts go to the stage, its questions are checked against what is computed, progress stays.
import { cleanup, fireEvent, screen, waitFor, within } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { readLesson } from '../../core/lessons/lesson.ts';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { LessonsTool } from './lessonsTool.tsx';
import { lessons } from './manifest.tsx';
import { faultsIn } from './subject.ts';
import { words } from './words.ts';

afterEach(cleanup);

test('a question is checked against the computed answer, in any unit, and stays answered', async () => {
  const app = testApp();
  const asked = vi.spyOn(app.mechanics, 'answer').mockResolvedValue({ ok: true, value: 6 });
  const loaded = vi.spyOn(app.actions, 'loadCase').mockImplementation(() => {});
  draw(<LessonsTool />, { app, features: [lessons] });
  const entry = await screen.findByTestId('lesson-1-rolling');
  expect(entry.closest('li')!.textContent).toContain(words.progress(0, 3));
  fireEvent.click(entry);
  fireEvent.click(screen.getAllByTestId('lesson-show')[0]!);
  await waitFor(() => expect(loaded).toHaveBeenCalledWith('rolling-wheel-line'));
  const question = screen.getByTestId('question-0');
  const answer = async (text: string, told: string): Promise<void> => {
    fireEvent.input(within(question).getByRole('textbox'), { target: { value: text } });
    fireEvent.submit(question);
    await waitFor(() => expect(within(question).getByRole('status').textContent).toBe(told));
  };
  await answer('six', words.fault('this is no number in m'));
  expect(asked).not.toHaveBeenCalled();
  await answer('5 m', words.wrong);
  await answer('600 cm', words.right('6.000 m'));
  expect(asked.mock.calls[0]![1]).toEqual({ kind: 'end', column: 'X' });
  fireEvent.click(screen.getByTestId('lessons-back'));
  expect((await screen.findByTestId('lesson-1-rolling')).closest('li')!.textContent).toContain(words.progress(1, 3));
});

test('a lesson of one’s own is read from a file, or refused with its line; its markup stays text', async () => {
  draw(<LessonsTool />, { app: testApp(), features: [lessons] });
  const give = (text: string): void => {
    const input = screen.getByTestId<HTMLInputElement>('lesson-file');
    Object.defineProperty(input, 'files', { value: [new File([text], 'own.md')], configurable: true });
    fireEvent.change(input);
  };
  give('# Mine\n```live\ntitle: x\n```');
  await waitFor(() => expect(screen.getByRole('alert').textContent).toMatch(/line 2: this block needs a line/));
  give('# Mine\n\n<img src=x onerror=alert(1)> *yes*');
  const lesson = await screen.findByTestId('lesson');
  expect(lesson.querySelector('img')).toBeNull();
  expect(lesson.querySelector('em')!.textContent).toBe('yes');
});

test('who wrote a lesson is told which of its parts can’t be used, and why', async () => {
  const app = testApp();
  draw(<LessonsTool />, { app, features: [lessons] });
  const part = (kind: string, ...lines: string[]): string => ['```' + kind, ...lines, '```', ''].join('\n');
  const text = [
    '# Mine',
    part('live', 'title: Good', 'case: ridden', 'plot: alpha lambda_1'),
    part('live', 'title: No case', 'case: riden'),
    part('live', 'title: No column', 'case: ridden', 'plot: alhpa'),
    part('live', 'title: No field', 'case: ridden', 'vary: parameters.tail 0 1'),
    part('question', 'ask: How far?', 'scenario: {"version": 1, "system": "ripstick"}', 'answer: end X'),
  ].join('\n');
  app.actions.openFiles([new File([text], 'own.md')]);
  const told = await screen.findByTestId('lesson-faults');
  const lines = within(told)
    .getAllByRole('listitem')
    .map(({ textContent }) => textContent);
  expect(lines[0]).toBe('line 8: there is no case "riden"');
  expect(lines[1]).toMatch(/^line 13: there is no column "alhpa"; right would be t, X, /);
  expect(lines[2]).toMatch(/^line 19: parameters.tail: unknown name "tail"/);
  expect(lines[3]).toMatch(/^line 25: system: unknown name "ripstick"/);
  expect(app.state.tool.value).toBe('lessons');
  fireEvent.click(screen.getByTestId('lessons-back'));
  expect(app.state.lesson.value).toBeNull();
});

test('no part of the page’s own lessons has a fault', async () => {
  const app = testApp();
  const files = import.meta.glob<string>('../../../lessons/*.md', { query: '?raw', import: 'default', eager: true });
  for (const [name, text] of Object.entries(files)) expect(await faultsIn(app, readLesson(text)), name).toEqual([]);
});
