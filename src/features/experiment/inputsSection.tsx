import type { NumberOrExpression, TrackControl } from '../../core/scenario/types.ts';
import type { InputMeta } from '../../core/model/system.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Choice, Section } from '../../ui/kit/controls.tsx';
import { isRidable } from '../../core/scenario/ride.ts';
import { withEntry, withKey } from '../../app/state/draft.ts';
import { ExpressionField } from '../../ui/kit/expressionField.tsx';
import { later } from '../../ui/kit/later.tsx';
import { firstLqr } from './lqrWeights.ts';
import { Term } from '../../ui/kit/term.tsx';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';

const LqrPanel = later(async () => (await import('./lqrPanel.tsx')).LqrPanel);
const RideCommands = later(async () => (await import('./rideCommands.tsx')).RideCommands);

export function InputsSection() {
  const ui = useUi();
  const system = ui.system.value;
  const draft = ui.app.state.draft.value;
  if (!system) return null;
  const named = new Set(system.meta.inputs.map((input) => input.name));
  // raw generalized forces are offered only where the scenario has them
  const raw = Object.keys(draft.inputs ?? {})
    .filter((name) => !named.has(name))
    .map((name) => ({ name, symbol: name, label: words.rawForce, unit: words.siUnit }));
  const inputs: readonly Pick<InputMeta, 'name' | 'symbol' | 'label' | 'unit'>[] = [...system.meta.inputs, ...raw];
  if (inputs.length === 0) return null;
  return (
    <Section title={words.inputs}>
      {inputs.map((input) => (
        <ExpressionField
          key={`${system.meta.id}.${input.name}`}
          path={`inputs.${input.name}`}
          symbol={<MathSymbol of={input.symbol} />}
          label={input.label}
          unit={input.unit}
          testId={`input-${input.name}`}
          value={draft.inputs?.[input.name]}
          base={ui.origin.value?.scenario.inputs?.[input.name]}
          commit={(value) => edit(ui, input.label, (now) => withEntry(now, 'inputs', input.name, value))}
        />
      ))}
      <p class="hint">{words.inputsHint}</p>
    </Section>
  );
}

export function ControlSection() {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const control = draft.control;
  const meta = ui.system.value?.meta;
  const tracking = meta?.inputs.filter((input) => input.tracks) ?? [];
  if (!meta || (meta.inputs.length === 0 && !control)) return null;
  const kinds = [
    { id: 'none', label: words.controlNone },
    ...(tracking.length > 0 ? [{ id: 'track', label: words.controlTrack }] : []),
    { id: 'lqr', label: words.controlLqr },
    ...(isRidable(meta) ? [{ id: 'ride', label: words.controlRide }] : []),
  ];
  const choose = (id: string) => {
    const saved = ui.origin.value?.scenario.control;
    const track: TrackControl = saved?.type === 'track' ? saved : { type: 'track', reference: {}, kp: 60, kd: 3 };
    const chosen = {
      none: undefined,
      track,
      ride: saved?.type === 'ride' ? saved : { type: 'ride' as const, commands: [] },
      lqr: firstLqr(meta, draft.initial, saved?.type === 'lqr' ? saved : undefined),
    }[id];
    edit(ui, words.controlKind, (now) => withKey(now, 'control', chosen));
  };
  return (
    <Section title={words.control}>
      <Choice
        label={words.controlKind}
        value={control?.type ?? 'none'}
        options={kinds}
        error={ui.app.state.draftErrors.value.get('control')}
        testId="control"
        onChange={choose}
      />
      {control?.type === 'lqr' && <LqrPanel key={meta.id} control={control} />}
      {control?.type === 'ride' && (
        <RideCommands
          key={meta.id}
          control={control}
          change={(part) => edit(ui, words.control, (now) => withKey(now, 'control', { ...control, ...part }))}
        />
      )}
      {control?.type === 'track' && <Track control={control} />}
    </Section>
  );
}

function Track({ control }: { control: TrackControl }) {
  const ui = useUi();
  const system = ui.system.value!;
  const saved = ui.origin.value?.scenario.control;
  const origin = saved?.type === 'track' ? saved : undefined;
  const change = (part: Partial<TrackControl>) =>
    edit(ui, words.control, (now) =>
      now.control?.type === 'track' ? withKey(now, 'control', { ...now.control, ...part }) : now,
    );
  const refer = (name: string, value: NumberOrExpression | undefined) => {
    const { [name]: _, ...rest } = control.reference;
    change({ reference: value === undefined ? rest : { ...rest, [name]: value } });
  };
  const gain = (key: 'kp' | 'kd'): NumberSpec => ({
    path: `control.${key}`,
    label: words[key],
    angle: false,
    numeric: true,
    min: 0,
    value: control[key],
    base: origin?.[key] ?? control[key],
    rest: 0,
    step: key === 'kp' ? 1 : 0.1,
    commit: (value) => change({ [key]: value as number }),
  });
  return (
    <>
      {system.meta.inputs
        .filter((input) => input.tracks)
        .map((input) => (
          <ExpressionField
            key={`${system.meta.id}.${input.name}`}
            path={`control.reference.${input.name}`}
            symbol={<MathSymbol of={input.symbol} />}
            unit={words.reference}
            label={input.tracks!.join(' + ')}
            shown={trackedName(input.tracks!, system.meta.coordinates)}
            value={control.reference[input.name]}
            base={origin?.reference[input.name]}
            placeholder="–"
            testId={`reference-${input.name}`}
            commit={(value) => refer(input.name, value)}
          />
        ))}
      <NumberField symbol={<MathSymbol of="k_p" />} spec={gain('kp')} testId="control-kp" />
      <NumberField symbol={<MathSymbol of="k_d" />} spec={gain('kd')} testId="control-kd" />
      <p class="hint">
        <Term id="tracked">{words.tracked}</Term> {words.trackHint}
      </p>
    </>
  );
}

/** `α + α_fp`, typeset. */
function trackedName(tracks: readonly string[], coordinates: readonly { name: string; symbol: string }[]) {
  return tracks.map((name, i) => (
    <>
      {i > 0 && ' + '}
      <MathSymbol of={coordinates.find((c) => c.name === name)?.symbol ?? name} />
    </>
  ));
}
