/** The first minute of a first visit: loaded when there is something to offer, never again after it was taken or put away. */
import { signal, useComputed, useSignal } from '@preact/signals';
import type { ComponentType, ComponentProps } from 'preact';
import { useEffect } from 'preact/hooks';
import { browserStorage } from '../../app/persistence/browserStorage.ts';
import { useUi } from '../../ui/context.ts';
import type { WelcomeView } from './offer.tsx';
import { text } from './words.ts';

const SEEN = 'tour';
/** Whether the tour is on: the sheet of keys starts it, too. */
const touring = signal(false);

/** Who comes by a link or with a file came for that. */
const firstVisit = (): boolean =>
  location.hash === '' &&
  location.search === '' &&
  browserStorage.text(SEEN) === null &&
  browserStorage.text('work') === null;

export function Welcome() {
  const { state } = useUi().app;
  const offered = useSignal(firstVisit());
  // Who rides, or has opened a file, has found something to do.
  const riding = state.motion.value?.written?.control?.type === 'ride';
  const wanted =
    useComputed(() => {
      const motion = state.motion.value;
      return touring.value || (offered.value && motion !== null && motion.source !== 'file');
    }).value && !riding;
  const view = useSignal<ComponentType<ComponentProps<typeof WelcomeView>> | null>(null);
  useEffect(() => {
    if (wanted && !view.value)
      void import('./offer.tsx').then(
        (part) => {
          view.value = part.WelcomeView;
        },
        () => {},
      );
  }, [wanted]);
  const end = () => {
    browserStorage.putText(SEEN, 'seen');
    offered.value = false;
    touring.value = false;
  };
  const View = view.value;
  return wanted && View ? (
    <View
      touring={touring.value}
      onTour={() => {
        touring.value = true;
      }}
      onEnd={end}
    />
  ) : null;
}

/** Under the sheet of keys. */
export function TakeTour({ close }: { close(): void }) {
  return (
    <button
      type="button"
      data-testid="take-tour"
      onClick={() => {
        close();
        touring.value = true;
      }}
    >
      {text.ofThePage}
    </button>
  );
}
