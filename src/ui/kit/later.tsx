import type { ComponentType } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { LoadingPart } from './loadingPart.tsx';

/** A component whose code is loaded when it is first shown, so that the first view need not wait for it. */
export function later<Props extends object>(load: () => Promise<ComponentType<Props>>): ComponentType<Props> {
  let loaded: ComponentType<Props> | null = null;
  return function Later(props: Props) {
    const [View, setView] = useState<ComponentType<Props> | null>(() => loaded);
    const [failed, setFailed] = useState(false);
    useEffect(() => {
      if (loaded) return;
      load().then(
        (view) => {
          loaded = view;
          setView(() => view);
        },
        () => setFailed(true),
      );
    }, []);
    return View ? <View {...props} /> : <LoadingPart failed={failed} />;
  };
}
