/** Fields that the pages of the export dialog share. */
import { useId, useState } from 'preact/hooks';
import { LARGEST, sideOf, SMALLEST } from '../../app/files/exportPlan.ts';
import type { ShotPlan } from '../../app/files/exportRenderer.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { words as text } from './words.ts';
import { Choice } from '../../ui/kit/controls.tsx';
import { choices, rangeOf } from './jobs.ts';

/** What is typed stays as it is until the field is left, whatever is drawn meanwhile. */
export function Amount({
  label,
  value,
  min,
  max,
  step,
  testId,
  onChange,
}: {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number | 'any';
  testId: string;
  onChange(value: number): void;
}) {
  const id = useId();
  const [typed, setTyped] = useState<string | null>(null);
  return (
    <div class="choice">
      <label for={id}>{label}</label>
      <input
        id={id}
        class="amount"
        type="number"
        value={typed ?? value}
        min={min}
        max={max}
        step={step}
        data-testid={testId}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onChange={(event) => {
          const read = event.currentTarget.valueAsNumber;
          if (Number.isFinite(read)) onChange(Math.min(max, Math.max(min, read)));
          setTyped(null);
        }}
      />
    </div>
  );
}

const PRESETS: readonly (readonly [number, number])[] = [
  [1280, 720],
  [1920, 1080],
  [3840, 2160],
  [1080, 1080],
];
const nameOf = (width: number, height: number): string =>
  `${width} × ${height}${width === height ? `, ${text.square}` : ''}`;

export function SizeFields({
  width,
  height,
  even = false,
  prefix,
  onChange,
}: {
  width: number;
  height: number;
  even?: boolean;
  prefix: string;
  onChange(size: { width?: number; height?: number }): void;
}) {
  const preset = PRESETS.findIndex(([w, h]) => w === width && h === height);
  return (
    <>
      <Choice
        label={text.size}
        value={String(preset)}
        testId={`${prefix}-size`}
        options={[
          ...PRESETS.map(([w, h], i) => ({ id: String(i), label: nameOf(w, h) })),
          { id: '-1', label: text.own },
        ]}
        onChange={(id) => {
          const chosen = PRESETS[Number(id)];
          onChange(chosen ? { width: chosen[0], height: chosen[1] } : { width: width + (preset >= 0 ? 2 : 0) });
        }}
      />
      {preset < 0 && (
        <div class="pair">
          <Amount
            label={text.width}
            value={width}
            min={SMALLEST}
            max={LARGEST}
            step={even ? 2 : 1}
            testId={`${prefix}-width`}
            onChange={(w) => onChange({ width: sideOf(w, even) })}
          />
          <Amount
            label={text.height}
            value={height}
            min={SMALLEST}
            max={LARGEST}
            step={even ? 2 : 1}
            testId={`${prefix}-height`}
            onChange={(h) => onChange({ height: sideOf(h, even) })}
          />
        </div>
      )}
    </>
  );
}

export function ViewField({
  view,
  motion,
  testId,
  onChange,
}: {
  view: ShotPlan['view'];
  motion: Motion;
  testId: string;
  onChange(view: ShotPlan['view']): void;
}) {
  const names = Object.keys(text.views) as (keyof typeof text.views)[];
  const offers = motion.system.meta.views;
  const offered = names.filter(
    (name) => (name !== 'caster' || offers?.closeUp) && (name !== 'rider' || offers?.ridden),
  );
  return (
    <Choice
      label={text.view}
      value={view}
      testId={testId}
      options={offered.map((name) => ({ id: name, label: text.views[name] }))}
      onChange={(name) => onChange(name as ShotPlan['view'])}
    />
  );
}

export function RangeFields({ motion }: { motion: Motion }) {
  const { from, to } = rangeOf(motion);
  const { start, end } = motion.trajectory;
  const set = (change: { from?: number; to?: number }): void =>
    void (choices.range.value = { motion: motion.id, ...rangeOf(motion), ...change });
  return (
    <div class="pair" role="group" aria-label={text.range}>
      <Amount
        label={text.from}
        value={from}
        min={start}
        max={end}
        step="any"
        testId="export-from"
        onChange={(value) => set({ from: value })}
      />
      <Amount
        label={text.to}
        value={to}
        min={start}
        max={end}
        step="any"
        testId="export-to"
        onChange={(value) => set({ to: value })}
      />
    </div>
  );
}
