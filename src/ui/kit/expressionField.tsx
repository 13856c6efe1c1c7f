/** An expression of t, on a line of its own. */
import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useState } from 'preact/hooks';
import { compileExpression } from '../../core/scenario/expressions.ts';
import type { NumberOrExpression } from '../../core/scenario/types.ts';
import { setRejected, useUi } from '../context.ts';
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
  const ui = useUi();
  const id = useId();
  const [typed, setTyped] = useState<string | null>(null);
  const [own, setOwn] = useState<string | null>(null);
  const settle = (problem: string | null, keep: string | null) => {
    setTyped(keep);
    setOwn(problem);
    setRejected(ui, path, problem);
  };
  useLayoutEffect(() => settle(null, null), [value, ui.epoch.value]);
  useLayoutEffect(() => () => setRejected(ui, path, null), []);

  const accept = () => {
    if (typed === null) return;
    const plain = plainText(typed);
    const problem = plain === '' ? null : problemOf(plain);
    settle(problem, problem === null ? null : typed);
    if (problem !== null || plain === String(value ?? '')) return;
    commit(plain === '' ? undefined : Number.isFinite(Number(plain)) ? Number(plain) : plain);
  };
  const error = own ?? ui.app.state.draftErrors.value.get(path) ?? null;
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
          onInput={(event) => setTyped(event.currentTarget.value)}
          onBlur={accept}
          onKeyDown={(event) => {
            if (event.key === 'Enter') accept();
            if (event.key === 'Escape' && typed !== null) settle(null, null);
          }}
        />
      </span>
      <FieldError id={id} error={error} />
    </div>
  );
}
