/** A button that opens a list of actions. Arrow keys move, Escape closes, focus returns to the button. */
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import { Icon } from './controls.tsx';

export interface MenuItem {
  id: string;
  title: string;
  summary?: string;
  /** Items of one group stand together under its name. */
  group?: string;
  current?: boolean;
  disabled?: boolean;
  testId?: string;
  choose(): void;
}

export function Menu({
  label,
  title,
  items,
  testId,
  wide,
  above,
  align = 'left',
  children,
}: {
  /** Name for assistive technology when the content alone does not say it. */
  label: string;
  title?: string;
  items: readonly MenuItem[];
  testId: string;
  wide?: boolean;
  /** Opens upward. */
  above?: boolean;
  align?: 'left' | 'right';
  children: ComponentChildren;
}) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const id = useId();
  const entries = () => [
    ...(root.current?.querySelectorAll<HTMLButtonElement>('[role=menuitem]:not(:disabled)') ?? []),
  ];
  const close = () => {
    setOpen(false);
    root.current?.querySelector<HTMLButtonElement>('.menu-button')?.focus();
  };

  useEffect(() => {
    if (!open) return;
    const list = entries();
    (list.find((entry) => entry.getAttribute('aria-current') === 'true') ?? list[0])?.focus();
    const outside = (event: Event) => {
      if (!root.current?.contains(event.target as Node)) setOpen(false);
    };
    document.addEventListener('pointerdown', outside);
    return () => document.removeEventListener('pointerdown', outside);
  }, [open]);

  const onKeyDown = (event: KeyboardEvent) => {
    if (!open) {
      if (event.key === 'ArrowDown') {
        event.preventDefault();
        event.stopPropagation();
        setOpen(true);
      }
      return;
    }
    event.stopPropagation();
    const list = entries();
    const at = list.indexOf(document.activeElement as HTMLButtonElement);
    const target = { ArrowDown: at + 1, ArrowUp: at - 1 + list.length, Home: 0, End: list.length - 1 }[event.key];
    if (target !== undefined) {
      event.preventDefault();
      list[target % list.length]?.focus();
    } else if (event.key === 'Escape') {
      close();
    } else if (event.key === 'Tab') {
      setOpen(false);
    }
  };

  return (
    <div class="menu" ref={root} onKeyDown={onKeyDown}>
      <button
        type="button"
        class="menu-button"
        aria-haspopup="menu"
        aria-expanded={open}
        aria-controls={id}
        aria-label={label}
        title={title}
        data-testid={testId}
        onClick={() => setOpen(!open)}
      >
        {children}
        <Icon name="down" />
      </button>
      <div
        id={id}
        role="menu"
        aria-label={label}
        class={`menu-list ${align}${wide ? ' wide' : ''}${above ? ' above' : ''}`}
        hidden={!open}
      >
        {open &&
          groupsOf(items).map(([group, members]) => (
            <div key={group} role={group ? 'group' : 'none'} aria-label={group || undefined} class="menu-group">
              {group && (
                <span class="menu-heading" aria-hidden="true">
                  {group}
                </span>
              )}
              {members.map((item) => (
                <button
                  key={item.id}
                  type="button"
                  role="menuitem"
                  tabIndex={-1}
                  aria-current={item.current ? 'true' : undefined}
                  disabled={item.disabled}
                  data-testid={item.testId}
                  onClick={() => {
                    close();
                    item.choose();
                  }}
                >
                  <span class="menu-title">{item.title}</span>
                  {item.summary && <span class="menu-summary">{item.summary}</span>}
                </button>
              ))}
            </div>
          ))}
      </div>
    </div>
  );
}

/** In the order in which groups first come. */
function groupsOf(items: readonly MenuItem[]): (readonly [string, readonly MenuItem[]])[] {
  const names = [...new Set(items.map((item) => item.group ?? ''))];
  return names.map((name) => [name, items.filter((item) => (item.group ?? '') === name)]);
}
