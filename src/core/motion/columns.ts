import { inputsOf } from '../model/inputs.ts';
import type { SystemMeta } from '../model/system.ts';

/** What a recorded column is called and measured in. */
export interface ColumnInfo {
  name: string;
  label: string;
  /** As shown; angles in degrees. */
  unit: string;
  /** From the recorded unit to the one shown. */
  factor: number;
  /** A position angle: values that differ by 2 pi mean the same. */
  angle: boolean;
}

const DEGREES = 180 / Math.PI;

/** A column as a page shows it; one that the system does not know is shown as it is recorded. */
export function columnInfo(meta: SystemMeta, name: string): ColumnInfo {
  const plain = { name, label: '', unit: '', factor: 1, angle: false };
  const base = name.replace(/_dot$/, '');
  const coordinate = meta.coordinates.find((c) => c.name === base);
  if (coordinate) {
    const rate = base !== name;
    const angle = coordinate.kind === 'angle';
    return {
      name,
      label: rate ? `rate of ${coordinate.label}` : coordinate.label,
      unit: (angle ? '°' : 'm') + (rate ? '/s' : ''),
      factor: angle ? DEGREES : 1,
      angle: angle && !rate,
    };
  }
  const input = inputsOf(meta).find((i) => i.name === name);
  if (input) return { ...plain, label: input.label, unit: input.unit };
  if (name === 't') return { ...plain, label: 'time', unit: 's' };
  if (name === 'energy') return { ...plain, label: 'energy', unit: 'J' };
  if (name === 'residual') return { ...plain, label: 'constraint residual' };
  if (/^lambda_\d+$/.test(name)) return { ...plain, label: `multiplier ${name.slice(7)}`, unit: 'N' };
  return plain;
}

/** `alpha [°]`, as an axis is labelled. */
export const axisLabel = ({ name, unit }: ColumnInfo): string => (unit ? `${name} [${unit}]` : name);
