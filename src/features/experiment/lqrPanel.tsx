/** LQR in the panel: inputs, operating point, a weight for every state and input; the running motion goes on with each change. */
import { MathSymbol } from '../../charts/textView.tsx';
import type { LqrControl, NumberOrExpression } from '../../core/scenario/types.ts';
import type { CoordinateMeta, InputMeta, SystemMeta } from '../../core/model/system.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Check } from '../../ui/kit/controls.tsx';
import { withKey } from '../../app/state/draft.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { ComputerFields } from './lqrComputer.tsx';
import { LqrFacts, LqrReadout, useAskForDesign } from './lqrReadout.tsx';
import { LqrTurns } from './lqrTurns.tsx';
import { operatingKeys, weightSets, writtenQ } from './lqrWeights.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { lqrWords } from './lqrWords.ts';
import { words } from './words.ts';
import { numberOf } from '../../ui/kit/useNumberField.ts';

/** Sliders run over powers of ten; the leftmost place of a state's weight is no weight at all. */
const LEAST = -3;
const MOST = 4;
const STEP = 0.05;

export function LqrPanel({ control }: { control: LqrControl }) {
  const ui = useUi();
  const meta = ui.system.value!.meta;
  useAskForDesign();
  const change = (part: Partial<LqrControl>) =>
    edit(ui, words.control, (now) =>
      now.control?.type === 'lqr' ? withKey(now, 'control', { ...now.control, ...part }) : now,
    );
  return (
    <div class="lqr" data-enter="apply" data-testid="lqr">
      <p class="hint">{lqrWords.about}</p>
      <InputChoice control={control} meta={meta} change={change} />
      <OperatingPoint control={control} meta={meta} change={change} />
      <LqrTurns control={control} meta={meta} />
      {(meta.forward ?? meta.speed) && <Schedule control={control} meta={meta} change={change} />}
      <div class="lqr-sets">
        <label>
          {lqrWords.sets}{' '}
          <select
            data-testid="lqr-sets"
            value=""
            onChange={(event) => {
              const found = weightSets(meta, control.inputs).find((s) => s.id === event.currentTarget.value);
              event.currentTarget.value = '';
              if (found) change({ Q: found.Q, R: found.R });
            }}
          >
            <option value="" disabled>
              {lqrWords.choose}
            </option>
            {weightSets(meta, control.inputs).map((s) => (
              <option key={s.id} value={s.id}>
                {lqrWords.setNames[s.id]}
              </option>
            ))}
          </select>
        </label>
      </div>
      <div class="lqr-turned">
        <LqrReadout />
        <p class="hint" data-testid="lqr-used">
          {Object.keys(control.Q ?? {}).length > 0 ? lqrWords.usedNamed : lqrWords.usedOnes}
        </p>
        <Weights control={control} meta={meta} change={change} />
      </div>
      <LqrFacts />
      <ComputerFields control={control} change={change} />
    </div>
  );
}

interface Part {
  control: LqrControl;
  meta: SystemMeta;
  change(part: Partial<LqrControl>): void;
}

function InputChoice({ control, meta, change }: Part) {
  const toggle = (name: string, on: boolean) => {
    const inputs = meta.inputs.map((i) => i.name).filter((n) => (n === name ? on : control.inputs.includes(n)));
    const keep = <T,>(record: Record<string, T> | undefined) =>
      Object.fromEntries(Object.entries(record ?? {}).filter(([n]) => inputs.includes(n)));
    change({
      inputs,
      R: keep(control.R),
      limits: keep(control.limits),
      ...(control.actuators && { actuators: keep(control.actuators) }),
    });
  };
  return (
    <fieldset class="group">
      <legend>{lqrWords.inputs}</legend>
      {meta.inputs.map((input) => (
        <Check
          key={input.name}
          label={input.label}
          testId={`lqr-input-${input.name}`}
          checked={control.inputs.includes(input.name)}
          onChange={(on) => toggle(input.name, on)}
        />
      ))}
    </fieldset>
  );
}

function OperatingPoint({ control, meta, change }: Part) {
  const ui = useUi();
  const saved = ui.origin.value?.scenario.control;
  const base = saved?.type === 'lqr' ? saved.at : undefined;
  return (
    <fieldset class="group">
      <legend>{lqrWords.at}</legend>
      {operatingKeys(meta, control.at).map((name) => {
        const { coordinate, rate } = stateOf(meta, name);
        const angle = coordinate?.kind === 'angle';
        const unit = rate ? (angle ? '°/s' : 'm/s') : angle ? '°' : 'm';
        return (
          <NumberField
            key={name}
            symbol={<MathSymbol of={coordinate?.symbol ?? 'v'} rate={rate && coordinate !== undefined} />}
            testId={`lqr-at-${name}`}
            spec={{
              path: `control.at.${name}`,
              label: coordinate ? labelOf(coordinate, rate) : lqrWords.speed,
              unit,
              angle,
              optional: true,
              value: control.at?.[name],
              base: base?.[name],
              rest: rate ? 0 : (coordinate?.rest ?? 0),
              step: rate && !angle ? 0.1 : 1,
              commit: (value) => change({ at: changed(control.at, name, value) }),
            }}
          />
        );
      })}
    </fieldset>
  );
}

/** What a schedule begins with when it is switched on, m/s. */
const FIRST_SCHEDULE = { from: 0.5, to: 4, count: 8 };

