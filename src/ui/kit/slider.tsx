/** A slider about a number's value, shown where it is asked for. */
import { useState } from 'preact/hooks';
import { formatQuantity, formatShort, toShown } from './format.ts';
import type { NumberFieldState, NumberSpec } from './useNumberField.ts';
import { words } from './words.ts';

/** Places of a slider; each is a round number. */
const PLACES = 200;
/** Steps of the field to each side of a value that says nothing of its own size. */
const REACH = 45;

export interface SliderRange {
  min: number;
  max: number;
  step: number;
}

/** From nothing to twice the value, or to as far on both sides; within the field's own bounds. In the unit shown. */
export function sliderRange(
  spec: Pick<NumberSpec, 'min' | 'max' | 'positive' | 'angle'>,
  now: number,
  step: number,
): SliderRange {
  const bound = (si: number | undefined): number | undefined =>
    si === undefined ? undefined : toShown(si, spec.angle);
  const [lower, upper] = [bound(spec.min), bound(spec.max)];
  const reach = Math.max(Math.abs(now), REACH * step);
  const oneSided = spec.positive === true || (lower !== undefined && lower >= 0);
  const [from, to] = oneSided ? [0, 2 * (spec.positive ? now : reach) || reach] : [now - reach, now + reach];
  const [min, max] = [Math.max(from, lower ?? -Infinity), Math.min(to, upper ?? Infinity)];
  const place = 10 ** Math.floor(Math.log10((max - min) / PLACES));
  const rounded = [1, 2, 5, 10].map((m) => m * place).find((one) => (max - min) / one <= PLACES)!;
  return { min: Math.floor(min / rounded) * rounded, max: Math.ceil(max / rounded) * rounded, step: rounded };
}

export function Slider({ spec, field, rate = false }: { spec: NumberSpec; field: NumberFieldState; rate?: boolean }) {
  const { shownNow, set, step } = field.slider;
  const now = shownNow();
  const [range, setRange] = useState(() => sliderRange(spec, now, step));
  const outside = now < range.min || now > range.max;
  if (outside) setRange(sliderRange(spec, now, step));
  return (
    <input
      type="range"
      class={`slider${rate ? ' rate' : ''}`}
      {...range}
      value={now}
      aria-label={words.sliderOf(spec.label)}
      aria-valuetext={
        spec.unit ? formatQuantity(spec.angle ? (now * Math.PI) / 180 : now, spec.unit) : formatShort(now)
      }
      data-testid={`slide-${spec.path}`}
      onInput={(event) => set(Number(Number(event.currentTarget.value).toPrecision(12)))}
      // At an end it goes on from there.
      onChange={(event) => {
        const at = Number(event.currentTarget.value);
        if (at <= range.min || at >= range.max) setRange(sliderRange(spec, at, step));
      }}
    />
  );
}
