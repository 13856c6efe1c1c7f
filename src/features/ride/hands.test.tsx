// @vitest-environment happy-dom
// What hands do becomes commands: thumbs on pads, a gamepad, a phone that is tilted, if it may tell.
import { cleanup, fireEvent, screen, waitFor } from '@testing-library/preact';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { draw, testApp } from '../../../tests/ui/page.tsx';
import { ride } from './manifest.tsx';
import { storeBest } from './rides.ts';
import { RideView } from './rideView.tsx';
import { words } from './words.ts';

/** Whether a phone that asks is allowed to tell its tilt. */
let allowed = 'granted';

beforeEach(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  HTMLElement.prototype.setPointerCapture = () => {};
  vi.stubGlobal(
    'DeviceOrientationEvent',
    class extends Event {
      static requestPermission = () => Promise.resolve(allowed);
    },
  );
});
afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
  localStorage.clear();
});

/** The view, and every command that it tells. */
function riding() {
  const app = testApp();
  const told: (readonly [string, number])[] = [];
  vi.spyOn(app.actions, 'steer').mockImplementation(({ command }) => {
    if (command) told.push([command[0], command[1]]);
  });
  draw(<RideView onLeave={() => {}} />, { app, features: [ride] });
  return { app, told };
}

const tilted = (gamma: number): Event => Object.assign(new Event('deviceorientation'), { beta: 0, gamma });

test('a pad is held as a key is', () => {
  const { told } = riding();
  fireEvent.pointerDown(screen.getByTestId('ride-push'));
  fireEvent.pointerUp(screen.getByTestId('ride-push'));
  expect(told).toEqual([
    ['push', 1],
    ['push', 0],
  ]);
});

test('legs and hips have pads once they are free, and the ride begins again with them', () => {
  const { app, told } = riding();
  expect(screen.queryByTestId('ride-crouch')).toBeNull();
  fireEvent.click(screen.getByTestId('ride-free'));
  expect(app.state.draft.peek().release).toEqual(['crouch', 'twist']);
  fireEvent.pointerDown(screen.getByTestId('ride-crouch'));
  fireEvent.pointerUp(screen.getByTestId('ride-crouch'));
  fireEvent.pointerDown(screen.getByTestId('ride-hipsRight'));
  expect(told).toEqual([
    ['crouch', 1],
    ['crouch', 0],
    ['hips', -1],
  ]);
});

test('a rider of a height and a mass has the body that goes with them', () => {
  const { app } = riding();
  fireEvent.change(screen.getByTestId('ride-mass'), { target: { value: '60' } });
  expect(app.state.draft.peek().parameters).toMatchObject({ riderMass: 60 });
  fireEvent.change(screen.getByTestId('ride-mass'), { target: { value: '' } });
  expect(app.state.draft.peek().parameters).not.toHaveProperty('riderMass');
});

test('a gamepad is asked with every picture', async () => {
  const pads = [{ connected: true, axes: [-0.5, 0, 0], buttons: [] }];
  vi.stubGlobal('navigator', Object.assign(Object.create(navigator), { getGamepads: () => pads }));
  const { told } = riding();
  await waitFor(() => expect(told).toEqual([['twist', 0.5]]));
  pads.length = 0;
  await waitFor(() => expect(told.at(-1)).toEqual(['twist', 0]));
});

test('a tilt leans, once the phone may tell it', async () => {
  const { told } = riding();
  allowed = 'denied';
  fireEvent.click(screen.getByTestId('ride-tilt'));
  await waitFor(() => expect(screen.getByTestId('ride-said').textContent).toBe(words.noTilt));
  window.dispatchEvent(tilted(-12.5));
  expect(told).toEqual([]);
  allowed = 'granted';
  fireEvent.click(screen.getByTestId('ride-tilt'));
  await waitFor(() => {
    window.dispatchEvent(tilted(-12.5));
    expect(told.length).toBe(1);
  });
  window.dispatchEvent(tilted(30));
  fireEvent.click(screen.getByTestId('ride-tilt'));
  await waitFor(() => expect(told.length).toBe(3));
  expect(told).toEqual([
    ['lean', 0.5],
    ['lean', -1],
    ['lean', 0],
  ]);
});

test('gates stand on the stage while one rides, with the best time of this browser', async () => {
  storeBest('rider', { time: 12.34, columns: ['t', 'X', 'Y'], values: [[0], [0], [0]] });
  const { app } = riding();
  expect(app.state.gates.peek().map(({ state }) => state)).toEqual(['next', 'ahead', 'ahead', 'ahead']);
  expect(screen.getByTestId('ride-view').textContent).toContain(words.best(12.34));
  cleanup();
  await waitFor(() => expect(app.state.gates.peek()).toEqual([]));
});
