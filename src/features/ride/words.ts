/** Every word of riding that is not in the first view. */
import type { Kind } from './rides.ts';
import { formatShort } from '../../ui/kit/format.ts';

const KINDS: Readonly<Record<Kind, string>> = {
  board: 'the board alone',
  rider: 'with a rider',
  body: 'with a rider, legs and hips too',
};

export const words = {
  label: 'Riding',
  title: (kind: Kind) => (kind === 'board' ? 'Ride of the board alone' : 'Ride with a rider'),
  ready: 'The board is being made ready …',
  there: 'A ride is on the stage: go to any moment of it and ride on from there, or ride again.',
  begin: 'Push off with ↑, steer with ← and →.',
  beginByTouch: 'Hold Push to start, steer with Left and Right.',
  keys: (kind: Kind) =>
    `↑ push off · Space pump · ← → turn · A D lean · ↓ brake · ${kind === 'body' ? 'C crouch · Q E hips · ' : ''}R again · P wait · Esc leave`,
  again: 'Again',
  leave: 'Leave',
  wait: 'Wait',
  goOn: 'Go on',
  takeOver: 'Ride on from here',
  takeOverTitle: 'From the moment that is shown, the ride is yours again',
  rider: 'With a rider',
  free: 'Legs and hips too',
  freeHint: 'Crouch, and turn hips and shoulders against the feet; they go ahead into a turn by themselves.',
  choices: (help: string, pace: string, kind: Kind, coarse: boolean) =>
    `Help: ${help.toLowerCase()} · clock: ${pace} · ${KINDS[kind]}${coarse ? ' · drawn coarser' : ''}`,
  marks: (count: number) => (count === 1 ? 'One command' : `${count} commands`),
  mark: (name: string, value: number, time: number) => {
    const much = value === 1 ? '' : ` ${formatShort(value)}`;
    return `${name}${much} at ${time.toFixed(2)} s`.replace(' -', ' \u2212');
  },
  help: 'Help',
  helpLevels: { 1: 'Full', 0.75: 'Some', 0: 'None' } as Readonly<Record<number, string>>,
  helpHint: {
    1: 'Keys say where to go; the layer beneath finds the torques of the feet, and puts a foot down when it is slow.',
    0.75: 'Three quarters of what the layer would do, a quarter of your keys as bare torque.',
    0: 'Your keys are the torques of the feet. Nothing else holds the board up.',
  } as Readonly<Record<number, string>>,
  pace: 'Clock',
  paces: { 1: '1', 0.5: '½', 0.25: '¼' } as Readonly<Record<number, string>>,
  pads: {
    left: 'Left',
    right: 'Right',
    push: 'Push',
    pump: 'Pump',
    brake: 'Brake',
    crouch: 'Crouch',
    hipsLeft: 'Hips left',
    hipsRight: 'Hips right',
  },
  tilt: 'Tilt to lean',
  noTilt: 'This device tells no tilt, or was not allowed to.',
  // No minus before a zero.
  speed: (v: number) => `${(Math.round(10 * v) / 10 + 0).toFixed(1)} m/s`.replace('-', '\u2212'),
  seconds: (t: number) => `${t.toFixed(1)} s`,
  course: 'Course',
  gate: (passed: number, all: number) => `gate ${passed} of ${all}`,
  ghost: 'best',
  best: (t: number) => `best ${t.toFixed(2)} s`,
  through: 'Through all gates',
  finished: (t: number, best: boolean) => `Through all gates in ${t.toFixed(2)} s${best ? ', your best yet' : ''}.`,
  fell: (side: 'left' | 'right' | null, degrees: number, time: number) =>
    `You fell${side ? ` to the ${side}, ${degrees.toFixed(0)}° over` : ''} after ${time.toFixed(1)} s: a plate touched the ground.`,
  lost: (message: string) => `The ride ended: ${message}`,
  kept: 'The ride is a run now: play it, plot it, save it, share it.',
  coarse: 'Drawn coarser for as long as you ride, so that keys are seen at once.',
  latency: (ms: number, dropped: number, frames: number) =>
    `from key to picture ${formatShort(Math.round(ms))} ms, ${dropped} of ${frames} frames dropped`,
};
