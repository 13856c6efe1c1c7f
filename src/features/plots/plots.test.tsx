// @vitest-environment happy-dom
// Without a motion the plots say how to get one.
import { cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { PlotsTool } from './plotsTool.tsx';
import { text } from './words.ts';

afterEach(cleanup);

test('an empty stage', () => {
  draw(<PlotsTool />);
  expect(screen.getByText(text.empty)).toBeTruthy();
});
