import type { ReadonlySignal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';

/** A signal's value, in a task of its own: for what is heavy to build, so that what changed it is not held up. */
export function useDeferred<T>(source: ReadonlySignal<T>): T {
  const [value, setValue] = useState(() => source.peek());
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const end = source.subscribe(() => {
      clearTimeout(timer);
      timer = setTimeout(() => setValue(() => source.peek()));
    });
    return () => {
      clearTimeout(timer);
      end();
    };
  }, [source]);
  return value;
}
