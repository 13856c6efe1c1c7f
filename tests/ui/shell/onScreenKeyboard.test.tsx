// @vitest-environment happy-dom
// A keyboard that only covers the page (iOS) is told by the visual viewport, and by nothing else.
import { cleanup, render } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { useOnScreenKeyboard } from '../../../src/ui/shell/onScreenKeyboard.ts';

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

const Page = () => {
  useOnScreenKeyboard();
  return <input />;
};
const root = document.documentElement;

test('the page knows how much of a phone a keyboard leaves, and when it has gone', () => {
  const seen = Object.assign(new EventTarget(), { width: 390, height: 844, offsetTop: 0, scale: 1 });
  vi.stubGlobal('visualViewport', seen);
  render(<Page />);
  expect(root.hasAttribute('data-keyboard')).toBe(false);
  Object.assign(seen, { height: 508, offsetTop: 120 });
  seen.dispatchEvent(new Event('resize'));
  expect(root.hasAttribute('data-keyboard')).toBe(true);
  expect(root.style.getPropertyValue('--seen-height')).toBe('508px');
  expect(root.style.getPropertyValue('--seen-top')).toBe('120px');
  // Enlarged by two fingers: as low, without a keyboard.
  Object.assign(seen, { scale: 1.7 });
  seen.dispatchEvent(new Event('resize'));
  expect(root.hasAttribute('data-keyboard')).toBe(false);
});
