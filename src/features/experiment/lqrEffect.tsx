/** What the regulator does in a whole run, beside what it did before the last change: largest inputs, work, cost. */
import { batch, useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { sameContent } from '../../app/state/draft.ts';
import { MathSymbol } from '../../charts/textView.tsx';
import type { RegulatorEffect } from '../../core/control/design/effect.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { useUi } from '../../ui/context.ts';
import { formatShort } from '../../ui/kit/format.ts';
import { Term } from '../../ui/kit/term.tsx';
import { text } from '../../ui/words.ts';
import { useRestedRegulator } from './useRestedRegulator.ts';
import { lqrWords as words } from './lqrWords.ts';

interface Known {
  draft: ScenarioFile;
  effect: RegulatorEffect;
}

export function LqrEffect() {
  const { app } = useUi();
  const meta = useUi().system.value!.meta;
  const now = useSignal<Known | null>(null);
  const before = useSignal<Known | null>(null);
  const waiting = useSignal(true);
  const forget = (): void => app.effect.forget('panel');
  useRestedRegulator(
    (draft) => {
      void app.effect.effect(draft, 'panel').then((found) => {
        if (!found) return;
        batch(() => {
          waiting.value = false;
          if (!found.ok) return;
          if (now.peek() && !sameContent(now.peek()!.draft, draft)) before.value = now.peek();
          now.value = { draft, effect: found.value };
        });
      });
    },
    () => {
      waiting.value = true;
      forget();
    },
    forget,
  );
  if (!now.value) return <p class="hint">{words.trying}</p>;
  const [present, earlier] = [now.value.effect, before.value?.effect];
  const inputs = new Map(meta.inputs.map((input) => [input.name, input]));
  const peakOf = (one: RegulatorEffect | undefined, name: string) =>
    one?.peaks.find((peak) => peak.name === name)?.value;
  const endOf = ({ reason, time }: RegulatorEffect) =>
    reason === 'end' ? '' : `${text.status.reasons[reason] ?? reason}, ${formatShort(time, 3)} s`;
  return (
    <table class={`effect${waiting.value ? ' waiting' : ''}`} data-testid="lqr-effect">
      <thead>
        <tr>
          <th scope="col">{words.effect}</th>
          <th scope="col">{words.before}</th>
          <th scope="col">{words.now}</th>
        </tr>
      </thead>
      <tbody>
        {present.peaks.map(({ name, value }) => (
          <Row key={name} before={peakOf(earlier, name)} now={value} unit={inputs.get(name)?.unit ?? ''}>
            {words.largest} <MathSymbol of={inputs.get(name)?.symbol ?? name} />
          </Row>
        ))}
        <Row before={earlier?.work} now={present.work} unit="J">
          {words.work}
        </Row>
        <Row before={earlier?.cost} now={present.cost} unit="">
          <Term id="cost">{words.cost}</Term>
        </Row>
        {[present, ...(earlier ? [earlier] : [])].some((one) => one.reason !== 'end') && (
          <tr>
            <th scope="row">{words.endsIn}</th>
            <td>{earlier ? endOf(earlier) : ''}</td>
            <td>{endOf(present)}</td>
          </tr>
        )}
      </tbody>
    </table>
  );
}

function Row({
  before,
  now,
  unit,
  children,
}: {
  before: number | null | undefined;
  now: number | null;
  unit: string;
  children: ComponentChildren;
}) {
  const shown = (value: number | null | undefined) =>
    value === null || value === undefined ? '–' : formatShort(value, 3);
  return (
    <tr>
      <th scope="row">
        {children}
        {unit && <span class="unit">, {unit}</span>}
      </th>
      <td>{shown(before)}</td>
      <td>{shown(now)}</td>
    </tr>
  );
}
