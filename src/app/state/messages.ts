import { signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from './signals.ts';

export interface MessageAction {
  label: string;
  run(): void;
}

export interface Message {
  id: number;
  kind: 'info' | 'warning' | 'error';
  title: string;
  /** What it is about: a newer one of the same takes its place. */
  topic: string;
  /** What happened, where, what to do. */
  details: readonly string[];
  /** What the person may do about it with one press. */
  action?: MessageAction;
}

/** More are too many to read: the oldest goes. */
const MOST_MESSAGES = 5;

export interface MessageState {
  messages: ReadonlySignal<readonly Message[]>;
}

export interface MessageActions {
  /**
   * Tells the person something.
   *
   * @param topic where the title names things: what the message is about
   */
  report(
    kind: Message['kind'],
    title: string,
    details: readonly string[],
    action?: MessageAction,
    topic?: string,
  ): void;
  dismiss(messageId: number): void;
}

export interface MessagesSlice {
  state: MessageState;
  actions: MessageActions;
}

/** What the page has to say; newest last. */
export function createMessages(): MessagesSlice {
  const messages = signal<readonly Message[]>([]);
  let next = 1;
  return {
    state: { messages: readonly(messages) },
    actions: {
      report(kind, title, details, action, topic = title) {
        const message = { id: next++, kind, title, topic, details, ...(action ? { action } : {}) };
        const others = messages.peek().filter((one) => one.topic !== topic);
        messages.value = [...others, message].slice(-MOST_MESSAGES);
      },
      dismiss: (id) => void (messages.value = messages.peek().filter((m) => m.id !== id)),
    },
  };
}
