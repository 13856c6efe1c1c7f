/** An expression of t, on a line of its own. */
import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { compileExpression } from '../../core/scenario/expressions.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { useUi } from '../context.ts';
import { plainText } from './format.ts';
import { FieldError } from './numberField.tsx';
import { words } from './words.ts';

function problemOf(expression: string): string | null {
  try {
    compileExpression(expression, { variables: ['t'] });
    return null;
  } catch (problem) {
    return problem instanceof Error ? problem.message : String(problem);
  }
}

export function ExpressionField({
  path,
  symbol,
  label,
  shown = label,
  unit,
  value,
  base,
  placeholder = '0',
  testId,
  commit,
}: {
  path: string;
  symbol: ComponentChildren;
  label: string;
  /** The label as it is set, when it holds symbols. */
  shown?: ComponentChildren;
  unit: string;
  value: NumberOrExpression | undefined;
  base: NumberOrExpression | undefined;
  placeholder?: string;
  testId?: string;
  commit(value: NumberOrExpression | undefined): void;
}) {
  const { state, actions } = useUi().app;
  const id = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const [own, setOwn] = useState<string | null>(null);
  /** What was in force before typing began, and what typing put in force. */
  const before = useRef<{ value: NumberOrExpression | undefined } | null>(null);
  const mine = useRef<NumberOrExpression | null>(null);
  const settle = (problem: string | null, keep: string | null) => {
    if (keep === null) before.current = mine.current = null;
    setTyped(keep);
    setOwn(problem);
    actions.refuseField(path, problem);
  };
  useLayoutEffect(() => {
    if (mine.current === null || mine.current !== value) settle(null, null);
  }, [value]);
  useLayoutEffect(() => settle(null, null), [state.draftEpoch.value]);
  useLayoutEffect(() => () => actions.refuseField(path, null), []);

  const stored = (plain: string): NumberOrExpression | undefined =>
    plain === '' ? undefined : Number.isFinite(Number(plain)) ? Number(plain) : plain;
  /** What can be computed is in force while more is typed. */
  const onInput = (text: string) => {
    before.current ??= { value };
    setTyped(text);
    const plain = plainText(text);
    if (plain === '' || problemOf(plain) !== null || plain === String(value ?? '')) return;
    mine.current = stored(plain)!;
    commit(mine.current);
  };
  const giveUp = () => {
    const was = before.current;
    settle(null, null);
    if (was && was.value !== value) commit(was.value);
  };

  const accept = () => {
    if (typed === null) return;
    const plain = plainText(typed);
    const problem = plain === '' ? null : problemOf(plain);
    settle(problem, problem === null ? null : typed);
    if (problem !== null || plain === String(value ?? '')) return;
    commit(stored(plain));
  };
  const error = own ?? state.draftErrors.value.get(path) ?? null;
  return (
    <div class="field expression">
      <span class="handle still">{symbol}</span>
      <label for={id} class="name">
        {shown}, {unit}
      </label>
      <span class={`box${error ? ' bad' : ''}`}>
        {String(value ?? '') !== String(base ?? '') && (
          <button
            type="button"
            class="dot"
            title={words.differs(label)}
            aria-label={words.differs(label)}
            onClick={() => {
              settle(null, null);
              commit(base);
            }}
          />
        )}
        <input
          id={id}
          type="text"
          autocomplete="off"
          spellcheck={false}
          value={typed ?? String(value ?? '')}
          placeholder={placeholder}
          aria-invalid={error ? 'true' : undefined}
          aria-describedby={error ? `${id}-error` : undefined}
          data-testid={testId}
          data-path={path}
          onInput={(event) => onInput(event.currentTarget.value)}
          onBlur={accept}
          onKeyDown={(event) => {
            if (event.key === 'Enter') accept();
            const undoes = (event.ctrlKey || event.metaKey) && !event.shiftKey && event.key.toLowerCase() === 'z';
            const refused = own !== null || (typed !== null && problemOf(plainText(typed)) !== null);
            if (undoes && refused) event.preventDefault();
            if ((event.key === 'Escape' && typed !== null) || (undoes && refused)) giveUp();
          }}
        />
      </span>
      <FieldError id={id} error={error} />
    </div>
  );
}
