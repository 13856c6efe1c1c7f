import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';
import { formatQuantity, formatShort, isExpression, toShown } from './format.ts';
import { words } from './words.ts';
import { numberOf, useNumberField } from './useNumberField.ts';
import type { NumberSpec } from './useNumberField.ts';

/** The box alone: input, unit (drag it to scrub) and the dot that resets. */
export function NumberBox({
  spec,
  field,
  testId,
  placeholder,
  id,
}: {
  spec: NumberSpec;
  field: ReturnType<typeof useNumberField>;
  testId?: string | undefined;
  placeholder?: string | undefined;
  id: string;
}) {
  const shownRest = spec.rest === undefined ? '' : formatShort(toShown(spec.rest, spec.angle), 6);
  const expression = spec.angle && !field.error && isExpression(field.text);
  return (
    <span class={`box${field.error ? ' bad' : ''}`}>
      {field.differs && (
        <button
          type="button"
          class="dot"
          title={words.differs(spec.label)}
          aria-label={words.differs(spec.label)}
          onClick={field.reset}
        />
      )}
      <input
        {...field.input}
        id={id}
        type="text"
        inputMode="text"
        autocomplete="off"
        spellcheck={false}
        aria-label={spec.unit ? `${spec.label} (${spec.unit})` : spec.label}
        aria-invalid={field.error ? 'true' : undefined}
        aria-describedby={field.error ? `${id}-error` : undefined}
        placeholder={placeholder ?? shownRest}
        data-testid={testId}
      />
      {spec.unit && (
        <span
          class="unit"
          title={expression ? `= ${formatQuantity(numberOf(spec.value, NaN), spec.unit)}` : words.scrub}
          {...field.scrub}
        >
          {expression ? spec.unit.replace('°', 'rad') : spec.unit}
        </span>
      )}
    </span>
  );
}

export function FieldError({ id, error }: { id: string; error: string | null }) {
  return error ? (
    <span class="error" id={`${id}-error`}>
      {error}
    </span>
  ) : null;
}

/** One row: symbol, name, value, unit. */
export function NumberField({
  symbol,
  spec,
  testId,
  placeholder,
  note,
}: {
  /** Typeset by whoever knows what it means. */
  symbol?: ComponentChildren;
  spec: NumberSpec;
  testId?: string;
  placeholder?: string;
  note?: string | undefined;
}) {
  const id = useId();
  const field = useNumberField(spec);
  return (
    <div class="field">
      {symbol !== undefined && (
        <span class="handle" title={words.scrub} {...field.scrub}>
          {symbol}
        </span>
      )}
      <label for={id} class="name" title={note}>
        {spec.label}
      </label>
      <NumberBox spec={spec} field={field} testId={testId} placeholder={placeholder} id={id} />
      <FieldError id={id} error={field.error} />
    </div>
  );
}
