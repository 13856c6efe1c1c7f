/** The experiment being edited: a draft for each system, and what it came from. */
import { batch, computed, signal, type ReadonlySignal } from '@preact/signals';
import { collectScenarioErrors } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import type { CaseInfo } from './cases.ts';
import { createEvent, listenable, readonly, type AppEvent } from './signals.ts';

export interface DraftAndOrigin {
  draft: ScenarioFile;
  origin: CaseInfo;
}

/** One change of the draft, by the words of an undo menu. */
export interface DraftEdit {
  label: string;
  before: DraftAndOrigin;
  after: DraftAndOrigin;
}

export interface ExperimentState {
  draft: ReadonlySignal<ScenarioFile>;
  /** The draft last edited of each system, and what it came from. */
  drafts: ReadonlySignal<ReadonlyMap<string, DraftAndOrigin>>;
  /** What the draft came from; `resetDraft` goes back to it. */
  origin: ReadonlySignal<CaseInfo>;
  /** The error of each draft key that is not right, by path; empty when the draft can run. */
  draftErrors: ReadonlySignal<ReadonlyMap<string, string>>;
}

export interface ExperimentActions {
  /**
   * Changes the draft: the only way there is.
   * @param label what was changed, in words
   * @param change gives a new object, or the same for no change
   */
  edit(label: string, change: (draft: ScenarioFile) => ScenarioFile): void;
  /** Gives what is in the panel a title of its own, which its links carry. */
  rename(title: string): void;
}

export interface ExperimentSlice {
  state: ExperimentState;
  actions: ExperimentActions & {
    /** Another draft takes the panel. */
    replace(label: string, next: DraftAndOrigin): void;
    /** The drafts of all systems, as they were stored. */
    restore(label: string, next: DraftAndOrigin, drafts: ReadonlyMap<string, DraftAndOrigin>): void;
  };
  /** Every change of the draft or its origin, after it. */
  edited: AppEvent<DraftEdit>;
}

/** Characters. */
const LONGEST_TITLE = 80;

export function createExperiment(first: CaseInfo, systems: Readonly<Record<string, SystemMeta>>): ExperimentSlice {
  const current = signal<DraftAndOrigin>({ draft: first.scenario, origin: first });
  const drafts = signal<ReadonlyMap<string, DraftAndOrigin>>(new Map([[first.scenario.system, current.peek()]]));
  const edited = createEvent<DraftEdit>();
  const draft = computed(() => current.value.draft);

  const put = (label: string, after: DraftAndOrigin, others = drafts.peek()): void => {
    const before = current.peek();
    const same = before.draft === after.draft && before.origin === after.origin;
    batch(() => {
      if (!same) current.value = after;
      // What was last edited of each system stays, whatever takes the panel to another one.
      if (after.origin.scenario.system === after.draft.system)
        drafts.value = new Map(others).set(after.draft.system, after);
      else if (others !== drafts.peek()) drafts.value = others;
    });
    if (!same) edited.emit({ label, before, after });
  };

  return {
    state: {
      draft,
      drafts: readonly(drafts),
      origin: computed(() => current.value.origin),
      draftErrors: computed(() => collectScenarioErrors(draft.value, systems)),
    },
    actions: {
      edit(label, change) {
        const { draft: before, origin } = current.peek();
        const after = change(before);
        if (after !== before) put(label, { draft: after, origin });
      },
      rename(typed) {
        const { draft: now, origin } = current.peek();
        const title = typed.trim().slice(0, LONGEST_TITLE);
        if (title !== '' && title !== origin.title) put('title', { draft: now, origin: { ...origin, title } });
      },
      replace: put,
      restore: put,
    },
    edited: listenable(edited),
  };
}
