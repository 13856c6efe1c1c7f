import { effect, signal, type Signal } from '@preact/signals';
import type { Messages } from '../state/messages.ts';
import type { AppState, Motion, RunState, RunStatistics } from '../types.ts';

/** A motion that stays, beside the one on the stage. */
export interface KeptRun {
  id: number;
  /** As the person calls it. */
  name: string;
  /** Place in the list of curves' colours and dashes. */
  style: number;
  motion: Motion;
  /** Null for files. */
  statistics: RunStatistics | null;
  ending: Extract<RunState, { kind: 'ended' }> | null;
  /** Shown in the plots. */
  visible: boolean;
  /** Shown in the scene. */
  ghost: boolean;
}

/** Numbers that kept runs may hold together, in bytes; and how many there may be, as many as curves can be told apart. */
export const KEPT_BYTES = 256e6;
export const MOST_KEPT = 11;

/** Names are cut here. */
const LONGEST_NAME = 80;

export const bytesOf = ({ trajectory }: Motion): number => 8 * trajectory.columns.length * trajectory.length;

/** Keeps what was on the stage. A run still computing is kept as it goes on. */
export class Kept {
  readonly runs: Signal<readonly KeptRun[]>;
  /** What was removed last, and where it stood. */
  readonly removed: Signal<{ run: KeptRun; place: number } | null> = signal(null);
  private readonly state: AppState;
  private readonly messages: Messages;
  private next = 1;

  constructor(state: AppState, messages: Messages) {
    this.state = state;
    this.messages = messages;
    this.runs = state.kept;
    effect(() => this.follow(state.run.value));
  }

  /** Bytes held. */
  get bytes(): number {
    return this.runs.value.reduce((sum, { motion }) => sum + bytesOf(motion), 0);
  }

  /** Keeps the motion on the stage; says so when there is no room. Its entry, or null. */
  keep(): KeptRun | null {
    const { state } = this;
    const motion = state.motion.peek();
    if (!motion || motion.trajectory.length === 0)
      return this.refuse('There is nothing to keep', 'Run a scenario or open a file first.');
    const runs = this.runs.peek();
    const already = runs.find((r) => r.motion.id === motion.id);
    if (already) return this.refuse('This run is kept already', `It is called “${already.name}”.`);
    if (runs.length >= MOST_KEPT)
      return this.refuse(
        'No more runs can be kept',
        `There are ${MOST_KEPT}, as many as curves can be told apart; remove one first.`,
      );
    const bytes = this.runs.peek().reduce((sum, r) => sum + bytesOf(r.motion), bytesOf(motion));
    if (bytes > KEPT_BYTES)
      return this.refuse(
        'This run is too large to keep',
        `Kept runs would hold ${(bytes / 1e6).toFixed(0)} MB, more than ${KEPT_BYTES / 1e6} MB; remove some, or run with a larger output step.`,
      );
    const run = state.run.peek();
    const kept: KeptRun = {
      id: this.next++,
      name: this.unusedName(motion.title),
      style: this.unusedStyle(),
      motion,
      statistics: motion.source === 'run' ? state.statistics.peek() : null,
      ending: run?.kind === 'ended' && motion.source === 'run' ? run : null,
      visible: true,
      ghost: false,
    };
    this.runs.value = [...runs, kept];
    return kept;
  }

  /** The entry of the motion on the stage, if it is kept. */
  ofStage(): KeptRun | undefined {
    const id = this.state.motion.value?.id;
    return this.runs.value.find((r) => r.motion.id === id);
  }

  change(id: number, change: Partial<Pick<KeptRun, 'name' | 'visible' | 'ghost'>>): void {
    const name = change.name === undefined ? undefined : change.name.trim().slice(0, LONGEST_NAME);
    // An empty name is none.
    const clean = { ...change, ...(name === undefined ? {} : { name }) };
    if (name === '') delete clean.name;
    this.runs.value = this.runs.peek().map((r) => (r.id === id ? { ...r, ...clean } : r));
  }

  remove(id: number): void {
    const runs = this.runs.peek();
    const place = runs.findIndex((r) => r.id === id);
    if (place < 0) return;
    this.removed.value = { run: runs[place]!, place };
    this.runs.value = runs.filter((r) => r.id !== id);
  }

  /** Puts back what was removed last; in another colour when its own is taken. */
  undo(): void {
    const removed = this.removed.peek();
    if (!removed) return;
    const runs = [...this.runs.peek()];
    const style = runs.some((r) => r.style === removed.run.style) ? this.unusedStyle() : removed.run.style;
    runs.splice(removed.place, 0, { ...removed.run, style });
    this.removed.value = null;
    this.runs.value = runs;
  }

  private follow(run: RunState | null): void {
    const motion = this.state.motion.peek();
    const kept = this.runs.peek().find((r) => r.motion.id === motion?.id);
    if (!kept || run?.kind !== 'ended' || kept.ending || motion?.source !== 'run') return;
    const statistics = this.state.statistics.peek();
    this.runs.value = this.runs.peek().map((r) => (r === kept ? { ...r, motion, statistics, ending: run } : r));
  }

  private refuse(title: string, detail: string): null {
    this.messages.add('info', title, [detail]);
    return null;
  }

  private unusedName(title: string): string {
    const names = new Set(this.runs.peek().map((r) => r.name));
    if (!names.has(title)) return title;
    for (let n = 2; ; n++) if (!names.has(`${title} (${n})`)) return `${title} (${n})`;
  }

  private unusedStyle(): number {
    const used = new Set(this.runs.peek().map((r) => r.style));
    for (let n = 0; ; n++) if (!used.has(n)) return n;
  }
}
