// @vitest-environment happy-dom
// A part that does not come: without a connection it says so; after an update it says that, and offers to reload.
import { cleanup, render, screen, waitFor } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { later } from '../../../src/ui/kit/later.tsx';
import { words } from '../../../src/ui/kit/words.ts';

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
  document.head.replaceChildren();
});

const Missing = later(() => Promise.reject(new TypeError('Failed to fetch dynamically imported module')));

function withEntry(): void {
  // Put in as text, it is not run.
  document.head.innerHTML = '<script type="module" src="./assets/index-old.js"></script>';
}

test.each([
  ['the server has another build', './assets/index-new.js', words.outdated],
  ['the server has this build', './assets/index-old.js', words.failed],
])('%s', async (_, src, said) => {
  withEntry();
  vi.stubGlobal('fetch', () => Promise.resolve(new Response(`<script type="module" src="${src}"></script>`)));
  render(<Missing />);
  await waitFor(() => expect(screen.getByRole('alert').textContent).toContain(said));
  expect(screen.queryByTestId('reload') !== null).toBe(said === words.outdated);
});

test('no connection', async () => {
  withEntry();
  vi.stubGlobal('fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  render(<Missing />);
  await waitFor(() => expect(screen.getByRole('alert').textContent).toBe(words.failed));
});
