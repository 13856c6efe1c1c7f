/** How long a run is, how finely it is written, and what ends it. */
import { MathSymbol } from '../../charts/textView.tsx';
import { DEFAULTS } from '../../core/scenario/defaults.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Choice, Section } from '../../ui/kit/controls.tsx';
import { withKey } from '../../app/state/draft.ts';
import { NumberField } from '../../ui/kit/numberField.tsx';
import { words } from './words.ts';
import type { NumberSpec } from '../../ui/kit/useNumberField.ts';

export function TimeSection() {
  const ui = useUi();
  const draft = ui.app.state.draft.value;
  const system = ui.system.value;
  const origin = ui.origin.value?.scenario;
  const spec = (key: 'duration' | 'outputStep'): NumberSpec => ({
    path: key,
    label: words[key],
    unit: 's',
    angle: false,
    numeric: true,
    positive: true,
    value: draft[key] ?? DEFAULTS[key],
    base: origin?.[key] ?? DEFAULTS[key],
    rest: DEFAULTS[key],
    step: key === 'duration' ? 1 : 0.001,
    commit: (value) =>
      edit(ui, words[key], (now) => withKey(now, key, value === DEFAULTS[key] ? undefined : (value as number))),
  });
  const constraints = draft.constraints ?? system?.meta.constraintSets[0]?.id;
  return (
    <Section title={words.time} open>
      <NumberField symbol={<MathSymbol of="T" />} spec={spec('duration')} testId="duration" />
      <NumberField symbol={<MathSymbol of="Δt" />} spec={spec('outputStep')} testId="output-step" />
      {system?.meta.touchdown && constraints !== 'none' && (
        <Choice
          label={words.touchdown(system.meta.touchdown.label)}
          value={draft.events?.['touchdown'] ?? 'stop'}
          testId="event-touchdown"
          options={[
            { id: 'stop', label: words.stop },
            { id: 'ignore', label: words.ignore },
          ]}
          error={ui.app.state.draftErrors.value.get('events.touchdown')}
          onChange={(id) =>
            edit(ui, words.touchdown(system.meta.touchdown!.label), (now) =>
              withKey(now, 'events', eventsWith(now.events, id === 'ignore')),
            )
          }
        />
      )}
    </Section>
  );
}

function eventsWith(
  events: Record<string, 'stop' | 'ignore'> | undefined,
  ignore: boolean,
): Record<string, 'stop' | 'ignore'> | undefined {
  const { touchdown: _, ...rest } = events ?? {};
  const next: Record<string, 'stop' | 'ignore'> = ignore ? { ...rest, touchdown: 'ignore' } : rest;
  return Object.keys(next).length > 0 ? next : undefined;
}
