/** What every part of the page shares, so that components need no long lists of props. */
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import { computed } from '@preact/signals';
import type { ReadonlySignal } from '@preact/signals';
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
  tools: readonly (Tool & { id: string; document: string | undefined })[];
  /** All that can be asked for by button, menu or key. */
  commands: readonly Command[];
  /** The case the draft came from; fields are compared with it. */
  origin: ReadonlySignal<CaseInfo | null>;
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
  return {
    app,
    methods,
    formulations,
    features,
    tools: features.flatMap(({ id, document, tool }) => (tool ? [{ id, document, ...tool }] : [])),
    commands,
    origin: origin ?? lastMatchingCase(app),
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
