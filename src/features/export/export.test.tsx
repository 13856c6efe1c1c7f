// @vitest-environment happy-dom
// What can leave the page: without a motion nothing is offered that would be empty; data always goes.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
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
