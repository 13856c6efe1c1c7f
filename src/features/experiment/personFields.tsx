/** The rider's parameters by height and mass. */
import { riderOf, type Person } from '../../core/systems/ripstik-rider/person.ts';
import { parameterDefault, withEntry } from '../../app/state/draft.ts';
import { edit, useUi } from '../../ui/context.ts';
import { PersonInputs } from '../../ui/kit/personInputs.tsx';
import { words } from './words.ts';

/** Heights that are looked through for the one that the parameters are of, cm. */
const [SHORTEST, TALLEST] = [100, 230] as const;

type Values = Readonly<Record<string, number>>;

/**
 * Whose body the parameters are, to the centimetre; null where they are nobody's.
 *
 * @param values the rider's parameters, SI
 * @param make what they are of a person
 */
export function personOf(values: Values, make: (person: Person) => Values): Person | null {
  const mass = values['riderMass']!;
  for (let height = SHORTEST; height <= TALLEST; height++) {
    const person = { height: height / 100, mass };
    if (Object.entries(make(person)).every(([name, value]) => values[name] === value)) return person;
  }
  return null;
}

export function PersonFields() {
  const ui = useUi();
  const meta = ui.system.value?.meta;
  const draft = ui.app.state.draft.value;
  if (!meta) return null;
  const set = draft.parameterSet ?? Object.keys(meta.parameterSets)[0];
  const standard = (name: string): number => parameterDefault(meta, set, name);
  // A formula stands for no number here: then the parameters are nobody's.
  const valueOf = (name: string): number => {
    const own = draft.parameters?.[name] ?? standard(name);
    return typeof own === 'number' ? own : NaN;
  };
  const make = (person: Person): Values => {
    const [offset, thickness] = [valueOf('plateOffset'), valueOf('plateThickness')];
    return riderOf(person, ...(Number.isFinite(offset + thickness) ? [offset, thickness] : []));
  };
  const names = Object.keys(make({ height: 1.75, mass: 75 }));
  const person = personOf(Object.fromEntries(names.map((name) => [name, valueOf(name)])), make);
  const take = (next: Person | null): void => {
    const body = next && make(next);
    edit(ui, words.person, (now) =>
      names.reduce((draft, name) => {
        const value = body?.[name];
        return withEntry(draft, 'parameters', name, value === standard(name) ? undefined : value);
      }, now),
    );
  };
  return (
    <div class="person-fields">
      <PersonInputs person={person} testId="person" onChange={take} />
      <p class="hint">{words.personHint}</p>
    </div>
  );
}