function Schedule({ control: { schedule }, change }: Part) {
  const field = (key: 'from' | 'to') => (
    <NumberField
      key={key}
      symbol={<MathSymbol of={lqrWords.scheduleEnds[key]} />}
      testId={`lqr-schedule-${key}`}
      spec={{
        path: `control.schedule.${key}`,
        label: lqrWords.scheduleLabels[key],
        unit: 'm/s',
        angle: false,
        positive: true,
        numeric: true,
        value: schedule![key],
        base: undefined,
        rest: FIRST_SCHEDULE[key],
        step: 0.1,
        commit: (value) => change({ schedule: { ...schedule!, [key]: numberOf(value, FIRST_SCHEDULE[key]) } }),
      }}
    />
  );
  return (
    <fieldset class="group">
      <legend>{lqrWords.schedule}</legend>
      <Check
        label={lqrWords.scheduled}
        testId="lqr-schedule"
        checked={schedule !== undefined}
        onChange={(on) => change({ schedule: on ? FIRST_SCHEDULE : undefined })}
      />
      {schedule && field('from')}
      {schedule && field('to')}
    </fieldset>
  );
}

function Weights({ control, meta, change }: Part) {
  const Q = writtenQ(control, meta);
  const row = (coordinate: CoordinateMeta, rate: boolean) => {
    const name = rate ? `${coordinate.name}_dot` : coordinate.name;
    return (
      <Weight
        key={name}
        kind="Q"
        name={name}
        symbol={coordinate.symbol}
        rate={rate}
        label={labelOf(coordinate, rate)}
        value={Q[name]}
        zero
        commit={(value) => change({ Q: { ...Q, [name]: value } })}
      />
    );
  };
  return (
    <>
      <details class="group-fold" open>
        <summary>{lqrWords.positions}</summary>
        {meta.coordinates.map((c) => row(c, false))}
      </details>
      <details class="group-fold">
        <summary>{lqrWords.rates}</summary>
        {meta.coordinates.map((c) => row(c, true))}
      </details>
      <details class="group-fold" open>
        <summary>{lqrWords.efforts}</summary>
        {chosenInputs(control, meta).map((input) => (
          <Weight
            key={input.name}
            kind="R"
            name={input.name}
            symbol={input.symbol}
            label={input.label}
            value={control.R?.[input.name] ?? 1}
            commit={(value) => change({ R: { ...control.R, [input.name]: value } })}
          />
        ))}
      </details>
      <details class="group-fold">
        <summary>{lqrWords.limits}</summary>
        {chosenInputs(control, meta).map((input) => (
          <NumberField
            key={input.name}
            symbol={<MathSymbol of={input.symbol} />}
            placeholder={lqrWords.none}
            testId={`lqr-limit-${input.name}`}
            spec={{
              path: `control.limits.${input.name}`,
              label: lqrWords.limitOf(input.label),
              unit: input.unit,
              angle: false,
              positive: true,
              optional: true,
              value: control.limits?.[input.name],
              base: undefined,
              step: 0.1,
              commit: (value) => change({ limits: changed(control.limits, input.name, value) }),
            }}
          />
        ))}
      </details>
    </>
  );
}

/** A weight: slider over powers of ten, and the number typed. */
function Weight({
  kind,
  name,
  symbol,
  rate = false,
  label,
  value,
  zero = false,
  commit,
}: {
  kind: 'Q' | 'R';
  name: string;
  symbol: string;
  rate?: boolean;
  label: string;
  value: NumberOrExpression | undefined;
  zero?: boolean;
  commit(value: number): void;
}) {
  const number = numberOf(value, 0);
  const place = number > 0 ? Math.min(MOST, Math.max(zero ? LEAST + STEP : LEAST, Math.log10(number))) : LEAST;
  return (
    <div class="weight">
      <NumberField
        symbol={<MathSymbol of={symbol} rate={rate} />}
        testId={`weight-${name}`}
        spec={{
          path: `control.${kind}.${name}`,
          label,
          angle: false,
          numeric: true,
          value,
          base: value,
          rest: 0,
          step: number > 0 ? 10 ** Math.floor(Math.log10(number)) : 1,
          ...(zero ? { min: 0 } : { positive: true }),
          commit: (typed) => commit(numberOf(typed, zero ? 0 : 1)),
        }}
      />
      <input
        type="range"
        min={LEAST}
        max={MOST}
        step={STEP}
        value={place}
        data-testid={`slider-${name}`}
        aria-label={lqrWords.weightOf(label)}
        aria-valuetext={formatShort(number, 3)}
        onInput={(event) => {
          const at = Number(event.currentTarget.value);
          commit(zero && at <= LEAST ? 0 : Number((10 ** at).toPrecision(3)));
        }}
      />
    </div>
  );
}

const chosenInputs = (
  control: LqrControl,
  meta: SystemMeta,
): readonly Pick<InputMeta, 'name' | 'symbol' | 'label' | 'unit'>[] =>
  control.inputs.map(
    (name) =>
      meta.inputs.find((i) => i.name === name) ?? {
        name,
        symbol: name,
        label: words.rawForce,
        unit: words.siUnit,
      },
  );

const labelOf = ({ label }: CoordinateMeta, rate: boolean): string => (rate ? lqrWords.rateOf(label) : label);

function stateOf(meta: SystemMeta, name: string): { coordinate: CoordinateMeta | undefined; rate: boolean } {
  const direct = meta.coordinates.find((c) => c.name === name);
  if (direct) return { coordinate: direct, rate: false };
  return { coordinate: meta.coordinates.find((c) => `${c.name}_dot` === name), rate: true };
}

function changed(
  record: Readonly<Record<string, NumberOrExpression>> | undefined,
  name: string,
  value: NumberOrExpression | undefined,
): Record<string, NumberOrExpression> {
  const { [name]: _, ...rest } = record ?? {};
  return value === undefined ? rest : { ...rest, [name]: value };
}
