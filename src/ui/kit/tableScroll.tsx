import type { ComponentChildren } from 'preact';

/** A table in a box that scrolls sideways where it must, shows that it does, and is reached by keys. */
export function TableScroll({
  label,
  class: name = '',
  children,
}: {
  /** What the table is about. */
  label: string;
  class?: string;
  children: ComponentChildren;
}) {
  return (
    <div class={`table-scroll ${name}`} tabIndex={0} role="region" aria-label={label}>
      {children}
    </div>
  );
}
