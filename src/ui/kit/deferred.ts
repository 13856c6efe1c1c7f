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

/** The value of the render before, then in a task of its own the present one. It must be the same object while nothing changed. */
export function useLagging<T>(value: T): T {
  const [shown, setShown] = useState(() => value);
  useEffect(() => {
    const timer = setTimeout(() => setShown(() => value));
    return () => clearTimeout(timer);
  }, [value]);
  return shown;
}
