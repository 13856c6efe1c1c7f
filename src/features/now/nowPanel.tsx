/** The state at the playback time, in numbers. Follows at most 15 times a second. */
import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import type { Motion } from '../../app/types.ts';
import type { CoordinateMeta } from '../../core/model/system.ts';
import type { Trajectory } from '../../core/motion/trajectory.ts';
import { useUi } from '../../ui/context.ts';
import { FilePanel } from '../../ui/shell/filePanel.tsx';
import { formatFixed, formatTime, formatValue, THIN } from '../../ui/kit/format.ts';
import { Chip, MathSymbol } from '../../ui/kit/symbol.tsx';
import { text } from '../../ui/words.ts';

const INTERVAL = 1000 / 15;

/** With what is to be said about a file, where the motion is one. */
export function NowTool() {
  const isFile = useUi().app.state.motion.value?.source === 'file';
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={text.panel.now}>
      <NowPanel />
      {isFile && (
        <section class="file-section" aria-label={text.panel.file}>
          <h3>{text.panel.file}</h3>
          <FilePanel />
        </section>
      )}
    </div>
  );
}

export function NowPanel() {
  const { state } = useUi().app;
  const time = useSlowTime();
  const motion = state.motion.value;
  if (!motion || motion.trajectory.length === 0) return <p class="hint pad">{text.now.empty}</p>;
  const multipliers = motion.trajectory.columns.filter((name) => name.startsWith('lambda_'));
  return (
    <div class="now">
      <table data-testid="now">
        <caption>
          t = {formatTime(time)}
          {THIN}s
        </caption>
        <thead>
          <tr>
            <th scope="col">
              <span class="hidden">{text.panel.now}</span>
            </th>
            <th scope="col" colSpan={2}>
              {text.now.value}
            </th>
            <th scope="col" colSpan={2}>
              {text.now.rate}
            </th>
          </tr>
        </thead>
        <tbody>
          {motion.system.meta.coordinates.map((c) => (
            <Row key={c.name} coordinate={c} trajectory={motion.trajectory} time={time} />
          ))}
        </tbody>
      </table>
      {multipliers.length > 0 && <Multipliers motion={motion} names={multipliers} time={time} />}
    </div>
  );
}

function Row({
  coordinate: c,
  trajectory,
  time,
}: {
  coordinate: CoordinateMeta;
  trajectory: Trajectory;
  time: number;
}) {
  const [value, rate] = [sample(trajectory, c.name, time), sample(trajectory, `${c.name}_dot`, time)];
  const angle = c.kind === 'angle';
  return (
    <tr>
      <th scope="row" title={c.label}>
        <Chip part={c.part} />
        <MathSymbol of={c.symbol} />
        <span class="hidden">{c.label}</span>
      </th>
      <td class="number" data-testid={`now-${c.name}`}>
        {value === null ? '–' : formatValue(value, c.kind)}
      </td>
      <td class="unit">{angle ? '°' : 'm'}</td>
      <td class="number">{rate === null ? '–' : formatValue(rate, c.kind)}</td>
      <td class="unit">{rate === null ? '' : angle ? '°/s' : 'm/s'}</td>
    </tr>
  );
}

function Multipliers({ motion, names, time }: { motion: Motion; names: readonly string[]; time: number }) {
  const roles = new Map<number, { part: 'front' | 'back'; label: string }>();
  for (const { part, lateral, vertical } of motion.system.contacts) {
    roles.set(lateral, { part, label: `${text.now.part[part]} ${text.now.lateral}` });
    roles.set(vertical, { part, label: `${text.now.part[part]} ${text.now.vertical}` });
  }
  return (
    <table data-testid="now-multipliers">
      <caption>{text.now.multipliers}</caption>
      <tbody>
        {names.map((name, i) => {
          const role = roles.get(i);
          const value = sample(motion.trajectory, name, time);
          return (
            <tr key={name}>
              <th scope="row">
                <Chip part={role?.part ?? 'board'} />
                <MathSymbol of={name.replace('lambda', 'λ')} /> <span class="name">{role?.label ?? ''}</span>
              </th>
              <td class="number" data-testid={`now-${name}`}>
                {value === null ? '–' : formatFixed(value, 3)}
              </td>
              <td class="unit">{role ? 'N' : ''}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

/** Linear between rows: enough for a read-out. */
export function sample(trajectory: Trajectory, name: string, time: number): number | null {
  const values = trajectory.column(name);
  const t = trajectory.column('t');
  if (!values || !t || values.length === 0) return null;
  const i = trajectory.locate(time);
  const next = Math.min(i + 1, values.length - 1);
  const span = t[next]! - t[i]!;
  const part = span > 0 ? Math.min(1, Math.max(0, (time - t[i]!) / span)) : 0;
  return values[i]! + part * (values[next]! - values[i]!);
}

/** The playback time, but not on every frame; the last change always arrives. */
export function useSlowTime(interval = INTERVAL): number {
  const { state } = useUi().app;
  const [slow] = useState(() => signal(state.time.peek()));
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    let last = 0;
    const show = () => {
      timer = undefined;
      last = performance.now();
      slow.value = state.time.peek();
    };
    const stop = state.time.subscribe(() => {
      timer ??= setTimeout(show, Math.max(0, interval - (performance.now() - last)));
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, []);
  return slow.value;
}
