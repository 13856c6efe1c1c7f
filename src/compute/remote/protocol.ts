/** The messages between the page and its workers, and how a call is typed. Nothing here knows what is called. */

/**
 * One remote call: what is asked, what is answered, what the worker tells meanwhile (`event`) and what the page may say
 * to a call under way (`update`). A service lists its calls as an interface of these, by name `service.call`.
 */
export interface Call<Request, Result, Event = never, Update = never> {
  request: Request;
  result: Result;
  event: Event;
  update: Update;
}

export type AnyCall = Call<unknown, unknown, unknown, unknown>;
/** Any interface whose members are calls. */
export type Calls<T> = { [K in keyof T]: AnyCall };

/** Page to worker. Every message names its call by a number that is never used again. */
export type ToWorker =
  /** With a `channel`, all that the worker says of the call comes through the `BroadcastChannel` of that name. */
  | { kind: 'call'; call: number; name: string; request: unknown; channel?: string | undefined }
  | { kind: 'update'; call: number; update: unknown }
  /** Please end soon, with an answer. */
  | { kind: 'abort'; call: number }
  /** Please end soon; nothing of this call is heard any more. */
  | { kind: 'drop'; call: number };

/** Worker to page. */
export type FromWorker =
  | { kind: 'event'; call: number; event: unknown }
  | { kind: 'result'; call: number; result: unknown }
  | { kind: 'error'; call: number; error: ErrorData }
  /** A message of the page could not be read, so that a call may wait for ever. */
  | { kind: 'unreadable' };

/** What of an error crosses over. `path` is that of a `ScenarioError`: the scenario's key that it is about. */
export interface ErrorData {
  name: string;
  message: string;
  path: string;
}

/** What both ends need of a worker, of its scope, or of a message port. */
export interface Endpoint {
  postMessage(message: unknown, transfer: Transferable[]): void;
  addEventListener(type: 'message' | 'messageerror', listener: (event: MessageEvent) => void): void;
}
