// @vitest-environment happy-dom
// A dialog takes the focus, gives it back, and closes by its button, Escape and a press beside it.
import { cleanup, fireEvent, render, screen, waitFor } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { Dialog } from '../../../src/ui/kit/dialog.tsx';

afterEach(cleanup);

function dialog() {
  const before = document.createElement('button');
  document.body.append(before);
  before.focus();
  const onClose = vi.fn<() => void>();
  const { unmount } = render(
    <Dialog title="Time step" testId="dialog" onClose={onClose}>
      <form>
        <input defaultValue="1/60" />
      </form>
    </Dialog>,
  );
  return { before, onClose, unmount, element: screen.getByTestId<HTMLDialogElement>('dialog') };
}

test('the focus goes to the first field, with its text chosen, and comes back', async () => {
  const { before, unmount, element } = dialog();
  const field = screen.getByRole<HTMLInputElement>('textbox');
  expect(element.open).toBe(true);
  expect(document.activeElement).toBe(field);
  expect([field.selectionStart, field.selectionEnd]).toEqual([0, 4]);
  unmount();
  // Preact runs what an effect left behind once the page has been drawn.
  await waitFor(() => expect(document.activeElement).toBe(before));
  before.remove();
});

test('it is named by its title', () => {
  const { element } = dialog();
  expect(document.getElementById(element.getAttribute('aria-labelledby')!)?.textContent).toBe('Time step');
});

test('the button, Escape and a press beside it ask to close; a press inside does not', () => {
  const { element, onClose } = dialog();
  fireEvent.click(screen.getByText('Time step'));
  expect(onClose).toHaveBeenCalledTimes(0);
  fireEvent.click(screen.getByLabelText('Close'));
  fireEvent(element, new Event('cancel', { cancelable: true }));
  fireEvent.click(element);
  expect(onClose).toHaveBeenCalledTimes(3);
});
