/** A test of one's own, by fields: what is measured of a run of the scenario, and between what. */
import { useSignal } from '@preact/signals';
import { FACTS, KINDS } from '../../core/manoeuvres/measure.ts';
import { parseTests, type Test } from '../../core/manoeuvres/testFile.ts';
import { words } from './words.ts';

/** A number where it is one, else the expression as typed; null for none. */
const bound = (text: string): number | string | null => {
  const plain = text.trim().replace('\u2212', '-').replace(',', '.');
  if (plain === '') return null;
  return Number.isFinite(Number(plain)) ? Number(plain) : plain;
};

/**
 * @param text the tests as they stand
 * @param test what is added behind them
 * @throws ScenarioError where either is wrong
 */
export function withTest(text: string, test: Test): string {
  const file =
    text.trim() === '' ? { version: 1 as const, tests: [] } : (JSON.parse(text) as { version: 1; tests: Test[] });
  const longer = JSON.stringify({ ...file, tests: [...file.tests, test] }, null, 1);
  parseTests(longer);
  return longer;
}

export function AddTest({ text, example, put }: { text: string; example: string; put: (text: string) => void }) {
  const name = useSignal('');
  const kind = useSignal<string>('max');
  const of = useSignal('');
  const [least, most] = [useSignal(''), useSignal('')];
  const problem = useSignal('');
  const isFact = (FACTS as readonly string[]).includes(kind.value);
  const add = (): void => {
    try {
      put(
        withTest(text, {
          name: name.value,
          measure: isFact ? kind.value : `${kind.value}(${of.value})`,
          bound: [bound(least.value), bound(most.value)],
        }),
      );
      problem.value = '';
      for (const field of [name, of, least, most]) field.value = '';
    } catch (error) {
      problem.value = (error as Error).message.replace(/^tests\[\d+\]\.?/, '');
    }
  };
  const field = (label: string, value: typeof name, id: string, hint: string) => (
    <label>
      {label}
      <input
        value={value.value}
        data-testid={id}
        placeholder={hint}
        spellcheck={false}
        autocomplete="off"
        onInput={(event) => (value.value = event.currentTarget.value)}
      />
    </label>
  );
  return (
    <details>
      <summary>{words.add}</summary>
      <form
        class="add-test"
        data-testid="add-test"
        onSubmit={(event) => {
          event.preventDefault();
          add();
        }}
      >
        {field(words.addName, name, 'add-name', words.addNameHint)}
        <label>
          {words.addMeasure}
          <select
            value={kind.value}
            data-testid="add-kind"
            onChange={(event) => (kind.value = event.currentTarget.value)}
          >
            {KINDS.map((id) => (
              <option key={id} value={id}>
                {words.kinds[id]}
              </option>
            ))}
            {FACTS.map((id) => (
              <option key={id} value={id}>
                {words.facts[id]}
              </option>
            ))}
          </select>
        </label>
        {!isFact && field(words.addOf, of, 'add-of', example)}
        {field(words.addLeast, least, 'add-least', words.addNone)}
        {field(words.addMost, most, 'add-most', words.addNone)}
        <button type="submit" data-testid="add-go">
          {words.addGo}
        </button>
      </form>
      <p class="hint">{words.addNote(example)}</p>
      {problem.value && (
        <p class="error" role="alert">
          {problem.value}
        </p>
      )}
    </details>
  );
}
