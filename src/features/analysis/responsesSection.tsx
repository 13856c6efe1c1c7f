/** The loop at one input, as Bode and Nyquist draw it, and a step of its disturbance answered by one state. */
import { useSignal, useSignalEffect } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { CURVES } from '../../app/runs/curveStyles.ts';
import { ChartView } from '../../charts/chartView.tsx';
import { curveMark } from '../../charts/curves.ts';
import type { Picture } from '../../charts/frame.ts';
import { lineAcross } from '../../charts/marks.ts';
import { bodeOf, type Responses } from '../../core/control/responses.ts';
import type { Column } from '../../core/motion/columns.ts';
import { words as plain } from '../../core/motion/symbols.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

const ASKER = 'responses';
const DEGREE = Math.PI / 180;
/** Beyond these the loop gain at low frequencies would hide the point -1. */
const NYQUIST = 4;

export function ResponsesBody({ names }: { names: ReadonlyMap<string, Column> }) {
  const { app, system } = useUi();
  const input = useSignal('');
  const state = useSignal('');
  const answer = useSignal<Responses | null>(null);
  const problem = useSignal('');
  useSignalEffect(() => {
    const draft = app.state.draft.value;
    if (draft.control?.type !== 'lqr') return void (answer.value = null);
    void app.control.responses(draft, input.value, state.value, ASKER).then((found) => {
      if (!found) return;
      problem.value = found.ok ? '' : found.message;
      if (found.ok) answer.value = found.value;
    });
  });
  useEffect(() => () => app.control.forget(ASKER), []);
  const shown = answer.value;
  if (app.state.draft.value.control?.type !== 'lqr') return <p class="hint">{words.noGain}</p>;
  if (!shown) return <p class={problem.value ? 'error' : 'hint'}>{problem.value || words.noLoop}</p>;
  const { inputs, states, loop, step } = shown;
  const { magnitude, phase } = bodeOf(loop);
  const stateName = shown.state;
  const label = names.get(stateName)?.label ?? stateName;
  const angle = names.get(stateName)?.degrees === true;
  const labelOf = (name: string): string =>
    names.get(name)?.label ?? system.value?.meta.inputs.find((i) => i.name === name)?.label ?? name;
  const choice = (of: typeof input, now: string, options: readonly string[], name: string, testId: string) => (
    <label>
      {name}{' '}
      <select data-testid={testId} value={now} onChange={(event) => (of.value = event.currentTarget.value)}>
        {options.map((option) => (
          <option key={option} value={option}>
            {labelOf(option)}
          </option>
        ))}
      </select>
    </label>
  );
  const over = { title: plain(words.frequency), kind: 'logarithmic' as const, air: 0 };
  return (
    <div data-testid="responses">
      {choice(input, shown.input, inputs, words.loopInput, 'responses-input')}
      <Curve
        label={words.magnitude}
        picture={{
          x: over,
          y: { title: plain(words.gainAxis), kind: 'logarithmic' },
          marks: [lineAcross('y', 1), curveOf(words.magnitude, loop.frequency, magnitude)],
        }}
      />
      <Curve
        label={words.phase}
        picture={{
          x: over,
          y: { title: plain(words.phaseAxis) },
          marks: [
            lineAcross('y', -180),
            lineAcross('y', 180),
            curveOf(
              words.phase,
              loop.frequency,
              phase.map((p) => p / DEGREE),
            ),
          ],
        }}
      />
      <Curve
        label={words.nyquist}
        tall
        picture={{
          x: { title: plain(words.nyquistReal), range: [-NYQUIST, NYQUIST] },
          y: { title: plain(words.nyquistImaginary), range: [-NYQUIST, NYQUIST] },
          equal: true,
          marks: [
            lineAcross('x', 0),
            lineAcross('y', 0),
            curveOf(words.nyquist, loop.real, loop.imaginary),
            curveMark({ color: '#d55e00', label: plain('−1'), x: [-1], y: [0], points: true }),
          ],
        }}
      />
      <p class="hint">{words.stepNote}</p>
      {choice(state, stateName, states, words.stepState, 'responses-state')}
      <Curve
        label={words.stepOf(label)}
        picture={{
          x: { title: plain(words.stepTime), air: 0 },
          y: { title: plain(angle ? `${label}, °` : label), zero: true },
          marks: [
            lineAcross('y', 0),
            curveOf(
              label,
              step.t,
              step.state.map((x) => (angle ? x / DEGREE : x)),
            ),
          ],
        }}
      />
      <Curve
        label={words.stepInput}
        picture={{
          x: { title: plain(words.stepTime), air: 0 },
          y: { title: plain(words.stepAxis), zero: true },
          marks: [lineAcross('y', 0), curveOf(words.stepInput, step.t, step.input)],
        }}
      />
    </div>
  );
}

const curveOf = (label: string, x: number[], y: number[]) => curveMark({ ...CURVES[0]!, label: plain(label), x, y });

function Curve({ label, picture, tall = false }: { label: string; picture: Picture; tall?: boolean }) {
  const { app } = useUi();
  return (
    <ChartView
      class={tall ? 'response tall' : 'response'}
      label={label}
      options={{}}
      // The theme's colours are in force after the page's own effect: draw in the next frame.
      attach={(chart) => app.state.theme.subscribe(() => void requestAnimationFrame(() => chart.redraw()))}
      update={(chart) => chart.setPicture(picture)}
    />
  );
}
