/**
 * What a keyboard on a phone's screen leaves of the page. Some browsers make the page lower for it, others (iOS) lay it
 * over the page, which no media query sees: so what is seen is asked of the visual viewport, for phone.css.
 */
import { useEffect } from 'preact/hooks';

/** Heights (CSS px) of a phone held upright with its keyboard up. */
const [LOWEST, HIGHEST] = [340, 560];

export function useOnScreenKeyboard(): void {
  useEffect(() => {
    const seen = window.visualViewport;
    if (!seen) return;
    const root = document.documentElement;
    const follow = (): void => {
      // Enlarged by two fingers, less is seen without any keyboard.
      const up = seen.width <= 760 && seen.scale < 1.05 && seen.height >= LOWEST && seen.height <= HIGHEST;
      const comes = up && !root.hasAttribute('data-keyboard');
      root.toggleAttribute('data-keyboard', up);
      if (!up) return;
      root.style.setProperty('--seen-top', `${seen.offsetTop}px`);
      root.style.setProperty('--seen-height', `${seen.height}px`);
      // The sheet has another height now: the field that was touched is brought back into it.
      if (comes) requestAnimationFrame(() => document.activeElement?.scrollIntoView({ block: 'center' }));
    };
    follow();
    for (const change of ['resize', 'scroll'] as const) seen.addEventListener(change, follow);
    return () => {
      for (const change of ['resize', 'scroll'] as const) seen.removeEventListener(change, follow);
    };
  }, []);
}
