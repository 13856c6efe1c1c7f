/** Small controls that every panel uses. */
import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';

export function Section({
  title,
  open = false,
  children,
}: {
  title: string;
  open?: boolean;
  children: ComponentChildren;
}) {
  return (
    <details class="section" open={open}>
      <summary>
        <h3>{title}</h3>
      </summary>
      <div class="section-body">{children}</div>
    </details>
  );
}

export function Choice({
  label,
  value,
  options,
  disabled,
  error,
  testId,
  onChange,
}: {
  label: string;
  value: string;
  options: readonly { id: string; label: string }[];
  disabled?: boolean;
  error?: string | null | undefined;
  testId?: string;
  onChange(id: string): void;
}) {
  const id = useId();
  // a scenario may name what this page does not offer: it is shown, and its error says so
  const all = options.some((option) => option.id === value) ? options : [...options, { id: value, label: value }];
  return (
    <div class="choice">
      <label for={id}>{label}</label>
      <select
        id={id}
        value={value}
        disabled={disabled}
        aria-invalid={error ? 'true' : undefined}
        data-testid={testId}
        onChange={(event) => onChange(event.currentTarget.value)}
      >
        {all.map((option) => (
          <option key={option.id} value={option.id}>
            {option.label}
          </option>
        ))}
      </select>
      {error && <span class="error">{error}</span>}
    </div>
  );
}

export function Check({
  label,
  checked,
  onChange,
  testId,
}: {
  label: string;
  checked: boolean;
  testId?: string;
  onChange(on: boolean): void;
}) {
  return (
    <label class="check">
      <input
        type="checkbox"
        checked={checked}
        data-testid={testId}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
      <span>{label}</span>
    </label>
  );
}

/** A button that stays pressed. */
export function Toggle({
  pressed,
  label,
  title,
  testId,
  onClick,
  children,
}: {
  pressed: boolean;
  label?: string;
  title?: string;
  testId?: string;
  onClick(): void;
  children: ComponentChildren;
}) {
  return (
    <button
      type="button"
      class="toggle"
      aria-pressed={pressed}
      aria-label={label}
      title={title}
      data-testid={testId}
      onClick={onClick}
    >
      {children}
    </button>
  );
}

const PATHS = {
  play: 'M4 2.5v11l9-5.5z',
  pause: 'M4 2.5h3v11H4zM9 2.5h3v11H9z',
  back: 'M12 3v10L5 8zM3.5 3h1.5v10H3.5z',
  forward: 'M4 3v10l7-5zM11 3h1.5v10H11z',
} as const;
const LINES = {
  share: 'M6 9.5l4-4M7 4.5l1.5-1.5a3 3 0 0 1 4.3 4.3L11.3 8.8M9 11.5L7.5 13a3 3 0 0 1-4.3-4.3L4.7 7.2',
  plots: 'M2 2v12h12M4 11c2-7 3-7 4.5-3s2.5 3 5-4',
  now: 'M2.5 12a6.2 6.2 0 1 1 11 0M8 9.5l2.5-3.5',
  analysis: 'M2 8h12M9 2v12M4.5 4.5l2 2m0-2l-2 2M4.5 9.5l2 2m0-2l-2 2',
  own: 'M5 3L1.5 8 5 13M11 3l3.5 5L11 13M9.5 2l-3 12',
  gaits: 'M2 8c0-7 12-7 12 0s-12 7-12 0zM2 8h12M8 2.5v11',
  methods: 'M2 13c4 0 4-9 12-9M2 13c6 0 8-3 12-3M2 2v12h12',
  equations: 'M12.5 4.5v-2h-9l5 5.5-5 5.5h9v-2',
  compare: 'M2 12c3 0 4-8 7-8 2 0 3 2 5 2M2 9c3 0 4 3 7 3 2 0 3-1 5-1',
  study: 'M2 2h12v12H2zM2 6h12M2 10h12M6 2v12M10 2v12',
  lessons: 'M8 4c-1.5-1.2-3.5-1.5-6-1.5v10c2.5 0 4.5.3 6 1.5M8 4c1.5-1.2 3.5-1.5 6-1.5v10c-2.5 0-4.5.3-6 1.5M8 4v10',
  loop: 'M3 7.5V6.5a2 2 0 0 1 2-2h8M11 2.5l2 2-2 2M13 8.5v1a2 2 0 0 1-2 2H3M5 13.5l-2-2 2-2',
  open: 'M2 12.5v-9h4l1.5 2H14v7zM2 7.5h12',
  sample: 'M2 11c2 0 2-6 4-6s2 6 4 6 2-6 4-6',
  export: 'M8 2v8M5 7l3 3 3-3M3 13h10',
  light: 'M8 5a3 3 0 1 1 0 6 3 3 0 0 1 0-6M8 1v1.5M8 13.5V15M1 8h1.5M13.5 8H15M3 3l1 1M12 12l1 1M3 13l1-1M12 4l1-1',
  dark: 'M13 9.5A5.5 5.5 0 1 1 6.5 3 4.5 4.5 0 0 0 13 9.5z',
  down: 'M4 6l4 4 4-4',
  up: 'M8 13V3M4 7l4-4 4 4',
  below: 'M8 3v10M4 9l4 4 4-4',
  before: 'M13 8H3M7 4L3 8l4 4',
  after: 'M3 8h10M9 4l4 4-4 4',
  raise: 'M3 2.5h10M8 13.5V6M4.5 9.5L8 6l3.5 3.5',
  lower: 'M3 13.5h10M8 2.5V10M4.5 6.5L8 10l3.5-3.5',
  table: 'M2 3h12v10H2zM2 6.5h12M2 10h12M6 3v10',
  undo: 'M3 6.5h7a3.5 3.5 0 0 1 0 7H6M6 3L2.5 6.5 6 10',
  redo: 'M13 6.5H6a3.5 3.5 0 0 0 0 7h4M10 3l3.5 3.5L10 10',
  close: 'M4 4l8 8M12 4l-8 8',
  check: 'M3 8.5l3.5 3.5L13 4.5',
  left: 'M10 3L5 8l5 5',
  right: 'M6 3l5 5-5 5',
} as const;

export type IconName = keyof typeof PATHS | keyof typeof LINES;

export function Icon({ name }: { name: IconName }) {
  const solid = name in PATHS;
  return (
    <svg class="icon" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
      <path
        d={solid ? PATHS[name as keyof typeof PATHS] : LINES[name as keyof typeof LINES]}
        fill={solid ? 'currentColor' : 'none'}
        stroke={solid ? 'none' : 'currentColor'}
        stroke-width="1.4"
        stroke-linecap="round"
        stroke-linejoin="round"
      />
    </svg>
  );
}
