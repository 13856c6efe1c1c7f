/** What is varied, from where to where, in how many steps. */
import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';
import type { LocusRequest } from '../../core/control/locus/scenarioLocus.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { text } from '../../ui/words.ts';
import { words } from './words.ts';
import { numberOf, type NumberSpec } from '../../ui/kit/useNumberField.ts';
import { offeredRange, type LocusSubject } from './subjects.ts';

const COUNT = 121;
const MOST = 1000;

type Range = Pick<LocusRequest, 'from' | 'to' | 'count'>;

export function LocusForm({
  subjects,
  parameters,
  computing,
  onStart,
  onCancel,
  children,
}: {
  subjects: readonly LocusSubject[];
  parameters: Readonly<Record<string, number>>;
  computing: boolean;
  onStart(subject: LocusSubject, range: Range): void;
  onCancel(): void;
  children?: ComponentChildren;
}) {
  const id = useId();
  const subject = useSignal(subjects[0]!);
  const typed = useSignal<{ from?: NumberOrExpression; to?: NumberOrExpression; count?: number }>({});
  const offered = offeredRange(subject.value, parameters[subject.value.name] ?? 0);
  const range = {
    from: numberOf(typed.value.from, offered.from),
    to: numberOf(typed.value.to, offered.to),
    count: typed.value.count ?? COUNT,
  };
  const rising = range.from < range.to;
  const { angle, unit, least, most } = subject.value;
  const spec = (end: 'from' | 'to'): NumberSpec => ({
    path: `locus.${end}`,
    label: words[end],
    unit,
    angle,
    value: typed.value[end] ?? offered[end],
    base: offered[end],
    rest: offered[end],
    ...(Number.isFinite(least) ? { min: least } : {}),
    ...(Number.isFinite(most) ? { max: most } : {}),
    commit: (value) => {
      typed.value = { ...typed.value, [end]: value ?? offered[end] };
    },
    aside() {},
  });
  const count: NumberSpec = {
    path: 'locus.count',
    label: words.steps,
    angle: false,
    numeric: true,
    min: 2,
    max: MOST,
    value: range.count,
    base: COUNT,
    rest: COUNT,
    step: 10,
    commit: (value) => {
      typed.value = { ...typed.value, count: Math.round(Number(value ?? COUNT)) };
    },
    aside() {},
  };
  return (
    <form
      class="locus-form"
      onSubmit={(event) => {
        event.preventDefault();
        if (rising) onStart(subject.value, range);
      }}
    >
      <div class="choice">
        <label for={id}>{words.against}</label>
        <select
          id={id}
          value={subject.value.id}
          data-testid="locus-subject"
          onChange={(event) => {
            subject.value = subjects.find((s) => s.id === event.currentTarget.value)!;
            typed.value = {};
          }}
        >
          <optgroup label={words.pointGroup}>
            {subjects
              .filter((s) => s.vary === 'at')
              .map((s) => (
                <option key={s.id} value={s.id}>
                  {s.label}
                </option>
              ))}
          </optgroup>
          <optgroup label={words.parameters}>
            {subjects
              .filter((s) => s.vary === 'parameter')
              .map((s) => (
                <option key={s.id} value={s.id}>
                  {s.label}
                </option>
              ))}
          </optgroup>
        </select>
      </div>
      <div class="locus-range" key={subject.value.id}>
        <NumberField spec={spec('from')} testId="locus-from" />
        <NumberField spec={spec('to')} testId="locus-to" />
        <NumberField spec={count} testId="locus-count" />
      </div>
      {children}
      {!rising && (
        <p class="error" role="alert">
          {words.mustRise}
        </p>
      )}
      <div class="run-buttons">
        <button type="submit" class="primary" data-testid="locus-run" disabled={!rising || computing}>
          {words.compute}
        </button>
        <button type="button" data-testid="locus-cancel" disabled={!computing} onClick={onCancel}>
          {text.panel.cancel}
        </button>
      </div>
    </form>
  );
}
