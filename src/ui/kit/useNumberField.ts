/** A field's behaviour: typed text, errors, stepping, scrubbing. What it looks like is `numberField.tsx`. */
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { evaluateNumber } from '../../core/scenario/expressions.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { commandFor } from '../../app/commands.ts';
import { setRejected, useUi } from '../context.ts';
import { fieldCommands } from './fieldCommands.ts';
import { formatField, naturalStep, nudge, parseField, storedFromShown, toShown } from './format.ts';
import type { FieldRules } from './format.ts';

export interface NumberSpec extends FieldRules {
  /** Draft path, e.g. `initial.alpha_fp`. */
  path: string;
  label: string;
  value: NumberOrExpression | undefined;
  /** The case's value; a dot shows where the draft differs. */
  base?: NumberOrExpression | undefined;
  /** What is in force when the field is empty, SI. */
  rest?: number | undefined;
  /** One arrow press, in the unit shown. */
  step?: number | undefined;
  commit(value: NumberOrExpression | undefined): void;
}

const PIXELS_PER_STEP = 4;

export function numberOf(value: NumberOrExpression | undefined, fallback: number): number {
  if (value === undefined) return fallback;
  if (typeof value === 'number') return value;
  try {
    return evaluateNumber(value);
  } catch {
    return fallback;
  }
}

export function useNumberField(spec: NumberSpec) {
  const ui = useUi();
  const [typed, setTyped] = useState<string | null>(null);
  const [error, setError] = useState<string | null>(null);
  const drag = useRef<{ x: number; from: number; moved: boolean } | null>(null);
  const text = typed ?? formatField(spec.value, spec.angle);
  const rest = spec.rest ?? 0;
  const step = spec.step ?? (spec.angle ? 1 : naturalStep(numberOf(spec.base, rest) || rest));
  const differs =
    numberOf(spec.value, rest) !== numberOf(spec.base, rest) ||
    (spec.value === undefined) !== (spec.base === undefined);

  const settle = (problem: string | null, keep: string | null) => {
    setTyped(keep);
    setError(problem);
    setRejected(ui, spec.path, problem);
  };
  // A value set from elsewhere (another case, a reset) takes the place of rejected text: at once, as what is typed after it must stay.
  useLayoutEffect(() => settle(null, null), [spec.value, ui.epoch.value]);
  useLayoutEffect(() => () => setRejected(ui, spec.path, null), []);

  const accept = (): boolean => {
    if (typed === null) return error === null;
    const parsed = parseField(typed, spec, evaluateNumber);
    if (!parsed.ok) {
      settle(parsed.error, typed);
      return false;
    }
    settle(null, null);
    if (typed !== formatField(spec.value, spec.angle)) spec.commit(parsed.stored);
    return true;
  };

  const move = (from: number, steps: number) => {
    let shown = nudge(from, step, steps);
    const lower = spec.min ?? (spec.positive ? step / 1000 : undefined);
    if (lower !== undefined) shown = Math.max(shown, toShown(lower, spec.angle));
    if (spec.max !== undefined) shown = Math.min(shown, toShown(spec.max, spec.angle));
    settle(null, null);
    spec.commit(storedFromShown(shown, spec));
  };
  const shownNow = () => {
    const parsed = typed === null ? null : parseField(typed, spec, evaluateNumber);
    return nudge(
      toShown(parsed?.ok && parsed.value !== undefined ? parsed.value : numberOf(spec.value, rest), spec.angle),
      0,
      0,
    );
  };

  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Enter') {
      accept();
    } else if (event.key === 'Escape' && (typed !== null || error)) {
      event.stopPropagation();
      settle(null, null);
    } else {
      const stepping = commandFor(fieldCommands, event, ui.app, 'field');
      if (!stepping) return;
      event.preventDefault();
      const factor = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
      move(shownNow(), stepping.id === 'value-up' ? factor : -factor);
    }
  };

  const scrub = {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      drag.current = { x: event.clientX, from: shownNow(), moved: false };
    },
    onPointerMove(event: PointerEvent) {
      const now = drag.current;
      if (!now) return;
      const steps = Math.round((event.clientX - now.x) / PIXELS_PER_STEP);
      if (steps === 0 && !now.moved) return;
      now.moved = true;
      move(now.from, steps * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1));
    },
    onPointerUp() {
      drag.current = null;
    },
    onPointerCancel() {
      drag.current = null;
    },
  };

  return {
    text,
    error: error ?? ui.app.state.draftErrors.value.get(spec.path) ?? null,
    differs,
    scrub,
    reset: () => {
      settle(null, null);
      spec.commit(spec.base);
    },
    input: {
      value: text,
      onInput: (event: { currentTarget: HTMLInputElement }) => setTyped(event.currentTarget.value),
      onBlur: () => void accept(),
      onKeyDown,
    },
  };
}
