/** The push without a pointer: buttons and keys that push at a body in steps. */
import { useEffect, useId, useMemo, useRef, useState } from 'preact/hooks';
import { createKeyboardPusher, type Force, type KeyboardPush } from '../../app/push/keyboardPush.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import './pushPad.css';
import { commandFor } from '../../app/commands.ts';
import { padCommands, wayOf, ways, type Way } from './commands.ts';
import { words as text } from './words.ts';
import { useUi } from '../../ui/context.ts';
import { Icon, type IconName } from '../../ui/kit/controls.tsx';
import { formatShort } from '../../ui/kit/format.ts';

const WAYS: Readonly<Record<Way, { force: Force; icon: IconName }>> = {
  ahead: { force: [1, 0, 0], icon: 'up' },
  back: { force: [-1, 0, 0], icon: 'below' },
  left: { force: [0, 1, 0], icon: 'before' },
  right: { force: [0, -1, 0], icon: 'after' },
  up: { force: [0, 0, 1], icon: 'raise' },
  down: { force: [0, 0, -1], icon: 'lower' },
};

/** What a person would push first: the first of two like bodies, else the first body. */
const firstOf = ({ bodies }: SystemMeta): string => (bodies.find(({ role }) => role === 'first') ?? bodies[0]!).id;

export function PushPad() {
  const { app } = useUi();
  const { state, actions } = app;
  const pusher = useMemo(() => createKeyboardPusher(state, actions), []);
  const meta = state.motion.value!.system.meta;
  const [chosen, choose] = useState(() => firstOf(meta));
  const body = meta.bodies.some(({ id }) => id === chosen) ? chosen : firstOf(meta);
  const root = useRef<HTMLDivElement>(null);
  const id = useId();
  const toggle = () => document.querySelector<HTMLElement>('[data-testid=toggle-push]');
  useEffect(() => {
    if (document.activeElement !== toggle()) root.current!.querySelector('button')!.focus();
    return () => {
      if (root.current?.contains(document.activeElement)) toggle()?.focus();
      pusher.dispose();
    };
  }, []);
  const onKeyDown = (event: KeyboardEvent) => {
    const command = commandFor(padCommands, event, app, 'push-pad');
    const way = command && wayOf(command);
    // The list of bodies keeps its arrows.
    if (!command || (way && event.target instanceof HTMLSelectElement)) return;
    if (way) pusher.press(body, WAYS[way].force);
    else if (pusher.current.peek()) pusher.release();
    else {
      toggle()?.focus();
      actions.set('dragPushes', false);
    }
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="push-row">
      <div
        class="push-pad"
        ref={root}
        role="group"
        aria-label={text.title}
        aria-describedby={id}
        data-testid="push-pad"
        onKeyDown={onKeyDown}
      >
        <div class="push-keys">
          {ways.map((way) => (
            <button
              key={way}
              type="button"
              class={`quiet square push-${way}`}
              aria-label={text.ways[way]}
              title={text.ways[way]}
              data-testid={`push-${way}`}
              onClick={() => pusher.press(body, WAYS[way].force)}
            >
              <Icon name={WAYS[way].icon} />
            </button>
          ))}
          <button
            type="button"
            class="quiet square push-none"
            aria-label={text.release}
            title={text.release}
            data-testid="push-none"
            onClick={pusher.release}
          >
            <Icon name="close" />
          </button>
        </div>
        <label class="push-body">
          <span class="hidden">{text.body}</span>
          <select
            value={body}
            data-testid="push-body"
            onChange={(event) => {
              pusher.release();
              choose(event.currentTarget.value);
            }}
          >
            {meta.bodies.map((one) => (
              <option key={one.id} value={one.id}>
                {one.label}
              </option>
            ))}
          </select>
        </label>
        <p class="push-force" role="status" data-testid="push-force">
          {inWords(pusher.current.value, meta)}
        </p>
        <p class="push-hint" id={id}>
          {text.hint}
        </p>
      </div>
    </div>
  );
}

function inWords(push: KeyboardPush | null, { bodies }: SystemMeta): string {
  if (!push) return text.nothing;
  const forces = push.force.flatMap((newtons, i) =>
    newtons === 0 ? [] : [text.newtons(formatShort(Math.abs(newtons), 4), text.towards[i]![newtons > 0 ? 0 : 1])],
  );
  return text.pulls(bodies.find(({ id }) => id === push.body)?.label ?? push.body, forces.join(', ') || text.balanced);
}
