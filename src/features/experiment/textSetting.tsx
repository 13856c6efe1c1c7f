/** A part of the scenario that is typed as text of several lines; what cannot be read stays as typed, with what is wrong. */
import { useSignal } from '@preact/signals';

export function TextSetting<T extends object>({
  testId,
  label,
  rows,
  text,
  read,
  change,
}: {
  testId: string;
  label: string;
  rows: number;
  /** As it stands in the scenario. */
  text: string;
  /** What was typed, or in words why it is none. */
  read(text: string): T | string;
  change(value: T): void;
}) {
  const typed = useSignal<string | null>(null);
  const problem = useSignal('');
  const commit = (entered: string): void => {
    const value = read(entered);
    problem.value = typeof value === 'string' ? value : '';
    if (typeof value === 'string') return;
    typed.value = null;
    change(value);
  };
  return (
    <>
      <textarea
        data-testid={testId}
        aria-label={label}
        aria-invalid={problem.value !== ''}
        rows={rows}
        spellcheck={false}
        value={typed.value ?? text}
        onInput={(event) => (typed.value = event.currentTarget.value)}
        onChange={(event) => commit(event.currentTarget.value)}
      />
      {problem.value && (
        <p class="error" role="alert">
          {problem.value}
        </p>
      )}
    </>
  );
}
