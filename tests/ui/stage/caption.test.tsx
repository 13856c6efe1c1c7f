// @vitest-environment happy-dom
// The caption claims of a case only what is still the case; what was changed stands in its place.
import { act, cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { Caption } from '../../../src/ui/stage/caption.tsx';
import { withEntry } from '../../../src/app/state/draft.ts';
import { draw, putOnStage, testApp } from '../page.tsx';

afterEach(cleanup);

const first = (app: ReturnType<typeof testApp>) => app.state.origin.value;

test('an edited case loses its claim and says what is not as in it; undone, it has it again', async () => {
  const app = testApp();
  const { title, summary } = first(app);
  app.actions.run();
  draw(<Caption />, { app });
  expect(screen.getByText(summary)).toBeTruthy();
  void act(() => {
    app.actions.edit('gravity', (draft) => withEntry(draft, 'parameters', 'gravity', 1.62));
    app.actions.edit('roll', (draft) => withEntry(draft, 'initial', 'alpha', '5 deg'));
    app.actions.run();
  });
  expect(screen.getByText(`${title}, changed`)).toBeTruthy();
  expect(screen.queryByText(summary)).toBeNull();
  expect((await screen.findByTestId('caption-changes')).textContent).toMatch(/rod roll 5°; gravity.* 1\.62/);
  void act(() => app.actions.goToEdit(0));
  void act(() => app.actions.run());
  expect(screen.getByText(summary)).toBeTruthy();
});

test('a file is called by its own name, whatever stands in the panel', () => {
  const app = testApp();
  putOnStage(app, first(app).scenario, 'file');
  draw(<Caption />, { app });
  expect(screen.getByText('A motion')).toBeTruthy();
  expect(screen.queryByText(first(app).summary)).toBeNull();
});

test('a title of one’s own is what is shown, and an undo takes it back', () => {
  const app = testApp();
  const { title } = first(app);
  app.actions.run();
  draw(<Caption />, { app });
  void act(() => app.actions.rename('  My ride '));
  expect(screen.getByText('My ride')).toBeTruthy();
  void act(() => app.actions.undo());
  expect(screen.getByText(title)).toBeTruthy();
});
