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

export type Range = Pick<LocusRequest, 'from' | 'to' | 'count'>;

export function LocusForm({
  subjects,
  parameters,
  computing,
  onStart,
  onCancel,
  offered: offeredCount = COUNT,
  against = words.against,
  testId = 'locus',
  children,
}: {
  subjects: readonly LocusSubject[];
  parameters: Readonly<Record<string, number>>;
  computing: boolean;
  onStart(subject: LocusSubject, range: Range): void;
  onCancel(): void;
  /** How many values are offered. */
  offered?: number;
  against?: string;
  testId?: string;
  children?: ComponentChildren;
}) {
  const id = useId();
  const subject = useSignal(subjects[0]!);
  const typed = useSignal<{ from?: NumberOrExpression; to?: NumberOrExpression; count?: number }>({});
  const offered = offeredRange(subject.value, parameters[subject.value.name] ?? 0);
  const range = {
    from: numberOf(typed.value.from, offered.from),
    to: numberOf(typed.value.to, offered.to),
    count: typed.value.count ?? offeredCount,
  };
  const rising = range.from < range.to;
  const { angle, unit, least, most } = subject.value;
  const spec = (end: 'from' | 'to'): NumberSpec => ({
    path: `${testId}.${end}`,
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
    path: `${testId}.count`,
    label: words.steps,
    angle: false,
    numeric: true,
    min: 2,
    max: MOST,
    value: range.count,
    base: offeredCount,
    rest: offeredCount,
    step: 10,
    commit: (value) => {
      typed.value = { ...typed.value, count: Math.round(Number(value ?? offeredCount)) };
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
        <label for={id}>{against}</label>
        <select
          id={id}
          value={subject.value.id}
          data-testid={`${testId}-subject`}
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
        <NumberField spec={spec('from')} testId={`${testId}-from`} />
        <NumberField spec={spec('to')} testId={`${testId}-to`} />
        <NumberField spec={count} testId={`${testId}-count`} />
      </div>
      {children}
      {!rising && (
        <p class="error" role="alert">
          {words.mustRise}
        </p>
      )}
      <div class="run-buttons">
        <button type="submit" class="primary" data-testid={`${testId}-run`} disabled={!rising || computing}>
          {words.compute}
        </button>
        <button type="button" data-testid={`${testId}-cancel`} disabled={!computing} onClick={onCancel}>
          {text.panel.cancel}
        </button>
      </div>
    </form>
  );
}
