/** One person on the board: begins rides, tells them what the controls ask, follows them picture by picture. */
import type { App } from '../../app/app.ts';
import { UNRECORDED, type Motion } from '../../app/runs/motion.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { riderOf, type Person } from '../../core/systems/ripstik-rider/person.ts';
import { Controls } from './controls.ts';
import { gates, HALF_WIDTH, Passage } from './course.ts';
import { Measure } from './measure.ts';
import { bestOf, ghostAt, rideScenario, rowsOf, storeBest, storedBest, upTo, type Best, type Kind } from './rides.ts';
import { words } from './words.ts';

type Phase = 'starting' | 'riding' | 'over';

const DEGREES = 180 / Math.PI;
/** The panel's numbers and the map are drawn this often, ms, and half as often where that is felt; the scene with every picture. */
const DRAW_MS = 100;

export class Session {
  phase: Phase = 'starting';
  said: string = words.ready;
  rider = true;
  /** Whether the rider's legs and hips move too. */
  free = false;
  /** Who rides; the system's own rider without. */
  person: Person | null = null;
  level = 1;
  pace = 1;
  waiting = false;
  speed = 0;
  time = 0;
  way: number[] = [];
  best: Best | null = null;
  passage = new Passage(gates);
  measure = new Measure();
  readonly controls: Controls;
  private readonly app: App;
  private draw = (): void => {};
  private drawn = 0;
  /** Rows of the motion that were followed. */
  private rows = 0;
  private motion = 0;
  /** Counts rides: what an earlier one still says is not heard. */
  private ride = 0;
  /** What is said to it is heard once the picture has been drawn. */
  private readonly painted = new MessageChannel();

  constructor(app: App) {
    this.app = app;
    this.controls = new Controls((name, value, given) => this.tell(name, value, given));
    this.painted.port1.onmessage = ({ data: [ride, time] }: MessageEvent<[number, number]>) => {
      if (ride === this.ride) this.measure.shown(performance.now(), time);
    };
  }

  /** Rides until what it returns is called. */
  run(draw: () => void): () => void {
    this.draw = draw;
    const { state, actions } = this.app;
    const view = state.view.peek();
    if (!this.goOn()) this.begin();
    let frame = requestAnimationFrame(function next(this: void, now: number) {
      follow(now);
      frame = requestAnimationFrame(next);
    });
    const follow = (now: number): void => this.frame(now);
    return () => {
      cancelAnimationFrame(frame);
      this.painted.port1.close();
      this.ride++;
      if (this.phase !== 'over') actions.cancel();
      actions.setGates([]);
      actions.setCompanion(null);
      if (state.view.peek() === 'rider') actions.set('view', view);
      if (state.motion.peek()?.written?.control?.type === 'ride') actions.report('info', words.label, [words.kept]);
    };
  }

  /** A ride that is on the stage is not thrown away: it is ridden on, from where one likes, or begun again. */
  private goOn(): boolean {
    const { motion, run } = this.app.state;
    const { written: file, system } = motion.peek() ?? {};
    if (!system || file?.control?.type !== 'ride' || run.peek()?.kind === 'computing') return false;
    // Whoever rides is a body of the system where a gait has it held upright.
    this.rider = (system.meta.gait?.hold ?? []).length > 0;
    this.free = (file.release ?? []).length > 0;
    this.best = storedBest(this.kind);
    this.phase = 'over';
    this.said = words.there;
    this.showGates();
    this.draw();
    return true;
  }

  begin(): void {
    this.best = storedBest(this.kind);
    const body = this.person ? riderOf(this.person) : {};
    this.start(rideScenario(this.rider, this.level, [], body, this.free), 0);
  }

  /** Goes on from the moment on the stage: the ride up to there is computed again, which gives the same. */
  takeOver(): void {
    const { state } = this.app;
    const time = state.time.peek();
    const file = upTo(state.motion.peek()?.written, time);
    if (file) this.start(file, time);
  }

  private start(file: ScenarioFile, resume: number): void {
    const { actions, state } = this.app;
    const ride = ++this.ride;
    this.controls.forget();
    this.controls.body = (file.release ?? []).length > 0;
    this.passage = new Passage(gates);
    this.measure = new Measure();
    Object.assign(this, { rows: 0, way: [], waiting: false, speed: 0, time: resume });
    this.phase = 'starting';
    this.said = words.ready;
    this.motion = state.motion.peek()?.id ?? 0;
    this.showGates();
    actions.ride(file, {
      title: words.title(this.kind),
      resume,
      pace: this.pace,
      told: (command, given) => {
        if (ride === this.ride) this.measure.told(given, command[0]);
      },
      over: (end) => {
        if (ride === this.ride) this.end(end);
      },
    });
    // Helped as it is chosen now, whatever held before.
    if (resume > 0) actions.steer({ command: ['help', this.level, performance.now()] });
    this.draw();
  }

