/** Pads for thumbs, the tilt of a phone, and choices of a few values. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Session } from './session.ts';
import { words } from './words.ts';

const PADS = { left: 'ArrowLeft', right: 'ArrowRight', push: 'ArrowUp', pump: ' ', brake: 'ArrowDown' } as const;
/** Of a rider whose legs and hips move too. */
const BODY = { crouch: 'c', hipsLeft: 'q', hipsRight: 'e' } as const;

/** A pad is its key, held. */
export function Pads({ session }: { session: Session }) {
  return (
    <div class="ride-pads">
      {Object.entries({ ...PADS, ...(session.kind === 'body' ? BODY : {}) }).map(([pad, key]) => {
        const release = ({ timeStamp }: Event): void => void session.controls.release({ key, timeStamp });
        return (
          <button
            key={pad}
            type="button"
            data-testid={`ride-${pad}`}
            disabled={session.phase === 'over'}
            onPointerDown={(event) => {
              event.currentTarget.setPointerCapture(event.pointerId);
              session.controls.press({ key, timeStamp: event.timeStamp });
            }}
            onPointerUp={release}
            onPointerCancel={release}
            onContextMenu={(event) => event.preventDefault()}
          >
            {words.pads[pad as keyof typeof words.pads]}
          </button>
        );
      })}
      <Tilt session={session} />
    </div>
  );
}

/** Some phones ask the person first. */
type Asking = typeof DeviceOrientationEvent & { requestPermission?(): Promise<string> };

/** Turned like a wheel: about the axis that looks out of the screen towards the face, whichever way the phone is held. */
function degreesOf({ beta, gamma }: DeviceOrientationEvent): number {
  const angle = screen.orientation?.angle ?? 0;
  const turned = angle === 90 ? beta : angle === 270 ? -(beta ?? 0) : angle === 180 ? -(gamma ?? 0) : gamma;
  return -(turned ?? 0);
}

function Tilt({ session }: { session: Session }) {
  const on = useSignal(false);
  useEffect(() => {
    if (!on.value) return;
    const hear = (event: DeviceOrientationEvent): void => session.controls.tilt(degreesOf(event));
    window.addEventListener('deviceorientation', hear);
    return () => {
      window.removeEventListener('deviceorientation', hear);
      session.controls.tilt(0);
    };
  }, [on.value]);
  if (typeof DeviceOrientationEvent === 'undefined' || !matchMedia('(pointer: coarse)').matches) return null;
  const ask = async (): Promise<void> => {
    const asking = DeviceOrientationEvent as Asking;
    const allowed = (await asking.requestPermission?.().catch(() => 'denied')) ?? 'granted';
    if (allowed !== 'granted') session.say(words.noTilt);
    else on.value = !on.value;
  };
  return (
    <button type="button" aria-pressed={on.value} data-testid="ride-tilt" onClick={() => void ask()}>
      {words.tilt}
    </button>
  );
}

interface ChoiceProps {
  label: string;
  options: Readonly<Record<number, string>>;
  value: number;
  testId: string;
  onChange(value: number): void;
}

export function Choice({ label, options, value, testId, onChange }: ChoiceProps) {
  const values = Object.keys(options)
    .map(Number)
    .sort((a, b) => b - a);
  return (
    <div class="segments" role="group" aria-label={label}>
      <span class="ride-label">{label}</span>
      {values.map((one) => (
        <button
          key={one}
          type="button"
          class="toggle"
          aria-pressed={one === value}
          data-testid={`${testId}-${one}`}
          onClick={() => onChange(one)}
        >
          {options[one]}
        </button>
      ))}
    </div>
  );
}
