import type { Message } from '../../app/state/messages.ts';
import { useEffect } from 'preact/hooks';
import { useUi } from '../context.ts';
import { Icon } from '../kit/controls.tsx';
import { text } from '../words.ts';

const LINGER = 6000;

/** What happened, where, what to do. Errors and warnings stay until they are dismissed. */
export function Messages() {
  const { state } = useUi().app;
  return (
    <section class="messages" aria-label={text.message.label}>
      {state.messages.value.map((message) => (
        <Toast key={message.id} message={message} />
      ))}
    </section>
  );
}

function Toast({ message }: { message: Message }) {
  const { actions } = useUi().app;
  useEffect(() => {
    if (message.kind !== 'info' || message.action) return;
    const timer = setTimeout(() => actions.dismiss(message.id), LINGER);
    return () => clearTimeout(timer);
  }, [message.id]);
  return (
    <div class={`message ${message.kind}`} role={message.kind === 'error' ? 'alert' : 'status'} data-testid="message">
      <div>
        <p class="message-title">{message.title}</p>
        {message.details.map((line, i) => (
          <p key={i}>{line}</p>
        ))}
        {message.action && (
          <button
            type="button"
            class="message-action"
            onClick={() => {
              message.action!.run();
              actions.dismiss(message.id);
            }}
          >
            {message.action.label}
          </button>
        )}
      </div>
      <button
        type="button"
        class="quiet square"
        aria-label={text.message.dismiss}
        onClick={() => actions.dismiss(message.id)}
      >
        <Icon name="close" />
      </button>
    </div>
  );
}
