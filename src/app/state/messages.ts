import type { Signal } from '@preact/signals';
import type { Message, MessageAction } from '../types.ts';

/** What the page has to say; newest last, oldest dropped when there are too many to read. */
export class Messages {
  private readonly list: Signal<readonly Message[]>;
  private next = 1;

  constructor(list: Signal<readonly Message[]>) {
    this.list = list;
  }

  add(kind: Message['kind'], title: string, details: readonly string[], action?: MessageAction): void {
    this.list.value = [
      ...this.list.peek(),
      { id: this.next++, kind, title, details, ...(action ? { action } : {}) },
    ].slice(-5);
  }

  dismiss(id: number): void {
    this.list.value = this.list.peek().filter((m) => m.id !== id);
  }
}
