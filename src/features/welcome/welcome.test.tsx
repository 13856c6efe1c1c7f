// @vitest-environment happy-dom
// The tour goes on and back, names its steps, and ends by its button or Escape.
import { act, cleanup, fireEvent, render, screen } from '@testing-library/preact';
import { afterEach, expect, test, vi } from 'vitest';
import { draw, putOnStage, testApp } from '../../../tests/ui/page.tsx';
import { WelcomeView } from './offer.tsx';
import { steps } from './steps.ts';
import { Tour } from './tour.tsx';
import { Welcome } from './welcome.tsx';
import { text } from './words.ts';

afterEach(cleanup);

test('forward and back through all steps, and done', () => {
  const onEnd = vi.fn<() => void>();
  render(<Tour onEnd={onEnd} />);
  const heading = () => screen.getByRole('heading').textContent;
  expect(heading()).toBe(text.steps[steps[0]!.id].title);
  for (const step of steps.slice(1)) {
    fireEvent.click(screen.getByTestId('tour-next'));
    expect(heading()).toBe(text.steps[step.id].title);
  }
  expect(screen.getByTestId('tour').textContent).toContain(text.of(steps.length, steps.length));
  fireEvent.click(screen.getByTestId('tour-back'));
  expect(heading()).toBe(text.steps[steps.at(-2)!.id].title);
  fireEvent.click(screen.getByTestId('tour-next'));
  fireEvent.click(screen.getByTestId('tour-next'));
  expect(onEnd).toHaveBeenCalledTimes(1);
});

test('Escape ends it at any step', () => {
  const onEnd = vi.fn<() => void>();
  render(<Tour onEnd={onEnd} />);
  fireEvent.click(screen.getByTestId('tour-next'));
  fireEvent.keyDown(window, { key: 'Escape' });
  expect(onEnd).toHaveBeenCalledTimes(1);
});

test('the offer: one thing to try is a case that there is', () => {
  const app = testApp();
  const load = vi.spyOn(app.actions, 'loadCase').mockImplementation(() => {});
  const onEnd = vi.fn<() => void>();
  draw(<WelcomeView touring={false} onTour={() => {}} onEnd={onEnd} />, { app });
  fireEvent.click(screen.getByTestId('offer-try'));
  expect(onEnd).toHaveBeenCalledTimes(1);
  expect(app.cases.map(({ id }) => id)).toContain(load.mock.calls[0]![0]);
});

test('the offer stands over a run, not over a file that was opened', async () => {
  const app = testApp();
  const scenario = { version: 1, system: 'rolling-wheel', duration: 0.1 } as const;
  putOnStage(app, scenario);
  draw(<Welcome />, { app });
  expect(await screen.findByTestId('offer')).toBeTruthy();
  void act(() => void putOnStage(app, scenario, 'file'));
  expect(screen.queryByTestId('offer')).toBeNull();
  void act(() => void putOnStage(app, scenario));
  expect(screen.queryByTestId('offer')).toBeTruthy();
});
