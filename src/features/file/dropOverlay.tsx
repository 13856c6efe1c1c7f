import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

/** Files may be dropped anywhere on the page. */
export function DropOverlay() {
  const ui = useUi();
  const over = useSignal(false);
  useEffect(() => {
    // enter and leave come once for every element that is crossed
    let depth = 0;
    const carries = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
    const listeners: Record<string, (event: DragEvent) => void> = {
      dragenter: () => {
        depth++;
        over.value = true;
      },
      dragover: () => {},
      dragleave: () => {
        depth = Math.max(0, depth - 1);
        if (depth === 0) over.value = false;
      },
      drop: (event) => {
        depth = 0;
        over.value = false;
        const files = [...(event.dataTransfer?.files ?? [])];
        if (files.length > 0) ui.app.actions.openFiles(files);
      },
    };
    const entries = Object.entries(listeners).map(
      ([name, listen]) =>
        [
          name,
          (event: Event) => {
            if (!carries(event as DragEvent)) return;
            event.preventDefault();
            listen(event as DragEvent);
          },
        ] as const,
    );
    for (const [name, listen] of entries) window.addEventListener(name, listen);
    return () => {
      for (const [name, listen] of entries) window.removeEventListener(name, listen);
    };
  }, []);
  return over.value ? (
    <div class="drop" data-testid="drop">
      <p>{words.drop}</p>
    </div>
  ) : null;
}
