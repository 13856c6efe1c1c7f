/** The start: every coordinate and velocity of the system, and what the consistent start made of them. */
import { useId, useState } from 'preact/hooks';
import type { Adjustment } from '../../app/runs/motion.ts';
import type { CoordinateMeta, SystemMeta } from '../../core/model/system.ts';
import { edit, useUi } from '../../ui/context.ts';
import { shownFirst } from '../../core/model/shown.ts';
import { coordinateUnit, rateUnit } from '../../core/model/units.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { withEntry } from '../../app/state/draft.ts';
import { formatQuantity } from '../../ui/kit/format.ts';
import { FieldError, Handle, Meaning, NumberBox, NumberField, Slider } from '../../ui/kit/numberField.tsx';
import { Chip } from '../../ui/kit/chip.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';
import { useNumberField } from '../../ui/kit/useNumberField.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';

/** Signs that the boxes have room for. */
const [MOST_VALUE, MOST_RATE] = [6, 5];

export function StartSection() {
  const ui = useUi();
  const system = ui.system.value;
  if (!system) return null;
  const motion = ui.app.state.motion.value;
  const adjusted = new Map(
    motion?.source === 'run' && motion.system === system ? motion.adjustments.map((a) => [a.name, a]) : [],
  );
  return (
    <Section title={words.start} open>
      {system.meta.speed && <SpeedField key={system.meta.id} speed={system.meta.speed} />}
      <div class="start-head" aria-hidden="true">
        <span>{words.value}</span>
        {system.meta.order !== 1 && <span>{words.rate}</span>}
      </div>
      {shownFirst(system.meta.coordinates, system.meta).map((c) => (
        <StartRow
          key={`${system.meta.id}.${c.name}`}
          coordinate={c}
          value={adjusted.get(c.name)}
          rate={adjusted.get(`${c.name}_dot`)}
          rated={system.meta.order !== 1}
        />
      ))}
      <p class="hint">{words.startHint}</p>
    </Section>
  );
}

/** One word for the velocities straight ahead: the start may say it instead of them. */
function SpeedField({ speed: { name, label } }: { speed: NonNullable<SystemMeta['speed']> }) {
  const ui = useUi();
  return (
    <NumberField
      testId={`initial-${name}`}
      spec={{
        path: `initial.${name}`,
        label,
        unit: 'm/s',
        angle: false,
        optional: true,
        rest: 0,
        step: 0.1,
        value: ui.app.state.draft.value.initial?.[name],
        base: ui.origin.value?.scenario.initial?.[name],
        commit: (value) => edit(ui, label, (draft) => withEntry(draft, 'initial', name, value)),
      }}
      symbol={<MathSymbol of="v" />}
    />
  );
}

/** @param rated whether the rate can be chosen: of first order it follows from the value */
function StartRow({
  coordinate,
  value,
  rate,
  rated,
}: {
  coordinate: CoordinateMeta;
  value: Adjustment | undefined;
  rate: Adjustment | undefined;
  rated: boolean;
}) {
  const [valueId, rateId] = [useId(), useId()];
  const valueSpec = useStartSpec(coordinate, 0);
  const rateSpec = useStartSpec(coordinate, 1);
  const valueField = useNumberField(valueSpec);
  const rateField = useNumberField(rateSpec);
  const [open, setOpen] = useState(false);
  // What is too long for a narrow box gets a line of its own: nothing is cut off.
  const long = valueField.text.length > MOST_VALUE || rateField.text.length > MOST_RATE;
  return (
    <div class={`start-row${long ? ' long' : ''}`}>
      <Handle label={coordinate.label} field={valueField} open={open} onPress={() => setOpen(!open)}>
        <Chip role={coordinate.role} />
        <span class="name">
          <MathSymbol of={coordinate.symbol} /> {coordinate.label}
        </span>
      </Handle>
      <NumberBox spec={valueSpec} field={valueField} id={valueId} testId={`initial-${coordinate.name}`} />
      {rated && <NumberBox spec={rateSpec} field={rateField} id={rateId} testId={`initial-${coordinate.name}_dot`} />}
      {open && <Slider spec={valueSpec} field={valueField} />}
      {open && rated && <Slider spec={rateSpec} field={rateField} rate />}
      <Meaning of={valueField} />
      <Meaning of={rateField} rate />
      <FieldError id={valueId} error={valueField.error} />
      <FieldError id={rateId} error={rateField.error} />
      <Solved adjustment={value} unit={valueSpec.unit!} />
      <Solved adjustment={rate} unit={rateSpec.unit!} rate />
    </div>
  );
}

function useStartSpec(coordinate: CoordinateMeta, order: 0 | 1): NumberSpec {
  const ui = useUi();
  const name = order === 0 ? coordinate.name : `${coordinate.name}_dot`;
  return {
    path: `initial.${name}`,
    label: order === 0 ? coordinate.label : `${coordinate.label}, ${words.rate}`,
    unit: order === 0 ? coordinateUnit(coordinate) : rateUnit(coordinate),
    angle: coordinate.kind === 'angle',
    optional: true,
    value: ui.app.state.draft.value.initial?.[name],
    base: ui.origin.value?.scenario.initial?.[name],
    rest: order === 0 ? (coordinate.rest ?? 0) : 0,
    step: coordinate.kind === 'angle' ? 1 : order === 0 ? 0.01 : 0.1,
    commit: (value) => edit(ui, coordinate.label, (draft) => withEntry(draft, 'initial', name, value)),
  };
}

/** What the last run started from instead. */
function Solved({
  adjustment,
  unit,
  rate = false,
}: {
  adjustment: Adjustment | undefined;
  unit: string;
  rate?: boolean;
}) {
  if (!adjustment || adjustment.from === adjustment.to) return null;
  const why = adjustment.named ? words.moved : words.solved;
  return (
    <span class={`solved${rate ? ' rate' : ''}`} data-testid={`solved-${adjustment.name}`}>
      → {formatQuantity(adjustment.to, unit)} ({why})
    </span>
  );
}
