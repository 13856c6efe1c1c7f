import type { ComponentChildren } from 'preact';
import { useId, useState } from 'preact/hooks';
import { formatShort, isExpression, toShown } from './format.ts';
import { later } from './later.tsx';
import { words } from './words.ts';
import { useNumberField } from './useNumberField.ts';
import type { NumberFieldState, NumberSpec } from './useNumberField.ts';

export const Slider = later(async () => (await import('./slider.tsx')).Slider);

/** The box alone: input, unit (drag it to scrub) and the dot that resets. */
export function NumberBox({
  spec,
  field,
  testId,
  placeholder,
  id,
}: {
  spec: NumberSpec;
  field: NumberFieldState;
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
        title={field.input.value === field.text ? undefined : field.text}
        aria-label={spec.unit ? `${spec.label} (${spec.unit})` : spec.label}
        aria-invalid={field.error ? 'true' : undefined}
        aria-describedby={field.error ? `${id}-error` : undefined}
        placeholder={placeholder ?? shownRest}
        data-testid={testId}
        data-path={spec.path}
      />
      {spec.unit && (
        <span class="unit" title={words.scrub} {...field.scrub}>
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

/** Dragged it changes the value; pressed it shows the slider. */
export function Handle({
  label,
  field,
  open,
  onPress,
  children,
}: {
  label: string;
  field: NumberFieldState;
  open: boolean;
  onPress(): void;
  children: ComponentChildren;
}) {
  return (
    // Not a stop of the keyboard: in the field the arrow keys do what the slider does.
    <button
      type="button"
      class="handle"
      tabIndex={-1}
      aria-expanded={open}
      aria-label={words.sliderOf(label)}
      title={words.handle}
      {...field.scrub}
      onClick={() => !field.wasDragged() && onPress()}
    >
      {children}
    </button>
  );
}

/** What an expression in the field comes to. */
export function Meaning({ of: { meaning }, rate = false }: { of: NumberFieldState; rate?: boolean }) {
  return meaning === null ? null : <span class={`meaning${rate ? ' rate' : ''}`}>{meaning}</span>;
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
  const [open, setOpen] = useState(false);
  return (
    <div class="field">
      {symbol !== undefined && (
        <Handle label={spec.label} field={field} open={open} onPress={() => setOpen(!open)}>
          {symbol}
        </Handle>
      )}
      <label for={id} class="name" title={note}>
        {spec.label}
      </label>
      <NumberBox spec={spec} field={field} testId={testId} placeholder={placeholder} id={id} />
      <Meaning of={field} />
      <FieldError id={id} error={field.error} />
      {open && <Slider spec={spec} field={field} />}
    </div>
  );
}
