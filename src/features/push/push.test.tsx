// @vitest-environment happy-dom
// Pushing by keys: force in steps while it is held, released by its button or Escape.
import { cleanup, fireEvent, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { push } from './manifest.tsx';
import { PushPad } from './pushPad.tsx';
import { PushSwitch } from './pushSwitch.tsx';
import { words } from './words.ts';

afterEach(cleanup);

function stage(source: 'run' | 'file' = 'run') {
  const app = testApp();
  putOnStage(app, app.cases.find(({ id }) => id === 'released')!.scenario, source);
  return app;
}

test('presses add up, in words; Escape releases', () => {
  draw(<PushPad />, { app: stage(), features: [push] });
  const force = () => screen.getByTestId('push-force').textContent;
  expect(force()).toBe(words.nothing);
  fireEvent.click(screen.getByTestId('push-ahead'));
  const once = parseFloat(/: ([\d.]+)/.exec(force()!)![1]!);
  fireEvent.keyDown(screen.getByTestId('push-pad'), { key: 'ArrowUp' });
  expect(parseFloat(/: ([\d.]+)/.exec(force()!)![1]!)).toBeCloseTo(2 * once, 6);
  expect(force()).toContain(words.towards[0][0]);
  fireEvent.keyDown(screen.getByTestId('push-ahead'), { key: 'Escape' });
  expect(force()).toBe(words.nothing);
});

test('the switch is there for a run, and not for a file', () => {
  const app = stage();
  draw(<PushSwitch />, { app, features: [push] });
  fireEvent.click(screen.getByTestId('toggle-push'));
  expect(screen.getByTestId('toggle-push').getAttribute('aria-pressed')).toBe('true');
  cleanup();
  draw(<PushSwitch />, { app: stage('file'), features: [push] });
  expect(screen.queryByTestId('toggle-push')).toBeNull();
});
