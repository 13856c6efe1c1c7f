import type { Signal } from '@preact/signals';
import type { SweepPath } from '../../core/scenario/sweepPaths.ts';
import { words } from './words.ts';
import { Check } from '../../ui/kit/controls.tsx';
import { allMethods, offeredAxis, type AxisForm } from './sweepChoices.ts';

const own = words.sweep;

/** What is varied, from where to where. */
export function AxisFields({
  index,
  form,
  paths,
}: {
  index: number;
  form: Signal<AxisForm>;
  paths: readonly SweepPath[];
}) {
  const { path, scale, methods } = form.value;
  const subject = paths.find((p) => p.path === path);
  const change = (part: Partial<AxisForm>) => {
    form.value = { ...form.value, ...part };
  };
  const field = (key: 'from' | 'to' | 'count', unit = '') => (
    <label>
      {own[key]}{' '}
      <span class="with-unit">
        <input
          type="text"
          inputMode="decimal"
          size={key === 'count' ? 5 : 9}
          value={form.value[key]}
          data-testid={`sweep-${key}-${index}`}
          onInput={(e) => change({ [key]: e.currentTarget.value })}
        />
        {unit && <span class="unit">{unit}</span>}
      </span>
    </label>
  );
  const groups = Object.keys(own.groups) as SweepPath['group'][];
  return (
    <fieldset class="sweep-axis">
      <label class="grow">
        {own.axis[index]}{' '}
        <select
          value={subject || path === 'method' ? path : ''}
          data-testid={`sweep-axis-${index}`}
          onChange={(e) => {
            form.value = offeredAxis(
              paths.find((p) => p.path === e.currentTarget.value),
              e.currentTarget.value,
              index === 0 ? 11 : 9,
            );
          }}
        >
          {index > 0 && <option value="">{own.none}</option>}
          {groups.map((group) => {
            const members = paths.filter((p) => p.group === group);
            return (
              members.length > 0 && (
                <optgroup key={group} label={own.groups[group]}>
                  {members.map((p) => (
                    <option key={p.path} value={p.path}>
                      {p.label}
                    </option>
                  ))}
                </optgroup>
              )
            );
          })}
          <optgroup label={own.methodGroup}>
            <option value="method">{own.method}</option>
          </optgroup>
        </select>
      </label>
      {subject && (
        <div class="sweep-range">
          {field('from', subject.unit)}
          {field('to', subject.unit)}
          {field('count')}
          <label>
            {own.scale}{' '}
            <select
              value={scale}
              data-testid={`sweep-scale-${index}`}
              onChange={(e) => change({ scale: e.currentTarget.value as AxisForm['scale'] })}
            >
              {(['linear', 'logarithmic'] as const).map((s) => (
                <option key={s} value={s}>
                  {own.scales[s]}
                </option>
              ))}
            </select>
          </label>
        </div>
      )}
      {path === 'method' && (
        <div class="sweep-methods">
          {allMethods.map((m) => (
            <Check
              key={m.id}
              label={m.label}
              checked={methods.includes(m.id)}
              testId={`sweep-method-${m.id}`}
              onChange={(on) => change({ methods: on ? [...methods, m.id] : methods.filter((id) => id !== m.id) })}
            />
          ))}
        </div>
      )}
    </fieldset>
  );
}
