import { MathSymbol } from '../../charts/textView.tsx';
import { showsAny, shownFirst } from '../../core/model/shown.ts';
import type { ParameterMeta, SystemMeta } from '../../core/model/system.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Choice, Section } from '../../ui/kit/controls.tsx';
import { parameterDefault, withEntry, withParameterSet } from '../../app/state/draft.ts';
import { later } from '../../ui/kit/later.tsx';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { words } from './words.ts';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';

const PersonFields = later(async () => (await import('./personFields.tsx')).PersonFields);

export function ParametersSection() {
  const ui = useUi();
  const meta = ui.system.value?.meta;
  if (!meta) return null;
  const draft = ui.app.state.draft.value;
  const sets = Object.keys(meta.parameterSets);
  const parameters = shownFirst(meta.parameters, meta);
  const groups = [...new Set(parameters.map((p) => p.group))];
  return (
    <Section title={words.parameters} open={showsAny(parameters, meta)}>
      {sets.length > 1 && (
        <Choice
          label={words.parameterSet}
          value={draft.parameterSet ?? sets[0]!}
          options={sets.map((id) => ({ id, label: id }))}
          testId="parameter-set"
          error={ui.app.state.draftErrors.value.get('parameterSet')}
          onChange={(id) =>
            edit(ui, words.parameterSet, (now) => withParameterSet(now, meta, id === sets[0] ? undefined : id))
          }
        />
      )}
      {groups.map((group) => (
        <fieldset key={group} class="group">
          <legend>{group}</legend>
          {group === meta.person && <PersonFields />}
          {parameters
            .filter((p) => p.group === group)
            .map((p) => (
              <ParameterField key={`${meta.id}.${p.name}`} meta={meta} parameter={p} />
            ))}
        </fieldset>
      ))}
    </Section>
  );
}

function ParameterField({ meta, parameter: p }: { meta: SystemMeta; parameter: ParameterMeta }) {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const origin = ui.origin.value?.scenario;
  const standard = parameterDefault(meta, draft.parameterSet ?? Object.keys(meta.parameterSets)[0], p.name);
  const base =
    origin?.parameters?.[p.name] ??
    parameterDefault(meta, origin?.parameterSet ?? Object.keys(meta.parameterSets)[0], p.name);
  const spec: NumberSpec = {
    path: `parameters.${p.name}`,
    label: p.label,
    unit: p.kind === 'angle' ? '°' : p.unit,
    angle: p.kind === 'angle',
    min: p.min,
    max: p.max,
    positive: p.positive,
    value: draft.parameters?.[p.name] ?? standard,
    base,
    rest: standard,
    commit: (value) =>
      edit(ui, p.label, (now) =>
        withEntry(now, 'parameters', p.name, numberOf(value, standard) === standard ? undefined : value),
      ),
  };
  return <NumberField symbol={<MathSymbol of={p.symbol} />} spec={spec} testId={`parameter-${p.name}`} note={p.note} />;
}
