/** How feet sway, as sliders and a footprint that the board on the stage follows; what a metre costs, and the cheapest gait. */
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { gaitScenario, plainGait, USUAL_DRAG, type Gait } from '../../core/gait/gait.ts';
import type { GaitReport } from '../../core/gait/measureGait.ts';
import { SEARCH, type SearchState } from '../../core/gait/optimiseGait.ts';
import type { SystemView } from '../../core/model/system.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { edit, useUi } from '../../ui/context.ts';
import { Check, Section } from '../../ui/kit/controls.tsx';
import { formatQuantity, formatShort } from '../../ui/kit/format.ts';
import { numberOf } from '../../ui/kit/useNumberField.ts';
import { Footprint } from './footprint.tsx';
import './gaits.css';
import { words } from './words.ts';

const DEGREE = Math.PI / 180;

type Standing = { kind: 'idle' } | { kind: 'searching'; state: SearchState } | { kind: 'failed'; message: string };

export function GaitsTool() {
  const system = useUi().system.value;
  if (!system) return null;
  if (!system.meta.gait) return <p class="hint pad">{words.noFeet(system.meta.title)}</p>;
  return <Gaits key={system.meta.id} system={system} />;
}

function Gaits({ system }: { system: SystemView }) {
  const ui = useUi();
  const gait = useSignal<Gait>(plainGait);
  const change = (next: Gait): void => {
    gait.value = next;
    edit(ui, words.label, (draft) => ridden(system, draft, next));
  };
  return (
    <div class="gaits" data-testid="gaits">
      <p class="hint pad">{words.intro}</p>
      <Section title={words.gait} open>
        <Footprint gait={gait.value} />
        <Sway gait={gait.value} onChange={change} />
        <button type="button" data-testid="gait-ride" onClick={() => change(gait.peek())}>
          {words.ride}
        </button>
      </Section>
      <Cost system={system} gait={gait.value} onUse={change} />
    </div>
  );
}

/** The draft with feet that do this; what else it says stays. */
function ridden(system: SystemView, draft: ScenarioFile, gait: Gait): ScenarioFile {
  const { hold, ...made } = gaitScenario(system.meta, gait, draft);
  return hold && hold.length > 0 ? { ...made, hold } : made;
}

function Sway({ gait, onChange }: { gait: Gait; onChange(gait: Gait): void }) {
  const row = (key: 'amplitude' | 'frequency' | 'phase' | 'bias' | 'twist', max: number, min: number, step: number) => {
    const scale = key === 'frequency' ? 1 : DEGREE;
    return (
      <Range
        label={words[key]}
        value={gait[key] / scale}
        shown={formatQuantity(gait[key], key === 'frequency' ? 'Hz' : '°')}
        {...{ min, max, step }}
        testId={`gait-${key}`}
        onInput={(value) => onChange({ ...gait, [key]: value * scale })}
      />
    );
  };
  return (
    <>
      {row('amplitude', 30, 0, 0.1)}
      {row('frequency', 4, 0.3, 0.01)}
      {row('phase', 180, -180, 1)}
      {row('bias', 15, -15, 0.1)}
      {row('twist', 15, -15, 0.1)}
    </>
  );
}

/** A number by its slider, in the unit that is shown. */
function Range({
  label,
  shown,
  testId,
  onInput,
  ...range
}: {
  label: string;
  value: number;
  shown: string;
  min: number;
  max: number;
  step: number;
  testId: string;
  onInput(value: number): void;
}) {
  return (
    <label class="gaits-row">
      <span>{label}</span>
      <output>{shown}</output>
      <input
        type="range"
        class="slider"
        {...range}
        data-testid={testId}
        aria-valuetext={shown}
        onInput={(event) => onInput(Number(event.currentTarget.value))}
      />
    </label>
  );
}

