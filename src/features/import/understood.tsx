/** What was understood of the whole file; each can be changed. */
import type { SystemMeta } from '../../core/model/system.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import type { Encoding, ImportChoices, ImportPlan, Separator } from '../../csv/plan.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import { useUi } from '../../ui/context.ts';
import { Check, Choice } from '../../ui/kit/controls.tsx';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { unitless } from './choices.ts';
import { words } from './words.ts';

const options = (labels: Readonly<Record<string, string>>) =>
  Object.entries(labels).map(([id, label]) => ({ id, label }));

/** Of the choice that no system is meant. */
const NO_SYSTEM = '';
/** Of the choice that no column has the time. */
const COUNTED = -1;

interface Part {
  plan: ImportPlan;
  change(choices: ImportChoices): void;
}

export function Understood({ plan, meta }: { plan: ImportPlan; meta: SystemMeta | null }) {
  const { actions } = useUi().app;
  const change = (choices: ImportChoices) => actions.readAgain(choices);
  return (
    <div class="import-fields">
      <SystemChoice plan={plan} change={change} />
      <PartFields plan={plan} change={change} />
      <TimeFields plan={plan} change={change} />
      <UnitFields plan={plan} change={change} />
      {meta && meta.order !== 1 && (
        <div>
          <Check
            label={words.rates}
            checked={plan.rates !== 'none'}
            testId="import-rates"
            onChange={(on) => change({ rates: on ? 'savitzky-golay' : 'none' })}
          />
          <p class="hint">{words.ratesHint}</p>
        </div>
      )}
      <TextFields plan={plan} change={change} />
    </div>
  );
}

function SystemChoice({ plan, change }: Part) {
  const { systems } = useUi().app;
  return (
    <Choice
      label={words.system}
      testId="import-system"
      value={plan.system ?? NO_SYSTEM}
      options={[...systems.map(({ id, title }) => ({ id, label: title })), { id: NO_SYSTEM, label: words.data }]}
      onChange={(id) => change({ system: id === NO_SYSTEM ? null : id })}
    />
  );
}

/** Which of several bodies, and of several runs. */
function PartFields({ plan: { bodies, body, runs, run }, change }: Part) {
  return (
    <>
      {bodies.length > 1 && (
        <Choice
          label={words.body}
          testId="import-body"
          value={body ?? ''}
          options={bodies.map((id) => ({ id, label: id || words.unnamedBody }))}
          onChange={(id) => change({ body: id })}
        />
      )}
      {runs > 1 && (
        <Choice
          label={words.run}
          testId="import-run"
          value={String(run ?? 1)}
          options={Array.from({ length: runs }, (_, i) => ({ id: String(i + 1), label: words.runOf(i + 1, runs) }))}
          onChange={(id) => change({ run: Number(id) })}
        />
      )}
    </>
  );
}

function TimeFields({ plan, change }: Part) {
  const { time, columns } = plan;
  const read = time.columns.map((index) => columns[index]!.source);
  const stepped = time.form === 'frame' || time.form === 'counted';
  return (
    <>
      <Choice
        label={words.time}
        testId="import-time"
        value={String(time.columns[0] ?? COUNTED)}
        options={[
          ...columns.map(({ index, source }) => ({ id: String(index), label: words.timeColumn(source) })),
          { id: String(COUNTED), label: words.timeCounted },
        ]}
        onChange={(id) => change({ time: Number(id) === COUNTED ? null : columns[Number(id)]!.source })}
      />
      {read.length > 0 && time.form !== 'number' && <p class="hint">{words.timeIs(words.forms[time.form])}</p>}
      {(time.form === 'number' || time.form === 'epoch') && time.columns.length === 1 && (
        <Choice
          label={words.timeUnit}
          testId="import-time-unit"
          value={time.unit || 's'}
          options={options(words.timeUnits)}
          onChange={(timeUnit) => change({ timeUnit })}
        />
      )}
      {stepped && <StepField key={String(time.step)} step={time.step ?? 1 / 60} change={change} />}
    </>
  );
}

function StepField({ step, change }: { step: number; change: Part['change'] }) {
  const commit = (value?: NumberOrExpression) => {
    const next = numberOf(value ?? step, step);
    if (next !== step) change({ step: next });
  };
  const inverse = Math.round(1 / step);
  const shown = Math.abs(inverse * step - 1) < 1e-9 && inverse > 1 ? `1/${inverse}` : step;
  return (
    <NumberField
      testId="import-step"
      symbol={<MathSymbol of="Δt" />}
      spec={{
        path: 'import.step',
        label: words.step,
        unit: 's',
        angle: false,
        positive: true,
        value: shown,
        base: shown,
        rest: step,
        step: 0.001,
        commit,
        aside() {},
      }}
    />
  );
}

function UnitFields({ plan, change }: Part) {
  const choices = useUi().app.state.motion.value?.imported?.choices ?? {};
  return (
    <>
      {(unitless(plan, 'angle') || choices.angles) && (
        <Choice
          label={words.angles}
          testId="import-angles"
          value={choices.angles ?? 'rad'}
          options={options(words.angleUnits)}
          onChange={(id) => change({ angles: id as 'rad' | 'deg' })}
        />
      )}
      {(unitless(plan, 'length') || choices.lengths) && (
        <Choice
          label={words.lengths}
          testId="import-lengths"
          value={choices.lengths ?? 'm'}
          options={options(words.lengthUnits)}
          onChange={(id) => change({ lengths: id as 'm' | 'cm' | 'mm' })}
        />
      )}
      {plan.system !== null && (
        <Choice
          label={words.up}
          testId="import-up"
          value={plan.up}
          options={[
            { id: 'z', label: 'z' },
            { id: 'y', label: 'y' },
          ]}
          onChange={(id) => change({ up: id as 'y' | 'z' })}
        />
      )}
    </>
  );
}

function TextFields({ plan, change }: Part) {
  return (
    <>
      <Choice
        label={words.encoding}
        testId="import-encoding"
        value={plan.encoding}
        options={options(words.encodings)}
        onChange={(id) => change({ encoding: id as Encoding })}
      />
      <Choice
        label={words.separator}
        testId="import-separator"
        value={plan.separator}
        options={options(words.separators)}
        onChange={(id) => change({ separator: id as Separator })}
      />
      <Choice
        label={words.decimal}
        testId="import-decimal"
        value={plan.decimal}
        options={options(words.decimals)}
        onChange={(id) => change({ decimal: id as '.' | ',' })}
      />
      <HeaderLine plan={plan} change={change} />
      <p class="hint">
        {plan.unitsLine !== null && `${words.unitsLine(plan.unitsLine)} `}
        {words.firstRow(plan.firstRow)}
      </p>
    </>
  );
}

function HeaderLine({ plan, change }: Part) {
  const line = plan.headerLines.at(-1) ?? 0;
  return (
    <label class="choice">
      <span>
        {words.header} <span class="hint">{words.headerHint}</span>
      </span>
      <input
        key={line}
        type="number"
        min={0}
        max={plan.firstRow + plan.preview.length}
        defaultValue={String(line)}
        data-testid="import-header"
        onChange={(event) => {
          const next = event.currentTarget.valueAsNumber;
          if (Number.isSafeInteger(next) && next >= 0 && next !== line) change({ headerLine: next });
          else event.currentTarget.value = String(line);
        }}
      />
    </label>
  );
}