  setHelp(level: number): void {
    this.level = level;
    if (this.phase !== 'over') this.tell('help', level);
    this.draw();
  }

  setPace(pace: number): void {
    this.pace = pace;
    if (!this.waiting) this.app.actions.steer({ pace });
    this.draw();
  }

  setWaiting(waiting: boolean): void {
    this.waiting = waiting;
    this.app.actions.steer({ pace: waiting ? 0 : this.pace });
    this.draw();
  }

  get kind(): Kind {
    return !this.rider ? 'board' : this.free ? 'body' : 'rider';
  }

  setFree(free: boolean): void {
    this.free = free;
    this.begin();
  }

  setPerson(person: Person | null): void {
    this.person = person;
    this.begin();
  }

  setRider(rider: boolean): void {
    this.rider = rider;
    this.begin();
  }

  say(words: string): void {
    this.said = words;
    this.draw();
  }

  /** Where the best ride was at this time. */
  ghost(): { x: number; y: number } | null {
    return this.best && ghostAt(this.best, this.time);
  }

  private tell(name: string, value: number, given = performance.now()): void {
    if (this.phase === 'over') return;
    this.app.actions.steer({ command: [name, value, given] });
  }

  private frame(now: number): void {
    if (this.phase === 'over') return;
    const { state, actions } = this.app;
    actions.steer({ ready: true });
    this.controls.gamepads(navigator.getGamepads?.() ?? []);
    const motion = state.motion.peek();
    if (!motion || motion.written?.control?.type !== 'ride' || state.run.peek()?.kind !== 'computing') return;
    if (this.phase === 'starting') {
      if (motion.id === this.motion) return;
      this.motion = motion.id;
      this.phase = 'riding';
      this.said = matchMedia('(pointer: coarse)').matches ? words.beginByTouch : words.begin;
      actions.setCompanion(this.best && companionOf(motion, this.best));
      actions.set('view', motion.system.meta.views?.ridden ? 'rider' : state.view.peek());
    }
    // Something else took the stage.
    if (motion.id !== this.motion) return void (this.phase = 'over');
    this.look();
    this.measure.frame(now);
    this.painted.port2.postMessage([this.ride, this.time]);
    if (now - this.drawn < (state.coarse.peek() ? 2 : 1) * DRAW_MS) return;
    this.drawn = now;
    this.draw();
  }

  private showGates(): void {
    const { passed } = this.passage;
    this.app.actions.setGates(
      gates.map((gate, i) => ({
        ...gate,
        half: HALF_WIDTH,
        state: i < passed ? 'done' : i === passed ? 'next' : 'ahead',
      })),
    );
  }

  /** Takes up the rows that came. */
  private look(): void {
    const { trajectory } = this.app.state.motion.peek()!;
    const [t, x, y, heading, vx, vy] = ['t', 'X', 'Y', 'theta', 'X_dot', 'Y_dot'].map((c) => trajectory.column(c)!);
    if (trajectory.length === 0) return;
    const { passed } = this.passage;
    for (; this.rows < trajectory.length; this.rows++) {
      const i = this.rows;
      this.passage.at(t![i]!, x![i]!, y![i]!);
      if (i % 10 === 0) this.way.push(x![i]!, y![i]!);
    }
    if (this.passage.passed !== passed) this.showGates();
    const last = trajectory.length - 1;
    this.time = t![last]!;
    this.speed = vx![last]! * Math.cos(heading![last]!) + vy![last]! * Math.sin(heading![last]!);
    const { finished } = this.passage;
    if (finished === null || this.said.startsWith(words.through)) return;
    const best = !this.best || finished < this.best.time;
    this.said = words.finished(finished, best);
    if (!best) return;
    const names = this.app.state.motion.peek()!.system.meta.coordinates.map(({ name }) => name);
    this.best = bestOf(trajectory, names, finished);
    storeBest(this.kind, this.best);
  }

  private end(end: { reason: string; message: string; time: number }): void {
    const { state, actions } = this.app;
    this.phase = 'over';
    actions.pause();
    const beta = state.motion.peek()?.trajectory.column('beta');
    const lean = beta?.[(state.motion.peek()?.trajectory.length ?? 1) - 1] ?? 0;
    const side = beta ? (lean > 0 ? 'right' : 'left') : null;
    if (end.reason === 'touchdown') this.said = words.fell(side, Math.abs(lean) * DEGREES, end.time);
    else if (end.reason !== 'cancelled') this.said = words.lost(end.message);
    const { latency, dropped, frames } = this.measure;
    if (latency !== null) this.said += ` (${words.latency(latency, dropped, frames)})`;
    this.draw();
  }
}

/** The best ride beside the one that begins, in the same bodies. */
const companionOf = ({ system, parameters }: Motion, best: Best): Motion => ({
  id: -1,
  source: 'run',
  title: words.ghost,
  system,
  parameters,
  trajectory: rowsOf(best),
  ...UNRECORDED,
});
