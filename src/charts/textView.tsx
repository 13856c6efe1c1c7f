import type { Text } from '../core/motion/symbols.ts';

/** Typeset text in the page. */
export function TextView({ of }: { of: Text }) {
  return (
    <span class="typeset">
      {of.map((run, i) =>
        run.sub ? (
          <sub key={i} class={classOf(run)}>
            {run.text}
          </sub>
        ) : (
          <span key={i} class={classOf(run)}>
            {run.text}
          </span>
        ),
      )}
    </span>
  );
}

const classOf = ({ text, math, dot }: Text[number]): string | undefined =>
  [math && 'math', dot && 'dot', dot && /[A-Z]/.test(text) && 'capital'].filter(Boolean).join(' ') || undefined;
