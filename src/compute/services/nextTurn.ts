const scope = globalThis as { setImmediate?: (then: () => void) => void };

/**
 * Lets other messages have their turn, then goes on. A message to oneself does it: unlike a timer it is not throttled.
 * Node (tests) hands out all messages of a port in one go, those that come meanwhile too, and has `setImmediate` for this.
 */
export const nextTurn: () => Promise<void> = scope.setImmediate
  ? () => new Promise((resolve) => scope.setImmediate!(resolve))
  : byMessage();

function byMessage(): () => Promise<void> {
  const turns: (() => void)[] = [];
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => turns.shift()?.();
  return () =>
    new Promise((resolve) => {
      turns.push(resolve);
      port2.postMessage(null);
    });
}
