/** The operating point: what is named, what moves, and the multipliers that carry it. */
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import type { SystemView } from '../../core/model/system.ts';
import { edit, useUi, type Ui } from '../../ui/context.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { formatQuantity, formatShort, THIN } from '../../ui/kit/format.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { MathSymbol } from '../../charts/textView.tsx';
import { words } from './words.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';
import { shownUnit, type Column } from '../../core/motion/columns.ts';
import { pointOf, pointPath, withPoint } from './names.ts';

export function PointSection({
  analysis,
  names,
  system,
}: {
  analysis: ControlAnalysis | null;
  names: ReadonlyMap<string, Column>;
  system: SystemView;
}) {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const at = pointOf(draft);
  const speed = speedName(system);
  const shown = [...new Set([speed, ...Object.keys(at)])];
  const known = [...(system.meta.speed ? [system.meta.speed.name] : []), ...names.keys()];
  return (
    <Section title={words.point} open>
      {shown.map((name) => (
        <PointField key={`${system.meta.id}.${name}`} name={name} names={names} />
      ))}
      <label class="point-add">
        <span>{words.addState}</span>
        <select
          data-testid="point-add"
          value=""
          onChange={(event) => {
            const name = event.currentTarget.value;
            event.currentTarget.value = '';
            if (name) setPoint(ui, name, 0);
          }}
        >
          <option value="">{words.choose}</option>
          {known
            .filter((name) => !shown.includes(name))
            .map((name) => (
              <option key={name} value={name}>
                {names.get(name)?.label ?? name}
              </option>
            ))}
        </select>
      </label>
      <p class="hint">{words.pointNote}</p>
      {analysis && <Motion analysis={analysis} names={names} system={system} />}
    </Section>
  );
}

function setPoint(ui: Ui, name: string, value: NumberOrExpression | undefined): void {
  edit(ui, name, (now) => withPoint(now, name, value));
}

/** How fast it goes: a word of the system's own, or the rate of its first coordinate (itself, in first order). */
export function speedName(system: SystemView): string {
  const { coordinates, order, speed } = system.meta;
  return speed?.name ?? (order === 1 ? coordinates[0]!.name : `${coordinates[0]!.name}_dot`);
}

function PointField({ name, names }: { name: string; names: ReadonlyMap<string, Column> }) {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const origin = ui.origin.value?.scenario;
  const state = names.get(name);
  const unit = state ? shownUnit(state, true) : 'm/s';
  const spec: NumberSpec = {
    path: `${pointPath(draft)}.${name}`,
    label: state?.label ?? name,
    unit,
    angle: state?.degrees ?? false,
    optional: true,
    rest: 0,
    step: state?.degrees ? 1 : 0.1,
    value: pointOf(draft)[name],
    base: origin && pointOf(origin)[name],
    commit: (value) => setPoint(ui, name, value),
  };
  return (
    <NumberField
      symbol={<MathSymbol of={state?.symbol ?? 'v'} rate={state?.rate} />}
      spec={spec}
      placeholder={words.rest}
      testId={`point-${name}`}
    />
  );
}

function Motion({
  analysis: { point },
  names,
  system,
}: {
  analysis: ControlAnalysis;
  names: ReadonlyMap<string, Column>;
  system: SystemView;
}) {
  const { coordinates } = system.meta;
  const rates = coordinates.flatMap((c, i) =>
    point.v[i] && names.has(`${c.name}_dot`)
      ? [{ name: c.name, state: names.get(`${c.name}_dot`)!, value: point.v[i]! }]
      : [],
  );
  const values = coordinates.flatMap((c, i) =>
    point.q[i] !== 0 ? [{ state: names.get(c.name)!, value: point.q[i]! }] : [],
  );
  return (
    <dl class="point-facts" data-testid="operating-point">
      <div>
        <dt>{words.moves}</dt>
        <dd>
          {rates.length === 0
            ? words.nothingMoves
            : rates.map(({ name, state, value }) => <Fact key={name} state={state} value={value} />)}
        </dd>
      </div>
      {values.length > 0 && (
        <div>
          <dt>{words.stands}</dt>
          <dd>
            {values.map(({ state, value }) => (
              <Fact key={state.name} state={state} value={value} />
            ))}
          </dd>
        </div>
      )}
      {point.multipliers.length > 0 && (
        <div>
          <dt>{words.multipliers}</dt>
          <dd>
            {point.multipliers.map((value, i) => (
              <span key={i} class="fact">
                <MathSymbol of={`λ_${i + 1}`} />
                <span class="hidden">lambda {i + 1}</span> {formatShort(value, 5)}
                {role(system, i) && `${THIN}N`} <span class="hint">{role(system, i)}</span>
              </span>
            ))}
          </dd>
        </div>
      )}
    </dl>
  );
}

function Fact({ state, value }: { state: Column; value: number }) {
  return (
    <span class="fact" title={state.label}>
      <MathSymbol of={state.symbol} rate={state.rate} />
      <span class="hidden">{state.label}</span> {formatQuantity(value, shownUnit(state, true))}
    </span>
  );
}

/** `front wheel, vertical`, or nothing where the multiplier is no wheel's force. */
function role(system: SystemView, index: number): string {
  for (const { label, lateral, vertical } of system.contacts) {
    if (index === lateral) return `${label}, ${words.lateral}`;
    if (index === vertical) return `${label}, ${words.vertical}`;
  }
  return '';
}
