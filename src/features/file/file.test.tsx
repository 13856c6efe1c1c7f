// @vitest-environment happy-dom
// Files come by the button or are dropped anywhere.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { DropOverlay } from './dropOverlay.tsx';
import { OpenButtons } from './openButtons.tsx';
import { words } from './words.ts';

afterEach(cleanup);

test('the button takes several files, and is ready for the same one again', () => {
  const app = testApp();
  const open = vi.spyOn(app.actions, 'openFiles').mockImplementation(() => {});
  draw(<OpenButtons />, { app });
  const input = screen.getByTestId<HTMLInputElement>('open-file');
  const files = [new File(['t,X'], 'a.csv'), new File(['t,X'], 'b.csv')];
  Object.defineProperty(input, 'files', { value: files, configurable: true });
  fireEvent.change(input);
  expect(open.mock.calls[0]![0].map(({ name }) => name)).toEqual(['a.csv', 'b.csv']);
  expect(screen.getByTestId('sample-menu')).toBeTruthy();
});

test('over the page a file is welcome, and taken where it is dropped; a piece of text is not', () => {
  const app = testApp();
  const open = vi.spyOn(app.actions, 'openFiles').mockImplementation(() => {});
  draw(<DropOverlay />, { app });
  const drag = (type: string, types: string[], files: File[] = []) => {
    const event = new Event(type, { bubbles: true, cancelable: true });
    fireEvent(window, Object.assign(event, { dataTransfer: { types, files } }));
    return event.defaultPrevented;
  };
  expect(drag('dragenter', ['text/plain'])).toBe(false);
  expect(screen.queryByTestId('drop')).toBeNull();
  expect(drag('dragenter', ['Files'])).toBe(true);
  expect(screen.getByTestId('drop').textContent).toBe(words.drop);
  drag('dragenter', ['Files']);
  drag('dragleave', ['Files']);
  expect(screen.getByTestId('drop')).toBeTruthy();
  drag('drop', ['Files'], [new File([''], 'run.csv')]);
  expect(screen.queryByTestId('drop')).toBeNull();
  expect(open).toHaveBeenCalledTimes(1);
});
