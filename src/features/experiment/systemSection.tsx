import { heldOf, holdingOf } from '../../core/scenario/held.ts';
import { useId } from 'preact/hooks';
import { edit, useUi } from '../../ui/context.ts';
import { Choice, Section, Toggle } from '../../ui/kit/controls.tsx';
import { Term } from '../../ui/kit/term.tsx';
import { withKey } from '../../app/state/draft.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';

/** What the experiment is called; links and exports carry it. */
function Title() {
  const { state, actions } = useUi().app;
  const id = useId();
  return (
    <div class="choice">
      <label for={id}>{words.name}</label>
      <input
        id={id}
        class="title-field"
        type="text"
        autocomplete="off"
        value={state.origin.value.title}
        data-testid="title"
        // It is a name: Enter takes it, and runs nothing.
        onKeyDown={(event) => {
          if (event.key !== 'Enter' || event.ctrlKey || event.metaKey) return;
          event.stopPropagation();
          event.currentTarget.blur();
        }}
        onChange={(event) => {
          actions.rename(event.currentTarget.value);
          event.currentTarget.value = state.origin.peek().title;
        }}
      />
    </div>
  );
}

export function SystemSection() {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const system = ui.system.value;
  const errors = ui.app.state.draftErrors.value;
  const builtIn = ui.app.systems.map(({ id, title }) => ({ id, label: title }));
  const own = builtIn.some(({ id }) => id === draft.system) ? undefined : system?.meta;
  const systems = own ? [...builtIn, { id: own.id, label: own.title }] : builtIn;
  const choice = (
    <Choice
      label={words.system}
      value={draft.system}
      options={systems}
      error={errors.get('system')}
      testId="system"
      onChange={(id) => ui.app.actions.chooseSystem(id)}
    />
  );
  if (!system)
    return (
      <Section title={words.system} open>
        {choice}
      </Section>
    );
  const sets = system.meta.constraintSets;
  const chosen = sets.find((set) => set.id === (draft.constraints ?? sets[0]!.id));
  const held = heldOf(system.meta, draft);
  const hold = (name: string) => {
    const order = system.meta.coordinates.map((c) => c.name).filter((n) => (n === name) !== held.includes(n));
    const { hold, release } = holdingOf(system.meta, order);
    edit(ui, words.hold, (now) => withKey(withKey(now, 'hold', hold), 'release', release));
  };
  return (
    <Section title={words.system} open>
      {choice}
      {sets.length > 1 && (
        <Choice
          label={words.constraints}
          value={draft.constraints ?? sets[0]!.id}
          options={sets.map(({ id, label }) => ({ id, label: label.split(': ')[0]! }))}
          error={errors.get('constraints')}
          testId="constraints"
          onChange={(id) =>
            edit(ui, words.constraints, (now) => withKey(now, 'constraints', id === sets[0]!.id ? undefined : id))
          }
        />
      )}
      {sets.length > 1 && chosen?.label.includes(': ') && (
        <p class="hint sentence">{chosen.label.split(': ').slice(1).join(': ')}</p>
      )}
      {system.meta.order !== 1 && (
        <div class="hold" role="group" aria-label={words.hold}>
          <span class="hold-label">
            <Term id="held-coordinate">{words.hold}</Term>
          </span>
          <span class="hold-keys">
            {system.meta.coordinates.map((c) => (
              <Toggle
                key={c.name}
                pressed={held.includes(c.name)}
                label={c.label}
                title={c.label}
                testId={`hold-${c.name}`}
                onClick={() => hold(c.name)}
              >
                <MathSymbol of={c.symbol} />
              </Toggle>
            ))}
          </span>
          {['hold', 'release'].map((key) => errors.get(key) && <span class="error">{errors.get(key)}</span>)}
        </div>
      )}
      <Title />
      <button type="button" class="quiet" data-testid="duplicate" onClick={() => ui.app.actions.set('tool', 'own')}>
        {words.duplicate}
      </button>
    </Section>
  );
}
