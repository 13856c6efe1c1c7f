/** What every part of the page shares, so that components need no long lists of props. */
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import { computed, signal } from '@preact/signals';
import type { ReadonlySignal, Signal } from '@preact/signals';
import type { App } from '../app/app.ts';
import type { CaseInfo } from '../app/state/cases.ts';
import type { ScenarioFile } from '../core/scenario/types.ts';
import type { SystemView } from '../core/model/system.ts';
import { sameContent } from '../app/state/draft.ts';
import { labelOf, titleOf, type Command } from '../app/commands.ts';
import type { Feature, Tool } from './feature.ts';

export interface MethodChoice {
  id: string;
  label: string;
  /** False for fixed-step methods: the tolerances then have no meaning. */
  adaptive?: boolean;
}

export interface FormulationChoice {
  id: string;
  label: string;
}

export interface Ui {
  app: App;
  methods: readonly MethodChoice[];
  formulations: readonly FormulationChoice[];
  features: readonly Feature[];
  /** The places to work in beside the scene, each under its feature's id. */
  tools: readonly (Tool & { id: string })[];
  /** All that can be asked for by button, menu or key. */
  commands: readonly Command[];
  /** The case the draft came from; fields are compared with it. */
  origin: ReadonlySignal<CaseInfo | null>;
  /** Rises when the draft is replaced as a whole: fields then forget rejected text. */
  epoch: Signal<number>;
  /** Text that stands in a field but is not in force, by path. */
  rejected: Signal<ReadonlyMap<string, string>>;
  system: ReadonlySignal<SystemView | undefined>;
}

export const UiContext = createContext<Ui | null>(null);

export function useUi(): Ui {
  const ui = useContext(UiContext);
  if (!ui) throw new Error('useUi outside of Shell');
  return ui;
}

/** A command as a button or a menu shows it. */
export interface ShownCommand {
  label: string;
  /** The label, or more words, with the key. */
  title: string;
  disabled: boolean;
  perform(): void;
}

/** @throws Error when there is no such command */
export function useCommand(id: string): ShownCommand {
  const { app, commands } = useUi();
  const command = commands.find((one) => one.id === id);
  if (!command) throw new Error(`no command is called '${id}'`);
  return {
    label: labelOf(command, app),
    title: titleOf(command, app),
    disabled: !(command.enabled?.(app) ?? true),
    perform: () => command.perform?.(app),
  };
}

export function createUi(
  app: App,
  methods: readonly MethodChoice[],
  formulations: readonly FormulationChoice[],
  features: readonly Feature[],
  commands: readonly Command[],
  origin?: ReadonlySignal<CaseInfo | null>,
): Ui {
  const epoch = signal(0);
  return {
    app,
    methods,
    formulations,
    features,
    tools: features.flatMap(({ id, tool }) => (tool ? [{ id, ...tool }] : [])),
    commands,
    epoch,
    origin: origin ?? lastMatchingCase(app),
    rejected: signal<ReadonlyMap<string, string>>(new Map()),
    system: computed(() => app.systemOf(app.state.draft.value.system)),
  };
}

/** The case whose scenario the draft last was. */
function lastMatchingCase(app: App): ReadonlySignal<CaseInfo | null> {
  let last: CaseInfo | null = null;
  return computed(() => {
    const draft = app.state.draft.value;
    last =
      app.cases.find((c) => sameContent(c.scenario, draft)) ?? (last?.scenario.system === draft.system ? last : null);
    return last;
  });
}

/** @param label what is changed, in the words of an undo menu */
export function edit(ui: Ui, label: string, change: (draft: ScenarioFile) => ScenarioFile): void {
  ui.app.actions.edit(label, change);
}

/** Runs something that replaces the draft, and clears text that was refused. */
export function replaceDraft(ui: Ui, action: () => void): void {
  action();
  ui.rejected.value = new Map();
  ui.epoch.value++;
}

export function setRejected(ui: Ui, path: string, error: string | null): void {
  const now = ui.rejected.peek();
  if ((now.get(path) ?? null) === error) return;
  const next = new Map(now);
  if (error === null) next.delete(path);
  else next.set(path, error);
  ui.rejected.value = next;
}
