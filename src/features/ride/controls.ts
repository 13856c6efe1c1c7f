/** What keys, pads, a gamepad and a tilt ask for becomes commands: only what has changed is told. */

export type Told = 'twist' | 'lean' | 'pump' | 'push' | 'brake' | 'crouch' | 'hips';

/** Nothing is asked for. */
const REST: Readonly<Record<Told, number>> = { twist: 0, lean: 0, pump: 0, push: 0, brake: 0, crouch: 0, hips: 0 };
/** Of these to both sides. */
const SIDED: readonly Told[] = ['twist', 'lean', 'hips'];
/** For a rider whose legs and hips are free. */
const BODY: readonly Told[] = ['crouch', 'hips'];

/** Keys that are held, and what they ask for. */
const HELD: Readonly<Record<string, readonly [Told, number]>> = {
  ArrowLeft: ['twist', 1],
  ArrowRight: ['twist', -1],
  a: ['lean', 1],
  d: ['lean', -1],
  ArrowUp: ['push', 1],
  w: ['push', 1],
  ' ': ['pump', 1],
  ArrowDown: ['brake', 1],
  s: ['brake', 1],
  c: ['crouch', 1],
  q: ['hips', 1],
  e: ['hips', -1],
};

/** An axis is told in steps of this, so that a hand that trembles says nothing. */
const STEP = 0.05;
/** Of an axis around its rest. */
const DEAD = 0.12;
/** Tilt of a phone that is a whole lean, degrees. */
const TILT = 25;

/** A key event, or a name and perhaps a time (ms) that stand for one. */
interface Key {
  key: string;
  timeStamp?: number;
}

/** What is asked for, and when the hand moved, ms; now without. */
type Tell = (name: Told, value: number, given?: number) => void;

const nameOf = ({ key }: Key): string => (key.length === 1 ? key.toLowerCase() : key);

export class Controls {
  private readonly held = new Set<string>();
  /** Whether legs and hips can be told something. */
  body = false;
  private readonly analog = { ...REST };
  private readonly told = { ...REST };
  /** A gamepad held something a moment ago. */
  private padded = false;
  private readonly tell: Tell;

  constructor(tell: Tell) {
    this.tell = tell;
  }

  /** @returns whether it is a key of the ride */
  press(event: Key): boolean {
    const key = nameOf(event);
    if (!HELD[key] || (!this.body && BODY.includes(HELD[key][0]))) return false;
    this.held.add(key);
    this.update(event.timeStamp);
    return true;
  }

  release(event: Key): boolean {
    if (!this.held.delete(nameOf(event))) return false;
    this.update(event.timeStamp);
    return true;
  }

  releaseAll(): void {
    this.held.clear();
    Object.assign(this.analog, REST);
    this.update();
  }

  /** Nothing of what was told before holds for a ride that begins. */
  forget(): void {
    this.held.clear();
    Object.assign(this.told, REST);
  }

  /** Those that the browser knows of; one that is pulled out lets go. */
  gamepads(pads: readonly (Gamepad | null)[]): void {
    const pad = pads.find((one) => one?.connected);
    if (pad) this.gamepad(pad);
    else if (this.padded) this.gamepad({ axes: [], buttons: [] });
    this.padded = Boolean(pad);
  }

  /** Sticks and triggers, in the standard layout. */
  private gamepad(pad: Pick<Gamepad, 'axes' | 'buttons'>): void {
    const axis = (i: number): number => {
      const x = pad.axes[i] ?? 0;
      return Math.abs(x) < DEAD ? 0 : -x;
    };
    Object.assign(this.analog, {
      twist: axis(0),
      lean: axis(2),
      pump: pad.buttons[7]?.value ?? 0,
      brake: pad.buttons[6]?.value ?? 0,
      push: pad.buttons[0]?.value ?? 0,
      // The right stick pulled down, or the second button; the shoulders' buttons.
      crouch: Math.max(0, -axis(3), pad.buttons[1]?.value ?? 0),
      hips: (pad.buttons[4]?.value ?? 0) - (pad.buttons[5]?.value ?? 0),
    });
    this.update();
  }

  /** @param degrees that the phone is turned to the left in the hand */
  tilt(degrees: number): void {
    this.analog.lean = Math.abs(degrees) < TILT * DEAD ? 0 : degrees / TILT;
    this.update();
  }

  private update(given?: number): void {
    const now = { ...this.analog };
    for (const key of this.held) {
      const [name, value] = HELD[key]!;
      now[name] += value;
    }
    for (const name of Object.keys(now) as Told[]) {
      if (!this.body && BODY.includes(name)) continue;
      const least = SIDED.includes(name) ? -1 : 0;
      const value = Math.max(least, Math.min(1, Math.round(now[name] / STEP) * STEP)) + 0;
      if (value === this.told[name]) continue;
      this.told[name] = value;
      this.tell(name, value, given);
    }
  }
}
