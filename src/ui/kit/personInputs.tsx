/** A person by height and mass: two numbers that stand for a body. */
import type { Person } from '../../core/systems/ripstik-rider/person.ts';

/** A person of ordinary size to begin with. */
const GROWN: Person = { height: 1.75, mass: 75 };
const SIZES = { height: [1, 2.3, 0.01, 'Height, m'], mass: [20, 200, 1, 'Mass, kg'] } as const;

interface PersonInputsProps {
  /** Null: somebody else, of numbers of their own. */
  person: Person | null;
  /** Of the fields, before `height` and `mass`. */
  testId: string;
  /** Null where a field was emptied. */
  onChange(person: Person | null): void;
}

/** What is not a height or a mass of somebody is not taken, and the browser says between what it must be. */
export function PersonInputs({ person, testId, onChange }: PersonInputsProps) {
  return (
    <>
      {(['height', 'mass'] as const).map((key) => {
        const [least, most, step, label] = SIZES[key];
        return (
          <label key={key} class="person-input">
            {label}{' '}
            <input
              type="number"
              min={least}
              max={most}
              step={step}
              placeholder={String(GROWN[key])}
              value={person?.[key] ?? ''}
              data-testid={`${testId}-${key}`}
              onChange={({ currentTarget }) => {
                const { value, valueAsNumber } = currentTarget;
                if (value === '' && currentTarget.validity.badInput !== true) onChange(null);
                else if (valueAsNumber >= least && valueAsNumber <= most)
                  onChange({ ...(person ?? GROWN), [key]: valueAsNumber });
                else currentTarget.reportValidity();
              }}
            />
          </label>
        );
      })}
    </>
  );
}
