/** A field's behaviour: typed text, errors, stepping, scrubbing. What it looks like is `numberField.tsx`. */
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { evaluateNumber } from '../../core/scenario/expressions.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { commandFor } from '../../app/commands.ts';
import { useUi } from '../context.ts';
import { fieldCommands } from './fieldCommands.ts';
import {
  formatField,
  formatQuantity,
  naturalStep,
  nudge,
  parseField,
  PLAIN_NUMBER,
  plainText,
  restingText,
  storedFromShown,
  toShown,
} from './format.ts';
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
  /** A field that is no part of the draft: it is committed when it is left, and this is told whether its text is refused. */
  aside?(reason: string | null): void;
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
  const { app } = useUi();
  const [typed, setTyped] = useState<string | null>(null);
  const [error, setError] = useState<string | null>(null);
  const [focused, setFocused] = useState(false);
  const drag = useRef<{ x: number; from: number; moved: boolean } | null>(null);
  const dragged = useRef(false);
  /** What was in force before typing began, and the number that typing put in force. */
  const before = useRef<{ value: NumberOrExpression | undefined } | null>(null);
  const own = useRef<number | null>(null);
  const rest = spec.rest ?? 0;
  const text = typed ?? formatField(spec.value, spec.angle);
  const step = spec.step ?? (spec.angle ? 1 : naturalStep(numberOf(spec.base, rest) || rest));
  const differs =
    numberOf(spec.value, rest) !== numberOf(spec.base, rest) ||
    (spec.value === undefined) !== (spec.base === undefined);

  const refuse = spec.aside ?? ((reason: string | null) => app.actions.refuseField(spec.path, reason));
  const settle = (problem: string | null, keep: string | null) => {
    setTyped(keep);
    setError(problem);
    refuse(problem);
    if (keep === null) before.current = own.current = null;
  };
  // A value set from elsewhere (another case, a reset, an undo) takes the place of what stands there: at once, as what is typed after it must stay.
  useLayoutEffect(() => {
    if (own.current === null || own.current !== numberOf(spec.value, NaN)) settle(null, null);
  }, [spec.value]);
  useLayoutEffect(() => settle(null, null), [app.state.draftEpoch.value]);
  useLayoutEffect(() => () => refuse(null), []);

  const parsed = typed === null ? null : parseField(typed, spec, evaluateNumber);

  /** A number that is whole is in force while more is typed; what is not yet one waits until the field is left. */
  const onInput = ({ currentTarget: { value } }: { currentTarget: HTMLInputElement }) => {
    before.current ??= { value: spec.value };
    setTyped(value);
    if (spec.aside) return;
    const now = parseField(value, spec, evaluateNumber);
    if (!now.ok || now.value === undefined || now.value === numberOf(spec.value, NaN)) return;
    own.current = now.value;
    spec.commit(now.stored);
  };

  const accept = (): boolean => {
    if (typed === null) return error === null;
    if (!parsed!.ok) {
      settle(parsed!.error, typed);
      return false;
    }
    settle(null, null);
    if (typed !== formatField(spec.value, spec.angle) && !Object.is(parsed!.stored, spec.value))
      spec.commit(parsed!.stored);
    return true;
  };

  /** Back to what was in force before typing. */
  const giveUp = () => {
    const was = before.current;
    settle(null, null);
    if (was && !Object.is(was.value, spec.value)) spec.commit(was.value);
  };

  const set = (shown: number) => {
    const lower = spec.min ?? (spec.positive ? step / 1000 : undefined);
    let within = lower === undefined ? shown : Math.max(shown, toShown(lower, spec.angle));
    if (spec.max !== undefined) within = Math.min(within, toShown(spec.max, spec.angle));
    settle(null, null);
    spec.commit(storedFromShown(within, spec));
  };
  const move = (from: number, steps: number) => set(nudge(from, step, steps));
  const shownNow = () =>
    nudge(
      toShown(parsed?.ok && parsed.value !== undefined ? parsed.value : numberOf(spec.value, rest), spec.angle),
      0,
      0,
    );

  const onKeyDown = (event: KeyboardEvent) => {
    const undoes = (event.ctrlKey || event.metaKey) && !event.shiftKey && event.key.toLowerCase() === 'z';
    if (event.key === 'Enter') {
      accept();
    } else if (event.key === 'Escape' && (typed !== null || error)) {
      event.stopPropagation();
      giveUp();
    } else if (undoes && (error !== null || parsed?.ok === false)) {
      // Text that is not in force is the last change there is.
      event.preventDefault();
      giveUp();
    } else {
      const stepping = commandFor(fieldCommands, event, app, 'field');
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
      dragged.current = false;
    },
    onPointerMove(event: PointerEvent) {
      const now = drag.current;
      if (!now) return;
      const steps = Math.round((event.clientX - now.x) / PIXELS_PER_STEP);
      if (steps === 0 && !now.moved) return;
      now.moved = dragged.current = true;
      move(now.from, steps * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1));
    },
    onPointerUp() {
      drag.current = null;
    },
    onPointerCancel() {
      drag.current = null;
    },
  };

  const written = plainText(text);
  const meant = parsed ? (parsed.ok ? parsed.value : undefined) : numberOf(spec.value, NaN);
  return {
    text,
    error: error ?? app.state.draftErrors.value.get(spec.path) ?? null,
    /** What an expression comes to, in the field's unit; null where the text says it. */
    meaning:
      written === '' || PLAIN_NUMBER.test(written) || meant === undefined || !Number.isFinite(meant) || error !== null
        ? null
        : `= ${formatQuantity(meant, spec.unit ?? '')}`,
    differs,
    scrub,
    /** What a slider needs; the values are in the unit shown. */
    slider: { shownNow, set, step },
    /** Whether a press on the handle was a drag. */
    wasDragged: () => dragged.current,
    reset: () => {
      settle(null, null);
      spec.commit(spec.base);
    },
    input: {
      value: focused || typed !== null ? text : restingText(text),
      onInput,
      onFocus({ currentTarget: input }: { currentTarget: HTMLInputElement }) {
        setFocused(true);
        if (input.value === text) return;
        input.value = text;
        input.select();
      },
      onBlur() {
        setFocused(false);
        accept();
      },
      onKeyDown,
    },
  };
}

export type NumberFieldState = ReturnType<typeof useNumberField>;
