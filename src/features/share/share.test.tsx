// @vitest-environment happy-dom
// The link is copied, or shown for the person to copy where the browser does not let the page.
import { cleanup, fireEvent, screen, waitFor } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { ShareButton } from './share.tsx';
import { words } from './words.ts';

afterEach(() => {
  cleanup();
  vi.restoreAllMocks();
});

const clipboard = (write: (text: string) => Promise<void>) =>
  vi.spyOn(navigator.clipboard, 'writeText').mockImplementation(write);

test('what is copied is a link to the draft, and it is said', async () => {
  const write = clipboard(() => Promise.resolve());
  const app = testApp();
  draw(<ShareButton />, { app });
  fireEvent.click(screen.getByTestId('share'));
  await waitFor(() => expect(app.state.messages.value.map(({ title }) => title)).toEqual([words.copied]));
  expect(write.mock.calls[0]![0]).toMatch(/#v=1&/);
});

test('a clipboard that is closed leaves a field with the link', async () => {
  clipboard(() => Promise.reject(new Error('denied')));
  draw(<ShareButton />);
  fireEvent.click(screen.getByTestId('share'));
  const field = await screen.findByTestId<HTMLInputElement>('share-link');
  expect(field.value).toMatch(/#v=1&/);
  await waitFor(() => expect(document.activeElement).toBe(field));
});
