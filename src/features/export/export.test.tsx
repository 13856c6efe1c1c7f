// @vitest-environment happy-dom
// What can leave the page: without a motion nothing is offered that would be empty; data always goes.
import { cleanup, fireEvent, screen, waitFor } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { ExportDialog } from './exportDialog.tsx';
import { ExportMenu } from './exportMenu.tsx';
import { exporting } from './manifest.tsx';
import { words } from './words.ts';

afterEach(cleanup);

test('the menu offers the run only when there is one', () => {
  const app = testApp();
  const save = vi.spyOn(app.actions, 'saveScenario').mockImplementation(() => {});
  draw(<ExportMenu />, { app, features: [exporting] });
  fireEvent.click(screen.getByTestId('export-menu'));
  expect(screen.getByTestId<HTMLButtonElement>('export-csv').disabled).toBe(true);
  fireEvent.click(screen.getByTestId('export-scenario'));
  expect(save).toHaveBeenCalledTimes(1);
});

test('the dialog says why there is no picture, and still saves data', () => {
  const app = testApp();
  draw(<ExportDialog />, { app, features: [exporting] });
  expect(screen.getByTestId('export-trouble').textContent).toBe(words.noMotion);
  cleanup();
  putOnStage(app, app.cases.find(({ id }) => id === 'released')!.scenario);
  draw(<ExportDialog />, { app, features: [exporting] });
  expect(screen.getByTestId('export-trouble').textContent).toBe(words.noScene);
  fireEvent.click(screen.getByTestId('export-tab-data'));
  expect(screen.getByTestId<HTMLButtonElement>('save-csv').disabled).toBe(false);
});

test('the system goes to other tools, with what they cannot say, or with the reason why not', async () => {
  const app = testApp();
  const saved = vi.spyOn(URL, 'createObjectURL').mockReturnValue('blob:nothing');
  draw(<ExportDialog />, { app, features: [exporting] });
  fireEvent.click(screen.getByTestId('export-tab-data'));
  const asked = vi.spyOn(app.mechanics, 'export');
  asked.mockResolvedValueOnce({ ok: true, value: { name: 'board.xml', text: '<mujoco/>', notes: ['No skates.'] } });
  fireEvent.click(screen.getByTestId('save-mjcf'));
  await waitFor(() => expect(screen.getByTestId('exchange-told').textContent).toBe('Saved board.xml.No skates.'));
  expect(asked.mock.calls[0]![0].system).toBe(app.state.draft.peek().system);
  expect(saved).toHaveBeenCalledTimes(1);
  asked.mockResolvedValueOnce({ ok: false, path: 'system', message: 'no tree' });
  fireEvent.click(screen.getByTestId('save-mjcf'));
  await waitFor(() => expect(screen.getByTestId('exchange-told').textContent).toContain('Nothing was saved. no tree'));
  expect(saved).toHaveBeenCalledTimes(1);
});
