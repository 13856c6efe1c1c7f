import { glossary } from '../../ui/glossary.ts';

/** The words of the field, by the alphabet. */
export function Terms() {
  return (
    <dl class="terms" data-testid="terms">
      {glossary.map(({ id, term, meaning }) => (
        <div key={id}>
          <dt>{term}</dt>
          <dd>{meaning}</dd>
        </div>
      ))}
    </dl>
  );
}