function Cost({ system, gait, onUse }: { system: SystemView; gait: Gait; onUse(gait: Gait): void }) {
  const { app } = useUi();
  const standing = useSignal<Standing>({ kind: 'idle' });
  const found = useSignal<GaitReport | null>(null);
  const speed = useSignal(1);
  const harmonics = useSignal(false);
  useEffect(() => () => app.gait.cancel(), []);
  const drag = system.meta.gait!.drag;
  const written = app.state.draft.value.parameters ?? {};
  const given = drag === undefined ? undefined : numberOf(written[drag], 0);
  const parameters = (): Record<string, number> => {
    const own = Object.fromEntries(Object.entries(written).map(([name, value]) => [name, numberOf(value, NaN)]));
    return drag !== undefined && given === 0 ? { ...own, [drag]: USUAL_DRAG } : own;
  };
  const find = async (search: boolean): Promise<void> => {
    standing.value = { kind: 'searching', state: { tried: 0, best: null } };
    const request = { system: system.meta.id, gait, speed: speed.peek(), parameters: parameters() };
    const orders = harmonics.peek() ? [2, 3] : [];
    const answer = await app.gait.find(
      search ? { ...request, search: { ...SEARCH, harmonics: orders } } : request,
      (state) => {
        standing.value = { kind: 'searching', state };
      },
    );
    if (!answer.ok) standing.value = { kind: 'failed', message: answer.message };
    else {
      standing.value = answer.value ? { kind: 'idle' } : { kind: 'failed', message: words.nothing };
      found.value = answer.value;
    }
  };
  const now = standing.value;
  const busy = now.kind === 'searching';
  return (
    <Section title={words.cost} open>
      {given === 0 && <p class="hint">{words.noDrag(words.drag(formatShort(USUAL_DRAG)))}</p>}
      <Range
        label={words.speed}
        value={speed.value}
        shown={formatQuantity(speed.value, 'm/s')}
        min={0.3}
        max={3}
        step={0.1}
        testId="gait-speed"
        onInput={(value) => {
          speed.value = value;
        }}
      />
      <Check
        label={words.harmonics}
        checked={harmonics.value}
        testId="gait-harmonics"
        onChange={(on) => {
          harmonics.value = on;
        }}
      />
      <div class="run-buttons">
        <button type="button" class="primary" data-testid="gait-search" disabled={busy} onClick={() => void find(true)}>
          {words.search}
        </button>
        <button type="button" data-testid="gait-hold" disabled={busy} onClick={() => void find(false)}>
          {words.hold}
        </button>
        {busy && (
          <button type="button" data-testid="gait-cancel" onClick={() => app.gait.cancel()}>
            {words.cancel}
          </button>
        )}
      </div>
      <p class="hint" role="status" data-testid="gait-state">
        {busy
          ? words.trying(now.state.tried, now.state.best && formatQuantity(now.state.best.cost, 'J/m'))
          : words.searchHint}
      </p>
      {now.kind === 'failed' && (
        <p class="error" role="alert">
          {now.message}
        </p>
      )}
      {found.value && <Found report={found.value} onUse={onUse} />}
    </Section>
  );
}

function Found({ report, onUse }: { report: GaitReport; onUse(gait: Gait): void }) {
  const { results } = words;
  const { gait } = report;
  const rows: readonly (readonly [string, string])[] = [
    [results.cost, formatQuantity(report.cost, 'J/m')],
    [results.gross, formatQuantity(report.grossCost, 'J/m')],
    [results.transport, formatShort(report.transport)],
    [results.torque, formatQuantity(report.torque, 'N·m')],
    [results.amplitude, formatQuantity(gait.amplitude, '°')],
    [results.frequency, formatQuantity(gait.frequency, 'Hz')],
    [results.phase, formatQuantity(gait.phase, '°')],
    [results.speed, formatQuantity(report.speed, 'm/s')],
  ];
  return (
    <>
      <table data-testid="gait-found">
        <caption>{words.table}</caption>
        <tbody>
          {rows.map(([label, value]) => (
            <tr key={label}>
              <th scope="row">{label}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <button type="button" data-testid="gait-use" onClick={() => onUse(gait)}>
        {words.use}
      </button>
    </>
  );
}
