import { isTall, symbolText, type Text, type TextRun } from '../core/motion/symbols.ts';
import './typeset.css';

/** Typeset text in the page. */
export function TextView({ of }: { of: Text }) {
  return (
    <span class="typeset">
      <Runs of={of} />
    </span>
  );
}

/** `α_fp` with its subscript, a rate with a dot, beside words that say the same for those who hear it. */
export function MathSymbol({ of, rate = false }: { of: string; rate?: boolean | undefined }) {
  return (
    <span class="typeset symbol" aria-hidden="true">
      <Runs of={symbolText(of, rate)} />
    </span>
  );
}

function Runs({ of }: { of: Text }) {
  return (
    <>
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
    </>
  );
}

const classOf = ({ text, math, dot }: TextRun): string | undefined =>
  [math && 'math', dot && 'dot', dot && isTall(text) && 'tall'].filter(Boolean).join(' ') || undefined;
