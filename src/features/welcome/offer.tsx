/** What a first visit is offered, in the stage's corner: one thing to try, and the tour. */
import { text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Icon } from '../../ui/kit/controls.tsx';
import { Tour } from './tour.tsx';
import './welcome.css';

const TO_TRY = 'balanced';

export function WelcomeView({ touring, onTour, onEnd }: { touring: boolean; onTour(): void; onEnd(): void }) {
  const ui = useUi();
  if (touring) return <Tour onEnd={onEnd} />;
  const balance = () => {
    onEnd();
    ui.app.actions.loadCase(TO_TRY);
    document.getElementById('stage')?.focus();
  };
  return (
    <aside class="offer" aria-label={text.offer} data-testid="offer">
      <p>{text.try}</p>
      <div class="offer-buttons">
        <button type="button" class="primary" data-testid="offer-try" onClick={balance}>
          {text.balance}
        </button>
        {ui.commands.some(({ id }) => id === 'ride') && (
          <button
            type="button"
            data-testid="offer-ride"
            onClick={() => {
              onEnd();
              ui.commands.find(({ id }) => id === 'ride')?.perform?.(ui.app);
              document.getElementById('stage')?.focus();
            }}
          >
            {text.ride}
          </button>
        )}
        <button type="button" data-testid="offer-tour" onClick={onTour}>
          {text.take}
        </button>
      </div>
      <button
        type="button"
        class="quiet square offer-close"
        aria-label={text.dismiss}
        title={text.dismiss}
        data-testid="offer-close"
        onClick={() => {
          onEnd();
          document.getElementById('stage')?.focus();
        }}
      >
        <Icon name="close" />
      </button>
    </aside>
  );
}
