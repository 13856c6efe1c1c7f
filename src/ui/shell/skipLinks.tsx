/** The first stops of the Tab key: past the bars to what one came for. The address stays as it is. */
import { skipText } from '../../app/words.ts';

const GOALS = [
  { id: 'stage', label: skipText.scene },
  { id: 'playback', label: skipText.playback },
] as const;

export function SkipLinks() {
  return (
    <nav class="skips" aria-label={skipText.label}>
      {GOALS.map(({ id, label }) => (
        <a
          key={id}
          class="skip"
          href={`#${id}`}
          data-testid={`skip-${id}`}
          onClick={(event) => {
            event.preventDefault();
            document.getElementById(id)?.focus();
          }}
        >
          {label}
        </a>
      ))}
    </nav>
  );
}
