/** In the status line: to how many digits the run is right, until when. */
import { useUi } from '../../ui/context.ts';
import { formatScientific } from '../../ui/kit/format.ts';
import { saidOf } from './said.ts';
import { words } from './words.ts';

export function TrustStatus() {
  const { state, actions } = useUi().app;
  const known = state.trust.value;
  if (!known) return null;
  if (known.kind === 'asks')
    return (
      <button
        type="button"
        class="link"
        data-testid="trust-ask"
        title={words.askTitle}
        onClick={() => actions.compareRun()}
      >
        {words.ask}
      </button>
    );
  if (known.kind === 'comparing')
    return (
      <span class="trust" data-testid="trust-comparing">
        {words.comparing(Math.floor(100 * known.share))}
      </span>
    );
  const { against, compared } = known.trust;
  return (
    <span
      class="trust"
      data-testid="trust"
      data-until={known.trust.until[4]}
      title={words.title(against.name, formatScientific(against.rtol, 0), words.seconds(compared))}
    >
      {saidOf(known.trust)}
    </span>
  );
}
